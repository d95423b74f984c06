// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "apps/cli/session.h"
#include "apps/cli/verbs.h"
#include "post/svg.h"

namespace dgt::cli {
namespace {

bool is_drawing(const std::string& name) {
  return name == kStream ||
         CLI::detail::to_lower(std::filesystem::path(name).extension()) == ".svg";
}

ExitCode run(const Request& request, const Console& console) {
  if (!is_drawing(request.output)) {
    console.error(Text::UnknownDrawing, {request.output});
    return ExitCode::WrongUsage;
  }
  const auto path = load_path(request.file, request.source, console);
  if (!path) return path.error();
  return write_result(request.output, draw_svg(*path), console);
}

}  // namespace

void add_plot(CLI::App& app, Job& job) {
  const auto options = std::make_shared<Request>();
  CLI::App* verb = add_verb(
      app, job, "plot", "A drawing of the tool path",
      "Draws the tool path as SVG: the programmed contour green, the equidistant (what is cut) "
      "yellow, rapids dashed, the start a dot. Arcs are true arcs, coordinates are millimetres.");
  add_request(*verb, *options, "The drawing, a name that ends in .svg");
  set_job<Request>(verb, job, options, run);
}

}  // namespace dgt::cli
