// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of dgt-studio, as scripts see it: without a screen.
#include <gmock/gmock.h>

#include <QImage>
#include <QProcess>

#include "tests/studio/qt_values.h"
#include "tests/support/command.h"

namespace dgt::studio {
namespace {

using support::corpus;

struct Outcome {
  int exit_code = -1;
  QString said;
};

Outcome run(const QStringList& arguments) {
  QProcess program;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.remove(QStringLiteral("DISPLAY"));
  environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
  environment.remove(QStringLiteral("QT_QPA_PLATFORM"));
  program.setProcessEnvironment(environment);
  program.setProcessChannelMode(QProcess::MergedChannels);
  program.start(QStringLiteral(DGT_STUDIO), arguments);
  program.waitForFinished(100000);
  if (program.exitStatus() != QProcess::NormalExit) return {};
  return {program.exitCode(), QString::fromUtf8(program.readAll())};
}

QString sample(const char* name) { return QString::fromStdString(corpus(name)); }

class ScreenshotOfTheProgram : public testing::Test {
 protected:
  support::TemporaryFolder folder;
  QString picture = QString::fromStdString(folder.name("out.png"));
};

TEST_F(ScreenshotOfTheProgram, HasTheSizeThatIsAskedFor) {
  const Outcome done = run({QStringLiteral("--screenshot"), picture, QStringLiteral("--size"),
                            QStringLiteral("1000x700"), sample("1P.bgt")});
  EXPECT_EQ(done.exit_code, 0) << done.said.toStdString();
  EXPECT_EQ(QImage(picture).size(), QSize(1000, 700));
}

TEST_F(ScreenshotOfTheProgram, EveryViewThemeAndLanguageIsAnother) {
  std::vector<QImage> seen;
  for (const char* const words : {"--view draw", "--view nc", "--view points", "--view wizard",
                                  "--view tape", "--theme dark", "--lang ru"}) {
    QStringList arguments = QString::fromLatin1(words).split(u' ');
    arguments << QStringLiteral("--screenshot") << picture << sample("1P.bgt");
    if (!arguments.contains(QStringLiteral("--lang"))) {
      arguments << QStringLiteral("--lang") << QStringLiteral("en");
    }
    ASSERT_EQ(run(arguments).exit_code, 0) << words;
    const QImage image(picture);
    for (const QImage& other : seen) EXPECT_NE(image, other) << words;
    seen.push_back(image);
  }
}

TEST_F(ScreenshotOfTheProgram, AFaultyProgramIsShownWithItsFaults) {
  const std::string faulty = folder.write("faulty.bgt", "L1=X\n");
  EXPECT_EQ(
      run({QStringLiteral("--screenshot"), picture, QString::fromStdString(faulty)}).exit_code, 0);
  EXPECT_FALSE(QImage(picture).isNull());
}

TEST_F(ScreenshotOfTheProgram, FilesThatFailAreNamed) {
  const QString none = QString::fromStdString(folder.name("none.bgt"));
  Outcome failed = run({QStringLiteral("--screenshot"), picture, none});
  EXPECT_EQ(failed.exit_code, 3);
  EXPECT_TRUE(failed.said.contains(none)) << failed.said.toStdString();
  failed = run({QStringLiteral("--screenshot"), picture, QStringLiteral("--machine"), none,
                sample("1P.bgt")});
  EXPECT_EQ(failed.exit_code, 3);
  const QString nowhere = QString::fromStdString(folder.name("no/out.png"));
  failed = run({QStringLiteral("--screenshot"), nowhere, sample("1P.bgt")});
  EXPECT_EQ(failed.exit_code, 3);
  EXPECT_TRUE(failed.said.contains(nowhere)) << failed.said.toStdString();
}

TEST_F(ScreenshotOfTheProgram, WrongUsageEndsWithTwo) {
  for (const char* const words :
       {"--size 10x10 --screenshot out.png", "--view draw", "--view none --screenshot out.png",
        "--lang de", "--nonsense", "--size big --screenshot out.png"}) {
    EXPECT_EQ(run(QString::fromLatin1(words).split(u' ')).exit_code, 2) << words;
  }
}

TEST_F(ScreenshotOfTheProgram, HelpAndVersionNeedNoScreen) {
  Outcome done = run({QStringLiteral("--help")});
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_TRUE(done.said.contains(QStringLiteral("--screenshot")));
  done = run({QStringLiteral("--version")});
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_TRUE(done.said.startsWith(QStringLiteral("dgt-studio ")));
}

TEST(TheProgramWithoutAScreen, SaysSoInBothLanguages) {
  const Outcome english = run({QStringLiteral("--lang"), QStringLiteral("en")});
  EXPECT_EQ(english.exit_code, 3);
  EXPECT_EQ(english.said,
            QStringLiteral("dgt-studio: error: there is no screen: neither DISPLAY nor "
                           "WAYLAND_DISPLAY is set; --screenshot OUT.png saves a picture without "
                           "one\n"));
  const Outcome russian = run({QStringLiteral("--lang"), QStringLiteral("ru")});
  EXPECT_EQ(russian.exit_code, 3);
  EXPECT_EQ(
      russian.said,
      QStringLiteral("dgt-studio: ошибка: нет экрана: не заданы ни DISPLAY, ни "
                     "WAYLAND_DISPLAY; картинку без экрана сохраняет --screenshot OUT.png\n"));
}

}  // namespace
}  // namespace dgt::studio
