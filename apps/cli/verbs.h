// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>

#include "apps/cli/console.h"
#include "apps/cli/options.h"

/// One function a verb, each in a file of its own: it declares the verb with its options; when the
/// command line names the verb, `job` is what is left to run.
namespace dgt::cli {

struct Job {
  std::function<ExitCode()> run;
  MessageOptions messages;  ///< for what happens outside the verb
};

void add_batch(CLI::App& app, Job& job);
void add_check(CLI::App& app, Job& job);
void add_compile(CLI::App& app, Job& job);
void add_format(CLI::App& app, Job& job);
void add_convert(CLI::App& app, Job& job);
void add_dump(CLI::App& app, Job& job);
void add_info(CLI::App& app, Job& job);
void add_offset(CLI::App& app, Job& job);
void add_path(CLI::App& app, Job& job);
void add_plot(CLI::App& app, Job& job);
void add_points(CLI::App& app, Job& job);
void add_tape(CLI::App& app, Job& job);
void add_verify(CLI::App& app, Job& job);

/// The subcommand itself with --help, --version and the options of messages.
[[nodiscard]] CLI::App* add_verb(CLI::App& app, Job& job, const std::string& name,
                                 const std::string& summary, const std::string& description);

/// Has the verb do `run` with the options as they stand when the command line has been read.
template <typename Options>
void set_job(CLI::App* verb, Job& job, std::shared_ptr<const Options> options,
             ExitCode (*run)(const Options&, const Console&)) {
  verb->callback([options, &job, run] {
    job.run = [options, &job, run] { return run(*options, job.messages.console()); };
  });
}

}  // namespace dgt::cli
