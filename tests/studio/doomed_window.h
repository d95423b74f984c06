// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dgt::studio {

/// A window for a test to kill: what the environment variable DGT_STUDIO_DOOMED says is typed into
/// it, a file it names in DGT_STUDIO_FILE being open; a line on standard output tells when the text
/// has been kept for recovery.
int live_until_killed();

}  // namespace dgt::studio
