// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/file_io.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

namespace dgt {
namespace {

namespace fs = std::filesystem;

constexpr int kTries = 100;  // names tried for the new file

/// An open file; closes what it still holds.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  [[nodiscard]] bool ok() const { return fd_ >= 0; }
  [[nodiscard]] int number() const { return fd_; }
  /// Reports what only closing brings to light.
  [[nodiscard]] bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

tl::unexpected<FileError> failed(const std::string& name, int error = errno) {
  return tl::unexpected(FileError{name, error});
}

FileResult<std::string> read_all(int fd, const std::string& name) {
  std::string bytes;
  std::array<char, 1 << 16> buffer{};
  for (;;) {
    const ssize_t got = ::read(fd, buffer.data(), buffer.size());
    if (got == 0) return bytes;
    if (got > 0) {
      bytes.append(buffer.data(), static_cast<std::size_t>(got));
    } else if (errno != EINTR) {
      return failed(name);
    }
  }
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(fd, bytes.data(), bytes.size());
    if (put >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(put));
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

FileResult<void> write_through(const std::string& name, std::string_view bytes) {
  Descriptor file(::open(name.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
  if (!file.ok() || !write_all(file.number(), bytes) || !file.close()) return failed(name);
  return {};
}

/// The new file beside `target`: hidden, and gone again unless it became the target.
class NewFile {
 public:
  explicit NewFile(const fs::path& target) {
    for (int i = 0; i < kTries && fd_ < 0; ++i) {
      path_ = target.parent_path() / ("." + target.filename().string() + "." +
                                      std::to_string(::getpid()) + "." + std::to_string(i));
      fd_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (fd_ < 0 && errno != EEXIST) return;
    }
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile() {
    if (fd_ >= 0 && !renamed_) ::unlink(path_.c_str());
  }
  [[nodiscard]] int descriptor() const { return fd_; }
  [[nodiscard]] bool rename_to(const fs::path& target) {
    renamed_ = ::rename(path_.c_str(), target.c_str()) == 0;
    return renamed_;
  }

 private:
  fs::path path_;
  int fd_ = -1;
  bool renamed_ = false;
};

/// Makes the new name last through a power cut, where the file system can say so.
void sync_folder(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.ok()) ::fsync(opened.number());
}

FileResult<void> replace(const std::string& name, const fs::path& target, std::string_view bytes,
                         const struct stat* existing) {
  if (existing != nullptr && ::access(target.c_str(), W_OK) != 0) return failed(name);
  NewFile file(target);
  Descriptor open(file.descriptor());
  if (!open.ok()) return failed(name);
  if (existing != nullptr && ::fchmod(open.number(), existing->st_mode & 07777) != 0) {
    return failed(name);
  }
  if (!write_all(open.number(), bytes) || ::fsync(open.number()) != 0 || !open.close() ||
      !file.rename_to(target)) {
    return failed(name);
  }
  sync_folder(target);
  return {};
}

}  // namespace

std::string FileError::text() const { return name + ": " + std::generic_category().message(error); }

FileResult<std::string> read_file(const std::string& name) {
  if (name == kStream) return read_all(STDIN_FILENO, name);
  const Descriptor file(::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
  if (!file.ok()) return failed(name);
  return read_all(file.number(), name);
}

FileResult<void> write_file(const std::string& name, std::string_view bytes) {
  if (name == kStream) {
    if (!write_all(STDOUT_FILENO, bytes)) return failed(name);
    return {};
  }
  struct stat existing {};
  if (::stat(name.c_str(), &existing) != 0) {
    if (errno != ENOENT) return failed(name);
    return replace(name, name, bytes, nullptr);
  }
  if (S_ISDIR(existing.st_mode)) return failed(name, EISDIR);
  if (!S_ISREG(existing.st_mode)) return write_through(name, bytes);
  std::error_code error;
  const fs::path target = fs::canonical(name, error);  // a link stays a link
  if (error) return failed(name, error.value());
  return replace(name, target, bytes, &existing);
}

}  // namespace dgt
