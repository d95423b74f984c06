// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "apps/driver/settings.h"

/// Many programs written for one control.
namespace dgt {

/// One program and where it goes.
struct BatchItem {
  std::string input;
  std::string output;
};

/// Why there is no plan: nothing stands behind `input`, or both it and `other` would be written to
/// `output`.
struct BatchFault {
  std::string input;
  std::string other;
  std::string output;

  [[nodiscard]] bool is_clash() const { return !output.empty(); }
};

/// The programs that folders, patterns and names stand for, sorted by name, each once; of folders
/// the files in a known language, in folders below as well, whose place is kept under `folder`.
[[nodiscard]] tl::expected<std::vector<BatchItem>, BatchFault> plan_batch(
    const std::vector<std::string>& inputs, const std::string& folder, const Dialect& dialect);

struct BatchResult {
  BatchItem item;
  bool is_done = false;
  std::size_t blocks = 0;
  double deviation = 0;  ///< certified, mm
  std::optional<FileError> failure;
  DiagnosticBag bag;
  std::vector<std::shared_ptr<const SourceFile>> sources;  ///< that the bag points into
};

/// Works `jobs` programs at a time; the results are in the order of the items, whatever the order
/// in which they were done.
[[nodiscard]] std::vector<BatchResult> run_batch(const std::vector<BatchItem>& items,
                                                 const Settings& settings, unsigned jobs);

/// One line a program: `done` or `failed`, blocks, deviation, names.
[[nodiscard]] std::string table_of(const std::vector<BatchResult>& results);

}  // namespace dgt
