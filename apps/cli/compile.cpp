// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/compile.h"

#include <map>

#include "apps/cli/machine_options.h"
#include "apps/cli/session.h"
#include "apps/cli/stage.h"
#include "apps/cli/verbs.h"
#include "apps/driver/write_messages.h"

namespace dgt::cli {
namespace {

constexpr const char* kList = "list";

struct CompileOptions {
  Request request;
  PostOptions post;
};

ExitCode run(const CompileOptions& options, const Console& console) {
  if (options.post.dialect == kList) {
    return write_result(options.request.output, list_of_dialects(console.language()), console);
  }
  return write_for(options.request, options.post, console);
}

}  // namespace

void add_compensation(CLI::App& verb, PostOptions& options) {
  static const std::map<std::string, Compensation> kChoices = {{"computed", Compensation::Computed},
                                                               {"control", Compensation::Control}};
  verb.add_option(
          "--compensation", options.compensation,
          "Who offsets contours with W; computed (the default): the equidistant is "
          "written; control: the contour with G41 or G42, 29 or 30 and a straight cut to it")
      ->option_text("computed|control")
      ->transform(CLI::CheckedTransformer(kChoices).description(""))
      ->group("Machine");
}

ExitCode write_for(const Request& request, const PostOptions& post, const Console& console) {
  auto settings = settle(request.source, console, post.dialect);
  if (!settings) return settings.error();
  Dialect& dialect = settings->dialect;
  if (post.compensation) dialect.compensation = *post.compensation;
  if (dialect.name.empty()) {
    console.error(Text::NoDialect, {names_of_dialects(", ")});
    return ExitCode::WrongUsage;
  }
  const auto made = load(request.file, request.source, settings->source, console);
  if (!made) return made.error();
  const WriteResult written = [&] {
    Stage stage(console, Text::StageWriting, request.file);
    return write(*made->result.path, dialect, stage.on_progress());
  }();
  console.show(explain(written, dialect, *made), sources_of(*made));
  if (!written.faults.empty()) return ExitCode::InputErrors;
  const ExitCode code = write_result(request.output, written.text, console);
  if (code == ExitCode::Done) {
    console.note(Text::Compiled, {dialect.name, std::to_string(written.report.blocks),
                                  told(written.report.deviation)});
  }
  return code;
}

void add_compile(CLI::App& app, Job& job) {
  const auto options = std::make_shared<CompileOptions>();
  CLI::App* verb = add_verb(
      app, job, "compile", "From source to NC program: the main job",
      "Compiles a program for a control and writes it whole or not at all. A note tells the number "
      "of blocks and the certificate: how far the written curve lies from the exact tool path at "
      "most, which is proved block by block, not sampled. A program with an error yields no output "
      "and exit code 1.\n\nExample:\n  dgt compile 1P.bgt --post essi -o 1P.ess");
  add_request(*verb, options->request, "The NC program");
  verb->get_option("FILE")->required(false);  // not for the list
  verb->add_option("--post", options->post.dialect,
                   "The dialect to write, unless the machine file chooses it: a file of one's own, "
                   "list to tell of all, or " +
                       names_of_dialects(", "))
      ->option_text("NAME|FILE.toml|list")
      ->group("Machine");
  add_compensation(*verb, options->post);
  verb->callback([options, &job] {
    if (options->request.file.empty() && options->post.dialect != kList) {
      throw CLI::RequiredError("FILE");
    }
    job.run = [options, &job] { return run(*options, job.messages.console()); };
  });
}

}  // namespace dgt::cli
