// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each device has a mechanism, which moves a row when its time has come, and a side towards the
// line, which goes on while the mechanism hangs.
#include "device/simulator.h"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <deque>
#include <span>
#include <utility>

#include "device/descriptor.h"

namespace dgt {
namespace {

using Kind = SimulatedFault::Kind;
using Clock = std::chrono::steady_clock;

constexpr std::uint8_t kXon = 0x11;
constexpr std::uint8_t kXoff = 0x13;
constexpr int kTick = 2;                 // ms
constexpr std::size_t kMostBytes = 256;  // taken from a line at once
/// A start so long after the end of the tape is a new reading; earlier it is the computer's queue,
/// which was full and is empty again.
constexpr std::chrono::milliseconds kAtRest{200};
// Rows in the punch's buffer when it stops the computer and when it lets it go on. What the line
// still brings is taken: on a pseudo-terminal that may be more than on a wire.
constexpr std::size_t kFull = 24;
constexpr std::size_t kEmpty = 8;
constexpr std::array<std::pair<std::string_view, Kind>, 7> kNames = {{{"flip", Kind::Flip},
                                                                      {"drop", Kind::Drop},
                                                                      {"double", Kind::Double},
                                                                      {"break", Kind::Break},
                                                                      {"slow", Kind::Slow},
                                                                      {"hang", Kind::Hang},
                                                                      {"power", Kind::PowerCut}}};

/// One end of a pair of pseudo-terminals; the computer opens the other by its name.
class Line {
 public:
  [[nodiscard]] static DeviceResult<Line> open() {
    Line line;
    line.master_ = Descriptor(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    std::array<char, 128> name{};
    if (!line.master_.is_open() || ::grantpt(line.master_.number()) != 0 ||
        ::unlockpt(line.master_.number()) != 0 ||
        ::ptsname_r(line.master_.number(), name.data(), name.size()) != 0) {
      return tl::unexpected(DeviceFault{DeviceFault::Kind::CannotOpen, "/dev/ptmx", errno});
    }
    line.name_ = name.data();
    return line;
  }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool is_alive() const { return master_.is_open(); }
  [[nodiscard]] int number() const { return master_.number(); }
  void cut() { master_.close(); }

  /// What has come, at most so much.
  [[nodiscard]] std::vector<std::uint8_t> read(std::size_t most) {
    std::vector<std::uint8_t> bytes(most);
    const ssize_t got = is_alive() && most > 0 ? ::read(number(), bytes.data(), most) : -1;
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return bytes;
  }
  /// Whether the computer has closed its end, after it had opened it.
  [[nodiscard]] bool is_closed() const {
    pollfd polled{number(), 0, 0};
    return is_alive() && ::poll(&polled, 1, 0) == 1 && (polled.revents & POLLHUP) != 0;
  }
  [[nodiscard]] bool write(std::uint8_t byte) {
    return is_alive() && ::write(number(), &byte, 1) == 1;
  }

 private:
  Descriptor master_;
  std::string name_;
};

/// How many rows the mechanism may move by now.
class Drive {
 public:
  explicit Drive(std::uint32_t speed) : speed_(speed) {}
  void restart() { since_ = Clock::now(), moved_ = 0; }
  void slow_down() {
    share_ = kSlowedDown;
    restart();
  }
  [[nodiscard]] bool is_due() const {
    const std::chrono::duration<double> passed = Clock::now() - since_;
    return static_cast<double>(moved_) < passed.count() * speed_ * share_;
  }
  void move() { ++moved_; }

 private:
  double speed_;
  double share_ = 1;
  Clock::time_point since_ = Clock::now();
  std::size_t moved_ = 0;
};

/// What is wrong at a row; each fault happens once.
class Faults {
 public:
  explicit Faults(std::vector<SimulatedFault> faults) : faults_(std::move(faults)) {}
  [[nodiscard]] std::optional<SimulatedFault> take(std::size_t row) {
    const auto found = std::ranges::find(faults_, row, &SimulatedFault::row);
    if (found == faults_.end()) return std::nullopt;
    const SimulatedFault fault = *found;
    faults_.erase(found);
    return fault;
  }
  void forget() { faults_.clear(); }

 private:
  std::vector<SimulatedFault> faults_;
};

/// What a row becomes: none, one or two.
std::vector<Row> rows_after(const std::optional<SimulatedFault>& fault, Row row) {
  if (!fault) return {row};
  switch (fault->kind) {
    case Kind::Flip:
      return {static_cast<Row>(row ^ 1U << (fault->track - 1))};
    case Kind::Drop:
      return {};
    case Kind::Double:
      return {row, row};
    case Kind::Break:
    case Kind::Slow:
    case Kind::Hang:
    case Kind::PowerCut:
      break;
  }
  return {row};
}

class SimulatedReader {
 public:
  SimulatedReader(Line line, SimulatorSettings& settings)
      : line_(std::move(line)),
        tape_(settings.tape),
        speed_(settings.reader_speed),
        drive_(settings.reader_speed),
        faults_(settings.reader_faults) {}

  [[nodiscard]] const std::string& name() const { return line_.name(); }
  [[nodiscard]] int number() const { return line_.is_alive() ? line_.number() : -1; }

  void tick() {
    const auto bytes = line_.read(kMostBytes);
    for (const std::uint8_t byte : bytes) obey(byte);
    if (bytes.empty() && line_.is_closed()) rewind();
    while (running_ && !hangs_ && drive_.is_due() && step()) drive_.move();
  }

 private:
  void obey(std::uint8_t byte) {
    const bool is_at_rest = at_ == tape_.size() && Clock::now() - last_ > kAtRest;
    if (byte == kXon && is_at_rest) rewind();
    if (byte == kXon && !running_) drive_.restart();
    if (byte == kXon) running_ = true;
    if (byte == kXoff) running_ = false;
  }
  /// The tape is put in anew.
  void rewind() {
    if (at_ > 0) {
      faults_.forget();
      hangs_ = torn_ = false;
      drive_ = Drive(speed_);
    }
    at_ = 0;
    running_ = false;
    waiting_.clear();
  }
  /// Sends one row; false when the line takes none or there is none.
  bool step() {
    if (waiting_.empty() && !next_row()) return false;
    if (waiting_.empty()) return true;  // a row was lost
    if (!line_.write(waiting_.front())) return false;
    waiting_.pop_front();
    last_ = Clock::now();
    return true;
  }
  bool next_row() {
    if (torn_) {
      waiting_.push_back(kRubOut);
      return true;
    }
    if (at_ >= tape_.size()) return false;
    const auto fault = faults_.take(at_);
    if (fault && !goes_on(fault->kind)) return false;
    for (const Row row : rows_after(fault, tape_[at_])) waiting_.push_back(row);
    ++at_;
    return true;
  }
  bool goes_on(Kind kind) {
    if (kind == Kind::Hang) hangs_ = true;
    if (kind == Kind::PowerCut) line_.cut();
    if (kind == Kind::Break) torn_ = true;
    if (kind == Kind::Slow) drive_.slow_down();
    return kind != Kind::Hang && kind != Kind::PowerCut && kind != Kind::Break;
  }

  Line line_;
  const std::vector<Row>& tape_;
  std::uint32_t speed_;
  Drive drive_;
  Faults faults_;
  std::deque<Row> waiting_;
  std::size_t at_ = 0;
  Clock::time_point last_ = Clock::now();  // when a row was sent
  bool running_ = false;
  bool hangs_ = false;
  bool torn_ = false;
};

class SimulatedPunch {
 public:
  SimulatedPunch(Line line, SimulatorSettings& settings)
      : line_(std::move(line)),
        settings_(settings),
        drive_(settings.punch_speed),
        faults_(settings.punch_faults) {}

  [[nodiscard]] const std::string& name() const { return line_.name(); }
  [[nodiscard]] int number() const { return line_.is_alive() ? line_.number() : -1; }

  void tick() {
    const auto bytes = line_.read(kMostBytes);
    if (buffer_.empty()) drive_.restart();
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    while (!hangs_ && !buffer_.empty() && drive_.is_due()) {
      drive_.move();
      step();
    }
    handshake();
    if (bytes.empty() && (buffer_.empty() || hangs_) && line_.is_closed()) finish();
  }

 private:
  void step() {
    const Row row = buffer_.front();
    const auto fault = faults_.take(at_++);
    if (fault) begin(fault->kind);
    if (hangs_ || !line_.is_alive()) return;
    buffer_.pop_front();
    for (const Row punched : rows_after(fault, row)) punched_.push_back(punched);
  }
  void begin(Kind kind) {
    if (kind == Kind::Slow) drive_.slow_down();
    if (kind == Kind::PowerCut) {
      line_.cut();
      finish();
    }
    hangs_ = hangs_ || kind == Kind::Hang || kind == Kind::Break;
    torn_ = torn_ || kind == Kind::Break;
  }
  void handshake() {
    const bool is_full = torn_ || buffer_.size() >= kFull;
    if (is_full && !stopped_) stopped_ = line_.write(kXoff);
    if (!is_full && stopped_ && buffer_.size() <= kEmpty) stopped_ = !line_.write(kXon);
  }
  /// The tape is cut off.
  void finish() {
    if (at_ == 0) return;
    settings_.on_punched(punched_);
    if (settings_.loop) settings_.tape = punched_;
    punched_.clear();
    buffer_.clear();
    faults_.forget();
    at_ = 0;
    hangs_ = torn_ = stopped_ = false;
    drive_ = Drive(settings_.punch_speed);
  }

  Line line_;
  SimulatorSettings& settings_;
  Drive drive_;
  Faults faults_;
  std::deque<Row> buffer_;
  std::vector<Row> punched_;
  std::size_t at_ = 0;  // rows taken from the buffer
  bool hangs_ = false;
  bool torn_ = false;
  bool stopped_ = false;  // the computer, by us
};

class PseudoTerminals : public Simulator {
 public:
  PseudoTerminals(Line punch, Line reader, SimulatorSettings settings)
      : settings_(std::move(settings)),
        punch_(std::move(punch), settings_),
        reader_(std::move(reader), settings_) {}

  const std::string& punch_name() const override { return punch_.name(); }
  const std::string& reader_name() const override { return reader_.name(); }

  void run(const std::function<bool()>& stopped) override {
    while (!stopped()) {
      punch_.tick();
      reader_.tick();
      ::poll(nullptr, 0, kTick);
    }
  }

 private:
  SimulatorSettings settings_;
  SimulatedPunch punch_;
  SimulatedReader reader_;
};

}  // namespace

std::optional<SimulatedFault> parse_simulated_fault(std::string_view text) {
  const std::size_t at = text.find('@');
  const auto name =
      std::ranges::find(kNames, text.substr(0, at), [](const auto& row) { return row.first; });
  if (at == std::string_view::npos || name == kNames.end()) return std::nullopt;
  SimulatedFault fault{name->second};
  const char* const end = text.data() + text.size();
  const auto row = std::from_chars(text.data() + at + 1, end, fault.row);
  if (row.ec != std::errc() || fault.row == 0) return std::nullopt;
  --fault.row;
  if (row.ptr == end) return fault;
  if (*row.ptr != ':' || fault.kind != Kind::Flip) return std::nullopt;
  const auto track = std::from_chars(row.ptr + 1, end, fault.track);
  const bool is_whole = track.ec == std::errc() && track.ptr == end;
  if (!is_whole || fault.track < 1 || fault.track > kTracks) return std::nullopt;
  return fault;
}

DeviceResult<std::unique_ptr<Simulator>> Simulator::open(SimulatorSettings settings) {
  auto punch = Line::open();
  if (!punch) return tl::unexpected(punch.error());
  auto reader = Line::open();
  if (!reader) return tl::unexpected(reader.error());
  return std::make_unique<PseudoTerminals>(*std::move(punch), *std::move(reader),
                                           std::move(settings));
}

}  // namespace dgt
