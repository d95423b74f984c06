// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "lang/text/diagnostic.h"

namespace dgt {
namespace {

// Every test of this folder in one string.
std::string all_tests() {
  std::string text;
  const std::filesystem::path folder = std::filesystem::path(DGT_SOURCE_DIR) / "tests" / "lang";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp") continue;
    std::ifstream in(entry.path(), std::ios::binary);
    text.append(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return text;
}

TEST(Messages, EveryOneIsShownByATest) {
  const std::string tests = all_tests();
  for (const MessageInfo& row : all_messages()) {
    if (row.name == "TooManyDiagnostics") continue;  // DiagnosticBag's own test shows it by name
    EXPECT_NE(tests.find("[" + std::string(row.code) + "]"), std::string::npos)
        << row.code << " " << row.name;
  }
}

}  // namespace
}  // namespace dgt
