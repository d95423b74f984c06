// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lang/text/diagnostic.h"
#include "lang/text/render.h"

namespace dgt::cli {

/// What a command ends with; the numbers are a contract with scripts.
enum class ExitCode : std::uint8_t {
  Done = 0,
  InputErrors = 1,  ///< and nothing was written
  WrongUsage = 2,
  Failure = 3,  ///< of a file or device, or of the program itself
  NotVerified = 4
};

using Sources = std::vector<std::shared_ptr<const SourceFile>>;

/// The sentences of the command itself; the rows of texts.def.
enum class Text : std::uint8_t {
#define DGT_TEXT(name, english, russian) name,
#include "apps/cli/texts.def"
#undef DGT_TEXT
};

/// English unless LC_ALL, LC_MESSAGES or LANG (the first that is set) asks for Russian.
[[nodiscard]] Language language_of_locale();

enum class ColourChoice : std::uint8_t { Auto, Always, Never };

/// Auto: on a terminal, unless NO_COLOR is set and not empty or TERM is `dumb`.
[[nodiscard]] Colour colour_of(ColourChoice choice);

enum class MessageForm : std::uint8_t { Text, Sarif };

/// Everything that one command has to say, for one SARIF log at its end.
class SarifLog {
 public:
  void add(DiagnosticBag bag, Sources sources);
  void add_failure(std::string text) { failures_.push_back(std::move(text)); }
  [[nodiscard]] std::string text(Language language) const;

 private:
  std::vector<DiagnosticBag> bags_;
  std::vector<Sources> sources_;
  std::vector<std::string> failures_;
};

/// What the command says to the person, on standard error. With a log nothing is printed:
/// diagnostics and errors go there, notes of the command are left out.
class Console {
 public:
  Console(Language language, Colour colour, std::shared_ptr<SarifLog> log = nullptr)
      : render_{language, colour}, log_(std::move(log)) {}

  [[nodiscard]] Language language() const { return render_.language; }
  /// Whether nothing is printed: everything goes into a log.
  [[nodiscard]] bool is_quiet() const { return log_ != nullptr; }
  /// The sentence alone.
  [[nodiscard]] std::string sentence(Text text,
                                     std::initializer_list<std::string_view> arguments) const;
  /// `sources`: the files that the diagnostics point into.
  void show(const DiagnosticBag& bag, const Sources& sources) const;
  /// `dgt: error: …`, `dgt: note: …`
  void error(Text text, std::initializer_list<std::string_view> arguments) const;
  void note(Text text, std::initializer_list<std::string_view> arguments) const;

 private:
  void say(Severity severity, Text text, std::initializer_list<std::string_view> arguments) const;

  RenderOptions render_;
  std::shared_ptr<SarifLog> log_;
};

}  // namespace dgt::cli
