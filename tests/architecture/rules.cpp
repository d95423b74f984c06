// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string_view>

namespace dgt::architecture {
namespace {

constexpr std::string_view kLicence = "// SPDX-License-Identifier: GPL-3.0-or-later";

struct Include {
  std::string target;
  bool quoted = false;
};

std::string_view without_leading_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

std::optional<Include> parse_include(std::string_view line) {
  line = without_leading_blanks(line);
  if (!line.starts_with('#')) return std::nullopt;
  line = without_leading_blanks(line.substr(1));
  constexpr std::string_view kInclude = "include";
  if (!line.starts_with(kInclude)) return std::nullopt;
  line = without_leading_blanks(line.substr(kInclude.size()));
  if (line.empty() || (line[0] != '"' && line[0] != '<')) return std::nullopt;
  const bool quoted = line[0] == '"';
  const auto end = line.find(quoted ? '"' : '>', 1);
  return Include{std::string(line.substr(1, end - 1)), quoted};
}

/// The rooms that a file of `room` may include from.
const std::set<std::string_view>& reach(std::string_view room) {
  static const std::map<std::string_view, std::set<std::string_view>> kReach = {
      {"kernel", {"kernel"}},
      {"lang", {"lang", "kernel"}},
      {"post", {"post", "kernel"}},
      {"device", {"device"}},
      {"apps", {"apps", "lang", "post", "device", "kernel"}},
      {"tests", {"tests", "apps", "lang", "post", "device", "kernel"}},
      {"benchmarks", {"benchmarks", "apps", "lang", "post", "device", "kernel"}},
  };
  static const std::set<std::string_view> kNowhere;
  const auto found = kReach.find(room);
  return found == kReach.end() ? kNowhere : found->second;
}

/// The standard library's own headers have neither folder nor extension.
bool is_standard(std::string_view target) {
  return target.find_first_of("./") == std::string_view::npos;
}

bool is_gmp(std::string_view target) { return target == "gmp.h" || target == "gmpxx.h"; }

/// What is wrong with this include in this file; "" when nothing is.
std::string fault_of_quoted(const SourceFile& file, const std::string& target) {
  const auto slash = target.find('/');
  const std::string room = slash == std::string::npos ? "" : target.substr(0, slash);
  if (!reach(file.room()).contains(room)) {
    return std::string(file.room()) + " must not include \"" + target + "\"";
  }
  if (file.room() == "kernel" && file.is_header() && !is_internal_to_kernel(file.path) &&
      is_internal_to_kernel(target)) {
    return "a public header of kernel must not include the internal \"" + target + "\"";
  }
  return "";
}

std::string fault_of_angled(const SourceFile& file, const std::string& target) {
  if (target.starts_with("CGAL/") && !file.path.starts_with("kernel/cgal/")) {
    return "CGAL is included inside kernel/cgal/ only, not <" + target + ">";
  }
  if (!file.is_header() || is_standard(target)) return "";
  if (file.room() == "kernel" && !is_internal_to_kernel(file.path) && !is_gmp(target)) {
    return "a public header of kernel includes std and GMP only, not <" + target + ">";
  }
  if (file.room() == "device" && target != "tl/expected.hpp") {
    return "a header of device includes std and tl::expected only, not <" + target + ">";
  }
  return "";
}

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool contains_word(std::string_view line, std::string_view word) {
  for (auto at = line.find(word); at != std::string_view::npos; at = line.find(word, at + 1)) {
    const auto end = at + word.size();
    const bool starts = at == 0 || !is_word_character(line[at - 1]);
    if (starts && (end == line.size() || !is_word_character(line[end]))) return true;
  }
  return false;
}

/// A path counts as absolute when nothing that could belong to it stands before its first slash.
bool contains_absolute_path(std::string_view line, std::string_view prefix) {
  constexpr std::string_view kBefore = " \t\"'`(<=:,";
  for (auto at = line.find(prefix); at != std::string_view::npos; at = line.find(prefix, at + 1)) {
    if (at == 0 || kBefore.find(line[at - 1]) != std::string_view::npos) return true;
  }
  return false;
}

}  // namespace

bool is_internal_to_kernel(const std::string& path) {
  return path.starts_with("kernel/cgal/") || path.starts_with("kernel/mpfr_");
}

Violations wrong_includes(const SourceFile& file) {
  Violations found;
  if (!file.is_cpp()) return found;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const auto include = parse_include(file.lines[i]);
    if (!include) continue;
    const std::string fault = include->quoted ? fault_of_quoted(file, include->target)
                                              : fault_of_angled(file, include->target);
    if (!fault.empty()) found.push_back(file.place(i) + fault);
  }
  return found;
}

Violations wrong_opening(const SourceFile& file) {
  Violations found;
  if (!file.is_cpp()) return found;
  if (file.lines.empty() || file.lines[0] != kLicence) {
    found.push_back(file.place(0) + "the first line must be \"" + std::string(kLicence) + "\"");
  }
  if (file.is_header() && std::ranges::count(file.lines, "#pragma once") != 1) {
    found.push_back(file.place(0) + "a header has one #pragma once");
  }
  return found;
}

Violations forbidden_words(const SourceFile& file) {
  // Put together from pieces, so that this file keeps the rule too.
  const auto joined = [](std::string_view a, std::string_view b, std::string_view c = "") {
    return std::string(a).append(b).append(c);
  };
  static const std::array kMarks = {joined("TO", "DO"), joined("FIX", "ME"), joined("XX", "X"),
                                    joined("HA", "CK")};
  static const std::array kHomes = {joined("/", "home", "/"), joined("/", "root", "/"),
                                    joined("/", "Users", "/"), joined("/", "work", "/"),
                                    joined("/", "mnt", "/")};
  Violations found;
  if (file.path == "LICENSE") return found;
  const bool is_data = file.path.starts_with("tests/corpus/");
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    for (const auto& mark : kMarks) {
      if (!is_data && contains_word(file.lines[i], mark)) {
        found.push_back(file.place(i) + "mark of unfinished work: " + mark);
      }
    }
    for (const auto& home : kHomes) {
      if (contains_absolute_path(file.lines[i], home)) {
        found.push_back(file.place(i) + "absolute path of one machine: " + home);
      }
    }
  }
  return found;
}

Violations types_named_twice(const std::vector<SourceFile>& files) {
  static const std::set<std::string, std::less<>> kRooms = {"kernel", "lang", "post", "device",
                                                            "apps"};
  static const std::regex kNamespace(R"(^namespace ([\w:]*) ?\{)");
  static const std::regex kType(
      R"(^(?:struct|class|enum class) (\w+)(?: final)?(?: : [^;]*)? ?\{)");
  std::map<std::string, std::string> known;
  Violations violations;
  for (const auto& file : files) {
    if (kRooms.find(file.room()) == kRooms.end() || !file.is_header()) continue;
    std::string space;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      std::smatch found;
      if (std::regex_search(file.lines[i], found, kNamespace)) space = found[1];
      if (!std::regex_search(file.lines[i], found, kType)) continue;
      const std::string name = space + "::" + found[1].str();
      const auto [first, fresh] = known.try_emplace(name, file.path);
      if (!fresh && first->second != file.path)
        violations.push_back(file.place(i) + name + " is also in " + first->second);
    }
  }
  return violations;
}

Violations strangers_at_top_level(const std::filesystem::path& root) {
  static const std::set<std::string> kEntries = {
      "CHANGELOG.md", "CMakeLists.txt", "CMakePresets.json",
      "LICENSE",      "README.md",      "apps",
      "benchmarks",   "build",          "device",
      "kernel",       "lang",           "post",
      "tests"};
  Violations found;
  for (const auto& entry : std::filesystem::directory_iterator(root)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with('.') && !kEntries.contains(name)) {
      found.push_back(name + ":1: has no place at the top level");
    }
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace dgt::architecture
