// SPDX-License-Identifier: GPL-3.0-or-later
//
// A message that nobody has read as it comes out is not finished. Tests compare rendered text, so
// a code in brackets in a test's source, or in a golden file, is a message that was looked at.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "lang/text/diagnostic.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// `DGT0203` for each `[DGT0203]`.
std::set<std::string, std::less<>> codes_shown_in(const std::string& text) {
  static const std::regex kCode("\\[(DGT[0-9]{4})\\]");
  return {std::sregex_token_iterator(text.begin(), text.end(), kCode, 1),
          std::sregex_token_iterator()};
}

std::set<std::string, std::less<>> codes_shown_by_tests() {
  const fs::path tests = fs::path(DGT_SOURCE_DIR) / "tests";
  std::set<std::string, std::less<>> shown;
  for (const char* folder : {"lang", "apps", "device_commands", "corpus"}) {
    for (const auto& entry : fs::recursive_directory_iterator(tests / folder)) {
      const bool is_this = entry.path().filename() == "messages_shown_test.cpp";
      if (entry.is_regular_file() && !is_this)
        shown.merge(codes_shown_in(content_of(entry.path())));
    }
  }
  return shown;
}

TEST(MessagesShown, FindsCodesInRenderedTextOnly) {
  EXPECT_EQ(codes_shown_in("a:1:1: error: x [DGT0203]\\n\" \"[DGT0204]\" DGT0205 [DGT020]"),
            (std::set<std::string, std::less<>>{"DGT0203", "DGT0204"}));
}

TEST(MessagesShown, EveryMessageIsShownByATest) {
  const auto shown = codes_shown_by_tests();
  for (const MessageInfo& row : all_messages()) {
    EXPECT_TRUE(shown.contains(row.code)) << row.code << " " << row.name << ": " << row.english;
  }
}

}  // namespace
}  // namespace dgt
