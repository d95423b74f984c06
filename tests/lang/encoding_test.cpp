// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/encoding.h"

#include <gtest/gtest.h>

namespace dgt {
namespace {

TEST(Decode, LeavesUtf8AsItIs) { EXPECT_EQ(decode("L1=X5 ' привет"), "L1=X5 ' привет"); }

TEST(Decode, DropsTheByteOrderMark) { EXPECT_EQ(decode("\xEF\xBB\xBFL1"), "L1"); }

TEST(Decode, PutsAReplacementForEveryInvalidByte) {
  EXPECT_EQ(decode("a\xFFz"), "a\uFFFDz");
  EXPECT_EQ(decode("\xC0\x80"), "\uFFFD\uFFFD") << "overlong";
  EXPECT_EQ(decode("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD") << "surrogate";
  EXPECT_EQ(decode("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD") << "past the last character";
  EXPECT_EQ(decode("\xD0"), "\uFFFD") << "cut off";
}

TEST(CodePointAt, ReadsEveryLength) {
  EXPECT_EQ(code_point_at("A", 0).value, U'A');
  EXPECT_EQ(code_point_at("Я", 0).value, U'Я');
  EXPECT_EQ(code_point_at("−", 0).value, U'−');
  EXPECT_EQ(code_point_at("😀", 0).value, U'😀');
  EXPECT_EQ(code_point_at("😀", 0).size, 4U);
}

TEST(CountCodePoints, CountsCharactersNotBytes) {
  EXPECT_EQ(count_code_points("С2 Р4"), 5U);
  EXPECT_EQ(count_code_points(""), 0U);
}

}  // namespace
}  // namespace dgt
