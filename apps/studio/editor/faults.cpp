// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/editor/faults.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace dgt::studio {
namespace {

QString qt(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

FaultPlace place_of(const Range& range, const SourceFile* program) {
  return {range.file == program ? QString() : qt(range.file->name()), range.place()};
}

Cure cure_of(const FixIt& fix) {
  const Range& range = fix.range;
  return {Range{range.file, range.begin, range.begin}.place(),
          Range{range.file, range.end, range.end}.place(), qt(range.text()), qt(fix.replacement),
          fix.certainty};
}

Fault fault_of(const Diagnostic& d, const SourceFile* program, Language language) {
  Fault fault;
  fault.severity = d.severity();
  fault.code = qt(d.code());
  fault.text = qt(text(d.message, d.arguments, language));
  fault.at = place_of(d.range, program);
  if (d.other && d.other->file == d.range.file) fault.other = d.other->place();
  for (const Note& note : d.notes) {
    fault.notes.push_back(
        {qt(text(note.message, note.arguments, language)), place_of(note.range, program)});
  }
  if (d.fix_it && d.fix_it->range.file == program) fault.cure = cure_of(*d.fix_it);
  return fault;
}

QString line_of_note(const FaultNote& note) {
  const QString where =
      note.at.file.isEmpty()
          ? QCoreApplication::translate("Faults", "line %1").arg(note.at.place.line)
          : QStringLiteral("%1:%2").arg(QFileInfo(note.at.file).fileName()).arg(note.at.place.line);
  return QStringLiteral("<br>&nbsp;• %1 (%2)")
      .arg(note.text.toHtmlEscaped(), where.toHtmlEscaped());
}

}  // namespace

std::vector<Fault> faults_of(const Compilation& made, Language language) {
  std::vector<Fault> faults;
  faults.reserve(made.bag.all().size());
  for (const Diagnostic& d : made.bag.all()) {
    faults.push_back(fault_of(d, made.file.get(), language));
  }
  return faults;
}

QString tip_of(const Fault& fault) {
  QString tip =
      QStringLiteral("<p>%1 <small>[%2]</small>").arg(fault.text.toHtmlEscaped(), fault.code);
  for (const FaultNote& note : fault.notes) tip += line_of_note(note);
  if (fault.cure) {
    const QString key = QStringLiteral("Alt+Enter");
    tip += QStringLiteral("<br>") + (fault.cure->replacement.isEmpty()
                                         ? QCoreApplication::translate("Faults", "%1: remove “%2”")
                                               .arg(key, fault.cure->was.toHtmlEscaped())
                                         : QCoreApplication::translate("Faults", "%1: write “%2”")
                                               .arg(key, fault.cure->replacement.toHtmlEscaped()));
  }
  return tip + QStringLiteral("</p>");
}

}  // namespace dgt::studio
