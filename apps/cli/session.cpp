// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/session.h"

#include "apps/cli/machine_options.h"
#include "apps/cli/stage.h"
#include "kernel/check.h"

namespace dgt::cli {

ExitCode report(const FileError& error, const Console& console) {
  console.error(Text::FileFailed, {error.text()});
  return ExitCode::Failure;
}

Sources sources_of(const Compilation& made) {
  Sources sources = made.result.files;
  sources.push_back(made.file);
  return sources;
}

Step<void> expect_source(const std::string& file, const SourceOptions& options,
                         const Console& console) {
  if (options.from || language_of(file)) return {};
  console.error(Text::UnknownLanguage, {file});
  return tl::unexpected(ExitCode::WrongUsage);
}

InputLanguage language_for(const std::string& file, const SourceOptions& options) {
  return options.from.value_or(language_of(file).value_or(InputLanguage::Dgt));
}

Step<Compilation> examine(const std::string& file, const SourceOptions& options,
                          const SourceSettings& settings, const Console& console) {
  if (const auto known = expect_source(file, options, console); !known) {
    return tl::unexpected(known.error());
  }
  auto made = [&] {
    Stage stage(console, Text::StageReading, file);
    SourceSettings watched = settings;
    watched.evaluate.on_progress = stage.on_progress();
    watched.essi.nc.on_progress = stage.on_progress();
    watched.gcode.nc.on_progress = stage.on_progress();
    watched.three_b.nc.on_progress = stage.on_progress();
    return compile_file(file, watched);
  }();
  if (!made) return tl::unexpected(report(made.error(), console));
  console.show(made->bag, sources_of(*made));
  return std::move(*made);
}

Step<Compilation> load(const std::string& file, const SourceOptions& options,
                       const SourceSettings& settings, const Console& console) {
  auto made = examine(file, options, settings, console);
  if (!made) return made;
  if (made->bag.has_errors()) return tl::unexpected(ExitCode::InputErrors);
  DGT_CHECK(made->result.path.has_value());
  return made;
}

Step<Compilation> load(const std::string& file, const SourceOptions& options,
                       const Console& console) {
  const auto settings = settle(options, console);
  if (!settings) return tl::unexpected(settings.error());
  return load(file, options, settings->source, console);
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
