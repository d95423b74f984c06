// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/setting_rules.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace dgt {
namespace {

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

constexpr std::array kRules{
    SettingRule{{kDialectKey, "essi|essi-iso|plasmatic|linuxcnc|fanuc-wire|grbl|3b|FILE.toml"},
                [](Settings&, std::string_view text) {
                  return find_dialect(text) != nullptr || names_dialect_file(text);
                }},
    SettingRule{{"offset_side", "auto|left|right"}, set_offset_side},
    SettingRule{{"join_tolerance", "≥ 0 mm"}, set_join_tolerance},
    SettingRule{{"gouge", "error|warn|trim"}, set_gouge},
    SettingRule{{"crossings", "all|leads|none"}, set_crossings},
    SettingRule{{"kerf", "0…100 mm"}, set_kerf},
    SettingRule{{"arc_tolerance", "0…10 mm"}, set_arc_tolerance},
    SettingRule{{"essi.dialect", "essi|essi-iso"}, set_essi_dialect},
    SettingRule{{"essi.unit", "0.000001…100 mm"}, set_essi_unit},
    SettingRule{{"essi.rotation", "ccw|cw"},
                [](Settings& settings, std::string_view text) {
                  return set_sense(settings.source.essi.rotation, text);
                }},
    SettingRule{{"essi.scale_unit", "percent|permille"}, set_scale_unit},
    SettingRule{{"essi.iso_plus", "ccw|cw"},
                [](Settings& settings, std::string_view text) {
                  return set_sense(settings.source.essi.iso_plus, text);
                }},
    SettingRule{{"gcode.positions", "absolute|incremental"}, set_positions},
    SettingRule{{"gcode.dwell_unit", "s|ms"}, set_read_dwell},
    SettingRule{{"3b.unit", "0.000001…100 mm"}, set_three_b_unit},
    SettingRule{{"3b.pause", "rapid|stop"}, set_pause},
    SettingRule{{"3b.end_tolerance", "0…10 mm"}, set_end_tolerance},
    SettingRule{{"dxf.layers", "NAME,NAME"}, set_layers},
    SettingRule{{"dxf.unit", "drawing|mm|inch"}, set_dxf_unit},
    SettingRule{{"dxf.join_tolerance", "0…10 mm"}, set_dxf_join_tolerance},
    SettingRule{{"dxf.curve_tolerance", "0.000001…10 mm"}, set_curve_tolerance},
    SettingRule{{"dxf.order", "auto|inside-out|drawn"}, set_dxf_order},
    SettingRule{{"dxf.direction", "drawn|part-left|part-right"}, set_dxf_direction},
    SettingRule{{"dxf.kerf", "on|off"}, set_dxf_kerf},
    SettingRule{{"corner", "extend|round|chamfer"}, set_corner},
    SettingRule{{"corner_limit", "1…1000"}, set_corner_limit},
    SettingRule{{"rapid_speed", "0.001…1000000 mm/min"},
                [](Settings& settings, std::string_view text) {
                  return set_motion(settings.motion.rapid_speed, text, least_motion());
                }},
    SettingRule{{"cut_speed", "0.001…1000000 mm/min"},
                [](Settings& settings, std::string_view text) {
                  return set_motion(settings.motion.cut_speed, text, least_motion());
                }},
    SettingRule{{"acceleration", "0.001…1000000 mm/s²"},
                [](Settings& settings, std::string_view text) {
                  return set_motion(settings.motion.acceleration, text, least_motion());
                }},
    SettingRule{{"corner_deviation", "0…1000000 mm"},
                [](Settings& settings, std::string_view text) {
                  return set_motion(settings.motion.corner_deviation, text, 0);
                }},
    SettingRule{{"pierce_time", "0…1000000 s"},
                [](Settings& settings, std::string_view text) {
                  return set_motion(settings.motion.pierce_time, text, 0);
                }},
    SettingRule{{kMacroPathKey, "[\"/a\", \"/b\"], /a:/b"}, set_macro_path},
    SettingRule{{"max_statements", "1…1000000000000"},
                [](Settings& settings, std::string_view text) {
                  const bool is_one =
                      set_whole(settings.source.evaluate.bounds.statements, text, kMostWork);
                  const std::uint64_t blocks = settings.source.evaluate.bounds.statements;
                  change_nc(settings, [&](NcOptions& nc) { nc.max_blocks = blocks; });
                  return is_one;
                }},
    SettingRule{{"max_moves", "1…1000000000000"},
                [](Settings& settings, std::string_view text) {
                  const bool is_one =
                      set_whole(settings.source.evaluate.bounds.moves, text, kMostWork);
                  const std::uint64_t moves = settings.source.evaluate.bounds.moves;
                  change_nc(settings, [&](NcOptions& nc) { nc.max_moves = moves; });
                  settings.source.dxf.max_moves = moves;
                  return is_one;
                }},
    SettingRule{{"max_loop_depth", "1…1000"},
                [](Settings& settings, std::string_view text) {
                  return set_depth(settings.source.evaluate.bounds.loop_depth, text);
                }},
    SettingRule{{"max_macro_depth", "1…1000"},
                [](Settings& settings, std::string_view text) {
                  return set_depth(settings.source.evaluate.bounds.macro_depth, text);
                }},
    SettingRule{{"max_text_depth", "1…1000"},
                [](Settings& settings, std::string_view text) {
                  return set_depth(settings.source.evaluate.bounds.text_depth, text);
                }},
};

}  // namespace

std::span<const SettingRule> setting_rules() { return kRules; }

}  // namespace dgt
