// SPDX-License-Identifier: GPL-3.0-or-later
//
// dgt tape punch, read, duplicate: tapes on devices. What goes wrong with a device, or with the
// tape in it, ends in exit code 3.
#include <unistd.h>

#include <iostream>

#include "apps/cli/tape.h"
#include "apps/cli/tape_faults.h"
#include "apps/cli/tape_watch.h"
#include "apps/driver/tape_jobs.h"
#include "device/join.h"

namespace dgt::cli {
namespace {

struct DeviceOptions : TapeOptions {
  std::string punch;   ///< empty: the settings name it
  std::string reader;  ///< the same
  std::size_t from_row = 1;
  bool verify = false;
  std::string resume;
};

Step<PunchSettings> punch_for(const std::string& option, const char* name, const Settings& settings,
                              const Console& console) {
  PunchSettings punch = settings.tape.punch;
  if (!option.empty()) punch.device = option;
  if (!punch.device.empty()) return punch;
  console.error(Text::NoPunch, {name});
  return tl::unexpected(ExitCode::WrongUsage);
}

Step<ReaderSettings> reader_for(const std::string& option, const char* name,
                                const Settings& settings, const Console& console) {
  ReaderSettings reader = settings.tape.reader;
  if (!option.empty()) reader.device = option;
  if (!reader.device.empty()) return reader;
  console.error(Text::NoReader, {name});
  return tl::unexpected(ExitCode::WrongUsage);
}

// --- reading ------------------------------------------------------------------------------------

TapeReading read_device(const ReaderSettings& settings, const TapeFormat& format,
                        const Console& console) {
  Progress progress(settings.device, 0, console);
  return read_from(settings, format, progress.watch());
}

/// Nothing that was read is lost.
ExitCode keep_part(const Tape& tape, const std::string& output, const Console& console) {
  if (tape.rows.empty()) return ExitCode::Failure;
  const std::string name = free_part_name(output);
  const auto written = write_file(name, to_picture(tape));
  if (!written) return report(written.error(), console);
  console.note(Text::PartKept, {std::to_string(tape.rows.size()), name});
  return ExitCode::Failure;
}

Step<Tape> joined_with(const std::string& part, const Tape& again, const Console& console) {
  const auto kept = load_image(part, console);
  if (!kept) return tl::unexpected(kept.error());
  auto joined = join_readings(*kept, again);
  if (joined) return *std::move(joined);
  console.error(joined.error() == JoinFault::NoOverlap ? Text::JoinNoOverlap : Text::JoinAmbiguous,
                {part});
  return tl::unexpected(ExitCode::Failure);
}

/// One reading, after a resumed part if there is one; what fails is kept as far as it goes.
Step<Tape> read_whole(const ReaderSettings& settings, const TapeFormat& format,
                      const DeviceOptions& options, const Console& console) {
  TapeReading reading = read_device(settings, format, console);
  if (reading.fault) {
    const std::string why = sentence_of(*reading.fault, limits_of(settings), console.language());
    console.error(Text::FileFailed, {why});
    reading.tape.gaps.push_back({reading.tape.rows.size(), why});
  }
  if (!options.resume.empty() && !reading.tape.rows.empty()) {
    auto joined = joined_with(options.resume, reading.tape, console);
    if (joined) reading.tape = *std::move(joined);
    if (!joined && !reading.fault)
      return tl::unexpected(keep_part(reading.tape, options.output, console));
  }
  if (reading.fault) return tl::unexpected(keep_part(reading.tape, options.output, console));
  return std::move(reading.tape);
}

/// Reads once more and tells what is different.
bool reads_the_same(const ReaderSettings& settings, const TapeFormat& format, const Tape& tape,
                    const Console& console) {
  const TapeReading again = read_device(settings, format, console);
  if (again.fault) {
    (void)report(*again.fault, limits_of(settings), console);
    return false;
  }
  const TapeProgram program = read_program(settings.device, again.tape, format);
  const DiagnosticBag bag = compare(tape.rows, again.tape, 0, program, format);
  console.show(program.bag, {program.file});
  console.show(bag, {program.file});
  return !bag.has_errors() && again.tape.gaps.empty();
}

/// A sound tape from the reader, read twice when asked for.
struct SoundTape {
  Tape tape;
  TapeProgram program;
};
Step<SoundTape> read_sound(const ReaderSettings& settings, const TapeFormat& format,
                           const DeviceOptions& options, const Console& console, bool twice) {
  auto tape = read_whole(settings, format, options, console);
  if (!tape) return tl::unexpected(tape.error());
  TapeProgram program = read_program(settings.device, *tape, format);
  console.show(program.bag, {program.file});
  if (program.decoded.is_damaged()) {
    return tl::unexpected(keep_part(*tape, options.output, console));
  }
  if (twice && !reads_the_same(settings, format, *tape, console)) {
    console.error(Text::ReadDifferently, {settings.device});
    return tl::unexpected(keep_part(*tape, options.output, console));
  }
  return SoundTape{*std::move(tape), std::move(program)};
}

ExitCode read(const DeviceOptions& options, const Console& console) {
  const auto settings = settle(options.source, console);
  if (!settings) return settings.error();
  const auto reader = reader_for(options.reader, "device", *settings, console);
  if (!reader) return reader.error();
  const Interrupts interrupts;
  const auto sound = read_sound(*reader, settings->tape.format, options, console, options.verify);
  if (!sound) return sound.error();
  const TapeForm form =
      options.form.value_or(tape_form_of(options.output).value_or(TapeForm::Text));
  const DecodedTape& decoded = sound->program.decoded;
  const ExitCode code = form == TapeForm::Text
                            ? write_program(options.output, decoded, *settings, console)
                            : write_tape(options.output, sound->tape, form, {}, console);
  if (code == ExitCode::Done) tell_length(reader->device, sound->tape, decoded, console);
  return code;
}

// --- punching -----------------------------------------------------------------------------------

/// `failure` speaks of rows of the whole tape; those before `from` are on another piece.
void tell_how_to_go_on(std::span<const Row> rows, const PunchFailure& failure, std::size_t from,
                       const TapeFormat& format, const Console& console) {
  const auto whole = whole_blocks(rows, failure, from, format);
  if (!whole) {
    console.note(Text::PunchBeginsAnew, {});
    return;
  }
  console.note(Text::PunchGoesOn, {std::to_string(whole->rows), millimetres_to(whole->rows),
                                   std::to_string(whole->lines), std::to_string(whole->rows + 1)});
}

Step<void> punch_rows(const PunchSettings& settings, const std::vector<Row>& rows,
                      const TapeFormat& format, std::size_t from, const Console& console) {
  tl::expected<void, PunchFailure> done;
  {
    Progress progress(settings.device, rest_of(rows, from, format).size(), console);
    done = punch_from(settings, rows, from, format, progress.watch());
  }
  if (done) return {};
  const DeviceFault& fault = done.error().fault;
  (void)report(fault, limits_of(settings), console);
  using Kind = DeviceFault::Kind;
  const bool has_begun = fault.kind != Kind::CannotOpen && fault.kind != Kind::CannotSetUp;
  if (has_begun) tell_how_to_go_on(rows, done.error(), from, format, console);
  return tl::unexpected(ExitCode::Failure);
}

/// Where a person stands beside, the tape is carried from the punch to the reader first.
void wait_for_person(const std::string& reader, const Console& console) {
  if (::isatty(STDIN_FILENO) != 1 || console.is_quiet()) return;
  console.note(Text::PutTapeIn, {reader});
  std::string line;
  std::getline(std::cin, line);
}

Step<void> read_back(const ReaderSettings& reader, const PunchSettings& punch,
                     const std::vector<Row>& rows, const TapeFormat& format,
                     const Console& console) {
  wait_for_person(reader.device, console);
  if (reads_the_same(reader, format, {rows, {}}, console)) return {};
  console.error(Text::PunchedWrongly, {punch.device});
  return tl::unexpected(ExitCode::Failure);
}

ExitCode punch_and_verify(const std::vector<Row>& rows, const PunchSettings& punch,
                          const std::optional<ReaderSettings>& reader, const TapeFormat& format,
                          std::size_t from, const Console& console) {
  if (const auto done = punch_rows(punch, rows, format, from, console); !done) return done.error();
  if (reader) {
    const auto same = read_back(*reader, punch, rest_of(rows, from, format), format, console);
    if (!same) return same.error();
  }
  console.note(Text::TapeLength,
               {punch.device, std::to_string(rows.size()), millimetres_to(rows.size())});
  return ExitCode::Done;
}

/// The rows of a tape file that are sound.
Step<std::vector<Row>> load_sound(const DeviceOptions& options, const TapeFormat& format,
                                  const Console& console) {
  auto loaded = load_tape(options.file, options, format, console);
  if (!loaded) return tl::unexpected(loaded.error());
  if (!loaded->is_program) {
    const TapeProgram program = read_program(options.file, loaded->tape, format);
    console.show(program.bag, {program.file});
    if (program.decoded.is_damaged()) return tl::unexpected(ExitCode::InputErrors);
  }
  return std::move(loaded->tape.rows);
}

Step<std::optional<ReaderSettings>> verifier(const DeviceOptions& options, const Settings& settings,
                                             const Console& console) {
  if (!options.verify) return std::optional<ReaderSettings>();
  auto reader = reader_for(options.reader, "reader", settings, console);
  if (!reader) return tl::unexpected(reader.error());
  return std::optional(*std::move(reader));
}

ExitCode punch(const DeviceOptions& options, const Console& console) {
  const auto settings = settle(options.source, console);
  if (!settings) return settings.error();
  const auto format = format_for(options, *settings, console);
  if (!format) return format.error();
  const auto device = punch_for(options.punch, "device", *settings, console);
  if (!device) return device.error();
  const auto reader = verifier(options, *settings, console);
  if (!reader) return reader.error();
  const auto rows = load_sound(options, *format, console);
  if (!rows) return rows.error();
  if (options.from_row < 1 || options.from_row > rows->size()) {
    console.error(Text::BadFromRow,
                  {std::to_string(options.from_row), std::to_string(rows->size())});
    return ExitCode::WrongUsage;
  }
  const Interrupts interrupts;
  return punch_and_verify(*rows, *device, *reader, *format, options.from_row - 1, console);
}

// --- duplicating --------------------------------------------------------------------------------

ExitCode duplicate(const DeviceOptions& options, const Console& console) {
  const auto settings = settle(options.source, console);
  if (!settings) return settings.error();
  const TapeFormat& format = settings->tape.format;
  const auto reader = reader_for(options.reader, "reader", *settings, console);
  if (!reader) return reader.error();
  const auto device = punch_for(options.punch, "punch", *settings, console);
  if (!device) return device.error();
  const Interrupts interrupts;
  const auto sound = read_sound(*reader, format, options, console, false);
  if (!sound) return sound.error();
  tell_length(reader->device, sound->tape, sound->program.decoded, console);
  const auto back = options.verify ? std::optional(*reader) : std::nullopt;
  return punch_and_verify(sound->tape.rows, *device, back, format, 0, console);
}

CLI::Option* add_device(CLI::App& verb, const char* name, std::string& device,
                        const std::string& what) {
  return verb.add_option(name, device, what)->option_text("DEVICE");
}

}  // namespace

void add_tape_devices(CLI::App& tape, Job& job) {
  const auto punched = std::make_shared<DeviceOptions>();
  CLI::App* verb = add_verb(
      tape, job, "punch", "Punches a program or a tape file",
      "Nothing moves before every character can be punched. Ctrl-C stops between rows. A punch "
      "that "
      "fails is told with the last whole block that is surely on the tape, from which --from-row "
      "goes on.");
  add_tape_file(*verb, *punched, "The program, or a tape (.tap or picture)");
  add_device(*verb, "-d,--device", punched->punch,
             "The punch: a serial line, a character device, a file (default: punch.device)");
  verb->add_option("--from-row", punched->from_row,
                   "Go on at this row of the whole tape, behind blank tape to be spliced")
      ->option_text("ROW");
  verb->add_flag("--verify", punched->verify,
                 "Read the tape back and compare every row; a person is asked to put it in");
  add_device(*verb, "--reader", punched->reader,
             "The reader for --verify (default: reader.device)");
  add_tape_header(*verb, *punched);
  add_tape_settings(*verb, *punched);
  set_job<DeviceOptions>(verb, job, punched, punch);

  const auto got = std::make_shared<DeviceOptions>();
  verb = add_verb(tape, job, "read", "Reads a tape",
                  "Reads until the tape has run through and checks it. A tape that is damaged or "
                  "cannot be read to its end is not written under the name asked for: what was "
                  "read is kept as a picture with its gaps marked, OUT.part.txt.");
  add_device(*verb, "-d,--device", got->reader,
             "The reader: a serial line, a character device, a file (default: reader.device)");
  add_tape_output(*verb, *got, "What was read: .tap rows, .txt picture, else the program");
  verb->add_flag("--verify", got->verify, "Read the tape twice and compare every row");
  verb->add_option("--resume", got->resume,
                   "Go on with what an earlier reading has kept; the tape begins anywhere before "
                   "its last gap")
      ->option_text("PART");
  add_tape_settings(*verb, *got);
  set_job<DeviceOptions>(verb, job, got, read);

  const auto copied = std::make_shared<DeviceOptions>();
  verb = add_verb(tape, job, "duplicate", "Copies a tape",
                  "Reads a tape, checks it, and punches it row by row as it is.");
  add_device(*verb, "--reader", copied->reader,
             "The reader, or a tape file (default: reader.device)");
  add_device(*verb, "--punch", copied->punch, "The punch, or a file (default: punch.device)");
  verb->add_flag("--verify", copied->verify, "Read the copy back and compare every row");
  add_tape_settings(*verb, *copied);
  set_job<DeviceOptions>(verb, job, copied, duplicate);
}

}  // namespace dgt::cli
