// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of the house, held against the tree as it stands; each rule is first shown to notice
// a file that breaks it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/architecture/rules.h"

namespace dgt::architecture {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<SourceFile>& tree() {
  static const std::vector<SourceFile> kFiles = read_source_tree(DGT_SOURCE_DIR);
  return kFiles;
}

/// The violations of a rule in the whole tree, one a line.
std::string in_tree(Violations (*rule)(const SourceFile&)) {
  std::string all;
  for (const auto& file : tree()) {
    for (const auto& violation : rule(file)) all += violation + "\n";
  }
  return all;
}

Violations includes_of(const std::string& path, const std::string& text) {
  return wrong_includes(source_file(path, text));
}

TEST(SourceTree, IsReadWithItsRooms) {
  for (const std::string path : {"CMakeLists.txt", "kernel/number.h", ".ci/run"}) {
    EXPECT_EQ(std::ranges::count(tree(), path, &SourceFile::path), 1) << path;
  }
}

TEST(SourceTree, LinesCountFromOne) {
  const auto file = source_file("lang/a.h", "first\n\nthird");
  EXPECT_THAT(file.lines, ElementsAre("first", "", "third"));
  EXPECT_EQ(file.place(2), "lang/a.h:3: ");
  EXPECT_EQ(file.room(), "lang");
  EXPECT_EQ(source_file("README.md", "").room(), "");
}

TEST(IncludeDirections, TheTreeKeepsThem) { EXPECT_EQ(in_tree(wrong_includes), ""); }

TEST(IncludeDirections, PostIntoLangIsNamedWithItsLine) {
  EXPECT_THAT(includes_of("post/a.cpp", "//\n#include \"lang/dgt/lexer.h\"\n"),
              ElementsAre("post/a.cpp:2: post must not include \"lang/dgt/lexer.h\""));
}

TEST(IncludeDirections, EachWrongArrowIsNoticed) {
  EXPECT_EQ(includes_of("kernel/a.h", "#include \"lang/a.h\"").size(), 1U);
  EXPECT_EQ(includes_of("kernel/a.cpp", "# include \"post/a.h\"").size(), 1U);
  EXPECT_EQ(includes_of("lang/a.cpp", "#include \"post/a.h\"").size(), 1U);
  EXPECT_EQ(includes_of("lang/a.cpp", "#include \"apps/driver/a.h\"").size(), 1U);
  EXPECT_EQ(includes_of("device/a.cpp", "#include \"kernel/a.h\"").size(), 1U);
  EXPECT_EQ(includes_of("apps/cli/a.cpp", "#include \"tests/support/a.h\"").size(), 1U);
}

TEST(IncludeDirections, AFileIsNamedFromTheRoot) {
  EXPECT_EQ(includes_of("kernel/a.cpp", "#include \"a.h\"").size(), 1U);
  EXPECT_EQ(includes_of("kernel/a.cpp", "#include \"../kernel/a.h\"").size(), 1U);
}

TEST(IncludeDirections, EachRightArrowIsLeftAlone) {
  EXPECT_THAT(includes_of("lang/a.cpp", "#include \"kernel/a.h\"\n#include <fmt/core.h>"),
              IsEmpty());
  EXPECT_THAT(includes_of("post/a.h", "#include \"kernel/a.h\"\n#include <vector>"), IsEmpty());
  EXPECT_THAT(includes_of("apps/driver/a.h", "#include \"post/a.h\"\n#include \"lang/a.h\""),
              IsEmpty());
  EXPECT_THAT(includes_of("lang/README.md", "#include \"post/a.h\""), IsEmpty());
}

TEST(IncludeDirections, CgalStaysInItsRoom) {
  EXPECT_EQ(includes_of("kernel/a.cpp", "#include <CGAL/Cartesian.h>").size(), 1U);
  EXPECT_EQ(includes_of("tests/kernel/a.cpp", "#include <CGAL/Cartesian.h>").size(), 1U);
  EXPECT_THAT(includes_of("kernel/cgal/a.cpp", "#include <CGAL/Cartesian.h>"), IsEmpty());
}

TEST(IncludeDirections, PublicHeadersOfKernelBringInStdAndGmpOnly) {
  EXPECT_THAT(includes_of("kernel/a.h", "#include <vector>\n#include <gmpxx.h>"), IsEmpty());
  EXPECT_EQ(includes_of("kernel/a.h", "#include <mpfr.h>").size(), 1U);
  EXPECT_EQ(includes_of("kernel/a.h", "#include <fmt/core.h>").size(), 1U);
  EXPECT_EQ(includes_of("kernel/a.h", "#include \"kernel/mpfr_float.h\"").size(), 1U);
  EXPECT_EQ(includes_of("kernel/a.h", "#include \"kernel/cgal/types.h\"").size(), 1U);
  EXPECT_THAT(includes_of("kernel/a.cpp", "#include <mpfr.h>"), IsEmpty());
  EXPECT_THAT(includes_of("kernel/mpfr_float.h", "#include <mpfr.h>"), IsEmpty());
}

TEST(IncludeDirections, HeadersOfDeviceBringInStdOnly) {
  EXPECT_THAT(includes_of("device/a.h", "#include <span>\n#include <tl/expected.hpp>"), IsEmpty());
  EXPECT_EQ(includes_of("device/a.h", "#include <gmpxx.h>").size(), 1U);
}

TEST(Opening, EveryFileOfTheTreeNamesItsLicence) { EXPECT_EQ(in_tree(wrong_opening), ""); }

TEST(Opening, AMissingLicenceOrGuardIsNoticed) {
  const std::string licence = "// SPDX-License-Identifier: GPL-3.0-or-later\n";
  EXPECT_EQ(wrong_opening(source_file("lang/a.cpp", "int a;\n")).size(), 1U);
  EXPECT_EQ(wrong_opening(source_file("lang/a.cpp", "")).size(), 1U);
  EXPECT_EQ(wrong_opening(source_file("lang/a.h", licence)).size(), 1U);
  EXPECT_THAT(wrong_opening(source_file("lang/a.h", licence + "#pragma once\n")), IsEmpty());
  EXPECT_THAT(wrong_opening(source_file("lang/a.md", "text")), IsEmpty());
}

TEST(ForbiddenWords, TheTreeHasNone) { EXPECT_EQ(in_tree(forbidden_words), ""); }

TEST(ForbiddenWords, AMarkOrAnAbsolutePathIsNoticed) {
  const std::string mark = std::string("TO") + "DO";
  const std::string path = std::string("/") + "home/someone/file";
  EXPECT_EQ(forbidden_words(source_file("lang/a.cpp", "// " + mark + ": later")).size(), 1U);
  EXPECT_EQ(forbidden_words(source_file("README.md", "see `" + path + "`")).size(), 1U);
  EXPECT_EQ(forbidden_words(source_file("README.md", path)).size(), 1U);
}

TEST(ForbiddenWords, PartsOfOtherWordsAreLeftAlone) {
  const std::string path = std::string("/") + "home/someone/file";
  const std::string mark = std::string("TO") + "DO";
  EXPECT_THAT(forbidden_words(source_file("lang/a.cpp", mark + "S")), IsEmpty());
  EXPECT_THAT(forbidden_words(source_file("lang/a.cpp",
                                          "example.org/"
                                          "home/")),
              IsEmpty());
  EXPECT_THAT(forbidden_words(source_file("tests/corpus/a.bgt", mark)), IsEmpty());
}

TEST(TypeNames, NoTwoHeadersDefineOneType) { EXPECT_THAT(types_named_twice(tree()), IsEmpty()); }

TEST(TypeNames, ATypeDefinedTwiceIsNamedWithBothPlaces) {
  const auto in = [](const char* path, const char* space) {
    return source_file(path, std::string("namespace ") + space + " {\nstruct Box {\n");
  };
  EXPECT_THAT(types_named_twice({in("kernel/a.h", "dgt"), in("post/b.h", "dgt")}),
              ElementsAre("post/b.h:2: dgt::Box is also in kernel/a.h"));
  EXPECT_THAT(types_named_twice({in("kernel/a.h", "dgt"), in("post/b.h", "dgt::post")}), IsEmpty());
  EXPECT_THAT(types_named_twice({in("kernel/a.h", "dgt"), in("post/b.cpp", "dgt")}), IsEmpty());
}

TEST(TopLevel, HasNoStrangers) { EXPECT_THAT(strangers_at_top_level(DGT_SOURCE_DIR), IsEmpty()); }

TEST(TopLevel, AStrangerIsNamed) {
  const std::filesystem::path root = testing::TempDir() + "dgt_top_level";
  std::filesystem::create_directories(root / "kernel");
  std::filesystem::create_directories(root / "utils");
  std::filesystem::create_directories(root / ".hidden");
  EXPECT_THAT(strangers_at_top_level(root), ElementsAre("utils:1: has no place at the top level"));
  std::filesystem::remove_all(root);
}

}  // namespace
}  // namespace dgt::architecture
