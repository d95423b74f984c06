// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/devices.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

#include "device/line_marks.h"
#include "device/port.h"

namespace dgt {
namespace {

using Kind = DeviceFault::Kind;

constexpr Row kStartReader = 0x11;  // DC1
constexpr Row kStopReader = 0x13;   // DC3
constexpr Wait kSoon{1000};         // until a control character must have been taken

DeviceFault failed(Kind kind, const std::string& name) { return {kind, name, errno}; }

// --- character devices --------------------------------------------------------------------------

class PortPunch : public Punch {
 public:
  explicit PortPunch(Port port) : port_(std::move(port)) {}

  DeviceResult<std::size_t> put(std::span<const Row> rows, Wait wait) override {
    return port_.write(rows, wait);
  }
  DeviceResult<bool> finish(Wait wait) override {
    auto drained = port_.is_drained(wait);
    if (drained && *drained) port_.keep_output();
    return drained;
  }
  bool has_pace() const override { return true; }

 private:
  Port port_;
};

class PortReader : public Reader {
 public:
  PortReader(Port port, Handshake handshake) : port_(std::move(port)), handshake_(handshake) {}

  DeviceResult<void> start() override {
    if (!port_.is_line()) return {};
    if (handshake_ == Handshake::RtsCts) port_.set_rts(true);
    if (handshake_ != Handshake::XonXoff) return {};
    const auto put = port_.write(std::array{kStartReader}, kSoon);
    if (!put) return tl::unexpected(put.error());
    if (*put == 0) return tl::unexpected(DeviceFault{Kind::NoRows, port_.name()});
    return {};
  }
  DeviceResult<Reading> take(Wait wait) override {
    std::array<Row, 4096> buffer{};
    const auto got = port_.read(buffer, wait);
    if (!got) return tl::unexpected(got.error());
    Reading reading;
    reading.ended = got->ended;
    const auto bytes = std::span(buffer).first(got->count);
    if (port_.is_line()) {
      marks_.read(bytes, reading);
    } else {
      reading.rows.assign(bytes.begin(), bytes.end());
    }
    return reading;
  }
  void stop() override {
    if (!port_.is_line()) return;
    if (handshake_ == Handshake::RtsCts) port_.set_rts(false);
    if (handshake_ != Handshake::XonXoff) return;
    // A reader that is gone has stopped too.
    if (port_.write(std::array{kStopReader}, kSoon)) port_.keep_output();
  }
  bool has_pace() const override { return true; }

 private:
  Port port_;
  Handshake handshake_;
  LineMarks marks_;
};

// --- files --------------------------------------------------------------------------------------

class FilePunch : public Punch {
 public:
  explicit FilePunch(std::string name) : name_(std::move(name)) {}

  DeviceResult<std::size_t> put(std::span<const Row> rows, Wait) override {
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    return rows.size();
  }
  DeviceResult<bool> finish(Wait) override {
    const std::string beside = name_ + ".new-" + std::to_string(::getpid());
    if (write(beside) && ::rename(beside.c_str(), name_.c_str()) == 0) return true;
    const DeviceFault fault = failed(Kind::Failed, name_);
    ::unlink(beside.c_str());
    return tl::unexpected(fault);
  }
  bool has_pace() const override { return false; }

 private:
  [[nodiscard]] bool write(const std::string& name) const {
    const Descriptor file(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file.is_open()) return false;
    for (std::size_t done = 0; done < rows_.size();) {
      const ssize_t put = ::write(file.number(), rows_.data() + done, rows_.size() - done);
      if (put < 0 && errno != EINTR) return false;
      if (put > 0) done += static_cast<std::size_t>(put);
    }
    return ::fsync(file.number()) == 0;
  }

  std::string name_;
  std::vector<Row> rows_;
};

class FileReader : public Reader {
 public:
  FileReader(std::string name, Descriptor file) : name_(std::move(name)), file_(std::move(file)) {}

  DeviceResult<void> start() override { return {}; }
  DeviceResult<Reading> take(Wait) override {
    Reading reading;
    reading.rows.resize(1 << 16);
    const ssize_t got = ::read(file_.number(), reading.rows.data(), reading.rows.size());
    if (got < 0 && errno != EINTR) return tl::unexpected(failed(Kind::Failed, name_));
    reading.rows.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    reading.ended = got == 0;
    return reading;
  }
  void stop() override {}
  bool has_pace() const override { return false; }

 private:
  std::string name_;
  Descriptor file_;
};

enum class Nature : std::uint8_t { Missing, File, Device };

Nature nature_of(const std::string& name) {
  struct stat found {};
  if (::stat(name.c_str(), &found) != 0) return Nature::Missing;
  return S_ISCHR(found.st_mode) || S_ISFIFO(found.st_mode) ? Nature::Device : Nature::File;
}

}  // namespace

DeviceResult<std::unique_ptr<Punch>> open_punch(const PunchSettings& settings) {
  const Nature nature = nature_of(settings.device);
  // What is missing among the devices is a punch that is not there, not a file to be made.
  const bool is_absent = nature == Nature::Missing && settings.device.starts_with("/dev/");
  if (nature == Nature::Device || is_absent) {
    auto port = Port::open(settings.device, PortUse::Punch, settings.line);
    if (!port) return tl::unexpected(port.error());
    return std::make_unique<PortPunch>(*std::move(port));
  }
  if (nature == Nature::File && ::access(settings.device.c_str(), W_OK) != 0) {
    return tl::unexpected(failed(Kind::CannotOpen, settings.device));
  }
  return std::make_unique<FilePunch>(settings.device);
}

DeviceResult<std::unique_ptr<Reader>> open_reader(const ReaderSettings& settings) {
  if (nature_of(settings.device) == Nature::Device) {
    auto port = Port::open(settings.device, PortUse::Reader, settings.line);
    if (!port) return tl::unexpected(port.error());
    return std::make_unique<PortReader>(*std::move(port), settings.line.handshake);
  }
  Descriptor file(::open(settings.device.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) return tl::unexpected(failed(Kind::CannotOpen, settings.device));
  return std::make_unique<FileReader>(settings.device, std::move(file));
}

}  // namespace dgt
