// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/wizard/contour_examples.h"

#include <QCoreApplication>
#include <sstream>

namespace dgt::studio {
namespace {

struct Row {
  const char* name;
  const char* program;
  const char* macro = nullptr;  ///< the text of the macro SLOT
};

constexpr Row kRows[] = {
    {QT_TRANSLATE_NOOP("ContourExample", "Plate"),
     "L1=Y0\nL2=X40\nL3=Y30\nL4=X0\nP1=X20 Y-6\nG54 X20 Y-6\nK1 W0.2 P1 L1 L-2 L-3 L4 L1 P1\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "Hole"),
     "P1=X0 Y4\nC1=X0 Y0 R15\nG54 X0 Y0\nK1 W0.2 P1 C1 P1\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "Rounded corners (R)"),
     "L1=Y0\nL2=X40\nL3=Y30\nL4=X0\nP1=X20 Y-6\nG54 X20 Y-6\n"
     "K1 W0.2 P1 L1 R5 L-2 R8 L-3 R5 L4 R8 L1 P1\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "Chamfered corners (V)"),
     "L1=Y0\nL2=X40\nL3=Y30\nL4=X0\nP1=X20 Y-6\nG54 X20 Y-6\n"
     "K1 W0.2 P1 L1 V5 L-2 V8 L-3 V5 L4 V8 L1 P1\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "Lines and circles"),
     "C1=X0 Y0 R20\nL1=Y-12\nP1=X0 Y-18\nG54 X0 Y-18\nK1 W0.2 P1 L1 I2 C1 I2 L1 P1\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "Tangents of circles (V)"),
     "C1=X0 Y0 R12\nC2=X45 Y8 R7\nP1=X-18 Y0\nG54 X-18 Y0\nK1 W0.3 P1 C1 V C2 V C1 P1\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "Circles joined by radii"),
     "C1=X0 Y0 R12\nC2=X26 Y0 R10\nP1=X-18 Y0\nG54 X-18 Y0\nK1 W0.2 P1 C1 R6 C2 R4 C1 P1\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "Turned by A: a hexagon"),
     "L1=Y-20\nP1=X0 Y-26\nG54 X0 Y-26\n"
     "K1 W0.2 P1 L1 A60 L1 A120 L1 A180 L1\nA240, L1 A300 L1 A-0 L1 P1\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "Coordinate system (O)"),
     "O1=X30 Y20 A30\nL1=Y0\nL2=X40\nL3=Y30\nL4=X0\nP1=X20 Y-6\nG54 X50 Y24\n"
     "K1 O1 W0.2 P1 L1 L-2 L-3 L4 L1 P1\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "Another equidistant on the way (U)"),
     "L1=Y0\nL2=X40\nL3=Y30\nL4=X0\nP1=X20 Y-6\nG54 X20 Y-6\n"
     "K1 W0.2 P1 L1 U2 L-2 L-3 U0.2 L4 L1 P1\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "Cam with a loop (1P, 2P)"),
     "L1=Y2\nL2=Y-2\nC1=X0 Y0 R7\nC2=X14 Y0 R-5\nG54 X14 Y0\nK1 W0.2 L1 C2 L-2 C-1\n"
     "FOR 5\nN1=N1-60\nAN1, L1 C2 L-2 C-1\nNEXT\nA-0, L1 C2\nG0 X14 Y0\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "Star with variables (4P)"),
     "N1=5 ' radius of the lobes\nN2=3 ' radius of the fillets\nP1=X0 Y0\nC1=X0 Y0 R11\n"
     "C2=X0 Y15 RN1\nC3=P1 M15 A-30 RN1\nC4=P1 M15 A-150 RN1\nP2=X0 Y16\nG54 X0 Y15\n"
     "K1 W0.2 P2 C-2 RN2 C-1 RN2\nC-3, RN2 C-1 RN2 C-4 RN2 C-1 RN2 C-2 P2\nG0 X0 Y15\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "Row of holes with a loop"),
     "N1=10\nFOR 5\nC1=XN1 Y0 R3\nP1=XN1 Y1\nG54 XN1 Y0\nK1 W0.1 P1 C1 P1\nN1=N1+12.5\nNEXT\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "One outline twice (B)"),
     "B1=\"P1 L1 L-2 L-3 L4 L1 P1,\"\nL1=Y0\nL2=X40\nL3=Y30\nL4=X0\nP1=X20 Y-6\nG54 X20 Y-6\n"
     "K1 W1 B1,\nK2 W0.2 B1,\n"},
    {QT_TRANSLATE_NOOP("ContourExample", "Slots by a macro (MAC)"),
     "MAC SLOT 30,6,0,0,\nMAC SLOT 24,5,40,18,\n",
     "' length N1, radius N2, middle of the left end at N3, N4\nN5=N3+N1\n"
     "C91=X N3 Y N4 R N2\nC92=X N5 Y N4 R N2\nN6=N2/-2+N3\nP91=X N6 Y N4\nG54 X N3 Y N4\n"
     "K91 W0.1 P91 C91 V C92 V C91 P91\n"},
};

constexpr const char* kMacro = "SLOT";

}  // namespace

std::string ContourExample::text() const {
  std::string out;
  for (const auto& [file, macro] : figure.files) {
    out += "' " + file + ".mac:\n";
    std::istringstream lines(macro);
    for (std::string line; std::getline(lines, line);) out += "'   " + line + "\n";
  }
  return out + figure.program;
}

std::vector<ContourExample> contour_examples() {
  std::vector<ContourExample> examples;
  for (const Row& row : kRows) {
    ContourExample example;
    example.name = QCoreApplication::translate("ContourExample", row.name);
    example.figure.program = row.program;
    if (row.macro != nullptr) example.figure.files.emplace(kMacro, row.macro);
    examples.push_back(std::move(example));
  }
  return examples;
}

}  // namespace dgt::studio
