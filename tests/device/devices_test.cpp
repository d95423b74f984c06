// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drivers over real terminals: a simulated punch and reader on pseudo-terminals, faults on command.
#include "device/devices.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <thread>

#include "device/compare.h"
#include "device/line_marks.h"
#include "device/run.h"
#include "device/simulator.h"
#include "tests/device/tapes.h"
#include "tests/support/command.h"
#include "tests/support/simulated_devices.h"

namespace dgt {
namespace {

using namespace std::chrono_literals;
using support::AtWork;
using support::kSimulatedSpeed;
using support::long_program;
using support::short_format;
using support::tape_of;
using support::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Kind = DeviceFault::Kind;

Tape long_tape() { return tape_of(long_program(60), short_format()); }
std::size_t middle() { return long_tape().rows.size() / 2; }

TapeReading read_from(const ReaderSettings& settings, const Watch& watch = {}) {
  auto reader = open_reader(settings);
  if (!reader) return {{}, reader.error()};
  return read_tape(**reader, settings, short_format(), watch);
}
tl::expected<void, PunchFailure> punch_to(const PunchSettings& settings,
                                          const std::vector<Row>& rows, const Watch& watch = {}) {
  auto punch = open_punch(settings);
  if (!punch) return tl::unexpected(PunchFailure{punch.error()});
  return punch_tape(**punch, rows, settings, watch);
}

SimulatorSettings reading(SimulatedFault::Kind kind) {
  SimulatorSettings settings;
  settings.tape = long_tape().rows;
  settings.reader_faults = {{kind, middle(), 3}};
  return settings;
}
SimulatorSettings punching(SimulatedFault::Kind kind) {
  SimulatorSettings settings;
  settings.punch_faults = {{kind, middle(), 3}};
  return settings;
}

// --- without a fault ----------------------------------------------------------------------------

TEST(ReaderOnALine, BringsAll256RowValues) {
  SimulatorSettings settings;
  for (int value = 0; value < 256; ++value) settings.tape.push_back(static_cast<Row>(value));
  settings.tape.insert(settings.tape.end(), 20, kBlankRow);
  const std::vector<Row> wanted = settings.tape;
  AtWork at_work(std::move(settings));
  const TapeReading made = read_from(at_work.reader());
  EXPECT_FALSE(made.fault);
  EXPECT_EQ(made.tape.rows, wanted);
  EXPECT_THAT(made.tape.gaps, IsEmpty());
}

TEST(PunchOnALine, TakesAll256RowValues) {
  std::vector<Row> rows;
  for (int value = 0; value < 256; ++value) rows.push_back(static_cast<Row>(value));
  AtWork at_work({});
  EXPECT_TRUE(punch_to(at_work.punch(), rows));
  EXPECT_EQ(at_work.punched(), rows);
}

TEST(PunchOnALine, ASlowerPunchStopsTheComputerAndNothingIsLost) {
  AtWork at_work({});
  PunchSettings settings = at_work.punch();
  settings.speed = 20'000;  // the simulated one does 6000
  EXPECT_TRUE(punch_to(settings, long_tape().rows));
  EXPECT_EQ(at_work.punched(), long_tape().rows);
}

TEST(PunchOnALine, KeepsThePace) {
  AtWork at_work({});
  PunchSettings settings = at_work.punch();
  settings.speed = 500;
  const std::vector<Row> rows(300, kBlankRow);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(punch_to(settings, rows));
  // A fiftieth of a second may be handed over beforehand.
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 550ms);
}

TEST(ReaderOnALine, ReadsTheSameTapeAgain) {
  SimulatorSettings settings;
  settings.tape = long_tape().rows;
  AtWork at_work(std::move(settings));
  EXPECT_EQ(read_from(at_work.reader()).tape, long_tape());
  EXPECT_EQ(read_from(at_work.reader()).tape, long_tape());
}

TEST(ReaderOnALine, ProgressIsToldAndAPersonMayStopIt) {
  SimulatorSettings settings;
  settings.tape = long_tape().rows;
  AtWork at_work(std::move(settings));
  std::size_t seen = 0;
  const TapeReading made = read_from(
      at_work.reader(), {[&](std::size_t rows) { seen = rows; }, [&] { return seen > 100; }});
  ASSERT_TRUE(made.fault);
  EXPECT_EQ(made.fault->kind, Kind::Cancelled);
  EXPECT_GT(seen, 100U);
  EXPECT_TRUE(std::equal(made.tape.rows.begin(), made.tape.rows.end(), long_tape().rows.begin()));
}

TEST(PunchOnALine, ProgressIsToldAndAPersonMayStopIt) {
  AtWork at_work({});
  std::size_t seen = 0;
  const auto made = punch_to(at_work.punch(), long_tape().rows,
                             {[&](std::size_t rows) { seen = rows; }, [&] { return seen > 700; }});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().fault.kind, Kind::Cancelled);
  EXPECT_EQ(made.error().fault.row, seen);
}

// --- each fault of the reader -------------------------------------------------------------------

TEST(ReaderFaults, AFlippedHoleIsReadAsItIs) {
  AtWork at_work(reading(SimulatedFault::Kind::Flip));
  const TapeReading made = read_from(at_work.reader());
  EXPECT_FALSE(made.fault);
  Tape wanted = long_tape();
  wanted.rows[middle()] ^= 1 << 2;
  EXPECT_EQ(made.tape, wanted);
  EXPECT_EQ(decode_tape(made.tape, short_format()).faults.at(0).row, middle());
}

TEST(ReaderFaults, ALostAndADoubledRowAreFoundByReadingTwice) {
  for (const auto kind : {SimulatedFault::Kind::Drop, SimulatedFault::Kind::Double}) {
    AtWork at_work(reading(kind));
    const TapeReading first = read_from(at_work.reader());
    const TapeReading second = read_from(at_work.reader());
    EXPECT_EQ(second.tape, long_tape());
    const TapeDifferences found = compare_rows(first.tape.rows, second.tape.rows);
    ASSERT_EQ(found.count, 1U);
    EXPECT_NEAR(static_cast<double>(found.rows[0].found_row), static_cast<double>(middle()), 1);
  }
}

/// What came before the fault is there, and nothing else.
void expect_rows_before_the_middle(const TapeReading& made, Kind kind) {
  ASSERT_TRUE(made.fault);
  EXPECT_EQ(made.fault->kind, kind);
  EXPECT_EQ(made.fault->row, made.tape.rows.size());
  const std::vector<Row> rows = long_tape().rows;
  EXPECT_EQ(made.tape.rows,
            std::vector<Row>(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(middle())));
}

TEST(ReaderFaults, ATornTapeIsNamed) {
  AtWork at_work(reading(SimulatedFault::Kind::Break));
  expect_rows_before_the_middle(read_from(at_work.reader()), Kind::Torn);
}

TEST(ReaderFaults, ASlowDriveIsNamed) {
  AtWork at_work(reading(SimulatedFault::Kind::Slow));
  const TapeReading made = read_from(at_work.reader());
  ASSERT_TRUE(made.fault);
  EXPECT_EQ(made.fault->kind, Kind::Slow);
  EXPECT_NEAR(made.fault->rate, kSimulatedSpeed * kSlowedDown, kSimulatedSpeed * kSlowedDown / 2);
  EXPECT_GE(made.tape.rows.size(), middle());
}

TEST(ReaderFaults, AReaderThatHangsFallsSilent) {
  AtWork at_work(reading(SimulatedFault::Kind::Hang));
  expect_rows_before_the_middle(read_from(at_work.reader()), Kind::Silent);
}

TEST(ReaderFaults, AReaderThatNeverStartsSendsNoRow) {
  SimulatorSettings settings = reading(SimulatedFault::Kind::Hang);
  settings.reader_faults[0].row = 0;
  AtWork at_work(std::move(settings));
  const TapeReading made = read_from(at_work.reader());
  ASSERT_TRUE(made.fault);
  EXPECT_EQ(made.fault->kind, Kind::NoRows);
}

TEST(ReaderFaults, APowerCutEndsTheLine) {
  AtWork at_work(reading(SimulatedFault::Kind::PowerCut));
  const TapeReading made = read_from(at_work.reader());
  ASSERT_TRUE(made.fault);
  EXPECT_EQ(made.fault->kind, Kind::Gone);
  // What the computer had not fetched yet is lost with the line.
  EXPECT_LE(made.tape.rows.size(), middle());
  EXPECT_GT(made.tape.rows.size(), 0U);
  EXPECT_TRUE(std::equal(made.tape.rows.begin(), made.tape.rows.end(), long_tape().rows.begin()));
}

// --- each fault of the punch --------------------------------------------------------------------

TEST(PunchFaults, WhatIsPunchedWronglyIsFoundByReadingBack) {
  for (const auto kind :
       {SimulatedFault::Kind::Flip, SimulatedFault::Kind::Drop, SimulatedFault::Kind::Double}) {
    SimulatorSettings settings = punching(kind);
    settings.loop = true;
    AtWork at_work(std::move(settings));
    ASSERT_TRUE(punch_to(at_work.punch(), long_tape().rows));
    std::this_thread::sleep_for(200ms);  // until the tape is in the reader
    const TapeReading made = read_from(at_work.reader());
    EXPECT_FALSE(made.fault);
    const TapeDifferences found = compare_rows(long_tape().rows, made.tape.rows);
    ASSERT_EQ(found.count, 1U);
    EXPECT_NEAR(static_cast<double>(found.rows[0].wanted_row), static_cast<double>(middle()), 1);
  }
}

/// The rows that are called surely punched are, and they are not many fewer than really are.
void expect_surely_punched(const std::vector<Row>& punched, const PunchFailure& failure) {
  EXPECT_LE(failure.punched, punched.size());
  EXPECT_GT(failure.punched, 0U);
  EXPECT_TRUE(std::equal(punched.begin(), punched.end(), long_tape().rows.begin()));
}

void expect_punch_fails(SimulatedFault::Kind fault, Kind kind) {
  AtWork at_work(punching(fault));
  PunchSettings settings = at_work.punch();
  settings.buffer = 500;  // what a busy computer leaves in the terminal's queue
  if (kind == Kind::Slow) settings.timeout = 10s;
  const auto made = punch_to(settings, long_tape().rows);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().fault.kind, kind);
  expect_surely_punched(at_work.punched(), made.error());
}

TEST(PunchFaults, ATornTapeStallsThePunch) {
  expect_punch_fails(SimulatedFault::Kind::Break, Kind::Stalled);
}
TEST(PunchFaults, APunchThatHangsStalls) {
  expect_punch_fails(SimulatedFault::Kind::Hang, Kind::Stalled);
}
TEST(PunchFaults, ASlowPunchIsNamed) { expect_punch_fails(SimulatedFault::Kind::Slow, Kind::Slow); }
TEST(PunchFaults, APowerCutEndsTheLine) {
  expect_punch_fails(SimulatedFault::Kind::PowerCut, Kind::Gone);
}

// --- other devices ------------------------------------------------------------------------------

TEST(FileDevices, AFileIsPunchedWholeAndReadBack) {
  const TemporaryFolder folder;
  PunchSettings punch;
  punch.device = folder.name("a.tap");
  EXPECT_TRUE(punch_to(punch, long_tape().rows));
  EXPECT_THAT(folder.entries(), ElementsAre("a.tap"));
  ReaderSettings reader;
  reader.device = punch.device;
  const TapeReading made = read_from(reader);
  EXPECT_FALSE(made.fault);
  EXPECT_EQ(made.tape, long_tape());
}

TEST(FileDevices, AFileThatCannotBeWrittenLeavesNothingBehind) {
  const TemporaryFolder folder;
  PunchSettings punch;
  punch.device = folder.name("none/a.tap");
  const auto made = punch_to(punch, long_tape().rows);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().fault.kind, Kind::Failed);
  EXPECT_EQ(made.error().fault.error, ENOENT);
  EXPECT_EQ(made.error().punched, 0U);
  EXPECT_THAT(folder.entries(), IsEmpty());
}

TEST(CharacterDevices, AFullOneReportsWhatTheSystemSays) {
  PunchSettings punch;
  punch.device = "/dev/full";
  const auto made = punch_to(punch, long_tape().rows);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().fault.kind, Kind::Failed);
  EXPECT_EQ(made.error().fault.error, ENOSPC);
}

TEST(CharacterDevices, OneThatIsNotThereIsNotMade) {
  PunchSettings punch;
  punch.device = "/dev/no-such-punch";
  const auto made = punch_to(punch, long_tape().rows);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().fault.kind, Kind::CannotOpen);
  ReaderSettings reader;
  reader.device = punch.device;
  EXPECT_EQ(read_from(reader).fault->kind, Kind::CannotOpen);
}

TEST(CharacterDevices, AnEndlessOneIsNoReader) {
  ::alarm(60);
  ReaderSettings reader;
  reader.device = "/dev/zero";
  reader.speed = 1;
  const TapeReading made = read_from(reader);
  ASSERT_TRUE(made.fault);
  EXPECT_EQ(made.fault->kind, Kind::TooLong);
  ::alarm(0);
}

TEST(CharacterDevices, APipeCarriesATapeBothWays) {
  ::alarm(60);
  const TemporaryFolder folder;
  const std::string pipe = folder.name("port");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  ReaderSettings reader;
  reader.device = pipe;
  reader.timeout = 2s;
  TapeReading made;
  std::thread reading([&] { made = read_from(reader); });
  PunchSettings punch;
  punch.device = pipe;
  punch.speed = kSimulatedSpeed;
  // A pipe can be opened to write when its reader is there.
  auto opened = open_punch(punch);
  for (int i = 0; i < 100 && !opened; ++i) {
    std::this_thread::sleep_for(10ms);
    opened = open_punch(punch);
  }
  ASSERT_TRUE(opened);
  EXPECT_TRUE(punch_tape(**opened, long_tape().rows, punch));
  opened->reset();
  reading.join();
  EXPECT_FALSE(made.fault);
  EXPECT_EQ(made.tape, long_tape());
  ::alarm(0);
}

TEST(LineSetup, ASpeedThatNoLineHasIsRefused) {
  AtWork at_work({});
  ReaderSettings reader = at_work.reader();
  reader.line.baud = 1234;
  const TapeReading made = read_from(reader);
  ASSERT_TRUE(made.fault);
  EXPECT_EQ(made.fault->kind, Kind::CannotSetUp);
  EXPECT_EQ(made.fault->error, EINVAL);
}

// --- what lines make of bytes -------------------------------------------------------------------

TEST(LineMarks, BreaksAndBadFramingAreNoise) {
  const std::vector<std::uint8_t> bytes = {1, 0xFF, 0xFF, 2, 0xFF, 0, 0, 3, 0xFF, 0, 0x41, 4};
  // However they are divided between readings.
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    LineMarks marks;
    Reading reading;
    marks.read(std::span(bytes).first(cut), reading);
    marks.read(std::span(bytes).subspan(cut), reading);
    EXPECT_THAT(reading.rows, ElementsAre(1, 0xFF, 2, 3, 0x41, 4));
    EXPECT_THAT(reading.noise, ElementsAre(3, 4));
  }
}

TEST(SimulatedFaults, AreSpelledWithRowsFromOne) {
  const auto fault = parse_simulated_fault("flip@120:8");
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, SimulatedFault::Kind::Flip);
  EXPECT_EQ(fault->row, 119U);
  EXPECT_EQ(fault->track, 8U);
  EXPECT_EQ(parse_simulated_fault("power@1")->kind, SimulatedFault::Kind::PowerCut);
  for (const char* wrong : {"", "flip", "flip@", "flip@0", "flip@1:9", "flip@1:0",
                            "flip@1:", "drop@1:2", "fold@1", "hang@1x", "@1"}) {
    EXPECT_FALSE(parse_simulated_fault(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace dgt
