// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dgt {

/// Gives back what the calling thread keeps for its arithmetic (MPFR's constants and spare
/// numbers). A thread that has calculated calls it before it ends.
void release_thread_arithmetic();

}  // namespace dgt
