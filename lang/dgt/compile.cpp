// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/compile.h"

#include "lang/dgt/crossing_messages.h"
#include "lang/dgt/evaluator.h"
#include "lang/dgt/parser.h"

namespace dgt {

CompileResult compile(const SourceFile& file, SourceLoader& loader, const EvaluateOptions& options,
                      DiagnosticBag& bag) {
  CompileResult result;
  language::ProgramReader program(file, bag);
  language::Evaluator evaluator(loader, options, bag);
  Toolpath path = evaluator.run(program);
  result.elements = evaluator.elements();
  result.files = evaluator.files();
  if (!bag.has_errors()) {
    if (evaluator.keeps_moves()) {
      language::report_crossings(path, options, {&file, result.files}, bag);
    } else if (options.crossings != CrossingMoves::None) {
      bag.add({Message::CrossingsNotSought, {&file, 0, 0}, {std::to_string(kMovesLookedOver)}});
    }
  }
  if (options.purpose == Purpose::Check) path = {};
  bag.sort(&file);
  if (!bag.has_errors()) result.path = std::move(path);
  return result;
}

}  // namespace dgt
