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

TEST(ControlMessages, TheStraightMoveBeforeTheContour) {
  const Dialect& linuxcnc = *find_dialect("linuxcnc");
  const Dialect& fanuc = *find_dialect("fanuc-wire");
  const std::string too_long = plate("4.9999", "X20 Y-5", "P1 L1 L-2 L-3 L4 L1 P1");
  EXPECT_THAT(told_by_control(too_long, fanuc),
              HasSubstr("error: the straight move before the contour is 5 mm long; for the control "
                        "to come to its offset there, it has to be longer than 5 mm; begin farther "
                        "away [DGT0814]"));
  const std::string half = plate("2.5", "X20 Y-5", "P1 L1 L-2 L-3 L4 L1 P1");
  EXPECT_THAT(told_by_control(half, fanuc), IsEmpty());
  EXPECT_THAT(told_by_control(half, linuxcnc),
              HasSubstr("it has to be longer than 5 mm; begin farther away [DGT0814]"));
  EXPECT_THAT(told_by_control(half, linuxcnc, Language::Russian),
              HasSubstr("прямой подход к контуру длиной 5 мм; чтобы станок вышел на нём на "
                        "эквидистанту, нужно больше 5 мм; начните дальше от контура [DGT0814]"));
  const std::string rapid = plate("0.2", "X20 Y-5", "P1 G0 L1 L-2 L-3 L4 L1 P1");
  EXPECT_THAT(told_by_control(rapid, linuxcnc), IsEmpty());
  // A boss smaller than the tool: no lead comes by it at the offset and meets it.
  const std::string boss = "C1=X0 Y0 R0.1\nP1=X0 Y-9\nG54 X0 Y-9\nF100\nK1 W0.2 P1 C1 P1\n";
  EXPECT_THAT(told_by_control(boss, fanuc), IsEmpty());
  EXPECT_THAT(told_by_control(boss, linuxcnc),
              HasSubstr("error: no straight move from there brings the control to its offset where "
                        "the contour begins; begin farther from the contour, along the normal of "
                        "its first element [DGT0817]"));
  // Nothing leads to a contour that begins where the tool stands.
  Toolpath path;
  Contour& contour = path.contours.emplace_back();
  contour.side = Side::Left;
  contour.offset = 1;
  path.moves.resize(1);
  contour.last = 1;
  Dialect dialect = linuxcnc;
  dialect.compensation = Compensation::Control;
  const WriteResult written = write(path, dialect);
  ASSERT_EQ(written.faults.size(), 1u);
  EXPECT_EQ(written.faults[0].kind, WriteFault::Kind::LeadLacking);
  const auto made = compile_bytes("part.bgt", "", {});
  EXPECT_THAT(render(explain(written, dialect, made)),
              HasSubstr("error: the control comes to its offset on a straight move before the "
                        "contour, and there is none; begin with a point beside the first element "
                        "[DGT0813]"));
}

TEST(ControlMessages, WhatAControlWouldCutWrong) {
  const Dialect& linuxcnc = *find_dialect("linuxcnc");
  EXPECT_THAT(told_by_control(plate("0.2", "X20 Y-5", "P1 L1 L-2 L-3 L4 U0.3 L1 P1"), linuxcnc),
              HasSubstr("error: the offset changes within the contour, and the control has one for "
                        "all of it; write this with '--compensation computed' [DGT0815]"));
  EXPECT_THAT(
      told_by_control(plate("0.2", "X20 Y-5", "P1 L1 X50 Y-5 X50 Y5 L-2 L-3 L4 L1 P1"), linuxcnc),
      HasSubstr(
          "error: within the contour the tool goes straight from point to point, where W does "
          "not move it and the control would; write this with '--compensation computed' "
          "[DGT0818]"));
  EXPECT_THAT(told_by_control(plate("0.2", "X20 Y-5", "P1 L1 L2 L-3 L4 L1 P1"), linuxcnc),
              HasSubstr("error: the contour runs against one of its elements, where the tool is on "
                        "the other side, and the control has one side for all of it; turn that "
                        "element round, or write this with '--compensation computed' [DGT0821]"));
}

TEST(ControlMessages, WhatTheEquidistantLeavesOut) {
  SourceSettings settings;
  settings.evaluate.gouge = GougePolicy::Trim;
  Dialect dialect = *find_dialect("linuxcnc");
  dialect.compensation = Compensation::Control;
  const auto made = compile_bytes(
      "part.bgt",
      "L1=Y0\nL2=X19.5\nL3=Y-4\nL4=X20.5\nL5=X40\nL6=Y-20\nL7=X0\nP1=X10 Y5\nG54 X10 Y5\nF100\n"
      "K1 W0.6 P1 L1 L2 L3 L-4 L1 L5 L6 L-7 L1 P1\n",
      settings);
  ASSERT_FALSE(made.bag.has_errors()) << render(made.bag);
  EXPECT_THAT(
      render(explain(write(*made.result.path, dialect), dialect, made)),
      HasSubstr("error: the offset leaves out elements of the contour, and the control would "
                "cut into the part there; write this with '--compensation computed' "
                "[DGT0819]"));
}

TEST(ControlMessages, WhatDependsOnTheControl) {
  Dialect essi = *find_dialect("essi");
  const std::string window =
      "L1=Y0\nL2=X40\nL3=Y30\nL4=X0\nP1=X20 Y15\nG54 X20 Y15\nK1 W0.2 L1 L-2 L-3 L4 L1 L-2\n";
  EXPECT_THAT(
      told_by_control(window, essi),
      HasSubstr("error: the contour begins in a corner, and some controls would cut into the "
                "part on the way to their offset there; begin between the ends of an "
                "element, or say 'kerf.entry' in the dialect essi [DGT0816]"));
  const std::string open = plate("0.2", "X20 Y-5", "P1 L1 L-2 X45 Y35");
  EXPECT_THAT(told_by_control(open, essi),
              HasSubstr("error: the contour is open, and where controls begin with their offset "
                        "differs; say 'kerf.entry' in the dialect essi, or write this with "
                        "'--compensation computed' [DGT0820]"));
  for (const KerfEntry entry : {KerfEntry::Meets, KerfEntry::Beside}) {
    essi.kerf.entry = entry;
    EXPECT_THAT(told_by_control(open, essi), ::testing::Not(HasSubstr("error")));
    EXPECT_THAT(told_by_control(window, essi), ::testing::Not(HasSubstr("error")));
  }
  const std::string two =
      plate("0.2", "X20 Y-5", "P1 L1 L-2 L-3 L4 L1 P1") + "K2 W0.3 P1 L1 L-2 L-3 L4 L1 P1\n";
  EXPECT_THAT(told_by_control(two, *find_dialect("linuxcnc")), ::testing::Not(HasSubstr("error")));
  EXPECT_THAT(told_by_control(two, essi),
              HasSubstr("error: this contour has another offset than the one before, and a control "
                        "that reads essi takes one from its settings for all; give them one W, or "
                        "write this with '--compensation computed' [DGT0822]"));
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
