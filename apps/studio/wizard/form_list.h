// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QListWidget>

namespace dgt::studio {

/// Pictures with a caption each, beside and below each other; one is chosen by a click, or by the
/// arrow keys and Enter or the space bar.
class FormList : public QListWidget {
  Q_OBJECT

 public:
  explicit FormList(QWidget* parent = nullptr);

  void add(const QString& caption);
  void set_tip(int row, const QString& tip);
  void set_picture(int row, const QImage& picture);
  /// In pixels of the style, before the ratio of the screen.
  [[nodiscard]] QSize picture_size() const;

 signals:
  void chosen(int row);     ///< by a click
  void confirmed(int row);  ///< by a key

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void measure();
};

}  // namespace dgt::studio
