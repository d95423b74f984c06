// SPDX-License-Identifier: GPL-3.0-or-later
//
// dgt tape simulate: a punch and a reader that are not there.
#include <chrono>
#include <cstdio>

#include "apps/cli/tape.h"
#include "apps/cli/tape_faults.h"
#include "apps/cli/tape_watch.h"
#include "device/simulator.h"

namespace dgt::cli {
namespace {

struct SimulateOptions : TapeOptions {
  std::string punched;
  std::vector<std::string> reader_faults;
  std::vector<std::string> punch_faults;
  bool loop = false;
  double seconds = 0;
};

Step<std::vector<SimulatedFault>> parse_faults(const std::vector<std::string>& texts,
                                               const Console& console) {
  std::vector<SimulatedFault> faults;
  for (const std::string& text : texts) {
    const auto fault = parse_simulated_fault(text);
    if (!fault) {
      console.error(Text::BadSimulatedFault, {text});
      return tl::unexpected(ExitCode::WrongUsage);
    }
    faults.push_back(*fault);
  }
  return faults;
}

Step<SimulatorSettings> simulator_for(const SimulateOptions& options, const Console& console) {
  const auto settings = settle(options.source, console);
  if (!settings) return tl::unexpected(settings.error());
  SimulatorSettings simulator;
  simulator.loop = options.loop;
  simulator.reader_speed = settings->tape.reader.speed;
  simulator.punch_speed = settings->tape.punch.speed;
  const auto reader_faults = parse_faults(options.reader_faults, console);
  if (!reader_faults) return tl::unexpected(reader_faults.error());
  const auto punch_faults = parse_faults(options.punch_faults, console);
  if (!punch_faults) return tl::unexpected(punch_faults.error());
  simulator.reader_faults = *reader_faults;
  simulator.punch_faults = *punch_faults;
  if (options.file.empty()) return simulator;
  const auto format = format_for(options, *settings, console);
  if (!format) return tl::unexpected(format.error());
  auto loaded = load_tape(options.file, options, *format, console);
  if (!loaded) return tl::unexpected(loaded.error());
  simulator.tape = std::move(loaded->tape.rows);
  return simulator;
}

ExitCode run(const SimulateOptions& options, const Console& console) {
  auto settings = simulator_for(options, console);
  if (!settings) return settings.error();
  ExitCode code = ExitCode::Done;
  settings->on_punched = [&](const std::vector<Row>& rows) {
    const std::string name = options.punched.empty() ? "-" : options.punched;
    console.note(Text::TapeLength,
                 {name, std::to_string(rows.size()), millimetres_to(rows.size())});
    if (options.punched.empty()) return;
    const auto written = write_tape(options.punched, {rows, {}}, TapeForm::Raw, {}, console);
    if (written != ExitCode::Done) code = written;
  };
  const Interrupts interrupts;
  const auto simulator = Simulator::open(*std::move(settings));
  if (!simulator) return report(simulator.error(), {}, console);
  // Before anything else: a script reads the names from here.
  std::printf("punch %s\nreader %s\n", (*simulator)->punch_name().c_str(),
              (*simulator)->reader_name().c_str());
  std::fflush(stdout);
  const auto begin = std::chrono::steady_clock::now();
  (*simulator)->run([&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    return Interrupts::arrived() || code != ExitCode::Done ||
           (options.seconds > 0 && passed.count() > options.seconds);
  });
  return code;
}

}  // namespace

void add_tape_simulate(CLI::App& tape, Job& job) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* verb = add_verb(
      tape, job, "simulate", "A punch and a reader that are not there",
      "Opens two pseudo-terminals, writes their names to standard output (`punch …`, `reader …`) "
      "and works as a punch and a reader with XON/XOFF until it is stopped. A fault happens once, "
      "on the first tape: flip@ROW:TRACK, drop@ROW, double@ROW, break@ROW, slow@ROW, hang@ROW, "
      "power@ROW.\n\nExample:\n"
      "  dgt tape simulate part.tap --reader-fault flip@300:2");
  verb->add_option("FILE", options->file, "The tape in the reader, or a program (default: none)")
      ->option_text(" ");
  verb->add_option("--punched", options->punched,
                   "Where a punched tape goes when the computer has closed the line; the next one "
                   "replaces it")
      ->option_text("FILE");
  verb->add_flag("--loop", options->loop, "What has been punched lies in the reader next");
  verb->add_option("--reader-fault", options->reader_faults,
                   "A fault of the reader; may be given again")
      ->option_text("FAULT")
      ->allow_extra_args(false);
  verb->add_option("--punch-fault", options->punch_faults,
                   "A fault of the punch; may be given again")
      ->option_text("FAULT")
      ->allow_extra_args(false);
  verb->add_option("--seconds", options->seconds, "Stop after so long (default: never)")
      ->option_text("S")
      ->check(CLI::PositiveNumber.description(""));
  add_tape_settings(*verb, *options);
  set_job<SimulateOptions>(verb, job, options, run);
}

}  // namespace dgt::cli
