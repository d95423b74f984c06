// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "apps/cli/compile.h"
#include "apps/cli/machine_options.h"
#include "apps/cli/session.h"
#include "apps/cli/stage.h"
#include "apps/cli/verbs.h"
#include "apps/driver/dgt_source.h"
#include "apps/driver/write_messages.h"
#include "post/dgt.h"

namespace dgt::cli {
namespace {

struct ConvertOptions {
  Request request;
  PostOptions post;
};

/// Where its messages come from, as those of a dialect do.
Dialect language_as_dialect() {
  Dialect dialect;
  dialect.name = kDgtDialect;
  dialect.unit = Rational(1, 1'000'000'000);
  return dialect;
}

/// Every arc of a contour may want a circle of its own, and these have numbers.
bool can_be_numbered(const Toolpath& path, const Console& console) {
  for (const Contour& contour : path.contours) {
    const auto first = path.moves.begin() + static_cast<std::ptrdiff_t>(contour.first);
    const auto last = path.moves.begin() + static_cast<std::ptrdiff_t>(contour.last);
    const auto arcs = static_cast<std::size_t>(
        std::count_if(first, last, [](const Move& move) { return move.kind == MoveKind::Arc; }));
    if (arcs <= kMaxDgtNumber) continue;
    console.error(Text::TooManyArcs, {std::to_string(contour.id), std::to_string(arcs),
                                      std::to_string(kMaxDgtNumber)});
    return false;
  }
  return true;
}

/// As a program in the language itself.
ExitCode write_source(const Request& request, const Console& console) {
  const auto settings = settle(request.source, console, "");
  if (!settings) return settings.error();
  const auto made = load(request.file, request.source, settings->source, console);
  if (!made) return made.error();
  if (!can_be_numbered(*made->result.path, console)) return ExitCode::InputErrors;
  const std::string title = std::filesystem::path(made->file->name()).filename();
  const DgtSource source = [&] {
    const Stage stage(console, Text::StageWriting, request.file);
    return write_dgt(*made->result.path, title);
  }();
  console.show(explain(source.written, language_as_dialect(), *made), sources_of(*made));
  if (!source.written.faults.empty()) return ExitCode::InputErrors;
  const ExitCode code = write_result(request.output, source.written.text, console);
  if (code != ExitCode::Done) return code;
  console.note(Text::WrittenAsDgt, {std::to_string(source.contours),
                                    fmt::format("{:.2g}", source.written.report.deviation)});
  if (source.by_points > 0) console.note(Text::WrittenByPoints, {std::to_string(source.by_points)});
  if (source.without_width > 0)
    console.note(Text::WrittenWithoutWidth, {std::to_string(source.without_width)});
  return code;
}

ExitCode run(const ConvertOptions& options, const Console& console) {
  if (options.post.dialect == kDgtDialect) return write_source(options.request, console);
  return write_for(options.request, options.post, console);
}

}  // namespace

void add_convert(CLI::App& app, Job& job) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* verb = add_verb(
      app, job, "convert", "From any language to any dialect",
      "Reads a program in DGT, ESSI, G-code, 3B, a DXF drawing or polylines and writes it for a "
      "control, or as DGT source to go on with, whole or not at all. Subprograms are written out, "
      "kerf that the program asks for is applied. What was written here comes back byte for byte "
      "when it is read and written again.\n\nExamples:\n"
      "  dgt convert star.ess --to linuxcnc -o star.ngc\n"
      "  dgt convert part.dxf --to dgt -o part.bgt");
  add_request(*verb, options->request, "The NC program");
  verb->add_option("--to", options->post.dialect,
                   "The dialect to write: a file of one's own, dgt for the language itself, or " +
                       names_of_dialects(", "))
      ->required()
      ->option_text("NAME|FILE.toml|dgt")
      ->group("Machine");
  add_compensation(*verb, options->post);
  set_job<ConvertOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
