// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/names.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "kernel/angle.h"
#include "lang/dgt/dump.h"
#include "lang/dgt/lexer.h"

namespace dgt {
namespace {

using language::ElementEntry;
using language::ElementKind;
using language::ElementTable;

/// The words of a program's files by their places, as the canonical layout spells them.
class WordsByPlace {
 public:
  explicit WordsByPlace(const Compilation& made) {
    read(*made.file);
    for (const auto& file : made.result.files) read(*file);
  }
  [[nodiscard]] std::string at(const std::string& file, const SourcePlace& place) const {
    const auto found = words_.find({file, place.line, place.column});
    return found == words_.end() ? "" : found->second;
  }

 private:
  void read(const SourceFile& file) {
    DiagnosticBag told_already;
    language::Lexer lexer(file, told_already);
    for (language::Lexer::Line line; lexer.next_line(line);) {
      for (const language::Word& word : line.words) {
        words_.insert({{file.name(), word.line, word.column}, language::to_text(word)});
      }
    }
  }
  std::map<std::tuple<std::string, std::uint32_t, std::uint32_t>, std::string> words_;
};

std::string without_sign(std::string name) {
  std::erase(name, '-');
  return name;
}

/// What contours run along that the table does not hold: moved elements, and blends.
class ContourNames {
 public:
  explicit ContourNames(const Compilation& made)
      : path_(*made.result.path), table_(made.result.elements), words_(made) {
    for (const Contour& contour : path_.contours) {
      for (const Move& move : programmed_moves(path_, contour)) add(move);
    }
  }
  [[nodiscard]] const std::vector<NamedShape>& shapes() const { return shapes_; }
  /// Whether an element is cut only where A or O have moved it to.
  [[nodiscard]] bool is_elsewhere(const std::string& name) const {
    return moved_.contains(name) && !in_place_.contains(name);
  }

 private:
  void add(const Move& move) {
    const std::string word = words_.at(path_.files.at(move.source.file), move.source);
    if (word.empty()) return;
    if (word.front() == 'P' && move.travels()) {
      add_point(word, move.to);
    } else if (!move.carrier.base) {
      return;
    } else if (word.front() != 'L' && word.front() != 'C') {
      const Place middle = middle_of(move);
      shapes_.push_back({word, NamedSpot{middle.x, middle.y, false}});
    } else if (is_defined(*move.carrier.base)) {
      in_place_.insert(without_sign(word));
    } else {
      moved_.insert(without_sign(word));
      add_once(word, *move.carrier.base);
    }
  }

  void add_point(const std::string& word, const Point& at) {
    const auto is_it = [&](const ElementEntry& entry) {
      return entry.point && Point(entry.point->exact) == at;
    };
    if (std::ranges::any_of(table_.all(ElementKind::Point), is_it)) {
      in_place_.insert(word);
    } else if (moved_.insert(word).second) {
      shapes_.push_back({word, NamedSpot{at.x(), at.y(), true}});
    }
  }

  struct Place {
    double x, y;
  };
  /// Near enough to the middle of a move for a name to belong to it.
  static Place middle_of(const Move& move) {
    return {(move.from.x() + move.to.x()) / 2, (move.from.y() + move.to.y()) / 2};
  }

  [[nodiscard]] bool is_defined(const Element& element) const {
    const auto is_it = [&](const ElementEntry& entry) {
      return entry.element && (*entry.element == element || reversed(*entry.element) == element);
    };
    const auto holds = [&](ElementKind kind) {
      return std::ranges::any_of(table_.all(kind), is_it);
    };
    return holds(ElementKind::Line) || holds(ElementKind::Circle);
  }

  void add_once(const std::string& word, const Element& element) {
    const bool known = std::ranges::find(drawn_, element) != drawn_.end();
    if (known) return;
    drawn_.push_back(element);
    std::visit([&](const auto& shape) { shapes_.push_back({word, shape}); }, element);
  }

  const Toolpath& path_;
  const ElementTable& table_;
  WordsByPlace words_;
  std::vector<NamedShape> shapes_;
  std::vector<Element> drawn_;
  std::set<std::string> moved_, in_place_;
};

void add_entry(std::vector<NamedShape>& shapes, std::string name, const ElementEntry& entry) {
  if (entry.point) {
    const Point at(entry.point->exact);
    shapes.push_back({std::move(name), NamedSpot{at.x(), at.y(), true}});
  } else if (entry.frame) {
    const RationalPoint& origin = entry.frame->origin;
    const UnitVector along = direction_of(entry.frame->degrees).unit;
    shapes.push_back(
        {std::move(name), NamedAxes{nearest_double(origin.x), nearest_double(origin.y),
                                    nearest_double(along.x()), nearest_double(along.y())}});
  } else if (entry.element) {
    std::visit(
        [&](const auto& shape) {
          shapes.push_back({std::move(name), shape});
        },
        *entry.element);
  }
}

}  // namespace

std::vector<NamedShape> names_of(const Compilation& made) {
  if (!made.result.path) return {};
  const ContourNames contours(made);
  std::vector<NamedShape> shapes;
  // Points first: they have the fewest places to stand.
  for (const ElementKind kind :
       {ElementKind::Point, ElementKind::Frame, ElementKind::Circle, ElementKind::Line}) {
    const auto& entries = made.result.elements.all(kind);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (entries[i].state != ElementEntry::State::Defined) continue;
      std::string name = static_cast<char>(kind) + std::to_string(i);
      if (!contours.is_elsewhere(name)) add_entry(shapes, std::move(name), entries[i]);
    }
  }
  shapes.insert(shapes.end(), contours.shapes().begin(), contours.shapes().end());
  return shapes;
}

}  // namespace dgt
