// SPDX-License-Identifier: GPL-3.0-or-later
//
// A kept text is a line of JSON that says whose it is, then the text in UTF-8.
#include "apps/studio/window/recovery.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>

#include "apps/driver/file_io.h"
#include "apps/studio/background.h"
#include "apps/studio/window/document.h"

namespace dgt::studio {
namespace {

QString lock_name(const QString& file) { return file + QStringLiteral(".lock"); }

QString qt(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QByteArray written(const KeptText& kept) {
  const QJsonObject head = {
      {QStringLiteral("name"), kept.name},
      {QStringLiteral("when"), kept.when.toString(Qt::ISODate)},
      {QStringLiteral("encoding"), qt(name_of(kept.form.encoding))},
      {QStringLiteral("byte_order_mark"), kept.form.byte_order_mark},
      {QStringLiteral("end_of_file_mark"), kept.form.end_of_file_mark},
      {QStringLiteral("line_end"), static_cast<int>(kept.form.line_end)},
  };
  return QJsonDocument(head).toJson(QJsonDocument::Compact) + '\n' + kept.text.toUtf8();
}

std::optional<KeptText> read_kept(const QString& file) {
  const auto bytes = read_file(file.toStdString());
  if (!bytes) return std::nullopt;
  const auto head_size = bytes->find('\n');
  if (head_size == std::string::npos) return std::nullopt;
  const QJsonObject head =
      QJsonDocument::fromJson(QByteArray::fromStdString(bytes->substr(0, head_size))).object();
  KeptText kept;
  kept.name = head[QStringLiteral("name")].toString();
  kept.when = QDateTime::fromString(head[QStringLiteral("when")].toString(), Qt::ISODate);
  kept.form.encoding = encoding_named(head[QStringLiteral("encoding")].toString().toStdString())
                           .value_or(Encoding::Utf8);
  kept.form.byte_order_mark = head[QStringLiteral("byte_order_mark")].toBool();
  kept.form.end_of_file_mark = head[QStringLiteral("end_of_file_mark")].toBool();
  kept.form.line_end =
      static_cast<LineEnd>(std::clamp(head[QStringLiteral("line_end")].toInt(), 0, 2));
  kept.text = qt(std::string_view(*bytes).substr(head_size + 1));
  if (!kept.when.isValid()) return std::nullopt;
  return kept;
}

}  // namespace

QString Recovery::standard_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
         QStringLiteral("/recovery");
}

Recovery::Recovery(QString folder, QObject* parent)
    : QObject(parent), folder_(std::move(folder)), disk_(std::make_unique<Background>()) {
  QDir().mkpath(folder_);
  file_ =
      folder_ + u'/' + QUuid::createUuid().toString(QUuid::WithoutBraces) + QStringLiteral(".text");
  lock_ = std::make_unique<QLockFile>(lock_name(file_));
  lock_->setStaleLockTime(0);
  lock_->tryLock();
  for (QTimer* const timer : {&pause_, &longest_}) {
    timer->setSingleShot(true);
    connect(timer, &QTimer::timeout, this, [this] {
      pause_.stop();
      longest_.stop();
      emit wanted();
    });
  }
  pause_.setInterval(kDelay);
  longest_.setInterval(kLongestDelay);
}

// A write in hand ends first, or it would bring the file back.
Recovery::~Recovery() {
  disk_.reset();
  QFile::remove(file_);
}

void Recovery::touch() {
  is_kept_ = false;
  pause_.start();
  if (!longest_.isActive()) longest_.start();
}

void Recovery::keep(const KeptText& text) {
  disk_->ask([this, text, name = file_.toStdString()] {
    const QByteArray bytes = written(text);
    const auto result = write_file(name, {bytes.data(), static_cast<std::size_t>(bytes.size())});
    return [this, result] {
      if (result) {
        is_kept_ = true;
        has_failed_ = false;
        emit kept();
      } else if (!std::exchange(has_failed_, true)) {
        emit failed(sentence_of(result.error()));
      }
    };
  });
}

void Recovery::forget() {
  pause_.stop();
  longest_.stop();
  is_kept_ = false;
  disk_->ask([name = file_] {
    QFile::remove(name);
    return [] {};
  });
}

std::vector<LeftText> Recovery::left_behind() const {
  std::vector<LeftText> found;
  const QDir folder(folder_);
  for (const QString& entry : folder.entryList({QStringLiteral("*.text")}, QDir::Files)) {
    const QString file = folder.filePath(entry);
    if (file == file_) continue;
    auto hold = std::make_shared<QLockFile>(lock_name(file));
    hold->setStaleLockTime(0);  // stale when its program is gone, however long ago
    if (!hold->tryLock()) continue;
    if (auto kept = read_kept(file)) found.push_back({*std::move(kept), file, std::move(hold)});
  }
  std::ranges::sort(found, std::greater(), [](const LeftText& left) { return left.kept.when; });
  return found;
}

void Recovery::remove(const LeftText& left) { QFile::remove(left.file); }

}  // namespace dgt::studio
