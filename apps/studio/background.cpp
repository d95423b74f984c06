// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/background.h"

#include <QMetaObject>
#include <exception>
#include <utility>

#include "kernel/thread_arithmetic.h"

namespace dgt::studio {

Background::Background(QObject* parent) : QObject(parent) {
  thread_ = std::thread([this] { run(); });
}

Background::~Background() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  asked_.notify_one();
  thread_.join();
}

void Background::ask(Work work) {
  const bool was_busy = is_busy();
  waiting_for_ = ++last_;
  {
    const std::lock_guard lock(mutex_);
    request_ = Request{last_, std::move(work)};
  }
  asked_.notify_one();
  if (!was_busy) emit busy_changed(true);
}

void Background::forget() {
  {
    const std::lock_guard lock(mutex_);
    request_.reset();
  }
  if (std::exchange(waiting_for_, 0) != 0) emit busy_changed(false);
}

std::optional<Background::Request> Background::next() {
  std::unique_lock lock(mutex_);
  asked_.wait(lock, [this] { return ending_ || request_; });
  return ending_ ? std::nullopt : std::exchange(request_, std::nullopt);
}

void Background::run() {
  while (auto request = next()) {
    Outcome outcome;
    try {
      outcome = request->work();
    } catch (const std::exception& fault) {
      outcome = [this, why = QString::fromUtf8(fault.what())] { emit failed(why); };
    }
    const std::uint64_t number = request->number;
    request.reset();  // what the work holds is let go here, not in the window's thread
    QMetaObject::invokeMethod(
        this, [this, number, outcome] { finish(number, outcome); }, Qt::QueuedConnection);
  }
  release_thread_arithmetic();
}

void Background::finish(std::uint64_t number, const Outcome& outcome) {
  if (number != waiting_for_) return;
  waiting_for_ = 0;
  if (outcome) outcome();
  if (!is_busy()) emit busy_changed(false);
}

}  // namespace dgt::studio
