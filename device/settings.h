// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string>

namespace dgt {

enum class Handshake : std::uint8_t {
  None,
  XonXoff,  ///< the punch stops the computer with DC3; DC1 starts the reader, DC3 stops it
  RtsCts    ///< the same with the lines RTS and CTS
};

/// The speeds that lines have.
inline constexpr std::array<std::uint32_t, 14> kBauds = {
    110, 150, 300, 600, 1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800};

/// How a serial line is set. Always 8 bits raw without parity of the line: track 8 has it already.
struct LineSettings {
  std::uint32_t baud = 9600;
  Handshake handshake = Handshake::XonXoff;
};

/// PL-150M: 150 rows a second.
struct PunchSettings {
  std::string device;                        ///< a file, a serial line, a character device
  std::uint32_t speed = 150;                 ///< rows a second
  std::chrono::milliseconds timeout{10000};  ///< without a row taken
  std::uint32_t buffer = 64;                 ///< rows that the punch may hold unpunched
  LineSettings line;
};

/// FS-1501: 1500 rows a second.
struct ReaderSettings {
  std::string device;
  std::uint32_t speed = 1500;
  std::chrono::milliseconds timeout{5000};  ///< silence that ends a reading
  LineSettings line{19200, Handshake::XonXoff};
};

}  // namespace dgt
