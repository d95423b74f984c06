// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/text/utf8.h"

namespace dgt {

/// The encodings in which twenty years of programs were written.
enum class Encoding : std::uint8_t { Utf8, Windows1251, Cp866, Koi8R };

inline constexpr std::array kEncodings = {Encoding::Utf8, Encoding::Windows1251, Encoding::Cp866,
                                          Encoding::Koi8R};

/// `utf-8`, `windows-1251`, `cp866`, `koi8-r`: as options and messages call them.
[[nodiscard]] std::string_view name_of(Encoding encoding);
/// The encoding of that name, in either case; nothing when there is none.
[[nodiscard]] std::optional<Encoding> encoding_named(std::string_view name);

enum class LineEnd : std::uint8_t { Lf, CrLf, Cr };

/// How a text lies in its file, besides the text itself.
struct TextForm {
  Encoding encoding = Encoding::Utf8;
  bool byte_order_mark = false;    ///< of UTF-8, at the beginning
  bool end_of_file_mark = false;   ///< Ctrl+Z at the end, as editors under DOS left it
  LineEnd line_end = LineEnd::Lf;  ///< the commonest; Lf in a file of one line
  bool mixed_line_ends = false;    ///< not all line ends are `line_end`

  friend bool operator==(const TextForm&, const TextForm&) = default;
};

/// A run of bytes that are no text in the file's encoding.
struct StrayBytes {
  std::uint32_t begin = 0;  ///< of their replacement characters in the decoded text
  std::uint32_t end = 0;
  std::string bytes;  ///< as they stand in the file

  friend bool operator==(const StrayBytes&, const StrayBytes&) = default;
};

/// A file's bytes as text.
struct Decoded {
  std::string text;  ///< valid UTF-8, with the line ends of the file, without marks
  TextForm form;
  std::vector<StrayBytes> strays;  ///< in their order; runs do not touch
};

/// Reads bytes as text in the given encoding.
///  (1) The text is valid UTF-8. Every byte that is no text becomes one kReplacementCharacter, so
///      columns still count characters.
///  (2) Without strays and mixed line ends, encode(text, form) gives the bytes back.
[[nodiscard]] Decoded decode(std::string_view bytes, Encoding encoding);

/// A text as bytes.
struct Encoded {
  std::string bytes;
  std::vector<std::uint32_t> lost;  ///< offsets in the text of characters that became `?`
};

/// Writes a text, valid UTF-8, in the given form; every line end becomes the form's. Characters
/// that the encoding lacks become `?` and are listed.
[[nodiscard]] Encoded encode(std::string_view text, const TextForm& form);

}  // namespace dgt
