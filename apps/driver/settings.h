// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "apps/driver/pipeline.h"
#include "apps/driver/tape_settings.h"
#include "apps/driver/timing.h"
#include "post/machine.h"
#include "post/machine_file.h"

/// All that a machine file and `--set` can change: how a program is executed, how it is written and
/// how it comes onto tape.
/// The keys stand in post/README.md.
namespace dgt {

struct Settings {
  Dialect dialect;  ///< without a name when none has been chosen; settings hold all the same
  SourceSettings source;
  TapeSettings tape;
  MotionSettings motion;
};

/// Every key: `dialect`, those of the execution, those of a dialect, those of tape.
[[nodiscard]] std::span<const SettingKey> all_settings();

/// The settings with one changed. `dialect` is only looked at: a dialect has to be chosen before
/// others change it.
[[nodiscard]] tl::expected<Settings, SettingFault> with_setting(Settings settings,
                                                                const Setting& setting);

/// A machine file, read and not yet judged.
struct MachineFile {
  std::shared_ptr<const SourceFile> file;
  std::vector<MachineEntry> entries;  ///< empty where the text is no TOML
  DiagnosticBag bag;                  ///< what is wrong with the text; points into `file`
};
[[nodiscard]] FileResult<MachineFile> read_machine_file(const std::string& name);

/// A dialect file, read and judged.
struct DialectSource {
  std::shared_ptr<const SourceFile> file;
  Dialect dialect;    ///< called as the file is, without folders and extension
  DiagnosticBag bag;  ///< with an error the dialect is not to be used
};
[[nodiscard]] FileResult<DialectSource> read_dialect_file(const std::string& name);
/// Whether the name of a dialect is that of a file: it ends in `.toml`.
[[nodiscard]] bool names_dialect_file(std::string_view name);

/// Where settings come from; the later win.
struct SettingSources {
  MachineFile* machine = nullptr;  ///< its bag takes what is wrong with its settings
  std::vector<Setting> set;        ///< `--set`, in order
  const Dialect* post = nullptr;   ///< chosen by name
};
/// The dialect that the machine file and `set` choose, a file's name seen from where it is said;
/// empty: none.
[[nodiscard]] std::string dialect_name(const SettingSources& sources);

/// Starts from the dialect that the sources choose and applies the machine file, then `set`. A
/// fault in `set` ends it; those of the file are collected, and what is faulty changes nothing.
[[nodiscard]] tl::expected<Settings, SettingFault> settle(const SettingSources& sources);

}  // namespace dgt
