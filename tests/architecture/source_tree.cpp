// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/source_tree.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace dgt::architecture {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

bool is_left_out(const fs::path& relative) { return relative == "build" || relative == ".git"; }

}  // namespace

std::string_view SourceFile::room() const {
  const auto slash = path.find('/');
  return slash == std::string::npos ? std::string_view() : std::string_view(path).substr(0, slash);
}

bool SourceFile::is_header() const { return path.ends_with(".h"); }

bool SourceFile::is_cpp() const {
  return is_header() || path.ends_with(".cpp") || path.ends_with(".def");
}

std::string SourceFile::place(std::size_t index) const {
  return path + ":" + std::to_string(index + 1) + ": ";
}

SourceFile source_file(std::string path, std::string_view text) {
  SourceFile file{std::move(path), {}};
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    file.lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return file;
}

std::vector<SourceFile> read_source_tree(const fs::path& root) {
  std::vector<SourceFile> files;
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::end(entry); ++entry) {
    const fs::path relative = entry->path().lexically_relative(root);
    if (is_left_out(relative)) {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file()) {
      const std::string text = read(entry->path());
      if (text.find('\0') == std::string::npos)
        files.push_back(source_file(relative.generic_string(), text));
    }
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

}  // namespace dgt::architecture
