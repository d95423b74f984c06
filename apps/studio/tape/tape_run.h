// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <atomic>
#include <memory>
#include <optional>

#include "apps/driver/tape_images.h"
#include "apps/driver/tape_jobs.h"
#include "apps/driver/tape_messages.h"
#include "apps/studio/background.h"

namespace dgt::studio {

/// One tape as it came from a reader or out of a file.
struct TapeTaken {
  TapeReading reading;
  std::optional<FileError> file_error;
  TapeImage image;      ///< of a file: what is wrong with it
  TapeProgram program;  ///< what is on the tape
};

/// A punch or reader at work in the background, for as long as the tape is.
class TapeRun : public QObject {
  Q_OBJECT

 public:
  explicit TapeRun(QObject* parent = nullptr);
  ~TapeRun() override;  ///< stops the device

  void punch(const PunchSettings& settings, const std::vector<Row>& rows, std::size_t from,
             const TapeFormat& format);
  void read(const ReaderSettings& settings, const TapeFormat& format);
  void stop();
  [[nodiscard]] bool is_busy() const { return work_.is_busy(); }

 signals:
  void busy_changed(bool busy);
  /// Some ten times a second.
  void progress(std::size_t rows, double seconds);
  void punched();
  void punch_failed(const dgt::PunchFailure& failure);
  void taken(const dgt::studio::TapeTaken& taken);

 private:
  [[nodiscard]] Watch watch();

  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  Background work_{this};
};

}  // namespace dgt::studio
