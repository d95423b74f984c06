// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "apps/cli/session.h"
#include "apps/cli/verbs.h"
#include "apps/driver/offset_input.h"
#include "apps/driver/offset_loops.h"
#include "kernel/loop_fault.h"
#include "lang/poly/reader.h"

namespace dgt::cli {
namespace {

using Engine = OffsetEngineKind;
enum class Form : std::uint8_t { Json, Poly, Svg };

struct OffsetJob {
  Request request;
  std::string distance;
  OffsetOptions options;
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

Step<std::vector<Chain>> loops_of_poly(const Request& request, const Console& console) {
  const auto bytes = read_file(request.file);
  if (!bytes) return tl::unexpected(report(bytes.error(), console));
  const auto source = decode_source(request.file, *bytes, request.source.encoding);
  DiagnosticBag bag;
  std::vector<PolyLoop> loops = read_poly(*source, bag);
  bag.sort();
  console.show(bag, {source});
  if (bag.has_errors()) return tl::unexpected(ExitCode::InputErrors);
  std::vector<Chain> chains;
  for (PolyLoop& loop : loops) chains.push_back(std::move(loop.chain));
  return chains;
}

Step<std::vector<Chain>> loops_of_program(const Request& request, const Console& console) {
  SourceOptions source = request.source;
  // The part lies to the left of every loop; a drawing has no directions of its own.
  if (language_for(request.file, source) == InputLanguage::Dxf)
    source.machine.settings.insert(source.machine.settings.begin(), "dxf.direction=part-left");
  const auto path = load_path(request.file, source, console);
  if (!path) return tl::unexpected(path.error());
  std::vector<Chain> chains;
  for (const Contour& contour : path->contours) {
    const std::string id = std::to_string(contour.id);
    if (auto chain = loop_of(*path, contour)) {
      const std::string edges = std::to_string(chain->edges.size());
      if (chain->closed)
        console.note(Text::LoopTaken, {id, edges, fmt::format("{:.6f}", area(*chain))});
      else
        console.note(Text::OpenLoopTaken, {id, edges});
      chains.push_back(*std::move(chain));
    } else {
      console.note(Text::ContourLeftOut, {id});
    }
  }
  if (chains.empty()) {
    console.error(Text::NoContour, {request.file});
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

std::vector<Chain> closed_of(const std::vector<Chain>& loops) {
  std::vector<Chain> closed;
  for (const Chain& loop : loops)
    if (loop.closed) closed.push_back(loop);
  return closed;
}

/// Loops are numbered as they are given, from 1.
void report(const LoopFault& fault, const std::vector<Chain>& loops, const Console& console) {
  const auto number = [&](std::size_t closed) {
    std::size_t at = 0;
    for (; !loops[at].closed || closed > 0; ++at)
      if (loops[at].closed) --closed;
    return std::to_string(at + 1);
  };
  const std::string x = to_short_decimal(Rational(fault.x), 6);
  const std::string y = to_short_decimal(Rational(fault.y), 6);
  if (fault.kind == LoopFault::Kind::Nesting)
    console.error(Text::LoopsNested, {number(fault.loop), x, y});
  else if (fault.loop == fault.other)
    console.error(Text::LoopCrossesItself, {number(fault.loop), x, y});
  else
    console.error(Text::LoopsCross, {number(fault.loop), number(fault.other), x, y});
}

/// Closed loops bound one region; open ones have an equidistant each.
std::vector<OffsetLoop> offset_by(const OffsetJob& job, const std::vector<Chain>& loops,
                                  const Rational& distance) {
  const std::vector<Chain> closed = closed_of(loops);
  std::vector<OffsetLoop> result = job.engine == Engine::Production
                                       ? production_offset(closed, distance, job.options)
                                       : reference_offset(closed, distance, job.options);
  for (const Chain& loop : loops) {
    if (loop.closed) continue;
    for (OffsetLoop& found : open_offset(loop, distance, job.options, job.engine))
      result.push_back(std::move(found));
  }
  return result;
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

bool has_open(const std::vector<Chain>& loops) {
  return std::ranges::any_of(loops, [](const Chain& loop) { return !loop.closed; });
}

ExitCode run(const OffsetJob& job, const Console& console) {
  const auto distance = parse_scientific(job.distance);
  if (!distance) {
    console.error(Text::BadDistance, {job.distance});
    return ExitCode::WrongUsage;
  }
  const auto form = form_of(job.request.output);
  if (!form) {
    console.error(Text::UnknownOffsetForm, {job.request.output});
    return ExitCode::WrongUsage;
  }
  const auto contours = loops_of_input(job.request, console);
  if (!contours) return contours.error();
  if (sgn(*distance) == 0 && has_open(*contours)) {
    console.error(Text::OpenLoopAtZero, {});
    return ExitCode::WrongUsage;
  }
  if (const auto fault = find_loop_fault(closed_of(*contours))) {
    report(*fault, *contours, console);
    return ExitCode::InputErrors;
  }
  const auto loops = in_order(offset_by(job, *contours, *distance));
  return write_result(job.request.output, in_form(*form, loops, *contours), console);
}

}  // namespace

void add_offset(CLI::App& app, Job& job) {
  const auto options = std::make_shared<OffsetJob>();
  CLI::App* verb = add_verb(
      app, job, "offset", "The equidistant of contours, without loops that gouge",
      "Writes the boundary of all places that lie left of the directed loops and at least the "
      "distance away from them: nothing is cut into, every island stays, and what is too narrow "
      "for the distance is gone. Of an open loop it writes the equidistant to its left, or right "
      "of it for a negative distance. Every decision is exact. Loops are those of a .poly file, or "
      "the programmed paths (W = 0) of a program's contours in their direction, without leads. "
      "Loops may touch and must not cross.\n\nExample:\n"
      "  dgt offset part.poly --distance 0.2 -o inner.poly");
  add_request(*verb, options->request,
              "The equidistant, a name that ends in .json, .poly or .svg; - is JSON");
  verb->add_option("--distance", options->distance,
                   "How far, in mm, an exact decimal; positive: to the left of the direction, "
                   "so that counter-clockwise loops shrink")
      ->required()
      ->option_text("MM");
  static const std::map<std::string, OffsetCorner> kCorners = {{"round", OffsetCorner::Round},
                                                               {"sharp", OffsetCorner::Sharp},
                                                               {"chamfer", OffsetCorner::Chamfer}};
  verb->add_option("--corner", options->options.corner,
                   "What joins the equidistants of a corner's edges on its outside: an arc about "
                   "the corner, the equidistants themselves prolonged until they meet, or their "
                   "tangents cut by one that touches that arc (default: round)")
      ->option_text("round|sharp|chamfer")
      ->transform(CLI::CheckedTransformer(kCorners).description(""));
  verb->add_option("--spike-limit", options->options.spike_limit,
                   "How many distances a sharp corner may lie from the contour's corner; beyond, "
                   "it is round (default: 4)")
      ->option_text("TIMES")
      ->check(CLI::Range(1.0, 1000.0).description(""));
  static const std::map<std::string, Engine> kEngines = {{"production", Engine::Production},
                                                         {"reference", Engine::Reference}};
  verb->add_option("--engine", options->engine,
                   "Which of two engines calculates it; both give the same loops, the reference "
                   "is slow and simple (default: production)")
      ->option_text("production|reference")
      ->transform(CLI::CheckedTransformer(kEngines).description(""));
  set_job<OffsetJob>(verb, job, options, run);
}

}  // namespace dgt::cli
