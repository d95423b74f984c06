// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "apps/cli/session.h"
#include "apps/cli/verbs.h"
#include "kernel/check.h"
#include "lang/dgt/formatter.h"

namespace dgt::cli {
namespace {

struct FormatOptions {
  std::vector<std::string> files;
  std::string output{kStream};
  bool in_place = false;
  bool check = false;
  SourceOptions source;
};

/// The bytes of a file, as they are and as they should be.
struct Layouts {
  std::string present;
  std::string canonical;
};

bool is_macro(const std::string& file) { return fold_case(file).ends_with(".mac"); }

Step<Layouts> lay_out(const std::string& file, const SourceOptions& options,
                      const Console& console) {
  if (!is_macro(file)) {
    if (const auto known = expect_source(file, options, console); !known) {
      return tl::unexpected(known.error());
    }
    if (language_for(file, options) != InputLanguage::Dgt) {
      console.error(Text::DgtOnly, {file});
      return tl::unexpected(ExitCode::WrongUsage);
    }
  }
  auto bytes = read_file(file);
  if (!bytes) return tl::unexpected(report(bytes.error(), console));
  const auto source = decode_source(file, *bytes, options.encoding);
  DiagnosticBag bag;
  const auto text = language::format(*source, bag);
  bag.sort();
  console.show(bag, {source});
  if (!text) return tl::unexpected(ExitCode::InputErrors);
  Encoded encoded = encode(*text, source->form());
  DGT_CHECK(encoded.lost.empty());  // comments come from the same encoding, the rest is ASCII
  return Layouts{*std::move(bytes), std::move(encoded.bytes)};
}

ExitCode format_file(const std::string& file, const FormatOptions& options,
                     const Console& console) {
  const auto layouts = lay_out(file, options.source, console);
  if (!layouts) return layouts.error();
  const bool is_canonical = layouts->canonical == layouts->present;
  if (options.check) {
    if (!is_canonical) console.error(Text::NotCanonical, {file});
    return is_canonical ? ExitCode::Done : ExitCode::InputErrors;
  }
  if (options.in_place && is_canonical) return ExitCode::Done;
  return write_result(options.in_place ? file : options.output, layouts->canonical, console);
}

ExitCode run(const FormatOptions& options, const Console& console) {
  const bool one_result = !options.in_place && !options.check;
  if (one_result && options.files.size() > 1) {
    console.error(Text::OneResultForMany, {});
    return ExitCode::WrongUsage;
  }
  ExitCode worst = ExitCode::Done;
  for (const std::string& file : options.files) {
    worst = std::max(worst, format_file(file, options, console));
  }
  return worst;
}

}  // namespace

void add_format(CLI::App& app, Job& job) {
  const auto options = std::make_shared<FormatOptions>();
  CLI::App* verb = add_verb(
      app, job, "format", "Canonical layout of a source",
      "Lays a program, macro or definition file out anew: Latin capitals, one blank between items, "
      "numbers in their shortest spelling, bodies of FOR indented, comments behind code in one "
      "column. Comments, blank lines, encoding and line ends stay, and so does the tool path. A "
      "file with syntax errors is refused with exit code 1. Macros end in .mac.");
  verb->add_option("FILE", options->files, "The sources; - is standard input")
      ->required()
      ->option_text("...");
  CLI::Option* output =
      verb->add_option("-o,--output", options->output,
                       "The file to write, whole or not at all (default: -, standard output)")
          ->option_text("OUT");
  CLI::Option* in_place =
      verb->add_flag("-i,--in-place", options->in_place,
                     "Write each source over itself, unless it is canonical already")
          ->excludes(output);
  verb->add_flag("--check", options->check,
                 "Write nothing; name the sources that are not canonical, exit code 1 if any")
      ->excludes(output)
      ->excludes(in_place);
  add_reading_options(*verb, options->source);
  set_job<FormatOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
