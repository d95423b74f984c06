// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace dgt {

/// A broken promise of our own: never the user's fault. Caught once per command, which reports it
/// as an internal error and writes nothing.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] inline void check_failed(const char* condition, const char* file, int line) {
  throw InternalError(std::string(file) + ":" + std::to_string(line) + ": " + condition);
}

}  // namespace dgt

/// States what must hold here if the program is right; on in release too.
#define DGT_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::dgt::check_failed(#condition, __FILE__, __LINE__))
