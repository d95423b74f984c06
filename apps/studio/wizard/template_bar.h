// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "apps/studio/wizard/used_numbers.h"

class QLabel;
class QLineEdit;

namespace dgt::studio {

/// The template of a definition, `L1 = P_ C_`: its number and its values are typed; the space bar
/// goes on to the next, from the last on the definition is complete.
class TemplateBar : public QWidget {
  Q_OBJECT

 public:
  explicit TemplateBar(QWidget* parent = nullptr);

  /// A template of a pattern as the guide writes it, `L=PC`, with the first value to be typed.
  void begin(const std::string& pattern, int number);
  void end();
  [[nodiscard]] bool is_open() const { return !pattern_.empty(); }
  [[nodiscard]] const std::string& pattern() const { return pattern_; }
  /// To tell of elements that the program does not define.
  void set_program(const UsedNumbers& program) { program_ = program; }

 signals:
  /// A definition that the language takes: `L1=P1 C1`.
  void finished(QString line, int number);
  /// Esc: the person is done.
  void left();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Field {
    char letter = 0;
    QLineEdit* edit = nullptr;
  };
  /// The definition as it stands, with where each field's value lies in it.
  struct Line {
    std::string text;
    std::vector<std::pair<std::size_t, std::size_t>> values;
  };

  void clear();
  /// A value with its letter before it.
  QLineEdit* add_field(const QString& sign, char letter, int letters_wide);
  [[nodiscard]] Line line(std::size_t typed) const;
  void go_on(std::size_t from);
  void go_back(std::size_t from);
  void focus_on(std::size_t index);
  void complete();
  [[nodiscard]] bool accepts(std::size_t typed);
  void tell(const QString& message, bool is_error);
  [[nodiscard]] std::optional<std::size_t> index_of(const QObject* edit) const;
  void retranslate();

  std::string pattern_;
  std::vector<Field> fields_;  // the first is the number of the element itself
  UsedNumbers program_;
  QWidget* row_ = nullptr;
  QLabel* message_ = nullptr;
  QLabel* keys_ = nullptr;
};

}  // namespace dgt::studio
