// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "apps/studio/part.h"

namespace dgt::studio {

/// Compiles programs in a thread of its own. While one is compiled the newest request waits and
/// older ones are forgotten, so that typing never piles up work.
class Compiler : public QObject {
  Q_OBJECT

 public:
  struct Request {
    std::uint64_t revision = 0;
    std::string name;
    std::string bytes;  ///< of the file, in `settings.source.encoding`
    Settings settings;
  };

  explicit Compiler(QObject* parent = nullptr);
  ~Compiler() override;  ///< waits for the program in work

  void ask(Request request);

 signals:
  void made(dgt::studio::PartPtr part);
  /// The program itself failed: an internal error.
  void failed(std::uint64_t revision, QString why);

 private:
  void work();
  std::optional<Request> next();
  void compile(const Request& request);

  std::mutex mutex_;
  std::condition_variable asked_;
  std::optional<Request> request_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace dgt::studio
