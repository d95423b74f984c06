// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/machine_options.h"

#include <fmt/format.h>

#include <variant>

#include "apps/driver/machine_choice.h"

namespace dgt::cli {
namespace {

ExitCode report(const SettingFault& fault, const Console& console) {
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
  return ExitCode::WrongUsage;
}

Step<std::vector<Setting>> parsed(const std::vector<std::string>& texts, const Console& console) {
  std::vector<Setting> settings;
  for (const std::string& text : texts) {
    auto setting = parse_setting(text);
    if (!setting) return tl::unexpected(report(setting.error(), console));
    settings.push_back(*std::move(setting));
  }
  return settings;
}

ExitCode report(const MachineFault& fault, const Console& console) {
  if (const auto* file = std::get_if<FileError>(&fault)) return report(*file, console);
  if (const auto* setting = std::get_if<SettingFault>(&fault)) return report(*setting, console);
  if (const auto* dialect = std::get_if<UnknownDialect>(&fault)) {
    console.error(Text::UnknownDialect, {dialect->name, names_of_dialects(", ")});
    return ExitCode::WrongUsage;
  }
  return ExitCode::InputErrors;  // its messages have been shown
}

std::string help_of_settings() {
  std::string help =
      "Changes one setting, whatever the machine file says; may be given again, the later wins. "
      "Settings:";
  for (const SettingKey& setting : all_settings()) {
    help.append("\n  ").append(setting.key).append("=").append(setting.expected);
  }
  return help;
}

}  // namespace

Step<Settings> settle(const SourceOptions& options, const Console& console,
                      const std::string& post) {
  auto set = parsed(options.machine.settings, console);
  if (!set) return tl::unexpected(set.error());
  auto machine = settle(MachineChoice{options.machine.file, *std::move(set), post});
  for (const MachineMessages& said : machine.messages) console.show(said.bag, {said.file});
  if (!machine.settings) return tl::unexpected(report(machine.settings.error(), console));
  machine.settings->source = options.over(std::move(machine.settings->source));
  return *std::move(machine.settings);
}

void add_machine_options(CLI::App& verb, MachineOptions& options) {
  verb.add_option("--machine", options.file,
                  "A machine file: settings as TOML, key = value with words in quotes")
      ->option_text("FILE")
      ->group("Machine");
  verb.add_option("--set", options.settings, help_of_settings())
      ->option_text("KEY=VALUE")
      ->allow_extra_args(false)
      ->group("Machine");
}

std::string list_of_dialects(Language language) {
  std::string list;
  for (const Dialect& dialect : dialects()) {
    const std::string& about = language == Language::Russian ? dialect.about_ru : dialect.about;
    list += fmt::format("{:<12}{}\n", dialect.name, about);
  }
  return list;
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
