// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/editor/inks.h"

#include <gmock/gmock.h>

namespace dgt::studio {
namespace {

/// The line with the letter of its ink under each character.
std::string inked(const QString& line, InputLanguage language = InputLanguage::Dgt) {
  std::string letters(static_cast<std::size_t>(line.size()), '.');
  for (const InkedRange& range : inks_of(line, language)) {
    static constexpr std::string_view kLetters = "ENKVC";
    const char letter = kLetters[static_cast<std::size_t>(range.ink)];
    for (int i = 0; i < range.length; ++i) {
      letters.at(static_cast<std::size_t>(range.begin + i)) = letter;
    }
  }
  return letters;
}

TEST(Inks, ElementsQuantitiesCommandsAndComments) {
  EXPECT_EQ(inked(QStringLiteral("C2=P1 R-10 ' rim")), "EE.EE.NNNN.CCCCC");
  EXPECT_EQ(inked(QStringLiteral("G54 X0Y7.5")), "KKK.NNNNNN");
  EXPECT_EQ(inked(QStringLiteral("FOR 5")), "KKK.N");
  EXPECT_EQ(inked(QStringLiteral("LN1=XN2")), "EVV.NVV");
}

TEST(Inks, CountUtf16BehindLettersOfTwoBytes) {
  EXPECT_EQ(inked(QStringLiteral("L1=X5 ' обод")), "EE.NN.CCCCCC");
  EXPECT_EQ(inked(QStringLiteral("С1=P1 R5")), "EE.EE.NN");  // a Cyrillic С
}

TEST(Inks, OfNcPrograms) {
  EXPECT_EQ(inked(QStringLiteral("N10 G01 X1.5 (rim)"), InputLanguage::Gcode),
            "CCC.KKK.NNNN.CCCCC");
  EXPECT_EQ(inked(QStringLiteral("53"), InputLanguage::Essi), "KK");
  EXPECT_EQ(inked(QStringLiteral("+100-20"), InputLanguage::Essi), "NNNNNNN");
}

TEST(Inks, LinesThatAreNoProgramAreLeftAlone) {
  EXPECT_TRUE(inks_of({}, InputLanguage::Dgt).empty());
  EXPECT_TRUE(inks_of(QString(kLongestInkedLine + 1, u'L'), InputLanguage::Dgt).empty());
  // Whatever stands there, the ranges are inside the line and in order.
  const QString odd = QStringLiteral("\"L1 \x01\u2028 №😀 L1=)(;;'") + QChar(0xD800);
  int done = 0;
  for (const InkedRange& range : inks_of(odd, InputLanguage::Dgt)) {
    EXPECT_GE(range.begin, done);
    done = range.begin + range.length;
    EXPECT_LE(done, odd.size());
  }
}

}  // namespace
}  // namespace dgt::studio
