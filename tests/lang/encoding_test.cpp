// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/encoding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace dgt {
namespace {

constexpr std::array kCodePages = {Encoding::Windows1251, Encoding::Cp866, Encoding::Koi8R};

std::string utf8(std::string_view bytes) { return decode(bytes, Encoding::Utf8).text; }

// Every byte that `page` assigns, line ends and the mark at the end of a file left out.
std::string repertoire(Encoding page) {
  std::string bytes;
  for (int byte = 0; byte < 256; ++byte) {
    if (byte == '\r' || byte == '\n' || byte == 0x1A) continue;
    const std::string one(1, static_cast<char>(byte));
    if (decode(one, page).strays.empty()) bytes += one;
  }
  return bytes;
}

TEST(Encoding, NamesReadBack) {
  for (const Encoding encoding : kEncodings) {
    EXPECT_EQ(encoding_named(name_of(encoding)), encoding);
  }
  EXPECT_EQ(encoding_named("UTF-8"), Encoding::Utf8);
  EXPECT_EQ(encoding_named("Windows-1251"), Encoding::Windows1251);
  EXPECT_EQ(encoding_named("latin1"), std::nullopt);
}

TEST(Decode, LeavesUtf8AsItIs) { EXPECT_EQ(utf8("L1=X5 ' привет 😀"), "L1=X5 ' привет 😀"); }

TEST(Decode, DropsTheByteOrderMarkAndRemembersIt) {
  const Decoded decoded = decode("\xEF\xBB\xBFL1", Encoding::Utf8);
  EXPECT_EQ(decoded.text, "L1");
  EXPECT_TRUE(decoded.form.byte_order_mark);
}

TEST(Decode, DropsTheMarkAtTheEndOfAFileAndRemembersIt) {
  const Decoded decoded = decode("L1\r\n\x1A", Encoding::Cp866);
  EXPECT_EQ(decoded.text, "L1\r\n");
  EXPECT_TRUE(decoded.form.end_of_file_mark);
  EXPECT_EQ(encode(decoded.text, decoded.form).bytes, "L1\r\n\x1A");
}

TEST(Decode, PutsAReplacementForEveryInvalidByte) {
  EXPECT_EQ(utf8("a\xFFz"), "a\uFFFDz");
  EXPECT_EQ(utf8("\xC0\x80"), "\uFFFD\uFFFD") << "overlong";
  EXPECT_EQ(utf8("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD") << "surrogate";
  EXPECT_EQ(utf8("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD") << "past the last character";
  EXPECT_EQ(utf8("\xD0"), "\uFFFD") << "cut off";
  EXPECT_EQ(decode("\x98", Encoding::Windows1251).text, "\uFFFD") << "not assigned";
}

TEST(Decode, ListsStrayBytesByRuns) {
  const Decoded decoded = decode(
      "a\xFF\xFE"
      "b\xD0",
      Encoding::Utf8);
  const std::vector<StrayBytes> expected = {{1, 7, "\xFF\xFE"}, {8, 11, "\xD0"}};
  EXPECT_EQ(decoded.strays, expected);
}

TEST(Decode, AReplacementCharacterInTheTextIsNoStray) {
  EXPECT_TRUE(decode("a\uFFFDz", Encoding::Utf8).strays.empty());
}

TEST(Decode, ReadsTheCodePages) {
  EXPECT_EQ(decode("\xC2\xFB\xF0\xE5\xE7\xEA\xE0 \xB8\xA8 \xB9", Encoding::Windows1251).text,
            "Вырезка ёЁ №");
  EXPECT_EQ(decode("\x82\xEB\xE0\xA5\xA7\xAA\xA0 \xF1\xF0 \xFC\xC4", Encoding::Cp866).text,
            "Вырезка ёЁ №─");
  EXPECT_EQ(decode("\xF7\xD9\xD2\xC5\xDA\xCB\xC1 \xA3\xB3 \x80", Encoding::Koi8R).text,
            "Вырезка ёЁ ─");
}

TEST(Decode, KnowsTheLineEnds) {
  const auto form = [](std::string_view bytes) { return decode(bytes, Encoding::Utf8).form; };
  EXPECT_EQ(form("a").line_end, LineEnd::Lf);
  EXPECT_EQ(form("a\nb\n").line_end, LineEnd::Lf);
  EXPECT_EQ(form("a\r\nb").line_end, LineEnd::CrLf);
  EXPECT_EQ(form("a\rb\r").line_end, LineEnd::Cr);
  EXPECT_FALSE(form("a\r\nb\r\n").mixed_line_ends);
  EXPECT_TRUE(form("a\r\nb\r\nc\n").mixed_line_ends);
  EXPECT_EQ(form("a\r\nb\r\nc\n").line_end, LineEnd::CrLf);
}

TEST(Encode, WritesTheLineEndsOfTheForm) {
  const std::string text = "a\nb\r\nc\rd\n\ne";
  const auto written = [&](LineEnd end) {
    return encode(text, {Encoding::Utf8, false, false, end, false}).bytes;
  };
  EXPECT_EQ(written(LineEnd::Lf), "a\nb\nc\nd\n\ne");
  EXPECT_EQ(written(LineEnd::CrLf), "a\r\nb\r\nc\r\nd\r\n\r\ne");
  EXPECT_EQ(written(LineEnd::Cr), "a\rb\rc\rd\r\re");
}

TEST(Encode, ReportsWhatTheEncodingLacks) {
  const Encoded encoded = encode("a«é№", {Encoding::Cp866, false, false, LineEnd::Lf, false});
  EXPECT_EQ(encoded.bytes, "a??\xFC");
  EXPECT_EQ(encoded.lost, (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(encode("\uFFFD😀", {Encoding::Windows1251, false, false, LineEnd::Lf, false}).bytes,
            "??");
}

TEST(Encode, UndoesDecodeOverTheWholeRepertoire) {
  EXPECT_EQ(repertoire(Encoding::Windows1251).size(), 252U) << "0x98 is not assigned";
  for (const Encoding page : kCodePages) {
    const std::string bytes = repertoire(page);
    const Decoded decoded = decode(bytes, page);
    const Encoded encoded = encode(decoded.text, decoded.form);
    EXPECT_EQ(encoded.bytes, bytes) << name_of(page);
    EXPECT_TRUE(encoded.lost.empty()) << name_of(page);
    EXPECT_EQ(decode(encoded.bytes, page).text, decoded.text) << name_of(page);
  }
}

TEST(Encode, UndoesDecodeOfEveryUnicodeCharacter) {
  std::string text;
  for (char32_t c = 1; c <= 0x10FFFF; ++c) {
    if (c == '\r' || c == '\n' || (c >= 0xD800 && c <= 0xDFFF)) continue;
    append_utf8(text, c);
  }
  const Decoded decoded = decode(text, Encoding::Utf8);
  EXPECT_TRUE(decoded.strays.empty());
  EXPECT_TRUE(encode(decoded.text, decoded.form).bytes == text);
}

TEST(Encode, UndoesDecodeOfRandomFilesOfOneLineEnd) {
  std::mt19937 random(7);
  for (int round = 0; round < 2000; ++round) {
    const Encoding page = kEncodings.at(random() % kEncodings.size());
    const std::string chosen = page == Encoding::Utf8 ? "ab \t" : repertoire(page);
    const std::string end = std::array{"\n", "\r\n", "\r"}.at(random() % 3);
    std::string bytes = page == Encoding::Utf8 && random() % 2 == 0 ? "\xEF\xBB\xBF" : "";
    for (std::size_t n = random() % 60; n > 0; --n) {
      const std::size_t at = random() % (chosen.size() + 5);
      bytes += at < chosen.size() ? chosen.substr(at, 1) : end;
      if (page == Encoding::Utf8 && random() % 5 == 0) bytes += "ёЖ№😀";
    }
    if (random() % 4 == 0) bytes += '\x1A';
    const Decoded decoded = decode(bytes, page);
    EXPECT_EQ(encode(decoded.text, decoded.form).bytes, bytes) << name_of(page);
  }
}

TEST(Decode, GivesValidTextWhateverTheBytes) {
  std::mt19937 random(11);
  for (int round = 0; round < 2000; ++round) {
    std::string bytes(random() % 80, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    for (const Encoding encoding : kEncodings) {
      const Decoded decoded = decode(bytes, encoding);
      EXPECT_TRUE(decode(decoded.text, Encoding::Utf8).strays.empty());
      std::size_t stray = 0;
      for (const StrayBytes& run : decoded.strays) {
        stray += run.bytes.size();
        EXPECT_EQ(run.end - run.begin, 3 * run.bytes.size());
      }
      if (encoding == Encoding::Windows1251) {
        EXPECT_EQ(stray, static_cast<std::size_t>(std::ranges::count(bytes, '\x98')));
      }
    }
  }
}

}  // namespace
}  // namespace dgt
