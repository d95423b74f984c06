// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/text/detect.h"
#include "lang/text/encoding.h"

namespace dgt {

/// What a person calls a spot in a file. Lines and columns count from 1, columns and lengths in
/// code points.
struct Place {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  std::uint32_t length = 0;

  friend bool operator==(const Place&, const Place&) = default;
};

/// A source file in memory: its name as the user knows it, its text, its lines. LF, CRLF and CR end
/// a line. Ranges point into it, so it stays where it is.
class SourceFile {
 public:
  /// `bytes` as read from disk; decoded here, in the encoding that they look like when none is
  /// forced. The text of a file in UTF-16 is empty. At most 4 GiB of text (checked).
  SourceFile(std::string name, std::string_view bytes,
             std::optional<Encoding> forced = std::nullopt);
  SourceFile(const SourceFile&) = delete;
  SourceFile& operator=(const SourceFile&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Valid UTF-8 in any case.
  [[nodiscard]] std::string_view text() const { return read_.text; }
  /// How the text lay in the file; encode() writes it so again.
  [[nodiscard]] const TextForm& form() const { return read_.form; }
  /// Bytes that were no text.
  [[nodiscard]] const std::vector<StrayBytes>& strays() const { return read_.strays; }
  /// How the encoding was found; nothing when it was forced.
  [[nodiscard]] const std::optional<EncodingGuess>& guess() const { return guess_; }
  [[nodiscard]] bool is_utf16() const { return is_utf16_; }
  /// At least 1; a line end at the end of the file opens no further line.
  [[nodiscard]] std::uint32_t line_count() const {
    return static_cast<std::uint32_t>(line_starts_.size());
  }
  /// The text of line `line` (from 1) without its end.
  [[nodiscard]] std::string_view line_text(std::uint32_t line) const;
  /// Where line `line` (from 1) begins, as a byte offset into `text()`.
  [[nodiscard]] std::uint32_t line_start(std::uint32_t line) const {
    return line_starts_[line - 1];
  }
  /// The line that holds the byte offset.
  [[nodiscard]] std::uint32_t line_at(std::uint32_t offset) const;

 private:
  std::string name_;
  bool is_utf16_ = false;
  std::optional<EncodingGuess> guess_;
  Decoded read_;
  std::vector<std::uint32_t> line_starts_;
};

/// Bytes `begin` to `end` of a file's text. The file must outlive the range.
struct Range {
  const SourceFile* file = nullptr;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  [[nodiscard]] std::string_view text() const { return file->text().substr(begin, end - begin); }
  /// Line and column of the beginning; the length stops at the end of that line.
  [[nodiscard]] Place place() const;

  friend bool operator==(const Range&, const Range&) = default;
};

/// From the beginning of `a` to the end of `b`; `a` alone when `b` does not follow it in its file,
/// as happens where texts are put in place.
[[nodiscard]] inline Range join(const Range& a, const Range& b) {
  return a.file == b.file && b.end >= a.begin ? Range{a.file, a.begin, b.end} : a;
}
/// Whether `inner` is part of `outer`.
[[nodiscard]] inline bool lies_in(const Range& inner, const Range& outer) {
  return inner.file == outer.file && inner.begin >= outer.begin && inner.end <= outer.end;
}
/// The empty range behind `a`.
[[nodiscard]] inline Range behind(const Range& a) { return {a.file, a.end, a.end}; }

}  // namespace dgt
