// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractScrollArea>
#include <set>

#include "device/tape.h"

namespace dgt::studio {

/// A tape as it would lie on the table, in strips below each other, true to ISO 1154, each row with
/// what it says. Only what is seen is drawn, so a whole reel is no more work than a metre.
class TapeView : public QAbstractScrollArea {
  Q_OBJECT

 public:
  explicit TapeView(QWidget* parent = nullptr);

  void show_tape(Tape tape);
  /// Rows that are damaged, from 0.
  void mark(std::set<std::size_t> damaged);
  /// So many rows are done.
  void show_progress(std::size_t rows);
  void go_to_row(std::size_t row);
  [[nodiscard]] const Tape& tape() const { return tape_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool viewportEvent(QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void measure();
  void paint_strip(QPainter& painter, std::size_t first, double top) const;
  [[nodiscard]] std::size_t row_at(const QPoint& place) const;
  [[nodiscard]] double strip_height() const;

  Tape tape_;
  std::set<std::size_t> damaged_;
  std::size_t done_ = 0;
  std::size_t per_strip_ = 50;  // rows
  double scale_ = 3;            // pixels a mm
};

}  // namespace dgt::studio
