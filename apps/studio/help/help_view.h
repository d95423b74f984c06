// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QTextBrowser>
#include <map>

namespace dgt::studio {

/// A page of the help as it is read: Markdown with figures.
class HelpView : public QTextBrowser {
  Q_OBJECT

 public:
  explicit HelpView(QWidget* parent = nullptr);

  void show_page(const QString& markdown);
  /// Figures that have been drawn; the page is shown again and stays where it is.
  void set_figures(std::map<QString, QImage> figures);
  [[nodiscard]] bool has_figure(const QString& name) const { return figures_.contains(name); }
  void forget_figures() { figures_.clear(); }
  /// To the heading of that number.
  void go_to_heading(std::size_t heading);

 protected:
  QVariant loadResource(int type, const QUrl& name) override;

 private:
  void set_page();

  QString markdown_;
  std::map<QString, QImage> figures_;
};

}  // namespace dgt::studio
