// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lang/dgt/compile.h"
#include "lang/text/render.h"

namespace dgt {

/// Macros and definition files from memory, by their full name.
class MemoryLoader : public SourceLoader {
 public:
  using Files = std::map<std::string, std::string, std::less<>>;

  explicit MemoryLoader(Files files = {}, bool saved = true)
      : files_(std::move(files)), saved_(saved) {}

  std::optional<SourceText> load_macro(std::string_view name) override {
    ++loads;
    auto macro = load(std::string(name) + ".mac");
    return macro ? macro : load(std::string(name) + ".bgt");
  }
  std::optional<SourceText> load_definitions(std::string_view name) override {
    return load(std::string(name) + ".bgt");
  }
  bool has_folder() const override { return saved_; }

  int loads = 0;

 private:
  std::optional<SourceText> load(const std::string& name) const {
    const auto found = files_.find(name);
    if (found == files_.end()) return std::nullopt;
    return SourceText{found->first, found->second};
  }
  Files files_;
  bool saved_;
};

/// A program `t.bgt` from memory, compiled.
class CompiledProgram {
 public:
  explicit CompiledProgram(std::string_view text, MemoryLoader::Files files = {},
                           EvaluateOptions options = {}, bool saved = true)
      : file_("t.bgt", text), loader_(std::move(files), saved) {
    result_ = compile(file_, loader_, options, bag_);
  }

  /// Everything that was said, as a person sees it.
  [[nodiscard]] std::string messages(Language language = Language::English) const {
    return render(bag_, {language, Colour::Plain});
  }
  /// Only errors and warnings.
  [[nodiscard]] std::string faults() const {
    std::string out;
    for (const Diagnostic& d : bag_.all()) {
      if (d.severity() != Severity::Note) out += render(d);
    }
    return out;
  }
  /// The path; what stands in the way of one when there is none.
  [[nodiscard]] std::string path() const {
    return result_.path ? to_text(*result_.path) : messages();
  }
  [[nodiscard]] const CompileResult& result() const { return result_; }
  [[nodiscard]] const MemoryLoader& loader() const { return loader_; }

 private:
  SourceFile file_;
  MemoryLoader loader_;
  DiagnosticBag bag_;
  CompileResult result_;
};

}  // namespace dgt
