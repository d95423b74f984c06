// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/port.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <thread>
#include <utility>

namespace dgt {
namespace {

using Kind = DeviceFault::Kind;

/// Of kBauds, in their order.
constexpr std::array<speed_t, kBauds.size()> kSpeeds = {B110,   B150,    B300,    B600,   B1200,
                                                        B2400,  B4800,   B9600,   B19200, B38400,
                                                        B57600, B115200, B230400, B460800};
constexpr cc_t kXon = 0x11;
constexpr cc_t kXoff = 0x13;
/// How often a drained line is looked for: poll() does not tell.
constexpr Wait kLookAgain{5};

/// Raw bytes; who may stop whom depends on the direction. The reader's bytes are rows, 0x11 and
/// 0x13 among them, so what it sends never stops the computer.
termios raw(termios line, PortUse use, Handshake handshake) {
  ::cfmakeraw(&line);
  line.c_cflag &= ~static_cast<tcflag_t>(PARENB | CSTOPB | CRTSCTS);
  line.c_cflag |= CS8 | CLOCAL | CREAD;
  line.c_iflag &= ~static_cast<tcflag_t>(IXON | IXOFF | IXANY | IGNBRK | BRKINT | IGNPAR);
  if (use == PortUse::Reader) line.c_iflag |= PARMRK | INPCK;
  if (handshake == Handshake::RtsCts) line.c_cflag |= CRTSCTS;
  if (handshake == Handshake::XonXoff) line.c_iflag |= use == PortUse::Punch ? IXON : IXOFF;
  line.c_cc[VSTART] = kXon;
  line.c_cc[VSTOP] = kXoff;
  line.c_cc[VMIN] = 1;
  line.c_cc[VTIME] = 0;
  return line;
}

}  // namespace

DeviceResult<Port> Port::open(const std::string& name, PortUse use, const LineSettings& line) {
  const auto open_as = [&](int access) {
    return Descriptor(::open(name.c_str(), access | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  };
  // Lines are spoken on in both directions; a parallel port may know one alone.
  Descriptor descriptor = open_as(use == PortUse::Punch ? O_WRONLY : O_RDONLY);
  const bool is_line = descriptor.is_open() && ::isatty(descriptor.number()) == 1;
  if (is_line) {
    Descriptor both = open_as(O_RDWR);
    descriptor = std::move(both);
  }
  if (!descriptor.is_open()) return tl::unexpected(DeviceFault{Kind::CannotOpen, name, errno});
  Port port(name, std::move(descriptor));
  if (is_line && !port.set_up(use, line)) {
    return tl::unexpected(DeviceFault{Kind::CannotSetUp, name, errno});
  }
  return port;
}

Port::Port(std::string name, Descriptor descriptor)
    : name_(std::move(name)), descriptor_(std::move(descriptor)) {}

Port::Port(Port&& other) noexcept
    : name_(std::move(other.name_)),
      descriptor_(std::move(other.descriptor_)),
      before_(std::move(other.before_)),
      keeps_output_(other.keeps_output_) {}

Port::~Port() {
  if (!descriptor_.is_open() || !before_) return;
  // Closing a line that is stopped waits for half a minute, unless nothing is left to be sent.
  if (!keeps_output_) ::tcflush(descriptor_.number(), TCIOFLUSH);
  ::tcsetattr(descriptor_.number(), TCSANOW, before_.get());
}

bool Port::set_up(PortUse use, const LineSettings& line) {
  const auto baud = std::ranges::find(kBauds, line.baud);
  if (baud == kBauds.end()) {
    errno = EINVAL;
    return false;
  }
  const speed_t speed = kSpeeds.at(static_cast<std::size_t>(baud - kBauds.begin()));
  const int fd = descriptor_.number();
  termios before{};
  if (::tcgetattr(fd, &before) != 0) return false;
  termios wanted = raw(before, use, line.handshake);
  if (::cfsetispeed(&wanted, speed) != 0 || ::cfsetospeed(&wanted, speed) != 0 ||
      ::tcsetattr(fd, TCSANOW, &wanted) != 0) {
    return false;
  }
  before_ = std::make_unique<termios>(before);
  // tcsetattr() is content when it could set anything at all.
  termios now{};
  if (::tcgetattr(fd, &now) != 0) return false;
  constexpr tcflag_t kInput = IXON | IXOFF | PARMRK;
  constexpr tcflag_t kControl = CSIZE | PARENB | CRTSCTS;
  if (((now.c_iflag ^ wanted.c_iflag) & kInput) != 0 ||
      ((now.c_cflag ^ wanted.c_cflag) & kControl) != 0 || ::cfgetospeed(&now) != speed) {
    errno = ENOTSUP;
    return false;
  }
  ::tcflush(fd, TCIOFLUSH);
  ::tcflow(fd, TCOON);  // somebody may have left it stopped
  return true;
}

tl::unexpected<DeviceFault> Port::failed(int error) const {
  const bool is_gone = error == EIO || error == ENXIO || error == EPIPE || error == ENODEV;
  return tl::unexpected(DeviceFault{is_gone ? Kind::Gone : Kind::Failed, name_, error});
}

DeviceResult<bool> Port::is_ready(short events, Wait wait) {
  pollfd polled{descriptor_.number(), events, 0};
  const int count = ::poll(&polled, 1, static_cast<int>(wait.count()));
  if (count < 0) return errno == EINTR ? DeviceResult<bool>(false) : failed(errno);
  // What has come is read before the end is told.
  if ((polled.revents & events) != 0) return true;
  if ((polled.revents & (POLLERR | POLLNVAL)) != 0) return failed(EIO);
  if ((polled.revents & POLLHUP) != 0) {
    if (is_line()) return failed(EIO);
    return true;  // of a pipe: reading tells
  }
  return false;
}

DeviceResult<std::size_t> Port::write(std::span<const std::uint8_t> bytes, Wait wait) {
  const auto ready = is_ready(POLLOUT, wait);
  if (!ready) return tl::unexpected(ready.error());
  if (!*ready) return 0;
  const ssize_t put = ::write(descriptor_.number(), bytes.data(), bytes.size());
  if (put >= 0) return static_cast<std::size_t>(put);
  if (errno == EAGAIN || errno == EINTR) return 0;
  return failed(errno);
}

DeviceResult<Port::Got> Port::read(std::span<std::uint8_t> into, Wait wait) {
  const auto ready = is_ready(POLLIN, wait);
  if (!ready) return tl::unexpected(ready.error());
  if (!*ready) return Got{};
  const ssize_t got = ::read(descriptor_.number(), into.data(), into.size());
  if (got > 0) return Got{static_cast<std::size_t>(got), false};
  if (got == 0) {
    if (is_line()) return failed(EIO);  // hung up
    return Got{0, true};
  }
  if (errno == EAGAIN || errno == EINTR) return Got{};
  return failed(errno);
}

DeviceResult<bool> Port::is_drained(Wait wait) {
  if (!is_line()) return true;
  int waiting = 0;
  if (::ioctl(descriptor_.number(), TIOCOUTQ, &waiting) != 0) return failed(errno);
  if (waiting > 0) std::this_thread::sleep_for(std::min(wait, kLookAgain));
  return waiting == 0;
}

void Port::set_rts(bool raised) {
  int rts = TIOCM_RTS;
  (void)::ioctl(descriptor_.number(), raised ? TIOCMBIS : TIOCMBIC, &rts);
}

}  // namespace dgt
