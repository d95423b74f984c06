// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/machine_options.h"

#include <fmt/format.h>

#include <optional>

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

Step<Dialect> dialect_of_file(const std::string& name, const Console& console) {
  auto read = read_dialect_file(name);
  if (!read) return tl::unexpected(report(read.error(), console));
  console.show(read->bag, {read->file});
  if (read->bag.has_errors()) return tl::unexpected(ExitCode::InputErrors);
  return std::move(read->dialect);
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
  SettingSources sources;
  auto set = parsed(options.machine.settings, console);
  if (!set) return tl::unexpected(set.error());
  sources.set = *std::move(set);
  std::optional<MachineFile> machine;
  if (!options.machine.file.empty()) {
    auto read = read_machine_file(options.machine.file);
    if (!read) return tl::unexpected(report(read.error(), console));
    sources.machine = &machine.emplace(*std::move(read));
  }
  const std::string name = post.empty() ? dialect_name(sources) : post;
  std::optional<Dialect> dialect;
  if (names_dialect_file(name)) {
    auto read = dialect_of_file(name, console);
    if (!read) return tl::unexpected(read.error());
    sources.post = &dialect.emplace(*std::move(read));
  } else if (!post.empty()) {
    sources.post = find_dialect(post);
    if (sources.post == nullptr) {
      console.error(Text::UnknownDialect, {post, names_of_dialects(", ")});
      return tl::unexpected(ExitCode::WrongUsage);
    }
  }
  auto settings = settle(sources);
  if (machine) console.show(machine->bag, {machine->file});
  if (!settings) return tl::unexpected(report(settings.error(), console));
  if (machine && machine->bag.has_errors()) return tl::unexpected(ExitCode::InputErrors);
  settings->source = options.over(std::move(settings->source));
  return *std::move(settings);
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
