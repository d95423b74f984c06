// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/diagnostic.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lang/text/utf8.h"

namespace dgt {
namespace {

constexpr std::array kMessages = {
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

}  // namespace

const MessageInfo& info(Message message) { return kMessages.at(static_cast<std::size_t>(message)); }

std::span<const MessageInfo> all_messages() { return kMessages; }

std::string text(Message message, std::span<const std::string> arguments, Language language) {
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const std::string& argument : arguments) store.push_back(visible(shortened(argument)));
  const MessageInfo& row = info(message);
  return fmt::vformat(language == Language::Russian ? row.russian : row.english, store);
}

void DiagnosticBag::add(Diagnostic diagnostic) {
  const bool is_error = diagnostic.severity() == Severity::Error;
  const auto& range = diagnostic.range;
  if (!seen_.emplace(range.file, range.begin, range.end, diagnostic.message).second) return;
  if (is_error) ++error_count_;
  if (diagnostics_.size() > kMaxKept) return;
  if (diagnostics_.size() == kMaxKept) {
    diagnostic = {Message::TooManyDiagnostics, range, {std::to_string(kMaxKept)}};
  }
  diagnostics_.push_back(std::move(diagnostic));
}

void DiagnosticBag::sort() {
  std::vector<const SourceFile*> files;
  for (const Diagnostic& d : diagnostics_) {
    if (std::find(files.begin(), files.end(), d.range.file) == files.end()) {
      files.push_back(d.range.file);
    }
  }
  const auto key = [&](const Diagnostic& d) {
    const auto file = std::find(files.begin(), files.end(), d.range.file);
    return std::pair(file, d.range.begin);
  };
  const auto last = std::find_if(diagnostics_.begin(), diagnostics_.end(), [](const auto& d) {
    return d.message == Message::TooManyDiagnostics;
  });
  std::stable_sort(diagnostics_.begin(), last,
                   [&](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
}

}  // namespace dgt
