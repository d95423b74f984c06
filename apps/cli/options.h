// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/console.h"
#include "apps/driver/pipeline.h"
#include "kernel/contour.h"

/// Options that several verbs share.
namespace dgt::cli {

struct MessageOptions {
  std::optional<Language> language;  ///< unset: from the locale
  ColourChoice colour = ColourChoice::Auto;
  MessageForm form = MessageForm::Text;
  std::shared_ptr<SarifLog> log = std::make_shared<SarifLog>();

  [[nodiscard]] Console console() const;
  /// Prints the log when SARIF is asked for: once, when everything has been said.
  void finish() const;
};
void add_message_options(CLI::App& verb, MessageOptions& options);

/// Settings of the machine, from a file and one by one.
struct MachineOptions {
  std::string file;                   ///< empty: none
  std::vector<std::string> settings;  ///< `key=value`, the later one wins
};

/// How the source is read and what the program leaves open.
struct SourceOptions {
  std::optional<InputLanguage> from;  ///< unset: by the extension
  std::optional<Encoding> encoding;   ///< of all files; unset: as each looks
  std::vector<std::string> macro_path;
  std::optional<OffsetSide> offset_side;      ///< these three unset: by the settings
  std::optional<std::string> join_tolerance;  ///< mm, a decimal
  std::optional<GougePolicy> gouge;
  bool repair = false;
  MachineOptions machine;

  /// The settings with what the options say in their place.
  [[nodiscard]] SourceSettings over(SourceSettings settings) const;
};
void add_encoding_option(CLI::App& verb, SourceOptions& options);
/// Only the options that say how the text is read.
void add_reading_options(CLI::App& verb, SourceOptions& options);
void add_source_options(CLI::App& verb, SourceOptions& options);

/// One program in, one result out.
struct Request {
  std::string file;
  std::string output{kStream};
  SourceOptions source;
};
/// FILE, -o and the options of the source; `what` says what -o names.
void add_request(CLI::App& verb, Request& request, const std::string& what);

}  // namespace dgt::cli
