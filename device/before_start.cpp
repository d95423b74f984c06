// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows between blank ones are a run. Before the program a run is a letter in holes, a checksum
// line, or strange; the program begins with the first run that holds a `%`.
#include "device/before_start.h"

#include <algorithm>

#include "device/lettering.h"

namespace dgt {
namespace {

using Rows = TapeBeginning::Rows;

bool is_line_end(Row row) { return row == kLineFeed || row == kCarriageReturn; }

/// Longer than letters in holes with a damaged row between them.
constexpr std::size_t kSurelyText = 16;

/// A `%` with one hole too many or too few, and a program behind it.
bool is_damaged_start(std::span<const Row> run) {
  return std::popcount(static_cast<unsigned>(run[0] ^ kStartOfProgram)) == 1 &&
         (run.size() > kSurelyText || (run.size() > 1 && is_line_end(run[1])));
}

std::optional<TapeSum> sum_in(std::span<const Row> run) {
  std::string line;
  for (const Row row : run) {
    if (!has_even_parity(row)) return std::nullopt;
    line += code_of(row);
  }
  const std::size_t end = line.find('\r');
  if (!line.ends_with("\r\n") || end + 2 != line.size()) return std::nullopt;
  return sum_in_line(line.substr(0, end));
}

class BeginningReader {
 public:
  explicit BeginningReader(std::span<const Row> rows) : rows_(rows) {}

  TapeBeginning read() {
    found_.start = rows_.size();
    std::size_t end = 0;
    while (!found_.has_start) {
      const auto first = std::find_if(rows_.begin() + static_cast<std::ptrdiff_t>(end), rows_.end(),
                                      [](Row row) { return row != kBlankRow; });
      if (first == rows_.end()) break;
      const auto last = std::find(first, rows_.end(), kBlankRow);
      const auto begin = static_cast<std::size_t>(first - rows_.begin());
      read_run({begin, static_cast<std::size_t>(last - rows_.begin())}, begin - end);
      end = static_cast<std::size_t>(last - rows_.begin());
    }
    if (!found_.has_start && !found_.stray.empty()) found_.start = found_.stray.front().begin;
    return std::move(found_);
  }

 private:
  void read_run(const Rows& run, std::size_t blank_before) {
    const auto rows = rows_.subspan(run.begin, run.end - run.begin);
    if (const auto letter = letter_in_holes(rows)) {
      if (!found_.header.empty() && blank_before > kSpaceRows) found_.header += ' ';
      found_.header += *letter;
    } else if (const auto sum = sum_in(rows)) {
      found_.sum = sum;
    } else if (is_damaged_start(rows)) {
      start_at(run.begin);
    } else {
      read_strange(run, rows);
    }
  }
  void read_strange(const Rows& run, std::span<const Row> rows) {
    const auto before =
        static_cast<std::size_t>(std::ranges::find(rows, kStartOfProgram) - rows.begin());
    if (std::any_of(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(before),
                    [](Row row) { return row != kRubOut; })) {
      found_.stray.push_back({run.begin, run.begin + before});
    }
    if (before < rows.size()) start_at(run.begin + before);
  }
  void start_at(std::size_t row) {
    found_.has_start = true;
    found_.start = row;
  }

  std::span<const Row> rows_;
  TapeBeginning found_;
};

}  // namespace

TapeBeginning beginning_of(std::span<const Row> rows, BeforeStart before) {
  if (before == BeforeStart::Ignored) {
    const auto start = std::ranges::find(rows, kStartOfProgram);
    if (start != rows.end()) {
      TapeBeginning found;
      found.start = static_cast<std::size_t>(start - rows.begin());
      found.has_start = true;
      return found;
    }
  }
  return BeginningReader(rows).read();
}

}  // namespace dgt
