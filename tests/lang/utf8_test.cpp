// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/utf8.h"

#include <gtest/gtest.h>

namespace dgt {
namespace {

TEST(AsciiRun, EndsAtTheFirstOtherByteWhereverItStands) {
  for (std::size_t size = 0; size < 20; ++size) {
    for (std::size_t offset = 0; offset <= size; ++offset) {
      std::string text(size, '\x7F');
      EXPECT_EQ(ascii_run(text, offset), size - offset);
      for (std::size_t high = offset; high < size; ++high) {
        text[high] = '\x80';
        EXPECT_EQ(ascii_run(text, offset), high - offset) << size << ' ' << offset;
        text[high] = '\0';
      }
    }
  }
}

TEST(CodePointAt, ReadsEveryLength) {
  EXPECT_EQ(code_point_at("A", 0).value, U'A');
  EXPECT_EQ(code_point_at("Я", 0).value, U'Я');
  EXPECT_EQ(code_point_at("−", 0).value, U'−');
  EXPECT_EQ(code_point_at("😀", 0).value, U'😀');
  EXPECT_EQ(code_point_at("😀", 0).size, 4U);
}

TEST(CodePointAt, TellsAReplacementCharacterFromAnInvalidByte) {
  EXPECT_TRUE(is_valid(code_point_at("\uFFFD", 0)));
  EXPECT_FALSE(is_valid(code_point_at("\xFF", 0)));
}

TEST(CountCodePoints, CountsCharactersNotBytes) {
  EXPECT_EQ(count_code_points("С2 Р4"), 5U);
  EXPECT_EQ(count_code_points(""), 0U);
}

TEST(FoldCase, MakesLatinAndCyrillicSmall) {
  EXPECT_EQ(fold_case("KVAD Плита ЁІ№😀"), "kvad плита ёі№😀");
  EXPECT_EQ(fold_case("A\xFF"), "a\xFF") << "what is no text stays";
}

TEST(DisplayWidth, IsOneForCyrillicNoneForCombiningTwoForWide) {
  EXPECT_EQ(display_width(U'A'), 1U);
  EXPECT_EQ(display_width(U'Щ'), 1U);
  EXPECT_EQ(display_width(U'\u0306'), 0U);
  EXPECT_EQ(display_width(U'中'), 2U);
}

TEST(IsInvisible, HoldsForControlsAndMarksOfDirection) {
  for (const char32_t c : {U'\u0007', U'\u001B', U'\u007F', U'\u009B', U'\u200B', U'\u202E'}) {
    EXPECT_TRUE(is_invisible(c)) << static_cast<std::uint32_t>(c);
  }
  for (const char32_t c : {U'\t', U'\n', U'\r', U' ', U'\u00A0', U'Я'}) {
    EXPECT_FALSE(is_invisible(c)) << static_cast<std::uint32_t>(c);
  }
}

}  // namespace
}  // namespace dgt
