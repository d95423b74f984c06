// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/forms.h"

#include <algorithm>
#include <array>

namespace dgt::language {
namespace {

using enum Recipe;

constexpr ElementKind L = ElementKind::Line;
constexpr ElementKind C = ElementKind::Circle;
constexpr ElementKind P = ElementKind::Point;
constexpr ElementKind O = ElementKind::Frame;

constexpr std::array kForms = {
    Form{L, "X", "L=X", false, LineAtX},
    Form{L, "Y", "L=Y", false, LineAtY},
    Form{L, "PP", "L=XYXY L=PP", false, LineThroughPoints},
    Form{L, "PL", "L=XYL L=PL", false, LineParallelThroughPoint},
    Form{L, "LD", "L=LD", false, LineParallelAtDistance},
    Form{L, "PC", "L=XYC L=PC", false, LineFromPointToCircle},
    Form{L, "PA", "L=XYA L=PA", false, LineThroughPointAtAngle},
    Form{L, "CA", "L=CA", false, LineTangentAtAngle},
    Form{L, "CC", "L=CC", false, LineTangentToCircles},
    Form{L, "LAP", "L=LAP", false, LineTurnedThroughPoint},
    Form{C, "PR", "C=XYR C=PR", false, CircleAtCentre},
    Form{C, "PPP", "C=XYXYXY C=PPP", false, CircleThroughPoints},
    Form{C, "LLR", "C=LLR", false, CircleTouchingLines},
    Form{C, "LRC", "C=LRC C=ILRC", true, CircleTouchingLineAndCircle},
    Form{C, "CRC", "C=CRC C=ICRC", true, CircleTouchingCircles},
    Form{C, "PMAR", "C=PMAR", false, CircleAtPolarCentre},
    Form{P, "P", "P=XY", false, PointAtCoordinates},
    Form{P, "C", "P=C", false, PointAtCentre},
    Form{P, "LL", "P=LL", false, PointOfLines},
    Form{P, "LC", "P=LC P=ILC", true, PointOfLineAndCircle},
    Form{P, "CC", "P=CC P=ICC", true, PointOfCircles},
    Form{P, "MAP", "P=MAP", false, PointAtPolar},
    Form{O, "PA", "O=XYA O=PA", false, FrameAtPoint},
};

// Takes the operands of `form` out of `written`; what the form lacks and what is left over.
FormMismatch::Candidate compare(const Form& form, std::string_view written) {
  FormMismatch::Candidate result{&form, "", {}};
  std::vector<bool> used(written.size(), false);
  const auto take = [&](char letter) {
    for (std::size_t i = 0; i < written.size(); ++i) {
      if (!used[i] && written[i] == letter) {
        used[i] = true;
        return true;
      }
    }
    return false;
  };
  for (const char letter : form.operands) {
    if (take(letter)) continue;
    // Half an inline point is a point that lacks its other coordinate.
    if (letter == 'P' && take('X')) {
      result.missing += 'Y';
    } else if (letter == 'P' && take('Y')) {
      result.missing += 'X';
    } else {
      result.missing += letter;
    }
  }
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (!used[i]) result.surplus.push_back(i);
  }
  return result;
}

std::optional<FormMatch> fill(const Form& form, std::string_view written) {
  if (written.size() != form.operands.size()) return std::nullopt;
  FormMatch match{&form, {}};
  std::vector<bool> used(written.size(), false);
  for (const char letter : form.operands) {
    std::size_t i = 0;
    while (i < written.size() && (used[i] || written[i] != letter)) ++i;
    if (i == written.size()) return std::nullopt;
    used[i] = true;
    match.order.push_back(static_cast<std::uint8_t>(i));
  }
  return match;
}

}  // namespace

std::span<const Form> all_forms() { return kForms; }

std::optional<FormMatch> match_form(ElementKind result, std::string_view operands) {
  for (const Form& form : kForms) {
    if (form.result != result) continue;
    if (std::optional<FormMatch> match = fill(form, operands)) return match;
  }
  return std::nullopt;
}

FormMismatch explain_mismatch(ElementKind result, std::string_view operands) {
  const auto cost = [](const FormMismatch::Candidate& c) {
    return c.missing.size() + c.surplus.size();
  };
  FormMismatch mismatch;
  for (const Form& form : kForms) {
    if (form.result != result) continue;
    FormMismatch::Candidate candidate = compare(form, operands);
    if (!mismatch.nearest.empty() && cost(candidate) > cost(mismatch.nearest.front())) continue;
    if (!mismatch.nearest.empty() && cost(candidate) < cost(mismatch.nearest.front())) {
      mismatch.nearest.clear();
    }
    mismatch.nearest.push_back(std::move(candidate));
  }
  return mismatch;
}

bool is_operand_of(ElementKind result, char letter) {
  return std::any_of(kForms.begin(), kForms.end(), [&](const Form& form) {
    if (form.result != result) return false;
    const bool coordinate = letter == 'X' || letter == 'Y';
    return form.operands.find(letter) != std::string_view::npos ||
           (coordinate && form.operands.find('P') != std::string_view::npos);
  });
}

}  // namespace dgt::language
