// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/session.h"
#include "apps/cli/verbs.h"
#include "apps/driver/drawing_file.h"

namespace dgt::cli {
namespace {

struct PlotOptions {
  Request request;
  bool names = false;
  double size = DrawingStyle{}.size;
};

ExitCode run(const PlotOptions& options, const Console& console) {
  const Request& request = options.request;
  const auto form = drawing_form(request.output);
  if (!form) {
    console.error(Text::UnknownDrawing, {request.output});
    return ExitCode::WrongUsage;
  }
  const auto made = load(request.file, request.source, console);
  if (!made) return made.error();
  DrawingOptions drawing;
  drawing.form = *form;
  drawing.names = options.names;
  drawing.style.size = options.size;
  return write_result(request.output, drawing_of(*made, drawing), console);
}

}  // namespace

void add_plot(CLI::App& app, Job& job) {
  const auto options = std::make_shared<PlotOptions>();
  CLI::App* verb = add_verb(app, job, "plot", "A drawing of the tool path",
                            "Draws the tool path as SVG, PDF, PNG or DXF: the programmed contour "
                            "green, the equidistant (what is cut) "
                            "yellow, rapids dashed, the start a dot. Arcs are true arcs, "
                            "coordinates are millimetres. In DXF these are the "
                            "layers CONTOUR, EQUIDISTANT and RAPIDS.");
  add_request(*verb, options->request, "The drawing, a name that ends in .svg, .pdf, .png or .dxf");
  verb->add_flag("--names", options->names,
                 "Draw the elements too, with their names and directions, and the direction of "
                 "the cut");
  verb->add_option("--size", options->size, "The longer side (default: 1000), not of DXF")
      ->option_text("PIXELS")
      ->check(CLI::Range(50, 20000).description(""));
  set_job<PlotOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
