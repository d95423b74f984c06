// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMetaType>
#include <cstdint>
#include <memory>
#include <string>

#include "apps/driver/pipeline.h"
#include "apps/driver/settings.h"

namespace dgt::studio {

/// A program as the driver understood it: made in the background, shared between the windows, never
/// changed. Without a path (`compilation.result.path`) it has errors.
struct Part {
  std::uint64_t revision = 0;  ///< of the text that was compiled, as asked for
  std::string name;            ///< of the file; macros were looked for beside it
  Settings settings;           ///< with which it was compiled, and is to be written
  Compilation compilation;

  [[nodiscard]] const Toolpath* path() const {
    return compilation.result.path ? &*compilation.result.path : nullptr;
  }
};
using PartPtr = std::shared_ptr<const Part>;

}  // namespace dgt::studio

Q_DECLARE_METATYPE(dgt::studio::PartPtr)
