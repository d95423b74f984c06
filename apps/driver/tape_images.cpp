// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/tape_images.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <utility>

#include "apps/driver/tape_png.h"
#include "device/drawing.h"

namespace dgt {
namespace {

std::string extension_of(const std::string& name) {
  std::string extension = std::filesystem::path(name).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// The kind of a drawing, by its beginning: someone's PNG of a tape, say.
std::optional<std::string_view> drawing_in(std::string_view bytes) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kBeginnings = {
      {{"\x89PNG\r\n", "PNG"},
       {"<svg", "SVG"},
       {"<?xml", "SVG"},
       {"%PDF-", "PDF"},
       {"\xFF\xD8\xFF", "JPEG"}}};
  for (const auto& [beginning, kind] : kBeginnings)
    if (bytes.starts_with(beginning)) return kind;
  return std::nullopt;
}

}  // namespace

std::optional<TapeForm> tape_form_of(const std::string& name) {
  static constexpr std::array<std::pair<std::string_view, TapeForm>, 4> kForms = {
      {{".tap", TapeForm::Raw},
       {".txt", TapeForm::Picture},
       {".svg", TapeForm::Svg},
       {".png", TapeForm::Png}}};
  const auto form =
      std::ranges::find(kForms, extension_of(name), [](const auto& row) { return row.first; });
  return form == kForms.end() ? std::nullopt : std::optional(form->second);
}

TapeImage read_tape_image(const std::string& name, std::string_view bytes) {
  TapeImage image;
  if (const auto kind = drawing_in(bytes)) {
    image.file = std::make_shared<const SourceFile>(name, "", Encoding::Utf8);
    image.bag.add({Message::DrawingOfTape, {image.file.get(), 0, 0}, {std::string(*kind)}});
    return image;
  }
  if (!is_picture(bytes)) {
    image.tape.rows.assign(bytes.begin(), bytes.end());
    return image;
  }
  image.file = std::make_shared<const SourceFile>(name, bytes, Encoding::Utf8);
  auto tape = from_picture(image.file->text());
  if (tape) {
    image.tape = *std::move(tape);
    return image;
  }
  const Range range{image.file.get(), static_cast<std::uint32_t>(tape.error().begin),
                    static_cast<std::uint32_t>(tape.error().end)};
  image.bag.add({Message::PictureLine, range, {}});
  return image;
}

bool is_tape_image(const std::string& name, std::string_view bytes) {
  return extension_of(name) == ".tap" || is_picture(bytes);
}

tl::expected<std::string, PictureTooLarge> in_form(const Tape& tape, TapeForm form, RowRange rows) {
  const std::size_t last = std::min(rows.last, tape.rows.size());
  const std::size_t first = std::min(rows.first, last);
  switch (form) {
    case TapeForm::Raw:
    case TapeForm::Text:
      return std::string(tape.rows.begin() + static_cast<std::ptrdiff_t>(first),
                         tape.rows.begin() + static_cast<std::ptrdiff_t>(last));
    case TapeForm::Picture:
      return to_picture(tape, rows);
    case TapeForm::Svg:
      return to_svg(draw_tape(tape, rows));
    case TapeForm::Png: {
      auto png = to_png(draw_tape(tape, rows), kPixelsPerMm);
      if (!png) return tl::unexpected(PictureTooLarge{});
      return *std::move(png);
    }
  }
  return {};
}

}  // namespace dgt
