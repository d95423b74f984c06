// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "apps/studio/part.h"

/// What the compiler says about a program, as a person reads it.
namespace dgt::studio {

/// A stretch of a line. Lines and columns count from 1, columns and lengths in code points.
struct FaultPlace {
  QString file;  ///< its name; empty: the program itself
  Place place;
};

struct FaultNote {
  QString text;
  FaultPlace at;
};

/// A cure: what stands between two places of the program, and what should.
struct Cure {
  Place begin;
  Place end;
  QString was;
  QString replacement;
  Certainty certainty = Certainty::Sure;
};

struct Fault {
  Severity severity = Severity::Error;
  QString code;  ///< `DGT0203`
  QString text;
  FaultPlace at;
  std::optional<Place> other;  ///< a second place at fault in the same line
  std::vector<FaultNote> notes;
  std::optional<Cure> cure;  ///< in the program itself
};

/// All that is told about a program, in the order of the compiler.
[[nodiscard]] std::vector<Fault> faults_of(const Compilation& made, Language language);

/// A fault as rich text for a tip: the sentence, its code, its notes and the cure.
[[nodiscard]] QString tip_of(const Fault& fault);

}  // namespace dgt::studio
