// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/driver/file_io.h"
#include "lang/dgt/compile.h"

/// From the name of a file to its tool path, without a word to the person: what the command, the
/// tests and the fuzzers share.
namespace dgt {

enum class InputLanguage : std::uint8_t { Dgt };

/// By the extension, in either case: `.bgt` and `.dgt`. Standard input is DGT.
[[nodiscard]] std::optional<InputLanguage> language_of(const std::string& name);

struct SourceSettings {
  EvaluateOptions evaluate;
  std::vector<std::string> macro_path;  ///< folders, after the program's own and its `mac`
};

/// A source that has been read and executed.
struct Compilation {
  std::shared_ptr<const SourceFile> file;
  CompileResult result;
  DiagnosticBag bag;  ///< points into `file` and `result.files`
};

/// Compiles a DGT program; `-` is standard input, a program that was never saved.
[[nodiscard]] FileResult<Compilation> compile_file(const std::string& name,
                                                   const SourceSettings& settings);

}  // namespace dgt
