// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "kernel/thread_arithmetic.h"

namespace dgt::studio {

/// Works things out in a thread of its own for a window, where only the newest counts: while one is
/// in work the newest request waits and older ones are forgotten.
template <class Result>
class LatestTask {
 public:
  /// Asked by the work whether nobody wants its result any more.
  using GivenUp = std::function<bool()>;
  using Work = std::function<std::optional<Result>(const GivenUp&)>;
  using Done = std::function<void(Result)>;

  /// `done` is called in the thread of `receiver`, of which this object must be a member.
  LatestTask(QObject* receiver, Done done) : receiver_(receiver), done_(std::move(done)) {}
  LatestTask(const LatestTask&) = delete;
  LatestTask& operator=(const LatestTask&) = delete;
  ~LatestTask() {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
      newest_ = std::numeric_limits<unsigned>::max();
    }
    asked_.notify_one();
    if (thread_.joinable()) thread_.join();
  }

  void ask(Work work) { ask(std::move(work), true); }
  /// The work in hand is finished and delivered before: what changes faster than it is worked out
  /// still arrives now and then.
  void ask_next(Work work) { ask(std::move(work), false); }

  /// Whether something is still to be delivered.
  [[nodiscard]] bool is_busy() const { return delivered_ != asked_for_; }

 private:
  struct Request {
    Work work;
    unsigned number = 0;
  };

  void ask(Work work, bool gives_up) {
    {
      const std::lock_guard lock(mutex_);
      request_ = Request{std::move(work), ++asked_for_};
      if (gives_up) newest_ = asked_for_;
    }
    if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
    asked_.notify_one();
  }

  void run() {
    while (auto request = next()) {
      const unsigned number = request->number;
      auto result = request->work([this, number] { return number < newest_; });
      if (!result) continue;
      QMetaObject::invokeMethod(
          receiver_,
          [this, number, made = std::make_shared<Result>(std::move(*result))] {
            if (number < newest_) return;
            delivered_ = number;
            done_(std::move(*made));
          },
          Qt::QueuedConnection);
    }
    release_thread_arithmetic();
  }

  std::optional<Request> next() {
    std::unique_lock lock(mutex_);
    asked_.wait(lock, [this] { return ending_ || request_; });
    return ending_ ? std::nullopt : std::exchange(request_, std::nullopt);
  }

  QObject* receiver_;
  Done done_;
  std::mutex mutex_;
  std::condition_variable asked_;
  std::optional<Request> request_;
  bool ending_ = false;
  std::atomic<unsigned> newest_ = 0;  ///< requests before it are not wanted any more
  unsigned asked_for_ = 0;            ///< in the receiver's thread, as is the next
  unsigned delivered_ = 0;
  std::thread thread_;
};

}  // namespace dgt::studio
