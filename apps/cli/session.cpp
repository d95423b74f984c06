// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/session.h"

#include "kernel/check.h"

namespace dgt::cli {
namespace {

ExitCode report(const FileError& error, const Console& console) {
  console.error(Text::FileFailed, {error.text()});
  return ExitCode::Failure;
}

}  // namespace

Step<Compilation> load(const std::string& file, const SourceOptions& options,
                       const Console& console) {
  if (!options.from && !language_of(file)) {
    console.error(Text::UnknownLanguage, {file});
    return tl::unexpected(ExitCode::WrongUsage);
  }
  auto made = compile_file(file, options.settings());
  if (!made) return tl::unexpected(report(made.error(), console));
  console.show(made->bag);
  if (made->bag.has_errors()) return tl::unexpected(ExitCode::InputErrors);
  DGT_CHECK(made->result.path.has_value());
  return std::move(*made);
}

Step<Toolpath> load_path(const std::string& file, const SourceOptions& options,
                         const Console& console) {
  auto made = load(file, options, console);
  if (!made) return tl::unexpected(made.error());
  return std::move(*made->result.path);
}

ExitCode write_result(const std::string& output, std::string_view bytes, const Console& console) {
  const auto written = write_file(output, bytes);
  return written ? ExitCode::Done : report(written.error(), console);
}

}  // namespace dgt::cli
