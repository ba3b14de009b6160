#pragma once

#include <QObject>

#include "viscera/presentation/view_state.h"
#include "window/session/session_view.h"
#include "window/timeline/playback.h"
#include "window/work/settings.h"

class QWidget;

namespace viscera::app {

class Actions;
class SessionFiles;

/// Exports the session as a report (File > Report...) or as a script of commands (Edit > Copy as commands).
/// A worker makes both from the state of the window at that moment.
class ReportExport final : public QObject {
  Q_OBJECT

public:
  /// The parts of the window from which they are made; all have to live longer.
  struct Window {
    Workspace& workspace;
    Playback& playback;
    const SessionView& view;
    const SessionFiles& files;
    Settings& settings;
  };

  ReportExport(Window window, QWidget* parent);

  /// Adds "file.report" and "edit.copyCommands".
  void addTo(Actions& actions);

  /// Writes the report: .pdf or .html by the file's name.
  void write(const QString& file);
  /// Puts the script into the clipboard.
  void copyCommands();

private:
  void choose();
  presentation::ViewState view() const;

  Window window_;
  QWidget* parent_;
};

} // namespace viscera::app
