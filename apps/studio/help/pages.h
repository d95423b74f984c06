// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <map>
#include <vector>

#include "apps/studio/figure.h"
#include "lang/text/diagnostic.h"

/// The pages of the help: Markdown of `help/en` and `help/ru`, and what is made from the tables of
/// the language.
///
/// In them `<!-- topics A B -->` before a heading names the words that it explains, `<!-- sample
/// NAME -->` stands for a program of `help/samples.md` and its drawing, `<!-- generated dialects
/// -->` for the table of the dialects.
namespace dgt::studio {

/// A heading and what stands below it.
struct HelpSection {
  int level = 1;  ///< of the heading
  QString title;
  QStringList topics;
  QString text;  ///< Markdown, to be searched
};

struct HelpPage {
  QString markdown;                   ///< figures are images `figure:NAME`
  std::vector<HelpSection> sections;  ///< in the order of their headings; the first is the page's

  [[nodiscard]] const QString& title() const { return sections.front().title; }
};

/// A place in the help.
struct HelpPlace {
  std::size_t page = 0;
  std::size_t section = 0;

  friend bool operator==(const HelpPlace&, const HelpPlace&) = default;
};

struct HelpBook {
  std::vector<HelpPage> pages;
  std::map<QString, Figure> figures;  ///< by their names

  /// Where a word, a form or a message is explained: `FOR`, `L=PC`, `DGT0203`. Of an element with
  /// its number the letter counts.
  [[nodiscard]] std::optional<HelpPlace> place_of(const QString& word) const;
};

[[nodiscard]] HelpBook help_book(Language language);

/// The programs of `help/samples.md` by their names.
[[nodiscard]] std::map<QString, Figure> help_samples();

}  // namespace dgt::studio
