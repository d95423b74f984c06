// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/dialect_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

namespace dgt {
namespace {

using Entry = MachineEntry;
using FaultKind = DialectFileFault::Kind;

constexpr std::string_view kTranslate = "codes.translate.";

const std::string& value_of(const Entry& entry) {
  static const std::string kNone;
  return entry.values.empty() ? kNone : entry.values.front();
}

bool is_printable(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) >= ' '; });
}

bool read_text(std::string& target, const Entry& entry) {
  if (entry.kind != Entry::Kind::Text || !is_printable(entry.values.front())) return false;
  target = entry.values.front();
  return true;
}

/// A text stands for a list of one.
bool read_list(std::vector<std::string>& target, const Entry& entry) {
  if (entry.kind != Entry::Kind::Text && entry.kind != Entry::Kind::List) return false;
  if (!std::ranges::all_of(entry.values, is_printable)) return false;
  target = entry.values;
  return true;
}

/// Lines as one text, parted by line feeds.
bool read_lines(std::string& target, const Entry& entry) {
  std::vector<std::string> lines;
  if (!read_list(lines, entry)) return false;
  target.clear();
  for (const std::string& line : lines) target += (target.empty() ? "" : "\n") + line;
  return true;
}

bool read_flag(bool& target, const Entry& entry) {
  const std::string& value = value_of(entry);
  if (entry.kind != Entry::Kind::Other || (value != "true" && value != "false")) return false;
  target = value == "true";
  return true;
}

template <class T>
bool read_whole(T& target, const Entry& entry, int least, int most) {
  const std::string& value = value_of(entry);
  int number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (entry.kind != Entry::Kind::Number || error != std::errc() ||
      end != value.data() + value.size() || number < least || number > most)
    return false;
  target = static_cast<T>(number);
  return true;
}

template <class T>
bool choose(T& target, const Entry& entry,
            std::initializer_list<std::pair<std::string_view, T>> choices) {
  if (entry.kind != Entry::Kind::Text) return false;
  for (const auto& [name, value] : choices) {
    if (name != value_of(entry)) continue;
    target = value;
    return true;
  }
  return false;
}

/// As the setting of that name, so that both take the same values.
bool read_setting(Dialect& dialect, std::string_view setting, const Entry& entry) {
  if (entry.kind != Entry::Kind::Text && entry.kind != Entry::Kind::Number) return false;
  auto changed = with_setting(dialect, {std::string(setting), value_of(entry)});
  if (changed) dialect = *std::move(changed);
  return changed.has_value();
}

bool read_known_codes(Dialect& dialect, const Entry& entry) {
  if (entry.kind != Entry::Kind::Text) return false;
  auto codes = code_ranges(value_of(entry), Form::Gcode);
  if (codes) dialect.known_codes = *std::move(codes);
  return codes.has_value();
}

bool read_largest(Dialect& dialect, const Entry& entry) {
  const auto value = parse_decimal(value_of(entry));
  if (entry.kind != Entry::Kind::Number || !value || sgn(*value) <= 0) return false;
  dialect.largest = shared(*value);
  return true;
}

bool read_least_radius(Dialect& dialect, const Entry& entry) {
  const auto value = parse_decimal(value_of(entry));
  if (entry.kind != Entry::Kind::Number || !value || sgn(*value) < 0 || *value > 1) return false;
  dialect.least_radius = *value;
  return true;
}

bool read_positions(Dialect& dialect, const Entry& entry) {
  Positions& positions = dialect.positions;
  if (entry.kind == Entry::Kind::Text && value_of(entry) == "incremental") {
    positions = Positions::Incremental;
    return true;
  }
  // The others have no word for a place.
  return dialect.form == Form::Gcode &&
         choose(positions, entry, {{"absolute", Positions::Absolute}});
}

bool read_arc_form(Dialect& dialect, const Entry& entry) {
  if (entry.kind == Entry::Kind::Text && value_of(entry) == "centre") {
    dialect.arc_form = ArcForm::Centre;
    return true;
  }
  if (dialect.form == Form::ThreeB) return false;
  // Until the file says another: the middle of a radius-form arc moves by |1 − 1/cos(θ/2)| for each
  // unit of R, which is 1 at 120°.
  dialect.max_arc_degrees = 120;
  return choose(dialect.arc_form, entry, {{"radius", ArcForm::Radius}});
}

struct Rule {
  SettingKey key;
  bool (*apply)(Dialect&, const Entry&);
};

/// A member that is a text, a list or a flag.
template <auto Member>
bool member(Dialect& dialect, const Entry& entry) {
  auto& target = dialect.*Member;
  using T = std::remove_reference_t<decltype(target)>;
  if constexpr (std::is_same_v<T, std::string>) {
    return read_text(target, entry);
  } else if constexpr (std::is_same_v<T, bool>) {
    return read_flag(target, entry);
  } else {
    return read_list(target, entry);
  }
}
template <auto Member>
bool spelling(Dialect& dialect, const Entry& entry) {
  auto& target = dialect.spelling.*Member;
  if constexpr (std::is_same_v<std::remove_reference_t<decltype(target)>, bool>) {
    return read_flag(target, entry);
  } else {
    return read_text(target, entry);
  }
}
template <auto Member>
bool kerf(Dialect& dialect, const Entry& entry) {
  return read_list(dialect.kerf.*Member, entry);
}

constexpr std::string_view kWord = "\"words\"";
constexpr std::string_view kWords = "\"words\" or [\"line\", \"line\"]";
constexpr std::string_view kFlag = "true|false";

/// `form` comes first: others depend on it.
constexpr std::array kRules{
    Rule{{"form", "words|signed|3b"},
         [](Dialect& d, const Entry& e) {
           return choose(d.form, e,
                         {{"words", Form::Gcode}, {"signed", Form::Essi}, {"3b", Form::ThreeB}});
         }},
    Rule{{"about", kWord}, member<&Dialect::about>},
    Rule{{"about_ru", kWord}, member<&Dialect::about_ru>},
    Rule{{"unit", "0.000001…100 mm"},
         [](Dialect& d, const Entry& e) { return read_setting(d, "unit", e); }},
    Rule{{"positions", "absolute|incremental"}, read_positions},
    Rule{{"program.header", kWords}, member<&Dialect::header>},
    Rule{{"program.footer", kWords}, member<&Dialect::footer>},
    Rule{{"program.line_end", "lf|crlf"},
         [](Dialect& d, const Entry& e) { return read_setting(d, "line_end", e); }},
    Rule{{"program.rapid_to_start", kFlag}, member<&Dialect::rapid_to_start>},
    Rule{{"program.longest_line", "20…1000"},
         [](Dialect& d, const Entry& e) { return read_whole(d.longest_line, e, 20, 1000); }},
    Rule{{"numbers.largest", "above 0 mm"}, read_largest},
    Rule{{"numbers.plus", kFlag}, spelling<&Spelling::plus>},
    Rule{{"numbers.point", kFlag}, spelling<&Spelling::point>},
    Rule{{"numbers.trailing_zeros", kFlag}, spelling<&Spelling::trailing_zeros>},
    Rule{{"words.rapid", kWord}, spelling<&Spelling::rapid>},
    Rule{{"words.line", kWord}, spelling<&Spelling::line>},
    Rule{{"words.arc_cw", kWord}, spelling<&Spelling::clockwise>},
    Rule{{"words.arc_ccw", kWord}, spelling<&Spelling::counter_clockwise>},
    Rule{{"words.x", kWord}, spelling<&Spelling::x>},
    Rule{{"words.y", kWord}, spelling<&Spelling::y>},
    Rule{{"words.z", kWord}, spelling<&Spelling::z>},
    Rule{{"words.i", kWord}, spelling<&Spelling::i>},
    Rule{{"words.j", kWord}, spelling<&Spelling::j>},
    Rule{{"words.r", kWord}, spelling<&Spelling::r>},
    Rule{{"words.separator", kWord}, spelling<&Spelling::separator>},
    Rule{{"words.zero", kFlag}, spelling<&Spelling::zero_words>},
    Rule{{"words.repeat_motion", kFlag}, spelling<&Spelling::repeats_motion>},
    Rule{{"words.repeat_position", kFlag}, spelling<&Spelling::repeats_position>},
    Rule{{"line_numbers.word", kWord},
         [](Dialect& d, const Entry& e) { return read_text(d.line_numbers.word, e); }},
    Rule{{"line_numbers.first", "0…99999"},
         [](Dialect& d, const Entry& e) { return read_whole(d.line_numbers.first, e, 0, 99999); }},
    Rule{{"line_numbers.step", "1…1000"},
         [](Dialect& d, const Entry& e) { return read_whole(d.line_numbers.step, e, 1, 1000); }},
    Rule{{"rapids.begin", kWord}, member<&Dialect::rapids_begin>},
    Rule{{"rapids.end", kWord}, member<&Dialect::rapids_end>},
    Rule{{"arcs.form", "centre|radius"}, read_arc_form},
    Rule{{"arcs.max_degrees", "10…180° (R: 10…150°)"},
         [](Dialect& d, const Entry& e) { return read_setting(d, "max_arc_degrees", e); }},
    Rule{{"arcs.radius_mismatch", "0…1 mm"},
         [](Dialect& d, const Entry& e) { return read_setting(d, "radius_mismatch", e); }},
    Rule{{"arcs.least_radius", "0…1 mm"}, read_least_radius},
    Rule{{"arcs.centre", "from_start|absolute"},
         [](Dialect& d, const Entry& e) {
           return choose(d.centre_is_absolute, e, {{"from_start", false}, {"absolute", true}});
         }},
    Rule{{"arcs.plus", "cw|ccw"},
         [](Dialect& d, const Entry& e) {
           return choose(d.plus_is_ccw, e, {{"cw", false}, {"ccw", true}});
         }},
    Rule{{"torch.policy", "auto|program|none"},
         [](Dialect& d, const Entry& e) { return read_setting(d, "torch", e); }},
    Rule{{"torch.on", kWords},
         [](Dialect& d, const Entry& e) { return read_lines(d.torch_on, e); }},
    Rule{{"torch.off", kWords},
         [](Dialect& d, const Entry& e) { return read_lines(d.torch_off, e); }},
    Rule{{"torch.on_codes", kWords}, member<&Dialect::torch_on_codes>},
    Rule{{"torch.off_codes", kWords}, member<&Dialect::torch_off_codes>},
    Rule{{"torch.own_on_codes", kWords}, member<&Dialect::own_torch_on_codes>},
    Rule{{"torch.own_off_codes", kWords}, member<&Dialect::own_torch_off_codes>},
    Rule{{"codes.known", "\"M0-M1 M3-M9\""}, read_known_codes},
    Rule{{"codes.pass_letters", "\"ST\""}, member<&Dialect::passed_letters>},
    Rule{{"codes.drop_letters", "\"S\""}, member<&Dialect::dropped_letters>},
    Rule{
        {"codes.pass_numbers_below", "0…30000"},
        [](Dialect& d, const Entry& e) { return read_whole(d.passed_numbers_below, e, 0, 30000); }},
    Rule{
        {"feed.word", kWord},
        [](Dialect& d, const Entry& e) { return d.writes_feed = true, read_text(d.feed_word, e); }},
    Rule{{"feed.decimals", "0…6"},
         [](Dialect& d, const Entry& e) { return read_whole(d.feed_decimals, e, 0, 6); }},
    Rule{{"feed.needed", kFlag}, member<&Dialect::needs_feed>},
    Rule{{"feed.default", "0.001…1000000 mm/min"},
         [](Dialect& d, const Entry& e) { return read_setting(d, "default_feed", e); }},
    Rule{{"heights", kFlag}, member<&Dialect::writes_height>},
    Rule{{"dwell.word", kWord}, member<&Dialect::dwell_word>},
    Rule{{"dwell.unit", "s|0.1s|ms"},
         [](Dialect& d, const Entry& e) { return read_setting(d, "dwell_unit", e); }},
    Rule{{"dwell.decimals", "0…6"},
         [](Dialect& d, const Entry& e) { return read_whole(d.dwell_decimals, e, 0, 6); }},
    Rule{{"kerf.left", kWords}, kerf<&KerfWords::left>},
    Rule{{"kerf.right", kWords}, kerf<&KerfWords::right>},
    Rule{{"kerf.off", kWords}, kerf<&KerfWords::off>},
    Rule{{"kerf.entry", "meets|beside|either"},
         [](Dialect& d, const Entry& e) {
           return choose(d.kerf.entry, e,
                         {{"meets", KerfEntry::Meets},
                          {"beside", KerfEntry::Beside},
                          {"either", KerfEntry::Either}});
         }},
    Rule{{"kerf.corners", "extend|round"},
         [](Dialect& d, const Entry& e) {
           return choose(d.kerf.rounds_corners, e, {{"extend", false}, {"round", true}});
         }},
};

constexpr SettingKey kBase{"base", "the name of a dialect"};
constexpr SettingKey kAnyCode{"codes.translate.*", kWords};

const std::vector<SettingKey>& keys() {
  static const std::vector<SettingKey> all = [] {
    std::vector<SettingKey> made{kBase};
    for (const Rule& rule : kRules) made.push_back(rule.key);
    made.push_back(kAnyCode);
    return made;
  }();
  return all;
}

/// Reads one text.
class DialectReader {
 public:
  DialectReader(std::string name, std::span<const Dialect> known)
      : name_(std::move(name)), known_(known) {}

  DialectFile read(std::string_view text) {
    auto entries = read_machine_text(text);
    if (!entries) {
      const bool twice = entries.error().kind == MachineSyntaxFault::Kind::KeyTwice;
      const TextSpan span = entries.error().span;
      fault(twice ? FaultKind::KeyTwice : FaultKind::Syntax, span,
            std::string(text.substr(span.begin, span.end - span.begin)));
      return std::move(file_);
    }
    entries_ = *std::move(entries);
    begin();
    // In the order of the rules, whatever that of the file.
    for (const Rule& rule : kRules) {
      const Entry* const entry = find(rule.key.key);
      if (entry != nullptr && !rule.apply(file_.dialect, *entry)) bad_value(rule.key, *entry);
    }
    for (const Entry& entry : entries_) read_rest(entry);
    file_.dialect.name = name_;
    std::ranges::stable_sort(file_.faults, {}, [](const auto& f) { return f.span.begin; });
    return std::move(file_);
  }

 private:
  const Entry* find(std::string_view key) const {
    const auto found = std::ranges::find(entries_, key, &Entry::key);
    return found == entries_.end() ? nullptr : &*found;
  }

  void begin() {
    if (const Entry* const base = find(kBase.key)) {
      const auto found = std::ranges::find(known_, value_of(*base), &Dialect::name);
      if (found == known_.end()) return bad_value(kBase, *base);
      file_.dialect = *found;
    } else if (find("form") == nullptr) {
      const SettingKey& form = kRules.front().key;
      file_.faults.push_back(
          {FaultKind::KeyLacking, {}, std::string(form.key), "", std::string(form.expected)});
    }
  }

  /// Codes that are translated, and what is no key.
  void read_rest(const Entry& entry) {
    if (entry.key.starts_with(kTranslate)) {
      CodeWord word{entry.key.substr(kTranslate.size()), ""};
      if (!read_lines(word.words, entry)) return bad_value(kAnyCode, entry);
      std::erase_if(file_.dialect.codes, [&](const CodeWord& w) { return w.code == word.code; });
      return file_.dialect.codes.push_back(std::move(word));
    }
    std::vector<std::string_view> names;
    for (const SettingKey& key : keys()) names.push_back(key.key);
    if (std::ranges::find(names, std::string_view(entry.key)) != names.end()) return;
    file_.faults.push_back({FaultKind::UnknownKey, entry.key_span, entry.key,
                            std::string(nearest_key(entry.key, names)), ""});
  }

  void fault(FaultKind kind, const TextSpan& span, std::string key) {
    file_.faults.push_back({kind, span, std::move(key), "", ""});
  }
  void bad_value(const SettingKey& key, const Entry& entry) {
    file_.faults.push_back({FaultKind::BadValue, entry.value_span, std::string(key.key), "",
                            std::string(key.expected)});
  }

  std::string name_;
  std::span<const Dialect> known_;
  std::vector<Entry> entries_;
  DialectFile file_;
};

}  // namespace

std::span<const SettingKey> dialect_keys() { return keys(); }

DialectFile read_dialect(std::string name, std::string_view text, std::span<const Dialect> known) {
  return DialectReader(std::move(name), known).read(text);
}

DialectFile read_dialect(std::string name, std::string_view text) {
  return read_dialect(std::move(name), text, dialects());
}

}  // namespace dgt
