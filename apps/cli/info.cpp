// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/session.h"
#include "apps/cli/verbs.h"
#include "apps/driver/summary.h"

namespace dgt::cli {
namespace {

struct InfoOptions {
  Request request;
  bool json = false;
};

ExitCode run(const InfoOptions& options, const Console& console) {
  const auto path = load_path(options.request.file, options.request.source, console);
  if (!path) return path.error();
  const Summary summary = summarise(*path);
  return write_result(options.request.output,
                      options.json ? to_json(summary) : to_text(summary, console.language()),
                      console);
}

}  // namespace

void add_info(CLI::App& app, Job& job) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* verb = add_verb(
      app, job, "info", "Moves, lengths, box and pierces",
      "Tells what the tool path amounts to: moves by kind, contours, pierces (how often cutting "
      "begins after the start or a rapid), the length cut and travelled, dwells, and the box of "
      "everything travelled, the bulges of arcs included.");
  add_request(*verb, options->request, "File for the answer");
  verb->add_flag("--json", options->json, "As JSON, schema dgt-info/1");
  set_job<InfoOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
