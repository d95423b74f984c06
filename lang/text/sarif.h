// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lang/text/diagnostic.h"

namespace dgt {

/// How diagnostics are written for editors and build servers.
struct SarifOptions {
  Language language = Language::English;  ///< of the results' messages; rules carry both
  std::string version = {};               ///< of the program, `0.1.0`; left out when empty
  /// What kept the program from its work and belongs to no source: a file that cannot be read. The
  /// log has an invocation that was not successful then, with these as its notifications.
  std::vector<std::string> failures = {};
};

/// The diagnostics of one run, of all its bags in their order, as a SARIF 2.1.0 log (OASIS
/// standard): JSON, two blanks deep, ended by a line end.
///  (1) Every message that occurs is a rule: its `fullDescription` is the English text, its `help`
///      the Russian one, `messageStrings` hold both as `en` and `ru`, with placeholders.
///  (2) Every diagnostic is a result with its sentence, its arguments and its region; columns count
///      code points, the end stands behind the last one. Notes are related locations, a fix-it is
///      a fix.
///  (3) A file is named by a URI reference: relative names stay relative, absolute ones begin with
///      `file:///`; what is not plain ASCII is written in percent form.
[[nodiscard]] std::string to_sarif(std::span<const DiagnosticBag* const> bags,
                                   const SarifOptions& options = {});
[[nodiscard]] std::string to_sarif(const DiagnosticBag& bag, const SarifOptions& options = {});

}  // namespace dgt
