#pragma once

#include <QMainWindow>

#include <memory>

#include "window/actions.h"
#include "window/file_actions.h"
#include "window/group_layout.h"
#include "window/handle_placer.h"
#include "window/mode.h"
#include "window/pose_editor.h"
#include "window/sample_loader.h"
#include "window/settings.h"
#include "window/style/theme.h"
#include "window/timeline/playback.h"
#include "window/timeline/volume_monitor.h"
#include "window/workspace.h"

class QStackedWidget;

namespace viscera::app {

class BindingMessages;
class ClickTool;
class ExportActions;
class GizmoScene;
class HandlePanel;
class HandleScene;
class ImportDesk;
class Measuring;
class ModeRail;
class MotionGuide;
class OrganPanel;
class OrganScene;
class PanelDock;
class PlayParts;
class RegionScene;
class SessionFiles;
class ShortcutCard;
class StatusLine;
class StressMode;
class TimelineBar;
class TourCard;
class ViewArea;
class ViewState;
class ViewWidget;
class VolumePanel;
class WelcomeCard;

/// The window: puts the parts together and says which mode is on. What the parts do is in the parts.
class MainWindow final : public QMainWindow {
  Q_OBJECT

public:
  /// `settings` has to outlive the window. `registry` has the coordinate systems to choose from, `clock`
  /// drives the sequences.
  MainWindow(Settings& settings, plugin::Registry registry, motion::Player::Clock clock,
             QWidget* parent = nullptr);
  ~MainWindow() override;

  Workspace& workspace() { return workspace_; }
  Playback& playback() { return playback_; }
  PoseEditor& poses() { return poses_; }
  const VolumeMonitor& volumes() const { return volumes_; }
  FileActions& files() { return *files_; }
  ImportDesk& imports() { return *imports_; }
  ExportActions& exports() { return *exports_; }
  SampleLoader& samples() { return *samples_; }
  SessionFiles& sessions() { return *sessions_; }
  StressMode& stress() { return *stress_; }
  Measuring& measuring() { return *measuring_; }
  ViewArea& viewArea() { return *viewArea_; }
  PlayParts& play() { return *play_; }
  const Actions& actions() const { return actions_; }

  Mode mode() const { return mode_; }
  void setTheme(ThemeKind kind);
  void showWelcome(bool shown);
  /// Saves a picture of the 3D view; returns its file, empty when it could not be written.
  QString saveScreenshot();
  /// Brings the organs into the picture from the front.
  void frameFromFront();

public Q_SLOTS:
  void setMode(viscera::app::Mode mode);

protected:
  void closeEvent(QCloseEvent* event) override;

private:
  // main_window.cpp
  void makeDocks();
  QWidget* makePages();
  void makeCards();
  void connectParts();
  void connectImports();
  void showImports();
  void connectTimeline();
  void syncTimeline();
  void restoreLayout();
  void focusSelection();
  void escape();
  void syncHint();
  // main_window_actions.cpp
  void makeFileActions();
  void makeEditActions();
  void makeViewActions();
  void makeModeActions();
  void makeHandleActions();
  void makeRegionActions();
  void makeSequenceActions();
  void makeHelpActions();
  void syncActions();
  // main_window_session.cpp
  void makeSession();
  void makeSessionActions();
  void syncTitle();
  void fillHistoryMenu();
  // main_window_deform.cpp
  void makeDeformScene();
  void makeDeformActions();
  void makeMirrorActions();
  void syncDeformActions();
  // main_window_menus.cpp
  void makeMenus();
  void fillRecentMenu();
  void fillSampleMenu();
  void startTour();

  Settings& settings_;
  Actions actions_;
  Workspace workspace_;
  PoseEditor poses_;
  Playback playback_;
  VolumeMonitor volumes_;
  GroupLayout groupLayout_;
  HandlePlacer placer_;
  FileActions* files_;
  ExportActions* exports_;
  SampleLoader* samples_;
  ViewArea* viewArea_;
  std::unique_ptr<OrganScene> organScene_;
  std::unique_ptr<HandleScene> handleScene_;
  std::unique_ptr<RegionScene> regionScene_;
  std::unique_ptr<GizmoScene> gizmoScene_;
  std::unique_ptr<MotionGuide> motionGuide_;
  std::unique_ptr<ClickTool> clickTool_;
  std::unique_ptr<Measuring> measuring_;
  std::unique_ptr<StressMode> stress_;
  std::unique_ptr<PlayParts> play_;
  std::unique_ptr<ImportDesk> imports_;
  PanelDock* importDock_ = nullptr;
  BindingMessages* bindingMessages_ = nullptr;
  ModeRail* rail_ = nullptr;
  OrganPanel* organPanel_ = nullptr;
  HandlePanel* handlePanel_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  QStackedWidget* charts_ = nullptr; ///< Volumes, or stress in its mode.
  TimelineBar* timeline_ = nullptr;
  VolumePanel* volumePanel_ = nullptr;
  StatusLine* status_ = nullptr;
  WelcomeCard* welcome_ = nullptr;
  ShortcutCard* shortcuts_ = nullptr;
  TourCard* tour_ = nullptr;
  std::unique_ptr<ViewState> viewState_;
  SessionFiles* sessions_ = nullptr;
  QMenu* recentMenu_ = nullptr;
  QMenu* historyMenu_ = nullptr;
  QMenu* sampleMenu_ = nullptr;
  std::vector<PanelDock*> docks_;
  QByteArray standardLayout_;
  ThemeKind theme_ = ThemeKind::dark;
  Mode mode_ = Mode::explore;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
