#pragma once

#include <QObject>

#include "window/edit_actions.h"
#include "window/file_actions.h"
#include "window/modes/mode_controller.h"
#include "window/sample_loader.h"

class QMenu;
class QMenuBar;

namespace viscera::app {

class PanelDock;

/// What stands in which menu. The actions are made elsewhere.
class Menus final : public QObject {
  Q_OBJECT

public:
  /// What the menus lead to; all have to live longer.
  struct Parts {
    const Actions& actions;
    const ModeController& modes;
    EditActions& edit;
    FileActions& files;
    SampleLoader& samples;
    Workspace& workspace;
    const Settings& settings;
    const std::vector<PanelDock*>& docks;
  };

  Menus(QMenuBar& bar, const Parts& parts);

  QMenu* samples() const { return samples_; }

public Q_SLOTS:
  /// The files opened last are others.
  void fillRecent();

private:
  void makeFileMenu();
  void makeEditMenu();
  void makeViewMenu();
  void makeOrganMenus();
  void makeLastMenus();
  void fill(QMenu* menu, const std::vector<const char*>& ids) const;
  void fillSamples();

  QMenuBar& bar_;
  Parts parts_;
  QMenu* recent_ = nullptr;
  QMenu* samples_ = nullptr;
};

} // namespace viscera::app
