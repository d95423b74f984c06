// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "apps/cli/machine_options.h"
#include "apps/cli/session.h"
#include "apps/cli/stage.h"
#include "apps/cli/verbs.h"
#include "apps/driver/certificate.h"
#include "apps/driver/control_proof.h"
#include "apps/driver/nc_files.h"

namespace dgt::cli {
namespace {

struct VerifyOptions {
  Request request;
  std::string against;
  std::string post;
  std::optional<std::string> tolerance;
  bool json = false;
};

/// Whose program it will be, if nobody says.
std::string usual_dialect(const std::string& file, InputLanguage language) {
  if (language == InputLanguage::Essi || language == InputLanguage::EssiIso) return "essi";
  if (language == InputLanguage::ThreeB) return "3b";
  const std::string extension = std::filesystem::path(file).extension();
  return CLI::detail::to_lower(extension) == ".cnc" ? "plasmatic" : "linuxcnc";
}

bool is_nc(InputLanguage language) {
  return language == InputLanguage::Essi || language == InputLanguage::EssiIso ||
         language == InputLanguage::Gcode || language == InputLanguage::ThreeB;
}

Step<Settings> settings_of(const VerifyOptions& options, const Console& console) {
  const Request& request = options.request;
  if (!options.post.empty()) return settle(request.source, console, options.post);
  auto settings = settle(request.source, console);
  if (!settings || !settings->dialect.name.empty()) return settings;
  return settle(request.source, console,
                usual_dialect(request.file, language_for(request.file, request.source)));
}

/// The other file goes by its extension.
SourceOptions of_the_other(SourceOptions options) {
  options.from.reset();
  return options;
}

ExitCode run(const VerifyOptions& options, const Console& console) {
  const Request& request = options.request;
  const InputLanguage language = language_for(request.file, request.source);
  if (!is_nc(language)) {
    console.error(Text::NotNc, {request.file});
    return ExitCode::WrongUsage;
  }
  const auto settings = settings_of(options, console);
  if (!settings) return settings.error();
  const SourceSettings reading = as_its_control(*settings);
  const auto program = load(request.file, request.source, reading, console);
  if (!program) return program.error();
  const SourceOptions other = of_the_other(request.source);
  SourceSettings source = settings->source;
  source.from.reset();
  const auto against = load(options.against, other, source, console);
  if (!against) return against.error();
  VerifyLimits limits = limits_of(settings->dialect);
  if (options.tolerance) limits.deviation = *parse_decimal(*options.tolerance);
  const Certificate proof = [&] {
    Stage stage(console, Text::StageProving, request.file);
    return prove({request.file, *program, reading}, {options.against, *against, source},
                 settings->dialect, limits, stage.on_progress());
  }();
  const ExitCode code = write_result(
      request.output, options.json ? to_json(proof) : to_text(proof, console.language()), console);
  return code != ExitCode::Done || proof.holds() ? code : ExitCode::NotVerified;
}

std::string fault_of_tolerance(const std::string& text) {
  const auto value = parse_decimal(text);
  return value && sgn(*value) > 0 ? "" : "'" + text + "' is no tolerance in mm";
}

}  // namespace

void add_verify(CLI::App& app, Job& job) {
  const auto options = std::make_shared<VerifyOptions>();
  CLI::App* verb = add_verb(
      app, job, "verify", "The proof of an NC program",
      "Reads an NC program back and proves that it runs the exact path of another file, a DGT "
      "source as a rule: how far the two curves lie apart at most, both ways; that every block "
      "ends within half a unit of where it should; that closed contours close; that nothing is "
      "gouged; that the two radii of every arc agree as well as the control demands. All are upper "
      "bounds with a proof; nothing is sampled, and nothing of the writers is used. Exit code 4 "
      "when the proof fails, with the blocks that are to blame.\n\nExample:\n"
      "  dgt verify 1P.ess --against 1P.bgt");
  add_request(*verb, options->request, "File for the certificate");
  verb->add_option("--against", options->against,
                   "What the program has to run: any source; its language goes by its extension")
      ->required()
      ->option_text("FILE");
  verb->add_option("--post", options->post,
                   "The dialect whose unit and limits hold (default: essi for ESSI, 3b for 3B, "
                   "plasmatic for .cnc, linuxcnc for other G-code)")
      ->option_text("NAME")
      ->group("Machine");
  verb->add_option("--tolerance", options->tolerance,
                   "The curves may lie this far apart (default: two units)")
      ->option_text("MM")
      ->check(CLI::Validator(fault_of_tolerance, ""));
  verb->add_flag("--json", options->json, "As JSON, schema dgt-verify/1");
  set_job<VerifyOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
