// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "lang/text/encoding.h"

namespace dgt {

/// What the bytes of a file say about its encoding.
struct EncodingGuess {
  Encoding encoding = Encoding::Utf8;
  Encoding runner_up = Encoding::Windows1251;  ///< the next likely one
  double confidence = 1.0;  ///< how likely `encoding` is beside the others, from 0 to 1
};

/// Below this confidence a person is told of the guess.
inline constexpr double kSureEnough = 0.95;

/// The encoding of a file.
///  (1) ASCII, a byte order mark and valid UTF-8 are UTF-8 with confidence 1: Russian text in a
///  code
///      page is practically never valid UTF-8 (a lead byte and a continuation there are a letter
///      and a sign that never meet).
///  (2) Otherwise each encoding reads the bytes, and the reading that surprises a Russian reader
///      least wins: by pairs of letters, capitals inside words, frames drawn beside letters, signs
///      of other alphabets; bytes that are no text surprise most.
///  (3) It never fails: bytes of no sense get some encoding and a low confidence.
[[nodiscard]] EncodingGuess detect_encoding(std::string_view bytes);

/// A file in UTF-16, with its mark, as some editors save what they call Unicode: none of ours.
[[nodiscard]] bool looks_like_utf16(std::string_view bytes);

/// decode() in the encoding that detect_encoding() finds.
[[nodiscard]] Decoded decode(std::string_view bytes);

}  // namespace dgt
