// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "kernel/toolpath.h"

namespace dgt {

/// A JSON text as it grows. It is written straight out: a path of 10⁵ moves as a tree of JSON
/// values would take twenty times its memory.
class MoveJson {
 public:
  /// `files`: what the places of moves count into.
  explicit MoveJson(const std::vector<std::string>& files = {});

  std::string out;

  /// In shortest form, with a point or an exponent, so that readers that tell the two apart see no
  /// whole numbers.
  void number(double value);
  /// `[x, y]`
  void point(double x, double y);
  /// `[MOVE, …]` (apps/README.md), one a line.
  void moves(std::span<const Move> list);

 private:
  void point(const char* key, const Point& p);
  void value(const char* key, const RationalPtr& v);
  void move(const Move& m);
  void arc(const Move& m);
  void source(const SourcePlace& place);

  std::vector<std::string> quoted_files_;
};

}  // namespace dgt
