// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "apps/cli/session.h"
#include "apps/cli/verbs.h"
#include "apps/driver/names.h"
#include "post/svg.h"

namespace dgt::cli {
namespace {

struct PlotOptions {
  Request request;
  bool names = false;
  double size = DrawingStyle{}.size;
};

bool is_drawing(const std::string& name) {
  return name == kStream ||
         CLI::detail::to_lower(std::filesystem::path(name).extension()) == ".svg";
}

ExitCode run(const PlotOptions& options, const Console& console) {
  const Request& request = options.request;
  if (!is_drawing(request.output)) {
    console.error(Text::UnknownDrawing, {request.output});
    return ExitCode::WrongUsage;
  }
  const auto made = load(request.file, request.source, console);
  if (!made) return made.error();
  DrawingStyle style;
  style.size = options.size;
  const std::vector<NamedShape> named = options.names ? names_of(*made) : std::vector<NamedShape>();
  return write_result(request.output, draw_svg(*made->result.path, style, named), console);
}

}  // namespace

void add_plot(CLI::App& app, Job& job) {
  const auto options = std::make_shared<PlotOptions>();
  CLI::App* verb = add_verb(
      app, job, "plot", "A drawing of the tool path",
      "Draws the tool path as SVG: the programmed contour green, the equidistant (what is cut) "
      "yellow, rapids dashed, the start a dot. Arcs are true arcs, coordinates are millimetres.");
  add_request(*verb, options->request, "The drawing, a name that ends in .svg");
  verb->add_flag("--names", options->names,
                 "Draw the elements too, with their names and directions, and the direction of "
                 "the cut");
  verb->add_option("--size", options->size, "The longer side (default: 1000)")
      ->option_text("PIXELS")
      ->check(CLI::Range(50, 20000).description(""));
  set_job<PlotOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
