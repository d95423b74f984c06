// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/tape_settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <optional>
#include <utility>

#include "kernel/number.h"

namespace dgt {
namespace {

using Text = std::string_view;

bool set_whole(std::uint32_t& target, Text text, std::uint32_t least, std::uint32_t most) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return false;
  if (value < least || value > most) return false;
  target = value;
  return true;
}

/// Seconds from 0.1 to 600, thousandths at most.
bool set_time(std::chrono::milliseconds& target, Text text) {
  const auto seconds = parse_decimal(text);
  if (!seconds || *seconds < Rational(1, 10) || *seconds > 600) return false;
  const Rational milliseconds = *seconds * 1000;
  if (milliseconds.get_den() != 1) return false;
  target = std::chrono::milliseconds(milliseconds.get_num().get_si());
  return true;
}

template <class T>
bool choose(T& target, Text text, std::initializer_list<std::pair<Text, T>> choices) {
  for (const auto& [name, value] : choices) {
    if (name != text) continue;
    target = value;
    return true;
  }
  return false;
}

bool set_baud(LineSettings& line, Text text) {
  return set_whole(line.baud, text, kBauds.front(), kBauds.back()) &&
         std::ranges::find(kBauds, line.baud) != kBauds.end();
}

bool set_handshake(LineSettings& line, Text text) {
  return choose<Handshake>(
      line.handshake, text,
      {{"none", Handshake::None}, {"xonxoff", Handshake::XonXoff}, {"rtscts", Handshake::RtsCts}});
}

bool set_device(std::string& device, Text text) {
  device = text;
  return !text.empty();
}

constexpr std::uint32_t kLongest = 10'000;     // mm
constexpr std::uint32_t kFastest = 100'000;    // rows/s
constexpr std::uint32_t kMostBuffer = 65'536;  // rows

constexpr Text kBaudsExpected =
    "110|150|300|600|1200|2400|4800|9600|19200|38400|57600|115200|230400|460800";

struct Rule {
  SettingKey key;
  bool (*apply)(TapeSettings&, Text);
};

constexpr std::array kRules{
    Rule{{"tape.leader", "0…10000 mm"},
         [](TapeSettings& s, Text text) { return set_whole(s.format.leader, text, 0, kLongest); }},
    Rule{{"tape.trailer", "0…10000 mm"},
         [](TapeSettings& s, Text text) { return set_whole(s.format.trailer, text, 0, kLongest); }},
    Rule{{"tape.start", "percent|none"},
         [](TapeSettings& s, Text text) {
           return choose<TapeStart>(s.format.start, text,
                                    {{"percent", TapeStart::Percent}, {"none", TapeStart::None}});
         }},
    Rule{{"tape.line_end", "crlf|lf"},
         [](TapeSettings& s, Text text) {
           return choose<TapeLineEnd>(s.format.line_end, text,
                                      {{"crlf", TapeLineEnd::CrLf}, {"lf", TapeLineEnd::Lf}});
         }},
    Rule{{"tape.unpunchable", "refuse|drop|transliterate"},
         [](TapeSettings& s, Text text) {
           return choose<Unpunchable>(s.format.unpunchable, text,
                                      {{"refuse", Unpunchable::Refuse},
                                       {"drop", Unpunchable::Drop},
                                       {"transliterate", Unpunchable::Transliterate}});
         }},
    Rule{{"tape.header", "none|name"},
         [](TapeSettings& s, Text text) {
           return choose<bool>(s.header_is_name, text, {{"none", false}, {"name", true}});
         }},
    Rule{{"tape.checksum", "none|line"},
         [](TapeSettings& s, Text text) {
           return choose<TapeChecksum>(
               s.format.checksum, text,
               {{"none", TapeChecksum::None}, {"line", TapeChecksum::Line}});
         }},
    Rule{{"tape.before_start", "checked|ignored"},
         [](TapeSettings& s, Text text) {
           return choose<BeforeStart>(
               s.format.before_start, text,
               {{"checked", BeforeStart::Checked}, {"ignored", BeforeStart::Ignored}});
         }},
    Rule{{"punch.device", "\"/dev/ttyS0\""},
         [](TapeSettings& s, Text text) { return set_device(s.punch.device, text); }},
    Rule{{"punch.speed", "1…100000 rows/s"},
         [](TapeSettings& s, Text text) { return set_whole(s.punch.speed, text, 1, kFastest); }},
    Rule{{"punch.baud", kBaudsExpected},
         [](TapeSettings& s, Text text) { return set_baud(s.punch.line, text); }},
    Rule{{"punch.handshake", "none|xonxoff|rtscts"},
         [](TapeSettings& s, Text text) { return set_handshake(s.punch.line, text); }},
    Rule{{"punch.timeout", "0.1…600 s"},
         [](TapeSettings& s, Text text) { return set_time(s.punch.timeout, text); }},
    Rule{
        {"punch.buffer", "0…65536 rows"},
        [](TapeSettings& s, Text text) { return set_whole(s.punch.buffer, text, 0, kMostBuffer); }},
    Rule{{"reader.device", "\"/dev/ttyS1\""},
         [](TapeSettings& s, Text text) { return set_device(s.reader.device, text); }},
    Rule{{"reader.speed", "1…100000 rows/s"},
         [](TapeSettings& s, Text text) { return set_whole(s.reader.speed, text, 1, kFastest); }},
    Rule{{"reader.baud", kBaudsExpected},
         [](TapeSettings& s, Text text) { return set_baud(s.reader.line, text); }},
    Rule{{"reader.handshake", "none|xonxoff|rtscts"},
         [](TapeSettings& s, Text text) { return set_handshake(s.reader.line, text); }},
    Rule{{"reader.timeout", "0.1…600 s"},
         [](TapeSettings& s, Text text) { return set_time(s.reader.timeout, text); }},
};

constexpr auto kKeys = [] {
  std::array<SettingKey, kRules.size()> keys{};
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = kRules[i].key;
  return keys;
}();

}  // namespace

std::span<const SettingKey> tape_settings() { return kKeys; }

tl::expected<TapeSettings, SettingFault> with_setting(TapeSettings settings,
                                                      const Setting& setting) {
  const auto rule = std::ranges::find(kRules, setting.key, [](const Rule& r) { return r.key.key; });
  if (rule == kRules.end()) return tl::unexpected(unknown_key(setting, {}));
  if (!rule->apply(settings, setting.value)) {
    return tl::unexpected(bad_value(rule->key, setting.value));
  }
  return settings;
}

}  // namespace dgt
