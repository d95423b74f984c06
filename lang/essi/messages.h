// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lang/essi/block.h"

namespace dgt::essi {

/// A call that is being run.
struct Call {
  std::int64_t number = 0;
  Range range;
};

/// Tells what is wrong with blocks, and in which calls of subprograms.
class Messages {
 public:
  Messages(const SourceFile& file, DiagnosticBag& bag) : file_(file), bag_(bag) {}

  /// The calls that led to the block in work, the outermost first.
  std::vector<Call> calls;

  [[nodiscard]] Range range_of(const Block& block) const {
    return {&file_, block.begin, block.end};
  }
  [[nodiscard]] Range range_of(const Field& field) const {
    return {&file_, field.begin, field.end};
  }

  void add(Diagnostic diagnostic) {
    if (diagnostic.severity() != Severity::Note) {
      for (auto call = calls.rbegin(); call != calls.rend(); ++call)
        diagnostic.notes.push_back(
            {Message::InSubprogram, call->range, {std::to_string(call->number)}});
    }
    bag_.add(std::move(diagnostic));
  }
  void report(Message message, const Range& range, std::vector<std::string> arguments = {}) {
    add({message, range, std::move(arguments)});
  }
  /// With its text.
  void refuse(const Field& field, Message message) {
    report(message, range_of(field), {std::string(range_of(field).text())});
  }
  void refuse(const Block& block, Message message) {
    report(message, range_of(block), {std::string(range_of(block).text())});
  }

 private:
  const SourceFile& file_;
  DiagnosticBag& bag_;
};

}  // namespace dgt::essi
