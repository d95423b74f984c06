// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/settings.h"

#include <algorithm>
#include <filesystem>

#include "apps/driver/setting_rules.h"
#include "lang/text/reading.h"
#include "post/dialect_file.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;

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
  if (entry.key == kMacroPathKey && (entry.kind == Kind::Text || entry.kind == Kind::List)) {
    set_folders(settings, entry, machine);
    return settings;
  }
  auto changed = with_setting(std::move(settings), {entry.key, value});
  if (!changed && changed.error().kind == SettingFault::Kind::UnknownKey) return changed;
  if (!is_one_value || entry.key == kMacroPathKey) {
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
    for (const SettingRule& rule : setting_rules()) all.push_back(rule.key);
    all.insert(all.end(), dialect_settings().begin(), dialect_settings().end());
    all.insert(all.end(), tape_settings().begin(), tape_settings().end());
    return all;
  }();
  return keys;
}

tl::expected<Settings, SettingFault> with_setting(Settings settings, const Setting& setting) {
  const auto rules = setting_rules();
  const auto rule =
      std::ranges::find(rules, setting.key, [](const SettingRule& r) { return r.key.key; });
  if (rule != rules.end()) {
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
      if (entry.key != kDialectKey || entry.values.empty()) continue;
      name = entry.values.front();
      if (names_dialect_file(name))
        name = (fs::path(sources.machine->file->name()).parent_path() / name).string();
    }
  }
  for (const Setting& setting : sources.set) {
    if (setting.key == kDialectKey) name = setting.value;
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
