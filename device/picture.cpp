// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/picture.h"

#include <algorithm>
#include <optional>

namespace dgt {
namespace {

constexpr std::string_view kEdge = "___________\n";
constexpr std::string_view kGap = "~~~~~~~~~~~  gap: ";
constexpr std::string_view kBlank = "|     .   |";
constexpr std::size_t kFeedColumn = 6;

/// The column of a track, from 0 to 7.
constexpr std::size_t column_of(std::size_t track) { return (track < 3 ? 9 : 8) - track; }
static_assert(column_of(7) == 1 && column_of(3) == 5 && column_of(2) == 7 && column_of(0) == 9);

void append_row(std::string& picture, Row row) {
  const std::size_t begin = picture.size();
  picture += kBlank;
  for (std::size_t track = 0; track < kTracks; ++track) {
    if ((row >> track & 1) != 0) picture[begin + column_of(track)] = 'o';
  }
  if (row != kBlankRow) picture.append("  ").append(name_of(row));
  picture += '\n';
}

void append_gap(std::string& picture, const Gap& gap) {
  picture += kGap;
  for (const char c : gap.reason) picture += c == '\n' || c == '\r' ? ' ' : c;
  picture += '\n';
}

bool is_hole(char c) { return c == 'o' || c == 'O' || c == '*'; }

std::optional<Row> row_in(std::string_view line) {
  if (line.size() < kBlank.size() || line[0] != '|' || line[kBlank.size() - 1] != '|' ||
      line[kFeedColumn] != '.') {
    return std::nullopt;
  }
  Row row = 0;
  for (std::size_t track = 0; track < kTracks; ++track) {
    const char c = line[column_of(track)];
    if (is_hole(c)) {
      row = static_cast<Row>(row | 1U << track);
    } else if (c != ' ') {
      return std::nullopt;
    }
  }
  return row;
}

bool means_nothing(std::string_view line) {
  return line.empty() || line[0] == '#' || line.find_first_not_of('_') == std::string_view::npos;
}

std::string reason_in(std::string_view line) {
  const std::size_t colon = line.find(": ");
  return colon == std::string_view::npos ? "" : std::string(line.substr(colon + 2));
}

}  // namespace

std::string to_picture(const Tape& tape, RowRange rows) {
  const std::size_t last = std::min(rows.last, tape.rows.size());
  std::string picture(kEdge);
  picture.reserve(picture.size() + (last - std::min(rows.first, last)) * (kBlank.size() + 4));
  auto gap = std::ranges::lower_bound(tape.gaps, rows.first, {}, &Gap::row);
  for (std::size_t row = rows.first; row < last; ++row) {
    for (; gap != tape.gaps.end() && gap->row <= row; ++gap) append_gap(picture, *gap);
    append_row(picture, tape.rows[row]);
  }
  for (; gap != tape.gaps.end() && gap->row <= last; ++gap) append_gap(picture, *gap);
  return picture.append(kEdge);
}

bool is_picture(std::string_view bytes) {
  return bytes.starts_with(kEdge) || bytes.starts_with("___________\r\n");
}

tl::expected<Tape, PictureFault> from_picture(std::string_view picture) {
  Tape tape;
  for (std::size_t begin = 0; begin < picture.size();) {
    const std::size_t end = std::min(picture.find('\n', begin), picture.size());
    std::string_view line = picture.substr(begin, end - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with('~')) {
      tape.gaps.push_back({tape.rows.size(), reason_in(line)});
    } else if (const auto row = row_in(line)) {
      tape.rows.push_back(*row);
    } else if (!means_nothing(line)) {
      return tl::unexpected(PictureFault{begin, begin + line.size()});
    }
    begin = end + 1;
  }
  return tape;
}

}  // namespace dgt
