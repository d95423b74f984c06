// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/contour_writer.h"

#include <algorithm>

#include "kernel/check.h"
#include "lang/dgt/dump.h"

namespace dgt::language {
namespace {

bool is_word(char letter) {
  return std::string_view("GFSTM").find(letter) != std::string_view::npos;
}

}  // namespace

void ContourWriter::CurrentFrame::update() {
  is_world = !base && sgn(angle) == 0;
  if (is_world) return;
  frame.origin = base ? base->origin : RationalPoint{0, 0};
  frame.rotation = direction_of(base ? Rational(base->degrees + angle) : angle).unit;
}

// --- a contour from its beginning to its end
// ------------------------------------------------------

void ContourWriter::start(unsigned id, Range range) {
  end();
  open_.emplace();
  open_->id = id;
  open_->range = range;
  frame_ = {};
}

void ContourWriter::start_broken(Range range) {
  start(0, range);
  open_->broken = true;
  open_->has_beginning = false;
}

void ContourWriter::end() {
  if (!open_) return;
  const OpenContour contour = *std::exchange(open_, std::nullopt);
  if (contour.broken || contour.items.empty()) return;
  const ToolState before = state_;
  BuiltContour built = build_contour(contour.items, state_, options_);
  // Nobody reads what is past the end of the list.
  const bool is_told = evaluation_.bag.error_count() <= DiagnosticBag::kMaxKept;
  const auto turn = is_told ? find_turn(contour, built, before, options_) : std::optional<Turn>();
  report(built, contour, turn, evaluation_.bag);
  if (!built.faults.empty() || built.moves.empty()) return;
  count_moves(built.moves.size());
  check_limit(made_, contour.range);
  if (!keeps_moves_) return;
  Contour& made = path_.contours.emplace_back();
  made.id = contour.id;
  made.offset = built.offset;
  made.side = built.side;
  made.closed = built.closed;
  made.first = path_.moves.size();
  path_.moves.insert(path_.moves.end(), std::make_move_iterator(built.moves.begin()),
                     std::make_move_iterator(built.moves.end()));
  made.last = path_.moves.size();
  made.programmed = std::move(built.programmed);
}

// --- items
// ----------------------------------------------------------------------------------------

void ContourWriter::take(const std::vector<Item>& items) {
  for (std::size_t i = 0; i < items.size(); ++i) take(items, i);
  check_limit(open_->items.size(), open_->range);
}

void ContourWriter::take(const std::vector<Item>& items, std::size_t& i) {
  const Item& item = items[i];
  switch (item.letter) {
    case 'L':
    case 'C':
      return take_element(item);
    case 'P':
      return take_point(item);
    case 'X':
    case 'Y':
      return take_axis(item);
    case 'O':
      return take_frame(item);
    case 'A':
      return take_angle(item);
    case 'I':
      return take_selector(item);
    case 'G':
      return take_g(items, i);
    default:
      return take_number(item);
  }
}

template <class What>
void ContourWriter::add(What what, const Item& item, const ElementName& name) {
  open_->items.push_back({std::move(what), place_of(item)});
  open_->origins.push_back({item.range, name, evaluation_.expansion.current()});
}

void ContourWriter::take_element(const Item& item) {
  const std::optional<ElementName> name = evaluation_.name_of(item);
  ElementPtr element = name ? evaluation_.element(item, *name) : nullptr;
  if (!element) return mark_broken();
  if (!frame_.is_world) element = ElementPtr(placed(*element, frame_.frame));
  add(AlongItem{std::move(element)}, item, *name);
}

void ContourWriter::take_point(const Item& item) {
  const std::optional<KnownPoint> point = evaluation_.point(item);
  if (!point) return mark_broken();
  const ExactPoint at = frame_.is_world ? point->exact : placed(point->exact, frame_.frame);
  if (at.is_rational()) {
    add(PointItem{Point(RationalPoint{at.x.a, at.y.a})}, item);
  } else {
    add(PointItem{Point(at)}, item);
  }
}

void ContourWriter::take_axis(const Item& item) {
  const std::optional<Rational> value = evaluation_.value(item);
  if (!value) return mark_broken();
  Element line = item.letter == 'X' ? vertical_line(*value) : horizontal_line(*value);
  if (!frame_.is_world) line = placed(line, frame_.frame);
  add(AxisItem{ElementPtr(std::move(line))}, item);
}

void ContourWriter::take_frame(const Item& item) {
  const std::optional<ElementName> name = evaluation_.name_of(item);
  if (!name) return mark_broken();
  frame_ = {};
  if (name->number == 0) return;
  const ElementEntry* const entry = evaluation_.look_up(item, *name);
  if (entry == nullptr) return mark_broken();
  frame_.base = entry->frame;
  frame_.update();
}

void ContourWriter::take_angle(const Item& item) {
  const std::optional<Rational> angle = evaluation_.value(item);
  if (!angle) return mark_broken();
  frame_.angle = *angle;
  frame_.update();
}

void ContourWriter::take_selector(const Item& item) {
  const std::optional<Selector> selector = evaluation_.selector(item);
  if (!selector) return mark_broken();
  add(SelectItem{*selector}, item);
}

void ContourWriter::take_number(const Item& item) {
  if (item.number.is_absent()) return add(BevelItem{std::nullopt}, item);
  const std::optional<Rational> value =
      is_word(item.letter) ? word_value(item) : evaluation_.value(item);
  if (!value) return mark_broken();
  switch (item.letter) {
    case 'R':
      return add(FilletItem{*value}, item);
    case 'V':
      return add(BevelItem{*value}, item);
    case 'D':
      return add(TravelItem{*value}, item);
    case 'Z':
      return add(HeightItem{*value}, item);
    case 'W':
    case 'U':
      return add(OffsetItem{*value, item.letter == 'W'}, item);
    case 'F':
      return add(FeedItem{*value}, item);
    case 'T':
      if (sgn(*value) != 0) add(DwellItem{*value}, item);
      return;
    default:
      DGT_CHECK(item.letter == 'S' || item.letter == 'M');
      return add(CodeItem{code_of(item, *value)}, item);
  }
}

void ContourWriter::take_g(const std::vector<Item>& items, std::size_t& i) {
  const Item& item = items[i];
  const std::optional<int> code = g_code(item);
  if (!code) return mark_broken();
  if (*code == 0) return add(RapidItem{}, item);
  const std::optional<RationalPoint> at = point_behind(items, i);
  if (!at) return mark_broken();
  add(ThreadItem{frame_.is_world ? *at : placed(*at, frame_.frame)}, item);
}

// --- words, in and outside contours
// ---------------------------------------------------------------

std::optional<int> ContourWriter::g_code(const Item& item) {
  const std::optional<Rational> value = evaluation_.value(item);
  if (!value) return std::nullopt;
  if (*value == 0) return 0;
  if (*value == 54) return 54;
  evaluation_.report({Message::UnknownG, item.range, {to_short_decimal(*value)}});
  return std::nullopt;
}

std::optional<RationalPoint> ContourWriter::point_behind(const std::vector<Item>& items,
                                                         std::size_t& i) {
  const char next = i + 1 == items.size() ? '\0' : items[i + 1].letter;
  if (next == 'X' || next == 'Y') {
    const std::string lacking(1, next == 'X' ? 'Y' : 'X');
    evaluation_.report(
        {Message::GLacksCoordinate, items[i + 1].range, {to_text(items[i]), lacking}});
    ++i;
    return std::nullopt;
  }
  if (next != 'P') {
    evaluation_.report({Message::GWithoutPoint, items[i].range, {to_text(items[i])}});
    return std::nullopt;
  }
  ++i;
  std::optional<KnownPoint> point = evaluation_.point(items[i]);
  if (!point) return std::nullopt;
  return std::move(point->stand_in);
}

std::optional<Rational> ContourWriter::word_value(const Item& item) {
  std::optional<Rational> value = evaluation_.value(item);
  if (!value) return std::nullopt;
  if (sgn(*value) < 0 && item.letter != 'S') {
    evaluation_.report({Message::NegativeWord, item.range, {std::string(1, item.letter)}});
    return std::nullopt;
  }
  if (item.letter == 'M' && value->get_den() != 1) {
    evaluation_.report({Message::CodeNotWhole, item.range, {to_short_decimal(*value)}});
    return std::nullopt;
  }
  return value;
}

std::string ContourWriter::code_of(const Item& item, const Rational& value) {
  return item.letter + to_short_decimal(value);
}

bool ContourWriter::are_words(const std::vector<Item>& items) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool is_place = std::string_view("PXY").find(items[i].letter) != std::string_view::npos;
    const bool behind_g = i > 0 && items[i - 1].letter == 'G';
    if (!is_word(items[i].letter) && !(is_place && behind_g)) return false;
  }
  return true;
}

void ContourWriter::act(const std::vector<Item>& words, bool broken) {
  DGT_CHECK(!open_);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Item& item = words[i];
    if (item.letter == 'G') {
      const bool has_point = i + 1 < words.size() && words[i + 1].letter == 'P';
      if (broken && !has_point) continue;
      act_on_g(words, i);
      continue;
    }
    const std::optional<Rational> value = is_word(item.letter) ? word_value(item) : std::nullopt;
    if (!value) continue;
    if (item.letter == 'F') {
      state_.straight_rapid = sgn(*value) == 0;
      if (sgn(*value) != 0) state_.feed = shared(*value);
    } else if (item.letter != 'T') {
      push_stop(MoveKind::Code, item).code = code_of(item, *value);
    } else if (sgn(*value) != 0) {
      push_stop(MoveKind::Dwell, item).seconds = shared(*value);
    }
  }
  if (!words.empty()) check_limit(made_, words.front().range);
}

void ContourWriter::act_on_g(const std::vector<Item>& items, std::size_t& i) {
  const Item& item = items[i];
  const std::optional<int> code = g_code(item);
  if (!code) {
    while (i + 1 < items.size() && !is_word(items[i + 1].letter)) ++i;
    return;
  }
  const std::optional<RationalPoint> to = point_behind(items, i);
  if (!to) return;
  if (*code == 0) return travel_to(*to, Role::Position, item);
  if (state_.moved) return travel_to(*to, Role::Thread, item);
  state_.start = *to;
  state_.at = Point(*to);
}

void ContourWriter::travel_to(const RationalPoint& to, Role role, const Item& item) {
  const Point end(to);
  if (end == state_.at) return;
  Move& move = push_stop(MoveKind::Rapid, item);
  move.role = role;
  move.to = end;
  move.feed = state_.feed;
  state_.at = end;
  state_.moved = true;
}

Move& ContourWriter::push_stop(MoveKind kind, const Item& item) {
  count_moves(1);
  if (!keeps_moves_) path_.moves.clear();
  Move& move = path_.moves.emplace_back();
  move.kind = kind;
  move.from = move.to = state_.at;
  move.source = place_of(item);
  return move;
}

// --- the path as a whole
// --------------------------------------------------------------------------

SourcePlace ContourWriter::place_of(const Item& item) {
  const SourceFile* const file = item.range.file;
  const auto known = std::find(files_.begin(), files_.end(), file);
  const auto index = static_cast<std::uint32_t>(known - files_.begin());
  if (known == files_.end()) {
    files_.push_back(file);
    path_.files.push_back(file->name());
  }
  return {index, item.line, item.column};
}

void ContourWriter::check_limit(std::size_t moves, const Range& range) {
  const std::uint64_t limit = evaluation_.options.bounds.moves;
  if (moves <= limit || over_limit_) return;
  over_limit_ = true;
  evaluation_.report({Message::TooManyMoves, range, {std::to_string(limit)}});
}

void ContourWriter::count_moves(std::size_t moves) {
  made_ += moves;
  if (evaluation_.options.purpose != Purpose::Check || made_ <= kMovesLookedOver) return;
  keeps_moves_ = false;
  path_.moves = {};
  path_.contours = {};
}

Toolpath ContourWriter::finish() {
  end();
  path_.start = state_.start;
  // What happened before the first move happened at the start, wherever G54 put it later.
  for (Move& move : path_.moves) {
    if (move.travels()) break;
    move.from = move.to = Point(state_.start);
  }
  return std::move(path_);
}

}  // namespace dgt::language
