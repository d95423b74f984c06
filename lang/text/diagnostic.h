// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "lang/text/source_file.h"

namespace dgt {

/// Every message the readers can give; the rows of diagnostics.def.
enum class Message : std::uint16_t {
#define DGT_DIAGNOSTIC(name, code, severity, english, russian) name,
#include "lang/text/diagnostics.def"
#undef DGT_DIAGNOSTIC
};

enum class Severity : std::uint8_t { Note, Warning, Error };
enum class Language : std::uint8_t { English, Russian };

/// One row of the table of messages.
struct MessageInfo {
  std::string_view name;  ///< the enumerator
  std::string_view code;  ///< stable, `DGT0203`
  Severity severity;
  std::string_view english;  ///< with numbered placeholders, `{0}`
  std::string_view russian;  ///< with the same placeholders
};
[[nodiscard]] const MessageInfo& info(Message message);
/// The whole table, in the order of the enumerators.
[[nodiscard]] std::span<const MessageInfo> all_messages();

/// Whether a program may put a fix-it in place unasked.
enum class Certainty : std::uint8_t {
  Sure,
  Guess  ///< it changes what a working program cuts; a person decides
};

/// A text to put in place of a range that would cure the fault.
struct FixIt {
  Range range;
  std::string replacement;
  Certainty certainty = Certainty::Sure;
};

/// A further place that belongs to a diagnostic.
struct Note {
  Message message;
  Range range;
  std::vector<std::string> arguments;
};

/// A fault, a doubt or a remark about a source text, as data.
struct Diagnostic {
  Message message;
  Range range;
  std::vector<std::string> arguments;  ///< what the placeholders stand for
  std::vector<Note> notes = {};
  std::optional<FixIt> fix_it = std::nullopt;
  /// A second place at fault, in the line of `range`; both are underlined.
  std::optional<Range> other = std::nullopt;

  [[nodiscard]] Severity severity() const { return info(message).severity; }
  [[nodiscard]] std::string_view code() const { return info(message).code; }
};

/// The sentence of a message with its arguments filled in, made visible(), cut
/// after 300 characters.
[[nodiscard]] std::string text(Message message, std::span<const std::string> arguments, Language);

/// Collects diagnostics. The same message about the same range is kept once, so a fault inside a
/// loop is told once. Of each severity kMaxKept are kept, so that remarks never crowd out errors;
/// past them one more says so, and errors are only counted.
class DiagnosticBag {
 public:
  static constexpr std::size_t kMaxKept = 1000;

  void add(Diagnostic diagnostic);

  [[nodiscard]] const std::vector<Diagnostic>& all() const { return diagnostics_; }
  [[nodiscard]] bool empty() const { return diagnostics_.empty(); }
  [[nodiscard]] bool has_errors() const { return error_count_ > 0; }
  [[nodiscard]] std::size_t error_count() const { return error_count_; }

  /// Puts the diagnostics in the order of their places: those in `first`, then files as first met;
  /// in each of them top to bottom.
  void sort(const SourceFile* first = nullptr);

 private:
  std::vector<Diagnostic> diagnostics_;
  std::set<std::tuple<const SourceFile*, std::uint32_t, std::uint32_t, Message>> seen_;
  std::array<std::size_t, 3> kept_{};  // by severity
  std::size_t error_count_ = 0;
};

}  // namespace dgt
