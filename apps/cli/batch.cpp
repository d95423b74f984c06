// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <thread>

#include "apps/cli/machine_options.h"
#include "apps/cli/verbs.h"

namespace dgt::cli {
namespace {

namespace fs = std::filesystem;

struct BatchOptions {
  std::vector<std::string> inputs;
  std::string post;
  std::string folder;
  unsigned jobs = 0;  ///< 0: as many as there are cores
  SourceOptions source;
};

void tell(const BatchResult& result, const Console& console) {
  if (result.failure) console.error(Text::FileFailed, {result.failure->text()});
  console.show(result.bag, result.sources);
}

ExitCode run(const BatchOptions& options, const Console& console) {
  const auto settings = settle(options.source, console, options.post);
  if (!settings) return settings.error();
  if (settings->dialect.name.empty()) {
    console.error(Text::NoDialect, {names_of_dialects(", ")});
    return ExitCode::WrongUsage;
  }
  const auto plan = plan_batch(options.inputs, options.folder, settings->dialect);
  if (!plan) {
    const BatchFault& fault = plan.error();
    if (fault.is_clash())
      console.error(Text::BatchClash, {fault.input, fault.other, fault.output});
    else
      console.error(Text::NoPrograms, {fault.input});
    return ExitCode::WrongUsage;
  }
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  const auto results = run_batch(*plan, *settings, options.jobs == 0 ? cores : options.jobs);
  std::size_t failed = 0;
  for (const BatchResult& result : results) {
    tell(result, console);
    if (!result.is_done) ++failed;
  }
  const ExitCode told = write_result(std::string(kStream), table_of(results), console);
  console.note(Text::Batched, {std::to_string(results.size()), std::to_string(failed)});
  if (told != ExitCode::Done) return told;
  return failed > 0 ? ExitCode::InputErrors : ExitCode::Done;
}

}  // namespace

void add_batch(CLI::App& app, Job& job) {
  const auto options = std::make_shared<BatchOptions>();
  CLI::App* verb = add_verb(
      app, job, "batch", "Many programs on all cores",
      "Writes every program of the folders and patterns for one control, each into a file of its "
      "own name in the folder -o, whole or not at all. What is wrong with one holds up no other. "
      "Messages and the table on standard output come in the order of the names, however the work "
      "was shared out. Exit code 1 when any failed.\n\nExample:\n"
      "  dgt batch parts 'more/*.bgt' --post linuxcnc -o out");
  verb->add_option("DIR|GLOB", options->inputs,
                   "Folders, with all programs in them and in folders below, and patterns with * "
                   "and ? in the name of the file, or plain names of files")
      ->required()
      ->option_text("...");
  verb->add_option("-o,--output", options->folder,
                   "The folder to write to; made when there is none")
      ->required()
      ->option_text("DIR");
  verb->add_option(
          "--post", options->post,
          "The dialect to write, unless the machine file chooses it: " + names_of_dialects(", "))
      ->option_text("NAME")
      ->group("Machine");
  verb->add_option("--jobs", options->jobs, "Programs at a time (default: one a core)")
      ->option_text("N")
      ->check(CLI::Range(1, 1024).description(""));
  add_source_options(*verb, options->source);
  set_job<BatchOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
