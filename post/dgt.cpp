// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/dgt.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "post/dgt_contour.h"
#include "post/dgt_elements.h"

namespace dgt {
namespace {

/// Items of a contour are broken into lines about this wide.
constexpr std::size_t kWidth = 76;

class DgtProgram {
 public:
  DgtProgram(const Toolpath& path, const std::vector<DgtStyle>& styles) : path_(path) {
    result_.contours.resize(path.contours.size());
    for (std::size_t i = 0; i < path.contours.size(); ++i) styles_.push_back(styles.at(i));
  }

  DgtText run(const std::string& title) {
    check();
    if (!result_.faults.empty()) return std::move(result_);
    add_line("' " + title);
    add_line("G54 " + dgt_coordinates(dgt_place(Point(path_.start))));
    std::size_t contour = 0;
    std::size_t move = 0;
    while (move < path_.moves.size()) {
      while (contour < path_.contours.size() && path_.contours[contour].last <= move) ++contour;
      const bool is_contour =
          contour < path_.contours.size() && path_.contours[contour].first == move;
      if (is_contour) {
        add_contour(contour);
        move = path_.contours[contour].last;
      } else {
        add_between(path_.moves[move++]);
      }
    }
    return std::move(result_);
  }

 private:
  void check() {
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      const Move& move = path_.moves[i];
      if (move.kind != MoveKind::Code || !dgt_code(move.code).empty()) continue;
      WriteFault fault;
      fault.kind = WriteFault::Kind::UnknownCode;
      fault.move = i;
      fault.place = move.source;
      fault.code = move.code;
      result_.faults.push_back(fault);
    }
  }

  void add_line(const std::string& line) {
    result_.text += line + "\n";
    ++lines_;
  }
  void add_definitions() {
    for (const std::string& definition : names_.take_definitions()) add_line(definition);
  }

  void set_feed(const Move& move) {
    if (!move.feed || (feed_ && *feed_ == *move.feed)) return;
    feed_ = *move.feed;
    add_line("F" + to_short_decimal(*feed_, kDgtDecimals));
  }

  /// What stands outside contours.
  void add_between(const Move& move) {
    if (move.travels()) set_feed(move);
    switch (move.kind) {
      case MoveKind::Code:
        return add_line(dgt_code(move.code));
      case MoveKind::Dwell:
        return add_line("T" + to_short_decimal(*move.seconds, kDgtDecimals));
      case MoveKind::Rapid: {
        if (move.z) break;
        const char* const word = move.role == Role::Thread ? "G54 " : "G0 ";
        return add_line(word + dgt_coordinates(dgt_place(move.to)));
      }
      default:
        break;
    }
    add_items(*dgt_items({&move, 1}, false, DgtStyle::Points, names_), "");
  }

  void add_contour(std::size_t index) {
    const Contour& contour = path_.contours[index];
    const std::span<const Move> moves(path_.moves.data() + contour.first,
                                      contour.last - contour.first);
    // An element may be defined again, so numbers never run out between contours.
    const std::size_t more = moves.size() + 2;
    if (names_.largest() + more > kMaxDgtNumber) names_.begin_anew();
    const auto cut = std::ranges::find_if(moves, [](const Move& move) { return move.travels(); });
    if (cut != moves.end()) set_feed(*cut);
    result_.contours[index].first = lines_ + 1;
    DgtStyle& style = result_.contours[index].style;
    style = more < kMaxDgtNumber ? styles_[index] : DgtStyle::Points;
    auto items = items_of(contour, moves, style);
    while (!items) {
      style = static_cast<DgtStyle>(static_cast<int>(style) + 1);
      items = items_of(contour, moves, style);
    }
    std::string head;
    if (is_with_width(style)) {
      head = "W" + to_short_decimal(abs(contour.offset), kDgtDecimals) + " ";
      set_side(contour.side);
    }
    add_items(*items, head);
    if (!moves.empty() && moves.back().feed) feed_ = *moves.back().feed;
    result_.contours[index].last = lines_;
  }

  std::optional<std::vector<std::string>> items_of(const Contour& contour,
                                                   std::span<const Move> moves, DgtStyle style) {
    if (is_with_width(style))
      return dgt_items_with_leads(programmed_moves(path_, contour), contour.closed, style, names_);
    if (style == DgtStyle::Points) return dgt_items(moves, contour.closed, style, names_);
    const bool is_round = !moves.empty() && moves.front().from == moves.back().to;
    return dgt_items(moves, is_round, style, names_);
  }

  void set_side(Side side) {
    if (side == side_) return;
    side_ = side;
    add_line(side == Side::Left ? "'@ offset-side left" : "'@ offset-side right");
  }

  void add_items(const std::vector<std::string>& items, const std::string& head) {
    add_definitions();
    std::string line = "K" + std::to_string(contours_++ % kMaxDgtNumber + 1) + " " + head;
    bool goes_on = false;
    for (const std::string& item : items) {
      if (line.size() + item.size() > kWidth) {
        add_line(line + (goes_on ? "," : ""));
        line = "  ";
        goes_on = true;
      }
      line += item + " ";
    }
    add_line(line + (goes_on ? "," : ""));
  }

  const Toolpath& path_;
  std::vector<DgtStyle> styles_;
  DgtNames names_;
  std::size_t lines_ = 0;
  std::size_t contours_ = 0;
  std::optional<Rational> feed_;
  Side side_ = Side::None;
  DgtText result_;
};

}  // namespace

std::string dgt_code(const std::string& code) {
  if (code == "53") return "M7";
  if (code == "54") return "M8";
  if (code == "0") return "M0";
  const bool is_word = code.size() > 1 && (code[0] == 'M' || code[0] == 'S');
  return is_word ? code : "";
}

DgtText to_dgt(const Toolpath& path, const std::vector<DgtStyle>& styles,
               const std::string& title) {
  return DgtProgram(path, styles).run(title);
}

}  // namespace dgt
