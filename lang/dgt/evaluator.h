// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "lang/dgt/contour_writer.h"
#include "lang/dgt/evaluation.h"
#include "lang/dgt/loader.h"
#include "lang/dgt/parser.h"

namespace dgt::language {

/// Executes a program: statement by statement, through loops, macros and definition files.
class Evaluator {
 public:
  Evaluator(SourceLoader& loader, const EvaluateOptions& options, DiagnosticBag& bag)
      : loader_(loader), bag_(bag), shared_(options, bag), contours_(shared_) {}

  /// Runs the program to its end and gives its path, of use when no error was reported.
  [[nodiscard]] Toolpath run(ProgramReader& program);

  [[nodiscard]] const ElementTable& elements() const { return shared_.elements; }
  /// Whether the path has all its moves; see Purpose::Check.
  [[nodiscard]] bool keeps_moves() const { return contours_.keeps_moves(); }
  /// The files read on the way.
  [[nodiscard]] const std::vector<std::shared_ptr<const SourceFile>>& files() const {
    return files_;
  }

 private:
  /// A loop under way in the program being executed.
  struct Loop {
    std::size_t begin = 0;
    Integer remaining;  ///< rounds, this one included
  };
  /// A spliced line with the texts it was last put together from.
  struct Splice {
    std::vector<Variables::TextWords> texts;
    std::shared_ptr<const Statement> statement;
  };

  // evaluator.cpp
  void execute(const Program& program);
  void forget_splices(const Program& program);
  [[nodiscard]] bool count_statement(const Statement& statement);
  /// Where to go on after the statement at `at`.
  [[nodiscard]] std::size_t step(const Program& program, std::size_t at, std::vector<Loop>& loops);
  [[nodiscard]] std::size_t enter_loop(const Program& program, std::size_t at,
                                       std::vector<Loop>& loops);
  [[nodiscard]] Integer rounds_of(const ForLoop& loop, bool broken);
  void execute_simple(const Statement& statement);
  void execute(const ContourStart& start, bool broken);
  void execute(const ItemLine& line, const Statement& statement);
  void execute(const Directive& directive);
  [[nodiscard]] bool report_missing_equals(const ItemLine& line);
  void stop(Message message, const Range& range, std::uint64_t limit);
  /// Ends the open contour because of what stands at `by`.
  void end_contour(const Range& by);

  // evaluator_skipped.cpp
  void check_skipped(std::span<const Statement> body);

  // evaluator_values.cpp
  void execute(const NumberAssignment& assignment, const Statement& statement);
  [[nodiscard]] std::optional<Rational> evaluate(const NumberAssignment& assignment);
  void set_number(int index, std::optional<Rational> value, const Range& place);
  void execute(const TextAssignment& assignment, bool broken);
  void execute(const SplicedLine& line, const Statement& statement);
  [[nodiscard]] std::optional<int> text_index(const Word& word);
  void report_division(const NumberAssignment::Term& term);
  [[nodiscard]] bool holds_itself(const Word& word, int index, const std::vector<int>& path);
  /// `path`: the texts that `words` stand in, outermost first.
  [[nodiscard]] bool expand(const std::vector<Word>& words, std::vector<int>& path,
                            std::vector<Word>& out, std::vector<Variables::TextWords>& texts);

  // evaluator_files.cpp
  void execute(const MacroCall& call, bool broken);
  void execute(const DefinitionFile& file, bool broken);
  [[nodiscard]] std::shared_ptr<const Program> macro(const Range& name);
  [[nodiscard]] std::optional<SourceText> load_macro(const Range& name);
  /// Tells what is wrong with the name of a file that was not found.
  void report_name(Message not_found, const Range& name);
  [[nodiscard]] std::shared_ptr<const Program> read(SourceText text);
  void set_arguments(const MacroCall& call);
  void run_definitions(const Program& program);

  SourceLoader& loader_;
  DiagnosticBag& bag_;
  Evaluation shared_;
  ContourWriter contours_;
  std::vector<std::shared_ptr<const SourceFile>> files_;
  std::map<std::string, std::shared_ptr<const Program>, std::less<>> macros_;  // null: not found
  std::vector<std::shared_ptr<const Program>> programs_;  // keep what splices point into
  std::unordered_map<const SplicedLine*, Splice> splices_;
  std::uint64_t executed_ = 0;
  std::size_t loop_depth_ = 0;
  bool stopped_ = false;
  std::optional<Range> contour_ended_;  ///< by what, when a contour was open before
};

}  // namespace dgt::language
