// SPDX-License-Identifier: GPL-3.0-or-later
//
// One block at a time, in the order in which LinuxCNC executes its words: feed, S, T, M, dwell,
// modes, motion, and the stops last.
#include "lang/gcode/reader.h"

#include <array>
#include <utility>

#include "lang/gcode/block.h"
#include "lang/gcode/codes.h"
#include "lang/nc/arc_check.h"
#include "lang/nc/path_builder.h"
#include "lang/nc/told_arc.h"

namespace dgt {
namespace {

using gcode::Block;
using gcode::CodeWord;
using gcode::Group;

constexpr int kCancelled = 800;  // G80
constexpr int kTenths = 10;

std::uint32_t bit(char letter) { return 1U << (letter - 'A'); }

constexpr std::uint32_t bits(const char* letters) {
  std::uint32_t set = 0;
  for (; *letters != '\0'; ++letters) set |= 1U << (*letters - 'A');
  return set;
}

bool ends_program(int m) { return m == 2 || m == 30; }
/// Those that act when the motion of their block is done.
bool acts_last(int m) { return m == 0 || m == 1 || m == 60 || ends_program(m); }
bool calls_program(int m) { return m == 97 || m == 98 || m == 99; }

class GcodeReader {
 public:
  GcodeReader(const SourceFile& file, const GcodeOptions& options, DiagnosticBag& bag)
      : file_(file),
        text_(file.text()),
        options_(options),
        bag_(bag),
        blocks_(file, bag),
        path_(file, file.line_count()),
        is_absolute_(!options.begins_incremental) {}

  NcProgram run() {
    while (blocks_.next(block_)) {
      tell_progress(options_.nc.on_progress, block_.line, file_.line_count());
      if (ended_ && !block_.is_tape_mark) {
        report(Message::BehindTheEnd, whole_block());
        break;
      }
      if (block_.is_tape_mark) {
        ended_ = ended_ || !is_first_;
      } else {
        execute();
      }
      is_first_ = false;
      if (path_.size() > options_.nc.max_moves) {
        report(Message::TooManyMoves, whole_block(), {std::to_string(options_.nc.max_moves)});
        break;
      }
    }
    report_arcs();
    NcProgram program = path_.finish();
    program.step = std::move(step_);
    return program;
  }

 private:
  // --- messages

  [[nodiscard]] Range whole_block() const { return {&file_, block_.begin, block_.end}; }
  [[nodiscard]] Range range_of(const CodeWord& code) const {
    return {&file_, code.begin, code.end};
  }
  [[nodiscard]] Range range_of(char letter) const {
    return {&file_, block_.letters[static_cast<std::size_t>(letter - 'A')],
            block_.word(letter).end};
  }
  void report(Message message, const Range& range, std::vector<std::string> arguments = {}) {
    bag_.add({message, range, std::move(arguments)});
  }
  void report_arcs() { dgt::report(path_.arcs(), bag_); }
  static std::string text_of(const Range& range) { return std::string(range.text()); }

  // --- one block

  void execute() {
    rest_ = block_.present;
    place_ = {0, block_.line, block_.column};
    is_machine_frame_ = sets_origin_ = dwells_ = false;
    moves_ = -1;
    refuse_axes();
    read_codes();
    if (block_.present & bits("FST")) read_settings();
    if (block_.m_count > 0) read_m(false);
    if (dwells_) dwell();
    if (sets_origin_) set_origin();
    move();
    if (block_.m_count > 0) read_m(true);
    if (rest_ != 0) refuse_rest();
  }

  [[nodiscard]] bool has(char letter) const { return (rest_ & bit(letter)) != 0; }
  const Decimal& use(char letter) {
    rest_ &= ~bit(letter);
    return block_.word(letter);
  }

  void refuse_axes() {
    constexpr std::uint32_t kOthers = bits("ABCUVW");
    if ((rest_ & kOthers) == 0) return;
    for (const char letter : {'A', 'B', 'C', 'U', 'V', 'W'}) {
      if (!has(letter)) continue;
      use(letter);
      report(Message::GcodeAxis, range_of(letter), {std::string(1, letter)});
    }
  }

  void refuse_rest() {
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
      if (!has(letter)) continue;
      const Range range = range_of(letter);
      const bool is_known = (bits("DHIJKLPQRXYZ") & bit(letter)) != 0;
      report(is_known ? Message::GcodeIdleWord : Message::GcodeUnknownWord, range,
             {text_of(range)});
    }
  }

  // --- G

  void read_codes() {
    std::array<const CodeWord*, static_cast<std::size_t>(Group::Unknown) + 1> seen{};
    for (std::size_t i = 0; i < block_.g_count; ++i) {
      const CodeWord& code = block_.g[i];
      const Group group = gcode::group_of(code.number);
      const CodeWord*& other = seen[static_cast<std::size_t>(group)];
      if (group == Group::Unknown) {
        report(Message::GcodeUnknownG, range_of(code), {text_of(range_of(code))});
        moves_ = kCancelled;  // it may have meant the coordinates
        continue;
      }
      if (other != nullptr) {
        report(Message::GcodeClash, range_of(code),
               {text_of(range_of(*other)), text_of(range_of(code))});
        continue;
      }
      other = &code;
      read_code(code, group);
    }
  }

  void read_code(const CodeWord& code, Group group) {
    switch (group) {
      case Group::Motion:
        motion_ = code.number;
        moves_ = code.number;
        break;
      case Group::Once:
        dwells_ = code.number == 40;
        is_machine_frame_ = code.number == 530;
        sets_origin_ = code.number == 920;
        if (code.number == 921 || code.number == 922) shift_ = {};
        break;
      case Group::Plane:
        plane_ = code.number;
        break;
      case Group::Units:
        unit_ = code.number == 200 ? LengthUnit::Inch : LengthUnit::Millimetre;
        break;
      case Group::Distance:
        is_absolute_ = code.number == 900;
        break;
      case Group::ArcDistance:
        is_centre_absolute_ = code.number == 901;
        break;
      case Group::Kerf:
        switch_kerf(code);
        break;
      case Group::ToolLength:
        if (code.number == 430 && has('X') && !has('H')) {
          kerf_ = length_of(use('X'), unit_, text_).millimetres();
        } else if (has('H')) {
          use('H');  // the length of a tool changes nothing in the plane
        }
        break;
      case Group::Frame:
        if (frame_ != 0 && frame_ != code.number && path_.size() > 0)
          report(Message::GcodeUnknownG, range_of(code), {text_of(range_of(code))});
        frame_ = code.number;
        break;
      case Group::PathMode:
        if (has('P')) use('P');
        if (has('Q')) use('Q');
        break;
      default:
        break;
    }
  }

  void switch_kerf(const CodeWord& code) {
    const Side side = code.number == 400                         ? Side::None
                      : code.number == 410 || code.number == 411 ? Side::Left
                                                                 : Side::Right;
    Rational offset = kerf_ ? *kerf_ : Rational(options_.nc.kerf_width / 2);
    if (has('D')) {
      const Decimal& d = use('D');
      // G41 D1 names a register of the control, G41.1 D0.4 a diameter.
      if (code.number % kTenths == 1) offset = length_of(d, unit_, text_).millimetres() / 2;
    }
    path_.switch_kerf(side, offset, range_of(code));
  }

  // --- F, S, T, M

  void read_settings() {
    if (has('F')) set_feed(use('F'));
    for (const char letter : {'S', 'T'}) {
      if (!has(letter)) continue;
      const Rational value = use(letter).value(text_);
      path_.code(letter + to_short_decimal(value), place_);
    }
  }

  void set_feed(const Decimal& feed) {
    if (has_feed_ && feed.same_as(feed_word_) && feed_unit_ == unit_) return;
    const Rational value = length_of(feed, unit_, text_).millimetres();
    if (sgn(value) <= 0) {
      report(Message::GcodeFeed, range_of('F'), {text_of(range_of('F'))});
      return;
    }
    has_feed_ = true;
    feed_word_ = feed;
    feed_unit_ = unit_;
    path_.set_feed(shared(value));
  }

  void read_m(bool last) {
    for (std::size_t i = 0; i < block_.m_count; ++i) {
      const CodeWord& code = block_.m[i];
      if (acts_last(code.number) != last) continue;
      if (calls_program(code.number)) {
        report(Message::GcodeProgramFlow, range_of(code), {text_of(range_of(code))});
        rest_ &= ~bits("PQL");
      } else if (ends_program(code.number)) {
        ended_ = true;
      } else {
        path_.code("M" + std::to_string(code.number), place_);
      }
    }
  }

  // --- dwell, origin

  void dwell() {
    const char letter = has('P') ? 'P' : 'X';
    if (!has(letter)) return report(Message::GcodeDwellIncomplete, whole_block());
    const Rational time = use(letter).value(text_);
    if (sgn(time) < 0) return report(Message::GcodeDwellIncomplete, range_of(letter));
    path_.dwell(shared(time * options_.dwell_unit), place_);
  }

  void set_origin() {
    const Spot said{has('X') ? coordinate('X') : path_.at().x - shift_.x,
                    has('Y') ? coordinate('Y') : path_.at().y - shift_.y};
    if (has('Z')) coordinate('Z');
    if (is_placed_) {
      shift_ = path_.at() - said;
    } else {
      path_.start_at(said, place_);
      is_placed_ = true;
    }
  }

  Length coordinate(char letter) {
    const Decimal& number = use(letter);
    if (number.decimals > finest_) note_step(number.decimals);
    return length_of(number, unit_, text_);
  }
  /// The finest number of a program tells its grid. Whole numbers tell nothing.
  void note_step(std::uint32_t decimals) {
    finest_ = decimals;
    step_ = unit_ == LengthUnit::Inch ? Rational(127, 5) : Rational(1);
    for (std::uint32_t i = 0; i < decimals; ++i) step_ /= 10;
  }

  // --- motion

  void move() {
    constexpr std::uint32_t kAxes = bits("XYZ");
    constexpr std::uint32_t kArcWords = bits("IJR");
    const bool is_arc = motion_ == 20 || motion_ == 30;
    if ((rest_ & (is_arc ? kAxes | kArcWords : kAxes)) == 0) {
      if (is_arc && moves_ == motion_ && !has('I') && !has('J') && !has('R')) return;
      return;
    }
    if (moves_ == kCancelled || motion_ == kCancelled) {
      if (moves_ != kCancelled || motion_ == kCancelled) report_no_motion();
      rest_ &= ~(kAxes | bits("IJKRPQL"));
      return;
    }
    const Spot from = path_.at();
    const bool is_flat = !has('X') && !has('Y');
    const Spot to = target();
    RationalPtr height = has('Z') ? target_height() : nullptr;
    if (is_arc) return arc(to, std::move(height));
    if (!is_placed_) {
      if (motion_ == 0 && is_absolute_ && !is_flat) {
        path_.start_at(to, place_);
        is_placed_ = true;
      } else if (motion_ != 0 || !is_flat) {
        is_placed_ = true;
      }
    }
    if (to == path_.at() && !height) return;
    if (motion_ == 0) {
      path_.rapid(to, std::move(height), place_);
    } else {
      path_.line(to, std::move(height), place_);
    }
  }

  void report_no_motion() {
    for (const char letter : {'X', 'Y', 'Z'}) {
      if (!has(letter)) continue;
      const Range range = range_of(letter);
      return report(Message::GcodeNoMotion, range, {text_of(range)});
    }
  }

  Spot target() {
    const Spot from = path_.at();
    const bool absolute = is_absolute_ || is_machine_frame_;
    Spot to = from;
    if (has('X')) {
      const Length x = coordinate('X');
      to.x = !absolute ? from.x + x : is_machine_frame_ ? x : x + shift_.x;
    }
    if (has('Y')) {
      const Length y = coordinate('Y');
      to.y = !absolute ? from.y + y : is_machine_frame_ ? y : y + shift_.y;
    }
    return to;
  }

  /// Null when it does not change.
  RationalPtr target_height() {
    const Length z = coordinate('Z');
    const Length to = is_absolute_ || is_machine_frame_ ? z : height_ + z;
    if (is_height_known_ && to == height_) return nullptr;
    is_height_known_ = true;
    height_ = to;
    return shared(to.millimetres());
  }

  void arc(const Spot& to, RationalPtr height) {
    is_placed_ = true;
    const bool ccw = motion_ == 30;
    if (plane_ != 170) {
      report(Message::GcodePlane, whole_block(), {plane_ == 180 ? "G18" : "G19"});
      return skip_arc(to, std::move(height));
    }
    const bool by_centre = has('I') || has('J');
    if (has('R') && by_centre) {
      report(Message::GcodeArcTwice, range_of('R'));
      return skip_arc(to, std::move(height));
    }
    if (has('R')) return arc_by_radius(to, ccw, std::move(height));
    if (!by_centre) {
      report(Message::GcodeArcIncomplete, whole_block());
      return skip_arc(to, std::move(height));
    }
    arc_by_centre(to, ccw, std::move(height));
  }

  /// After a fault the program is read on from where the arc should have ended.
  void skip_arc(const Spot& to, RationalPtr height) {
    rest_ &= ~bits("IJKRP");
    path_.line(to, std::move(height), place_);
  }

  void arc_by_centre(const Spot& to, bool ccw, RationalPtr height) {
    const Spot from = path_.at();
    const Spot chord = to - from;
    Spot centre{has('I') ? coordinate('I') : Length(), has('J') ? coordinate('J') : Length()};
    if (is_centre_absolute_) centre = centre + shift_ - from;
    if (auto fault = fault_of_centre(chord, centre, options_.nc, whole_block(), path_.arcs())) {
      bag_.add(*std::move(fault));
      return skip_arc(to, std::move(height));
    }
    if (const auto middle = division_of(chord, centre, ccw)) {
      path_.arc(from + *middle, told_by_centre(from, *middle, centre, ccw), nullptr, place_);
      path_.arc(to, told_by_centre(from + *middle, chord - *middle, centre - *middle, ccw),
                std::move(height), place_);
      return;
    }
    path_.arc(to, told_by_centre(from, chord, centre, ccw), std::move(height), place_);
  }

  void arc_by_radius(const Spot& to, bool ccw, RationalPtr height) {
    const Spot from = path_.at();
    const Spot chord = to - from;
    Length radius = coordinate('R');
    const bool major = sgn(radius.millimetres()) < 0;
    if (major) radius = Length() - radius;
    static const Rational kMillimetre(1);
    static const Rational kInch(127, 5);
    static const Rational kUnitOfRepair(1, 10);
    const RadiusWord word{radius, unit_ == LengthUnit::Inch ? kInch : kMillimetre, true};
    RadiusVerdict verdict =
        judge_radius(chord, word, kUnitOfRepair, options_.nc, whole_block(), path_.arcs());
    const bool is_fault = verdict.message && verdict.message->severity() == Severity::Error;
    if (verdict.message) bag_.add(*std::move(verdict.message));
    if (is_fault) return skip_arc(to, std::move(height));
    path_.arc(to,
              verdict.is_half_turn ? told_half_turn(from, chord, ccw)
                                   : told_by_radius(from, chord, radius, major, ccw),
              std::move(height), place_);
  }

  const SourceFile& file_;
  const std::string_view text_;
  const GcodeOptions& options_;
  DiagnosticBag& bag_;
  gcode::BlockReader blocks_;
  PathBuilder path_;

  Block block_;
  std::uint32_t rest_ = 0;  ///< letters of the block that nothing has used yet
  SourcePlace place_;
  int moves_ = -1;  ///< the motion word of the block
  bool is_machine_frame_ = false;
  bool sets_origin_ = false;
  bool dwells_ = false;

  int motion_ = kCancelled;
  int plane_ = 170;
  int frame_ = 0;
  bool is_absolute_;
  bool is_centre_absolute_ = false;
  LengthUnit unit_ = LengthUnit::Millimetre;
  Spot shift_;  ///< of G92: where the program's origin lies
  Length height_;
  bool is_height_known_ = false;
  bool is_placed_ = false;  ///< it is known where the program starts
  std::optional<Rational> kerf_;
  std::uint32_t finest_ = 0;  ///< decimals of a coordinate so far
  Rational step_;
  bool has_feed_ = false;
  Decimal feed_word_;  ///< the last F, which programs repeat in every block
  LengthUnit feed_unit_ = LengthUnit::Millimetre;
  bool is_first_ = true;
  bool ended_ = false;
};

}  // namespace

NcProgram read_gcode(const SourceFile& file, const GcodeOptions& options, DiagnosticBag& bag) {
  return GcodeReader(file, options, bag).run();
}

}  // namespace dgt
