// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "apps/cli/session.h"
#include "apps/cli/verbs.h"
#include "apps/driver/names.h"
#include "apps/driver/picture.h"
#include "post/dxf.h"
#include "post/svg.h"

namespace dgt::cli {
namespace {

struct PlotOptions {
  Request request;
  bool names = false;
  double size = DrawingStyle{}.size;
};

enum class DrawingForm : std::uint8_t { Svg, Pdf, Png, Dxf };

/// By the extension; standard output is SVG.
std::optional<DrawingForm> form_of(const std::string& name) {
  const std::string extension = CLI::detail::to_lower(std::filesystem::path(name).extension());
  if (name == kStream || extension == ".svg") return DrawingForm::Svg;
  if (extension == ".pdf") return DrawingForm::Pdf;
  if (extension == ".png") return DrawingForm::Png;
  if (extension == ".dxf") return DrawingForm::Dxf;
  return std::nullopt;
}

std::string drawn(const Compilation& made, const PlotOptions& options, DrawingForm form) {
  const Toolpath& path = *made.result.path;
  if (form == DrawingForm::Dxf) return draw_dxf(path);
  DrawingStyle style;
  style.size = options.size;
  const std::vector<NamedShape> named = options.names ? names_of(made) : std::vector<NamedShape>();
  const std::string svg = draw_svg(path, style, named);
  if (form == DrawingForm::Pdf) return pdf_of(svg);
  return form == DrawingForm::Png ? png_of(svg) : svg;
}

ExitCode run(const PlotOptions& options, const Console& console) {
  const Request& request = options.request;
  const auto form = form_of(request.output);
  if (!form) {
    console.error(Text::UnknownDrawing, {request.output});
    return ExitCode::WrongUsage;
  }
  const auto made = load(request.file, request.source, console);
  if (!made) return made.error();
  return write_result(request.output, drawn(*made, options, *form), console);
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
