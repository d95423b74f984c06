// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as a program: it is compiled within small bounds, told of in both languages, dumped and
// laid out. A zero byte ends the program; behind it, up to the next, stands the macro that every
// MAC finds, then the definition file of every OPR.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "kernel/check.h"
#include "lang/dgt/compile.h"
#include "lang/dgt/dump.h"
#include "lang/dgt/formatter.h"
#include "lang/text/fixes.h"
#include "lang/text/render.h"

namespace {

using namespace dgt;

std::string_view cut_part(std::string_view& rest) {
  const std::size_t end = rest.find('\0');
  const std::string_view part = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return part;
}

class PartLoader : public SourceLoader {
 public:
  PartLoader(std::string_view macro, std::string_view definitions)
      : macro_(macro), definitions_(definitions) {}

  std::optional<SourceText> load_macro(std::string_view) override {
    return SourceText{"m.mac", std::string(macro_)};
  }
  std::optional<SourceText> load_definitions(std::string_view) override {
    return SourceText{"d.bgt", std::string(definitions_)};
  }
  bool has_folder() const override { return true; }

 private:
  std::string_view macro_;
  std::string_view definitions_;
};

EvaluateOptions small_bounds() {
  EvaluateOptions options;
  options.bounds = {
      .statements = 300, .moves = 300, .loop_depth = 5, .macro_depth = 5, .text_depth = 5};
  return options;
}

void check_places(const DiagnosticBag& bag) {
  const auto is_inside = [](const Range& range) {
    return range.file != nullptr && range.begin <= range.end &&
           range.end <= range.file->text().size();
  };
  for (const Diagnostic& diagnostic : bag.all()) {
    DGT_CHECK(is_inside(diagnostic.range));
    for (const Note& note : diagnostic.notes) DGT_CHECK(is_inside(note.range));
    if (diagnostic.fix_it) DGT_CHECK(is_inside(diagnostic.fix_it->range));
  }
}

// What is laid out once stays as it is.
void check_layout(const SourceFile& file) {
  DiagnosticBag ignored;
  const std::optional<std::string> laid_out = language::format(file, ignored);
  if (!laid_out) return;
  const SourceFile again("f.bgt", *laid_out, Encoding::Utf8);
  DGT_CHECK(language::format(again, ignored) == laid_out);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  const std::string_view text = cut_part(rest);
  const std::string_view macro = cut_part(rest);
  const SourceFile file("f.bgt", text);
  PartLoader loader(macro, cut_part(rest));
  DiagnosticBag bag;
  const EvaluateOptions options = small_bounds();
  const CompileResult result = compile(file, loader, options, bag);
  DGT_CHECK(result.path.has_value() == !bag.has_errors());
  check_places(bag);
  (void)render(bag, {Language::English, Colour::Plain});
  (void)render(bag, {Language::Russian, Colour::Ansi});
  (void)language::print_words(file);
  (void)language::print_syntax(file);
  if (result.path) (void)to_text(*result.path);
  (void)apply_fixes(file, bag);
  check_layout(file);
  return 0;
}
