// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/diagnostic.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lang/text/utf8.h"

namespace dgt {
namespace {

// No std::array that counts for itself: clang unfolds one element after the other, up to 256.
constexpr MessageInfo kMessages[] = {
#define DGT_DIAGNOSTIC(name, code, severity, english, russian) \
  MessageInfo{#name, code, Severity::severity, english, russian},
#include "lang/text/diagnostics.def"
#undef DGT_DIAGNOSTIC
};

// What a message quotes of the source may be a megabyte without a blank.
constexpr std::uint32_t kMaxQuoted = 300;

std::string shortened(const std::string& argument) {
  if (argument.size() <= kMaxQuoted) return argument;
  std::size_t end = 0;
  for (std::uint32_t count = 0; count < kMaxQuoted && end < argument.size(); ++count) {
    end += code_point_at(argument, end).size;
  }
  return end < argument.size() ? argument.substr(0, end) + "…" : argument;
}

// What stands behind as many messages of a severity as are kept.
Message message_of_end(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return Message::TooManyDiagnostics;
    case Severity::Warning:
      return Message::TooManyWarnings;
    case Severity::Note:
      break;
  }
  return Message::TooManyNotes;
}

bool is_end(Message message) { return message == message_of_end(info(message).severity); }

}  // namespace

const MessageInfo& info(Message message) { return kMessages[static_cast<std::size_t>(message)]; }

std::span<const MessageInfo> all_messages() { return kMessages; }

std::string text(Message message, std::span<const std::string> arguments, Language language) {
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const std::string& argument : arguments) store.push_back(visible(shortened(argument)));
  const MessageInfo& row = info(message);
  return fmt::vformat(language == Language::Russian ? row.russian : row.english, store);
}

void DiagnosticBag::add(Diagnostic diagnostic) {
  const Severity severity = diagnostic.severity();
  std::size_t& kept = kept_.at(static_cast<std::size_t>(severity));
  const bool is_error = severity == Severity::Error;
  if (kept > kMaxKept) {
    if (is_error) ++error_count_;
    return;
  }
  const Range range = diagnostic.range;
  if (!seen_.emplace(range.file, range.begin, range.end, diagnostic.message).second) return;
  if (is_error) ++error_count_;
  if (++kept > kMaxKept) {
    diagnostic = {message_of_end(severity), range, {std::to_string(kMaxKept)}};
  }
  diagnostics_.push_back(std::move(diagnostic));
}

void DiagnosticBag::sort(const SourceFile* first) {
  std::vector<const SourceFile*> files;
  if (first != nullptr) files.push_back(first);
  for (const Diagnostic& d : diagnostics_) {
    if (std::find(files.begin(), files.end(), d.range.file) == files.end()) {
      files.push_back(d.range.file);
    }
  }
  const auto key = [&](const Diagnostic& d) {
    const auto file = std::find(files.begin(), files.end(), d.range.file);
    return std::tuple(is_end(d.message), file, d.range.begin);
  };
  std::stable_sort(diagnostics_.begin(), diagnostics_.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
}

}  // namespace dgt
