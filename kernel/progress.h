// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace dgt {

/// Is told how far long work is, by the thread that does it: `done` of `all`, in lines or moves.
/// Empty: nobody wants to know.
using OnProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Between two calls lie so many lines or moves, some milliseconds at most.
inline constexpr std::size_t kProgressStep = 1024;

inline void tell_progress(const OnProgress& told, std::size_t done, std::size_t all) {
  if (told && done % kProgressStep == 0) told(done, all);
}

}  // namespace dgt
