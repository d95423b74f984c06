// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/drawing_file.h"

#include <array>
#include <cctype>
#include <filesystem>
#include <utility>

#include "apps/driver/names.h"
#include "apps/driver/picture.h"
#include "post/dxf.h"

namespace dgt {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::optional<DrawingForm> drawing_form(const std::string& name) {
  constexpr std::array kForms = {
      std::pair{".svg", DrawingForm::Svg}, std::pair{".pdf", DrawingForm::Pdf},
      std::pair{".png", DrawingForm::Png}, std::pair{".dxf", DrawingForm::Dxf}};
  if (name == kStream) return DrawingForm::Svg;
  const std::string extension = lower(std::filesystem::path(name).extension().string());
  for (const auto& [ending, form] : kForms) {
    if (extension == ending) return form;
  }
  return std::nullopt;
}

std::string drawing_of(const Compilation& made, const DrawingOptions& options) {
  const Toolpath& path = *made.result.path;
  if (options.form == DrawingForm::Dxf) return draw_dxf(path);
  const std::vector<NamedShape> named = options.names ? names_of(made) : std::vector<NamedShape>();
  const std::string svg = draw_svg(path, options.style, named);
  if (options.form == DrawingForm::Pdf) return pdf_of(svg);
  return options.form == DrawingForm::Png ? png_of(svg) : svg;
}

}  // namespace dgt
