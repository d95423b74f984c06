// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "apps/studio/wizard/definition_forms.h"
#include "lang/dgt/forms.h"
#include "lang/dgt/parser.h"
#include "tests/studio/qt_values.h"

namespace dgt::studio {
namespace {

std::string letters_of(const language::Definition& definition) {
  std::string letters;
  for (const language::Item& operand : definition.operands) letters += operand.letter;
  return letters;
}

TEST(WizardForms, EveryFormOfTheLanguageHasAnExampleOfItself) {
  const std::vector<DefinitionForm> forms = definition_forms();
  for (const language::Form& wanted : language::all_forms()) {
    bool found = false;
    for (const DefinitionForm& form : forms) {
      const SourceFile file("line.bgt", form.example(), Encoding::Utf8);
      DiagnosticBag bag;
      const language::Program program = language::parse(file, bag);
      ASSERT_FALSE(bag.has_errors()) << form.example();
      const auto& definition = std::get<language::Definition>(program.statements.at(0).body);
      const auto match = language::match_form(definition.kind, letters_of(definition));
      ASSERT_TRUE(match.has_value()) << form.example();
      found = found || match->form == &wanted;
    }
    EXPECT_TRUE(found) << wanted.pattern;
  }
}

TEST(WizardForms, EveryFormHasAPicture) {
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    const DrawingStyle style = figure_style(standard_colours(theme), 120);
    for (const DefinitionForm& form : definition_forms()) {
      const QImage picture = draw_figure(form.figure, style);
      ASSERT_FALSE(picture.isNull()) << form.pattern;
      const QColor lit = standard_colours(theme).programmed;
      int pixels = 0;
      for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) pixels += picture.pixelColor(x, y) == lit;
      }
      // What the form defines is to be seen; a coordinate system is a pair of arrows.
      EXPECT_TRUE(form.kind() == 'O' || pixels > 8) << form.pattern;
    }
  }
}

TEST(WizardForms, EveryFormSaysWhatItMakes) {
  for (const DefinitionForm& form : definition_forms()) {
    EXPECT_FALSE(form.description.isEmpty()) << form.pattern;
  }
}

}  // namespace
}  // namespace dgt::studio
