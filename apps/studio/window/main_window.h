// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>

#include "apps/studio/background.h"
#include "apps/studio/editor/find_bar.h"
#include "apps/studio/editor/source_editor.h"
#include "apps/studio/window/actions.h"
#include "apps/studio/window/documents.h"
#include "apps/studio/window/live_compiler.h"
#include "apps/studio/window/notice_bar.h"
#include "apps/studio/window/panels.h"
#include "apps/studio/window/settings_store.h"
#include "apps/studio/window/status_fields.h"

class QMenu;

namespace dgt::studio {

class HelpWindow;

/// The main window of the guide: menus, tools, the editor and the panels around it. It owns them
/// and passes between them what they say.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// What the command line says for this time; what is left open is as it was last time.
  struct Options {
    std::optional<Language> language;
    std::optional<Theme> theme;
    QString machine_file;
  };
  explicit MainWindow(const Options& options, QWidget* parent = nullptr);
  ~MainWindow() override;

  bool open_file(const QString& name) { return documents_->open_file(name); }
  /// Offers what an earlier program left behind.
  void offer_recovery() { documents_->offer_recovery(); }

  [[nodiscard]] Panels& panels() { return *panels_; }
  [[nodiscard]] SourceEditor& editor() { return *editor_; }
  [[nodiscard]] Actions& actions() { return *actions_; }
  [[nodiscard]] NoticeBar& notices() { return *notices_; }
  [[nodiscard]] const Documents& documents() const { return *documents_; }
  [[nodiscard]] const LiveCompiler& compiler() const { return *compiler_; }
  [[nodiscard]] const Settings& machine() const { return machine_; }

  void set_language(Language language);
  void set_theme(Theme theme);
  void draw();
  void show_nc();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  // Construction.
  void build_centre();
  void build_menus();
  void build_tools();
  void join_actions();
  void join_text_actions();
  void join_panels();
  void join_documents();
  void retranslate();

  // What the compiler says goes round.
  void take_part(const PartPtr& part);
  void show_faults(const Part& part);
  void draw_part(const PartPtr& part);
  void go_to_place(int file, int line, int column);
  void light_line(int line);

  // Commands.
  void use_machine(const QString& file);
  void put_cure(std::size_t fault);
  void format();
  void take_formatted(int revision, const std::optional<std::string>& text);
  void ask_for_line();
  void choose_colours();
  void choose_machine();
  void read_tape();
  void punch(const QString& name, const QByteArray& bytes);
  void duplicate_tape();
  void show_help(const QString& word);
  void show_about();
  void ask_to_exit();
  /// An NC program that was changed by hand is saved or given up.
  bool may_leave_nc();
  void set_font_size(int points);
  void show_title();

  SettingsStore settings_;
  Settings machine_;
  Actions* actions_;
  NoticeBar* notices_;
  SourceEditor* editor_;
  FindBar* find_bar_;
  Panels* panels_;
  StatusFields* fields_;
  Documents* documents_;
  LiveCompiler* compiler_;
  HelpWindow* help_ = nullptr;
  std::vector<std::pair<QMenu*, const char*>> menus_;
  Background formatting_;
  PartPtr shown_;               ///< the last answer to the text
  PartPtr drawn_;               ///< what the drawing shows: of the text, or of an NC program
  bool wants_drawing_ = false;  ///< F5 waits for the compiler
  bool wants_nc_ = false;       ///< F8 does
  bool shown_once_ = false;
};

}  // namespace dgt::studio
