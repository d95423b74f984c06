// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QSize>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/toolpath.h"

namespace dgt::studio {

/// The internal form in lines, and which moves they tell of. Made in the background.
class InternalText {
 public:
  explicit InternalText(const Toolpath& path);

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::size_t lines() const { return begins_.size() - 1; }
  [[nodiscard]] std::size_t longest() const { return longest_; }  ///< line, in bytes
  [[nodiscard]] std::string_view line(std::size_t i) const;       ///< without its end
  /// Where the move of a line was asked for; line 0: it tells of none, or of one that nobody asked
  /// for.
  [[nodiscard]] SourcePlace source(std::size_t line) const { return sources_[line]; }
  /// The next line from `from` on, or the one before it, that has `wanted` in it, in either case;
  /// past an end it goes on at the other. `lines()`: none.
  [[nodiscard]] std::size_t find(std::string_view wanted, std::size_t from, bool backwards) const;
  /// The first line of a move asked for there; `lines()`: none.
  [[nodiscard]] std::size_t first_of(std::uint32_t file, std::uint32_t line) const;

 private:
  std::string text_;
  std::vector<std::size_t> begins_;  ///< of lines, and the end
  std::vector<SourcePlace> sources_;
  std::size_t longest_ = 0;
};

/// Shows the lines: any number of them, since only those in view are looked at.
class InternalLines : public QAbstractListModel {
  Q_OBJECT

 public:
  using QAbstractListModel::QAbstractListModel;
  void show_text(std::shared_ptr<const InternalText> text);
  void light(const SourcePlace& line);  ///< of it the line counts
  void set_size(QSize size);            ///< of every line, in pixels
  [[nodiscard]] const InternalText* text() const { return text_.get(); }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::shared_ptr<const InternalText> text_;
  SourcePlace lit_;
  QSize size_;
};

}  // namespace dgt::studio
