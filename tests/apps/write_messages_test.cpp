// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/write_messages.h"

#include <gmock/gmock.h>

#include "lang/text/render.h"
#include "tests/support/command.h"

namespace dgt {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What a person is told when this program is written in a dialect, its codes and places.
std::string told(const std::string& program, const std::string& dialect_name) {
  const support::TemporaryFolder folder;
  const auto made = compile_file(folder.write("part.bgt", program), {});
  EXPECT_FALSE(made->bag.has_errors()) << render(made->bag);
  const Dialect& dialect = *find_dialect(dialect_name);
  const DiagnosticBag bag = explain(write(*made->result.path, dialect), dialect, *made);
  std::string lines;
  for (const Diagnostic& diagnostic : bag.all()) {
    const Place place = diagnostic.range.place();
    lines += std::to_string(place.line) + ":" + std::to_string(place.column) + " " +
             text(diagnostic.message, diagnostic.arguments, Language::English) + " [" +
             std::string(diagnostic.code()) + "]\n";
  }
  return lines;
}

/// The same as it is shown, without the name of the folder.
std::string rendered(const std::string& program, const std::string& dialect_name,
                     Language language = Language::English) {
  const support::TemporaryFolder folder;
  const auto made = compile_file(folder.write("part.bgt", program), {});
  EXPECT_FALSE(made->bag.has_errors()) << render(made->bag);
  const Dialect& dialect = *find_dialect(dialect_name);
  const std::string shown =
      render(explain(write(*made->result.path, dialect), dialect, *made), {language});
  return shown.substr(std::min(shown.find("part.bgt"), shown.size()));
}

/// Feed, power, a pause, a code, a height: each at a place of its own.
constexpr const char* kEverything =
    "P1=X10 Y0\n"
    "P2=X20 Y0\n"
    "F100\n"
    "S5\n"
    "K1 P1 T2 P2\n"
    "M60\n"
    "K2 P1 Z5 P2\n";

TEST(WriterMessages, WhatTheDialectSaysNeedsNone) {
  EXPECT_THAT(told(kEverything, "linuxcnc"), IsEmpty());
}

TEST(WriterMessages, NameTheDialectAtThePlaceInTheSource) {
  EXPECT_EQ(
      told(kEverything, "essi"),
      "5:7 the dialect essi has no dwell; T cannot be written [DGT0803]\n"
      "6:1 'M60' means nothing in the dialect essi [DGT0801]\n"
      "7:10 the dialect essi has no heights; Z cannot be written [DGT0802]\n"
      "4:1 the dialect essi does not write S; the control takes it from its settings [DGT0807]\n"
      "5:4 the dialect essi writes no feed; the control takes it from its settings [DGT0806]\n");
}

TEST(WriterMessages, ACodeThatTheInterpreterOfLinuxcncDoesNotKnow) {
  EXPECT_EQ(told("P1=X10 Y0\nF1\nK1 P1 M107 X20 Y0\n", "linuxcnc"),
            "3:7 'M107' means nothing in the dialect linuxcnc [DGT0801]\n");
}

TEST(WriterMessages, ATorchPutOutBeforeACutIsTold) {
  EXPECT_EQ(rendered("L1=X0\nL2=Y0\nP1=X5 Y-9\nG54 X-9 Y9\nK1 M7, L1 L-2 M8 P1\n", "essi"),
            "part.bgt:5:15: warning: after M8 the program cuts on with the torch off; a code "
            "written behind an element acts before that element is cut [DGT0809]\n"
            "K1 M7, L1 L-2 M8 P1\n"
            "              ^\n");
  EXPECT_EQ(rendered("K1 X0 Y0 M8 X9 Y0\n", "plasmatic", Language::Russian),
            "part.bgt:1:10: warning: после M8 программа режет дальше с выключенным резаком; "
            "команда, записанная после элемента, выполняется до прохода по нему [DGT0809]\n"
            "K1 X0 Y0 M8 X9 Y0\n"
            "         ^\n");
}

TEST(WriterMessages, ATorchPutOutBehindTheLastCutIsNot) {
  EXPECT_EQ(told("K1 M7 X1 Y0 X9 Y0 M8\nG0 X0 Y0\n", "essi"), "");
}

TEST(WriterMessages, AFeedThatIsMissingIsTold) {
  EXPECT_EQ(told("P1=X10 Y0\nP2=X20 Y0\nK1 P1 P2\n", "linuxcnc"),
            "3:4 the dialect linuxcnc needs a feed and the program sets none; 1000 mm/min is "
            "written [DGT0808]\n");
}

TEST(WriterMessages, AMoveBehindTheEndAndOneThatIsTooLarge) {
  EXPECT_EQ(told("P1=X10 Y0\nP2=X20 Y0\nK1 P1 P2\nM2\nG0 X1 Y1\n", "essi"),
            "5:1 the tool moves after the program has been ended [DGT0805]\n");
  EXPECT_EQ(told("G0 X999999999999999 Y1\n", "essi"),
            "1:1 the move is too large to be written in steps of 0.1 mm [DGT0804]\n");
}

TEST(WriterMessages, LimitsOfTheControl) {
  EXPECT_EQ(rendered("K1 X0 Y0 X2000 Y0\n", "3b"),
            "part.bgt:1:10: error: the move needs a number that the dialect 3b does not take; its "
            "largest is 999.999 mm [DGT0810]\n"
            "K1 X0 Y0 X2000 Y0\n"
            "         ^\n");
  EXPECT_EQ(rendered("K1 X0 Y0 X2000 Y0\n", "3b", Language::Russian),
            "part.bgt:1:10: error: для перемещения нужно число, которого диалект 3b не принимает; "
            "самое большое — 999.999 мм [DGT0810]\n"
            "K1 X0 Y0 X2000 Y0\n"
            "         ^\n");
}

TEST(WriterMessages, ALineThatTheControlCannotHold) {
  Dialect dialect = *find_dialect("grbl");
  dialect.torch_on = std::string(80, 'M');
  const support::TemporaryFolder folder;
  const auto made = compile_file(folder.write("part.bgt", "F1\nK1 X0 Y0 X1 Y0\n"), {});
  const WriteResult written = write(*made->result.path, dialect);
  EXPECT_THAT(render(explain(written, dialect, *made)),
              HasSubstr("part.bgt:2:10: error: the line for this is longer than the 79 characters "
                        "that the dialect grbl takes [DGT0811]"));
}

// --- offset by the control

/// A plate of 40 × 30 that is begun on the middle of its lower side.
std::string plate(const std::string& w, const std::string& begin, const std::string& way) {
  return "L1=Y0\nL2=X40\nL3=Y30\nL4=X0\nC1=X20 Y0 R5\nG54 X20 Y-5\nF100\nP1=" + begin + "\nK1 W" +
         w + " " + way + "\n";
}

std::string told_by_control(const std::string& program, Dialect dialect,
                            Language language = Language::English) {
  dialect.compensation = Compensation::Control;
  const support::TemporaryFolder folder;
  const auto made = compile_file(folder.write("part.bgt", program), {});
  EXPECT_FALSE(made->bag.has_errors()) << render(made->bag);
  const std::string shown =
      render(explain(write(*made->result.path, dialect), dialect, *made), {language});
  return shown.substr(std::min(shown.find("part.bgt"), shown.size()));
}

TEST(ControlMessages, ADialectWithoutWordsForIt) {
  const std::string program = plate("0.2", "X20 Y-5", "P1 L1 L-2 L-3 L4 L1 P1");
  EXPECT_THAT(told_by_control(program, *find_dialect("linuxcnc")), IsEmpty());
  EXPECT_THAT(told_by_control(program, *find_dialect("grbl")),
              HasSubstr("error: a control that reads grbl cannot offset contours; write this with "
                        "'--compensation computed' [DGT0812]"));
  EXPECT_THAT(told_by_control(program, *find_dialect("3b"), Language::Russian),
              HasSubstr("error: станок с диалектом 3b не строит эквидистанту; для него нужен "
                        "--compensation computed [DGT0812]"));
}

TEST(ControlMessages, TheStraightCutBeforeTheContour) {
  const Dialect& linuxcnc = *find_dialect("linuxcnc");
  EXPECT_THAT(
      told_by_control(plate("4.9999", "X20 Y-5", "P1 L1 L-2 L-3 L4 L1 P1"), linuxcnc),
      HasSubstr("error: the straight cut before the contour is 5 mm long; the control needs "
                "more than its offset of 5 mm [DGT0814]"));
  EXPECT_THAT(
      told_by_control(plate("0.2", "X20 Y-5", "P1 G0 L1 L-2 L-3 L4 L1 P1"), linuxcnc),
      HasSubstr("error: the control comes to its offset on a straight cut before the contour, "
                "and there is none; begin with a point beside the first element "
                "[DGT0813]"));
}

TEST(ControlMessages, WhatAControlWouldCutWrong) {
  const Dialect& linuxcnc = *find_dialect("linuxcnc");
  EXPECT_THAT(
      told_by_control(plate("0.2", "X20 Y-5", "P1 L1 L-2 L-3 L4 U0.3 L1 P1"), linuxcnc),
      HasSubstr("error: the offset changes within the contour; the control has one for all of it "
                "[DGT0815]"));
  const std::string window =
      "L1=Y0\nL2=X40\nL3=Y30\nL4=X0\nG54 X20 Y15\nF100\nK1 W0.2 L1 L-2 L-3 L4 L1 L-2\n";
  EXPECT_THAT(
      told_by_control(window, linuxcnc),
      HasSubstr("error: the contour begins in an inside corner, and offset by the control the tool "
                "would cut into the part there; begin between the ends of an element [DGT0816]"));
  const std::string disc = "C1=X0 Y0 R5\nP1=X0 Y-9\nG54 X0 Y-9\nF100\nK1 W0.2 P1 C1 P1\n";
  EXPECT_THAT(
      told_by_control(disc, linuxcnc),
      HasSubstr(
          "error: the control comes to the contour 0.201 mm behind its beginning; to cut that "
          "at the end, the contour has to be closed and its first element a longer line "
          "[DGT0817]"));
}

TEST(WriterMessages, PointIntoTheMacroThatAskedForIt) {
  const support::TemporaryFolder folder;
  folder.write("mac/lift.mac", "P1=X10 Y0\nK1 P1 Z5 X20 Y0\n");
  const auto made = compile_file(folder.write("part.bgt", "\n\nMAC lift\n"), {});
  ASSERT_FALSE(made->bag.has_errors()) << render(made->bag);
  const Dialect& dialect = *find_dialect("essi");
  const DiagnosticBag bag = explain(write(*made->result.path, dialect), dialect, *made);
  ASSERT_EQ(bag.all().size(), 1U);
  EXPECT_EQ(bag.all()[0].message, Message::HeightNotInDialect);
  EXPECT_EQ(bag.all()[0].range.file->name(), folder.name("mac/lift.mac"));
  EXPECT_EQ(bag.all()[0].range.place().line, 2U);
  EXPECT_EQ(bag.all()[0].range.place().column, 10U);
}

}  // namespace
}  // namespace dgt
