// SPDX-License-Identifier: GPL-3.0-or-later
//
// A reading of the bytes costs bits: what an ideal code for Russian shop texts would spend on it.
// The differences between readings are then logarithms of odds. Only signs outside ASCII cost
// anything, since ASCII reads alike in all encodings.
#include "lang/text/detect.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lang/text/russian_pairs.h"

namespace dgt {
namespace {

// Evidence enough: past so many bytes a text is judged by its beginning.
constexpr std::size_t kSampleSize = 1U << 15U;

// Bits, by judgement: the gaps between the classes matter, not their values.
constexpr double kNoText = 20;         // a byte that is no text
constexpr double kForeign = 12;        // a letter or sign no Russian shop uses
constexpr double kShopSign = 7;        // « » — № ° ± …
constexpr double kFrameSign = 9;       // a corner, a joint, the first sign of a stroke
constexpr double kStrokeGoesOn = 0.5;  // the same sign again
constexpr double kFrameTouchesLetter = 6;
constexpr double kYo = 4;               // ё, which most people write е
constexpr double kCapitalBegins = 2.5;  // a word
constexpr double kCapitalsGoOn = 0.3;   // in a word of capitals
constexpr double kSecondCapital = 2;
constexpr double kSmallBehindCapitals = 6;
constexpr double kCapitalInsideWord = 9;
// A single letter in a word of the program, `С2`: a Latin letter was meant.
constexpr double kLookAlikeCapital = 4;
constexpr double kLookAlikeSmall = 6.5;
constexpr double kNoLookAlike = 10;

// Before any evidence: the younger files are in Windows-1251, KOI8-R was never much at home on DOS.
constexpr std::array<double, kEncodings.size()> kRarity = {0, 0, 1, 2};

// Letter pairs depend on each other, so their bits say less than they add up to.
constexpr double kWeightOfEvidence = 0.5;

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

bool is_frame(char32_t c) { return c >= 0x2500 && c <= 0x25A0; }

bool is_shop_sign(char32_t c) {
  return std::u32string_view(U"«»—–№°±…“”„·×•§√²\u00A0").find(c) != std::u32string_view::npos;
}

bool is_word_of_program(char32_t c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '=' ||
         c == '-' || c == '"';
}

double cost_of_single(char32_t c) {
  if (std::u32string_view(U"АВСЕКМНОРТУХ").find(c) != std::u32string_view::npos) {
    return kLookAlikeCapital;
  }
  return std::u32string_view(U"асеорух").find(c) != std::u32string_view::npos ? kLookAlikeSmall
                                                                              : kNoLookAlike;
}

// Reads a text of signs from left to right and adds up what they cost.
class Reader {
 public:
  explicit Reader(std::u32string_view text) : text_(text) {}

  double cost() {
    for (at_ = 0; at_ < text_.size(); ++at_) {
      const auto letter = russian_letter(text_[at_]);
      if (letter) {
        read_letter(*letter);
      } else {
        end_word();
        if (text_[at_] >= 0x80) read_sign(text_[at_]);
      }
    }
    end_word();
    return cost_;
  }

 private:
  char32_t before() const { return at_ > 0 ? text_[at_ - 1] : U' '; }
  char32_t behind() const { return at_ + 1 < text_.size() ? text_[at_ + 1] : U' '; }

  bool stands_in_program() const {
    return previous_ == kWordBoundary && !russian_letter(behind()) &&
           (is_word_of_program(before()) || is_word_of_program(behind()));
  }

  void read_letter(const RussianLetter& letter) {
    if (stands_in_program()) {
      cost_ += cost_of_single(text_[at_]);
      return;
    }
    if (is_frame(before())) cost_ += kFrameTouchesLetter;
    cost_ += surprise(previous_, letter.number) + cost_of_case(letter.capital);
    if (text_[at_] == U'ё' || text_[at_] == U'Ё') cost_ += kYo;
    previous_ = letter.number;
    ++length_;
    if (letter.capital) ++capitals_;
  }

  double cost_of_case(bool capital) const {
    if (length_ == 0) return capital ? kCapitalBegins : 0;
    if (capitals_ < length_) return capital ? kCapitalInsideWord : 0;
    if (capital) return length_ == 1 ? kSecondCapital : kCapitalsGoOn;
    return length_ == 1 ? 0 : kSmallBehindCapitals;
  }

  void end_word() {
    if (previous_ == kWordBoundary) return;
    cost_ += surprise(previous_, kWordBoundary);
    previous_ = kWordBoundary;
    length_ = 0;
    capitals_ = 0;
  }

  void read_sign(char32_t c) {
    if (c == kReplacementCharacter) {
      cost_ += kNoText;
    } else if (is_frame(c)) {
      cost_ += before() == c ? kStrokeGoesOn : kFrameSign;
      if (russian_letter(before())) cost_ += kFrameTouchesLetter;
    } else {
      cost_ += is_shop_sign(c) ? kShopSign : kForeign;
    }
  }

  std::u32string_view text_;
  std::size_t at_ = 0;
  double cost_ = 0;
  std::uint32_t previous_ = kWordBoundary;
  std::uint32_t length_ = 0;    // of the word so far
  std::uint32_t capitals_ = 0;  // in it
};

// The bytes outside ASCII with one neighbour on either side, which is all that a cost depends on.
std::string telling_part(std::string_view bytes) {
  std::string part;
  bool behind_high = false;
  for (std::size_t i = 0; i < bytes.size() && part.size() < kSampleSize; ++i) {
    const bool high = !is_ascii(bytes[i]);
    const bool before_high = i + 1 < bytes.size() && !is_ascii(bytes[i + 1]);
    if (high || behind_high || before_high) part += bytes[i];
    behind_high = high;
  }
  return part;
}

double cost_in(Encoding encoding, std::string_view bytes) {
  const std::string text = decode(bytes, encoding).text;
  std::u32string signs;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint c = code_point_at(text, i);
    signs += c.value;
    i += c.size;
  }
  return Reader(signs).cost();
}

bool is_valid_utf8(std::string_view bytes) {
  for (std::size_t i = ascii_run(bytes, 0); i < bytes.size();) {
    const CodePoint c = code_point_at(bytes, i);
    if (!is_valid(c)) return false;
    i += c.size;
    i += ascii_run(bytes, i);
  }
  return true;
}

}  // namespace

EncodingGuess detect_encoding(std::string_view bytes) {
  if (is_valid_utf8(bytes) || bytes.starts_with("\xEF\xBB\xBF")) return {};
  const std::string part = telling_part(bytes);
  std::array<double, kEncodings.size()> cost{};
  std::ranges::transform(kEncodings, kRarity, cost.begin(),
                         [&](Encoding e, double rarity) { return rarity + cost_in(e, part); });
  auto order = kEncodings;
  const auto cost_of = [&](Encoding e) { return cost.at(static_cast<std::size_t>(e)); };
  std::ranges::stable_sort(order, {}, cost_of);
  double others = 0;
  for (const Encoding e : order) {
    others += std::exp2(kWeightOfEvidence * (cost_of(order[0]) - cost_of(e)));
  }
  return {order[0], order[1], 1 / others};
}

bool looks_like_utf16(std::string_view bytes) {
  const bool marked = bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
  return marked && bytes.substr(0, 16).find('\0') != std::string_view::npos;
}

Decoded decode(std::string_view bytes) { return decode(bytes, detect_encoding(bytes).encoding); }

}  // namespace dgt
