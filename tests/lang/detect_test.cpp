// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/detect.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "lang/text/reading.h"
#include "lang/text/render.h"
#include "lang/text/russian_pairs.h"
#include "tests/lang/comment_samples.h"

namespace dgt {
namespace {

using support::CommentSamples;
using support::Writing;

std::string in(Encoding encoding, std::string_view text) {
  return encode(text, {encoding, false, false, LineEnd::Lf, false}).bytes;
}

std::string told(std::string_view bytes, Language language = Language::English) {
  const SourceFile file("t.bgt", bytes);
  DiagnosticBag bag;
  report_reading(file, bag);
  return render(bag, {language, Colour::Plain});
}

// How detection did on a series of files.
struct Score {
  int files = 0;
  int right = 0;
  int doubted = 0;  // right, and yet the person is asked
  int wrong_and_sure = 0;

  void add(Encoding encoding, std::string_view bytes) {
    const EncodingGuess guess = detect_encoding(bytes);
    ++files;
    const bool sure = guess.confidence >= kSureEnough;
    if (guess.encoding == encoding) {
      ++right;
      if (!sure) ++doubted;
    } else if (sure) {
      ++wrong_and_sure;
    }
  }
};

constexpr std::array kCodePages = {Encoding::Windows1251, Encoding::Cp866, Encoding::Koi8R};

class DetectIn : public testing::TestWithParam<Encoding> {};
std::string page_name(const testing::TestParamInfo<Encoding>& page) {
  std::string name;
  for (const char c : name_of(page.param)) {
    if (c != '-') name += c;
  }
  return name;
}
INSTANTIATE_TEST_SUITE_P(CodePages, DetectIn, testing::ValuesIn(kCodePages), page_name);

TEST_P(DetectIn, CommentsOfTwentyLettersAreReadRightly) {
  for (const Writing writing : {Writing::Sentence, Writing::Small, Writing::Capitals}) {
    CommentSamples samples(1);
    Score score;
    for (int i = 0; i < 2000; ++i) score.add(GetParam(), in(GetParam(), samples.next(20, writing)));
    EXPECT_GE(score.right, 1990) << static_cast<int>(writing);
    EXPECT_LE(score.doubted, 20) << static_cast<int>(writing);
    EXPECT_EQ(score.wrong_and_sure, 0) << static_cast<int>(writing);
  }
}

TEST_P(DetectIn, ProgramsWithCommentsAreReadRightly) {
  CommentSamples samples(2);
  Score score;
  for (int i = 0; i < 1000; ++i) score.add(GetParam(), in(GetParam(), samples.program(20)));
  EXPECT_EQ(score.right, 1000);
  EXPECT_LE(score.doubted, 5);
}

TEST_P(DetectIn, SingleShortWordsAreReadRightlyOrDoubted) {
  Score score;
  for (const std::string_view word : {"деталь", "контур", "Начало", "КОНЕЦ", "паз", "отверстие",
                                      "проба", "Вася", "нож", "ЛИСТ", "вход", "не трогать"}) {
    score.add(GetParam(), in(GetParam(), std::string("K1 ' ").append(word)));
  }
  EXPECT_EQ(score.wrong_and_sure, 0);
  EXPECT_GE(score.right, 11);
}

TEST_P(DetectIn, LookAlikesInAProgramAreReadRightly) {
  EXPECT_EQ(detect_encoding(in(GetParam(), "В1=\"С2 Р4 L5,\"")).encoding, GetParam());
  EXPECT_EQ(detect_encoding(in(GetParam(), "К1 W0.1 Р1 L1 С2 L-2\nС3=Х5 Y0 R7")).encoding,
            GetParam());
}

TEST_P(DetectIn, ALongFileIsJudgedByItsBeginning) {
  CommentSamples samples(3);
  std::string text;
  while (text.size() < 300000) text += samples.program(20);
  EXPECT_EQ(detect_encoding(in(GetParam(), text)).encoding, GetParam());
}

TEST(Detect, DrawnFramesBelongToTheirCodePages) {
  const std::string_view framed = "╔════════╗\n║ ПЛИТА ║\n╚════════╝\n";
  EXPECT_EQ(detect_encoding(in(Encoding::Cp866, framed)).encoding, Encoding::Cp866);
  EXPECT_EQ(detect_encoding(in(Encoding::Koi8R, framed)).encoding, Encoding::Koi8R);
}

TEST(Detect, AsciiAndValidUtf8AreUtf8WithFullConfidence) {
  for (const std::string_view bytes : {"", "L1=X5", "' привет", "\xEF\xBB\xBFL1", "С", "№"}) {
    const EncodingGuess guess = detect_encoding(bytes);
    EXPECT_EQ(guess.encoding, Encoding::Utf8) << bytes;
    EXPECT_EQ(guess.confidence, 1.0) << bytes;
  }
}

TEST(Detect, AByteOrderMarkDecides) {
  EXPECT_EQ(detect_encoding("\xEF\xBB\xBF\xC2\xFB\xF0\xE5\xE7\xEA\xE0").encoding, Encoding::Utf8);
}

TEST(Detect, StrayBytesDoNotMakeUtf8ACodePage) {
  CommentSamples samples(4);
  for (int i = 0; i < 500; ++i) {
    std::string bytes = "' " + samples.next(20, Writing::Sentence);
    const auto at = static_cast<std::ptrdiff_t>(samples.below(3) == 0 ? bytes.size() : 0);
    bytes.insert(bytes.begin() + at, static_cast<char>(0x80 + samples.below(0x80)));
    EXPECT_EQ(detect_encoding(bytes).encoding, Encoding::Utf8) << bytes;
  }
}

TEST(Detect, NeverFailsOnRandomBytes) {
  CommentSamples random(5);
  for (int i = 0; i < 5000; ++i) {
    std::string bytes(random.below(200), '\0');
    for (char& byte : bytes) byte = static_cast<char>(random.below(256));
    const EncodingGuess guess = detect_encoding(bytes);
    EXPECT_GT(guess.confidence, 0.2);
    EXPECT_LE(guess.confidence, 1.0);
    EXPECT_NE(guess.encoding, guess.runner_up);
    EXPECT_EQ(told(bytes).empty(), told(bytes).find("DGT010") == std::string::npos);
  }
}

TEST(RussianPairs, TheTableIsWhatCountingOurNotesGives) {
  std::ifstream in(DGT_SOURCE_DIR "/tests/lang/data/shop_notes.txt", std::ios::binary);
  const std::string notes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  constexpr std::uint32_t kSigns = kWordBoundary + 1;
  std::array<std::array<double, kSigns>, kSigns> pairs{};
  std::array<double, kSigns> first{};
  std::array<double, kSigns> second{};
  double all = 0;
  std::uint32_t previous = kWordBoundary;
  for (std::size_t i = 0; i < notes.size();) {
    const CodePoint c = code_point_at(notes, i);
    const auto letter = russian_letter(c.value);
    const std::uint32_t next = letter ? letter->number : kWordBoundary;
    if (previous != kWordBoundary || next != kWordBoundary) {
      ++pairs.at(previous).at(next);
      ++first.at(previous);
      ++second.at(next);
      ++all;
    }
    previous = next;
    i += c.size;
  }
  ASSERT_GT(all, 4000);
  constexpr double kWeight = 4;
  for (std::uint32_t a = 0; a < kSigns; ++a) {
    for (std::uint32_t b = 0; b < kSigns; ++b) {
      const double share = (second.at(b) + 1) / (all + kSigns);
      const double likely = (pairs.at(a).at(b) + kWeight * share) / (first.at(a) + kWeight);
      const double bits = std::min<double>(kMostSurprising, std::round(-std::log2(likely)));
      EXPECT_EQ(surprise(a, b), bits) << a << " then " << b;
    }
  }
}

TEST(Reading, ADoubtfulEncodingIsAWarningThatNamesTheOption) {
  EXPECT_EQ(told("K1 ' \xE0\n"),
            "t.bgt:1:6: warning: read as windows-1251 with 48 % confidence; if it is cp866, say "
            "--encoding cp866 [DGT0108]\nK1 ' а\n     ^\n");
  EXPECT_EQ(told("K1 ' \xE0\n", Language::Russian),
            "t.bgt:1:6: warning: прочитано как windows-1251, уверенность 48 %; если это cp866, "
            "укажите --encoding cp866 [DGT0108]\nK1 ' а\n     ^\n");
  EXPECT_EQ(told("L1=X5 ' \xC2\xFB\xF0\xE5\xE7\xEA\xE0"), "") << "no doubt, no word";
}

TEST(Reading, StrayBytesAreLocatedErrorsWithTheirValues) {
  EXPECT_EQ(told("L1=X5 ' длина\nL2=Y\xFF\xFE 7\n"),
            "t.bgt:2:5: error: the bytes FF FE are no text in utf-8 [DGT0102]\n"
            "L2=Y\uFFFD\uFFFD 7\n"
            "    ^~\n");
  EXPECT_EQ(told("L1=X5 ' длина\nL2=Y\xFF\xFE 7\n", Language::Russian),
            "t.bgt:2:5: error: байты FF FE не являются текстом в кодировке utf-8 [DGT0102]\n"
            "L2=Y\uFFFD\uFFFD 7\n"
            "    ^~\n");
}

TEST(Reading, ACodePageHasStrayBytesToo) {
  const SourceFile file("t.bgt", "L1=X5\r\nL2=Y\x98 7 ' \xE4\xEB\xE8\xED\xE0",
                        Encoding::Windows1251);
  DiagnosticBag bag;
  report_reading(file, bag);
  EXPECT_EQ(render(bag),
            "t.bgt:2:5: error: the bytes 98 are no text in windows-1251 [DGT0102]\n"
            "L2=Y\uFFFD 7 ' длина\n    ^\n");
}

TEST(Reading, AForcedEncodingIsNotDoubted) {
  const SourceFile file("t.bgt", "K1 ' \xE0", Encoding::Cp866);
  DiagnosticBag bag;
  report_reading(file, bag);
  EXPECT_TRUE(bag.empty());
  EXPECT_EQ(file.text(), "K1 ' р");
}

TEST(Reading, Utf16IsOneError) {
  EXPECT_EQ(told(std::string_view("\xFF\xFEL\0001\0", 6)),
            "t.bgt:1:1: error: the file is UTF-16; save it as UTF-8 [DGT0109]\n\n^\n");
}

}  // namespace
}  // namespace dgt
