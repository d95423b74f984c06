// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QSizeF>
#include <algorithm>
#include <cmath>
#include <vector>

namespace dgt::studio {

/// Which part of the window carries letters already, in squares: labels that would cover others are
/// left out.
class LabelSpace {
 public:
  /// `cell`: the side of a square, in pixels.
  LabelSpace(QSizeF window, double cell)
      : cell_(cell),
        columns_(count(window.width())),
        rows_(count(window.height())),
        taken_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

  [[nodiscard]] bool is_free(const QRectF& place) const {
    const Cells cells = cells_of(place);
    if (cells.left < 0 || cells.top < 0 || cells.right >= columns_ || cells.bottom >= rows_)
      return false;
    for (int row = cells.top; row <= cells.bottom; ++row) {
      for (int column = cells.left; column <= cells.right; ++column) {
        if (taken_[index(column, row)]) return false;
      }
    }
    return true;
  }
  void take(const QRectF& place) {
    const Cells cells = cells_of(place);
    for (int row = std::max(cells.top, 0); row <= std::min(cells.bottom, rows_ - 1); ++row) {
      for (int column = std::max(cells.left, 0); column <= std::min(cells.right, columns_ - 1);
           ++column) {
        taken_[index(column, row)] = true;
      }
    }
  }

 private:
  struct Cells {
    int left, top, right, bottom;
  };
  [[nodiscard]] int count(double length) const {
    return std::max(1, static_cast<int>(std::ceil(length / cell_)));
  }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  /// Places may lie far outside: what is beyond the window by more than a window is cut off.
  [[nodiscard]] Cells cells_of(const QRectF& place) const {
    const auto cell = [this](double at, int end) {
      return static_cast<int>(std::clamp(std::floor(at / cell_), -1.0, double(end)));
    };
    return {cell(place.left(), columns_), cell(place.top(), rows_), cell(place.right(), columns_),
            cell(place.bottom(), rows_)};
  }

  double cell_;
  int columns_;
  int rows_;
  std::vector<bool> taken_;
};

}  // namespace dgt::studio
