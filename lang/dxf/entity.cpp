// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dxf/entity.h"

#include <algorithm>
#include <array>
#include <utility>

namespace dgt {
namespace {

/// Entities that say something about the part and are not part of it.
constexpr std::array<std::string_view, 25> kAnnotations = {
    "ACAD_TABLE", "ARC_DIMENSION", "ATTDEF",  "ATTRIB", "DIMENSION",   "HATCH",     "IMAGE",
    "LEADER",     "LIGHT",         "MLEADER", "MTEXT",  "MULTILEADER", "OLE2FRAME", "OLEFRAME",
    "POINT",      "RAY",           "RTEXT",   "SEQEND", "SUN",         "TEXT",      "TOLERANCE",
    "UNDERLAY",   "VIEWPORT",      "WIPEOUT", "XLINE"};

constexpr long kClosed = 1;
constexpr long kThreeDimensional = 8;
constexpr long kMeshes = 16 | 64;
constexpr long kFrameVertex = 16;

/// π to 60 digits.
const Rational& pi() {
  static const Rational kPi =
      *parse_decimal("3.14159265358979323846264338327950288419716939937510582097494");
  return kPi;
}

/// Degrees, those beside a quarter turn taken for it.
Rational snapped(const Rational& degrees) {
  const Rational quarter = Rational(nearest_integer(degrees / 90)) * 90;
  return abs(degrees - quarter) <= dxf_angle_rounding() ? quarter : degrees;
}

class EntityReader {
 public:
  EntityReader(const DxfRecord& record, DxfGroups& groups, DiagnosticBag& bag)
      : record_(record), groups_(groups), bag_(bag) {}

  DxfEntity run() {
    entity_.place = record_.name;
    const DxfGroup* const layer = record_.find(8);
    entity_.layer = layer != nullptr ? std::string(layer->text()) : "0";
    entity_.hidden = whole_or(67, 0) == 1 || (whole_or(60, 0) & 1) == 1;
    read_shape(record_.name.text());
    return std::move(entity_);
  }

 private:
  void read_shape(std::string_view kind) {
    if (kind == "LINE") return read_line();
    if (kind == "ARC") return read_arc();
    if (kind == "CIRCLE") return read_circle();
    if (kind == "LWPOLYLINE") return read_light_polyline();
    if (kind == "POLYLINE") return read_polyline();
    if (kind == "ELLIPSE") return read_ellipse();
    if (kind == "SPLINE") return read_spline();
    if (kind == "INSERT") return read_insert();
    entity_.shape = DxfOther{std::ranges::find(kAnnotations, kind) != kAnnotations.end()};
  }

  // --- numbers

  Rational number_or(int code, const Rational& otherwise) {
    const DxfGroup* const group = record_.find(code);
    return group != nullptr ? groups_.number(*group) : otherwise;
  }
  long whole_or(int code, long otherwise) {
    const DxfGroup* const group = record_.find(code);
    return group != nullptr ? groups_.whole(*group) : otherwise;
  }
  Rational needed(int code) {
    const DxfGroup* const group = record_.find(code);
    if (group != nullptr) return groups_.number(*group);
    report_lack(record_.name, code);
    return 0;
  }
  RationalPoint needed_point(int code) {
    Rational x = needed(code);
    return {std::move(x), needed(code + 10)};
  }
  void report_lack(const Range& place, int code) {
    bag_.add({Message::DxfLacking, place, {std::string(place.text()), std::to_string(code)}});
  }
  void fail(Message message, std::vector<std::string> arguments = {}) {
    entity_.shape = DxfFaulty{message, std::move(arguments)};
  }

  /// Whether the entity lies in the plane of the drawing; a fault if it does not. With the normal
  /// (0, 0, −1) it is drawn from behind. What is left of a zero is no slope.
  bool is_in_plane(bool& from_behind) {
    const Rational x = number_or(210, 0);
    const Rational y = number_or(220, 0);
    const Rational z = number_or(230, 1);
    const Rational slope = abs(z) / 1'000'000'000;
    if (sgn(z) == 0 || abs(x) > slope || abs(y) > slope) {
      fail(Message::DxfTilted, {std::string(entity_.kind())});
      return false;
    }
    from_behind = sgn(z) < 0;
    return true;
  }
  bool is_in_plane() { return is_in_plane(entity_.mirrored); }

  // --- shapes

  void read_line() {
    RationalPoint from = needed_point(10);
    DxfLine line{std::move(from), needed_point(11)};
    entity_.sloping = number_or(30, 0) != number_or(31, 0);
    entity_.shape = std::move(line);  // in coordinates of the world, whatever its extrusion
  }

  bool read_radius(Rational& radius) {
    radius = needed(40);
    if (sgn(radius) >= 0) return true;
    fail(Message::DxfBadRadius, {std::string(record_.find(40)->text())});
    return false;
  }

  void read_circle() {
    DxfArc circle;
    circle.centre = needed_point(10);
    if (is_in_plane() && read_radius(circle.radius)) entity_.shape = std::move(circle);
  }

  void read_arc() {
    DxfArc arc;
    arc.centre = needed_point(10);
    const Rational start = needed(50);
    const Rational end = needed(51);
    if (!is_in_plane() || !read_radius(arc.radius)) return;
    if (start == end) return fail(Message::DxfArcOfNoSweep, {});
    arc.start = direction_of(snapped(start)).unit;
    arc.end = direction_of(snapped(end)).unit;
    entity_.shape = std::move(arc);
  }

  void read_light_polyline() {
    DxfPolyline polyline;
    polyline.closed = (whole_or(70, 0) & kClosed) != 0;
    bool has_y = true;
    const auto end_vertex = [&] {
      if (!has_y) report_lack(polyline.places.back(), 20);
    };
    for (const DxfGroup& group : record_.groups) {
      if (group.code == 10) {
        end_vertex();
        has_y = false;
        polyline.vertices.push_back({{groups_.number(group), 0}, 0});
        polyline.places.push_back(group.value);
      } else if (group.code == 20 && !polyline.vertices.empty()) {
        has_y = true;
        polyline.vertices.back().at.y = groups_.number(group);
      } else if (group.code == 42 && !polyline.vertices.empty()) {
        polyline.vertices.back().bulge = groups_.number(group);
      }
    }
    end_vertex();
    if (is_in_plane()) entity_.shape = std::move(polyline);
  }

  void read_polyline() {
    const long flags = whole_or(70, 0);
    if ((flags & kMeshes) != 0) return;  // a surface: not read
    DxfPolyline polyline;
    polyline.closed = (flags & kClosed) != 0;
    Rational height;
    for (const DxfRecord& record : record_.vertices) {
      EntityReader vertex(record, groups_, bag_);
      if ((vertex.whole_or(70, 0) & kFrameVertex) != 0) continue;  // beside the curve, not on it
      RationalPoint at = vertex.needed_point(10);
      polyline.vertices.push_back({std::move(at), vertex.number_or(42, 0)});
      polyline.places.push_back(record.name);
      const Rational z = vertex.number_or(30, 0);
      if (polyline.vertices.size() == 1) height = z;
      entity_.sloping = entity_.sloping || z != height;
    }
    const bool is_of_world = (flags & kThreeDimensional) != 0;
    entity_.sloping = entity_.sloping && is_of_world;
    if (is_of_world || is_in_plane()) entity_.shape = std::move(polyline);
  }

  void read_ellipse() {
    DxfEllipse ellipse;
    ellipse.centre = needed_point(10);
    ellipse.major = needed_point(11);
    const Rational ratio = needed(40);
    const Rational full_turn = 2 * pi();
    const Rational start = number_or(41, 0);
    const Rational end = number_or(42, full_turn);
    bool from_behind = false;
    if (!is_in_plane(from_behind)) return;
    if (sgn(ratio) <= 0) {
      const DxfGroup* const said = record_.find(40);
      return fail(Message::DxfBadRatio, {said != nullptr ? std::string(said->text()) : "0"});
    }
    if (start == end) return fail(Message::DxfArcOfNoSweep, {});
    ellipse.minor =
        ratio * (from_behind ? turned_right(ellipse.major) : turned_left(ellipse.major));
    ellipse.start = direction_of(snapped(start * 180 / pi())).unit;
    ellipse.end = direction_of(snapped(end * 180 / pi())).unit;
    entity_.shape = std::move(ellipse);
  }

  void read_spline() {
    DxfSpline spline;
    std::vector<Rational> weights;
    bool has_fit_points = false;
    Rational height;
    for (const DxfGroup& group : record_.groups) {
      if (group.code == 10) spline.points.push_back({groups_.number(group), 0, 1});
      if (group.code == 20 && !spline.points.empty())
        spline.points.back().y = groups_.number(group);
      if (group.code == 30) {
        const Rational z = groups_.number(group);
        if (spline.points.size() <= 1) height = z;
        entity_.sloping = entity_.sloping || z != height;
      }
      if (group.code == 40) spline.knots.push_back(groups_.number(group));
      if (group.code == 41) weights.push_back(groups_.number(group));
      has_fit_points = has_fit_points || group.code == 11;
    }
    const long degree = whole_or(71, 3);
    if (spline.points.empty() && has_fit_points) return fail(Message::DxfSplineByFitPoints, {});
    constexpr long kMaxDegree = 25;
    const auto count = static_cast<long>(spline.points.size());
    if (degree < 1 || degree > kMaxDegree || count <= degree)
      return fail(Message::DxfBadDegree, {std::to_string(degree), std::to_string(count)});
    spline.degree = static_cast<std::size_t>(degree);
    if (spline.knots.size() != spline.points.size() + spline.degree + 1) {
      return fail(Message::DxfBadKnots, {std::to_string(spline.knots.size()),
                                         std::to_string(spline.points.size() + spline.degree + 1)});
    }
    if (!std::ranges::is_sorted(spline.knots)) return fail(Message::DxfKnotsDecrease, {});
    if (!weights.empty() && !weigh(spline, weights)) return;
    entity_.shape = std::move(spline);
  }

  bool weigh(DxfSpline& spline, const std::vector<Rational>& weights) {
    const bool all_positive = std::ranges::all_of(weights, [](const Rational& w) { return w > 0; });
    if (weights.size() != spline.points.size() || !all_positive) {
      fail(Message::DxfBadWeights, {});
      return false;
    }
    for (std::size_t i = 0; i < weights.size(); ++i) {
      BezierPoint& p = spline.points[i];
      p = {p.x * weights[i], p.y * weights[i], weights[i]};
    }
    return true;
  }

  void read_insert() {
    DxfInsert insert;
    const DxfGroup* const name = record_.find(2);
    if (name == nullptr) return report_lack(record_.name, 2);
    insert.block = std::string(name->text());
    insert.at = needed_point(10);
    insert.scale_x = number_or(41, 1);
    insert.scale_y = number_or(42, 1);
    insert.turn = direction_of(snapped(number_or(50, 0))).unit;
    insert.columns = std::max(whole_or(70, 1), 1L);
    insert.rows = std::max(whole_or(71, 1), 1L);
    insert.column_step = number_or(44, 0);
    insert.row_step = number_or(45, 0);
    if (!is_in_plane()) return;
    if (sgn(insert.scale_x) == 0 || sgn(insert.scale_y) == 0)
      return fail(Message::DxfBadScale, {insert.block});
    entity_.shape = std::move(insert);
  }

  const DxfRecord& record_;
  DxfGroups& groups_;
  DiagnosticBag& bag_;
  DxfEntity entity_;
};

}  // namespace

const DxfGroup* DxfRecord::find(int code) const {
  const auto found = std::find_if(groups.rbegin(), groups.rend(),
                                  [code](const DxfGroup& group) { return group.code == code; });
  return found == groups.rend() ? nullptr : &*found;
}

const Rational& dxf_angle_rounding() {
  static const Rational kRounding(1, 10'000'000'000);
  return kRounding;
}

DxfEntity dxf_entity(const DxfRecord& record, DxfGroups& groups, DiagnosticBag& bag) {
  return EntityReader(record, groups, bag).run();
}

}  // namespace dgt
