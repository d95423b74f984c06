// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/nc/dialect_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "apps/driver/settings.h"
#include "apps/studio/language.h"

namespace dgt::studio {
namespace {

constexpr int kDialect = Qt::UserRole;
constexpr int kIsFile = Qt::UserRole + 1;
constexpr int kLettersWide = 96;
constexpr int kRows = 12;

QString about(const Dialect& dialect) {
  return QString::fromStdString(message_language() == Language::Russian ? dialect.about_ru
                                                                        : dialect.about);
}

}  // namespace

DialectDialog::DialectDialog(const QString& chosen, const QStringList& own, QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(tr("NC program for which control?"));
  auto* column = new QVBoxLayout(this);
  list_ = new QTreeWidget(this);
  list_->setObjectName(QStringLiteral("dialects"));
  list_->setColumnCount(2);
  list_->setHeaderLabels({tr("Dialect"), tr("What it is")});
  list_->setRootIsDecorated(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  list_->setMinimumSize(fontMetrics().horizontalAdvance(u'x') * kLettersWide,
                        fontMetrics().lineSpacing() * kRows);
  column->addWidget(list_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  ok_ = buttons->addButton(tr("&Write"), QDialogButtonBox::AcceptRole);
  QPushButton* const file =
      buttons->addButton(tr("&Own dialect file…"), QDialogButtonBox::ActionRole);
  file->setToolTip(tr("A TOML file that says how a control wants its programs"));
  column->addWidget(buttons);
  for (const Dialect& dialect : dialects()) {
    const QString name = QString::fromStdString(dialect.name);
    add(name, name, about(dialect));
  }
  for (const QString& name : own) add_file(name);
  if (!chosen.isEmpty() && QFileInfo(chosen).isFile()) add_file(chosen);
  mark(chosen);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(file, &QPushButton::clicked, this, &DialectDialog::ask_for_file);
  connect(list_, &QTreeWidget::itemActivated, this, &QDialog::accept);
  ok_->setDefault(true);
  list_->setFocus();
}

QTreeWidgetItem* DialectDialog::add(const QString& dialect, const QString& name,
                                    const QString& what) {
  auto* item = new QTreeWidgetItem(list_, {name, what});
  QFont bold = item->font(0);
  bold.setBold(true);
  item->setFont(0, bold);
  item->setData(0, kDialect, dialect);
  item->setToolTip(1, what);
  return item;
}

QTreeWidgetItem* DialectDialog::add_file(const QString& file) {
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* const item = list_->topLevelItem(i);
    if (item->data(0, kDialect) == file) return item;
  }
  const auto read = read_dialect_file(file.toStdString());
  const QString what = read ? about(read->dialect) : QString::fromStdString(read.error().text());
  QTreeWidgetItem* const item = add(file, QFileInfo(file).fileName(), what.isEmpty() ? file : what);
  item->setData(0, kIsFile, true);
  item->setToolTip(0, file);
  return item;
}

void DialectDialog::ask_for_file() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Dialect file"), QFileInfo(dialect()).path(),
                                   tr("Dialects (*.toml);;All files (*)"));
  if (!file.isEmpty()) list_->setCurrentItem(add_file(file));
}

void DialectDialog::mark(const QString& dialect) {
  list_->setCurrentItem(list_->topLevelItem(0));
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* const item = list_->topLevelItem(i);
    if (item->data(0, kDialect) == dialect) list_->setCurrentItem(item);
  }
}

QString DialectDialog::dialect() const {
  const QTreeWidgetItem* const item = list_->currentItem();
  return item == nullptr ? QString() : item->data(0, kDialect).toString();
}

QStringList DialectDialog::own_files() const {
  QStringList files;
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    const QTreeWidgetItem* const item = list_->topLevelItem(i);
    if (item->data(0, kIsFile).toBool()) files << item->data(0, kDialect).toString();
  }
  return files;
}

}  // namespace dgt::studio
