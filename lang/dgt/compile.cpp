// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/compile.h"

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
  bag.sort(&file);
  if (!bag.has_errors()) result.path = std::move(path);
  return result;
}

}  // namespace dgt
