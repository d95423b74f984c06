// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/figure.h"

#include <optional>

#include "apps/driver/names.h"
#include "apps/driver/picture.h"
#include "lang/dgt/loader.h"

namespace dgt::studio {
namespace {

/// Files that are nowhere but here.
class FilesAtHand : public SourceLoader {
 public:
  explicit FilesAtHand(const std::map<std::string, std::string>& files) : files_(files) {}
  std::optional<SourceText> load_macro(std::string_view name) override { return load(name); }
  std::optional<SourceText> load_definitions(std::string_view name) override { return load(name); }
  [[nodiscard]] bool has_folder() const override { return true; }

 private:
  [[nodiscard]] std::optional<SourceText> load(std::string_view name) const {
    const auto found = files_.find(std::string(name));
    if (found == files_.end()) return std::nullopt;
    return SourceText{found->first, found->second};
  }
  const std::map<std::string, std::string>& files_;
};

Compilation compiled(const Figure& figure) {
  Compilation made;
  made.file = decode_source("figure.bgt", figure.program, Encoding::Utf8);
  FilesAtHand files(figure.files);
  made.result = compile(*made.file, files, {}, made.bag);
  return made;
}

std::vector<NamedShape> shapes_of(const Figure& figure, const Compilation& made) {
  std::vector<NamedShape> shapes;
  if (figure.axes) shapes.push_back({"0", NamedAxes{}});
  for (NamedShape& shape : names_of(made)) {
    shape.lit = shape.name == figure.lit;
    const auto called = figure.called.find(shape.name);
    if (called != figure.called.end()) shape.name = called->second;
    shapes.push_back(std::move(shape));
  }
  for (const FigureNote& note : figure.notes)
    shapes.push_back({note.text, NamedSpot{note.x, note.y, false}});
  return shapes;
}

std::string css(const QColor& colour) { return colour.name().toStdString(); }

}  // namespace

DrawingStyle figure_style(const Colours& colours, double pixels) {
  DrawingStyle style;
  style.background = css(colours.sheet);
  style.programmed = css(colours.programmed);
  style.equidistant = css(colours.equidistant);
  style.rapid = css(colours.rapid);
  style.start = css(colours.points);
  style.named = css(colours.axes);
  style.letters = css(colours.points);
  style.named_width = 1;
  style.margin_named = 0.16;
  style.size = pixels;
  return style;
}

QImage draw_figure(const Figure& figure, const DrawingStyle& style, double ratio) {
  const Compilation made = compiled(figure);
  if (!made.result.path) return {};
  DrawingStyle scaled = style;
  for (double* const length :
       {&scaled.programmed_width, &scaled.equidistant_width, &scaled.rapid_width,
        &scaled.rapid_dash, &scaled.start_width, &scaled.named_width, &scaled.arrow_width,
        &scaled.dot_width, &scaled.letters_height, &scaled.size}) {
    *length *= ratio;
  }
  const std::string png = png_of(draw_svg(*made.result.path, scaled, shapes_of(figure, made)));
  QImage image = QImage::fromData(QByteArray::fromStdString(png), "PNG");
  image.setDevicePixelRatio(ratio);
  return image;
}

}  // namespace dgt::studio
