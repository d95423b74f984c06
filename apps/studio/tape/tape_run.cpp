// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/tape/tape_run.h"

#include <QFileInfo>
#include <QMetaObject>

namespace dgt::studio {
namespace {

constexpr qint64 kBetween = 100;  // ms, what an eye can follow

TapeTaken out_of_file(const std::string& name) {
  TapeTaken taken;
  const auto bytes = read_file(name);
  if (!bytes) {
    taken.file_error = bytes.error();
    return taken;
  }
  taken.image = read_tape_image(name, *bytes);
  taken.reading.tape = taken.image.tape;
  return taken;
}

}  // namespace

TapeRun::TapeRun(QObject* parent) : QObject(parent) {
  connect(&work_, &Background::busy_changed, this, &TapeRun::busy_changed);
}

TapeRun::~TapeRun() { stop(); }

void TapeRun::stop() { *cancelled_ = true; }

// Called in the thread of the work.
Watch TapeRun::watch() {
  *cancelled_ = false;
  auto clock = std::make_shared<QElapsedTimer>();
  auto last = std::make_shared<qint64>(-kBetween);
  clock->start();
  return {[this, clock, last](std::size_t rows) {
            const qint64 now = clock->elapsed();
            if (now - *last < kBetween) return;
            *last = now;
            QMetaObject::invokeMethod(
                this, [this, rows, now] { emit progress(rows, static_cast<double>(now) / 1000); },
                Qt::QueuedConnection);
          },
          [cancelled = cancelled_] { return cancelled->load(); }};
}

void TapeRun::punch(const PunchSettings& settings, const std::vector<Row>& rows, std::size_t from,
                    const TapeFormat& format) {
  work_.ask([this, settings, rows, from, format, seen = watch()]() -> Background::Outcome {
    const auto done = punch_from(settings, rows, from, format, seen);
    if (done) return [this] { emit punched(); };
    return [this, failure = done.error()] { emit punch_failed(failure); };
  });
}

void TapeRun::read(const ReaderSettings& settings, const TapeFormat& format) {
  work_.ask([this, settings, format, seen = watch()]() -> Background::Outcome {
    auto made = std::make_shared<TapeTaken>();
    if (QFileInfo(QString::fromStdString(settings.device)).isFile()) {
      *made = out_of_file(settings.device);
    } else {
      made->reading = read_from(settings, format, seen);
    }
    made->program = read_program(settings.device, made->reading.tape, format);
    return [this, made] { emit taken(*made); };
  });
}

}  // namespace dgt::studio
