// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/drawn_path.h"

#include <algorithm>
#include <cmath>

namespace dgt {
namespace {

void add(Box& box, const Box& other) {
  if (other.empty()) return;
  box.add(other.left, other.bottom);
  box.add(other.right, other.top);
}

/// Asks now and then.
class Patience {
 public:
  explicit Patience(const std::function<bool()>& given_up) : given_up_(given_up) {}
  [[nodiscard]] bool ends() {
    constexpr std::size_t kSeldom = 4096;
    return ++moves_ % kSeldom == 0 && given_up_ && given_up_();
  }

 private:
  const std::function<bool()>& given_up_;
  std::size_t moves_ = 0;
};

std::vector<Move> parts_of(std::span<const Move> moves) {
  std::vector<Move> parts;
  std::ranges::copy_if(moves, std::back_inserter(parts), is_part);
  return parts;
}

}  // namespace

std::optional<DrawnPath> DrawnPath::of(const Toolpath& path,
                                       const std::function<bool()>& given_up) {
  DrawnPath out;
  Patience patience(given_up);
  out.start_ = {coordinate(path.start.x), coordinate(path.start.y)};
  double travelled = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (patience.ends()) return std::nullopt;
    const Move& move = path.moves[i];
    if (!move.travels()) continue;
    const bool rapid = move.kind == MoveKind::Rapid;
    DrawnLayer& layer = rapid ? out.rapids_ : out.cuts_;
    layer.add(move, static_cast<std::uint32_t>(i));
    travelled += layer[layer.size() - 1].length();
    out.steps_.push_back({travelled, static_cast<std::uint32_t>(layer.size() - 1), rapid});
  }
  std::uint32_t number = 0;
  for (const Contour& contour : path.contours) {
    out.kerfs_.push_back(
        {static_cast<std::uint32_t>(contour.first), std::fabs(nearest_double(contour.offset))});
    for (const Move& move : programmed_moves(path, contour)) {
      if (patience.ends()) return std::nullopt;
      if (move.cuts()) out.programmed_.add(move, number);
      ++number;
    }
  }
  out.measure(path);
  return out;
}

void DrawnPath::measure(const Toolpath& path) {
  for (DrawnLayer* layer : {&cuts_, &rapids_, &programmed_}) {
    layer->index();
    add(box_, layer->box());
  }
  box_.add(start_.x, start_.y);
  for (const Contour& contour : path.contours)
    add(part_box_, box_of(parts_of(programmed_moves(path, contour))));
  if (!part_box_.empty()) return;
  std::vector<Move> cuts;
  std::ranges::copy_if(path.moves, std::back_inserter(cuts), &Move::cuts);
  part_box_ = box_of(cuts);
}

DrawnCurve DrawnPath::curve(std::size_t step) const {
  return layer(steps_[step])[steps_[step].curve];
}

std::uint32_t DrawnPath::move(std::size_t step) const {
  return layer(steps_[step]).number(steps_[step].curve);
}

const SourcePlace& DrawnPath::source(std::size_t step) const {
  return layer(steps_[step]).source(steps_[step].curve);
}

std::size_t DrawnPath::step_of(std::uint32_t move) const {
  return cuts_.count_before(move) + rapids_.count_before(move);
}

double DrawnPath::travel() const { return steps_.empty() ? 0 : steps_.back().end; }

double DrawnPath::travelled(ToolPlace tool) const {
  const double done = tool.steps == 0 ? 0 : steps_[tool.steps - 1].end;
  if (tool.steps == steps_.size()) return done;
  return done + tool.part * (steps_[tool.steps].end - done);
}

ToolPlace DrawnPath::tool_after(double millimetres) const {
  if (millimetres <= 0) return {};
  const auto under_way = std::ranges::upper_bound(steps_, millimetres, {}, &Step::end);
  const auto steps = static_cast<std::size_t>(under_way - steps_.begin());
  if (under_way == steps_.end()) return {steps, 0};
  const double done = steps == 0 ? 0 : steps_[steps - 1].end;
  return {steps, (millimetres - done) / (under_way->end - done)};
}

DrawnPlace DrawnPath::place(ToolPlace tool) const {
  if (tool.steps < steps_.size()) return place_at(curve(tool.steps), tool.part);
  return steps_.empty() ? start_ : curve(steps_.size() - 1).to;
}

double DrawnPath::kerf_radius(std::uint32_t move) const {
  if (kerfs_.empty()) return 0;
  const auto after = std::ranges::upper_bound(kerfs_, move, {}, &Kerf::first);
  return after == kerfs_.begin() ? kerfs_.front().radius : std::prev(after)->radius;
}

double DrawnPath::kerf_radius(ToolPlace tool) const {
  if (steps_.empty()) return kerf_radius(std::uint32_t{0});
  return kerf_radius(move(std::min(tool.steps, steps_.size() - 1)));
}

double DrawnPath::widest_kerf() const {
  double widest = 0;
  for (const Kerf& kerf : kerfs_) widest = std::max(widest, kerf.radius);
  return widest;
}

}  // namespace dgt
