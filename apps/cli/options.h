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

/// How the source is read and what the program leaves open.
struct SourceOptions {
  std::optional<InputLanguage> from;  ///< unset: by the extension
  std::optional<Encoding> encoding;   ///< of all files; unset: as each looks
  std::vector<std::string> macro_path;
  OffsetSide offset_side = OffsetSide::Auto;
  std::string join_tolerance = "0.001";  ///< mm, a decimal
  GougePolicy gouge = GougePolicy::Error;

  [[nodiscard]] SourceSettings settings() const;
};
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
