// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/machine.h"

#include <gtest/gtest.h>

namespace dgt {
namespace {

tl::expected<Dialect, SettingFault> set(const char* dialect, const char* text) {
  return parse_setting(text).and_then(
      [&](const Setting& s) { return with_setting(*find_dialect(dialect), s); });
}

TEST(Settings, ChangeTheirField) {
  EXPECT_EQ(set("essi", "unit=0.01")->unit, Rational(1, 100));
  EXPECT_EQ(set("plasmatic", "decimals=3")->unit, Rational(1, 1000));
  EXPECT_EQ(*set("linuxcnc", "feed=120.5")->feed, Rational(241, 2));
  EXPECT_EQ(set("linuxcnc", "default_feed=7")->default_feed, 7);
  EXPECT_EQ(set("linuxcnc", "torch_on=M3 S1")->torch_on, "M3 S1");
  EXPECT_EQ(set("linuxcnc", "torch_off=")->torch_off, "");
  EXPECT_EQ(set("essi", "torch=program")->torch, TorchPolicy::Program);
  EXPECT_EQ(set("linuxcnc", "torch=none")->torch, TorchPolicy::None);
  EXPECT_EQ(set("plasmatic", "dwell_unit=ms")->dwell_unit, DwellUnit::Milliseconds);
  EXPECT_EQ(set("essi", "max_arc_degrees=90")->max_arc_degrees, 90);
  EXPECT_EQ(set("plasmatic", "radius_mismatch=0.005")->radius_mismatch, Rational(1, 200));
  EXPECT_EQ(set("essi", "line_end=crlf")->line_end, "\r\n");
}

TEST(Settings, AnUnknownKeyNamesTheNearest) {
  const auto r = set("essi", "torch_of=x");
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().kind, SettingFault::Kind::UnknownKey);
  EXPECT_EQ(r.error().key, "torch_of");
  EXPECT_EQ(r.error().nearest, "torch_off");
  EXPECT_EQ(set("essi", "units=1").error().nearest, "unit");
}

TEST(Settings, ABadValueSaysWhatIsExpected) {
  for (const char* text :
       {"unit=0", "unit=-1", "unit=x", "unit=0.0000001", "unit=1.000001", "decimals=9",
        "decimals=", "feed=0", "torch=on", "dwell_unit=min", "max_arc_degrees=170",
        "radius_mismatch=2", "line_end=cr", "torch_on=a\nb", "pass_codes=M5-M3", "pass_codes=G1",
        "pass_codes=M101", "pass_codes=M1-", "pass_codes=M-1"}) {
    const auto r = set("essi", text);
    ASSERT_FALSE(r) << text;
    EXPECT_EQ(r.error().kind, SettingFault::Kind::BadValue) << text;
    EXPECT_FALSE(r.error().expected.empty()) << text;
  }
}

TEST(Settings, WithoutAnEqualsSignThereIsNoValue) {
  EXPECT_EQ(parse_setting("unit").error().kind, SettingFault::Kind::NoValue);
  EXPECT_EQ(parse_setting("=1").error().kind, SettingFault::Kind::NoValue);
  EXPECT_EQ(parse_setting("torch_on=A=B")->value, "A=B");
}

TEST(Settings, CodesPassThatTheDialectDoesNotKnow) {
  const auto words = [](const char* dialect, const char* text, const char* code) {
    const CodeMeaning meaning = meaning_of(*set(dialect, text), code);
    return meaning.kind == CodeMeaning::Kind::Words ? meaning.words : "unknown";
  };
  EXPECT_EQ(words("linuxcnc", "pass_codes=", "M100"), "unknown");
  EXPECT_EQ(words("linuxcnc", "pass_codes=M100-M199", "M100"), "M100");
  EXPECT_EQ(words("linuxcnc", "pass_codes=M100-M199", "M199"), "M199");
  EXPECT_EQ(words("linuxcnc", "pass_codes=M100-M199", "M200"), "unknown");
  EXPECT_EQ(words("plasmatic", "pass_codes=10, M21", "M010"), "M10");
  EXPECT_EQ(words("plasmatic", "pass_codes=10, M21", "M21"), "M21");
  EXPECT_EQ(words("plasmatic", "pass_codes=10, M21", "M11"), "unknown");
  EXPECT_EQ(words("essi", "pass_codes=M15", "M15"), "15");
}

TEST(Settings, ATorchCodeThatPassesStaysATorchCode) {
  EXPECT_EQ(meaning_of(*set("plasmatic", "pass_codes=M3-M5"), "M3").words, "M3");
  EXPECT_EQ(meaning_of(*set("plasmatic", "pass_codes=M3-M5"), "M3").torch, TorchAct::On);
  EXPECT_EQ(meaning_of(*set("plasmatic", "pass_codes=M3-M5"), "M5").torch, TorchAct::Off);
}

TEST(Settings, WithoutATorchItsCodesAreLikeAnyOther) {
  EXPECT_EQ(meaning_of(*set("linuxcnc", "torch=none"), "M8").torch, TorchAct::None);
  EXPECT_EQ(meaning_of(*set("linuxcnc", "torch=none"), "M8").words, "M08");
}

TEST(Settings, EveryKeyIsListed) { EXPECT_EQ(dialect_settings().size(), 13u); }

TEST(NearestKey, OfNoneIsEmpty) { EXPECT_EQ(nearest_key("x", {}), ""); }

}  // namespace
}  // namespace dgt
