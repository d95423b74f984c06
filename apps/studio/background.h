// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace dgt::studio {

/// A thread of its own for work that would freeze a window. While one piece of work is done the
/// newest waits, and older ones are forgotten.
class Background : public QObject {
  Q_OBJECT

 public:
  /// What becomes of the work, called in the thread of this object.
  using Outcome = std::function<void()>;
  using Work = std::function<Outcome()>;

  explicit Background(QObject* parent = nullptr);
  ~Background() override;  ///< waits for the work in hand; its outcome is dropped

  /// The outcome is called unless newer work was asked for meanwhile.
  void ask(Work work);
  /// What is asked for or in hand has no outcome any more.
  void forget();
  [[nodiscard]] bool is_busy() const { return waiting_for_ != 0; }

 signals:
  void busy_changed(bool busy);
  /// The work itself failed: an internal error.
  void failed(QString why);

 private:
  struct Request {
    std::uint64_t number = 0;
    Work work;
  };
  void run();
  std::optional<Request> next();
  void finish(std::uint64_t number, const Outcome& outcome);

  std::mutex mutex_;
  std::condition_variable asked_;
  std::optional<Request> request_;
  bool ending_ = false;
  std::uint64_t last_ = 0;         // number of the newest request; of this object's thread
  std::uint64_t waiting_for_ = 0;  // 0: for nothing
  std::thread thread_;
};

}  // namespace dgt::studio
