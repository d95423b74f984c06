// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/internal_text.h"

#include <QColor>
#include <algorithm>
#include <cctype>
#include <utility>

#include "apps/studio/window/theme.h"

namespace dgt::studio {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool holds(std::string_view line, std::string_view wanted) {
  const auto same = [](char a, char b) { return lower(a) == lower(b); };
  return !std::ranges::search(line, wanted, same).empty();
}

}  // namespace

// A line of a move begins with its number, and they stand in order; others tell of contours.
InternalText::InternalText(const Toolpath& path) : text_(to_text(path)) {
  std::size_t move = 0;
  for (std::size_t at = 0; at < text_.size(); at = text_.find('\n', at) + 1) {
    begins_.push_back(at);
    const bool tells_of_move = std::isdigit(static_cast<unsigned char>(text_[at])) != 0;
    sources_.push_back(tells_of_move ? path.moves[move++].source : SourcePlace{});
  }
  begins_.push_back(text_.size());
  for (std::size_t i = 0; i < lines(); ++i) longest_ = std::max(longest_, line(i).size());
}

std::string_view InternalText::line(std::size_t i) const {
  return std::string_view(text_).substr(begins_[i], begins_[i + 1] - begins_[i] - 1);
}

std::size_t InternalText::find(std::string_view wanted, std::size_t from, bool backwards) const {
  const std::size_t count = lines();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = backwards ? (from + count - i) % count : (from + i) % count;
    if (holds(line(at), wanted)) return at;
  }
  return count;
}

std::size_t InternalText::first_of(std::uint32_t file, std::uint32_t line) const {
  const auto is_there = [&](const SourcePlace& p) { return p.line == line && p.file == file; };
  return static_cast<std::size_t>(std::ranges::find_if(sources_, is_there) - sources_.begin());
}

void InternalLines::show_text(std::shared_ptr<const InternalText> text) {
  beginResetModel();
  text_ = std::move(text);
  endResetModel();
}

void InternalLines::light(const SourcePlace& line) {
  lit_ = line;
  if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1), {Qt::BackgroundRole});
}

void InternalLines::set_size(QSize size) { size_ = size; }

int InternalLines::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !text_ ? 0 : static_cast<int>(text_->lines());
}

QVariant InternalLines::data(const QModelIndex& index, int role) const {
  const auto row = static_cast<std::size_t>(index.row());
  if (role == Qt::DisplayRole) {
    const std::string_view line = text_->line(row);
    return QString::fromUtf8(line.data(), static_cast<qsizetype>(line.size()));
  }
  if (role == Qt::SizeHintRole) return size_;
  if (role == Qt::BackgroundRole && lit_.line > 0) {
    const SourcePlace place = text_->source(row);
    if (place.line == lit_.line && place.file == lit_.file) return colours().current_line;
  }
  return {};
}

}  // namespace dgt::studio
