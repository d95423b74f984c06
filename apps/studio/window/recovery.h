// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

#include "apps/studio/background.h"
#include "lang/text/encoding.h"

namespace dgt::studio {

/// An unsaved text, kept where a power cut or a kill does not reach it.
struct KeptText {
  QString name;  ///< of its file; empty: never saved
  TextForm form;
  QString text;
  QDateTime when;
};

/// A text that a program which is gone has left behind. While it is held nobody else is offered it.
struct LeftText {
  KeptText kept;
  QString file;  ///< where it lies
  std::shared_ptr<QLockFile> hold;
};

/// Keeps the unsaved text of one window in a file of its own, and finds what others left behind.
/// Files lie in a folder of the user's data; each has a lock as long as its program lives.
class Recovery : public QObject {
  Q_OBJECT

 public:
  /// Typing pauses this long before it is kept; no more than so much of it is lost.
  static constexpr int kDelay = 2000;  // ms
  /// Who types without pause is kept this often.
  static constexpr int kLongestDelay = 10000;  // ms

  explicit Recovery(QString folder, QObject* parent = nullptr);
  ~Recovery() override;  ///< the text is saved or given up: nothing stays

  [[nodiscard]] static QString standard_folder();

  /// Something was typed: `wanted` is emitted when it is time to keep the text.
  void touch();
  /// Writes the text in the background, the newest last.
  void keep(const KeptText& text);
  /// The text is saved or given up.
  void forget();
  /// Whether the file holds what was last handed to keep().
  [[nodiscard]] bool is_kept() const { return is_kept_; }

  /// What programs that are gone left behind, newest first.
  [[nodiscard]] std::vector<LeftText> left_behind() const;
  static void remove(const LeftText& left);

 signals:
  void wanted();
  void kept();
  /// The text could not be kept: there is no room, say. Told once until it works again.
  void failed(QString why);

 private:
  QString folder_;
  QString file_;
  std::unique_ptr<QLockFile> lock_;
  QTimer pause_;
  QTimer longest_;
  bool is_kept_ = false;
  bool has_failed_ = false;
  std::unique_ptr<Background> disk_;
};

}  // namespace dgt::studio
