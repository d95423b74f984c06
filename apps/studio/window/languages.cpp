// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/languages.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <memory>
#include <vector>

namespace dgt::studio {
namespace {

using Translators = std::vector<std::unique_ptr<QTranslator>>;

Translators& installed() {
  static Translators translators;
  return translators;
}

void install(const QString& file) {
  auto translator = std::make_unique<QTranslator>();
  if (!translator->load(file)) return;
  QCoreApplication::installTranslator(translator.get());
  installed().push_back(std::move(translator));
}

}  // namespace

void use_language(Language language) {
  for (const auto& translator : installed()) {
    QCoreApplication::removeTranslator(translator.get());
  }
  installed().clear();
  // Numbers in programs have points; those of the windows go with them.
  QLocale numbers(language == Language::Russian ? QLocale::Russian : QLocale::English);
  numbers.setNumberOptions(QLocale::OmitGroupSeparator);
  QLocale::setDefault(numbers);
  if (language == Language::English) return;
  install(QLibraryInfo::path(QLibraryInfo::TranslationsPath) + QStringLiteral("/qtbase_ru.qm"));
  const QDir folder(QStringLiteral(":/translations"));
  for (const QString& file : folder.entryList({QStringLiteral("*_ru.qm")})) {
    install(folder.filePath(file));
  }
}

}  // namespace dgt::studio
