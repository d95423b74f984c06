// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/driver/file_io.h"
#include "lang/dgt/compile.h"
#include "lang/dxf/reader.h"
#include "lang/essi/reader.h"
#include "lang/gcode/reader.h"
#include "lang/three_b/reader.h"

/// From the name of a file to its tool path, without a word to the person: what the command, the
/// tests and the fuzzers share.
namespace dgt {

enum class InputLanguage : std::uint8_t { Dgt, Essi, EssiIso, Gcode, ThreeB, Dxf, Poly };

/// By the extension, in either case: `.bgt` and `.dgt`; `.ess` and `.essi`; `.nc`, `.cnc`,
/// `.gcode`, `.ngc` and `.tap`; `.3b`; `.dxf`; `.poly`. Standard input is DGT.
[[nodiscard]] std::optional<InputLanguage> language_of(const std::string& name);

struct SourceSettings {
  std::optional<InputLanguage> from;  ///< unset: by the extension, DGT when that says nothing
  EvaluateOptions evaluate;
  EssiOptions essi;
  GcodeOptions gcode;
  ThreeBOptions three_b;
  DxfOptions dxf;
  std::optional<Encoding> encoding;     ///< of the program; `evaluate` has that of macros
  std::vector<std::string> macro_path;  ///< folders, after the program's own and its `mac`
};

/// A source that has been read and executed; in other languages than DGT `result` has the
/// path alone.
struct Compilation {
  std::shared_ptr<const SourceFile> file;
  CompileResult result;
  DiagnosticBag bag;      ///< points into `file` and `result.files`
  ArcSummary arcs;        ///< of an NC program
  bool has_kerf = false;  ///< an NC program that the control offsets
  SourcePlace placed_by;  ///< what tells where an NC program starts; line 0: nothing
};

/// Decodes a source; `-` is called `<stdin>` in messages.
[[nodiscard]] std::shared_ptr<const SourceFile> decode_source(const std::string& name,
                                                              std::string_view bytes,
                                                              std::optional<Encoding> encoding);

/// Compiles a program that has been read already; macros are looked for where `name` is.
[[nodiscard]] Compilation compile_source(const std::string& name,
                                         std::shared_ptr<const SourceFile> source,
                                         const SourceSettings& settings);
/// Compiles a program of which the bytes are known already; macros are looked for where `name` is.
[[nodiscard]] Compilation compile_bytes(const std::string& name, std::string_view bytes,
                                        const SourceSettings& settings);

/// Compiles a program; `-` is standard input, a program that was never saved.
[[nodiscard]] FileResult<Compilation> compile_file(const std::string& name,
                                                   const SourceSettings& settings);

}  // namespace dgt
