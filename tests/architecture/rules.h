// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/architecture/source_tree.h"

namespace dgt::architecture {

/// What breaks a rule: one line "path:line: what is wrong" each; empty when the rule holds.
using Violations = std::vector<std::string>;

/// The include directions of the rooms:
///  (1) A quoted include names its file from the root and goes only where the arrows go: kernel to
///      itself; lang and post to kernel; device to itself; apps, tests, benchmarks anywhere, but
///      none of the rooms into tests or benchmarks.
///  (2) CGAL is included inside kernel/cgal/ only.
///  (3) A public header of kernel includes the standard library, GMP and public headers.
///  (4) A header of device includes the standard library and tl::expected.
[[nodiscard]] Violations wrong_includes(const SourceFile& file);

/// Headers of kernel that bring in MPFR or CGAL; they are not installed (kernel/CMakeLists.txt).
[[nodiscard]] bool is_internal_to_kernel(const std::string& path);

/// Every C++ file opens with its licence, every header then has `#pragma once`.
[[nodiscard]] Violations wrong_opening(const SourceFile& file);

/// Marks of unfinished work, and absolute paths of somebody's machine.
[[nodiscard]] Violations forbidden_words(const SourceFile& file);

/// Types that two headers of the rooms define under one name in one namespace. Each file compiles;
/// the linker then keeps one constructor, or one vector, for both.
[[nodiscard]] Violations types_named_twice(const std::vector<SourceFile>& files);

/// Entries of the top level that have no place there; names with a leading dot are free.
[[nodiscard]] Violations strangers_at_top_level(const std::filesystem::path& root);

}  // namespace dgt::architecture
