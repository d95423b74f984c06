// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/fixes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "apps/driver/path_json.h"
#include "tests/lang/program.h"
#include "tests/support/program_generators.h"

namespace dgt {
namespace {

/// Diagnostics about `text`, each an error with a fix-it.
class Fixes {
 public:
  explicit Fixes(std::string_view text) : file_("t.bgt", text) {}
  Fixes& at(std::uint32_t begin, std::uint32_t end, std::string replacement,
            Certainty certainty = Certainty::Sure, Message message = Message::Unexpected) {
    const Range range{&file_, begin, end};
    bag_.add({message, range, {"x"}, {}, FixIt{range, std::move(replacement), certainty}});
    return *this;
  }
  [[nodiscard]] std::string text() const { return apply_fixes(file_, bag_).text; }
  [[nodiscard]] std::size_t count() const { return apply_fixes(file_, bag_).applied.size(); }
  [[nodiscard]] DiagnosticBag& bag() { return bag_; }

 private:
  SourceFile file_;
  DiagnosticBag bag_;
};

TEST(ApplyFixes, ReplacesInsertsAndRemoves) {
  EXPECT_EQ(Fixes("abcdef").at(1, 2, "XYZ").at(3, 3, "-").at(4, 6, "").text(), "aXYZc-d");
  EXPECT_EQ(Fixes("abc").text(), "abc");
  EXPECT_EQ(Fixes("").at(0, 0, "a").text(), "a");
}

TEST(ApplyFixes, GoesByPlaceNotByOrder) {
  EXPECT_EQ(Fixes("abcdef").at(4, 5, "2").at(0, 1, "1").text(), "1bcd2f");
}

TEST(ApplyFixes, TakesTheFirstOfThoseThatOverlap) {
  EXPECT_EQ(Fixes("abcdef").at(0, 3, "1").at(2, 4, "2").at(3, 4, "3").text(), "13ef");
  EXPECT_EQ(
      Fixes("abcdef").at(0, 3, "1").at(0, 3, "2", Certainty::Sure, Message::ExtraWords).text(),
      "1def");
}

TEST(ApplyFixes, TakesOneOfThoseThatBeginAtOnePlace) {
  Fixes fixes("ab");
  fixes.at(1, 1, ",").at(1, 1, ";", Certainty::Sure, Message::ExtraWords).at(1, 2, "c");
  EXPECT_EQ(fixes.text(), "a,b");
  EXPECT_EQ(fixes.count(), 1U);
}

TEST(ApplyFixes, TakesNeighboursBoth) {
  EXPECT_EQ(Fixes("abcd").at(0, 2, "1").at(2, 4, "2").text(), "12");
  EXPECT_EQ(Fixes("abcd").at(0, 2, "1").at(2, 2, "2").text(), "12cd");
}

TEST(ApplyFixes, LeavesGuessesAndNotesAlone) {
  EXPECT_EQ(Fixes("abc").at(0, 1, "x", Certainty::Guess).text(), "abc");
  EXPECT_EQ(Fixes("abc").at(0, 1, "x", Certainty::Sure, Message::OffsetOnLeft).text(), "abc");
}

TEST(ApplyFixes, LeavesOtherFilesAlone) {
  const SourceFile other("other.bgt", "abc");
  Fixes fixes("abc");
  const Range range{&other, 0, 1};
  fixes.bag().add({Message::Unexpected, range, {"a"}, {}, FixIt{range, "x"}});
  EXPECT_EQ(fixes.text(), "abc");
}

std::string path_without_places(std::string_view text, std::string& faults) {
  MemoryLoader loader({{"SLOT.mac", support::kMacro}});
  const SourceFile file("t.bgt", text);
  DiagnosticBag bag;
  CompileResult result = compile(file, loader, {}, bag);
  faults = render(bag);
  if (!result.path) return "";
  for (Move& move : result.path->moves) move.source.column = 0;
  for (Contour& contour : result.path->contours) {
    for (Move& move : contour.programmed.value()) move.source.column = 0;
  }
  return to_json(*result.path);
}

// Nobody's part changes because a tool was asked to tidy up.
RC_GTEST_PROP(ApplyFixesLaws, TheSureFixesOfAProgramThatCompilesKeepItsPath, ()) {
  const std::string text = *support::any_program();
  std::string faults;
  const std::string path = path_without_places(text, faults);
  RC_PRE(!path.empty());
  const SourceFile file("t.bgt", text);
  DiagnosticBag bag;
  MemoryLoader loader({{"SLOT.mac", support::kMacro}});
  (void)compile(file, loader, {}, bag);
  const FixedText fixed = apply_fixes(file, bag);
  RC_CLASSIFY(!fixed.applied.empty(), "fixed");
  RC_ASSERT(path_without_places(fixed.text, faults) == path);
  RC_ASSERT(faults.find("DGT0103") == std::string::npos);  // every look-alike is gone
}

}  // namespace
}  // namespace dgt
