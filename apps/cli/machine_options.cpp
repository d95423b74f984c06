// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/machine_options.h"

#include "post/machine.h"

namespace dgt::cli {
namespace {

void report(const SettingFault& fault, const Console& console) {
  switch (fault.kind) {
    case SettingFault::Kind::NoValue:
      console.error(Text::SettingWithoutValue, {fault.key});
      break;
    case SettingFault::Kind::UnknownKey:
      console.error(Text::UnknownSetting, {fault.key, fault.nearest});
      break;
    case SettingFault::Kind::BadValue:
      console.error(Text::BadSettingValue, {fault.key, fault.value, fault.expected});
      break;
  }
}

std::string help_of_settings() {
  std::string help = "Changes one setting of the dialect; may be given again. Settings:";
  for (const SettingKey& setting : dialect_settings()) {
    help.append("\n  ").append(setting.key).append("=").append(setting.expected);
  }
  return help;
}

}  // namespace

Step<Dialect> MachineOptions::chosen(const Console& console) const {
  const Dialect* found = find_dialect(dialect);
  if (found == nullptr) {
    console.error(Text::UnknownDialect, {dialect, names_of_dialects(", ")});
    return tl::unexpected(ExitCode::WrongUsage);
  }
  tl::expected<Dialect, SettingFault> machine = *found;
  for (const std::string& text : settings) {
    machine = parse_setting(text).and_then(
        [&](const Setting& setting) { return with_setting(*machine, setting); });
    if (machine) continue;
    report(machine.error(), console);
    return tl::unexpected(ExitCode::WrongUsage);
  }
  return std::move(*machine);
}

void add_machine_options(CLI::App& verb, MachineOptions& options) {
  verb.add_option("--post", options.dialect,
                  "The dialect to write, or list to name them all: " + names_of_dialects(", "))
      ->option_text("NAME|list")
      ->required()
      ->group("Machine");
  verb.add_option("--set", options.settings, help_of_settings())
      ->option_text("KEY=VALUE")
      ->allow_extra_args(false)
      ->group("Machine");
}

std::string names_of_dialects(std::string_view separator) {
  std::string names;
  for (const Dialect& dialect : dialects()) {
    if (!names.empty()) names += separator;
    names += dialect.name;
  }
  return names;
}

}  // namespace dgt::cli
