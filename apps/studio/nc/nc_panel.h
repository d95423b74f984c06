// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "apps/studio/part.h"

namespace dgt::studio {

/// The NC program of a part: its text in a dialect, to be changed by hand, proved, saved and
/// punched.
class NcPanel : public QWidget {
  Q_OBJECT

 public:
  explicit NcPanel(QWidget* parent = nullptr);
  ~NcPanel() override;

  /// The machine file that a dialect's settings come from; empty: none.
  void set_machine(const QString& file);
  /// Writes the part's text anew in the dialect that was chosen, if one was. A text that was
  /// changed by hand is written over only when the person agrees.
  void show_part(PartPtr part);
  /// Asks for the dialect; false when the person would not say.
  bool choose_dialect();
  /// Chooses without asking: a name of `dgt compile --post list`, or a dialect file.
  void set_dialect(const QString& name);
  [[nodiscard]] QString dialect() const;  ///< empty: none yet

 signals:
  /// The text as it stands, changed by hand or not, read back: to be drawn.
  void part_read(dgt::studio::PartPtr part);
  void punch_wanted(QByteArray text);
  /// A place in the part's source was asked for.
  void place_chosen(int file, int line, int column);
};

}  // namespace dgt::studio
