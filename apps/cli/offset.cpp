// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "apps/cli/session.h"
#include "apps/cli/verbs.h"
#include "apps/driver/offset_input.h"
#include "apps/driver/offset_loops.h"
#include "lang/poly/reader.h"

namespace dgt::cli {
namespace {

constexpr const char* kRound = "round";

enum class Engine : std::uint8_t { Production, Reference };
enum class Form : std::uint8_t { Json, Poly, Svg };

struct OffsetOptions {
  Request request;
  std::string distance;
  std::string corner = kRound;
  Engine engine = Engine::Production;
};

std::optional<Form> form_of(const std::string& output) {
  static const std::map<std::string, Form> kForms = {
      {".json", Form::Json}, {".poly", Form::Poly}, {".svg", Form::Svg}};
  if (output == kStream) return Form::Json;
  const auto found =
      kForms.find(CLI::detail::to_lower(std::filesystem::path(output).extension().string()));
  return found == kForms.end() ? std::nullopt : std::optional(found->second);
}

/// An open loop has no inside that could shrink.
void refuse_open(const std::vector<PolyLoop>& loops, DiagnosticBag& bag) {
  for (const PolyLoop& loop : loops) {
    if (!loop.chain.closed) bag.add({Message::OpenLoopOffset, loop.places.front(), {}});
  }
}

Step<std::vector<Chain>> loops_of_poly(const Request& request, const Console& console) {
  const auto bytes = read_file(request.file);
  if (!bytes) return tl::unexpected(report(bytes.error(), console));
  const auto source = decode_source(request.file, *bytes, request.source.encoding);
  DiagnosticBag bag;
  std::vector<PolyLoop> loops = read_poly(*source, bag);
  refuse_open(loops, bag);
  bag.sort();
  console.show(bag, {source});
  if (bag.has_errors()) return tl::unexpected(ExitCode::InputErrors);
  std::vector<Chain> chains;
  for (PolyLoop& loop : loops) chains.push_back(std::move(loop.chain));
  return chains;
}

Step<std::vector<Chain>> loops_of_program(const Request& request, const Console& console) {
  const auto path = load_path(request.file, request.source, console);
  if (!path) return tl::unexpected(path.error());
  std::vector<Chain> chains;
  for (const Contour& contour : path->contours) {
    const std::string id = std::to_string(contour.id);
    if (auto chain = loop_of(contour)) {
      console.note(Text::LoopTaken,
                   {id, std::to_string(chain->edges.size()), fmt::format("{:.6f}", area(*chain))});
      chains.push_back(*std::move(chain));
    } else {
      console.note(Text::ContourLeftOut, {id});
    }
  }
  if (chains.empty()) {
    console.error(Text::NoClosedContour, {request.file});
    return tl::unexpected(ExitCode::InputErrors);
  }
  return chains;
}

Step<std::vector<Chain>> loops_of_input(const Request& request, const Console& console) {
  if (const auto known = expect_source(request.file, request.source, console); !known) {
    return tl::unexpected(known.error());
  }
  return language_for(request.file, request.source) == InputLanguage::Poly
             ? loops_of_poly(request, console)
             : loops_of_program(request, console);
}

std::vector<OffsetLoop> offset_by(Engine engine, const std::vector<Chain>& loops,
                                  const Rational& distance) {
  return engine == Engine::Production ? production_offset(loops, distance)
                                      : reference_offset(loops, distance);
}

std::string in_form(Form form, const std::vector<EquidistantLoop>& loops,
                    const std::vector<Chain>& contours) {
  switch (form) {
    case Form::Json:
      return to_json(loops);
    case Form::Poly:
      return to_poly(loops);
    case Form::Svg:
      return to_svg(loops, contours);
  }
  return {};
}

ExitCode run(const OffsetOptions& options, const Console& console) {
  const auto distance = parse_scientific(options.distance);
  if (!distance) {
    console.error(Text::BadDistance, {options.distance});
    return ExitCode::WrongUsage;
  }
  if (options.corner != kRound) {
    console.error(Text::UnknownCorner, {options.corner});
    return ExitCode::WrongUsage;
  }
  const auto form = form_of(options.request.output);
  if (!form) {
    console.error(Text::UnknownOffsetForm, {options.request.output});
    return ExitCode::WrongUsage;
  }
  const auto contours = loops_of_input(options.request, console);
  if (!contours) return contours.error();
  const auto loops = in_order(offset_by(options.engine, *contours, *distance));
  return write_result(options.request.output, in_form(*form, loops, *contours), console);
}

}  // namespace

void add_offset(CLI::App& app, Job& job) {
  const auto options = std::make_shared<OffsetOptions>();
  CLI::App* verb = add_verb(
      app, job, "offset", "The equidistant of closed contours, without loops that gouge",
      "Writes the boundary of all places that lie left of the directed loops and at least the "
      "distance away from them: nothing is cut into, every island stays, and what is too narrow "
      "for the distance is gone. Every decision is exact. Loops are those of a .poly file, or the "
      "programmed paths (W = 0) of a program's closed contours in their direction, without leads. "
      "Loops may touch and must not cross.\n\nExample:\n"
      "  dgt offset part.poly --distance 0.2 -o inner.poly");
  add_request(*verb, options->request,
              "The equidistant, a name that ends in .json, .poly or .svg; - is JSON");
  verb->add_option("--distance", options->distance,
                   "How far, in mm, an exact decimal; positive: to the left of the direction, "
                   "so that counter-clockwise loops shrink")
      ->required()
      ->option_text("MM");
  verb->add_option("--corner", options->corner,
                   "What joins the equidistants of a corner's edges on its outside: an arc about "
                   "the corner (default: round)")
      ->option_text("round");
  static const std::map<std::string, Engine> kEngines = {{"production", Engine::Production},
                                                         {"reference", Engine::Reference}};
  verb->add_option("--engine", options->engine,
                   "Which of two engines calculates it; both give the same loops, the reference "
                   "is slow and simple (default: production)")
      ->option_text("production|reference")
      ->transform(CLI::CheckedTransformer(kEngines).description(""));
  set_job<OffsetOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
