// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <stdexcept>

#include "apps/driver/drawing_file.h"
#include "apps/driver/file_io.h"
#include "apps/studio/drawing/drawing_panel.h"

namespace dgt::studio {
namespace {

/// What went wrong; empty: nothing did.
QString write_drawing(const Compilation& made, const std::string& name,
                      const DrawingOptions& options) {
  try {
    const auto written = write_file(name, drawing_of(made, options));
    return written ? QString() : QString::fromStdString(written.error().text());
  } catch (const std::runtime_error& fault) {
    return QString::fromUtf8(fault.what());
  }
}

}  // namespace

void DrawingPanel::save_picture() {
  if (!scene_) return;
  const QString proposed =
      QFileInfo(QString::fromStdString(scene_->part->name)).completeBaseName() +
      QStringLiteral(".png");
  const QString name = QFileDialog::getSaveFileName(this, tr("Save the drawing"), proposed,
                                                    tr("Drawings (*.png *.svg *.pdf *.dxf)"));
  if (name.isEmpty()) return;
  DrawingOptions options;
  const auto form = drawing_form(name.toStdString());
  if (!form) {
    QMessageBox::warning(this, tr("Save the drawing"),
                         tr("The name has to end in .png, .svg, .pdf or .dxf: it says what kind of "
                            "drawing is written."));
    return;
  }
  options.form = *form;
  options.names = canvas_->shown().names;
  files_.ask([this, scene = scene_, name, options]() -> Background::Outcome {
    const QString fault = write_drawing(scene->part->compilation, name.toStdString(), options);
    return [this, fault] {
      if (!fault.isEmpty()) QMessageBox::critical(this, tr("Save the drawing"), fault);
    };
  });
}

}  // namespace dgt::studio
