// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/options.h"

#include <cstdio>
#include <map>

#include "apps/cli/machine_options.h"

namespace dgt::cli {
namespace {

/// A decimal that is not negative.
std::string fault_of_length(const std::string& text) {
  const auto value = parse_decimal(text);
  return value && sgn(*value) >= 0 ? "" : "'" + text + "' is no length in mm";
}

std::map<std::string, Encoding> encodings() {
  std::map<std::string, Encoding> named;
  for (const Encoding encoding : kEncodings) named.emplace(name_of(encoding), encoding);
  return named;
}

std::string encoding_names() {
  std::string names;
  for (const Encoding encoding : kEncodings) {
    names.append(names.empty() ? "" : "|").append(name_of(encoding));
  }
  return names;
}

}  // namespace

Console MessageOptions::console() const {
  return {language.value_or(language_of_locale()), colour_of(colour),
          form == MessageForm::Sarif ? log : nullptr};
}

void MessageOptions::finish() const {
  if (form != MessageForm::Sarif) return;
  const std::string text = log->text(language.value_or(language_of_locale()));
  std::fwrite(text.data(), 1, text.size(), stderr);
}

SourceSettings SourceOptions::over(SourceSettings settings) const {
  settings.from = from;
  settings.encoding = encoding;
  settings.evaluate.encoding = encoding;
  if (offset_side) settings.evaluate.offset_side = *offset_side;
  if (join_tolerance) settings.evaluate.join_tolerance = parse_decimal(*join_tolerance).value();
  if (gouge) settings.evaluate.gouge = *gouge;
  settings.essi.nc.repair = settings.gcode.nc.repair = repair;
  settings.macro_path.insert(settings.macro_path.begin(), macro_path.begin(), macro_path.end());
  return settings;
}

void add_message_options(CLI::App& verb, MessageOptions& options) {
  static const std::map<std::string, Language> kLanguages = {{"en", Language::English},
                                                             {"ru", Language::Russian}};
  static const std::map<std::string, ColourChoice> kColours = {{"auto", ColourChoice::Auto},
                                                               {"always", ColourChoice::Always},
                                                               {"never", ColourChoice::Never}};
  static const std::map<std::string, MessageForm> kForms = {{"text", MessageForm::Text},
                                                            {"sarif", MessageForm::Sarif}};
  verb.add_option("--lang", options.language, "Language of the messages (default: the locale's)")
      ->option_text("en|ru")
      ->transform(CLI::CheckedTransformer(kLanguages).description(""))
      ->group("Messages");
  verb.add_option("--diagnostics", options.form,
                  "How diagnostics are written to standard error; sarif: as one SARIF 2.1.0 log, "
                  "for editors and build servers")
      ->option_text("text|sarif")
      ->transform(CLI::CheckedTransformer(kForms).description(""))
      ->group("Messages");
  // A bare --color asks for colour, as in other programs.
  verb.add_option("--color", options.colour,
                  "Colours in messages; auto: on a terminal, unless NO_COLOR is set")
      ->option_text("auto|always|never")
      ->transform(CLI::CheckedTransformer(kColours).description(""))
      ->group("Messages");
}

void add_encoding_option(CLI::App& verb, SourceOptions& options) {
  verb.add_option(
          "--encoding", options.encoding,
          "Encoding of the program, its macros and definition files (default: as each looks)")
      ->option_text(encoding_names())
      ->transform(CLI::CheckedTransformer(encodings(), CLI::ignore_case).description(""))
      ->group("Source");
}

void add_reading_options(CLI::App& verb, SourceOptions& options) {
  static const std::map<std::string, InputLanguage> kInputs = {
      {"dgt", InputLanguage::Dgt},          {"essi", InputLanguage::Essi},
      {"essi-iso", InputLanguage::EssiIso}, {"gcode", InputLanguage::Gcode},
      {"3b", InputLanguage::ThreeB},        {"dxf", InputLanguage::Dxf},
      {"poly", InputLanguage::Poly}};
  verb.add_option(
          "--from", options.from,
          "Language of the input (default: by the extension; .bgt and .dgt are DGT, .ess and .essi "
          "ESSI, .nc, .cnc, .gcode, .ngc and .tap G-code, .3b 3B, .dxf drawings, .poly polylines; "
          "standard input is DGT)")
      ->option_text("dgt|essi|essi-iso|gcode|3b|dxf|poly")
      ->transform(CLI::CheckedTransformer(kInputs).description(""))
      ->group("Source");
  add_encoding_option(verb, options);
  verb.add_flag("--repair", options.repair,
                "In ESSI and G-code, take an arc whose radius lacks at most one unit for its chord "
                "as half a turn, with a warning")
      ->group("Source");
}

void add_source_options(CLI::App& verb, SourceOptions& options) {
  static const std::map<std::string, OffsetSide> kSides = {
      {"auto", OffsetSide::Auto}, {"left", OffsetSide::Left}, {"right", OffsetSide::Right}};
  add_reading_options(verb, options);
  verb.add_option("--mac-path", options.macro_path,
                  "A further folder to look in for MAC files, after the program's own folder and "
                  "its subfolder mac; may be given again")
      ->option_text("FOLDER")
      ->allow_extra_args(false)
      ->group("Source");
  verb.add_option("--offset-side", options.offset_side,
                  "Where W > 0 lies, seen along the elements; auto (the default): on the side of "
                  "the contour's first element on which the tool stands")
      ->option_text("auto|left|right")
      ->transform(CLI::CheckedTransformer(kSides).description(""))
      ->group("Source");
  verb.add_option("--join-tolerance", options.join_tolerance,
                  "Offset elements that miss each other by at most this are joined with a warning "
                  "(default: 0.001)")
      ->option_text("MM")
      ->check(CLI::Validator(fault_of_length, ""))
      ->group("Source");
  static const std::map<std::string, GougePolicy> kGouges = {
      {"error", GougePolicy::Error}, {"warn", GougePolicy::Warn}, {"trim", GougePolicy::Trim}};
  verb.add_option("--gouge", options.gouge,
                  "What it is when the tool cuts into its own contour (default: error); trim: the "
                  "loops that do are left out")
      ->option_text("error|warn|trim")
      ->transform(CLI::CheckedTransformer(kGouges).description(""))
      ->group("Source");
  add_machine_options(verb, options.machine);
}

void add_request(CLI::App& verb, Request& request, const std::string& what) {
  verb.add_option("FILE", request.file, "The program; - is standard input")
      ->required()
      ->option_text(" ");
  verb.add_option("-o,--output", request.output,
                  what + "; written whole or not at all (default: -, standard output)")
      ->option_text("OUT");
  add_source_options(verb, request.source);
}

}  // namespace dgt::cli
