// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "device/settings.h"
#include "device/simulator.h"

namespace dgt::support {

// Fast devices, so that a test takes tenths of a second.
inline constexpr std::uint32_t kSimulatedSpeed = 6000;

/// A simulator at work. Nothing here waits longer than its timeouts; a test that hangs all the same
/// is ended by the alarm.
class AtWork {
 public:
  explicit AtWork(SimulatorSettings settings) {
    std::signal(SIGPIPE, SIG_IGN);
    ::alarm(60);
    settings.reader_speed = settings.punch_speed = kSimulatedSpeed;
    settings.on_punched = [this](const std::vector<Row>& rows) {
      punched_ = rows;
      ++tapes_;
    };
    simulator_ = *Simulator::open(std::move(settings));
    thread_ = std::thread([this] { simulator_->run([this] { return stopped_.load(); }); });
  }
  ~AtWork() {
    stop();
    ::alarm(0);
  }

  [[nodiscard]] PunchSettings punch() const {
    PunchSettings settings;
    settings.device = simulator_->punch_name();
    settings.speed = kSimulatedSpeed;
    settings.timeout = std::chrono::milliseconds(400);
    return settings;
  }
  [[nodiscard]] ReaderSettings reader() const {
    ReaderSettings settings;
    settings.device = simulator_->reader_name();
    settings.speed = kSimulatedSpeed;
    settings.timeout = std::chrono::milliseconds(400);
    return settings;
  }
  /// The tape that lies in the punch's tray, once the line was closed.
  [[nodiscard]] std::vector<Row> punched() {
    for (int i = 0; i < 500 && tapes_ == 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    stop();
    return punched_;
  }

 private:
  void stop() {
    stopped_ = true;
    if (thread_.joinable()) thread_.join();
  }

  std::unique_ptr<Simulator> simulator_;
  std::vector<Row> punched_;
  std::atomic<int> tapes_ = 0;
  std::atomic<bool> stopped_ = false;
  std::thread thread_;
};

}  // namespace dgt::support
