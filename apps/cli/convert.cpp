// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/compile.h"
#include "apps/cli/machine_options.h"
#include "apps/cli/verbs.h"

namespace dgt::cli {
namespace {

struct ConvertOptions {
  Request request;
  PostOptions post;
};

ExitCode run(const ConvertOptions& options, const Console& console) {
  return write_for(options.request, options.post, console);
}

}  // namespace

void add_convert(CLI::App& app, Job& job) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* verb = add_verb(
      app, job, "convert", "From any language to any dialect",
      "Reads a program in DGT, ESSI, G-code or as polylines and writes it for a control, whole or "
      "not at all. Subprograms are written out, kerf that the program asks for is applied. What "
      "was "
      "written here comes back byte for byte when it is read and written again.\n\nExample:\n"
      "  dgt convert star.ess --to linuxcnc -o star.ngc");
  add_request(*verb, options->request, "The NC program");
  verb->add_option("--to", options->post.dialect,
                   "The dialect to write: a file of one's own, or " + names_of_dialects(", "))
      ->required()
      ->option_text("NAME|FILE.toml")
      ->group("Machine");
  add_compensation(*verb, options->post);
  set_job<ConvertOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
