// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/source_file.h"

#include <gtest/gtest.h>

namespace dgt {
namespace {

TEST(SourceFile, EveryKindOfLineEndEndsALine) {
  const SourceFile file("a.bgt", "one\r\ntwo\nthree\rfour");
  ASSERT_EQ(file.line_count(), 4U);
  EXPECT_EQ(file.line_text(1), "one");
  EXPECT_EQ(file.line_text(2), "two");
  EXPECT_EQ(file.line_text(3), "three");
  EXPECT_EQ(file.line_text(4), "four");
}

TEST(SourceFile, AnEmptyFileHasOneEmptyLine) {
  const SourceFile file("a.bgt", "");
  ASSERT_EQ(file.line_count(), 1U);
  EXPECT_EQ(file.line_text(1), "");
}

TEST(SourceFile, ALineEndAtTheEndOpensNoLine) {
  EXPECT_EQ(SourceFile("a.bgt", "one\n").line_count(), 1U);
  EXPECT_EQ(SourceFile("a.bgt", "one\n\n").line_count(), 2U);
}

TEST(Range, ColumnsAndLengthsCountCharacters) {
  const SourceFile file("a.bgt", "x\nС2 Р4 L5");
  const auto begin = static_cast<std::uint32_t>(file.text().find("Р4"));
  const Range range{&file, begin, begin + 3};
  EXPECT_EQ(range.text(), "Р4");
  EXPECT_EQ(range.place(), (Place{2, 4, 2}));
}

TEST(Range, TheLengthStopsAtTheEndOfTheLine) {
  const SourceFile file("a.bgt", "abc\ndef");
  EXPECT_EQ((Range{&file, 1, 7}).place(), (Place{1, 2, 2}));
  EXPECT_EQ((Range{&file, 7, 7}).place(), (Place{2, 4, 0})) << "the end of the file";
}

TEST(Range, JoinsOnlyWhatFollowsInOneFile) {
  const SourceFile file("a.bgt", "abcdef");
  const SourceFile other("b.bgt", "abcdef");
  EXPECT_EQ(join({&file, 0, 1}, {&file, 3, 4}), (Range{&file, 0, 4}));
  EXPECT_EQ(join({&file, 3, 4}, {&file, 0, 1}), (Range{&file, 3, 4}));
  EXPECT_EQ(join({&file, 0, 1}, {&other, 3, 4}), (Range{&file, 0, 1}));
}

}  // namespace
}  // namespace dgt
