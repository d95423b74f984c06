// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/compiler.h"

#include <exception>
#include <utility>

#include "kernel/thread_arithmetic.h"

namespace dgt::studio {

Compiler::Compiler(QObject* parent) : QObject(parent) {
  qRegisterMetaType<PartPtr>();
  qRegisterMetaType<std::uint64_t>("std::uint64_t");
  thread_ = std::thread([this] { work(); });
}

Compiler::~Compiler() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  asked_.notify_one();
  thread_.join();
}

void Compiler::ask(Request request) {
  {
    const std::lock_guard lock(mutex_);
    request_ = std::move(request);
  }
  asked_.notify_one();
}

std::optional<Compiler::Request> Compiler::next() {
  std::unique_lock lock(mutex_);
  asked_.wait(lock, [this] { return ending_ || request_; });
  return ending_ ? std::nullopt : std::exchange(request_, std::nullopt);
}

void Compiler::work() {
  while (const auto request = next()) {
    try {
      compile(*request);
    } catch (const std::exception& fault) {
      emit failed(request->revision, QString::fromUtf8(fault.what()));
    }
  }
  release_thread_arithmetic();
}

// Signals cross to the receiver's thread by themselves.
void Compiler::compile(const Request& request) {
  auto part = std::make_shared<Part>();
  part->revision = request.revision;
  part->name = request.name;
  part->settings = request.settings;
  part->compilation = compile_bytes(request.name, request.bytes, request.settings.source);
  emit made(std::move(part));
}

}  // namespace dgt::studio
