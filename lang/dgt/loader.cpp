// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/loader.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

#include "lang/text/encoding.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;

// The file of `folder` whose name is `wanted` but for upper and lower case.
std::optional<fs::path> find_in(const fs::path& folder, const std::string& wanted) {
  std::error_code error;
  const fs::path exact = folder / fs::path(wanted);
  if (fs::is_regular_file(exact, error)) return exact;
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    std::error_code ignored;
    if (entry.is_regular_file(ignored) &&
        fold_case(entry.path().filename().string()) == fold_case(wanted)) {
      found.push_back(folder / entry.path().filename());
    }
  }
  if (found.empty()) return std::nullopt;
  return *std::min_element(found.begin(), found.end());  // the same on every disk
}

std::optional<SourceText> read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (in.bad()) return std::nullopt;
  return SourceText{path.string(), std::move(bytes)};
}

bool has_folder_in_it(std::string_view name) {
  return name.find_first_of("/\\") != std::string_view::npos;
}

}  // namespace

std::optional<SourceText> FolderLoader::load_macro(std::string_view name) {
  if (has_folder_in_it(name)) return std::nullopt;
  std::vector<fs::path> search;
  if (program_folder_) search = {*program_folder_, *program_folder_ / "mac"};
  search.insert(search.end(), folders_.begin(), folders_.end());
  for (const fs::path& folder : search) {
    for (const std::string_view extension : {".mac", ".bgt"}) {
      if (const auto path = find_in(folder, std::string(name).append(extension))) {
        return read(*path);
      }
    }
  }
  return std::nullopt;
}

std::optional<SourceText> FolderLoader::load_definitions(std::string_view name) {
  if (!program_folder_ || has_folder_in_it(name)) return std::nullopt;
  const auto path = find_in(*program_folder_, std::string(name) + ".bgt");
  return path ? read(*path) : std::nullopt;
}

}  // namespace dgt
