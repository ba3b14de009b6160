#pragma once

#include <QObject>

#include "window/import/file_actions.h"
#include "window/modes/mode_controller.h"
#include "window/timeline/sample_loader.h"
#include "window/work/actions.h"

class QMenu;
class QMenuBar;

namespace viscera::app {

class PanelDock;
class ScanActions;

/// Fills the menus of the window, and implements the menu Edit: undo and redo, the list of steps, and
/// selecting all handles. The other actions are made elsewhere.
class Menus final : public QObject {
  Q_OBJECT

public:
  /// The parts of the window that the menus call; all have to live longer.
  struct Parts {
    Actions& actions;
    const ModeController& modes;
    FileActions& files;
    SampleLoader& samples;
    const ScanActions& scans;
    Workspace& workspace;
    Settings& settings;
    const std::vector<PanelDock*>& docks;
  };

  /// Adds "edit.undo" and "edit.redo".
  Menus(QMenuBar& bar, const Parts& parts);

  QMenu* samples() const { return samples_; }

public Q_SLOTS:
  /// Fills the menu of recently opened files.
  void fillRecent();

private:
  void addEditActions();
  void makeFileMenu();
  void makeEditMenu();
  void makeViewMenu();
  void makeLanguageMenu(QMenu& menu);
  void makeOrganMenus();
  void makeLastMenus();
  void fill(QMenu* menu, const std::vector<const char*>& ids) const;
  void fillSamples();
  /// The steps around the present one, the youngest first; those that were undone are in italics.
  void fillSteps(QMenu* menu);

  QMenuBar& bar_;
  Parts parts_;
  QMenu* recent_ = nullptr;
  QMenu* samples_ = nullptr;
};

} // namespace viscera::app
