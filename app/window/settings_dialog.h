#pragma once

#include <QDialog>

#include "window/work/actions.h"
#include "window/work/settings.h"

class QFormLayout;

namespace viscera::app {

/// What the user can set, in one place: look, language, folders, what is shown at the start. Every choice is
/// kept, and applied, at once; the language with the next start.
class SettingsDialog final : public QDialog {
  Q_OBJECT

public:
  /// `settings` and `actions` have to outlive the dialog.
  SettingsDialog(Settings& settings, const Actions& actions, QWidget* parent);

private:
  QWidget* makeLook();
  QWidget* makeStart();
  QWidget* makeFolders();
  void addFolder(QFormLayout& form, const QString& name, const char* key,
                 QStandardPaths::StandardLocation standard);
  /// A check box for an action that is on or off.
  void addSwitch(QFormLayout& form, QAction* action);

  Settings& settings_;
  const Actions& actions_;
};

} // namespace viscera::app
