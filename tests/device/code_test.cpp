// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs onto tape and back.
#include <gmock/gmock.h>

#include "tests/device/tapes.h"

namespace dgt {
namespace {

using support::random_text;
using support::short_format;
using support::tape_of;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<Row> rows_of(std::string_view codes) {
  std::vector<Row> rows;
  for (const char c : codes) rows.push_back(row_of(c));
  return rows;
}
TapeFormat bare() {
  TapeFormat format;
  format.leader = format.trailer = 0;
  return format;
}
TapeFormat without_start() {
  TapeFormat format = bare();
  format.start = TapeStart::None;
  return format;
}
DecodedTape decoded(std::string_view codes, const TapeFormat& format) {
  return decode_tape({rows_of(codes), {}}, format);
}
std::string text_of(std::string_view codes) { return decoded(codes, without_start()).text; }
std::string back(std::string_view text, const TapeFormat& format = {}) {
  const DecodedTape made = decode_tape(tape_of(text, format), format);
  EXPECT_THAT(made.faults, IsEmpty()) << text;
  return made.text;
}

TEST(TapeEncoding, LaysOutLeaderStartProgramTrailer) {
  TapeFormat format;
  format.leader = 5;
  format.trailer = 3;
  EXPECT_EQ(tape_of("G0\n", format).rows,
            (std::vector<Row>{0, 0, kStartOfProgram, kCarriageReturn, kLineFeed, row_of('G'),
                              row_of('0'), kCarriageReturn, kLineFeed, 0, 0}));
}

TEST(TapeEncoding, LeadersAreAtLeastAsLongAsAsked) {
  EXPECT_EQ(rows_in(0), 0U);
  EXPECT_EQ(rows_in(1), 1U);
  EXPECT_EQ(rows_in(254), 100U);
  EXPECT_EQ(rows_in(255), 101U);
}

TEST(TapeEncoding, AnyLineEndBecomesTheTapes) {
  TapeFormat format = without_start();
  EXPECT_EQ(tape_of("A\nB\r\nC\rD\n\nE", format).rows, rows_of("A\r\nB\r\nC\r\nD\r\n\r\nE"));
  format.line_end = TapeLineEnd::Lf;
  EXPECT_EQ(tape_of("A\nB\r\nC\rD\n\nE", format).rows, rows_of("A\nB\nC\nD\n\nE"));
}

TEST(TapeEncoding, ALastLineWithoutEndIsTold) {
  EXPECT_TRUE(encode_tape("M02", {}).ends_in_line);
  EXPECT_FALSE(encode_tape("M02\n", {}).ends_in_line);
  EXPECT_FALSE(encode_tape("", {}).ends_in_line);
}

TEST(TapeEncoding, WhatIsNotInTheCodeIsRefusedWithItsPlace) {
  const EncodedTape made = encode_tape("G0 (\xD0\xA0\xD0\xB5\xD0\xB7)\nx\x01\n", {});
  EXPECT_TRUE(made.refused);
  EXPECT_THAT(made.rows, IsEmpty());
  EXPECT_THAT(made.unpunchable,
              ElementsAre(UnpunchableRun{4, 10, true, ""}, UnpunchableRun{12, 14, true, ""}));
}

TEST(TapeEncoding, OnRequestItIsDropped) {
  TapeFormat format = without_start();
  format.unpunchable = Unpunchable::Drop;
  const EncodedTape made = encode_tape(
      "A\xD0\xA0z\xFF"
      "B\n",
      format);
  EXPECT_FALSE(made.refused);
  EXPECT_EQ(made.rows, rows_of("AB\r\n"));
  EXPECT_THAT(made.unpunchable, ElementsAre(UnpunchableRun{1, 5, false, ""}));
}

TEST(TapeEncoding, OnRequestItIsTransliteratedAndTheRestRefused) {
  TapeFormat format = without_start();
  format.unpunchable = Unpunchable::Transliterate;
  const EncodedTape made = encode_tape("(\xD0\xA9\xD0\xB8\xD1\x82 part)\n", format);
  EXPECT_EQ(made.rows, rows_of("(SHCHIT PART)\r\n"));
  EXPECT_THAT(made.unpunchable, ElementsAre(UnpunchableRun{1, 7, false, "SHCHIT"},
                                            UnpunchableRun{8, 12, false, "PART"}));
  EXPECT_TRUE(encode_tape("\xE4\xB8\xAD", format).refused);  // a Chinese letter
  EXPECT_TRUE(encode_tape("\xFF", format).refused);          // no UTF-8
  EXPECT_TRUE(encode_tape("\xED\xA0\x80", format).refused);  // half a pair of UTF-16
}

TEST(TapeDecoding, Each256RowValuesIsReadForWhatItIs) {
  for (int value = 0; value < 256; ++value) {
    const auto row = static_cast<Row>(value);
    const DecodedTape made = decode_tape({{row_of('A'), row, row_of('B')}, {}}, without_start());
    const auto expect = [&](const std::string& text, std::vector<TapeFault::Kind> faults) {
      EXPECT_EQ(made.text, text) << value;
      std::vector<TapeFault::Kind> seen;
      for (const TapeFault& fault : made.faults) {
        seen.push_back(fault.kind);
        EXPECT_EQ(fault.row, 1U);
        EXPECT_EQ(fault.offset, 1U);
        EXPECT_EQ(fault.seen, row);
      }
      EXPECT_EQ(seen, faults) << value;
    };
    switch (kind_of(row)) {
      case RowKind::Blank:
      case RowKind::RubOut:
        expect("AB", {});
        break;
      case RowKind::LineFeed:
      case RowKind::CarriageReturn:
        expect("A\nB", {});
        break;
      case RowKind::Character:
        expect({'A', code_of(row), 'B'}, {});
        break;
      case RowKind::Foreign:
        expect({'A', code_of(row), 'B'}, {TapeFault::Kind::ForeignCode});
        break;
      case RowKind::Damaged:
        expect(
            "A\xEF\xBF\xBD"
            "B",
            {TapeFault::Kind::Parity});
        break;
    }
    EXPECT_EQ(made.is_damaged(), kind_of(row) == RowKind::Damaged);
  }
}

TEST(TapeDecoding, LineEndsOfAllTeleprintersAreRead) {
  EXPECT_EQ(text_of("A\r\nB\r\n"), "A\nB\n");
  EXPECT_EQ(text_of("A\nB\n"), "A\nB\n");
  EXPECT_EQ(text_of("A\rB\r"), "A\nB\n");
  EXPECT_EQ(text_of("A\n\rB\n\r"), "A\nB\n");
  EXPECT_EQ(text_of("A\r\r\nB\r\r\n"), "A\nB\n");
  EXPECT_EQ(text_of("A\r\n\r\nB"), "A\n\nB");
  EXPECT_EQ(text_of("A\n\nB"), "A\n\nB");
  EXPECT_EQ(text_of(std::string_view("A\r\0\x7F\nB", 6)), "A\nB");
}

TEST(TapeDecoding, BlankTapeAndRubOutsInTheProgramMeanNothing) {
  EXPECT_EQ(text_of(std::string_view("G\0\0"
                                     "0\x7F\x7F"
                                     "1\n",
                                     8)),
            "G01\n");
}

TEST(TapeDecoding, ForeignCodesAreKeptAndToldOnce) {
  const DecodedTape made = decoded("ab\nc\n", without_start());
  EXPECT_EQ(made.text, "ab\nc\n");
  ASSERT_EQ(made.faults.size(), 1U);
  EXPECT_EQ(made.faults[0].count, 3U);
  EXPECT_FALSE(made.is_damaged());
}

TEST(TapeDecoding, WithoutAStartTheTextIsReadAndTheLackIsTold) {
  const DecodedTape made = decoded(std::string_view("\0\0G01\r\nM02\r\n", 12), bare());
  EXPECT_EQ(made.text, "G01\nM02\n");
  ASSERT_EQ(made.faults.size(), 1U);
  EXPECT_EQ(made.faults[0].kind, TapeFault::Kind::NoStart);
  EXPECT_EQ(made.faults[0].row, 2U);
}

TEST(TapeDecoding, LetteringOfOthersIsStrangeUnlessIgnored) {
  std::vector<Row> rows = {0, 0x11, 0x93, 0, 0x55, 0};
  for (const Row row : rows_of("%\r\nG0\r\n")) rows.push_back(row);
  TapeFormat format = bare();
  const DecodedTape strange = decode_tape({rows, {}}, format);
  ASSERT_EQ(strange.faults.size(), 2U);
  EXPECT_EQ(strange.faults[0].kind, TapeFault::Kind::StrayRows);
  EXPECT_EQ(strange.faults[0].row, 1U);
  EXPECT_EQ(strange.faults[0].count, 2U);
  EXPECT_EQ(strange.text, "G0\n");
  format.before_start = BeforeStart::Ignored;
  EXPECT_FALSE(decode_tape({rows, {}}, format).is_damaged());
  EXPECT_EQ(decode_tape({rows, {}}, format).text, "G0\n");
}

TEST(TapeDecoding, AnEmptyTapeIsTold) {
  for (const std::size_t length : {0U, 1U, 100U}) {
    const DecodedTape made = decode_tape({std::vector<Row>(length, kBlankRow), {}}, {});
    EXPECT_EQ(made.text, "");
    ASSERT_EQ(made.faults.size(), 1U);
    EXPECT_EQ(made.faults[0].kind, TapeFault::Kind::NothingPunched);
  }
}

TEST(TapeDecoding, GapsAreToldWhereTheyStand) {
  Tape tape{rows_of("%\r\nG01\r\nG02\r\n"), {{5, "a"}, {8, "b"}, {13, "c"}, {0, "d"}}};
  std::ranges::sort(tape.gaps, {}, &Gap::row);
  const DecodedTape made = decode_tape(tape, bare());
  std::vector<std::string> told;
  for (const TapeFault& fault : made.faults) {
    EXPECT_EQ(fault.kind, TapeFault::Kind::Gap);
    told.push_back(fault.detail + std::to_string(fault.row) + "@" + std::to_string(fault.offset));
  }
  EXPECT_THAT(told, ElementsAre("d0@0", "a5@2", "b8@4", "c13@8"));
  EXPECT_EQ(made.text, "G01\nG02\n");
}

TEST(TapeDecoding, OfVeryManyFaultsTheFirstAreKeptAndAllCounted) {
  const DecodedTape made = decode_tape({std::vector<Row>(5000, 1), {}}, without_start());
  EXPECT_EQ(made.faults.size(), DecodedTape::kMostFaults);
  EXPECT_EQ(made.damage_count, 5000U);
  EXPECT_EQ(made.text.size(), 15000U);
}

// --- laws of the round trip ---------------------------------------------------------------------

TEST(TapeRoundTrip, ThePercentLineIsTheTapesUnlessItIsOneOfAPair) {
  EXPECT_EQ(back("%\nG0\n"), "G0\n");
  EXPECT_EQ(back("%\nG0\n%\n"), "%\nG0\n%\n");
  EXPECT_EQ(back("%\nG0\n%"), "%\nG0\n%");
  EXPECT_EQ(back("%123\nG0\n"), "%123\nG0\n");
  EXPECT_EQ(back("G0 %\nG1\n"), "G0 %\nG1\n");
  EXPECT_EQ(back("%\n"), "");
  EXPECT_EQ(back(""), "");
  EXPECT_EQ(back("%\nG0\n", without_start()), "%\nG0\n");
}

bool is_start_line(const std::string& text) { return text.starts_with("%\n"); }
bool is_end_line(const std::string& text) {
  return text.ends_with("\n%") || text.ends_with("\n%\n");
}

TEST(TapeRoundTrip, AMillionRandomTapesComeBackIdentical) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 1'000'000; ++i) {
    const std::string text = random_text(random);
    TapeFormat format;
    format.leader = static_cast<std::uint32_t>(random() % 40);
    format.trailer = static_cast<std::uint32_t>(random() % 40);
    format.line_end = random() % 2 == 0 ? TapeLineEnd::Lf : TapeLineEnd::CrLf;
    format.start = random() % 4 == 0 ? TapeStart::None : TapeStart::Percent;
    if (random() % 16 == 0) format.checksum = TapeChecksum::Line;
    if (random() % 16 == 0) format.header = random_text(random);
    // A lone line `%` at one end only belongs to the tape; the test before this one has that.
    if (format.start == TapeStart::Percent && is_start_line(text) != is_end_line(text)) continue;
    const DecodedTape made = decode_tape(tape_of(text, format), format);
    const bool nothing = format.start == TapeStart::None && text.empty();
    ASSERT_EQ(made.faults.size(), nothing ? 1U : 0U) << i << "\n" << text;
    ASSERT_EQ(made.text, text) << i;
  }
}

TEST(TapeRoundTrip, AHeaderAndAChecksumAreReadBack) {
  TapeFormat format = short_format();
  format.header = "Korpus-2 (\xD0\xAF) v1.ess";
  format.checksum = TapeChecksum::Line;
  const DecodedTape made = decode_tape(tape_of("G01\nM02\n", format), format);
  EXPECT_THAT(made.faults, IsEmpty());
  EXPECT_EQ(made.header, "KORPUS-2 (IA) V1.ESS");
  ASSERT_TRUE(made.sum);
  EXPECT_EQ(made.sum->count, 13U);
  EXPECT_EQ(made.text, "G01\nM02\n");
}

TEST(TapeChecksums, TheSumIsTheKnownOne) {
  const std::string digits = "123456789";  // the check value of CRC-32
  EXPECT_EQ(sum_of({reinterpret_cast<const Row*>(digits.data()), digits.size()}).crc, 0xCBF43926U);
  EXPECT_EQ(to_line({0xCBF43926U, 9}), "CRC32 CBF43926 9");
  EXPECT_EQ(sum_in_line("CRC32 CBF43926 9"), (TapeSum{0xCBF43926U, 9}));
  for (const char* no_line :
       {"", "CRC32", "CRC32 ", "CRC32 CBF43926", "CRC32 CBF43926 ", "CRC32 CBF4392G 9",
        "CRC32 CBF43926 9A", "CRC33 CBF43926 9", "CRC32 CBF43926 99999999999999999999999"}) {
    EXPECT_FALSE(sum_in_line(no_line)) << no_line;
  }
}

TEST(TapeChecksums, OneThatIsWantedAndNotThereIsTold) {
  TapeFormat format = short_format();
  const Tape tape = tape_of("G01\n", format);
  format.checksum = TapeChecksum::Line;
  const DecodedTape made = decode_tape(tape, format);
  ASSERT_EQ(made.faults.size(), 1U);
  EXPECT_EQ(made.faults[0].kind, TapeFault::Kind::ChecksumMissing);
}

}  // namespace
}  // namespace dgt
