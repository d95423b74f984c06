// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/editor/fault_list.h"

#include <QEvent>
#include <QFileInfo>
#include <QHeaderView>

#include "apps/studio/window/icons.h"

namespace dgt::studio {
namespace {

constexpr int kKind = Qt::UserRole;  // what a row is, and of which fault
constexpr int kFault = Qt::UserRole + 1;
constexpr int kFile = Qt::UserRole + 2;
constexpr int kLine = Qt::UserRole + 3;
constexpr int kColumn = Qt::UserRole + 4;

enum Row { FaultRow, NoteRow, CureRow };

QIcon icon_of(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return sign_icon(QStringLiteral("error"), &Colours::error);
    case Severity::Warning:
      return sign_icon(QStringLiteral("warning"), &Colours::warning);
    case Severity::Note:
      break;
  }
  return sign_icon(QStringLiteral("note"), &Colours::note);
}

void set_place(QTreeWidgetItem* item, const FaultPlace& at) {
  item->setData(0, kFile, at.file);
  item->setData(0, kLine, at.place.line);
  item->setData(0, kColumn, at.place.column);
  const QString line = QString::number(at.place.line);
  item->setText(1, at.file.isEmpty() ? line : QFileInfo(at.file).fileName() + u':' + line);
}

}  // namespace

FaultList::FaultList(QWidget* parent) : QTreeWidget(parent) {
  setObjectName(QStringLiteral("faults"));
  setColumnCount(3);
  setUniformRowHeights(true);
  setAllColumnsShowFocus(true);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  connect(this, &QTreeWidget::itemClicked, this, [this](const QTreeWidgetItem* item) {
    if (item->data(0, kKind).toInt() != CureRow) go_to(item);  // a cure takes Enter or two clicks
  });
  connect(this, &QTreeWidget::itemActivated, this, &FaultList::go_to);
  retranslate();
}

void FaultList::retranslate() { setHeaderLabels({tr("Message"), tr("Line"), tr("Code")}); }

void FaultList::show_faults(const std::vector<Fault>& faults) {
  clear();
  for (std::size_t i = 0; i < faults.size(); ++i) add(faults[i], static_cast<int>(i));
}

void FaultList::add(const Fault& fault, int index) {
  auto* const item = new QTreeWidgetItem(this, {fault.text, QString(), fault.code});
  item->setIcon(0, icon_of(fault.severity));
  item->setToolTip(0, tip_of(fault));
  item->setData(0, kKind, FaultRow);
  item->setData(0, kFault, index);
  set_place(item, fault.at);
  for (const FaultNote& note : fault.notes) {
    auto* const row = new QTreeWidgetItem(item, {note.text});
    row->setIcon(0, icon_of(Severity::Note));
    row->setData(0, kKind, NoteRow);
    set_place(row, note.at);
  }
  if (fault.cure) {
    auto* const row = new QTreeWidgetItem(
        item, {fault.cure->replacement.isEmpty() ? tr("Remove “%1”").arg(fault.cure->was)
                                                 : tr("Write “%1”").arg(fault.cure->replacement)});
    row->setIcon(0, icon(QStringLiteral("cure")));
    row->setData(0, kKind, CureRow);
    row->setData(0, kFault, index);
  }
}

void FaultList::choose(int fault) {
  QTreeWidgetItem* const item = topLevelItem(fault);
  if (item == nullptr) return;
  setCurrentItem(item);
  item->setExpanded(true);
  scrollToItem(item);
}

void FaultList::go_to(const QTreeWidgetItem* item) {
  const int kind = item->data(0, kKind).toInt();
  const QString file = item->data(0, kFile).toString();
  if (kind == CureRow) {
    emit cure_chosen(item->data(0, kFault).toInt());
  } else if (kind == FaultRow && file.isEmpty()) {
    emit fault_chosen(item->data(0, kFault).toInt());
  } else {
    emit place_chosen(file, item->data(0, kLine).toInt(), item->data(0, kColumn).toInt());
  }
}

void FaultList::changeEvent(QEvent* event) {
  QTreeWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace dgt::studio
