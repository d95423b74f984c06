// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/console.h"

#include <fmt/args.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "lang/text/sarif.h"

namespace dgt::cli {
namespace {

struct TextRow {
  std::string_view english;
  std::string_view russian;
};

constexpr std::array kTexts = {
#define DGT_TEXT(name, english, russian) TextRow{english, russian},
#include "apps/cli/texts.def"
#undef DGT_TEXT
};

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

std::string filled(Text text, Language language,
                   std::initializer_list<std::string_view> arguments) {
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const std::string_view argument : arguments) store.push_back(argument);
  const TextRow& row = kTexts.at(static_cast<std::size_t>(text));
  return fmt::vformat(language == Language::Russian ? row.russian : row.english, store);
}

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

Language language_of_locale() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const std::string_view value = variable(name);
    if (!value.empty()) return value.starts_with("ru") ? Language::Russian : Language::English;
  }
  return Language::English;
}

Colour colour_of(ColourChoice choice) {
  if (choice == ColourChoice::Always) return Colour::Ansi;
  if (choice == ColourChoice::Never || !variable("NO_COLOR").empty() || variable("TERM") == "dumb")
    return Colour::Plain;
  return ::isatty(STDERR_FILENO) == 1 ? Colour::Ansi : Colour::Plain;
}

void SarifLog::add(DiagnosticBag bag, Sources sources) {
  bags_.push_back(std::move(bag));
  sources_.push_back(std::move(sources));
}

std::string SarifLog::text(Language language) const {
  std::vector<const DiagnosticBag*> bags;
  for (const DiagnosticBag& bag : bags_) bags.push_back(&bag);
  return to_sarif(bags, {language, DGT_VERSION, failures_});
}

void Console::show(const DiagnosticBag& bag, const Sources& sources) const {
  if (log_) {
    log_->add(bag, sources);
  } else {
    print(render(bag, render_));
  }
}

std::string Console::sentence(Text text, std::initializer_list<std::string_view> arguments) const {
  return filled(text, render_.language, arguments);
}

void Console::error(Text text, std::initializer_list<std::string_view> arguments) const {
  say(Severity::Error, text, arguments);
}

void Console::note(Text text, std::initializer_list<std::string_view> arguments) const {
  say(Severity::Note, text, arguments);
}

void Console::say(Severity severity, Text text,
                  std::initializer_list<std::string_view> arguments) const {
  const bool is_error = severity == Severity::Error;
  if (log_) {
    if (is_error) log_->add_failure(filled(text, render_.language, arguments));
    return;
  }
  const bool ansi = render_.colour == Colour::Ansi;
  print(fmt::format("dgt: {}{}:{} {}\n",
                    !ansi      ? ""
                    : is_error ? "\x1b[1;31m"
                               : "\x1b[1;36m",
                    is_error ? "error" : "note", ansi ? "\x1b[0m" : "",
                    filled(text, render_.language, arguments)));
}

}  // namespace dgt::cli
