// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/machine_file.h"

#include <gmock/gmock.h>

namespace dgt {
namespace {

using Kind = MachineEntry::Kind;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string cut(const std::string& text, const TextSpan& span) {
  return text.substr(span.begin, span.end - span.begin);
}

/// `key=value value @key@value`, the last two cut from the text where the entry says they stand.
std::vector<std::string> entries(const std::string& text) {
  std::vector<std::string> lines;
  const auto read = read_machine_text(text);
  if (!read) return {"fault at " + cut(text, read.error().span)};
  for (const MachineEntry& entry : *read) {
    std::string line = entry.key + "=";
    for (const std::string& value : entry.values) line += value + ";";
    lines.push_back(line + " @" + cut(text, entry.key_span) + "@" + cut(text, entry.value_span));
  }
  return lines;
}

Kind kind_of(const std::string& value) { return read_machine_text("a = " + value)->at(0).kind; }
std::string value_of(const std::string& value) {
  return read_machine_text("a = " + value)->at(0).values.at(0);
}

TEST(MachineFile, EntriesComeInTheOrderOfTheTextWithTheirPlaces) {
  EXPECT_THAT(entries("# Проволока\r\nunit = 0.05 # мм\r\n\"decimals\"=+3\ntorch_on = 'M3 S1'\n"),
              ElementsAre("unit=0.05; @unit@0.05", "decimals=3; @\"decimals\"@+3",
                          "torch_on=M3 S1; @torch_on@'M3 S1'"));
}

TEST(MachineFile, TablesStandBeforeTheirKeys) {
  EXPECT_THAT(entries("essi.rotation = 'cw'\n[essi]\nscale_unit = 'percent'\n"),
              ElementsAre("fault at [essi]"));
  EXPECT_THAT(entries("b = 1\n[essi]\nrotation = 'cw'\n[a.b]\nc = 1\n"),
              ElementsAre("b=1; @b@1", "essi.rotation=cw; @rotation@'cw'", "a.b.c=1; @c@1"));
}

TEST(MachineFile, ANumberIsTheDecimalThatIsWritten) {
  EXPECT_EQ(value_of("0.05"), "0.05");
  EXPECT_EQ(value_of("0.1000000000000000000000000000001"), "0.1000000000000000000000000000001");
  EXPECT_EQ(value_of("-0.5"), "-0.5");
  EXPECT_EQ(value_of("+1_000.25"), "+1000.25");
  EXPECT_EQ(value_of("10_000_000"), "10000000");
  EXPECT_EQ(value_of("0x1F"), "31");
  EXPECT_EQ(value_of("inf"), "inf");
}

TEST(MachineFile, AnExponentMovesThePoint) {
  EXPECT_EQ(value_of("5e-2"), "0.05");
  EXPECT_EQ(value_of("1_0.5e-2"), "0.105");
  EXPECT_EQ(value_of("1.25E+1"), "12.5");
  EXPECT_EQ(value_of("1.25e2"), "125");
  EXPECT_EQ(value_of("-2e3"), "-2000");
  EXPECT_EQ(value_of("1.5e0"), "1.5");
}

TEST(MachineFile, ValuesAreOfFourKinds) {
  EXPECT_EQ(kind_of("1"), Kind::Number);
  EXPECT_EQ(kind_of("1.5"), Kind::Number);
  EXPECT_EQ(kind_of("\"1.5\""), Kind::Text);
  EXPECT_EQ(kind_of("['a', \"b\"]"), Kind::List);
  EXPECT_EQ(kind_of("[]"), Kind::List);
  for (const char* other : {"true", "1979-05-27", "[1]", "['a', 1]", "{}", "[{}]"})
    EXPECT_EQ(kind_of(other), Kind::Other) << other;
}

TEST(MachineFile, AListMayTakeSeveralLines) {
  const auto read = read_machine_text("p = ['a',\n  'b']\n");
  EXPECT_THAT(read->at(0).values, ElementsAre("a", "b"));
}

TEST(MachineFile, AnEmptyFileAndAnEmptyTable) {
  EXPECT_THAT(entries(""), IsEmpty());
  EXPECT_THAT(entries("# nothing\n"), IsEmpty());
  EXPECT_THAT(entries("[tape]\n"), ElementsAre("tape=[tape]; @tape@[tape]"));
}

TEST(MachineFile, AFaultOfSyntaxIsPlaced) {
  using Fault = MachineSyntaxFault::Kind;
  const auto fault = [](const std::string& text) {
    const auto read = read_machine_text(text);
    EXPECT_FALSE(read.has_value()) << text;
    if (read) return std::string("none");
    return (read.error().kind == Fault::KeyTwice ? "twice " : "") + cut(text, read.error().span);
  };
  EXPECT_EQ(fault("unit = 0,05"), ",05");
  EXPECT_EQ(fault("# Ж\ntorch_on = M3 S1\nx=1"), "M3 S1");
  EXPECT_EQ(fault("feed = 1\nunit =\nx=1"), "unit =");
  EXPECT_EQ(fault("a=1\ndialect = \"essi\nx=1"), "dialect = \"essi");
  EXPECT_EQ(fault("unit"), "unit");
  EXPECT_EQ(fault("unit=1\nfeed=2\nunit = 2 # again\nx=1"), "twice unit");
  EXPECT_EQ(fault("[t]\n[t]\n"), "twice [t]");
  EXPECT_EQ(fault("единица = 1"), "единица = 1");
}

}  // namespace
}  // namespace dgt
