// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "apps/driver/pipeline.h"
#include "post/write.h"

namespace dgt {

/// The dialect by which `--to` names the language itself.
inline constexpr const char* kDgtDialect = "dgt";

/// A program that was written in DGT.
struct DgtSource {
  WriteResult written;  ///< the text in the layout of `dgt format`; its deviation is proved
  std::size_t contours = 0;
  std::size_t by_points = 0;      ///< contours that only points could say
  std::size_t without_width = 0;  ///< contours with W that are written as they are cut
};

/// No move of what is written leaves the path by more than this, or the contour is said another
/// way. A thousandth of the finest unit of a control. Unit: mm.
inline constexpr double kDgtDeviation = 1e-6;

/// Writes a path as a DGT program that a person would go on with: elements, tangents and fillets,
/// contours with their W. Each contour is compiled as it is written and held against the path, move
/// by move, with the bound of kernel/measure.h; one that differs is said in the next plainer style
/// (post/dgt.h), in the end from point to point.
/// `title`: the comment at the head. Faults are those of to_dgt(), and `OutOfRange` where even
/// points do not give the move back.
[[nodiscard]] DgtSource write_dgt(const Toolpath& path, const std::string& title);

}  // namespace dgt
