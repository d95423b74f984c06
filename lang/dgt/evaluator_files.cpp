// SPDX-License-Identifier: GPL-3.0-or-later
//
// MAC and OPR: other files, executed with the names of the program.
#include <algorithm>

#include "lang/dgt/evaluator.h"
#include "lang/dgt/parser.h"
#include "lang/text/encoding.h"
#include "lang/text/look_alike.h"

namespace dgt::language {

std::shared_ptr<const Program> Evaluator::read(SourceText text) {
  auto file = std::make_shared<const SourceFile>(std::move(text.name), text.bytes,
                                                 shared_.options.encoding);
  DiagnosticBag faults;
  auto program = std::make_shared<const Program>(parse(*file, faults));
  for (const Diagnostic& fault : faults.all()) {
    fault.severity() == Severity::Error ? shared_.report(fault) : bag_.add(fault);
  }
  files_.push_back(std::move(file));
  programs_.push_back(program);
  return program;
}

// --- macros
// ---------------------------------------------------------------------------------------

void Evaluator::execute(const MacroCall& call, bool broken) {
  const std::shared_ptr<const Program> program = broken ? nullptr : macro(call.name);
  if (!program) {
    shared_.names_missing = true;
    return;
  }
  const std::uint32_t limit = shared_.options.bounds.macro_depth;
  if (shared_.call_stack.size() > limit) return stop(Message::MacrosTooDeep, call.name, limit);
  const OffsetSide side = contours_.offset_side();
  shared_.call_stack.push_back(program->file);
  set_arguments(call);
  shared_.expansion.push(Message::InMacro, call.name, std::string(call.name.text()));
  execute(*program);
  contours_.end();
  contour_ended_.reset();
  shared_.expansion.pop();
  contours_.set_offset_side(side);  // a directive in a macro is the macro's own
  shared_.call_stack.pop_back();
}

// Read once, however often it is called.
std::shared_ptr<const Program> Evaluator::macro(const Range& name) {
  const std::string key = fold_case(name.text());
  const auto known = macros_.find(key);
  if (known != macros_.end() && known->second) return known->second;
  std::optional<SourceText> text = load_macro(name);
  if (!text) {
    report_name(Message::NoSuchMacro, name);
    return macros_[key] = nullptr;
  }
  shared_.expansion.push(Message::InMacro, name, std::string(name.text()));
  macros_[key] = read(*std::move(text));
  shared_.expansion.pop();
  return macros_[key];
}

// A name that was typed in the Russian layout by half is taken for the Latin one, when there is
// nothing under it as written.
std::optional<SourceText> Evaluator::load_macro(const Range& name) {
  const std::string written(name.text());
  std::optional<SourceText> text = loader_.load_macro(written);
  const std::string latin = latin_look_alike(written);
  if (text || latin == written) return text;
  text = loader_.load_macro(latin);
  if (text) {
    shared_.report({Message::LookAlike, name, {written, latin}, {}, FixIt{name, latin}});
  }
  return text;
}

void Evaluator::report_name(Message not_found, const Range& name) {
  const std::string_view written = name.text();
  const std::size_t end = written.find_first_of("(,;=", 1);
  const std::string meant(written.substr(0, end));
  const std::string folded = fold_case(meant);
  if (end != std::string_view::npos) {
    return shared_.report({Message::NameRunsOn, name, {std::string(written), meant}});
  }
  if (folded.size() > 4 && (folded.ends_with(".mac") || folded.ends_with(".bgt"))) {
    const std::string bare = meant.substr(0, meant.size() - 4);
    return shared_.report({Message::NameWithExtension, name, {bare}, {}, FixIt{name, bare}});
  }
  shared_.report({not_found, name, {meant}});
}

// All arguments are worked out before the first is set, since they may be variables themselves.
void Evaluator::set_arguments(const MacroCall& call) {
  std::vector<std::optional<Rational>> values;
  for (const MacroCall::Argument& argument : call.arguments) {
    values.push_back(shared_.variables.value(argument.number));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    set_number(static_cast<int>(i) + 1, std::move(values[i]), call.arguments[i].range);
  }
}

// --- definition files
// -----------------------------------------------------------------------------

void Evaluator::execute(const DefinitionFile& file, bool broken) {
  std::optional<SourceText> text;
  if (!broken && !loader_.has_folder()) {
    shared_.report({Message::UnsavedProgram, file.name, {}});
  } else if (!broken) {
    text = loader_.load_definitions(file.name.text());
    if (!text) {
      report_name(Message::NoSuchDefinitionFile, file.name);
    }
  }
  if (text) {
    shared_.expansion.push(Message::InDefinitionFile, file.name, std::string(file.name.text()));
    run_definitions(*read(*std::move(text)));
    shared_.expansion.pop();
  } else {
    shared_.names_missing = true;
  }
}

void Evaluator::run_definitions(const Program& program) {
  shared_.definition_files.push_back(program.file);
  for (const Statement& statement : program.statements) {
    if (!count_statement(statement)) return;
    const auto* const definition = std::get_if<Definition>(&statement.body);
    if (definition != nullptr) {
      define(*definition, statement.broken, shared_);
    } else if (!statement.broken) {
      shared_.report({Message::NotADefinition, statement.range, {}});
    }
  }
}

}  // namespace dgt::language
