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

  [[nodiscard]] Console console() const;
};
void add_message_options(CLI::App& verb, MessageOptions& options);

/// How the source is read and what the program leaves open.
struct SourceOptions {
  std::optional<InputLanguage> from;  ///< unset: by the extension
  std::vector<std::string> macro_path;
  OffsetSide offset_side = OffsetSide::Auto;
  std::string join_tolerance = "0.001";  ///< mm, a decimal

  [[nodiscard]] SourceSettings settings() const;
};
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
