// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/document.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <cerrno>
#include <system_error>

#include "lang/text/detect.h"
#include "lang/text/utf8.h"

namespace dgt::studio {
namespace {

QString said(const char* sentence) { return QCoreApplication::translate("Document", sentence); }

QByteArray digest_of(std::string_view bytes) {
  return QCryptographicHash::hash(
      QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())),
      QCryptographicHash::Sha256);
}

QString qt(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString with_lf(QString text) {
  text.replace(QStringLiteral("\r\n"), QStringLiteral("\n"));
  text.replace(u'\r', u'\n');
  return text;
}

bool has_long_line(QStringView text) {
  qsizetype start = 0;
  for (qsizetype end = text.indexOf(u'\n'); end >= 0; end = text.indexOf(u'\n', start)) {
    if (end - start > kLongestLine) return true;
    start = end + 1;
  }
  return text.size() - start > kLongestLine;
}

tl::expected<std::string, QString> bytes_of_file(const QString& name) {
  const QFileInfo info(name);
  if (info.exists() && !info.isFile()) {
    return tl::unexpected(said(QT_TRANSLATE_NOOP("Document", "%1 is no file.")).arg(name));
  }
  if (info.size() > kLargestFile) {
    return tl::unexpected(
        said(QT_TRANSLATE_NOOP("Document",
                               "%1 is larger than %2 MB, too large to be edited. The command dgt "
                               "takes files of any size."))
            .arg(name)
            .arg(kLargestFile / (1024 * 1024)));
  }
  auto bytes = read_file(name.toStdString());
  if (!bytes) return tl::unexpected(sentence_of(bytes.error()));
  if (looks_like_utf16(*bytes)) {
    return tl::unexpected(
        said(QT_TRANSLATE_NOOP("Document",
                               "%1 is saved as UTF-16 (“Unicode”). Save it as UTF-8 in the "
                               "program it comes from."))
            .arg(name));
  }
  return *std::move(bytes);
}

}  // namespace

QString sentence_of(const FileError& error) {
  QString why;
  switch (error.error) {
    case ENOENT:
      why = said(QT_TRANSLATE_NOOP("Document", "there is no such file or folder"));
      break;
    case EACCES:
    case EPERM:
      why = said(QT_TRANSLATE_NOOP("Document", "permission denied"));
      break;
    case EROFS:
      why = said(QT_TRANSLATE_NOOP("Document", "the disk is read-only"));
      break;
    case ENOSPC:
    case EDQUOT:
      why = said(QT_TRANSLATE_NOOP("Document", "the disk is full"));
      break;
    case EISDIR:
      why = said(QT_TRANSLATE_NOOP("Document", "it is a folder"));
      break;
    case EIO:
      why = said(QT_TRANSLATE_NOOP("Document", "the disk failed"));
      break;
    default:
      why = qt(std::generic_category().message(error.error));
  }
  return QStringLiteral("%1: %2.").arg(qt(error.name), why);
}

Document::Document(QObject* parent) : QObject(parent) {
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, [this] {
    watch();  // a file that was replaced has to be watched anew
    if (on_disk() != OnDisk::AsKnown) emit changed_on_disk();
  });
}

void Document::watch() {
  if (const QStringList files = watcher_.files(); !files.isEmpty()) watcher_.removePaths(files);
  if (!name_.isEmpty() && QFileInfo::exists(name_)) watcher_.addPath(name_);
}

void Document::remember(const QString& name, QByteArray digest) {
  name_ = name;
  digest_ = std::move(digest);
  watch();
  emit changed();
}

tl::expected<LoadedText, QString> Document::load(const QString& name,
                                                 std::optional<Encoding> encoding) {
  const QString full = QDir::cleanPath(QFileInfo(name).absoluteFilePath());
  const auto bytes = bytes_of_file(full);
  if (!bytes) return tl::unexpected(bytes.error());
  const EncodingGuess guess =
      encoding ? EncodingGuess{*encoding, *encoding, 1.0} : detect_encoding(*bytes);
  Decoded decoded = decode(*bytes, guess.encoding);
  LoadedText loaded{with_lf(qt(decoded.text)), decoded.form, guess.confidence < kSureEnough, 0};
  for (const StrayBytes& stray : decoded.strays) loaded.strays += stray.bytes.size();
  if (has_long_line(loaded.text)) {
    return tl::unexpected(
        said(QT_TRANSLATE_NOOP("Document",
                               "%1 has lines of more than %2 characters and is no program."))
            .arg(full)
            .arg(kLongestLine));
  }
  form_ = decoded.form;
  remember(full, digest_of(*bytes));
  return loaded;
}

void Document::start_new() {
  form_ = {};
  remember({}, {});
}

void Document::take_over(const QString& name, const TextForm& form) {
  form_ = form;
  remember(name, {});
  accept_disk();
}

tl::expected<void, QString> Document::save(const QString& name, const QString& text) {
  const QString full = QDir::cleanPath(QFileInfo(name).absoluteFilePath());
  const Encoded encoded = encode(text.toStdString(), form_);
  const auto written = write_file(full.toStdString(), encoded.bytes);
  if (!written) return tl::unexpected(sentence_of(written.error()));
  form_.mixed_line_ends = false;
  remember(full, digest_of(encoded.bytes));
  return {};
}

QString Document::title() const { return QFileInfo(name_).fileName(); }

void Document::set_form(const TextForm& form) {
  if (form_ == form) return;
  form_ = form;
  emit changed();
}

QString Document::unsayable(const QString& text) const {
  const std::string bytes = text.toStdString();
  QString characters;
  for (const std::uint32_t offset : encode(bytes, form_).lost) {
    const char32_t lost = code_point_at(bytes, offset).value;
    const QString one = QString::fromUcs4(&lost, 1);
    if (!characters.contains(one)) characters += one;
  }
  return characters;
}

Document::OnDisk Document::on_disk() const {
  if (name_.isEmpty()) return OnDisk::AsKnown;
  if (!QFileInfo::exists(name_)) return OnDisk::Gone;
  const auto bytes = read_file(name_.toStdString());
  return bytes && digest_of(*bytes) == digest_ ? OnDisk::AsKnown : OnDisk::Changed;
}

void Document::accept_disk() {
  if (name_.isEmpty()) return;
  const auto bytes = read_file(name_.toStdString());
  digest_ = bytes ? digest_of(*bytes) : QByteArray();
  watch();
}

}  // namespace dgt::studio
