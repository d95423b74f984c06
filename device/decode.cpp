// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/decode.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "device/before_start.h"

namespace dgt {
namespace {

using Kind = TapeFault::Kind;

constexpr std::string_view kDamaged = "\xEF\xBF\xBD";  // U+FFFD
constexpr std::string_view kStartLine = "%\n";

/// The character of each row that is one; 0 for rows that need thought.
constexpr auto kCharacterOfRow = [] {
  std::array<char, 256> characters{};
  for (int code = 0; code < 128; ++code) {
    const auto character = static_cast<char>(code);
    if (is_punchable(character)) characters.at(row_of(character)) = character;
  }
  return characters;
}();

/// 1 for an odd number of holes, in a form that compilers make vectors of.
std::size_t odd_holes(Row row) {
  unsigned folded = row;
  folded ^= folded >> 4;
  folded ^= folded >> 2;
  folded ^= folded >> 1;
  return folded & 1;
}

constexpr std::size_t kNoRow = std::numeric_limits<std::size_t>::max();

class Decoder {
 public:
  Decoder(const Tape& tape, const TapeFormat& format) : tape_(tape), format_(format) {}

  DecodedTape decode() {
    read_beginning();
    find_end();
    read_program();
    strip_start_line();
    if (made_.program_begin == made_.program_end) {
      add({.kind = Kind::NothingPunched, .row = tape_.rows.size()});
    }
    check_sum();
    std::ranges::stable_sort(made_.faults, {}, &TapeFault::row);
    return std::move(made_);
  }

 private:
  void add(TapeFault fault) {
    if (fault.is_damage()) ++made_.damage_count;
    if (made_.faults.size() < DecodedTape::kMostFaults) made_.faults.push_back(std::move(fault));
  }

  // --- before the program

  void read_beginning() {
    const std::span<const Row> rows(tape_.rows);
    if (format_.start == TapeStart::None) {
      const auto first = std::ranges::find_if(rows, [](Row row) { return row != kBlankRow; });
      made_.program_begin = static_cast<std::size_t>(first - rows.begin());
      return;
    }
    TapeBeginning found = beginning_of(rows, format_.before_start);
    made_.program_begin = found.start;
    made_.header = std::move(found.header);
    made_.sum = found.sum;
    has_start_ = found.has_start;
    if (!found.has_start) {
      if (found.start < rows.size()) {
        add({.kind = Kind::NoStart, .row = found.start, .seen = rows[found.start]});
      }
      return;
    }
    for (const auto& [begin, end] : found.stray) {
      add({.kind = Kind::StrayRows, .row = begin, .count = end - begin, .seen = rows[begin]});
    }
  }

  void find_end() {
    const auto first = tape_.rows.begin() + static_cast<std::ptrdiff_t>(made_.program_begin);
    const auto last = std::find_if(tape_.rows.rbegin(), std::make_reverse_iterator(first),
                                   [](Row row) { return row != kBlankRow; });
    made_.program_end = static_cast<std::size_t>(last.base() - tape_.rows.begin());
  }

  // --- the program

  /// Writes into a text that is long enough beforehand: this is where speed is decided.
  void read_program() {
    const auto rows = std::span<const Row>(tape_.rows)
                          .subspan(made_.program_begin, made_.program_end - made_.program_begin);
    std::size_t damaged = 0;
    for (const Row row : rows) damaged += odd_holes(row);
    made_.text.resize(rows.size() + damaged * (kDamaged.size() - 1));
    char* out = made_.text.data();
    std::size_t at = 0;
    if (has_start_) {  // of whatever holes
      if (!has_even_parity(rows[0])) add_damaged(0, rows[0], 0);
      *out++ = '%';
      at = 1;
    }
    while (at < rows.size()) {
      add_gaps_up_to(made_.program_begin + at, out);
      const std::size_t stop = std::min(rows.size(), next_gap_row() - made_.program_begin);
      while (at < stop) {
        if (const char c = kCharacterOfRow[rows[at]]; c != '\0') {
          *out++ = c;
          ++at;
        } else {
          at = read_special(rows, at, out);
        }
      }
    }
    add_gaps_up_to(kNoRow, out);
    made_.text.resize(static_cast<std::size_t>(out - made_.text.data()));
  }

  /// At least one row further than the gaps told.
  [[nodiscard]] std::size_t next_gap_row() const {
    return gap_ < tape_.gaps.size() ? tape_.gaps[gap_].row : kNoRow;
  }
  void add_gaps_up_to(std::size_t row, const char* out) {
    for (; gap_ < tape_.gaps.size() && tape_.gaps[gap_].row <= row; ++gap_) {
      const Gap& gap = tape_.gaps[gap_];
      add({.kind = Kind::Gap,
           .row = gap.row,
           .offset = static_cast<std::size_t>(out - made_.text.data()),
           .detail = gap.reason});
    }
  }

  std::size_t read_special(std::span<const Row> rows, std::size_t at, char*& out) {
    const Row row = rows[at];
    if (row == kCarriageReturn && at + 1 < rows.size() && rows[at + 1] == kLineFeed) {
      *out++ = '\n';  // nearly always
      return behind_line_feed(rows, at + 2);
    }
    switch (kind_of(row)) {
      case RowKind::LineFeed:
        *out++ = '\n';
        return behind_line_feed(rows, at + 1);
      case RowKind::CarriageReturn: {
        const std::size_t next = next_of_sense(rows, at);
        // With an LF behind it, the line ends there.
        if (next == rows.size() || rows[next] != kLineFeed) *out++ = '\n';
        return next;
      }
      case RowKind::Damaged:
        add_damaged(at, row, static_cast<std::size_t>(out - made_.text.data()));
        out = std::ranges::copy(kDamaged, out).out;
        break;
      case RowKind::Foreign:
        add_foreign(at, row, static_cast<std::size_t>(out - made_.text.data()));
        *out++ = code_of(row);
        break;
      case RowKind::Blank:
      case RowKind::RubOut:
      case RowKind::Character:
        break;
    }
    return at + 1;
  }

  /// LF CR, as some teleprinters end their lines; in CR LF CR LF each CR begins a new pair.
  static std::size_t behind_line_feed(std::span<const Row> rows, std::size_t at) {
    if (at >= rows.size() || rows[at] != kCarriageReturn) return at;
    const std::size_t next = next_of_sense(rows, at);
    return next < rows.size() && rows[next] == kLineFeed ? at : next;
  }
  /// The first row from `at` on that is neither CR nor without meaning.
  static std::size_t next_of_sense(std::span<const Row> rows, std::size_t at) {
    while (at < rows.size() &&
           (rows[at] == kCarriageReturn || rows[at] == kBlankRow || rows[at] == kRubOut)) {
      ++at;
    }
    return at;
  }

  void add_damaged(std::size_t at, Row row, std::size_t offset) {
    add({.kind = Kind::Parity, .row = made_.program_begin + at, .seen = row, .offset = offset});
  }
  /// Told once, with their number.
  void add_foreign(std::size_t at, Row row, std::size_t offset) {
    if (foreign_) {
      ++made_.faults[*foreign_].count;
      return;
    }
    if (made_.faults.size() >= DecodedTape::kMostFaults) return;
    foreign_ = made_.faults.size();
    add({.kind = Kind::ForeignCode,
         .row = made_.program_begin + at,
         .seen = row,
         .offset = offset});
  }

  void strip_start_line() {
    if (!has_start_ || !made_.text.starts_with(kStartLine)) return;
    const bool is_pair = made_.text.ends_with("\n%") || made_.text.ends_with("\n%\n");
    if (is_pair) return;
    made_.text.erase(0, kStartLine.size());
    for (TapeFault& fault : made_.faults) {
      fault.offset -= std::min(fault.offset, kStartLine.size());
    }
  }

  // --- all of it

  void check_sum() {
    if (!has_start_) return;
    if (!made_.sum) {
      if (format_.checksum == TapeChecksum::Line && format_.before_start == BeforeStart::Checked) {
        add({.kind = Kind::ChecksumMissing, .row = made_.program_begin});
      }
      return;
    }
    const TapeSum found =
        sum_of(std::span<const Row>(tape_.rows)
                   .subspan(made_.program_begin, made_.program_end - made_.program_begin));
    if (found == *made_.sum) return;
    add({.kind = Kind::ChecksumDiffers,
         .row = made_.program_begin,
         .said = *made_.sum,
         .found = found});
  }

  const Tape& tape_;
  const TapeFormat& format_;
  DecodedTape made_;
  bool has_start_ = false;
  std::size_t gap_ = 0;                 // the first that is not told yet
  std::optional<std::size_t> foreign_;  // among the faults
};

}  // namespace

DecodedTape decode_tape(const Tape& tape, const TapeFormat& format) {
  return Decoder(tape, format).decode();
}

}  // namespace dgt
