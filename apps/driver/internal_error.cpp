// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/internal_error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace dgt {
namespace {

namespace fs = std::filesystem;

constexpr int kTries = 100;  // names tried

std::string quoted(const std::string& word) {
  constexpr const char* kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=./,:@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// The program has read it already; only a file can be read once more.
bool rewind_standard_input() {
  struct stat status {};
  return ::fstat(STDIN_FILENO, &status) == 0 && S_ISREG(status.st_mode) &&
         static_cast<std::uintmax_t>(status.st_size) <= kMostSavedBytes &&
         ::lseek(STDIN_FILENO, 0, SEEK_SET) == 0;
}

bool is_worth_saving(const std::string& word) {
  if (word == kStream) return rewind_standard_input();
  std::error_code ignored;
  return fs::is_regular_file(word, ignored) && fs::file_size(word, ignored) <= kMostSavedBytes;
}

std::string text_of(const FailedRun& error) {
  std::string text = "dgt " DGT_VERSION "\ninternal error: " + error.what + "\n\ndgt";
  for (const std::string& word : error.command_line) text += " " + quoted(word);
  text += '\n';
  for (const std::string& word : error.command_line) {
    if (!is_worth_saving(word)) continue;
    const auto bytes = read_file(word);
    if (!bytes) continue;
    text += "\n--- " + word + ", " + std::to_string(bytes->size()) + " bytes\n" + *bytes;
  }
  return text;
}

/// An open new file; another's, or a link that somebody has laid there, is left alone.
FileResult<int> open_new(const fs::path& folder, std::string& name) {
  const std::string stem = "dgt-internal-error-" + std::to_string(::getpid());
  int fd = -1;
  for (int i = 0; i < kTries && fd < 0; ++i) {
    name = folder / (stem + (i == 0 ? "" : "-" + std::to_string(i)) + ".txt");
    fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (fd < 0 && errno != EEXIST) break;
  }
  if (fd < 0) return tl::unexpected(FileError{name, errno});
  return fd;
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(fd, bytes.data(), bytes.size());
    if (put < 0 && errno != EINTR) return false;
    if (put > 0) bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return true;
}

}  // namespace

FileResult<std::string> save_internal_error(const FailedRun& error, const fs::path& folder) {
  std::string name;
  const auto fd = open_new(folder, name);
  if (!fd) return tl::unexpected(fd.error());
  const bool written = write_all(*fd, text_of(error));
  const int fault = errno;
  if (::close(*fd) == 0 && written) return name;
  ::unlink(name.c_str());
  return tl::unexpected(FileError{name, fault});
}

}  // namespace dgt
