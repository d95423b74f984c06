// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCompleter>
#include <QObject>
#include <QStandardItemModel>
#include <vector>

#include "apps/studio/part.h"

class QKeyEvent;

namespace dgt::studio {

class SourceEditor;

/// What may be written behind the text before the cursor.
struct Proposal {
  QString whole;     ///< as it will stand: `C12`
  QString inserted;  ///< what has to be typed for it
  QString note;      ///< how it is defined, or the guide's pattern
};

/// The proposals for a line up to the cursor. `part` may be null: nothing is defined.
///  * On an empty line, or behind the beginning of a word: operators, commands and definitions with
///    the next free number.
///  * Behind `L1=` the forms that take what is written already: their letters.
///  * Behind L, C, P, O and a part of a number: the elements that are defined.
[[nodiscard]] std::vector<Proposal> proposals_for(const QString& before, const Part* part);

/// The list of proposals at the cursor of an editor. It opens by itself behind a letter of an
/// element; the arrows choose, Tab or Enter takes.
class Completion : public QObject {
  Q_OBJECT

 public:
  explicit Completion(SourceEditor* editor);

  void set_part(PartPtr part) { part_ = std::move(part); }
  void offer();
  /// Whether the key was for the list.
  bool takes(QKeyEvent* event);
  /// The list goes with what has been typed.
  void follow(const QKeyEvent* event);

 private:
  void show(const std::vector<Proposal>& proposals);
  void take(const QModelIndex& index);

  SourceEditor* editor_;
  QStandardItemModel model_;
  QCompleter list_;
  PartPtr part_;
};

}  // namespace dgt::studio
