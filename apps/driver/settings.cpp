// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <optional>

#include "lang/text/reading.h"
#include "post/dialect_file.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDialect = "dialect";
constexpr std::string_view kMacroPath = "macro_path";
/// Deeper programs are mistakes, and the evaluator goes as deep itself.
constexpr std::uint64_t kMostDepth = 1000;
constexpr std::uint64_t kMostWork = 1'000'000'000'000;

template <class T>
bool set_whole(T& target, std::string_view text, std::uint64_t most) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return false;
  if (value < 1 || value > most) return false;
  target = static_cast<T>(value);
  return true;
}

bool set_depth(std::uint32_t& depth, std::string_view text) {
  return set_whole(depth, text, kMostDepth);
}

bool set_offset_side(Settings& settings, std::string_view text) {
  OffsetSide& side = settings.source.evaluate.offset_side;
  if (text == "auto") return side = OffsetSide::Auto, true;
  if (text == "left") return side = OffsetSide::Left, true;
  if (text == "right") return side = OffsetSide::Right, true;
  return false;
}

bool set_gouge(Settings& settings, std::string_view text) {
  GougePolicy& gouge = settings.source.evaluate.gouge;
  if (text == "error") return gouge = GougePolicy::Error, true;
  if (text == "warn") return gouge = GougePolicy::Warn, true;
  if (text == "trim") return gouge = GougePolicy::Trim, true;
  return false;
}

bool set_crossings(Settings& settings, std::string_view text) {
  CrossingMoves& crossings = settings.source.evaluate.crossings;
  if (text == "all") return crossings = CrossingMoves::All, true;
  if (text == "leads") return crossings = CrossingMoves::Leads, true;
  if (text == "none") return crossings = CrossingMoves::None, true;
  return false;
}

bool set_corner(Settings& settings, std::string_view text) {
  CornerStyle& corner = settings.source.evaluate.corner;
  if (text == "extend") return corner = CornerStyle::Extend, true;
  if (text == "round") return corner = CornerStyle::Round, true;
  if (text == "chamfer") return corner = CornerStyle::Chamfer, true;
  return false;
}

bool set_corner_limit(Settings& settings, std::string_view text) {
  auto value = parse_decimal(text);
  if (!value || *value < 1 || *value > 1000) return false;
  settings.source.evaluate.corner_limit = *std::move(value);
  return true;
}

bool set_join_tolerance(Settings& settings, std::string_view text) {
  auto value = parse_decimal(text);
  if (!value || sgn(*value) < 0) return false;
  settings.source.evaluate.join_tolerance = *std::move(value);
  return true;
}

/// Folders between colons, as in PATH.
bool set_macro_path(Settings& settings, std::string_view text) {
  std::vector<std::string>& folders = settings.source.macro_path;
  folders.clear();
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(':'), text.size());
    if (end > 0) folders.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return true;
}

/// The readers of NC programs share options.
template <class Change>
void change_nc(Settings& settings, Change&& change) {
  change(settings.source.essi.nc);
  change(settings.source.gcode.nc);
  change(settings.source.three_b.nc);
}

std::optional<Rational> decimal_between(std::string_view text, const Rational& least,
                                        const Rational& most) {
  auto value = parse_decimal(text);
  if (!value || *value < least || *value > most) return std::nullopt;
  return value;
}

bool set_arc_tolerance(Settings& settings, std::string_view text) {
  const auto value = decimal_between(text, 0, 10);
  if (value) change_nc(settings, [&](NcOptions& nc) { nc.arc_tolerance = *value; });
  return value.has_value();
}

bool set_kerf(Settings& settings, std::string_view text) {
  const auto value = decimal_between(text, 0, 100);
  if (value) {
    change_nc(settings, [&](NcOptions& nc) { nc.kerf_width = *value; });
    settings.source.dxf.kerf_width = *value;
  }
  return value.has_value();
}

bool set_sense(RotationSense& sense, std::string_view text) {
  if (text == "ccw") return sense = RotationSense::CounterClockwise, true;
  if (text == "cw") return sense = RotationSense::Clockwise, true;
  return false;
}

bool set_essi_dialect(Settings& settings, std::string_view text) {
  EssiDialect& dialect = settings.source.essi.dialect;
  if (text == "essi") return dialect = EssiDialect::Guide, true;
  if (text == "essi-iso") return dialect = EssiDialect::Iso, true;
  return false;
}

bool set_essi_unit(Settings& settings, std::string_view text) {
  const auto value = decimal_between(text, Rational(1, 1'000'000), 100);
  if (value) settings.source.essi.unit = *value;
  return value.has_value();
}

bool set_scale_unit(Settings& settings, std::string_view text) {
  Rational& unit = settings.source.essi.scale_unit;
  if (text == "percent") return unit = Rational(1, 100), true;
  if (text == "permille") return unit = Rational(1, 1000), true;
  return false;
}

bool set_three_b_unit(Settings& settings, std::string_view text) {
  const auto value = decimal_between(text, Rational(1, 1'000'000), 100);
  if (value) settings.source.three_b.unit = *value;
  return value.has_value();
}

bool set_pause(Settings& settings, std::string_view text) {
  ThreeBPause& pause = settings.source.three_b.pause;
  if (text == "rapid") return pause = ThreeBPause::Rapid, true;
  if (text == "stop") return pause = ThreeBPause::Stop, true;
  return false;
}

bool set_end_tolerance(Settings& settings, std::string_view text) {
  const auto value = decimal_between(text, 0, 10);
  if (value) settings.source.three_b.end_tolerance = *value;
  return value.has_value();
}

bool set_positions(Settings& settings, std::string_view text) {
  settings.source.gcode.begins_incremental = text == "incremental";
  return text == "incremental" || text == "absolute";
}

bool set_read_dwell(Settings& settings, std::string_view text) {
  settings.source.gcode.dwell_unit = text == "ms" ? Rational(1, 1000) : Rational(1);
  return text == "ms" || text == "s";
}

/// Names between commas; none: all layers that show.
bool set_layers(Settings& settings, std::string_view text) {
  std::vector<std::string>& layers = settings.source.dxf.layers;
  layers.clear();
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    std::string_view name = text.substr(0, end);
    while (name.starts_with(' ')) name.remove_prefix(1);
    while (name.ends_with(' ')) name.remove_suffix(1);
    if (name.empty()) return false;
    layers.emplace_back(name);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return true;
}

bool set_dxf_unit(Settings& settings, std::string_view text) {
  DxfUnit& unit = settings.source.dxf.unit;
  if (text == "drawing") return unit = DxfUnit::Drawing, true;
  if (text == "mm") return unit = DxfUnit::Millimetre, true;
  if (text == "inch") return unit = DxfUnit::Inch, true;
  return false;
}

bool set_dxf_order(Settings& settings, std::string_view text) {
  std::optional<DxfOrder>& order = settings.source.dxf.order;
  if (text == "auto") return order.reset(), true;
  if (text == "inside-out") return order = DxfOrder::InsideOut, true;
  if (text == "drawn") return order = DxfOrder::File, true;
  return false;
}

bool set_dxf_direction(Settings& settings, std::string_view text) {
  DxfDirection& direction = settings.source.dxf.direction;
  if (text == "drawn") return direction = DxfDirection::Drawn, true;
  if (text == "part-left") return direction = DxfDirection::PartLeft, true;
  if (text == "part-right") return direction = DxfDirection::PartRight, true;
  return false;
}

bool set_dxf_kerf(Settings& settings, std::string_view text) {
  settings.source.dxf.apply_kerf = text == "on";
  return text == "on" || text == "off";
}

bool set_dxf_join_tolerance(Settings& settings, std::string_view text) {
  const auto value = decimal_between(text, 0, 10);
  if (value) settings.source.dxf.join_tolerance = *value;
  return value.has_value();
}

bool set_curve_tolerance(Settings& settings, std::string_view text) {
  const auto value = decimal_between(text, Rational(1, 1'000'000), 10);
  if (value) settings.source.dxf.curve_tolerance = *value;
  return value.has_value();
}

/// What a machine moves with; 0 where `least` says so.
bool set_motion(double& target, std::string_view text, const Rational& least) {
  const auto value = decimal_between(text, least, 1'000'000);
  if (value) target = nearest_double(*value);
  return value.has_value();
}

const Rational& least_motion() {
  static const Rational kLeast(1, 1000);
  return kLeast;
}

struct Rule {
  SettingKey key;
  bool (*apply)(Settings&, std::string_view);
};

constexpr std::array kRules{
    Rule{{kDialect, "essi|essi-iso|plasmatic|linuxcnc|fanuc-wire|grbl|3b|FILE.toml"},
         [](Settings&, std::string_view text) {
           return find_dialect(text) != nullptr || names_dialect_file(text);
         }},
    Rule{{"offset_side", "auto|left|right"}, set_offset_side},
    Rule{{"join_tolerance", "≥ 0 mm"}, set_join_tolerance},
    Rule{{"gouge", "error|warn|trim"}, set_gouge},
    Rule{{"crossings", "all|leads|none"}, set_crossings},
    Rule{{"kerf", "0…100 mm"}, set_kerf},
    Rule{{"arc_tolerance", "0…10 mm"}, set_arc_tolerance},
    Rule{{"essi.dialect", "essi|essi-iso"}, set_essi_dialect},
    Rule{{"essi.unit", "0.000001…100 mm"}, set_essi_unit},
    Rule{{"essi.rotation", "ccw|cw"},
         [](Settings& settings, std::string_view text) {
           return set_sense(settings.source.essi.rotation, text);
         }},
    Rule{{"essi.scale_unit", "percent|permille"}, set_scale_unit},
    Rule{{"essi.iso_plus", "ccw|cw"},
         [](Settings& settings, std::string_view text) {
           return set_sense(settings.source.essi.iso_plus, text);
         }},
    Rule{{"gcode.positions", "absolute|incremental"}, set_positions},
    Rule{{"gcode.dwell_unit", "s|ms"}, set_read_dwell},
    Rule{{"3b.unit", "0.000001…100 mm"}, set_three_b_unit},
    Rule{{"3b.pause", "rapid|stop"}, set_pause},
    Rule{{"3b.end_tolerance", "0…10 mm"}, set_end_tolerance},
    Rule{{"dxf.layers", "NAME,NAME"}, set_layers},
    Rule{{"dxf.unit", "drawing|mm|inch"}, set_dxf_unit},
    Rule{{"dxf.join_tolerance", "0…10 mm"}, set_dxf_join_tolerance},
    Rule{{"dxf.curve_tolerance", "0.000001…10 mm"}, set_curve_tolerance},
    Rule{{"dxf.order", "auto|inside-out|drawn"}, set_dxf_order},
    Rule{{"dxf.direction", "drawn|part-left|part-right"}, set_dxf_direction},
    Rule{{"dxf.kerf", "on|off"}, set_dxf_kerf},
    Rule{{"corner", "extend|round|chamfer"}, set_corner},
    Rule{{"corner_limit", "1…1000"}, set_corner_limit},
    Rule{{"rapid_speed", "0.001…1000000 mm/min"},
         [](Settings& settings, std::string_view text) {
           return set_motion(settings.motion.rapid_speed, text, least_motion());
         }},
    Rule{{"cut_speed", "0.001…1000000 mm/min"},
         [](Settings& settings, std::string_view text) {
           return set_motion(settings.motion.cut_speed, text, least_motion());
         }},
    Rule{{"acceleration", "0.001…1000000 mm/s²"},
         [](Settings& settings, std::string_view text) {
           return set_motion(settings.motion.acceleration, text, least_motion());
         }},
    Rule{{"corner_deviation", "0…1000000 mm"},
         [](Settings& settings, std::string_view text) {
           return set_motion(settings.motion.corner_deviation, text, 0);
         }},
    Rule{{"pierce_time", "0…1000000 s"},
         [](Settings& settings, std::string_view text) {
           return set_motion(settings.motion.pierce_time, text, 0);
         }},
    Rule{{kMacroPath, "[\"/a\", \"/b\"], /a:/b"}, set_macro_path},
    Rule{{"max_statements", "1…1000000000000"},
         [](Settings& settings, std::string_view text) {
           const bool is_one =
               set_whole(settings.source.evaluate.bounds.statements, text, kMostWork);
           const std::uint64_t blocks = settings.source.evaluate.bounds.statements;
           change_nc(settings, [&](NcOptions& nc) { nc.max_blocks = blocks; });
           return is_one;
         }},
    Rule{{"max_moves", "1…1000000000000"},
         [](Settings& settings, std::string_view text) {
           const bool is_one = set_whole(settings.source.evaluate.bounds.moves, text, kMostWork);
           const std::uint64_t moves = settings.source.evaluate.bounds.moves;
           change_nc(settings, [&](NcOptions& nc) { nc.max_moves = moves; });
           settings.source.dxf.max_moves = moves;
           return is_one;
         }},
    Rule{{"max_loop_depth", "1…1000"},
         [](Settings& settings, std::string_view text) {
           return set_depth(settings.source.evaluate.bounds.loop_depth, text);
         }},
    Rule{{"max_macro_depth", "1…1000"},
         [](Settings& settings, std::string_view text) {
           return set_depth(settings.source.evaluate.bounds.macro_depth, text);
         }},
    Rule{{"max_text_depth", "1…1000"},
         [](Settings& settings, std::string_view text) {
           return set_depth(settings.source.evaluate.bounds.text_depth, text);
         }},
};

SettingKey key_of(std::string_view name) {
  return *std::ranges::find(all_settings(), name, &SettingKey::key);
}

// --- the entries of a machine file

Range range_of(const MachineFile& machine, const TextSpan& span) {
  return {machine.file.get(), span.begin, span.end};
}

/// The folders of a machine file are meant from where it lies, whoever reads it.
void set_folders(Settings& settings, const MachineEntry& entry, const MachineFile& machine) {
  const fs::path beside = fs::path(machine.file->name()).parent_path();
  settings.source.macro_path.clear();
  for (const std::string& folder : entry.values) {
    if (!folder.empty()) settings.source.macro_path.push_back(beside / folder);
  }
}

tl::expected<Settings, SettingFault> with_entry(Settings settings, const MachineEntry& entry,
                                                const MachineFile& machine) {
  using Kind = MachineEntry::Kind;
  const std::string value = entry.values.empty() ? std::string() : entry.values.front();
  const bool is_one_value = entry.kind == Kind::Text || entry.kind == Kind::Number;
  if (entry.key == kMacroPath && (entry.kind == Kind::Text || entry.kind == Kind::List)) {
    set_folders(settings, entry, machine);
    return settings;
  }
  auto changed = with_setting(std::move(settings), {entry.key, value});
  if (!changed && changed.error().kind == SettingFault::Kind::UnknownKey) return changed;
  if (!is_one_value || entry.key == kMacroPath) {
    return tl::unexpected(bad_value(key_of(entry.key), value));
  }
  return changed;
}

Diagnostic diagnostic_of(const SettingFault& fault, const MachineEntry& entry,
                         const MachineFile& machine) {
  if (fault.kind == SettingFault::Kind::UnknownKey) {
    return {
        Message::UnknownMachineKey, range_of(machine, entry.key_span), {fault.key, fault.nearest}};
  }
  const Range value = range_of(machine, entry.value_span);
  return {Message::BadMachineValue, value, {fault.key, std::string(value.text()), fault.expected}};
}

/// `unit` and `decimals` set the same; in a file neither is the later one.
void report_two_units(MachineFile& machine) {
  const MachineEntry* first = nullptr;
  for (const MachineEntry& entry : machine.entries) {
    if (entry.key != "unit" && entry.key != "decimals") continue;
    if (first != nullptr) {
      machine.bag.add(
          {Message::MachineKeyClash, range_of(machine, entry.key_span), {entry.key, first->key}});
    }
    first = &entry;
  }
}

Settings with_file(Settings settings, MachineFile& machine) {
  report_two_units(machine);
  for (const MachineEntry& entry : machine.entries) {
    auto changed = with_entry(settings, entry, machine);
    if (changed) {
      settings = *std::move(changed);
    } else {
      machine.bag.add(diagnostic_of(changed.error(), entry, machine));
    }
  }
  machine.bag.sort();
  return settings;
}

// --- a dialect file

Diagnostic diagnostic_of(const DialectFileFault& fault, const SourceFile* file) {
  using Kind = DialectFileFault::Kind;
  const Range range{file, fault.span.begin, fault.span.end};
  switch (fault.kind) {
    case Kind::Syntax:
      return {Message::MachineSyntax, range, {fault.key}};
    case Kind::KeyTwice:
      return {Message::MachineKeyTwice, range, {fault.key}};
    case Kind::UnknownKey:
      return {Message::UnknownDialectKey, range, {fault.key, fault.nearest}};
    case Kind::KeyLacking:
      return {Message::DialectKeyLacking, range, {fault.key, fault.expected}};
    case Kind::BadValue:
      break;
  }
  return {Message::BadDialectValue, range, {fault.key, std::string(range.text()), fault.expected}};
}

}  // namespace

std::span<const SettingKey> all_settings() {
  static const std::vector<SettingKey> keys = [] {
    std::vector<SettingKey> all;
    for (const Rule& rule : kRules) all.push_back(rule.key);
    all.insert(all.end(), dialect_settings().begin(), dialect_settings().end());
    all.insert(all.end(), tape_settings().begin(), tape_settings().end());
    return all;
  }();
  return keys;
}

tl::expected<Settings, SettingFault> with_setting(Settings settings, const Setting& setting) {
  const auto rule = std::ranges::find(kRules, setting.key, [](const Rule& r) { return r.key.key; });
  if (rule != kRules.end()) {
    if (rule->apply(settings, setting.value)) return settings;
    return tl::unexpected(bad_value(rule->key, setting.value));
  }
  auto tape = with_setting(settings.tape, setting);
  if (tape) {
    settings.tape = *std::move(tape);
    return settings;
  }
  if (tape.error().kind != SettingFault::Kind::UnknownKey) return tl::unexpected(tape.error());
  auto dialect = with_setting(settings.dialect, setting);
  if (dialect) {
    settings.dialect = *std::move(dialect);
    return settings;
  }
  if (dialect.error().kind != SettingFault::Kind::UnknownKey)
    return tl::unexpected(dialect.error());
  std::vector<std::string_view> known;
  for (const SettingKey& key : all_settings()) known.push_back(key.key);
  return tl::unexpected(unknown_key(setting, known));
}

FileResult<MachineFile> read_machine_file(const std::string& name) {
  const auto bytes = read_file(name);
  if (!bytes) return tl::unexpected(bytes.error());
  MachineFile machine;
  machine.file = decode_source(name, *bytes, std::nullopt);
  report_reading(*machine.file, machine.bag);
  auto entries = read_machine_text(machine.file->text());
  if (entries) {
    machine.entries = *std::move(entries);
    return machine;
  }
  const Range range = range_of(machine, entries.error().span);
  const bool twice = entries.error().kind == MachineSyntaxFault::Kind::KeyTwice;
  machine.bag.add({twice ? Message::MachineKeyTwice : Message::MachineSyntax,
                   range,
                   {std::string(range.text())}});
  return machine;
}

bool names_dialect_file(std::string_view name) { return name.ends_with(".toml"); }

FileResult<DialectSource> read_dialect_file(const std::string& name) {
  const auto bytes = read_file(name);
  if (!bytes) return tl::unexpected(bytes.error());
  DialectSource source;
  source.file = decode_source(name, *bytes, std::nullopt);
  report_reading(*source.file, source.bag);
  DialectFile read = read_dialect(fs::path(name).stem().string(), source.file->text());
  for (const DialectFileFault& fault : read.faults)
    source.bag.add(diagnostic_of(fault, source.file.get()));
  source.dialect = std::move(read.dialect);
  source.bag.sort();
  return source;
}

std::string dialect_name(const SettingSources& sources) {
  std::string name;
  if (sources.machine != nullptr) {
    for (const MachineEntry& entry : sources.machine->entries) {
      if (entry.key != kDialect || entry.values.empty()) continue;
      name = entry.values.front();
      if (names_dialect_file(name))
        name = (fs::path(sources.machine->file->name()).parent_path() / name).string();
    }
  }
  for (const Setting& setting : sources.set) {
    if (setting.key == kDialect) name = setting.value;
  }
  return name;
}

tl::expected<Settings, SettingFault> settle(const SettingSources& sources) {
  Settings settings;
  const Dialect* const chosen =
      sources.post != nullptr ? sources.post : find_dialect(dialect_name(sources));
  if (chosen != nullptr) settings.dialect = *chosen;
  if (sources.machine != nullptr) settings = with_file(std::move(settings), *sources.machine);
  for (const Setting& setting : sources.set) {
    auto changed = with_setting(std::move(settings), setting);
    if (!changed) return changed;
    settings = *std::move(changed);
  }
  return settings;
}

}  // namespace dgt
