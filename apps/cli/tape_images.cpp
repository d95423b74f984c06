// SPDX-License-Identifier: GPL-3.0-or-later
//
// dgt tape encode, decode, show, verify: tapes as files.
#include <charconv>

#include "apps/cli/tape.h"

namespace dgt::cli {
namespace {

struct ImageOptions : TapeOptions {
  std::string rows;
  std::string against;
  bool salvage = false;
};

constexpr const char* kTapeForms = "raw, picture, svg, png";

/// By --form, the extension of the output, or `otherwise`.
TapeForm form_of(const TapeOptions& options, TapeForm otherwise) {
  return options.form.value_or(tape_form_of(options.output).value_or(otherwise));
}

ExitCode refuse_text(const Console& console) {
  console.error(Text::TapeHasNoText, {"text", kTapeForms});
  return ExitCode::WrongUsage;
}

// --- encode -------------------------------------------------------------------------------------

ExitCode encode(const ImageOptions& options, const Console& console) {
  const auto settings = settle(options.source, console);
  if (!settings) return settings.error();
  const auto format = format_for(options, *settings, console);
  if (!format) return format.error();
  const TapeForm form = form_of(options, TapeForm::Raw);
  if (form == TapeForm::Text) return refuse_text(console);
  const auto loaded = load_tape(options.file, options, *format, console);
  if (!loaded) return loaded.error();
  const std::size_t rows = loaded->tape.rows.size();
  const ExitCode code = write_tape(options.output, loaded->tape, form, {}, console);
  if (code == ExitCode::Done) {
    console.note(Text::TapeLength, {options.file, std::to_string(rows), millimetres_to(rows)});
  }
  return code;
}

// --- decode -------------------------------------------------------------------------------------

ExitCode decode(const ImageOptions& options, const Console& console) {
  const auto settings = settle(options.source, console);
  if (!settings) return settings.error();
  const auto tape = load_image(options.file, console);
  if (!tape) return tape.error();
  const TapeProgram program = read_program(options.file, *tape, settings->tape.format);
  console.show(program.bag, {program.file});
  const DecodedTape& decoded = program.decoded;
  if (!decoded.is_damaged()) {
    const ExitCode code = write_program(options.output, decoded, *settings, console);
    if (code == ExitCode::Done) tell_length(options.file, *tape, decoded, console);
    return code;
  }
  const std::string count = std::to_string(decoded.damage_count);
  if (!options.salvage) {
    console.error(Text::TapeDamaged, {options.file, count});
    return ExitCode::InputErrors;
  }
  const ExitCode code = write_program(options.output, decoded, *settings, console);
  if (code != ExitCode::Done) return code;
  console.error(Text::TapeSalvaged, {options.file, count});
  return ExitCode::InputErrors;
}

// --- show ---------------------------------------------------------------------------------------

/// `12-345`, `12-`, `12`: rows from 1, both included.
std::optional<RowRange> parse_rows(std::string_view text) {
  RowRange rows;
  if (text.empty()) return rows;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, rows.first);
  if (first.ec != std::errc() || rows.first == 0) return std::nullopt;
  --rows.first;
  rows.last = rows.first + 1;
  if (first.ptr == end) return rows;
  if (*first.ptr != '-') return std::nullopt;
  rows.last = RowRange{}.last;
  if (first.ptr + 1 == end) return rows;
  const auto last = std::from_chars(first.ptr + 1, end, rows.last);
  if (last.ec != std::errc() || last.ptr != end || rows.last <= rows.first) return std::nullopt;
  return rows;
}

ExitCode show(const ImageOptions& options, const Console& console) {
  const auto rows = parse_rows(options.rows);
  if (!rows) {
    console.error(Text::BadRows, {options.rows});
    return ExitCode::WrongUsage;
  }
  const TapeForm form = form_of(options, TapeForm::Picture);
  if (form == TapeForm::Text) return refuse_text(console);
  const auto tape = load_image(options.file, console);
  if (!tape) return tape.error();
  return write_tape(options.output, *tape, form, *rows, console);
}

// --- verify -------------------------------------------------------------------------------------

ExitCode compare_with(const LoadedTape& wanted, const Tape& tape, const TapeProgram& program,
                      const ImageOptions& options, const TapeFormat& format,
                      const Console& console) {
  // A program says nothing about what stands before it on the tape.
  const std::size_t from = wanted.is_program ? program.decoded.program_begin : 0;
  const std::size_t wanted_from =
      wanted.is_program ? decode_tape(wanted.tape, format).program_begin : 0;
  const auto rows = std::span<const Row>(wanted.tape.rows).subspan(wanted_from);
  const DiagnosticBag bag = compare(rows, tape, from, program, format);
  console.show(bag, {program.file});
  if (bag.has_errors()) {
    console.error(Text::TapesDiffer, {options.file, options.against});
    return ExitCode::NotVerified;
  }
  console.note(Text::TapesAgree, {options.file, options.against});
  return ExitCode::Done;
}

ExitCode verify(const ImageOptions& options, const Console& console) {
  const auto settings = settle(options.source, console);
  if (!settings) return settings.error();
  const TapeFormat& format = settings->tape.format;
  const auto tape = load_image(options.file, console);
  if (!tape) return tape.error();
  const TapeProgram program = read_program(options.file, *tape, format);
  console.show(program.bag, {program.file});
  tell_length(options.file, *tape, program.decoded, console);
  const ExitCode sound = program.decoded.is_damaged() ? ExitCode::InputErrors : ExitCode::Done;
  if (options.against.empty()) return sound;
  const auto wanted = load_tape(options.against, options, format, console);
  if (!wanted) return wanted.error();
  const ExitCode same = compare_with(*wanted, *tape, program, options, format, console);
  return sound == ExitCode::Done ? same : sound;
}

}  // namespace

void add_tape_images(CLI::App& tape, Job& job) {
  const auto encoded = std::make_shared<ImageOptions>();
  CLI::App* verb = add_verb(
      tape, job, "encode", "A program onto tape, as a file",
      "Writes the tape of a program: leader, %, the program in ISO-7 with even parity, trailer, as "
      "the settings tape.* say. Characters that the code lacks are errors, unless the settings "
      "leave them out or transliterate them.");
  add_tape_file(*verb, *encoded, "The program, in any encoding, or a tape");
  add_tape_output(*verb, *encoded, "The tape: .tap rows, .txt picture, .svg or .png drawing");
  add_tape_header(*verb, *encoded);
  add_tape_settings(*verb, *encoded);
  set_job<ImageOptions>(verb, job, encoded, encode);

  const auto decoded = std::make_shared<ImageOptions>();
  verb = add_verb(tape, job, "decode", "The program that is on a tape file",
                  "Reads rows or a picture of them and writes the program. Every damaged row is "
                  "told with its number and its distance from the start; then nothing is written.");
  add_tape_file(*verb, *decoded, "The tape: rows (.tap) or a picture in letters");
  verb->add_option("-o,--output", decoded->output,
                   "The program; written whole or not at all (default: -, standard output)")
      ->option_text("OUT");
  verb->add_flag("--salvage", decoded->salvage,
                 "Write the program of a damaged tape too, U+FFFD for each damaged row; the exit "
                 "code is 1 all the same");
  add_tape_settings(*verb, *decoded);
  set_job<ImageOptions>(verb, job, decoded, decode);

  const auto shown = std::make_shared<ImageOptions>();
  verb = add_verb(tape, job, "show", "A tape as a picture",
                  "Shows the holes of a tape in letters, or draws them true to ISO 1154, whether "
                  "or not the tape is sound.");
  add_tape_file(*verb, *shown, "The tape");
  add_tape_output(*verb, *shown, "The picture: .txt letters, .svg or .png drawing, .tap rows");
  verb->add_option("--rows", shown->rows, "Only these rows, from 1 (default: all)")
      ->option_text("FIRST-LAST");
  set_job<ImageOptions>(verb, job, shown, show);

  const auto verified = std::make_shared<ImageOptions>();
  verb = add_verb(tape, job, "verify", "Whether a tape is sound, and is what it should be",
                  "Tells every fault of a tape. With --against each row is compared, so that two "
                  "flipped holes in one row are found too. Exit code 1 for a damaged tape, 4 for a "
                  "sound one that is another.");
  add_tape_file(*verb, *verified, "The tape");
  verb->add_option("--against", verified->against,
                   "A tape, compared row by row, or a program, compared from the % on")
      ->option_text("FILE");
  add_tape_settings(*verb, *verified);
  set_job<ImageOptions>(verb, job, verified, verify);
}

}  // namespace dgt::cli
