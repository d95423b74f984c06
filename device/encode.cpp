// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/encode.h"

#include <algorithm>
#include <array>

#include "device/checksum.h"
#include "device/lettering.h"
#include "device/transliterate.h"

namespace dgt {
namespace {

/// Between lettering, checksum and `%`, so that a person sees where one ends.
constexpr std::size_t kApart = 10;

/// The row of each byte that is punched as it is; blank for line ends and all others.
constexpr auto kRowOfByte = [] {
  std::array<Row, 256> rows{};
  for (int code = 0; code < 128; ++code) {
    const auto character = static_cast<char>(code);
    if (is_punchable(character)) rows.at(static_cast<std::size_t>(code)) = row_of(character);
  }
  return rows;
}();

Row plain_row(char byte) { return kRowOfByte[static_cast<unsigned char>(byte)]; }

/// Appends the rows of the program's text.
class Encoder {
 public:
  Encoder(std::string_view text, const TapeFormat& format, EncodedTape& made)
      : text_(text), format_(format), made_(made) {}

  void encode() {
    while (at_ < text_.size()) {
      append_plain();
      if (at_ == text_.size()) break;
      if (text_[at_] == '\n' || text_[at_] == '\r') {
        end_line();
      } else {
        append_unpunchable();
      }
    }
  }
  void append_line_end() {
    if (format_.line_end == TapeLineEnd::CrLf) made_.rows.push_back(kCarriageReturn);
    made_.rows.push_back(kLineFeed);
  }

 private:
  void append_plain() {
    const auto first = text_.begin() + static_cast<std::ptrdiff_t>(at_);
    const auto last =
        std::find_if(first, text_.end(), [](char byte) { return plain_row(byte) == kBlankRow; });
    const auto count = static_cast<std::size_t>(last - first);
    const std::size_t before = made_.rows.size();
    made_.rows.resize(before + count);
    std::transform(first, last, made_.rows.begin() + static_cast<std::ptrdiff_t>(before),
                   plain_row);
    at_ += count;
  }
  void end_line() {
    const bool is_pair = text_.substr(at_).starts_with("\r\n");
    at_ += is_pair ? 2 : 1;
    append_line_end();
  }
  void append_unpunchable() {
    const Utf8Character character = utf8_character(text_, at_);
    const auto spelled = format_.unpunchable == Unpunchable::Transliterate
                             ? transliterated(character.value)
                             : std::nullopt;
    const bool refused = format_.unpunchable != Unpunchable::Drop && !spelled;
    const std::string_view replacement = spelled.value_or("");
    for (const char c : replacement) made_.rows.push_back(row_of(c));
    note(at_, at_ + character.size, refused, replacement);
    at_ += character.size;
  }
  void note(std::size_t begin, std::size_t end, bool refused, std::string_view replacement) {
    made_.refused = made_.refused || refused;
    auto& runs = made_.unpunchable;
    if (!runs.empty() && runs.back().end == begin && runs.back().refused == refused) {
      runs.back().end = end;
      runs.back().replacement += replacement;
    } else if (runs.size() < EncodedTape::kMostRuns) {
      runs.push_back({begin, end, refused, std::string(replacement)});
    }
  }

  std::string_view text_;
  const TapeFormat& format_;
  EncodedTape& made_;
  std::size_t at_ = 0;
};

void append(std::vector<Row>& rows, const std::vector<Row>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

/// Leader, lettering and checksum; `program` begins with the `%`.
std::vector<Row> rows_before(std::span<const Row> program, const TapeFormat& format) {
  std::vector<Row> rows(rows_in(format.leader), kBlankRow);
  if (format.start == TapeStart::None) return rows;
  if (const std::vector<Row> header = lettering(format.header); !header.empty()) {
    append(rows, header);
    rows.insert(rows.end(), kApart, kBlankRow);
  }
  if (format.checksum == TapeChecksum::Line) {
    for (const char c : to_line(sum_of(program))) rows.push_back(row_of(c));
    append(rows, {kCarriageReturn, kLineFeed});
    rows.insert(rows.end(), kApart, kBlankRow);
  }
  return rows;
}

}  // namespace

EncodedTape encode_tape(std::string_view text, const TapeFormat& format) {
  EncodedTape made;
  const std::size_t trailer = rows_in(format.trailer);
  // Room for all that comes before in the usual case: long texts are moved at most once.
  made.rows.reserve(text.size() + text.size() / 8 + rows_in(format.leader) + trailer + 64);
  const bool plain = format.header.empty() && format.checksum == TapeChecksum::None;
  if (plain) made.rows.resize(rows_in(format.leader), kBlankRow);
  Encoder encoder(text, format, made);
  if (format.start == TapeStart::Percent && !text.starts_with('%')) {
    made.rows.push_back(kStartOfProgram);
    encoder.append_line_end();
  }
  encoder.encode();
  if (made.refused) {
    made.rows.clear();
    return made;
  }
  if (!plain) {
    const std::vector<Row> before = rows_before(made.rows, format);
    made.rows.insert(made.rows.begin(), before.begin(), before.end());
  }
  made.rows.insert(made.rows.end(), trailer, kBlankRow);
  made.ends_in_line = !text.empty() && text.back() != '\n' && text.back() != '\r';
  return made;
}

}  // namespace dgt
