// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "apps/driver/drawn_layer.h"

namespace dgt {

/// Where the tool stands: so many moves done, and a part of the next.
struct ToolPlace {
  std::size_t steps = 0;  ///< moves that travel, from the first
  double part = 0;        ///< of the next, 0 ≤ part < 1; 0 when there is none

  friend bool operator==(const ToolPlace&, const ToolPlace&) = default;
};

/// A tool path as it is shown, stepped through and pointed at. Steps are the moves that travel:
/// after k of them the tool stands on control point k + 1 (see points.h).
class DrawnPath {
 public:
  /// Nothing when `given_up` says so: it is asked every few thousand moves.
  [[nodiscard]] static std::optional<DrawnPath> of(const Toolpath& path,
                                                   const std::function<bool()>& given_up);
  DrawnPath() = default;

  [[nodiscard]] const DrawnLayer& cuts() const { return cuts_; }
  [[nodiscard]] const DrawnLayer& rapids() const { return rapids_; }
  /// The contours with W = 0, numbered through.
  [[nodiscard]] const DrawnLayer& programmed() const { return programmed_; }
  [[nodiscard]] DrawnPlace start() const { return start_; }

  /// Around everything, the start and the programmed contours included.
  [[nodiscard]] const Box& box() const { return box_; }
  /// The least box around the part itself, as programmed; around all cuts when the path has no
  /// contours. Empty when nothing is cut.
  [[nodiscard]] const Box& part_box() const { return part_box_; }

  [[nodiscard]] std::size_t steps() const { return steps_.size(); }
  [[nodiscard]] DrawnCurve curve(std::size_t step) const;
  [[nodiscard]] bool is_rapid(std::size_t step) const { return steps_[step].rapid; }
  [[nodiscard]] std::uint32_t move(std::size_t step) const;  ///< its number in Toolpath::moves
  [[nodiscard]] const SourcePlace& source(std::size_t step) const;
  /// The step of a move that travels, or of the next that does.
  [[nodiscard]] std::size_t step_of(std::uint32_t move) const;

  [[nodiscard]] double travel() const;                   ///< mm, rapids included
  [[nodiscard]] double travelled(ToolPlace tool) const;  ///< mm
  /// Where the tool is after so many mm; see `travelled`.
  [[nodiscard]] ToolPlace tool_after(double millimetres) const;
  [[nodiscard]] DrawnPlace place(ToolPlace tool) const;
  /// How far the tool cuts around itself in the contour of that move: |W|. Between contours it is
  /// that of the contour before, before the first that of the first.
  [[nodiscard]] double kerf_radius(std::uint32_t move) const;
  [[nodiscard]] double kerf_radius(ToolPlace tool) const;
  [[nodiscard]] double widest_kerf() const;  ///< the largest of them

 private:
  struct Step {
    double end = 0;  ///< mm travelled then
    std::uint32_t curve = 0;
    bool rapid = false;
  };
  struct Kerf {
    std::uint32_t first = 0;  ///< move
    double radius = 0;
  };

  void measure(const Toolpath& path);
  [[nodiscard]] const DrawnLayer& layer(const Step& step) const {
    return step.rapid ? rapids_ : cuts_;
  }

  DrawnLayer cuts_, rapids_, programmed_;
  DrawnPlace start_;
  Box box_, part_box_;
  std::vector<Step> steps_;
  std::vector<Kerf> kerfs_;
};

}  // namespace dgt
