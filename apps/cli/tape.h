// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/cli/machine_options.h"
#include "apps/cli/verbs.h"
#include "apps/driver/tape_images.h"
#include "apps/driver/tape_messages.h"

/// What the verbs of `dgt tape` share.
namespace dgt::cli {

// One file each two or three; they are added to the verb `tape`.
void add_tape_images(CLI::App& tape, Job& job);
void add_tape_devices(CLI::App& tape, Job& job);
void add_tape_simulate(CLI::App& tape, Job& job);

struct TapeOptions {
  std::string file;
  std::string output{kStream};
  std::string header;  ///< empty: as the settings say
  std::optional<TapeForm> form;
  SourceOptions source;  ///< machine and encoding
};
/// --machine, --set and --encoding.
void add_tape_settings(CLI::App& verb, TapeOptions& options);
void add_tape_file(CLI::App& verb, TapeOptions& options, const std::string& what);
void add_tape_output(CLI::App& verb, TapeOptions& options, const std::string& what);
void add_tape_header(CLI::App& verb, TapeOptions& options);

/// The settings' format with the lettering for a program of that name.
[[nodiscard]] Step<TapeFormat> format_for(const TapeOptions& options, const Settings& settings,
                                          const Console& console);

/// A tape that lies in a file.
[[nodiscard]] Step<Tape> load_image(const std::string& name, const Console& console);

/// The tape of a file that holds one, or of a program; tells what is wrong with it.
struct LoadedTape {
  Tape tape;
  bool is_program = false;
};
[[nodiscard]] Step<LoadedTape> load_tape(const std::string& name, const TapeOptions& options,
                                         const TapeFormat& format, const Console& console);

/// Writes rows in a form that is not a program's text.
[[nodiscard]] ExitCode write_tape(const std::string& output, const Tape& tape, TapeForm form,
                                  RowRange rows, const Console& console);
/// Writes the program of a tape, with the line ends of the settings.
[[nodiscard]] ExitCode write_program(const std::string& output, const DecodedTape& decoded,
                                     const Settings& settings, const Console& console);
/// Tells how long the tape is and where its program lies.
void tell_length(const std::string& name, const Tape& tape, const DecodedTape& decoded,
                 const Console& console);

}  // namespace dgt::cli
