// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "apps/cli/session.h"
#include "apps/cli/verbs.h"

namespace dgt::cli {
namespace {

struct CheckOptions {
  std::vector<std::string> files;
  SourceOptions source;
};

ExitCode run(const CheckOptions& options, const Console& console) {
  ExitCode worst = ExitCode::Done;
  for (const std::string& file : options.files) {
    const auto made = load(file, options.source, console);
    if (!made) worst = std::max(worst, made.error());
  }
  return worst;
}

}  // namespace

void add_check(CLI::App& app, Job& job) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* verb = add_verb(
      app, job, "check", "Diagnostics only",
      "Reads and executes the programs and says what is wrong with them; writes nothing. With "
      "several programs the exit code is the largest of their codes.");
  verb->add_option("FILE", options->files, "The programs; - is standard input")
      ->required()
      ->option_text("...");
  add_source_options(*verb, options->source);
  set_job<CheckOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
