// SPDX-License-Identifier: GPL-3.0-or-later
//
// The forms come from the table of the language; here stand the example and the description of each
// spelling. A spelling without an example is a mistake of ours, and a test finds it.
#include "apps/studio/wizard/definition_forms.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <sstream>

#include "kernel/check.h"
#include "lang/dgt/forms.h"

namespace dgt::studio {
namespace {

using Called = std::map<std::string, std::string>;
using Notes = std::vector<FigureNote>;

struct Example {
  const char* pattern;
  const char* description;
  std::string program;
  bool axes = false;
  Called called = {};
  Notes notes = {};
};

std::vector<Example> line_examples() {
  const std::string two_points = "P1=X8 Y6\nP2=X44 Y26\n";
  const std::string line = "L1=X0 Y0 X44 Y10\n";
  const std::string disc = "P1=X0 Y0\nC1=X34 Y4 R12\n";
  return {
      {"L=X",
       QT_TRANSLATE_NOOP("DefinitionForm", "Upright line through X"),
       "L6=X72",
       true,
       {},
       {{"X72", 36, 0}}},
      {"L=Y",
       QT_TRANSLATE_NOOP("DefinitionForm", "Level line through Y"),
       "L1=Y15",
       true,
       {},
       {{"Y15", 0, 8}, {" ", 24, 0}}},
      {"L=XYXY",
       QT_TRANSLATE_NOOP("DefinitionForm", "Line through two places"),
       two_points + "L1=X8 Y6 X44 Y26",
       true,
       {{"P1", "X Y"}, {"P2", "X Y"}}},
      {"L=PP", QT_TRANSLATE_NOOP("DefinitionForm", "Line through two points"),
       two_points + "L1=P1 P2"},
      {"L=XYL",
       QT_TRANSLATE_NOOP("DefinitionForm", "Line through a place, parallel to a line"),
       line + "P1=X14 Y22\nL2=X14 Y22 L1",
       true,
       {{"P1", "X Y"}}},
      {"L=PL", QT_TRANSLATE_NOOP("DefinitionForm", "Line through a point, parallel to a line"),
       line + "P1=X14 Y22\nL2=P1 L1"},
      {"L=LD",
       QT_TRANSLATE_NOOP("DefinitionForm",
                         "Line parallel to a line at distance D; D > 0 lies left of it"),
       line + "L2=L1 D14",
       false,
       {},
       {{"D14", 20, 12}}},
      {"L=XYC",
       QT_TRANSLATE_NOOP("DefinitionForm", "Line from a place, tangent to a circle"),
       disc + "L1=X0 Y0 C1",
       true,
       {{"P1", "X Y"}}},
      {"L=PC", QT_TRANSLATE_NOOP("DefinitionForm", "Line from a point, tangent to a circle"),
       disc + "L1=P1 C1"},
      {"L=XYA",
       QT_TRANSLATE_NOOP("DefinitionForm", "Line through a place at an angle to the X axis"),
       "P1=X12 Y8\nL1=X12 Y8 A30",
       true,
       {{"P1", "X Y"}},
       {{"A30", 36, 12}}},
      {"L=PA",
       QT_TRANSLATE_NOOP("DefinitionForm", "Line through a point at an angle to the X axis"),
       "P1=X12 Y8\nL1=P1 A30",
       false,
       {},
       {{"A30", 36, 12}}},
      {"L=CA",
       QT_TRANSLATE_NOOP("DefinitionForm", "Line tangent to a circle at an angle to the X axis"),
       "C1=X26 Y18 R12\nL1=C1 A30",
       true,
       {},
       {{"A30", 52, 12}}},
      {"L=CC", QT_TRANSLATE_NOOP("DefinitionForm", "Line tangent to two circles"),
       "C1=X0 Y0 R8\nC2=X40 Y4 R14\nL1=C1 C2"},
      {"L=LAP",
       QT_TRANSLATE_NOOP("DefinitionForm", "Line through a point that crosses a line at an angle"),
       line + "P1=X30 Y24\nL2=L1 A50 P1",
       false,
       {},
       {{"A50", 24, 9}}},
  };
}

std::vector<Example> circle_examples() {
  const std::string three = "P1=X4 Y2\nP2=X34 Y6\nP3=X20 Y28\n";
  const std::string flat = "L1=Y-16\nC1=X0 Y0 R22\n";
  const std::string discs = "C1=X0 Y0 R14\nC2=X30 Y4 R10\n";
  const Called places = {{"P1", "X Y"}, {"P2", "X Y"}, {"P3", "X Y"}};
  return {
      {"C=XYR",
       QT_TRANSLATE_NOOP("DefinitionForm",
                         "Circle about a place; R > 0 runs counter-clockwise, R < 0 clockwise"),
       "P1=X26 Y20\nC1=X26 Y20 R14",
       true,
       {{"P1", "X Y"}},
       {{"R14", 33, 20}}},
      {"C=PR",
       QT_TRANSLATE_NOOP("DefinitionForm",
                         "Circle about a point; R > 0 runs counter-clockwise, R < 0 clockwise"),
       "P1=X26 Y20\nC1=P1 R14",
       false,
       {},
       {{"R14", 33, 20}}},
      {"C=XYXYXY", QT_TRANSLATE_NOOP("DefinitionForm", "Circle through three places"),
       three + "C1=X4 Y2 X34 Y6 X20 Y28", true, places},
      {"C=PPP", QT_TRANSLATE_NOOP("DefinitionForm", "Circle through three points"),
       three + "C1=P1 P2 P3"},
      {"C=LLR",
       QT_TRANSLATE_NOOP("DefinitionForm", "Circle of radius R tangent to two lines"),
       "L1=Y0\nL2=X40 Y0 X28 Y30\nC1=L1 L2 R10",
       false,
       {},
       {{"R10", 26, 10}, {" ", 2, 26}}},
      {"C=LRC",
       QT_TRANSLATE_NOOP("DefinitionForm", "Circle of radius R tangent to a line and a circle"),
       flat + "C2=L1 R7 C1",
       false,
       {},
       {{"R7", -18, -9}}},
      {"C=ILRC",
       QT_TRANSLATE_NOOP("DefinitionForm",
                         "The other circle of radius R tangent to a line and a circle"),
       flat + "C2=I2 L1 R7 C1",
       false,
       {},
       {{"R7", 18, -9}}},
      {"C=CRC",
       QT_TRANSLATE_NOOP("DefinitionForm", "Circle of radius R tangent to two circles"),
       discs + "C3=C1 R-8 C2",
       false,
       {},
       {{"R-8", 17, -13}}},
      {"C=ICRC",
       QT_TRANSLATE_NOOP("DefinitionForm", "The other circle of radius R tangent to two circles"),
       discs + "C3=I2 C1 R-8 C2",
       false,
       {},
       {{"R-8", 15, 17}}},
      {"C=PMAR",
       QT_TRANSLATE_NOOP(
           "DefinitionForm",
           "Circle of radius R at distance M from a point, in the direction of the angle"),
       "P1=X0 Y0\nL9=P1 A30\nC1=P1 M30 A30 R10",
       false,
       {{"L9", ""}},
       {{"M30", 12, 10}, {"A30", 14, 3}}},
  };
}

std::vector<Example> point_examples() {
  const std::string meeting = "L1=X0 Y12 X30 Y16\nC1=X18 Y8 R14\n";
  const std::string discs = "C1=X0 Y0 R16\nC2=X22 Y4 R14\n";
  return {
      {"P=XY",
       QT_TRANSLATE_NOOP("DefinitionForm", "Point at a place"),
       "P1=X30 Y20",
       true,
       {},
       {{"X30", 30, 0}, {"Y20", 0, 20}}},
      {"P=C", QT_TRANSLATE_NOOP("DefinitionForm", "Centre of a circle"), "C1=X20 Y16 R14\nP1=C1"},
      {"P=LL",
       QT_TRANSLATE_NOOP("DefinitionForm", "Where two lines cross"),
       "L1=X0 Y4 X40 Y16\nL2=X8 Y26 X34 Y0\nP1=L1 L2",
       false,
       {},
       {{" ", 4, 20}, {" ", 38, 4}}},
      {"P=LC", QT_TRANSLATE_NOOP("DefinitionForm", "Where a line enters a circle"),
       meeting + "P1=L1 C1"},
      {"P=ILC", QT_TRANSLATE_NOOP("DefinitionForm", "Where a line leaves a circle (I2)"),
       meeting + "P1=I2 L1 C1"},
      {"P=CC", QT_TRANSLATE_NOOP("DefinitionForm", "Where the first circle enters the second"),
       discs + "P1=C1 C2"},
      {"P=ICC",
       QT_TRANSLATE_NOOP("DefinitionForm", "Where the first circle leaves the second (I2)"),
       discs + "P1=I2 C1 C2"},
      {"P=MAP",
       QT_TRANSLATE_NOOP("DefinitionForm",
                         "Point at distance M from a point, in the direction of the angle"),
       "P1=X4 Y4\nL9=P1 A30\nP2=M32 A30 P1",
       false,
       {{"L9", ""}},
       {{"M32", 14, 16}, {"A30", 18, 7}}},
  };
}

std::vector<Example> frame_examples() {
  return {
      {"O=XYA",
       QT_TRANSLATE_NOOP("DefinitionForm",
                         "Coordinate system: its origin and how far it is turned"),
       "O1=X43 Y30 A20",
       true,
       {},
       {{"A20", 66, 30}, {" ", 60, 44}}},
      {"O=PA",
       QT_TRANSLATE_NOOP("DefinitionForm", "Coordinate system at a point, turned by an angle"),
       "P1=X43 Y30\nO1=P1 A20",
       true,
       {},
       {{"A20", 66, 30}, {" ", 60, 44}}},
  };
}

std::vector<Example> all_examples() {
  std::vector<Example> all = line_examples();
  for (auto* const more : {circle_examples, point_examples, frame_examples}) {
    for (Example& example : more()) all.push_back(std::move(example));
  }
  return all;
}

std::string last_line(const std::string& program) {
  const auto end = program.rfind('\n');
  return end == std::string::npos ? program : program.substr(end + 1);
}

DefinitionForm form_of(Example example) {
  Figure figure;
  const std::string line = last_line(example.program);
  figure.lit = line.substr(0, line.find('='));
  figure.program = std::move(example.program);
  figure.axes = example.axes;
  figure.called = std::move(example.called);
  figure.notes = std::move(example.notes);
  return {example.pattern, QCoreApplication::translate("DefinitionForm", example.description),
          std::move(figure)};
}

}  // namespace

std::string DefinitionForm::example() const { return last_line(figure.program); }

std::vector<DefinitionForm> definition_forms() {
  std::vector<Example> examples = all_examples();
  std::vector<DefinitionForm> forms;
  for (const language::Form& form : language::all_forms()) {
    std::istringstream spellings{std::string(form.pattern)};
    for (std::string pattern; spellings >> pattern;) {
      const auto example = std::ranges::find(examples, pattern, &Example::pattern);
      DGT_CHECK(example != examples.end());
      forms.push_back(form_of(std::move(*example)));
    }
  }
  return forms;
}

bool names_an_element(char letter) {
  static constexpr std::string_view kElements = "LCPOI";
  return kElements.find(letter) != std::string_view::npos;
}

}  // namespace dgt::studio
