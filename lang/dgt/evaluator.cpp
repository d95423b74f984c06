// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/evaluator.h"

#include "kernel/check.h"
#include "lang/text/encoding.h"

namespace dgt::language {
namespace {

template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

}  // namespace

Toolpath Evaluator::run(ProgramReader& program) {
  shared_.call_stack = {&program.file()};
  std::size_t pieces = 0;
  for (Program piece; program.next(piece); forget_splices(piece)) {
    const OnProgress& told = shared_.options.on_progress;
    if (told && ++pieces % kProgressStep == 0 && !piece.statements.empty())
      told(piece.statements.front().range.begin, program.file().text().size());
    if (!stopped_) execute(piece);  // what comes after a stop is still parsed, for its faults
  }
  return contours_.finish();
}

void Evaluator::forget_splices(const Program& program) {
  for (const Statement& statement : program.statements) {
    if (const auto* const line = std::get_if<SplicedLine>(&statement.body)) splices_.erase(line);
  }
}

void Evaluator::execute(const Program& program) {
  std::vector<Loop> loops;
  for (std::size_t at = 0; at < program.statements.size() && !stopped_;) {
    if (!count_statement(program.statements[at])) break;
    at = step(program, at, loops);
    stopped_ = stopped_ || contours_.is_over_limit();
  }
  for (; !loops.empty(); loops.pop_back()) {
    shared_.expansion.pop();
    --loop_depth_;
  }
}

void Evaluator::stop(Message message, const Range& range, std::uint64_t limit) {
  shared_.report({message, range, {std::to_string(limit)}});
  stopped_ = true;
}

bool Evaluator::count_statement(const Statement& statement) {
  const std::uint64_t limit = shared_.options.bounds.statements;
  if (++executed_ > limit) stop(Message::TooManyStatements, statement.range, limit);
  return !stopped_;
}

// --- loops
// ----------------------------------------------------------------------------------------

std::size_t Evaluator::step(const Program& program, std::size_t at, std::vector<Loop>& loops) {
  const Statement& statement = program.statements[at];
  if (std::holds_alternative<ForLoop>(statement.body)) {
    return enter_loop(program, at, loops);
  }
  if (std::holds_alternative<LoopEnd>(statement.body)) {
    DGT_CHECK(!loops.empty());
    if (--loops.back().remaining > 0) {
      shared_.expansion.next_round();
      return loops.back().begin + 1;
    }
    loops.pop_back();
    shared_.expansion.pop();
    --loop_depth_;
    return at + 1;
  }
  execute_simple(statement);
  return at + 1;
}

std::size_t Evaluator::enter_loop(const Program& program, std::size_t at,
                                  std::vector<Loop>& loops) {
  const Statement& statement = program.statements[at];
  const ForLoop& loop = std::get<ForLoop>(statement.body);
  if (loop.end == at) return at + 1;  // it has no NEXT, which has been reported
  Integer rounds = rounds_of(loop, statement.broken);
  if (rounds == 0) {
    check_skipped(std::span(program.statements).subspan(at + 1, loop.end - at - 1));
    return loop.end + 1;
  }
  const std::uint32_t limit = shared_.options.bounds.loop_depth;
  if (loop_depth_ == limit) stop(Message::LoopsTooDeep, statement.range, limit);
  ++loop_depth_;
  loops.push_back({at, std::move(rounds)});
  shared_.expansion.push_loop(statement.range);
  return at + 1;
}

// A loop whose number of rounds is unknown runs once, so that its body is checked.
Integer Evaluator::rounds_of(const ForLoop& loop, bool broken) {
  if (broken) return 1;
  const std::optional<Rational> count = shared_.variables.value(loop.count);
  if (!count) return 1;
  if (count->get_den() == 1 && sgn(*count) >= 0) return count->get_num();
  shared_.report({Message::BadLoopCount, loop.count_range, {to_short_decimal(*count)}});
  return 1;
}

// --- statements
// -----------------------------------------------------------------------------------

void Evaluator::execute_simple(const Statement& statement) {
  std::visit(Overloaded{[&](const Definition& definition) {
                          end_contour(statement.range);
                          define(definition, statement.broken, shared_);
                        },
                        [&](const NumberAssignment& a) { execute(a, statement); },
                        [&](const TextAssignment& a) { execute(a, statement.broken); },
                        [&](const ContourStart& s) { execute(s, statement.broken); },
                        [&](const ItemLine& line) { execute(line, statement); },
                        [&](const MacroCall& call) {
                          end_contour(statement.range);
                          execute(call, statement.broken);
                        },
                        [&](const DefinitionFile& file) {
                          end_contour(statement.range);
                          execute(file, statement.broken);
                        },
                        [&](const SplicedLine& line) { execute(line, statement); },
                        [&](const Directive& directive) { execute(directive); },
                        [](const ForLoop&) {}, [](const LoopEnd&) {}},
             statement.body);
}

void Evaluator::end_contour(const Range& by) {
  if (contours_.is_open() && contours_.has_beginning()) contour_ended_ = by;
  contours_.end();
}

void Evaluator::execute(const ContourStart& start, bool broken) {
  contour_ended_.reset();
  const std::optional<ElementName> name =
      start.target.letter == 0 ? std::nullopt : shared_.name_of(start.target);
  const Range range = start.target.range;
  contours_.start(name ? static_cast<unsigned>(name->number) : 0, range);
  if (broken || !name) contours_.mark_broken();
  contours_.take(start.items);
}

// A line without a comma ends the contour and holds words that act at once; a line with one goes on
// with the contour.
void Evaluator::execute(const ItemLine& line, const Statement& statement) {
  if (statement.broken && contours_.is_open()) {  // most likely meant for it
    contours_.mark_broken();
    contours_.take(line.items);
    return;
  }
  const bool words = ContourWriter::are_words(line.items);
  if (words && (!line.has_comma || !contours_.is_open())) {
    end_contour(statement.range);
    contours_.act(line.items, statement.broken);
    return;
  }
  if (!contours_.is_open()) {
    if (report_missing_equals(line)) return;
    // Of a G that is not known or lacks its point that will be told.
    const bool is_g =
        !line.items.empty() && line.items.front().letter == 'G' &&
        (line.items.front().number.is_variable() || line.items.front().number.whole != 0);
    if (!line.items.empty() && !is_g && !statement.broken) {
      const Range range = line.items.front().range;
      Diagnostic fault{Message::NoOpenContour, range, {std::string(range.text())}};
      if (contour_ended_) fault.notes.push_back({Message::ContourEndedHere, *contour_ended_, {}});
      shared_.report(std::move(fault));
    }
    contours_.start_broken(statement.range);
  } else if (!line.has_comma && contours_.has_beginning()) {
    const Range last = line.items.back().range;
    shared_.report({Message::LineWithoutComma, statement.range, {}, {}, FixIt{behind(last), ","}});
    contours_.mark_broken();
  }
  contours_.take(line.items);
}

// `C1 X5 Y5 R2` where no contour is open and C1 not defined.
bool Evaluator::report_missing_equals(const ItemLine& line) {
  if (line.items.empty()) return false;
  const Item& target = line.items.front();
  const bool may_be_defined =
      std::string_view("LCPO").find(target.letter) != std::string_view::npos &&
      !target.is_inline_point && target.number.form == NumberForm::Decimal && !target.number.minus;
  if (!may_be_defined || shared_.elements.is_known(target.letter, target.number.whole))
    return false;
  std::string letters;
  for (const Item& item : line.items) letters += item.letter;
  const auto kind = static_cast<ElementKind>(target.letter);
  if (!match_form(kind, std::string_view(letters).substr(1))) return false;
  shared_.report({Message::MissingEquals,
                  target.range,
                  {std::string(target.range.text())},
                  {},
                  FixIt{behind(target.range), "="}});
  shared_.elements.at(kind, target.number.whole).state = ElementEntry::State::Unknown;
  return true;
}

void Evaluator::execute(const Directive& directive) {
  if (fold_case(directive.key.text()) != "offset-side") {
    shared_.report({Message::UnknownDirective, directive.key, {std::string(directive.key.text())}});
    return;
  }
  const std::string value = fold_case(directive.value.text());
  if (value == "left") {
    contours_.set_offset_side(OffsetSide::Left);
  } else if (value == "right") {
    contours_.set_offset_side(OffsetSide::Right);
  } else if (value == "auto") {
    contours_.set_offset_side(OffsetSide::Auto);
  } else if (value.empty()) {
    shared_.report({Message::OffsetSideLacking, directive.key, {}});
  } else {
    shared_.report(
        {Message::BadOffsetSide, directive.value, {std::string(directive.value.text())}});
  }
}

}  // namespace dgt::language
