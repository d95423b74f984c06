// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/run.h"

#include <algorithm>
#include <cmath>
#include <thread>

namespace dgt {
namespace {

using Kind = DeviceFault::Kind;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Wait kGlance{50};  // how long nobody looks whether the person wants to stop
constexpr std::uint32_t kAheadPerSecond = 50;  // a fiftieth of a second may be handed over early

double seconds_since(Clock::time_point then) { return Seconds(Clock::now() - then).count(); }

/// Watches whether a device keeps its speed. One pause of the computer spoils one window only.
class RateWatch {
 public:
  explicit RateWatch(std::uint32_t speed) : speed_(speed) {}

  /// The rate, when the device has been too slow for several windows.
  std::optional<double> add(std::size_t rows) {
    rows_ += rows;
    const double seconds = seconds_since(begin_);
    // Handshakes let rows through in bursts; a window is longer than those.
    if (rows_ < kWindowRows || seconds < kWindowSeconds) return std::nullopt;
    const double rate = static_cast<double>(rows_) / seconds;
    slow_ = rate < kSlowShare * speed_ ? slow_ + 1 : 0;
    rows_ = 0;
    begin_ = Clock::now();
    return slow_ >= kSlowWindows ? std::optional(rate) : std::nullopt;
  }

 private:
  std::uint32_t speed_;
  Clock::time_point begin_ = Clock::now();
  std::size_t rows_ = 0;
  int slow_ = 0;
};

class PunchRun {
 public:
  PunchRun(Punch& punch, std::span<const Row> rows, const PunchSettings& settings,
           const Watch& watch)
      : punch_(punch),
        rows_(rows),
        settings_(settings),
        watch_(watch),
        ahead_(std::max<std::size_t>(1, settings.speed / kAheadPerSecond)),
        rate_(settings.speed) {}

  tl::expected<void, PunchFailure> run() {
    while (done_ < rows_.size()) {
      if (watch_.cancelled()) return failed({Kind::Cancelled, settings_.device});
      const std::size_t allowed = allowed_now();
      if (allowed == done_) {
        std::this_thread::sleep_for(std::min<Seconds>(kGlance, Seconds(0.5 * ahead_seconds())));
        continue;
      }
      if (auto moved = put(allowed); !moved) return moved;
    }
    return finish();
  }

 private:
  [[nodiscard]] double ahead_seconds() const {
    return static_cast<double>(ahead_) / settings_.speed;
  }
  [[nodiscard]] std::size_t allowed_now() const {
    if (!punch_.has_pace()) return rows_.size();
    const double due = seconds_since(since_) * settings_.speed;
    return std::min(rows_.size(), from_ + ahead_ + static_cast<std::size_t>(due));
  }

  tl::expected<void, PunchFailure> put(std::size_t allowed) {
    const auto taken = punch_.put(rows_.subspan(done_, allowed - done_), kGlance);
    if (!taken) return failed(taken.error());
    done_ += *taken;
    if (done_ < allowed) {  // it was stopped: no catching up afterwards
      from_ = done_;
      since_ = Clock::now();
    }
    if (*taken == 0) {
      if (seconds_since(last_) > Seconds(settings_.timeout).count()) {
        return failed({Kind::Stalled, settings_.device});
      }
      return {};
    }
    last_ = Clock::now();
    watch_.progress(done_);
    if (const auto rate = rate_.add(*taken); rate && punch_.has_pace()) {
      return failed({Kind::Slow, settings_.device, 0, 0, *rate});
    }
    return {};
  }

  tl::expected<void, PunchFailure> finish() {
    last_ = Clock::now();
    for (;;) {
      const auto finished = punch_.finish(kGlance);
      if (!finished) return failed(finished.error());
      if (*finished) return {};
      if (watch_.cancelled()) return failed({Kind::Cancelled, settings_.device});
      if (seconds_since(last_) > Seconds(settings_.timeout).count()) {
        return failed({Kind::Stalled, settings_.device});
      }
    }
  }

  tl::unexpected<PunchFailure> failed(DeviceFault fault) const {
    fault.row = done_;
    const std::size_t unsure = ahead_ + settings_.buffer;
    const bool has_tape = punch_.has_pace();  // a file is whole or not there
    return tl::unexpected(
        PunchFailure{std::move(fault), has_tape && done_ > unsure ? done_ - unsure : 0});
  }

  Punch& punch_;
  std::span<const Row> rows_;
  const PunchSettings& settings_;
  const Watch& watch_;
  std::size_t ahead_;  // rows that may be handed over before they are due
  RateWatch rate_;
  std::size_t done_ = 0;
  std::size_t from_ = 0;  // so many rows were done at `since_`
  Clock::time_point since_ = Clock::now();
  Clock::time_point last_ = Clock::now();  // when a row was taken
};

class ReadRun {
 public:
  ReadRun(Reader& reader, const ReaderSettings& settings, const TapeFormat& format,
          const Watch& watch)
      : reader_(reader),
        settings_(settings),
        end_rows_(std::min(kEndRows, rows_in(format.trailer))),
        watch_(watch),
        rate_(settings.speed) {}

  TapeReading run() {
    if (const auto started = reader_.start(); !started) {
      fail(started.error());
      return std::move(made_);
    }
    while (!ended_ && !made_.fault) step();
    reader_.stop();
    return std::move(made_);
  }

 private:
  void step() {
    if (watch_.cancelled()) return fail({Kind::Cancelled, settings_.device});
    const auto reading = reader_.take(kGlance);
    if (!reading) return fail(reading.error());
    if (reading->ended) return end();
    if (reading->rows.empty() && reading->noise.empty()) {
      if (seconds_since(last_) > Seconds(settings_.timeout).count()) end();
      return;
    }
    if (rows().empty()) rate_ = RateWatch(settings_.speed);  // it may start when it likes
    last_ = Clock::now();
    append(*reading);
    watch_.progress(rows().size());
    judge(reading->rows);
  }

  void append(const Reading& reading) {
    for (const std::size_t at : reading.noise) {
      made_.tape.gaps.push_back({rows().size() + at, "break or bad framing on the line"});
    }
    made_.tape.rows.insert(rows().end(), reading.rows.begin(), reading.rows.end());
  }

  void judge(const std::vector<Row>& more) {
    if (rows().size() > kMostRows) return fail({Kind::TooLong, settings_.device});
    for (const Row row : more) rub_outs_ = row == kRubOut ? rub_outs_ + 1 : 0;
    const auto rate = rate_.add(more.size());
    if (!reader_.has_pace()) return;
    if (rub_outs_ >= kTornRows) {
      made_.tape.rows.resize(rows().size() - rub_outs_);  // light, not rows
      std::erase_if(made_.tape.gaps, [&](const Gap& gap) { return gap.row > rows().size(); });
      return fail({Kind::Torn, settings_.device});
    }
    if (rate) fail({Kind::Slow, settings_.device, 0, 0, *rate});
  }

  /// No more rows come.
  void end() {
    ended_ = true;
    if (!reader_.has_pace()) return;
    if (rows().empty()) return fail({Kind::NoRows, settings_.device});
    if (!is_end_of_tape()) fail({Kind::Silent, settings_.device});
  }
  [[nodiscard]] bool is_end_of_tape() {
    const auto last =
        std::find_if(rows().rbegin(), rows().rend(), [](Row row) { return row != kBlankRow; });
    const auto blank = static_cast<std::size_t>(last - rows().rbegin());
    if (last == rows().rend()) return false;  // a leader and no program
    return blank >= end_rows_ && (end_rows_ > 0 || *last == kLineFeed || *last == kCarriageReturn);
  }

  void fail(DeviceFault fault) {
    fault.row = rows().size();
    made_.fault = std::move(fault);
  }
  std::vector<Row>& rows() { return made_.tape.rows; }

  Reader& reader_;
  const ReaderSettings& settings_;
  std::size_t end_rows_;  // blank rows at the end of a whole tape
  const Watch& watch_;
  RateWatch rate_;
  TapeReading made_;
  bool ended_ = false;
  std::size_t rub_outs_ = 0;  // at the end of what has come
  Clock::time_point last_ = Clock::now();
};

}  // namespace

tl::expected<void, PunchFailure> punch_tape(Punch& punch, std::span<const Row> rows,
                                            const PunchSettings& settings, const Watch& watch) {
  return PunchRun(punch, rows, settings, watch).run();
}

TapeReading read_tape(Reader& reader, const ReaderSettings& settings, const TapeFormat& format,
                      const Watch& watch) {
  return ReadRun(reader, settings, format, watch).run();
}

}  // namespace dgt
