// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/forms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace dgt::language {
namespace {

TEST(Forms, EveryRowMatchesItselfInEveryOrder) {
  for (const Form& form : all_forms()) {
    std::string letters(form.operands);
    std::sort(letters.begin(), letters.end());
    do {
      const auto match = match_form(form.result, letters);
      ASSERT_TRUE(match.has_value()) << form.pattern << " as " << letters;
      EXPECT_EQ(match->form, &form) << form.pattern << " as " << letters;
    } while (std::next_permutation(letters.begin(), letters.end()));
  }
}

TEST(Forms, NoTwoRowsTakeTheSameOperands) {
  std::set<std::string> seen;
  for (const Form& form : all_forms()) {
    std::string key(form.operands);
    std::sort(key.begin(), key.end());
    EXPECT_TRUE(seen.insert(static_cast<char>(form.result) + key).second) << form.pattern;
  }
}

TEST(Forms, LikeKindsKeepTheirWrittenOrder) {
  const auto match = match_form(ElementKind::Circle, "RCC");
  ASSERT_TRUE(match.has_value());
  EXPECT_EQ(match->form->recipe, Recipe::CircleTouchingCircles);
  EXPECT_EQ(match->order, (std::vector<std::uint8_t>{1, 0, 2}));
}

TEST(Forms, SelectorsStandWhereTwoSolutionsAreLeft) {
  for (const Form& form : all_forms()) {
    const bool guide_has_selector = form.pattern.find("=I") != std::string_view::npos;
    EXPECT_EQ(form.takes_selector, guide_has_selector) << form.pattern;
  }
}

TEST(FormMismatch, NamesEveryFormThatLacksTheFewestOperands) {
  const FormMismatch mismatch = explain_mismatch(ElementKind::Line, "L");
  ASSERT_EQ(mismatch.nearest.size(), 2U);
  EXPECT_EQ(mismatch.nearest[0].form->recipe, Recipe::LineParallelThroughPoint);
  EXPECT_EQ(mismatch.nearest[0].missing, "P");
  EXPECT_EQ(mismatch.nearest[1].form->recipe, Recipe::LineParallelAtDistance);
  EXPECT_EQ(mismatch.nearest[1].missing, "D");
}

TEST(FormMismatch, HalfAPointLacksItsOtherCoordinate) {
  const FormMismatch mismatch = explain_mismatch(ElementKind::Point, "X");
  ASSERT_EQ(mismatch.nearest.size(), 1U);
  EXPECT_EQ(mismatch.nearest[0].missing, "Y");
}

TEST(FormMismatch, FindsTheSurplusOperand) {
  const FormMismatch mismatch = explain_mismatch(ElementKind::Circle, "PRD");
  ASSERT_FALSE(mismatch.nearest.empty());
  EXPECT_EQ(mismatch.nearest[0].form->recipe, Recipe::CircleAtCentre);
  EXPECT_EQ(mismatch.nearest[0].surplus, (std::vector<std::size_t>{2}));
}

}  // namespace
}  // namespace dgt::language
