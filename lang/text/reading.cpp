// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dgt {
namespace {

constexpr std::size_t kMaxBytesShown = 8;

// `98 FF`, the beginning of a long run.
std::string in_hexadecimal(std::string_view bytes) {
  std::string shown;
  for (const char byte : bytes.substr(0, kMaxBytesShown)) {
    if (!shown.empty()) shown += ' ';
    shown += fmt::format("{:02X}", static_cast<unsigned char>(byte));
  }
  return bytes.size() > kMaxBytesShown ? shown + " …" : shown;
}

void report_doubt(const SourceFile& file, const EncodingGuess& guess, DiagnosticBag& bag) {
  const std::string_view text = file.text();
  const auto high =
      std::ranges::find_if(text, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
  const auto begin = static_cast<std::uint32_t>(high - text.begin());
  const auto percent = static_cast<int>(std::floor(guess.confidence * 100));
  bag.add({Message::UncertainEncoding,
           {&file, begin, begin + code_point_at(text, begin).size},
           {std::string(name_of(guess.encoding)), std::string(name_of(guess.runner_up)),
            std::to_string(percent)}});
}

}  // namespace

void report_reading(const SourceFile& file, DiagnosticBag& bag) {
  if (file.is_utf16()) bag.add({Message::Utf16File, {&file, 0, 0}, {}});
  if (file.guess() && file.guess()->confidence < kSureEnough) {
    report_doubt(file, *file.guess(), bag);
  }
  for (const StrayBytes& run : file.strays()) {
    if (bag.error_count() > DiagnosticBag::kMaxKept) break;  // nobody reads on
    bag.add({Message::UndecodableText,
             {&file, run.begin, run.end},
             {in_hexadecimal(run.bytes), std::string(name_of(file.form().encoding))}});
  }
}

}  // namespace dgt
