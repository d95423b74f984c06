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
        "radius_mismatch=2", "line_end=cr", "torch_on=a\nb"}) {
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

TEST(Settings, EveryKeyIsListed) { EXPECT_EQ(dialect_settings().size(), 11u); }

TEST(NearestKey, OfNoneIsEmpty) { EXPECT_EQ(nearest_key("x", {}), ""); }

}  // namespace
}  // namespace dgt
