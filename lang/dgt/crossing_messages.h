// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "lang/dgt/compile.h"

namespace dgt::language {

/// The files that places of a path speak of.
struct PathSources {
  const SourceFile* program;
  const std::vector<std::shared_ptr<const SourceFile>>& others;
};

/// Warns of leads and rapids that go over a part, as the options say. Of the moves that one word
/// makes, as in a loop, the first is told. Precondition: the path has all its moves.
void report_crossings(const Toolpath& path, const EvaluateOptions& options,
                      const PathSources& sources, DiagnosticBag& bag);

}  // namespace dgt::language
