// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/points.h"

#include "apps/cli/session.h"
#include "apps/cli/verbs.h"

namespace dgt::cli {
namespace {

ExitCode run(const Request& request, const Console& console) {
  const auto path = load_path(request.file, request.source, console);
  if (!path) return path.error();
  return write_result(request.output, list_points(*path), console);
}

}  // namespace

void add_points(CLI::App& app, Job& job) {
  const auto options = std::make_shared<Request>();
  CLI::App* verb = add_verb(
      app, job, "points", "The calculated control points, numbered",
      "Lists the points between which the tool moves, numbered from 1: number, X, Y, then what "
      "leads there; for an arc its centre and its radius, negative when it runs clockwise. "
      "Millimetres with six decimals.");
  add_request(*verb, *options, "File for the list");
  set_job<Request>(verb, job, options, run);
}

}  // namespace dgt::cli
