// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/contour.h"
#include "lang/dgt/contour_turn.h"
#include "lang/dgt/evaluation.h"

namespace dgt::language {

/// Where an item of the kernel's contour came from: what messages about it say.
struct ItemOrigin {
  Range range;
  ElementName name;  ///< number < 0: no element with a number
  ExpansionPtr expansion;

  [[nodiscard]] std::string text() const {
    return name.number < 0 ? std::string(range.text()) : to_text(name);
  }
};

/// A contour while its lines come in.
struct OpenContour {
  unsigned id = 0;
  Range range;  ///< the word K
  std::vector<ContourItem> items;
  std::vector<ItemOrigin> origins;  ///< one for each item
  bool broken = false;              ///< a fault has been reported; nothing is built
  bool has_beginning = true;        ///< a K began it

  /// The first item that the word of this one made: a word in a loop makes several.
  [[nodiscard]] std::size_t first_of_word(std::size_t item) const {
    std::size_t first = 0;
    while (origins[first].range != origins[item].range) ++first;
    return first;
  }
};

/// Tells the faults and notices of a built contour in the user's words. `turn`: what would cure it.
void report(const BuiltContour& built, const OpenContour& contour, const std::optional<Turn>& turn,
            DiagnosticBag& bag);

/// Turns contour items and word lines into the tool path.
class ContourWriter {
 public:
  explicit ContourWriter(Evaluation& evaluation) : evaluation_(evaluation) {
    options_.offset_side = evaluation.options.offset_side;
    options_.join_tolerance = evaluation.options.join_tolerance;
    options_.gouge = evaluation.options.gouge;
    options_.corner = evaluation.options.corner;
    options_.corner_limit = evaluation.options.corner_limit;
  }

  [[nodiscard]] bool is_open() const { return open_.has_value(); }
  [[nodiscard]] OffsetSide offset_side() const { return options_.offset_side; }
  /// Of the next contours.
  void set_offset_side(OffsetSide side) { options_.offset_side = side; }

  /// Begins a contour after ending the one before.
  void start(unsigned id, Range range);
  /// A contour whose beginning is missing: its lines are read, and nothing is built.
  void start_broken(Range range);
  void take(const std::vector<Item>& items);
  /// Whether the open contour was begun by a K.
  [[nodiscard]] bool has_beginning() const { return open_->has_beginning; }
  void mark_broken() { open_->broken = true; }
  /// Builds the open contour, if there is one.
  void end();

  /// Words that act at once: G54, G0, F, S, T, M. Precondition: no contour is open.
  /// `broken`: a fault in the line has been told, so what a G lacks may have been its victim.
  void act(const std::vector<Item>& words, bool broken);
  /// Whether every item is a word that may stand outside a contour.
  [[nodiscard]] static bool are_words(const std::vector<Item>& items);

  /// More moves than the bounds allow; the evaluation is to stop.
  [[nodiscard]] bool is_over_limit() const { return over_limit_; }
  /// Whether the path has all moves: a check of a long program keeps none.
  [[nodiscard]] bool keeps_moves() const { return keeps_moves_; }
  /// The finished path, the files of its places included.
  [[nodiscard]] Toolpath finish();

 private:
  /// The coordinate system that items are given in.
  struct CurrentFrame {
    std::shared_ptr<const FrameDefinition> base;  ///< null: the world
    Rational angle;                               ///< of A
    Frame frame;
    bool is_world = true;

    void update();
  };

  void take(const std::vector<Item>& items, std::size_t& i);
  void take_element(const Item& item);
  void take_point(const Item& item);
  void take_axis(const Item& item);
  void take_number(const Item& item);
  void take_frame(const Item& item);
  void take_angle(const Item& item);
  void take_selector(const Item& item);
  void take_g(const std::vector<Item>& items, std::size_t& i);

  template <class What>
  void add(What what, const Item& item, const ElementName& name = {0, -1, false});
  /// The G word's number, 0 or 54; and the point of a G54, which is the item behind it.
  [[nodiscard]] std::optional<int> g_code(const Item& item);
  [[nodiscard]] std::optional<RationalPoint> point_behind(const std::vector<Item>& items,
                                                          std::size_t& i);
  /// F, S, T, M: checked; the last two and S as they go into the path.
  [[nodiscard]] std::optional<Rational> word_value(const Item& item);
  [[nodiscard]] static std::string code_of(const Item& item, const Rational& value);

  void act_on_g(const std::vector<Item>& items, std::size_t& i);
  void travel_to(const RationalPoint& to, Role role, const Item& item);
  Move& push_stop(MoveKind kind, const Item& item);

  [[nodiscard]] SourcePlace place_of(const Item& item);
  void check_limit(std::size_t moves, const Range& range);
  void count_moves(std::size_t moves);

  Evaluation& evaluation_;
  ContourOptions options_;
  Toolpath path_;
  ToolState state_;
  std::optional<OpenContour> open_;
  CurrentFrame frame_;
  std::vector<const SourceFile*> files_;  // of path_.files
  std::uint64_t made_ = 0;                // moves so far, kept or not
  bool over_limit_ = false;
  bool keeps_moves_ = true;
};

}  // namespace dgt::language
