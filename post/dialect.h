// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/toolpath.h"

/// What a control reads, as data.
namespace dgt {

enum class Form : std::uint8_t {
  Essi,   ///< signed fields without letters
  Gcode,  ///< letters and numbers
  ThreeB  ///< `B X B Y B J G Z` of wire machines
};
enum class Positions : std::uint8_t { Incremental, Absolute };
enum class ArcForm : std::uint8_t {
  Radius,  ///< end, whole radius, which arc, which sense
  Centre   ///< end, centre counted from the written start
};
enum class TorchPolicy : std::uint8_t {
  Automatic,  ///< on before the first cut, off before a rapid and at the end; a program that says
              ///< torch codes itself is left alone
  Program,    ///< only what the program says
  None        ///< the machine has no torch: torch codes are codes like any other
};
/// Who offsets a contour by half the kerf.
enum class Compensation : std::uint8_t {
  Computed,  ///< the equidistant is written
  Control    ///< the contour is written, and the words by which the control offsets it
};
enum class DwellUnit : std::uint8_t { Seconds, Tenths, Milliseconds };

/// A code of the program and the words the control has for it.
struct CodeWord {
  std::string code;  ///< as in Move::code without leading zeros: `M7`, `53`
  std::string words;
};

/// The M codes `first` to `last`.
struct CodeRange {
  int first = 0;
  int last = 0;
};

/// How G-code spells its words.
struct Spelling {
  std::string rapid = "G00";
  std::string line = "G01";
  std::string clockwise = "G02";
  std::string counter_clockwise = "G03";
  std::string x = "X", y = "Y", z = "Z", i = "I", j = "J", r = "R";
  std::string separator = " ";   ///< between two words
  bool plus = false;             ///< `X+1.5`
  bool point = true;             ///< false: units are counted, `X1500`
  bool trailing_zeros = true;    ///< false: `X1.5`, `X2.`
  bool zero_words = true;        ///< false: a word that is zero is left out (increments, centres)
  bool repeats_motion = true;    ///< false: `G01` is written where it changes
  bool repeats_position = true;  ///< false: absolute coordinates that stay are left out
};

/// `N10` and so on, before every line that does not begin with one of `%O:(`.
struct LineNumbers {
  std::string word;  ///< empty: none
  int first = 10;
  int step = 10;
};

/// Where a control stands at the end of the straight cut on which it comes to its offset.
enum class KerfEntry : std::uint8_t {
  Meets,   ///< where the offsets of that cut and of the next element meet (LinuxCNC)
  Beside,  ///< beside the beginning of the next element, along its normal (Fanuc)
  Either   ///< nobody has said: programs have to be right both ways
};

/// The words by which a control offsets the contour itself, and how it does. In the words stand for
/// lengths in mm: `{offset}`, how far the tool runs beside the contour; `{width}`, twice that;
/// `{units}`, the width in whole units.
struct KerfWords {
  std::vector<std::string> left;
  std::vector<std::string> right;
  std::vector<std::string> off;
  KerfEntry entry = KerfEntry::Either;
  bool rounds_corners = false;  ///< outer ones, by an arc; else it prolongs the elements

  [[nodiscard]] bool exist() const { return !left.empty() && !right.empty(); }
};

struct Dialect {
  std::string name;
  std::string about;     ///< one line, English
  std::string about_ru;  ///< the same, Russian
  Form form = Form::Gcode;
  Positions positions = Positions::Incremental;
  ArcForm arc_form = ArcForm::Centre;

  Rational unit{1, 10};  ///< the least step, in mm
  /// Longer arcs are divided, in degrees; at most 180. An arc that is exact on the grid is not.
  double max_arc_degrees = 180;
  /// The two radii of a centre-form arc differ by no more, in mm.
  Rational radius_mismatch{1, 20};
  /// No radius of a centre-form arc is less, in mm; smaller arcs are divided, in the end into
  /// lines.
  Rational least_radius{0};

  Spelling spelling;
  LineNumbers line_numbers;
  bool centre_is_absolute = false;  ///< else it is counted from where the arc begins
  bool plus_is_ccw = false;         ///< the sense `+` of an ESSI arc
  /// No number that is written is larger, in mm; null: as kMaxUnits has it.
  RationalPtr largest;
  std::size_t longest_line = 0;  ///< characters without the line end; 0: any

  /// In the lines `{x}` and `{y}` stand for where the program begins.
  std::vector<std::string> header;
  std::vector<std::string> footer;
  std::string line_end = "\n";
  bool rapid_to_start = false;  ///< the first block
  std::string rapids_begin;     ///< words before the first rapid of several, empty: none
  std::string rapids_end;       ///< behind the last

  TorchPolicy torch = TorchPolicy::Automatic;
  std::string torch_on;  ///< its lines parted by line feeds
  std::string torch_off;
  std::vector<std::string> torch_on_codes;   ///< written as torch_on
  std::vector<std::string> torch_off_codes;  ///< written as torch_off
  /// Written as they are, but torch codes all the same.
  std::vector<std::string> own_torch_on_codes;
  std::vector<std::string> own_torch_off_codes;
  std::vector<CodeWord> codes;         ///< further codes that are translated
  std::vector<CodeRange> known_codes;  ///< M codes of the control, written as they are
  std::vector<CodeRange> user_codes;   ///< likewise, by a setting; ESSI gets the number alone
  std::string passed_letters;          ///< other codes that begin so are written as they are
  int passed_numbers_below = 0;        ///< codes without a letter, written as they are
  std::string dropped_letters;         ///< taken from the control's settings: one note

  std::string feed_word;  ///< `F`; of ESSI a code with its sign, `39+`
  int feed_decimals = 3;
  bool writes_feed = false;     ///< false: F comes from the control's settings, one note
  bool needs_feed = false;      ///< a feed must be said before the first cut
  RationalPtr feed;             ///< mm/min for all cuts, instead of the program's
  Rational default_feed{1000};  ///< mm/min where needs_feed and the program says none
  bool writes_height = false;
  std::string dwell_word;  ///< with the letter of the time: `G04 P`; empty: cannot dwell
  DwellUnit dwell_unit = DwellUnit::Seconds;
  int dwell_decimals = 6;

  Compensation compensation = Compensation::Computed;
  KerfWords kerf;  ///< empty: the control cannot offset
};

/// Those that come with the program (post/dialects/), the oldest first.
[[nodiscard]] const std::vector<Dialect>& dialects();
/// Null when there is none of that name.
[[nodiscard]] const Dialect* find_dialect(std::string_view name);

/// What a code of the program does to the torch.
enum class TorchAct : std::uint8_t { None, On, Off };

/// What a dialect makes of a code of the program.
struct CodeMeaning {
  enum class Kind : std::uint8_t {
    Words,    ///< write `words`
    End,      ///< M2, M30: nothing may follow; the writer ends programs itself
    Dropped,  ///< taken from the control's settings
    Unknown
  };
  Kind kind = Kind::Unknown;
  std::string words;
  TorchAct torch = TorchAct::None;
};
[[nodiscard]] CodeMeaning meaning_of(const Dialect& dialect, std::string_view code);

}  // namespace dgt
