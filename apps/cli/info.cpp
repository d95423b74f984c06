// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/machine_options.h"
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
  const Request& request = options.request;
  const auto settings = settle(request.source, console);
  if (!settings) return settings.error();
  const auto made = load(request.file, request.source, settings->source, console);
  if (!made) return made.error();
  const Summary summary = summarise(*made->result.path, settings->motion);
  return write_result(options.request.output,
                      options.json ? to_json(summary) : to_text(summary, console.language()),
                      console);
}

}  // namespace

void add_info(CLI::App& app, Job& job) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* verb = add_verb(
      app, job, "info", "Moves, lengths, box, time and pierces",
      "Tells what the tool path amounts to: moves by kind, contours, pierces (how often cutting "
      "begins after the start or a rapid), the length cut and travelled, dwells, the time, and "
      "the box of everything travelled, the bulges of arcs included. The time is that of a machine "
      "with the settings rapid_speed, cut_speed (where the program says no feed), acceleration, "
      "corner_deviation and pierce_time: trapezoidal speeds, corners as fast as on an arc that "
      "leaves them by corner_deviation.");
  add_request(*verb, options->request, "File for the answer");
  verb->add_flag("--json", options->json, "As JSON, schema dgt-info/1");
  set_job<InfoOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
