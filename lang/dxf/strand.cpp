// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dxf/strand.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "lang/dxf/curves.h"

namespace dgt {
namespace {

/// Layers that never show on paper, whatever they are told.
constexpr std::string_view kDefinitionPoints = "DEFPOINTS";
/// What `dgt plot` draws the cuts on.
constexpr std::string_view kOwnCuts = "EQUIDISTANT";

/// Millimetres in a unit of $INSUNITS; 0: no length that parts are drawn in.
Rational millimetres_of(long units) {
  switch (units) {
    case 1:  // inch
      return {127, 5};
    case 2:  // foot
      return {1524, 5};
    case 4:
      return 1;
    case 5:  // cm
      return 10;
    case 6:  // m
      return 1000;
    case 9:  // mil
      return {127, 5000};
    case 13:  // micrometre
      return {1, 1000};
    case 14:  // dm
      return 100;
    default:
      return 0;
  }
}

DxfPiece piece_of(const ChainEdge& edge, const Range& place) {
  DxfPiece piece{edge.from, edge.to, std::nullopt, place};
  if (!edge.is_line()) piece.circle = Circle(edge.centre(), edge.radius);
  return piece;
}

/// The part of an exact length that a stand-in may be off by.
constexpr int kLengthExponent = -120;

Rational length_of(const Vector& v) {
  const Rational square = squared_length(v);
  if (const auto root = exact_sqrt(square)) return *root;
  return sqrt_within(square, kLengthExponent);
}

struct LeftOut {
  std::size_t count = 0;
  Range first;
};
using LeftOutList = std::map<std::string, LeftOut>;

class Expansion {
 public:
  Expansion(const DxfDrawing& drawing, const SourceFile& file, const DxfOptions& options,
            DiagnosticBag& bag)
      : drawing_(drawing), options_(options), bag_(bag), begin_{&file, 0, 0} {
    for (const std::string& layer : options.layers) asked_.insert(dxf_key(layer));
  }

  std::vector<DxfStrand> run() {
    if (asked_.empty() && drawing_.is_of_dgt) {
      asked_.insert(std::string(kOwnCuts));
      report(Message::DxfOwnDrawing, begin_);
    }
    const Rational unit = unit_in_millimetres();
    const Placement whole{{unit, 0}, {0, unit}, {}};
    expand(drawing_.entities, whole, {"", false});
    tell_left_out();
    if (strands_.empty() && !bag_.has_errors()) report(Message::DxfNothing, begin_);
    return std::move(strands_);
  }

 private:
  /// What a block takes from where it is put: the layer of its entities on layer 0.
  struct Context {
    std::string layer;
    bool inside = false;
  };

  void report(Message message, const Range& place, std::vector<std::string> arguments = {}) {
    bag_.add({message, place, std::move(arguments)});
  }

  Rational unit_in_millimetres() {
    if (options_.unit == DxfUnit::Millimetre) return 1;
    if (options_.unit == DxfUnit::Inch) return {127, 5};
    const Rational unit = millimetres_of(drawing_.units);
    if (sgn(unit) != 0) return unit;
    const bool is_said = drawing_.units_place.file != nullptr;
    report(Message::DxfUnitUnknown, is_said ? drawing_.units_place : begin_);
    return 1;
  }

  // --- layers

  enum class Visibility : std::uint8_t { Read, Frozen, Off, NotAsked };

  [[nodiscard]] Visibility visibility(const std::string& layer) const {
    if (!asked_.empty()) return asked_.contains(layer) ? Visibility::Read : Visibility::NotAsked;
    if (layer == kDefinitionPoints) return Visibility::NotAsked;
    const auto found = drawing_.layers.find(layer);
    if (found == drawing_.layers.end()) return Visibility::Read;
    if (found->second.frozen) return Visibility::Frozen;
    return found->second.off ? Visibility::Off : Visibility::Read;
  }

  static void count(LeftOutList& list, const std::string& name, const Range& place) {
    LeftOut& entry = list[name];
    if (entry.count++ == 0) entry.first = place;
  }

  /// Whether the entity, on that layer, is read; counted where it is not.
  bool is_read(const DxfEntity& entity, const std::string& layer) {
    if (entity.hidden) {
      count(hidden_, "", entity.place);
      return false;
    }
    const bool is_insert = std::holds_alternative<DxfInsert>(entity.shape);
    const Visibility how = visibility(layer);
    if (how == Visibility::Read) {
      found_.insert(layer);
      return true;
    }
    // Blocks have layers of their own; a frozen layer takes all that is put on it along.
    if (is_insert) return how != Visibility::Frozen;
    if (asked_.empty()) count(layers_, layer, entity.place);
    seen_.insert(layer);
    return false;
  }

  // --- entities

  void expand(const std::vector<DxfEntity>& entities, const Placement& placement,
              const Context& context) {
    for (const DxfEntity& entity : entities) {
      if (++work_ > options_.max_moves) return tell_too_much(entity.place);
      const std::string own = dxf_key(entity.layer);
      const std::string layer = context.inside && own == "0" ? context.layer : own;
      if (!is_read(entity, layer)) continue;
      if (entity.sloping) count(sloping_, "", entity.place);
      constexpr int kFlip = -1;
      const Placement from_behind{{kFlip, 0}, {0, 1}, {}};
      const Placement at = entity.mirrored ? placement.after(from_behind) : placement;
      std::visit([&](const auto& shape) { add(shape, entity, at, layer); }, entity.shape);
      if (stopped_) return;
    }
  }

  void tell_too_much(const Range& place) {
    if (!std::exchange(stopped_, true))
      report(Message::DxfTooMuch, place, {std::to_string(options_.max_moves)});
  }

  void add(const DxfOther& other, const DxfEntity& entity, const Placement&, const std::string&) {
    count(other.annotation ? annotations_ : unread_, std::string(entity.kind()), entity.place);
  }

  void add(const DxfFaulty& fault, const DxfEntity& entity, const Placement&, const std::string&) {
    report(fault.message, entity.place, fault.arguments);
  }

  void add(const DxfLine& line, const DxfEntity& entity, const Placement& at, const std::string&) {
    DxfStrand strand;
    strand.pieces.push_back({at.of(line.from), at.of(line.to), std::nullopt, entity.place});
    keep(std::move(strand), entity);
  }

  void add(const DxfArc& arc, const DxfEntity& entity, const Placement& at, const std::string&) {
    if (sgn(arc.radius) == 0) return count(points_, "", entity.place);
    add_ellipse({at.of(arc.centre), arc.radius * at.x_axis, arc.radius * at.y_axis}, arc.start,
                arc.end, entity);
  }

  void add(const DxfEllipse& ellipse, const DxfEntity& entity, const Placement& at,
           const std::string&) {
    if (sgn(squared_length(ellipse.major)) == 0) return count(points_, "", entity.place);
    add_ellipse({at.of(ellipse.centre), at.turned(ellipse.major), at.turned(ellipse.minor)},
                ellipse.start, ellipse.end, entity);
  }

  void add_ellipse(const PlacedEllipse& ellipse, const UnitVector& start, const UnitVector& end,
                   const DxfEntity& entity) {
    DxfStrand strand;
    strand.has_given_ends = false;
    strand.closed = start == end;
    if (!is_circle(ellipse)) return add_curves(curves_of(ellipse, start, end), strand, entity);
    strand.directed = false;
    const Rational radius = length_of(ellipse.major);
    if (sgn(radius) == 0) return count(points_, "", entity.place);
    const auto direction = [&](const UnitVector& t) {
      return direction_of(t.x() * ellipse.major + t.y() * ellipse.minor).unit;
    };
    const auto on_circle = [&](const UnitVector& t) {
      return ellipse.centre + radius * direction(t).vector();
    };
    const bool turned_over = sgn(cross(ellipse.major, ellipse.minor)) < 0;
    strand.pieces.push_back({on_circle(turned_over ? end : start),
                             on_circle(turned_over ? start : end), Circle(ellipse.centre, radius),
                             entity.place});
    keep(std::move(strand), entity);
  }

  void add(const DxfPolyline& polyline, const DxfEntity& entity, const Placement& at,
           const std::string&) {
    if (std::ranges::all_of(polyline.vertices,
                            [](const BulgeVertex& v) { return sgn(v.bulge) == 0; }) ||
        is_circle({{}, at.x_axis, at.y_axis}))
      return add_polyline(polyline, entity, at);
    // Seen askew its arcs are those of ellipses.
    const std::size_t n = polyline.vertices.size();
    DxfStrand whole;
    whole.closed = polyline.closed;
    for (std::size_t i = 0; i + (polyline.closed ? 0 : 1) < n; ++i) {
      const BulgeVertex& from = polyline.vertices[i];
      const BulgeVertex& to = polyline.vertices[(i + 1) % n];
      const auto chain = chain_of({{from.at, from.bulge}, {to.at, 0}}, false);
      if (!chain) continue;
      for (const ChainEdge& edge : chain->edges) append_placed(whole, edge, at, entity);
    }
    keep(std::move(whole), entity);
  }

  void add_polyline(const DxfPolyline& polyline, const DxfEntity& entity, const Placement& at) {
    const bool flips = sgn(cross(at.x_axis, at.y_axis)) < 0;
    std::vector<BulgeVertex> vertices;
    for (const BulgeVertex& v : polyline.vertices)
      vertices.push_back({at.of(v.at), flips ? Rational(-v.bulge) : v.bulge});
    const auto chain = chain_of(vertices, polyline.closed);
    if (!chain) return count(points_, "", entity.place);
    DxfStrand strand;
    strand.closed = polyline.closed;
    // Vertices that coincide with the one before begin no edge, great arcs are two.
    const auto behind = [&](std::size_t vertex) {
      std::size_t next = vertex + 1;
      while (next < vertices.size() && vertices[next].at == vertices[vertex].at) ++next;
      return next;
    };
    std::size_t vertex = 0;
    std::size_t next = behind(vertex);
    for (const ChainEdge& edge : chain->edges) {
      if (next < vertices.size() && edge.from == vertices[next].at) {
        vertex = next;
        next = behind(vertex);
      }
      strand.pieces.push_back(piece_of(edge, polyline.places[vertex]));
    }
    keep(std::move(strand), entity);
  }

  void append_placed(DxfStrand& strand, const ChainEdge& edge, const Placement& at,
                     const DxfEntity& entity) {
    if (edge.is_line()) {
      strand.pieces.push_back({at.of(edge.from), at.of(edge.to), std::nullopt, entity.place});
      return;
    }
    // Its ends seen from its centre are radius · normal, which points inward for a clockwise arc.
    const bool ccw = sgn(edge.radius) > 0;
    const UnitVector from = ccw ? -edge.start : edge.start;
    const UnitVector to = ccw ? -edge.end : edge.end;
    const Rational radius = abs(edge.radius);
    const PlacedEllipse ellipse{at.of(edge.centre()), radius * at.x_axis, radius * at.y_axis};
    std::vector<RationalCurve> curves = curves_of(ellipse, ccw ? from : to, ccw ? to : from);
    const auto edges = arcs_along(curves, options_.curve_tolerance, room());
    if (!edges) return tell_too_much(entity.place);
    DxfStrand arc;
    for (const ChainEdge& fitted : *edges) arc.pieces.push_back(piece_of(fitted, entity.place));
    if (!ccw) arc = reversed(arc);
    // Ends of fitted curves are on a grid; the vertices are what the drawing says.
    if (!arc.pieces.empty()) {
      arc.pieces.front().from = at.of(edge.from);
      arc.pieces.back().to = at.of(edge.to);
    }
    std::ranges::move(arc.pieces, std::back_inserter(strand.pieces));
  }

  void add(const DxfSpline& spline, const DxfEntity& entity, const Placement& at,
           const std::string&) {
    std::vector<RationalCurve> curves = curves_of(spline, at);
    // A knot of full multiplicity parts a spline.
    std::vector<RationalCurve> run;
    const auto flush = [&] {
      DxfStrand strand;
      if (!run.empty()) add_curves(std::exchange(run, {}), strand, entity);
    };
    for (RationalCurve& curve : curves) {
      if (!run.empty() && !meet(run.back().back(), curve.front())) flush();
      run.push_back(std::move(curve));
    }
    flush();
  }
  static bool meet(const BezierPoint& a, const BezierPoint& b) {
    return a.x / a.w == b.x / b.w && a.y / a.w == b.y / b.w;
  }

  void add_curves(const std::vector<RationalCurve>& curves, DxfStrand strand,
                  const DxfEntity& entity) {
    const auto edges = arcs_along(curves, options_.curve_tolerance, room());
    if (!edges) return tell_too_much(entity.place);
    for (const ChainEdge& edge : *edges) strand.pieces.push_back(piece_of(edge, entity.place));
    if (strand.pieces.empty()) return count(points_, "", entity.place);
    strand.closed = strand.closed || strand.pieces.front().from == strand.pieces.back().to;
    keep(std::move(strand), entity);
  }

  [[nodiscard]] std::size_t room() const { return options_.max_moves - work_; }

  /// Without pieces of no length.
  void keep(DxfStrand strand, const DxfEntity& entity) {
    std::erase_if(strand.pieces,
                  [](const DxfPiece& piece) { return piece.from == piece.to && !piece.circle; });
    if (strand.pieces.empty()) return count(points_, "", entity.place);
    work_ += strand.pieces.size();
    if (work_ > options_.max_moves) return tell_too_much(entity.place);
    strands_.push_back(std::move(strand));
  }

  // --- blocks

  void add(const DxfInsert& insert, const DxfEntity& entity, const Placement& at,
           const std::string& layer) {
    const std::string key = dxf_key(insert.block);
    const auto found = drawing_.blocks.find(key);
    if (found == drawing_.blocks.end())
      return report(Message::DxfUnknownBlock, entity.place, {insert.block});
    if (std::ranges::find(open_, key) != open_.end())
      return report(Message::DxfRecursion, entity.place, {insert.block});
    open_.push_back(key);
    const UnitVector across = turned_left(insert.turn);
    for (long row = 0; row < insert.rows && !stopped_; ++row) {
      for (long column = 0; column < insert.columns && !stopped_; ++column) {
        if (++work_ > options_.max_moves) tell_too_much(entity.place);
        const Vector step = Rational(column) * insert.column_step * insert.turn.vector() +
                            Rational(row) * insert.row_step * across.vector();
        Placement placed{insert.scale_x * insert.turn.vector(), insert.scale_y * across.vector(),
                         insert.at + step};
        placed.origin = placed.origin - placed.turned(found->second.base);
        expand(found->second.entities, at.after(placed), {layer, true});
      }
    }
    open_.pop_back();
  }

  // --- what is left out

  static std::string listed(const LeftOutList& list) {
    std::string text;
    for (const auto& [name, left] : list) {
      if (!text.empty()) text += ", ";
      text += name + " " + std::to_string(left.count);
    }
    return text;
  }
  void tell(Message message, const LeftOutList& list, std::vector<std::string> arguments) {
    if (list.empty()) return;
    const auto first = std::ranges::min_element(
        list, {}, [](const auto& entry) { return entry.second.first.begin; });
    report(message, first->second.first, std::move(arguments));
  }
  void tell_count(Message message, const LeftOutList& list) {
    if (!list.empty()) tell(message, list, {std::to_string(list.begin()->second.count)});
  }

  void tell_left_out() {
    for (const std::string& layer : asked_) {
      if (!found_.contains(layer)) report(Message::DxfNoSuchLayer, begin_, {layer, known_layers()});
    }
    tell(Message::DxfLayersLeftOut, layers_, {listed(layers_)});
    tell(Message::DxfAnnotations, annotations_, {listed(annotations_)});
    tell(Message::DxfUnread, unread_, {listed(unread_)});
    tell_count(Message::DxfHidden, hidden_);
    tell_count(Message::DxfSloping, sloping_);
    tell_count(Message::DxfPoints, points_);
  }

  [[nodiscard]] std::string known_layers() const {
    std::set<std::string> all = seen_;
    all.insert(found_.begin(), found_.end());
    std::string text;
    for (const std::string& layer : all) text += (text.empty() ? "" : ", ") + layer;
    return text.empty() ? "-" : text;
  }

  const DxfDrawing& drawing_;
  const DxfOptions& options_;
  DiagnosticBag& bag_;
  Range begin_;  ///< the beginning of the file
  std::set<std::string> asked_;
  std::set<std::string> found_;  ///< layers that were read
  std::set<std::string> seen_;   ///< layers that were not
  LeftOutList layers_, annotations_, unread_, hidden_, sloping_, points_;
  std::vector<std::string> open_;  ///< blocks that are being put in place
  std::uint64_t work_ = 0;
  bool stopped_ = false;
  std::vector<DxfStrand> strands_;
};

}  // namespace

DxfPiece reversed(const DxfPiece& piece) {
  DxfPiece back{piece.to, piece.from, piece.circle, piece.place};
  if (back.circle) back.circle = back.circle->reversed();
  return back;
}

DxfStrand reversed(const DxfStrand& strand) {
  DxfStrand back = strand;
  back.pieces.clear();
  for (auto piece = strand.pieces.rbegin(); piece != strand.pieces.rend(); ++piece)
    back.pieces.push_back(reversed(*piece));
  return back;
}

std::vector<DxfStrand> strands_of(const DxfDrawing& drawing, const SourceFile& file,
                                  const DxfOptions& options, DiagnosticBag& bag) {
  return Expansion(drawing, file, options, bag).run();
}

}  // namespace dgt
