// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/tape.h"

#include <map>

#include "apps/driver/tape_jobs.h"

namespace dgt::cli {
namespace {

Step<LoadedTape> encode_program(const std::string& name, std::string_view bytes,
                                const TapeOptions& options, const TapeFormat& format,
                                const Console& console) {
  ProgramOnTape made = program_on_tape(name, bytes, options.source.encoding, format);
  console.show(made.reading, {made.file});
  console.show(made.punching, {made.file});
  if (made.reading.has_errors() || made.punching.has_errors())
    return tl::unexpected(ExitCode::InputErrors);
  return LoadedTape{{std::move(made.rows), {}}, true};
}

Step<Tape> tape_in(const std::string& name, std::string_view bytes, const Console& console) {
  TapeImage image = read_tape_image(name, bytes);
  console.show(image.bag, {image.file});
  if (image.bag.has_errors()) return tl::unexpected(ExitCode::InputErrors);
  return std::move(image.tape);
}

}  // namespace

void add_tape_settings(CLI::App& verb, TapeOptions& options) {
  add_encoding_option(verb, options.source);
  add_machine_options(verb, options.source.machine);
}

void add_tape_file(CLI::App& verb, TapeOptions& options, const std::string& what) {
  verb.add_option("FILE", options.file, what + "; - is standard input")
      ->required()
      ->option_text(" ");
}

void add_tape_output(CLI::App& verb, TapeOptions& options, const std::string& what) {
  verb.add_option("-o,--output", options.output,
                  what + "; written whole or not at all (default: -, standard output)")
      ->option_text("OUT");
  static const std::map<std::string, TapeForm> kForms = {{"raw", TapeForm::Raw},
                                                         {"picture", TapeForm::Picture},
                                                         {"svg", TapeForm::Svg},
                                                         {"png", TapeForm::Png},
                                                         {"text", TapeForm::Text}};
  verb.add_option("--form", options.form,
                  "The form of what is written, whatever its name: raw rows, a picture in letters "
                  "(both are read back), drawings true to ISO 1154, the program's text")
      ->option_text("raw|picture|svg|png|text")
      ->transform(CLI::CheckedTransformer(kForms).description(""));
}

void add_tape_header(CLI::App& verb, TapeOptions& options) {
  verb.add_option("--header", options.header,
                  "Lettering in holes before the %, for a person to read; A-Z, 0-9 and +-./_()=")
      ->option_text("TEXT");
}

Step<TapeFormat> format_for(const TapeOptions& options, const Settings& settings,
                            const Console& console) {
  const auto format = format_for(settings.tape, options.file, options.header);
  if (format) return *format;
  console.error(Text::TapeNeedsStart, {});
  return tl::unexpected(ExitCode::WrongUsage);
}

Step<Tape> load_image(const std::string& name, const Console& console) {
  const auto bytes = read_file(name);
  if (!bytes) return tl::unexpected(report(bytes.error(), console));
  return tape_in(name, *bytes, console);
}

Step<LoadedTape> load_tape(const std::string& name, const TapeOptions& options,
                           const TapeFormat& format, const Console& console) {
  const auto bytes = read_file(name);
  if (!bytes) return tl::unexpected(report(bytes.error(), console));
  if (!is_tape_image(name, *bytes)) return encode_program(name, *bytes, options, format, console);
  auto tape = tape_in(name, *bytes, console);
  if (!tape) return tl::unexpected(tape.error());
  return LoadedTape{*std::move(tape), false};
}

ExitCode write_tape(const std::string& output, const Tape& tape, TapeForm form, RowRange rows,
                    const Console& console) {
  const auto bytes = in_form(tape, form, rows);
  if (!bytes) {
    console.error(Text::TapeTooLong, {std::to_string(tape.rows.size())});
    return ExitCode::WrongUsage;
  }
  return write_result(output, *bytes, console);
}

ExitCode write_program(const std::string& output, const DecodedTape& decoded,
                       const Settings& settings, const Console& console) {
  return write_result(output, with_line_ends(decoded.text, settings.dialect.line_end), console);
}

void tell_length(const std::string& name, const Tape& tape, const DecodedTape& decoded,
                 const Console& console) {
  console.note(Text::TapeRead,
               {name, std::to_string(tape.rows.size()), millimetres_to(tape.rows.size()),
                std::to_string(decoded.program_begin + 1), std::to_string(decoded.program_end),
                decoded.header.empty() ? "" : "; \"" + decoded.header + "\""});
}

void add_tape(CLI::App& app, Job& job) {
  CLI::App* tape = add_verb(
      app, job, "tape", "Paper tape, real or as a file",
      "Punches and reads ISO-7 tape, on devices and in files. `dgt tape VERB --help` tells about a "
      "verb.");
  tape->require_subcommand(1);
  add_tape_images(*tape, job);
  add_tape_devices(*tape, job);
  add_tape_simulate(*tape, job);
}

}  // namespace dgt::cli
