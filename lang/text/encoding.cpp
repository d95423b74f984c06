// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/encoding.h"

#include <algorithm>

#include "kernel/check.h"

namespace dgt {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr char kEndOfFileMark = '\x1A';

constexpr std::array<std::string_view, kEncodings.size()> kNames = {"utf-8", "windows-1251",
                                                                    "cp866", "koi8-r"};

// What the bytes 0x80 to 0xFF stand for; U+FFFD where nothing is assigned.
constexpr std::u16string_view kWindows1251 =
    u"ЂЃ‚ѓ„…†‡€‰Љ‹ЊЌЋЏђ‘’“”•–—\uFFFD™љ›њќћџ\u00A0ЎўЈ¤Ґ¦§Ё©Є«¬\u00AD®Ї°±Ііґµ¶·ё№є»јЅѕї"
    u"АБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯабвгдежзийклмнопрстуфхцчшщъыьэюя";
constexpr std::u16string_view kCp866 =
    u"АБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯабвгдежзийклмноп░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄"
    u"▌▐▀"
    u"рстуфхцчшщъыьэюяЁёЄєЇїЎў°∙·√№¤■\u00A0";
constexpr std::u16string_view kKoi8R =
    u"─│┌┐└┘├┤┬┴┼▀▄█▌▐░▒▓⌠■∙√≈≤≥\u00A0⌡°²·÷═║╒ё╓╔╕╖╗╘╙╚╛╜╝╞╟╠╡Ё╢╣╤╥╦╧╨╩╪╫╬©"
    u"юабцдефгхийклмнопярстужвьызшэщчъЮАБЦДЕФГХИЙКЛМНОПЯРСТУЖВЬЫЗШЭЩЧЪ";
static_assert(kWindows1251.size() == 128 && kCp866.size() == 128 && kKoi8R.size() == 128);

std::u16string_view upper_half(Encoding encoding) {
  switch (encoding) {
    case Encoding::Windows1251:
      return kWindows1251;
    case Encoding::Cp866:
      return kCp866;
    case Encoding::Koi8R:
      return kKoi8R;
    case Encoding::Utf8:
      break;
  }
  DGT_CHECK(false);
  return {};
}

// One character of the file: what it stands for, how many bytes it takes.
CodePoint character_at(std::string_view bytes, std::size_t offset, Encoding encoding) {
  if (encoding == Encoding::Utf8) return code_point_at(bytes, offset);
  const auto byte = static_cast<unsigned char>(bytes[offset]);
  return {byte < 0x80 ? byte : static_cast<char32_t>(upper_half(encoding)[byte - 0x80U]), 1};
}

void append_stray(Decoded& decoded, char byte) {
  const auto begin = static_cast<std::uint32_t>(decoded.text.size());
  append_utf8(decoded.text, kReplacementCharacter);
  const auto end = static_cast<std::uint32_t>(decoded.text.size());
  if (decoded.strays.empty() || decoded.strays.back().end != begin) {
    decoded.strays.push_back({begin, end, std::string(1, byte)});
  } else {
    decoded.strays.back().end = end;
    decoded.strays.back().bytes += byte;
  }
}

// Runs of ASCII, which most of a program is, are copied whole.
void append_text(Decoded& decoded, std::string_view bytes) {
  decoded.text.reserve(bytes.size());
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t run = ascii_run(bytes, i);
    decoded.text.append(bytes, i, run);
    i += run;
    if (i == bytes.size()) break;
    const CodePoint c = character_at(bytes, i, decoded.form.encoding);
    if (is_valid(c)) {
      append_utf8(decoded.text, c.value);
    } else {
      append_stray(decoded, bytes[i]);
    }
    i += c.size;
  }
}

void note_line_ends(TextForm& form, std::string_view text) {
  const auto line_feeds = static_cast<std::size_t>(std::ranges::count(text, '\n'));
  const auto returns = static_cast<std::size_t>(std::ranges::count(text, '\r'));
  std::size_t pairs = 0;
  if (returns > 0) {
    for (std::size_t i = 1; i < text.size(); ++i)
      pairs += text[i - 1] == '\r' && text[i] == '\n' ? 1 : 0;
  }
  std::array<std::size_t, 3> count{};
  count.at(static_cast<std::size_t>(LineEnd::Lf)) = line_feeds - pairs;
  count.at(static_cast<std::size_t>(LineEnd::CrLf)) = pairs;
  count.at(static_cast<std::size_t>(LineEnd::Cr)) = returns - pairs;
  const auto most = std::ranges::max_element(count);
  form.line_end = static_cast<LineEnd>(most - count.begin());
  form.mixed_line_ends = std::ranges::count(count, 0U) < 2;
}

std::string_view bytes_of(LineEnd end) {
  switch (end) {
    case LineEnd::CrLf:
      return "\r\n";
    case LineEnd::Cr:
      return "\r";
    case LineEnd::Lf:
      break;
  }
  return "\n";
}

bool append_character(std::string& bytes, char32_t value, Encoding encoding) {
  if (encoding == Encoding::Utf8) {
    append_utf8(bytes, value);
    return true;
  }
  const std::u16string_view page = upper_half(encoding);
  const auto at = value < kReplacementCharacter ? page.find(static_cast<char16_t>(value))
                                                : std::u16string_view::npos;
  bytes += at == std::u16string_view::npos ? '?' : static_cast<char>(0x80 + at);
  return at != std::u16string_view::npos;
}

}  // namespace

std::string_view name_of(Encoding encoding) {
  return kNames.at(static_cast<std::size_t>(encoding));
}

std::optional<Encoding> encoding_named(std::string_view name) {
  const std::string folded = fold_case(name);
  for (const Encoding encoding : kEncodings) {
    if (name_of(encoding) == folded) return encoding;
  }
  return std::nullopt;
}

Decoded decode(std::string_view bytes, Encoding encoding) {
  Decoded decoded;
  decoded.form.encoding = encoding;
  if (encoding == Encoding::Utf8 && bytes.starts_with(kByteOrderMark)) {
    decoded.form.byte_order_mark = true;
    bytes.remove_prefix(kByteOrderMark.size());
  }
  if (bytes.ends_with(kEndOfFileMark)) {
    decoded.form.end_of_file_mark = true;
    bytes.remove_suffix(1);
  }
  append_text(decoded, bytes);
  note_line_ends(decoded.form, decoded.text);
  return decoded;
}

Encoded encode(std::string_view text, const TextForm& form) {
  Encoded encoded;
  encoded.bytes.reserve(text.size());
  if (form.byte_order_mark) encoded.bytes = kByteOrderMark;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint c = code_point_at(text, i);
    if (c.value == '\r' && i + 1 < text.size() && text[i + 1] == '\n') {
      ++i;  // the line end is written for its second half
      continue;
    }
    if (c.value == '\r' || c.value == '\n') {
      encoded.bytes += bytes_of(form.line_end);
    } else if (c.value < 0x80) {
      encoded.bytes += static_cast<char>(c.value);
    } else if (!append_character(encoded.bytes, c.value, form.encoding)) {
      encoded.lost.push_back(static_cast<std::uint32_t>(i));
    }
    i += c.size;
  }
  if (form.end_of_file_mark) encoded.bytes += kEndOfFileMark;
  return encoded;
}

}  // namespace dgt
