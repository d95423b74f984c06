// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/live_compiler.h"

#include <algorithm>

namespace dgt::studio {

LiveCompiler::LiveCompiler(std::function<QString()> text, QObject* parent)
    : QObject(parent), text_(std::move(text)) {
  pause_.setSingleShot(true);
  pause_.setInterval(kPause);
  connect(&pause_, &QTimer::timeout, this, &LiveCompiler::compile_now);
  connect(&compiler_, &Compiler::made, this, &LiveCompiler::take);
  connect(&compiler_, &Compiler::failed, this, [this](std::uint64_t revision, const QString& why) {
    if (revision != revision_) return;
    emit working(false);
    emit failed(why);
  });
}

void LiveCompiler::touch() {
  ++revision_;
  current_ = nullptr;
  pause_.start();
}

void LiveCompiler::set_source(const QString& name, const Settings& settings) {
  name_ = name;
  settings_ = settings;
  settings_.source.encoding = Encoding::Utf8;  // of the text in the window; macros keep theirs
  touch();
}

void LiveCompiler::compile_now() {
  pause_.stop();
  if (current_) {
    emit made(current_);
    return;
  }
  if (asked_revision_ == revision_ && asked_.isValid()) return;  // in work
  asked_revision_ = revision_;
  asked_.start();
  emit working(true);
  compiler_.ask({.revision = revision_,
                 .name = name_.toStdString(),
                 .bytes = text_().toStdString(),
                 .settings = settings_});
}

void LiveCompiler::take(const PartPtr& part) {
  if (part->revision != revision_) return;
  pause_.setInterval(std::clamp(static_cast<int>(asked_.elapsed()), kPause, kLongestPause));
  current_ = part;
  emit working(false);
  emit made(part);
}

}  // namespace dgt::studio
