// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/machine_choice.h"

#include <optional>
#include <utility>

namespace dgt {
namespace {

using Messages = std::vector<MachineMessages>;

/// The dialect called so, if it is to be chosen by name: one of a machine file that comes with the
/// program settle() finds itself.
tl::expected<std::optional<Dialect>, MachineFault> dialect_called(const std::string& name,
                                                                  bool is_said,
                                                                  Messages& messages) {
  if (names_dialect_file(name)) {
    auto read = read_dialect_file(name);
    if (!read) return tl::unexpected(MachineFault(read.error()));
    const bool faulty = read->bag.has_errors();
    messages.push_back({read->file, std::move(read->bag)});
    if (faulty) return tl::unexpected(MachineFault(FaultyMachine{}));
    return std::move(read->dialect);
  }
  if (!is_said) return std::nullopt;
  const Dialect* known = find_dialect(name);
  if (known == nullptr) return tl::unexpected(MachineFault(UnknownDialect{name}));
  return *known;
}

}  // namespace

SettledMachine settle(const MachineChoice& choice) {
  SettledMachine made;
  SettingSources sources;
  sources.set = choice.set;
  std::optional<MachineFile> machine;
  if (!choice.file.empty()) {
    auto read = read_machine_file(choice.file);
    if (!read) {
      made.settings = tl::unexpected(MachineFault(read.error()));
      return made;
    }
    sources.machine = &machine.emplace(*std::move(read));
  }
  const bool is_said = !choice.dialect.empty();
  const auto dialect =
      dialect_called(is_said ? choice.dialect : dialect_name(sources), is_said, made.messages);
  if (!dialect) {
    made.settings = tl::unexpected(dialect.error());
    return made;
  }
  if (*dialect) sources.post = &**dialect;
  auto settings = settle(sources);
  const bool faulty = machine && machine->bag.has_errors();
  if (machine) made.messages.push_back({machine->file, std::move(machine->bag)});
  if (!settings) {
    made.settings = tl::unexpected(MachineFault(settings.error()));
  } else if (faulty) {
    made.settings = tl::unexpected(MachineFault(FaultyMachine{}));
  } else {
    made.settings = *std::move(settings);
  }
  return made;
}

}  // namespace dgt
