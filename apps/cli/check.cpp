// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "apps/cli/machine_options.h"
#include "apps/cli/verbs.h"
#include "apps/driver/fixing.h"

namespace dgt::cli {
namespace {

struct CheckOptions {
  std::vector<std::string> files;
  bool fix = false;
  SourceOptions source;
};

void tell(const Repair& repair, const std::string& file, const Console& console) {
  const std::string place = fmt::format("{}:{}:{}", file, repair.place.line, repair.place.column);
  const Text text = repair.before.empty()  ? Text::FixInserted
                    : repair.after.empty() ? Text::FixRemoved
                                           : Text::FixReplaced;
  console.note(text, {place, visible(repair.before), repair.after, info(repair.message).code});
}

/// What fix-its leave of the faults. Standard input comes out on standard output, fixed or not.
Step<Compilation> fix(const std::string& file, const SourceOptions& options,
                      const SourceSettings& settings, const Console& console) {
  if (const auto known = expect_source(file, options, console); !known) {
    return tl::unexpected(known.error());
  }
  auto fixing = fix_file(file, settings);
  if (!fixing) return tl::unexpected(report(fixing.error(), console));
  if (!fixing->repairs.empty() || file == kStream) {
    const ExitCode code = write_result(file, fixing->bytes, console);
    if (code != ExitCode::Done) return tl::unexpected(code);
  }
  for (const Repair& repair : fixing->repairs) tell(repair, fixing->made.file->name(), console);
  console.show(fixing->made.bag, sources_of(fixing->made));
  return std::move(fixing->made);
}

ExitCode run(const CheckOptions& options, const Console& console) {
  auto settings = settle(options.source, console);
  if (!settings) return settings.error();
  settings->source.evaluate.purpose = Purpose::Check;
  ExitCode worst = ExitCode::Done;
  std::size_t faulty = 0;
  for (const std::string& file : options.files) {
    const auto made = options.fix ? fix(file, options.source, settings->source, console)
                                  : examine(file, options.source, settings->source, console);
    const ExitCode code = !made                    ? made.error()
                          : made->bag.has_errors() ? ExitCode::InputErrors
                                                   : ExitCode::Done;
    worst = std::max(worst, code);
    if (code != ExitCode::Done) ++faulty;
  }
  if (options.files.size() > 1) {
    console.note(Text::Checked, {std::to_string(options.files.size()), std::to_string(faulty)});
  }
  return worst;
}

}  // namespace

void add_check(CLI::App& app, Job& job) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* verb = add_verb(
      app, job, "check", "Diagnostics only",
      "Reads and executes the programs and says what is wrong with them; writes nothing without "
      "--fix. All programs are checked, whatever is wrong with one; several are summed up at the "
      "end, and the exit code is the largest of their codes.");
  verb->add_option("FILE", options->files, "The programs; - is standard input")
      ->required()
      ->option_text("...");
  verb->add_flag("--fix", options->fix,
                 "Put the replacements that errors and warnings propose in place, until none is "
                 "left, and tell of each; what is told besides is what remains. Replacements that "
                 "change what a working program cuts are left to you. The program is written whole "
                 "in its own encoding; from standard input it goes to standard output");
  add_source_options(*verb, options->source);
  set_job<CheckOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
