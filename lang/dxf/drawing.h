// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kernel/chain.h"
#include "kernel/curve_fit.h"
#include "lang/text/diagnostic.h"

/// A DXF drawing as it stands in its file: entities in the coordinates of their block, numbers
/// exact, angles as rational directions.
namespace dgt {

struct DxfLine {
  RationalPoint from;
  RationalPoint to;
};

/// Counter-clockwise from one direction to the other; the same twice is once round.
struct DxfArc {
  RationalPoint centre;
  Rational radius;  ///< positive
  UnitVector start;
  UnitVector end;
};

struct DxfPolyline {
  std::vector<BulgeVertex> vertices;
  std::vector<Range> places;  ///< of the vertices
  bool closed = false;
};

/// centre + cos t · major + sin t · minor, t from the one direction to the other.
struct DxfEllipse {
  RationalPoint centre;
  Vector major;
  Vector minor;
  UnitVector start;
  UnitVector end;
};

struct DxfSpline {
  std::size_t degree = 3;
  std::vector<Rational> knots;      ///< points.size() + degree + 1 of them, not decreasing
  std::vector<BezierPoint> points;  ///< homogeneous
};

/// A block put in place: turned, scaled, repeated.
struct DxfInsert {
  std::string block;
  RationalPoint at;
  Rational scale_x = 1;
  Rational scale_y = 1;
  UnitVector turn;
  long columns = 1;
  long rows = 1;
  Rational column_step;
  Rational row_step;
};

/// What is not read: texts and dimensions, or a kind that may be part of the part.
struct DxfOther {
  bool annotation = false;
};

/// What is read and cannot be cut; a fault where its layer is asked for.
struct DxfFaulty {
  Message message;
  std::vector<std::string> arguments;
};

struct DxfEntity {
  std::variant<DxfOther, DxfFaulty, DxfLine, DxfArc, DxfPolyline, DxfEllipse, DxfSpline, DxfInsert>
      shape;
  Range place;  ///< its name in the file
  std::string layer;
  bool mirrored = false;  ///< drawn from behind (extrusion 0, 0, −1): x is −x
  bool sloping = false;   ///< its Z changes
  bool hidden = false;    ///< invisible, or on a sheet of paper

  [[nodiscard]] std::string_view kind() const { return place.text(); }
};

struct DxfLayer {
  bool frozen = false;
  bool off = false;
};

struct DxfBlock {
  RationalPoint base;
  std::vector<DxfEntity> entities;
};

/// Names of layers and blocks as they are compared: ASCII letters in either case are one.
[[nodiscard]] std::string dxf_key(std::string_view name);

struct DxfDrawing {
  std::map<std::string, DxfLayer> layers;  ///< by dxf_key()
  std::map<std::string, DxfBlock> blocks;  ///< by dxf_key()
  std::vector<DxfEntity> entities;
  long units = 0;  ///< $INSUNITS
  Range units_place;
  bool is_of_dgt = false;  ///< what `dgt plot` drew
};

/// Reads a file. With an error in the bag the drawing is not whole.
[[nodiscard]] DxfDrawing read_dxf_drawing(const SourceFile& file, DiagnosticBag& bag);

}  // namespace dgt
