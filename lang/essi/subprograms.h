// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>

#include "lang/essi/messages.h"
#include "lang/essi/reader.h"

namespace dgt::essi {

inline constexpr std::int64_t kFirstSubprogram = 101;
inline constexpr std::int64_t kLastSubprogram = 30000;

[[nodiscard]] inline bool is_subprogram(std::int64_t number) {
  return number >= kFirstSubprogram && number <= kLastSubprogram;
}

struct Subprogram {
  Range begin;
  std::vector<Block> blocks;
};

/// The subprograms of a program, as they are defined before its main part.
class Subprograms {
 public:
  explicit Subprograms(Messages& messages) : messages_(messages) {}

  /// Whether the block begins, ends or is part of a subprogram; then it is kept.
  bool take(const Block& block, bool began_main);
  /// At the end of the program: one that was not closed, calls of none that are never run.
  void check();

  /// Null, which is told, when there is none that the block could call.
  [[nodiscard]] const Subprogram* called_by(const Block& block);

 private:
  void open(const Block& block, bool began_main);
  void close(const Block& block);

  Messages& messages_;
  std::map<std::int64_t, Subprogram> all_;
  Subprogram* open_ = nullptr;
  std::int64_t open_number_ = 0;
};

/// What a call says besides the number.
struct CallWords {
  std::int64_t repetitions = 1;
  std::int64_t tenths = 0;  ///< of a degree, counter-clockwise
  Rational scale = 1;
};
/// Nothing, which is told, when it says something else.
[[nodiscard]] std::optional<CallWords> read_call(const Block& block, const EssiOptions& options,
                                                 Messages& messages);

/// Whether the subprogram that the block calls may be run inside those that run; told when not.
[[nodiscard]] bool may_enter(const Block& block, Messages& messages);

}  // namespace dgt::essi
