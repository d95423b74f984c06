// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/icons.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

namespace dgt::studio {
namespace {

/// Disabled icons are the text's, dim.
QByteArray coloured(QByteArray picture, QIcon::Mode mode, QColor Colours::*colour) {
  const QPalette palette = QApplication::palette();
  const bool disabled = mode == QIcon::Disabled;
  const auto group = disabled ? QPalette::Disabled : QPalette::Active;
  const QColor text = palette.color(group, QPalette::ButtonText);
  const auto put = [&](const char* sign, const QColor& own) {
    picture.replace(QByteArray("\"") + sign + '"',
                    '"' + (disabled ? text : own).name().toLatin1() + '"');
  };
  put("#000", colour != nullptr ? colours().*colour : text);
  put("#00f", palette.color(QPalette::Link));
  put("#0a0", colours().programmed);
  put("#fb0", colours().equidistant);
  put("#f00", colours().tool);
  return picture;
}

class PictureEngine : public QIconEngine {
 public:
  PictureEngine(QByteArray picture, QColor Colours::*colour)
      : picture_(std::move(picture)), colour_(colour) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    QSvgRenderer renderer(coloured(picture_, mode, colour_));
    renderer.render(painter, rect);
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return pixmap;
  }
  [[nodiscard]] QIconEngine* clone() const override { return new PictureEngine(*this); }

 private:
  QByteArray picture_;
  QColor Colours::*colour_;
};

}  // namespace

QIcon icon(const QString& name) { return sign_icon(name, nullptr); }

QIcon sign_icon(const QString& name, QColor Colours::*colour) {
  QFile file(QStringLiteral(":/studio/window/icons/%1.svg").arg(name));
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QIcon(new PictureEngine(file.readAll(), colour));
}

}  // namespace dgt::studio
