// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/session.h"
#include "apps/cli/verbs.h"
#include "apps/driver/path_json.h"

namespace dgt::cli {
namespace {

ExitCode run(const Request& request, const Console& console) {
  const auto path = load_path(request.file, request.source, console);
  if (!path) return path.error();
  return write_result(request.output, to_json(*path), console);
}

}  // namespace

void add_path(CLI::App& app, Job& job) {
  const auto options = std::make_shared<Request>();
  CLI::App* verb = add_verb(
      app, job, "path", "The tool path as JSON",
      "Writes the tool path as JSON, schema dgt-path/1: the start, each contour as programmed and "
      "as the tool runs it, every move of the program in order, and the lengths. Coordinates are "
      "millimetres, each the double nearest to the exact value; angles are degrees, "
      "counter-clockwise positive. The same program gives the same bytes.");
  add_request(*verb, *options, "File for the JSON");
  set_job<Request>(verb, job, options, run);
}

}  // namespace dgt::cli
