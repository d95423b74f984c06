// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "apps/cli/help.h"
#include "apps/cli/verbs.h"
#include "apps/driver/internal_error.h"

namespace dgt::cli {
namespace {

constexpr const char* kVersion = "dgt " DGT_VERSION;
constexpr const char* kHelpHelp = "This help";
constexpr const char* kVersionHelp = "The version of the program";
constexpr const char* kFooter =
    "`dgt VERB --help` tells about a verb.\n\n"
    "Diagnostics go to standard error as\n"
    "  file:line:column: error|warning|note: text [CODE]\n"
    "followed by the source line and a caret.\n\n"
    "Exit codes:\n"
    "  0  done\n"
    "  1  the input has errors; nothing was written\n"
    "  2  wrong usage\n"
    "  3  a file or device failed\n"
    "  4  verification failed\n\n"
    "Environment:\n"
    "  LC_ALL, LC_MESSAGES, LANG  language of the messages, without --lang\n"
    "  NO_COLOR                   no colours, without --color\n";

/// `--set a=1 b=2` as `--set a=1 --set b=2`; a word that is no `key=value` ends the run.
std::vector<std::string> with_settings_apart(int argc, const char* const* argv) {
  const auto is_setting = [](const std::string& word) {
    const auto equals = word.find('=');
    return equals != std::string::npos && equals > 0 &&
           word.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.-") == equals &&
           word.front() >= 'a' && word.front() <= 'z';
  };
  std::vector<std::string> words;
  bool after_setting = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool is_value = !words.empty() && words.back() == "--set";
    if (after_setting && !is_value && is_setting(word)) words.emplace_back("--set");
    after_setting = is_value || (after_setting && is_setting(word));
    words.push_back(word);
  }
  return words;
}

void declare(CLI::App& app, Job& job) {
  app.formatter(manual_formatter());  // the verbs inherit it
  app.set_help_flag("-h,--help", kHelpHelp);
  app.set_version_flag("--version", kVersion, kVersionHelp);
  app.require_subcommand(1);
  app.footer(kFooter);
  add_compile(app, job);
  add_convert(app, job);
  add_verify(app, job);
  add_batch(app, job);
  add_check(app, job);
  add_format(app, job);
  add_path(app, job);
  add_dump(app, job);
  add_points(app, job);
  add_info(app, job);
  add_plot(app, job);
  add_offset(app, job);
  add_tape(app, job);
}

void report(const FailedRun& error, const Console& console) {
  std::error_code no_folder;
  const auto folder = std::filesystem::temp_directory_path(no_folder);
  const auto saved = save_internal_error(error, no_folder ? "." : folder);
  if (saved) {
    console.error(Text::InternalSaved, {error.what, *saved});
  } else {
    console.error(Text::Internal, {error.what});
  }
}

ExitCode run(const Job& job, const std::vector<std::string>& command_line) {
  ExitCode code = ExitCode::Failure;
  try {
    code = job.run();
  } catch (const std::exception& error) {
    report({error.what(), command_line}, job.messages.console());
  }
  job.messages.finish();
  return code;
}

ExitCode main(int argc, const char* const* argv) {
  CLI::App app("Exact-geometry CAM for wire-EDM and plasma cutting: DGT programs to NC programs.",
               "dgt");
  Job job;
  declare(app, job);
  try {
    std::vector<std::string> words = with_settings_apart(argc, argv);
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ExitCode::Done : ExitCode::WrongUsage;
  }
  return run(job, {argv + std::min(argc, 1), argv + argc});
}

}  // namespace

CLI::App* add_verb(CLI::App& app, Job& job, const std::string& name, const std::string& summary,
                   const std::string& description) {
  CLI::App* verb = app.add_subcommand(name, summary + "\n\n" + description);
  verb->set_help_flag("-h,--help", kHelpHelp);
  verb->set_version_flag("--version", kVersion, kVersionHelp);
  add_message_options(*verb, job.messages);
  return verb;
}

}  // namespace dgt::cli

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that leaves early is a failed write, not a death
  return static_cast<int>(dgt::cli::main(argc, argv));
}
