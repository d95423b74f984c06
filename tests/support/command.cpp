// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/command.h"

#include <fcntl.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

namespace dgt::support {
namespace {

namespace fs = std::filesystem;

std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (const std::string& text : texts) all.push_back(const_cast<char*>(text.c_str()));
  all.push_back(nullptr);
  return all;
}

void redirect(const std::string& file, int flags, int as) {
  const int fd = ::open(file.c_str(), flags, 0600);
  if (fd < 0 || ::dup2(fd, as) < 0) ::_exit(127);
  ::close(fd);
}

// Files and not pipes hold the streams, so nothing can wait for the other side; what goes to a
// terminal is read while the command runs.
struct Streams {
  std::string in;
  std::string out;
  std::string err;
};

/// A terminal for another process to write on.
class Terminal {
 public:
  Terminal() {
    if (::openpty(&ours_, &theirs_, nullptr, nullptr, nullptr) != 0)
      throw std::runtime_error("openpty failed");
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal() {
    ::close(ours_);
    if (theirs_ >= 0) ::close(theirs_);
  }
  /// Of the child: where it writes.
  [[nodiscard]] int theirs() const { return theirs_; }
  /// All that is written until everybody has closed it.
  [[nodiscard]] std::string read_all() {
    ::close(std::exchange(theirs_, -1));
    std::string text;
    std::array<char, 4096> piece{};
    while (true) {
      const ssize_t got = ::read(ours_, piece.data(), piece.size());
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return text;  // EIO: closed at the other end
      text.append(piece.data(), static_cast<std::size_t>(got));
    }
  }

 private:
  int ours_ = -1;
  int theirs_ = -1;
};

[[noreturn]] void become(std::vector<char*> arguments, std::vector<char*> environment,
                         const Streams& streams, const Terminal* terminal, const fs::path& folder) {
  redirect(streams.in, O_RDONLY, STDIN_FILENO);
  redirect(streams.out, O_WRONLY | O_CREAT, STDOUT_FILENO);
  if (terminal == nullptr)
    redirect(streams.err, O_WRONLY | O_CREAT, STDERR_FILENO);
  else if (::dup2(terminal->theirs(), STDERR_FILENO) < 0)
    ::_exit(127);
  if (::chdir(folder.c_str()) == 0) ::execve(arguments[0], arguments.data(), environment.data());
  ::_exit(127);
}

void wait_for(pid_t child, Outcome& outcome) {
  int status = 0;
  rusage usage{};
  while (::wait4(child, &status, 0, &usage) < 0) {
    if (errno != EINTR) throw std::runtime_error("wait4 failed");
  }
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.peak_kib = usage.ru_maxrss;
}

}  // namespace

Outcome run_dgt(const std::vector<std::string>& arguments, const CommandOptions& options) {
  const TemporaryFolder folder;
  Streams streams{folder.write("in", options.input), folder.name("out"), folder.name("err")};
  if (!options.output_to.empty()) streams.out = options.output_to;

  std::vector<std::string> words = {DGT_COMMAND};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const char* path = std::getenv("PATH");
  std::vector<std::string> environment = {"LC_ALL=C.UTF-8",
                                          std::string("PATH=") + (path != nullptr ? path : "")};
  for (const std::string& entry : options.environment) {
    const auto is_same = [name = entry.substr(0, entry.find('=') + 1)](const std::string& other) {
      return other.starts_with(name);
    };
    std::erase_if(environment, is_same);
    environment.push_back(entry);
  }

  std::optional<Terminal> terminal;
  if (options.on_terminal) terminal.emplace();
  const Terminal* const error = terminal ? &*terminal : nullptr;
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) become(pointers(words), pointers(environment), streams, error, options.folder);
  Outcome outcome;
  if (terminal) outcome.err = terminal->read_all();
  wait_for(child, outcome);
  if (options.output_to.empty()) outcome.out = read_text(streams.out);
  if (!terminal) outcome.err = read_text(streams.err);
  return outcome;
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = fs::temp_directory_path() / "dgt-test-XXXXXX";
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("mkdtemp failed");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& file, const std::string& text) const {
  fs::create_directories((path_ / file).parent_path());
  std::ofstream(path_ / file, std::ios::binary) << text;
  return name(file);
}

std::vector<std::string> TemporaryFolder::entries() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

std::string read_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string corpus(const std::string& file) {
  return fs::path(DGT_SOURCE_DIR) / "tests" / "corpus" / file;
}

}  // namespace dgt::support
