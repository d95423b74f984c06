// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/tape/tape_dialog.h"

#include <gmock/gmock.h>

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "apps/driver/tape_jobs.h"
#include "apps/studio/editor/fault_list.h"
#include "apps/studio/editor/source_editor.h"
#include "apps/studio/tape/tape_view.h"
#include "tests/studio/qt_values.h"
#include "tests/support/command.h"
#include "tests/support/simulated_devices.h"

namespace dgt::studio {
namespace {

using support::AtWork;
using support::TemporaryFolder;

constexpr std::uint32_t kBlank = 60;  // mm of leader and trailer: short tapes

/// Patient with a machine that has other things to do: simulated devices run against the clock.
Settings patient_settings() {
  Settings settings;
  settings.tape.format.leader = settings.tape.format.trailer = kBlank;
  settings.tape.punch.speed = settings.tape.reader.speed = 300;
  settings.tape.punch.timeout = settings.tape.reader.timeout = std::chrono::milliseconds(1500);
  return settings;
}

Settings settings_with(const AtWork& devices) {
  Settings settings = patient_settings();
  settings.tape.punch.device = devices.punch().device;
  settings.tape.reader.device = devices.reader().device;
  return settings;
}

std::vector<Row> rows_of(const std::string& program) {
  return program_on_tape("p.ess", program, Encoding::Utf8, patient_settings().tape.format).rows;
}

const std::string kProgram = "53\n+100+\n++200\n-100+\n+-200\n54\n63\n";

struct OpenTape {
  explicit OpenTape(TapeJob job, const Settings& settings = patient_settings())
      : dialog(job, settings) {
    dialog.show();
    (void)QTest::qWaitForWindowExposed(&dialog);
  }
  QPushButton* button(const char* name) {
    return dialog.findChild<QPushButton*>(QString::fromLatin1(name));
  }
  void device(const char* box, const std::string& name) {
    dialog.findChild<QComboBox*>(QString::fromLatin1(box))
        ->setCurrentText(QString::fromStdString(name));
  }
  void program(const std::string& text, const char* name = "part.ess") {
    dialog.set_program(QString::fromLatin1(name), QByteArray::fromStdString(text));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !status().isEmpty(); }));
  }
  /// Clicks Start and waits for the end.
  void run() {
    QSignalSpy ended(&dialog, &TapeDialog::ended);
    QTest::mouseClick(button("start"), Qt::LeftButton);
    ASSERT_TRUE(ended.wait(30000));
  }
  QString status() { return dialog.findChild<QLabel*>(QStringLiteral("status"))->text(); }
  int from() { return dialog.findChild<QSpinBox*>(QStringLiteral("from"))->value(); }
  FaultList* faults() { return dialog.findChild<FaultList*>(); }
  const Tape& tape() { return dialog.findChild<TapeView*>()->tape(); }

  TapeDialog dialog;
};

// --- punching

TEST(TapeDialog, PunchesIntoAFileWhatTheCommandEncodes) {
  const TemporaryFolder folder;
  const std::string program = folder.write("part.ess", kProgram);
  const std::string wanted = folder.name("wanted.tap");
  ASSERT_EQ(support::run_dgt({"tape", "encode", program, "-o", wanted}).exit_code, 0);
  OpenTape tape(TapeJob::Punch, Settings());
  tape.program(kProgram);
  tape.device("punch", folder.name("punched.tap"));
  tape.run();
  EXPECT_EQ(support::read_text(folder.name("punched.tap")), support::read_text(wanted));
}

TEST(TapeDialog, PunchesOnADevice) {
  AtWork devices({});
  OpenTape tape(TapeJob::Punch, settings_with(devices));
  tape.program(kProgram);
  tape.run();
  EXPECT_TRUE(tape.status().startsWith(QStringLiteral("Punched:"))) << tape.status().toStdString();
  EXPECT_EQ(devices.punched(), rows_of(kProgram));
}

TEST(TapeDialog, ShowsTheTapeBeforeItIsPunched) {
  OpenTape tape(TapeJob::Punch);
  tape.program(kProgram);
  EXPECT_EQ(tape.tape().rows, rows_of(kProgram));
}

TEST(TapeDialog, LeaderAndLetteringCanBeChanged) {
  const TemporaryFolder folder;
  OpenTape tape(TapeJob::Punch);
  tape.program(kProgram);
  const std::size_t before = tape.tape().rows.size();
  auto* const leader = tape.dialog.findChild<QSpinBox*>(QStringLiteral("leader"));
  leader->setFocus();
  QTest::keyClick(leader, Qt::Key_Up);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return tape.tape().rows.size() == before + rows_in(kBlank + 50) - rows_in(kBlank); }));
}

TEST(TapeDialog, CharactersThatTapeLacksAreToldAndNothingIsPunched) {
  OpenTape tape(TapeJob::Punch);
  tape.device("punch", "/dev/null");
  tape.program("L1=X0 ' прямая\n", "part.bgt");
  EXPECT_FALSE(tape.button("start")->isEnabled());
  EXPECT_GE(tape.faults()->topLevelItemCount(), 1);
  // Spelled in Latin letters it can be.
  tape.dialog.findChild<QComboBox*>(QStringLiteral("unpunchable"))->setCurrentIndex(2);
  ASSERT_TRUE(QTest::qWaitFor([&] { return tape.button("start")->isEnabled(); }));
}

TEST(TapeDialog, APunchThatHangsIsToldAndHowToGoOn) {
  SimulatorSettings faulty;
  std::string program;
  for (int i = 0; i < 40; ++i) program += "+100+\n";
  faulty.punch_faults = {*parse_simulated_fault("hang@150")};
  AtWork devices(faulty);
  OpenTape tape(TapeJob::Punch, settings_with(devices));
  tape.program(program);
  tape.run();
  EXPECT_TRUE(tape.status().contains(QStringLiteral("has taken no row")))
      << tape.status().toStdString();
  EXPECT_TRUE(tape.status().contains(QStringLiteral("Whole blocks are on the tape")))
      << tape.status().toStdString();
  EXPECT_GT(tape.from(), 1);
  EXPECT_EQ(rows_of(program)[static_cast<std::size_t>(tape.from() - 2)], kLineFeed);
}

TEST(TapeDialog, APunchThatIsNotThereIsTold) {
  OpenTape tape(TapeJob::Punch);
  tape.program(kProgram);
  tape.device("punch", "/dev/no-such-punch");
  tape.run();
  EXPECT_TRUE(tape.status().contains(QStringLiteral("cannot be opened")))
      << tape.status().toStdString();
}

TEST(TapeDialog, StopEndsThePunchingAndTheWindowStays) {
  Settings slow = patient_settings();
  SimulatorSettings faulty;
  faulty.punch_faults = {*parse_simulated_fault("hang@30")};
  AtWork devices(faulty);
  slow.tape.punch.device = devices.punch().device;
  slow.tape.punch.timeout = std::chrono::seconds(60);
  OpenTape tape(TapeJob::Punch, slow);
  std::string program;
  for (int i = 0; i < 100; ++i) program += "+100+\n";
  tape.program(program);
  QSignalSpy ended(&tape.dialog, &TapeDialog::ended);
  QTest::mouseClick(tape.button("start"), Qt::LeftButton);
  QTest::qWait(300);
  QTest::keyClick(&tape.dialog, Qt::Key_Escape);
  ASSERT_TRUE(ended.wait(10000));
  EXPECT_TRUE(tape.dialog.isVisible());
  EXPECT_TRUE(tape.status().contains(QStringLiteral("stopped by hand")))
      << tape.status().toStdString();
}

// --- reading

TEST(TapeDialog, ReadsAProgramFromADevice) {
  SimulatorSettings loaded;
  loaded.tape = rows_of(kProgram);
  AtWork devices(loaded);
  OpenTape tape(TapeJob::Read, settings_with(devices));
  QSignalSpy text(&tape.dialog, &TapeDialog::text_read);
  tape.run();
  ASSERT_TRUE(tape.button("open")->isEnabled()) << tape.status().toStdString();
  QTest::mouseClick(tape.button("open"), Qt::LeftButton);
  ASSERT_EQ(text.count(), 1);
  EXPECT_EQ(text[0][0].toByteArray().toStdString(), kProgram);
  EXPECT_FALSE(tape.dialog.isVisible());
}

TEST(TapeDialog, ReadsRowsAndPicturesOutOfFiles) {
  const TemporaryFolder folder;
  const std::vector<Row> rows = rows_of(kProgram);
  const Tape whole{rows, {}};
  for (const auto& [name, bytes] :
       {std::pair{"p.tap", std::string(rows.begin(), rows.end())}, {"p.txt", to_picture(whole)}}) {
    OpenTape tape(TapeJob::Read);
    tape.device("reader", folder.write(name, bytes));
    tape.run();
    EXPECT_EQ(tape.dialog.findChild<SourceEditor*>()->text().toStdString(), kProgram) << name;
  }
}

TEST(TapeDialog, ADamagedRowIsToldAndMarked) {
  const TemporaryFolder folder;
  std::vector<Row> rows = rows_of(kProgram);
  rows[40] ^= 0x04;
  OpenTape tape(TapeJob::Read);
  tape.device("reader", folder.write("p.tap", {rows.begin(), rows.end()}));
  tape.run();
  EXPECT_TRUE(tape.status().startsWith(QStringLiteral("Damaged places: 1;")))
      << tape.status().toStdString();
  ASSERT_GE(tape.faults()->topLevelItemCount(), 1);
  EXPECT_TRUE(tape.faults()->topLevelItem(0)->text(0).contains(QStringLiteral("41")))
      << tape.faults()->topLevelItem(0)->text(0).toStdString();
  EXPECT_EQ(tape.button("open")->text(), QStringLiteral("&Open with damaged rows marked"));
}

TEST(TapeDialog, AReadingThatStopsIsKeptAndGoneOnWith) {
  SimulatorSettings loaded;
  std::string program;
  for (int i = 0; i < 40; ++i) program += "+" + std::to_string(i) + "+\n";
  loaded.tape = rows_of(program);
  loaded.reader_faults = {*parse_simulated_fault("hang@120")};
  AtWork devices(loaded);
  OpenTape tape(TapeJob::Read, settings_with(devices));
  tape.run();
  EXPECT_TRUE(tape.status().contains(QStringLiteral("is kept"))) << tape.status().toStdString();
  EXPECT_EQ(tape.tape().rows.size(), 119U);
  tape.run();  // the fault does not come twice
  EXPECT_EQ(tape.dialog.findChild<SourceEditor*>()->text().toStdString(), program);
}

TEST(TapeDialog, AFileThatIsNoTapeIsTold) {
  const TemporaryFolder folder;
  OpenTape tape(TapeJob::Read);
  tape.device("reader", folder.write("p.txt", "___________\nneither holes nor rows\n"));
  tape.run();
  EXPECT_FALSE(tape.button("open")->isEnabled());
  EXPECT_GE(tape.faults()->topLevelItemCount(), 1);
}

// --- duplicating

TEST(TapeDialog, ACopyIsTheTape) {
  const TemporaryFolder folder;
  const std::vector<Row> rows = rows_of(kProgram);
  OpenTape tape(TapeJob::Duplicate);
  tape.device("reader", folder.write("p.tap", {rows.begin(), rows.end()}));
  tape.device("punch", folder.name("copy.tap"));
  tape.run();
  EXPECT_EQ(tape.button("start")->text(), QStringLiteral("&Punch the copy"));
  tape.run();
  EXPECT_EQ(support::read_text(folder.name("copy.tap")), std::string(rows.begin(), rows.end()));
}

TEST(TapeDialog, ADamagedTapeIsNotCopied) {
  const TemporaryFolder folder;
  std::vector<Row> rows = rows_of(kProgram);
  rows[40] ^= 0x04;
  OpenTape tape(TapeJob::Duplicate);
  tape.device("reader", folder.write("p.tap", {rows.begin(), rows.end()}));
  tape.device("punch", folder.name("copy.tap"));
  tape.run();
  EXPECT_EQ(tape.button("start")->text(), QStringLiteral("&Read"));
  EXPECT_EQ(folder.entries(), std::vector<std::string>{"p.tap"});
}

}  // namespace
}  // namespace dgt::studio
