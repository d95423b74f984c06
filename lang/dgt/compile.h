// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "kernel/contour.h"
#include "kernel/part_crossing.h"
#include "kernel/progress.h"
#include "lang/dgt/elements.h"
#include "lang/dgt/loader.h"
#include "lang/text/diagnostic.h"

namespace dgt {

/// Ends for programs that have none. Passing one is an error of its own.
struct EvaluateBounds {
  std::uint64_t statements = 10'000'000;  ///< executed, loops and macros counted as they run
  std::uint64_t moves = 10'000'000;
  std::uint32_t loop_depth = 100;   ///< FOR in FOR, through macros
  std::uint32_t macro_depth = 100;  ///< MAC in MAC
  std::uint32_t text_depth = 100;   ///< B in B
};

/// What a program is compiled for.
enum class Purpose : std::uint8_t {
  Path,
  Check  ///< for what is wrong with it: of more than kMovesLookedOver moves none are kept
};
/// So many moves are kept in a check, to look for those that cross contours; about 1 KiB each. A
/// part has some hundreds, and a check of the largest programs stays within a few times their text.
inline constexpr std::uint64_t kMovesLookedOver = 10'000;

struct EvaluateOptions {
  Purpose purpose = Purpose::Path;
  /// Where W > 0 lies, until a comment `'@ offset-side left|right|auto` in the source says
  /// otherwise.
  OffsetSide offset_side = OffsetSide::Auto;
  /// See ContourOptions; mm.
  Rational join_tolerance = Rational(1, 1000);
  /// What a tool that cuts into the contour is.
  GougePolicy gouge = GougePolicy::Error;
  /// How the equidistant goes round outer corners; see ContourOptions.
  CornerStyle corner = CornerStyle::Extend;
  Rational corner_limit = 4;
  /// Which moves are looked at for going over a part.
  CrossingMoves crossings = CrossingMoves::All;
  EvaluateBounds bounds;
  /// Of macros and definition files; nothing: as each of them looks.
  std::optional<Encoding> encoding;
  OnProgress on_progress;  ///< of the program's text, in bytes
};

/// What a program comes to.
struct CompileResult {
  /// Nothing when there is an error; without moves when only a check was wanted.
  std::optional<Toolpath> path;
  language::ElementTable elements;  ///< as they stand at the end
  /// Macros and definition files that were read. Diagnostics point into them and into the program.
  std::vector<std::shared_ptr<const SourceFile>> files;
};

/// Reads and executes a DGT program. Everything that is wrong with it goes to `bag`, in the order
/// of the text. `file` and the result must outlive the diagnostics.
[[nodiscard]] CompileResult compile(const SourceFile& file, SourceLoader& loader,
                                    const EvaluateOptions& options, DiagnosticBag& bag);

}  // namespace dgt
