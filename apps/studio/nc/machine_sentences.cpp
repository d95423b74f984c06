// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/nc/machine_sentences.h"

#include <QCoreApplication>

namespace dgt::studio {
namespace {

/// The context of the sentences.
struct Sentences {
  Q_DECLARE_TR_FUNCTIONS(MachineSentences)
};

QString qt(const std::string& text) { return QString::fromStdString(text); }

QString sentence(const SettingFault& fault) {
  switch (fault.kind) {
    case SettingFault::Kind::NoValue:
      return Sentences::tr("“%1” sets nothing; a setting is written key=value.").arg(qt(fault.key));
    case SettingFault::Kind::UnknownKey:
      return Sentences::tr("There is no setting “%1”; the nearest is “%2”.")
          .arg(qt(fault.key), qt(fault.nearest));
    case SettingFault::Kind::BadValue:
      break;
  }
  return Sentences::tr("The setting “%1” cannot be “%2”; it takes %3.")
      .arg(qt(fault.key), qt(fault.value), qt(fault.expected));
}

}  // namespace

QString sentence_of(const MachineFault& fault) {
  if (const auto* file = std::get_if<FileError>(&fault)) return qt(file->text());
  if (const auto* setting = std::get_if<SettingFault>(&fault)) return sentence(*setting);
  if (const auto* dialect = std::get_if<UnknownDialect>(&fault))
    return Sentences::tr("There is no dialect “%1”.").arg(qt(dialect->name));
  return {};
}

std::vector<Fault> messages_of(const SettledMachine& machine, Language language) {
  std::vector<Fault> faults;
  for (const MachineMessages& messages : machine.messages) {
    Compilation told;  // its places are those of another file
    told.bag = messages.bag;
    for (Fault& fault : faults_of(told, language)) faults.push_back(std::move(fault));
  }
  return faults;
}

}  // namespace dgt::studio
