// SPDX-License-Identifier: GPL-3.0-or-later
//
// dgt tape as a person and a script see it: files, and devices on pseudo-terminals with faults.
#include <gmock/gmock.h>

#include <algorithm>
#include <csignal>

#include "apps/driver/tape_images.h"
#include "apps/driver/tape_messages.h"
#include "apps/driver/tape_settings.h"
#include "lang/text/render.h"
#include "tests/support/command.h"
#include "tests/support/simulated_devices.h"

namespace dgt {
namespace {

using support::AtWork;
using support::Outcome;
using support::read_text;
using support::run_dgt;
using support::TemporaryFolder;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr int kDone = 0;
constexpr int kInputErrors = 1;
constexpr int kWrongUsage = 2;
constexpr int kFailure = 3;
constexpr int kNotVerified = 4;

std::string without(std::string text, const std::string& part) {
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part)) {
    text.erase(at, part.size());
  }
  return text;
}

/// A folder in which `dgt tape` works; messages without its name.
struct Bench {
  TemporaryFolder folder;

  Outcome tape(std::vector<std::string> words) const {
    words.insert(words.begin(), "tape");
    support::CommandOptions options;
    options.folder = folder.path();
    Outcome outcome = run_dgt(words, options);
    outcome.err = without(outcome.err, folder.name(""));
    return outcome;
  }
  [[nodiscard]] std::string text(const std::string& file) const {
    return read_text(folder.path() / file);
  }
  /// A tape without leader and trailer.
  void encode(const std::string& program, const std::string& file) const {
    const Outcome made = tape({"encode", folder.write("p.ess", program), "-o", file, "--set",
                               "tape.leader=0", "tape.trailer=0"});
    ASSERT_EQ(made.exit_code, kDone) << made.err;
  }
  /// With one hole of a row (from 0) flipped.
  void flip(const std::string& file, std::size_t row, unsigned char holes) const {
    std::string rows = text(file);
    rows.at(row) = static_cast<char>(rows.at(row) ^ holes);
    folder.write(file, rows);
  }
};

const std::string kProgram = "53\n-44+18\n+69-3\n54\n";

// --- files --------------------------------------------------------------------------------------

TEST(DgtTape, AProgramComesBackFromItsTapeInAnyForm) {
  const Bench bench;
  const std::string program = bench.folder.write("a.ess", kProgram);
  for (const std::string tape : {"a.tap", "a.txt"}) {
    const Outcome made = bench.tape({"encode", program, "-o", tape});
    EXPECT_EQ(made.exit_code, kDone);
    EXPECT_EQ(made.err, "dgt: note: a.ess: 420 rows, 1066.80 mm\n");
    const Outcome back = bench.tape({"decode", tape, "-o", "b.ess"});
    EXPECT_EQ(back.exit_code, kDone);
    EXPECT_EQ(back.err, "dgt: note: " + tape +
                            ": 420 rows, 1066.80 mm; the program lies on rows 198 to 223\n");
    EXPECT_EQ(bench.text("b.ess"), kProgram);
  }
  EXPECT_EQ(bench.tape({"decode", "a.tap", "--set", "line_end=crlf"}).out,
            "53\r\n-44+18\r\n+69-3\r\n54\r\n");
}

TEST(DgtTape, PicturesAreLettersSvgAndPng) {
  const Bench bench;
  bench.encode("G0\n", "a.tap");
  EXPECT_EQ(bench.tape({"show", "a.tap"}).out,
            "___________\n|o o  .o o|  %\n|o   o.o o|  CR\n|    o. o |  LF\n| o   .ooo|  G\n"
            "|  oo .   |  0\n|o   o.o o|  CR\n|    o. o |  LF\n___________\n");
  EXPECT_EQ(bench.tape({"show", "a.tap", "--rows", "4-5"}).out,
            "___________\n| o   .ooo|  G\n|  oo .   |  0\n___________\n");
  EXPECT_EQ(bench.tape({"show", "a.tap", "-o", "a.svg"}).exit_code, kDone);
  EXPECT_THAT(bench.text("a.svg"), AllOf(StartsWith("<svg "), HasSubstr("r=\"0.915\"")));
  EXPECT_EQ(bench.tape({"show", "a.tap", "-o", "a.png"}).exit_code, kDone);
  EXPECT_THAT(bench.text("a.png"), StartsWith("\x89PNG\r\n\x1A\n"));
}

TEST(DgtTape, APngThatWouldBeTooLargeIsRefused) {
  const Bench bench;
  bench.folder.write("long.tap", std::string(200'000, '\0'));
  const Outcome outcome = bench.tape({"show", "long.tap", "-o", "a.png"});
  EXPECT_EQ(outcome.exit_code, kWrongUsage);
  EXPECT_EQ(outcome.err,
            "dgt: error: 200000 rows are too many for one PNG; choose some with --rows, or write "
            "SVG\n");
  EXPECT_THAT(bench.folder.entries(), ElementsAre("long.tap"));
  EXPECT_EQ(bench.tape({"show", "long.tap", "-o", "a.png", "--rows", "1-500"}).exit_code, kDone);
}

TEST(DgtTape, WhatCannotBePunchedIsRefusedWithItsPlace) {
  const Bench bench;
  const std::string program =
      bench.folder.write("a.nc", "G0 X1 (\xD0\x94\xD1\x8B\xD1\x80\xD0\xB0 no 1)\nG1\n");
  const Outcome refused = bench.tape({"encode", program, "-o", "a.tap"});
  EXPECT_EQ(refused.exit_code, kInputErrors);
  EXPECT_EQ(refused.err,
            "a.nc:1:8: error: '\xD0\x94\xD1\x8B\xD1\x80\xD0\xB0 no' cannot be punched in ISO-7; "
            "'--set tape.unpunchable=drop' leaves such characters out, 'transliterate' spells them "
            "in Latin capitals [DGT2001]\n"
            "G0 X1 (\xD0\x94\xD1\x8B\xD1\x80\xD0\xB0 no 1)\n       ^~~~~~~\n");
  EXPECT_THAT(bench.folder.entries(), ElementsAre("a.nc"));

  const Outcome spelled =
      bench.tape({"encode", program, "-o", "a.tap", "--set", "tape.unpunchable=transliterate"});
  EXPECT_EQ(spelled.exit_code, kDone);
  EXPECT_THAT(spelled.err,
              HasSubstr("warning: '\xD0\x94\xD1\x8B\xD1\x80\xD0\xB0 no' is punched as 'DYRA NO' "
                        "[DGT2002]\n"));
  EXPECT_EQ(bench.tape({"decode", "a.tap"}).out, "G0 X1 (DYRA NO 1)\nG1\n");

  const Outcome dropped =
      bench.tape({"encode", program, "-o", "a.tap", "--set", "tape.unpunchable=drop"});
  EXPECT_THAT(dropped.err, HasSubstr("warning: '\xD0\x94\xD1\x8B\xD1\x80\xD0\xB0 no' is not "
                                     "punched [DGT2003]\n"));
  EXPECT_EQ(bench.tape({"decode", "a.tap"}).out, "G0 X1 (  1)\nG1\n");
}

TEST(DgtTape, ALastLineWithoutEndIsTold) {
  const Bench bench;
  const Outcome made = bench.tape({"encode", bench.folder.write("a.nc", "G0\nM02"), "-o", "a.tap"});
  EXPECT_EQ(made.exit_code, kDone);
  EXPECT_THAT(made.err, StartsWith("a.nc:2:4: warning: the last line has no end; many controls do "
                                   "not execute it [DGT2004]\nM02\n   ^\n"));
}

TEST(DgtTape, EveryDamagedRowIsToldAndNothingIsWritten) {
  const Bench bench;
  bench.encode(kProgram, "a.tap");
  bench.flip("a.tap", 8, 0x08);
  bench.flip("a.tap", 16, 0x01);
  const Outcome outcome = bench.tape({"decode", "a.tap", "-o", "a.ess"});
  EXPECT_EQ(outcome.exit_code, kInputErrors);
  EXPECT_EQ(outcome.err,
            "a.tap:2:2: error: row 9, 20.32 mm from the start: an odd number of holes (3 4 5 6 8) "
            "[DGT2005]\n-\xEF\xBF\xBD"
            "4+18\n ^\n"
            "a.tap:3:2: error: row 17, 40.64 mm from the start: an odd number of holes (1 2 3 5 6) "
            "[DGT2005]\n+\xEF\xBF\xBD"
            "9-3\n ^\n"
            "dgt: error: a.tap: 2 faults; nothing was written; '--salvage' writes what can be "
            "read\n");
  EXPECT_THAT(bench.folder.entries(), Not(testing::Contains("a.ess")));
  const Outcome salvaged = bench.tape({"decode", "a.tap", "-o", "a.ess", "--salvage"});
  EXPECT_EQ(salvaged.exit_code, kInputErrors);
  EXPECT_EQ(bench.text("a.ess"),
            "53\n-\xEF\xBF\xBD"
            "4+18\n+\xEF\xBF\xBD"
            "9-3\n54\n");
}

/// What decode says of a file with these bytes, without the summary at its end.
std::string told(const std::string& bytes, std::vector<std::string> more = {}) {
  const Bench bench;
  bench.folder.write("a.tap", bytes);
  more.insert(more.begin(), {"decode", "a.tap"});
  const Outcome outcome = bench.tape(more);
  return outcome.err.substr(0, std::min(outcome.err.find("dgt: "), outcome.err.size()));
}

TEST(DgtTape, EachKindOfDamageHasItsSentence) {
  EXPECT_EQ(told(std::string(10, '\0')),
            "a.tap:1:1: error: nothing is punched on this tape [DGT2007]\n\n^\n");
  EXPECT_EQ(
      told(std::string(10, '\0') + "G0\n"),
      "a.tap:1:1: error: no % begins a program; row 11, 25.40 mm from the start, is the first "
      "that is punched; '--set tape.start=none' reads tapes without % [DGT2008]\nG0\n^\n");
  EXPECT_EQ(
      told(std::string("\0\x11\x22\0\x33\0\xA5\nG0\n", 11)),
      "a.tap:1:1: error: before the %, from row 2, 2.54 mm from the start, 3 rows are neither "
      "blank nor lettering nor checksum; '--set tape.before_start=ignored' passes over them "
      "[DGT2009]\nG0\n^\n");
  EXPECT_EQ(
      told(std::string("\0\x11\x22\0\x33\0\xA5\nG0\n", 11), {"--set", "tape.before_start=ignored"}),
      "");
  EXPECT_EQ(told("\xA5\nG0\n", {"--set", "tape.checksum=line"}),
            "a.tap:1:1: error: the tape has no checksum, and tape.checksum wants one [DGT2011]\n"
            "G0\n^\n");
  EXPECT_EQ(told("\xA5\nG0 1\n"),
            "a.tap:1:3: error: row 5, 10.16 mm from the start: an odd number of holes (6) [DGT2005]"
            "\nG0\xEF\xBF\xBD\xEF\xBF\xBD\n  ^\n"
            "a.tap:1:4: error: row 6, 12.70 mm from the start: an odd number of holes (1 5 6) "
            "[DGT2005]\nG0\xEF\xBF\xBD\xEF\xBF\xBD\n   ^\n");
}

TEST(DgtTape, SmallLettersOnATapeAreADoubt) {
  const Bench bench;
  bench.folder.write("a.tap", "\xA5\nG0\xE1\x63\n");
  const Outcome outcome = bench.tape({"decode", "a.tap"});
  EXPECT_EQ(outcome.exit_code, kDone);
  EXPECT_EQ(outcome.out, "G0ac\n");
  EXPECT_THAT(outcome.err,
              StartsWith("a.tap:1:3: warning: row 5, 10.16 mm from the start, is 'a', which NC "
                         "programs do not use; such rows: 2 [DGT2012]\nG0ac\n  ^\n"));
}

TEST(DgtTape, TheChecksumFindsWhatParityCannot) {
  const Bench bench;
  bench.tape({"encode", bench.folder.write("a.ess", kProgram), "-o", "a.tap", "--set",
              "tape.checksum=line", "tape.leader=0", "--header", "A1"});
  const Outcome whole = bench.tape({"decode", "a.tap"});
  EXPECT_EQ(whole.exit_code, kDone) << whole.err;
  EXPECT_THAT(whole.err, HasSubstr("; \"A1\"\n"));
  const std::string rows = bench.text("a.tap");
  bench.flip("a.tap", rows.find('\xA5') + 8, 0x0C);
  const Outcome outcome = bench.tape({"verify", "a.tap"});
  EXPECT_EQ(outcome.exit_code, kInputErrors);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("a.tap:1:1: error: the checksum on the tape is "),
                                 HasSubstr(" of 26 rows; what is punched has "),
                                 HasSubstr(" of 26 [DGT2010]\n53\n^\n")));
}

TEST(DgtTape, AGapInAPictureIsDamage) {
  const Bench bench;
  bench.folder.write("a.txt",
                     "___________\n|o o  .o o|\n|    o. o |\n| o   .ooo|\n~~  gap: stopped\n"
                     "|  oo .   |\n___________\n");
  const Outcome outcome = bench.tape({"decode", "a.txt"});
  EXPECT_EQ(outcome.exit_code, kInputErrors);
  EXPECT_THAT(outcome.err,
              StartsWith("a.txt:1:2: error: behind row 3, 7.62 mm from the start, rows "
                         "may be missing: stopped [DGT2006]\nG0\n ^\n"));
}

TEST(DgtTape, ALineThatIsNoRowIsShown) {
  const Bench bench;
  bench.folder.write("a.txt", "___________\n|o o  .o o|\n|o o .o o|\n");
  const Outcome outcome = bench.tape({"show", "a.txt"});
  EXPECT_EQ(outcome.exit_code, kInputErrors);
  EXPECT_EQ(outcome.err,
            "a.txt:3:1: error: this is no row of a tape: | tracks 8 to 4 . tracks 3 to 1 |, o is a "
            "hole [DGT2013]\n|o o .o o|\n^~~~~~~~~~\n");
}

TEST(DgtTape, ADrawingOfATapeIsToldFromATape) {
  const Bench bench;
  bench.folder.write("a.ess", "+100+200\n");
  for (const std::string form : {"png", "svg"}) {
    const std::string drawing = "a." + form;
    ASSERT_EQ(bench.tape({"encode", "a.ess", "-o", drawing}).exit_code, kDone);
    const Outcome outcome = bench.tape({"decode", drawing});
    EXPECT_EQ(outcome.exit_code, kInputErrors);
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_EQ(outcome.err,
              drawing + ":1:1: error: this is a drawing (" + (form == "png" ? "PNG" : "SVG") +
                  "), which nothing reads back as a tape; a tape is rows ('.tap') or a "
                  "picture in letters ('.txt') [DGT2017]\n\n^\n");
  }
}

TEST(DgtTape, VerifyComparesWithAProgramAndWithATape) {
  const Bench bench;
  bench.encode(kProgram, "a.tap");
  bench.encode(kProgram, "b.tap");
  EXPECT_EQ(bench.tape({"verify", "a.tap", "--against", "p.ess"}).exit_code, kDone);
  EXPECT_EQ(bench.tape({"verify", "a.tap", "--against", "b.tap"}).exit_code, kDone);
  bench.flip("b.tap", 8, 0x0C);  // two holes: parity sees nothing
  EXPECT_EQ(bench.tape({"verify", "b.tap"}).exit_code, kDone);
  for (const std::string wanted : {"p.ess", "a.tap"}) {
    const Outcome outcome = bench.tape({"verify", "b.tap", "--against", wanted});
    EXPECT_EQ(outcome.exit_code, kNotVerified);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("b.tap:2:2: error: row 9, 20.32 mm from the start: 8 "
                                             "instead of 4 [DGT2014]\n-84+18\n ^\n"),
                                   HasSubstr("dgt: error: b.tap is not " + wanted + "\n")));
  }
  const std::string rows = bench.text("a.tap");
  bench.folder.write("b.tap", rows.substr(0, 8) + rows.substr(10));
  EXPECT_THAT(bench.tape({"verify", "b.tap", "--against", "a.tap"}).err,
              HasSubstr("b.tap:2:2: error: before row 9, 20.32 mm from the start, 4 4 is missing "
                        "[DGT2015]\n-+18\n ^\n"));
  EXPECT_THAT(bench.tape({"verify", "a.tap", "--against", "b.tap"}).err,
              HasSubstr("a.tap:2:2: error: row 9, 20.32 mm from the start: 4 4 should not be there "
                        "[DGT2016]\n-44+18\n ^\n"));
  bench.flip("b.tap", 8, 1);
  EXPECT_EQ(bench.tape({"verify", "b.tap", "--against", "a.tap"}).exit_code, kInputErrors);
}

TEST(DgtTape, WrongUsageIsNamed) {
  const Bench bench;
  const std::string program = bench.folder.write("a.ess", kProgram);
  const auto refused = [&](std::vector<std::string> words) {
    const Outcome outcome = bench.tape(std::move(words));
    EXPECT_EQ(outcome.exit_code, kWrongUsage) << outcome.err;
    return outcome.err;
  };
  EXPECT_THAT(refused({"punch", program}), HasSubstr("no punch is named; say '--device DEVICE'"));
  EXPECT_THAT(refused({"read"}), HasSubstr("no reader is named; say '--device DEVICE'"));
  EXPECT_THAT(refused({"punch", program, "-d", "x.tap", "--verify"}),
              HasSubstr("no reader is named; say '--reader DEVICE'"));
  EXPECT_THAT(refused({"duplicate", "--reader", program}), HasSubstr("say '--punch DEVICE'"));
  EXPECT_THAT(refused({"show", program, "--rows", "0-3"}), HasSubstr("'0-3' is no range of rows"));
  EXPECT_THAT(refused({"show", program, "--form", "text"}), HasSubstr("raw, picture, svg, png"));
  EXPECT_THAT(refused({"encode", program, "--set", "tape.start=none", "tape.checksum=line"}),
              HasSubstr("they need tape.start=percent"));
  EXPECT_THAT(refused({"encode", program, "--set", "tape.lead=1"}),
              HasSubstr("there is no setting 'tape.lead'; the nearest is 'tape.leader'"));
  EXPECT_THAT(refused({"punch", program, "-d", "x.tap", "--from-row", "9999"}),
              HasSubstr("no row 9999 on this tape of 420 rows"));
  EXPECT_THAT(refused({"simulate", "--reader-fault", "fold@3"}), HasSubstr("'fold@3' is no fault"));
}

// --- devices ------------------------------------------------------------------------------------

std::string long_program() {
  std::string text;
  for (int i = 0; i < 150; ++i)
    text += "+" + std::to_string(i) + "-" + std::to_string(i * 7) + "\n";
  return text;
}
Tape long_tape() { return {encode_tape(long_program(), {}).rows, {}}; }

struct Devices {
  Bench bench;
  AtWork at_work;

  explicit Devices(SimulatorSettings settings) : at_work(std::move(settings)) {
    bench.folder.write("long.ess", long_program());
  }
  Outcome tape(std::vector<std::string> words) {
    const std::string speed = std::to_string(support::kSimulatedSpeed);
    words.insert(words.end(),
                 {"--set", "punch.speed=" + speed, "reader.speed=" + speed, "punch.timeout=3",
                  "reader.timeout=0.5", "punch.device=" + at_work.punch().device,
                  "reader.device=" + at_work.reader().device});
    Outcome outcome = bench.tape(words);
    outcome.err = without(outcome.err, at_work.punch().device);
    outcome.err = without(outcome.err, at_work.reader().device);
    return outcome;
  }
};

SimulatorSettings reader_with(std::vector<std::string> faults) {
  SimulatorSettings settings;
  settings.tape = long_tape().rows;
  for (const std::string& fault : faults) {
    settings.reader_faults.push_back(*parse_simulated_fault(fault));
  }
  return settings;
}
SimulatorSettings punch_with(std::vector<std::string> faults) {
  SimulatorSettings settings;
  settings.loop = true;
  for (const std::string& fault : faults) {
    settings.punch_faults.push_back(*parse_simulated_fault(fault));
  }
  return settings;
}

TEST(DgtTapeDevices, ATapeIsPunchedReadBackAndRead) {
  Devices devices(punch_with({}));
  const Outcome punched = devices.tape({"punch", "long.ess", "--verify"});
  EXPECT_EQ(punched.exit_code, kDone) << punched.err;
  const Outcome read = devices.tape({"read", "-o", "back.ess"});
  EXPECT_EQ(read.exit_code, kDone) << read.err;
  EXPECT_EQ(devices.bench.text("back.ess"), long_program());
}

TEST(DgtTapeDevices, DuplicatesReadCheckPunchAndReadBack) {
  Devices devices(punch_with({}));
  devices.bench.tape({"encode", "long.ess", "-o", "long.tap"});
  const Outcome copied = devices.tape({"duplicate", "--reader", "long.tap"});
  EXPECT_EQ(copied.exit_code, kDone) << copied.err;
  EXPECT_EQ(devices.at_work.punched(), long_tape().rows);
}

/// The part that is kept: the tape up to the fault, and a gap that says why.
void expect_part_kept(Devices& devices, const Outcome& outcome) {
  EXPECT_THAT(outcome.err, HasSubstr("is kept in a.ess.part.txt; go on with '--resume "
                                     "a.ess.part.txt'\n"));
  const auto entries = devices.bench.folder.entries();
  EXPECT_THAT(entries, ElementsAre("a.ess.part.txt", "long.ess"));
  const auto kept = from_picture(devices.bench.text("a.ess.part.txt"));
  ASSERT_TRUE(kept);
  ASSERT_EQ(kept->gaps.size(), 1U);
  EXPECT_EQ(kept->gaps[0].row, kept->rows.size());
  EXPECT_TRUE(std::equal(kept->rows.begin(), kept->rows.end(), long_tape().rows.begin()));
}

void expect_read_fails(const std::string& fault, const std::string& why) {
  Devices devices(reader_with({fault}));
  const Outcome outcome = devices.tape({"read", "-o", "a.ess"});
  EXPECT_EQ(outcome.exit_code, kFailure);
  EXPECT_THAT(outcome.err, HasSubstr(why));
  expect_part_kept(devices, outcome);
}

TEST(DgtTapeDevices, ATornTapeInTheReader) {
  expect_read_fails("break@700",
                    "light in all tracks behind row 699, 1775.46 mm; the tape is torn");
}
TEST(DgtTapeDevices, ASlowReader) {
  expect_read_fails("slow@700", " rows a second instead of 6000 at row ");
}
TEST(DgtTapeDevices, AReaderThatHangs) {
  expect_read_fails("hang@700",
                    "the reader fell silent behind row 699, 1775.46 mm, where no tape "
                    "ends; stuck tape, or the reader hangs");
}
TEST(DgtTapeDevices, AReaderWithoutPower) {
  expect_read_fails("power@700", "the line is dead behind row ");
}

TEST(DgtTapeDevices, AFlippedHoleInTheReader) {
  Devices devices(reader_with({"flip@700:3"}));
  const Outcome outcome = devices.tape({"read", "-o", "a.ess"});
  EXPECT_EQ(outcome.exit_code, kFailure);
  EXPECT_THAT(outcome.err, HasSubstr("error: row 700, 1775.46 mm from the start: an odd number"));
  EXPECT_THAT(devices.bench.folder.entries(), ElementsAre("a.ess.part.txt", "long.ess"));
}

TEST(DgtTapeDevices, ALostAndADoubledRowInTheReaderAreFoundByReadingTwice) {
  for (const auto& [fault, code] :
       {std::pair("drop@700", "[DGT2016]"), std::pair("double@700", "[DGT2015]")}) {
    Devices devices(reader_with({fault}));
    const Outcome outcome = devices.tape({"read", "-o", "a.ess", "--verify"});
    EXPECT_EQ(outcome.exit_code, kFailure);
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr(code), HasSubstr("the second reading is not the first")));
  }
}

TEST(DgtTapeDevices, AReadingThatStoppedIsGoneOnWith) {
  Devices devices(reader_with({"hang@700"}));
  EXPECT_EQ(devices.tape({"read", "-o", "a.ess"}).exit_code, kFailure);
  const Outcome outcome = devices.tape({"read", "-o", "a.ess", "--resume", "a.ess.part.txt"});
  EXPECT_EQ(outcome.exit_code, kDone) << outcome.err;
  EXPECT_EQ(devices.bench.text("a.ess"), long_program());
}

TEST(DgtTapeDevices, APartOfAnotherTapeIsNotJoined) {
  Devices devices(reader_with({}));
  const std::string other(60, 'X');
  devices.bench.folder.write("other.txt",
                             to_picture({encode_tape(other + "\n", {}).rows, {{258, "stopped"}}}));
  const Outcome outcome = devices.tape({"read", "-o", "a.ess", "--resume", "other.txt"});
  EXPECT_EQ(outcome.exit_code, kFailure);
  EXPECT_THAT(outcome.err, HasSubstr("what was read now does not hold the end of other.txt"));
  EXPECT_THAT(devices.bench.folder.entries(),
              ElementsAre("a.ess.part.txt", "long.ess", "other.txt"));
}

TEST(DgtTapeDevices, WhatIsPunchedWronglyIsFoundByReadingBack) {
  for (const auto& [fault, code] :
       {std::pair("flip@700:3", "[DGT2014]"), std::pair("drop@700", "[DGT2015]"),
        std::pair("double@700", "[DGT2016]")}) {
    Devices devices(punch_with({fault}));
    const Outcome outcome = devices.tape({"punch", "long.ess", "--verify"});
    EXPECT_EQ(outcome.exit_code, kFailure);
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr(code), HasSubstr("the tape read back is not what was punched")));
  }
}

void expect_punch_fails(const std::string& fault, const std::string& why) {
  Devices devices(punch_with({fault}));
  const Outcome outcome = devices.tape({"punch", "long.ess"});
  EXPECT_EQ(outcome.exit_code, kFailure);
  EXPECT_THAT(outcome.err, HasSubstr(why));
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("whole blocks are on the tape up to row "),
                                 HasSubstr("punch the rest with '--from-row ")));
}
TEST(DgtTapeDevices, ATornTapeInThePunch) {
  expect_punch_fails("break@1200", "the punch has taken no row for 3 s behind row ");
}
TEST(DgtTapeDevices, APunchThatHangs) {
  expect_punch_fails("hang@1200", "the punch has taken no row for 3 s behind row ");
}
TEST(DgtTapeDevices, ASlowPunch) {
  expect_punch_fails("slow@600", " rows a second instead of 6000 at row ");
}
TEST(DgtTapeDevices, APunchWithoutPower) {
  expect_punch_fails("power@1200", "the line is dead behind row ");
}

TEST(DgtTapeDevices, APunchingThatStoppedIsGoneOnWithAtABlock) {
  const Bench bench;
  bench.folder.write("long.ess", long_program());
  // The first block behind the start: rows 198 to 200 are the start's.
  const Outcome outcome = bench.tape(
      {"punch", "long.ess", "-d", "rest.tap", "--from-row", "201", "--set", "tape.leader=100"});
  EXPECT_EQ(outcome.exit_code, kDone) << outcome.err;
  const Outcome rest = bench.tape({"decode", "rest.tap", "--set", "tape.start=none"});
  EXPECT_EQ(rest.exit_code, kDone) << rest.err;
  EXPECT_TRUE(long_program().ends_with(rest.out));
  EXPECT_GT(rest.out.size(), 0U);
}

TEST(DgtTapeDevices, NothingMovesForWhatCannotBePunched) {
  Devices devices(punch_with({}));
  const Outcome outcome =
      devices.tape({"punch", devices.bench.folder.write("bad.ess", long_program() + "x\n")});
  EXPECT_EQ(outcome.exit_code, kInputErrors);
  EXPECT_THAT(outcome.err, HasSubstr("bad.ess:151:1: error: 'x' cannot be punched"));
  const Outcome damaged =
      devices.tape({"punch", devices.bench.folder.write("bad.tap", "\x01\x02")});
  EXPECT_EQ(damaged.exit_code, kInputErrors);
}

TEST(DgtTapeDevices, DevicesThatAreNotThereAreNamed) {
  const Bench bench;
  bench.folder.write("a.ess", kProgram);
  const Outcome punched = bench.tape({"punch", "a.ess", "-d", "/dev/no-such-punch"});
  EXPECT_EQ(punched.exit_code, kFailure);
  EXPECT_EQ(punched.err,
            "dgt: error: /dev/no-such-punch cannot be opened: No such file or directory\n");
  const Outcome read = bench.tape({"read", "-d", "/dev/no-such-reader", "--lang", "ru"});
  EXPECT_EQ(read.exit_code, kFailure);
  EXPECT_THAT(read.err, HasSubstr("/dev/no-such-reader не открывается"));
  const Outcome full = bench.tape({"punch", "a.ess", "-d", "/dev/full"});
  EXPECT_EQ(full.exit_code, kFailure);
  EXPECT_THAT(full.err, HasSubstr("/dev/full failed behind row 0, 0.00 mm: No space left"));
}

TEST(DgtTapeSimulate, SaysTheNamesAndStopsInTime) {
  const Bench bench;
  const Outcome outcome = bench.tape({"simulate", "--seconds", "0.2"});
  EXPECT_EQ(outcome.exit_code, kDone);
  EXPECT_THAT(outcome.out,
              testing::MatchesRegex("punch /dev/pts/[0-9]+\nreader /dev/pts/[0-9]+\n"));
}

// --- settings -----------------------------------------------------------------------------------

TEST(TapeSettings, AMachineFileHasATableForEach) {
  const Bench bench;
  bench.folder.write("m.toml",
                     "[tape]\nleader = 10\ntrailer = 5\nline_end = 'lf'\nheader = 'name'\n"
                     "[punch]\ndevice = 'out.tap'\n[reader]\ndevice = 'out.tap'\ntimeout = 0.25\n");
  bench.folder.write("p.ess", "53\n");
  const Outcome punched = bench.tape({"punch", "p.ess", "--machine", "m.toml"});
  EXPECT_EQ(punched.exit_code, kDone) << punched.err;
  const Outcome read = bench.tape({"read", "--machine", "m.toml"});
  EXPECT_EQ(read.out, "53\n");
  EXPECT_THAT(read.err, HasSubstr("; \"P.ESS\"\n"));
}

TEST(TapeSettings, EachTakesItsValuesAndNoOthers) {
  const auto takes = [](const char* key, const char* value) {
    return with_setting(TapeSettings{}, {key, value}).has_value();
  };
  for (const char* good : {"0.1", "600", "0.125", "5"}) EXPECT_TRUE(takes("punch.timeout", good));
  for (const char* bad : {"0", "601", "0.0001", "", "x"})
    EXPECT_FALSE(takes("reader.timeout", bad));
  for (const char* bad : {"0", "1000000", "1.5", ""}) EXPECT_FALSE(takes("punch.speed", bad));
  for (const char* bad : {"111", "0", ""}) EXPECT_FALSE(takes("punch.baud", bad));
  EXPECT_FALSE(takes("tape.leader", "10001"));
  EXPECT_FALSE(takes("punch.device", ""));
  TapeSettings made;
  for (const auto& [key, value] :
       {std::pair("tape.start", "none"), std::pair("tape.unpunchable", "drop"),
        std::pair("tape.checksum", "line"), std::pair("tape.before_start", "ignored"),
        std::pair("punch.baud", "2400"), std::pair("punch.handshake", "rtscts"),
        std::pair("punch.buffer", "7"), std::pair("reader.speed", "300"),
        std::pair("reader.baud", "115200"), std::pair("reader.handshake", "none"),
        std::pair("reader.timeout", "1.5")}) {
    made = *with_setting(made, {key, value});
  }
  EXPECT_EQ(made.format.start, TapeStart::None);
  EXPECT_EQ(made.format.unpunchable, Unpunchable::Drop);
  EXPECT_EQ(made.format.checksum, TapeChecksum::Line);
  EXPECT_EQ(made.format.before_start, BeforeStart::Ignored);
  EXPECT_EQ(made.punch.line.baud, 2400U);
  EXPECT_EQ(made.punch.line.handshake, Handshake::RtsCts);
  EXPECT_EQ(made.punch.buffer, 7U);
  EXPECT_EQ(made.reader.speed, 300U);
  EXPECT_EQ(made.reader.line.baud, 115200U);
  EXPECT_EQ(made.reader.line.handshake, Handshake::None);
  EXPECT_EQ(made.reader.timeout, std::chrono::milliseconds(1500));
}

TEST(TapeMessages, AreRussianToo) {
  TapeFormat format;
  format.leader = 0;
  Tape tape{encode_tape("G0\n", format).rows, {}};
  tape.rows[3] ^= 1;
  const TapeProgram program = read_program("a.tap", tape, {});
  EXPECT_EQ(render(program.bag, {Language::Russian}),
            "a.tap:1:1: error: строка 4, 7.62 мм от начала: нечётное число отверстий (2 3 7) "
            "[DGT2005]\n\xEF\xBF\xBD"
            "0\n^\n");
}

}  // namespace
}  // namespace dgt
