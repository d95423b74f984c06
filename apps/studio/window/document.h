// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <optional>
#include <tl/expected.hpp>

#include "apps/driver/file_io.h"
#include "lang/text/encoding.h"

namespace dgt::studio {

/// Beyond this a text is no program a person writes, and the editor would take too much memory: a
/// program of 10 MB takes half a gigabyte, its compilation included.
inline constexpr qint64 kLargestFile = 32LL * 1024 * 1024;
/// Beyond this a line stops the editor: it is laid out as a whole.
inline constexpr qsizetype kLongestLine = 100'000;

/// The text of a file, and what there is to say about how it was read.
struct LoadedText {
  QString text;  ///< lines end in LF
  TextForm form;
  bool unsure = false;     ///< the encoding was guessed without certainty
  std::size_t strays = 0;  ///< bytes that are no text in the encoding; saving would lose them
};

/// The file that is edited: its name, how its text lies in it, and whether somebody else has
/// changed it. Shows nothing and asks nothing.
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);

  /// Reads a file in an encoding, or in the one it looks like. With an error, a sentence for the
  /// person, the document stays what it was.
  [[nodiscard]] tl::expected<LoadedText, QString> load(const QString& name,
                                                       std::optional<Encoding> encoding = {});
  /// Becomes a new document without a file, with the line ends of the old one's kind.
  void start_new();
  /// Becomes a document whose text came from elsewhere, to be saved under `name` some day.
  void take_over(const QString& name, const TextForm& form);
  /// Writes the text whole or not at all; with an error the old file stands.
  [[nodiscard]] tl::expected<void, QString> save(const QString& name, const QString& text);

  [[nodiscard]] const QString& name() const { return name_; }  ///< full; empty: never saved
  [[nodiscard]] QString title() const;                         ///< without folders
  [[nodiscard]] const TextForm& form() const { return form_; }
  void set_form(const TextForm& form);
  /// The characters that the encoding lacks, each once, in their order.
  [[nodiscard]] QString unsayable(const QString& text) const;

  enum class OnDisk : std::uint8_t { AsKnown, Changed, Gone };
  [[nodiscard]] OnDisk on_disk() const;
  /// What is on disk is known now, whoever wrote it.
  void accept_disk();

 signals:
  void changed();          ///< name or form
  void changed_on_disk();  ///< by somebody else; see on_disk

 private:
  void remember(const QString& name, QByteArray digest);
  void watch();

  QString name_;
  TextForm form_;
  QByteArray digest_;  ///< of the bytes last read or written
  QFileSystemWatcher watcher_;
};

/// What the system says about a failed file, in the language of the program.
[[nodiscard]] QString sentence_of(const FileError& error);

}  // namespace dgt::studio
