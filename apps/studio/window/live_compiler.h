// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

#include "apps/studio/compiler.h"

namespace dgt::studio {

/// Compiles a text as it is typed. Answers to a text that has changed since are dropped.
class LiveCompiler : public QObject {
  Q_OBJECT

 public:
  /// Within a word people pause less, and squiggles under half a word are noise.
  static constexpr int kPause = 300;  // ms
  /// Programs that take long are compiled after a pause as long as that, so that typing shares the
  /// machine with one compilation at most every other moment.
  static constexpr int kLongestPause = 5000;  // ms

  /// `text` gives the text in UTF-8 when it is time.
  explicit LiveCompiler(std::function<QString()> text, QObject* parent = nullptr);

  /// The text or what it is compiled with has changed.
  void touch();
  void set_source(const QString& name, const Settings& settings);
  /// Without waiting for a pause. `made` follows in any case.
  void compile_now();
  /// The answer to the text as it stands; null while it is out.
  [[nodiscard]] const PartPtr& current() const { return current_; }

 signals:
  void made(dgt::studio::PartPtr part);
  void failed(QString why);
  void working(bool at_work);

 private:
  void take(const PartPtr& part);

  Compiler compiler_;
  std::function<QString()> text_;
  QTimer pause_;
  QElapsedTimer asked_;
  std::uint64_t revision_ = 0;  ///< of the text as it stands
  std::uint64_t asked_revision_ = 0;
  QString name_;
  Settings settings_;
  PartPtr current_;
};

}  // namespace dgt::studio
