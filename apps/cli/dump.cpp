// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/dump.h"

#include "apps/cli/session.h"
#include "apps/cli/verbs.h"

namespace dgt::cli {
namespace {

struct DumpOptions {
  Request request;
  bool tokens = false;
  bool ast = false;
  bool elements = false;
};

ExitCode run(const DumpOptions& options, const Console& console) {
  const bool stages = options.tokens || options.ast || options.elements;
  const std::string& file = options.request.file;
  if (stages && language_for(file, options.request.source) != InputLanguage::Dgt) {
    console.error(Text::DgtOnly, {file});
    return ExitCode::WrongUsage;
  }
  const auto made = load(options.request.file, options.request.source, console);
  if (!made) return made.error();
  std::string text;
  if (options.tokens) text += language::print_words(*made->file);
  if (options.ast) text += language::print_syntax(*made->file);
  if (options.elements) text += language::print_elements(made->result.elements);
  if (!stages) text = to_text(*made->result.path);
  return write_result(options.request.output, text, console);
}

}  // namespace

void add_dump(CLI::App& app, Job& job) {
  const auto options = std::make_shared<DumpOptions>();
  CLI::App* verb = add_verb(
      app, job, "dump", "The internal form of a program",
      "Prints the tool path in its internal form, one line a move: number, kind, where it ends, "
      "what it is part of, and its place in the source. With --tokens, --ast or --elements it "
      "prints these stages of the work on a DGT program instead, in this order.");
  add_request(*verb, options->request, "File for the text");
  verb->add_flag("--tokens", options->tokens, "The words of each line as they were read");
  verb->add_flag("--ast", options->ast, "The statements");
  verb->add_flag("--elements", options->elements,
                 "The lines, circles, points and coordinate systems as they stand at the end, with "
                 "certified bounds");
  set_job<DumpOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
