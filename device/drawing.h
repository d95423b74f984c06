// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "device/picture.h"
#include "device/tape.h"

/// A tape drawn true to ISO 1154, in strips below each other.
namespace dgt {

// ISO 1154, all in mm. Distances across the tape are from the edge beside tracks 1 to 3.
inline constexpr double kTapeWidth = 25.4;
inline constexpr double kPitch = 2.54;     ///< of rows and of tracks
inline constexpr double kCodeHole = 1.83;  ///< diameter
inline constexpr double kFeedHole = 1.17;  ///< diameter
inline constexpr double kFeedFromEdge = 9.96;

/// The middle of a track (from 0) from the three-hole edge.
[[nodiscard]] constexpr double track_from_edge(std::size_t track) {
  return kFeedFromEdge + (static_cast<double>(track) - (track < 3 ? 3.0 : 2.0)) * kPitch;
}

struct DrawnHole {
  double x = 0;  ///< mm, the middle
  double y = 0;  ///< mm, downwards
};
/// A piece of tape, the three-hole edge below, the beginning on the left.
struct DrawnStrip {
  std::size_t first_row = 0;
  double x = 0, y = 0;  ///< the upper left corner
  double length = 0;    ///< its width is kTapeWidth
  std::vector<DrawnHole> code;
  std::vector<DrawnHole> feed;
};
struct TapeDrawing {
  double width = 0, height = 0;  ///< mm
  std::vector<DrawnStrip> strips;
};

inline constexpr std::size_t kRowsPerStrip = 100;

[[nodiscard]] TapeDrawing draw_tape(const Tape& tape, RowRange rows = {});

/// The drawing as SVG, one unit a mm, each strip with its first row and distance.
[[nodiscard]] std::string to_svg(const TapeDrawing& drawing);

}  // namespace dgt
