#pragma once

#include <QMainWindow>

#include <functional>
#include <memory>
#include <string>

#include "window/import/file_actions.h"
#include "window/modes/mode_controller.h"
#include "window/style/theme.h"
#include "window/timeline/playback.h"
#include "window/timeline/sample_loader.h"
#include "window/timeline/volume_monitor.h"
#include "window/view/pose_editor.h"
#include "window/view/view_model.h"
#include "window/work/actions.h"
#include "window/work/handle_placer.h"
#include "window/work/settings.h"
#include "window/work/workspace.h"

namespace viscera::app {

class ArchiveActions;
class ArrivingSurfaces;
class BindingMessages;
class ExploreMode;
class ExportActions;
class ContourCorrector;
class ContourGrip;
class HandleGrip;
class Help;
class ImportController;
class LectureScreen;
class LessonExport;
class OrganPanel;
class PlayMode;
class ScanActions;
class SessionFiles;
class SessionView;
class SlicePanes;
class Slides;
class StatusLine;
class StressMode;
class TimelineBar;
class ViewActions;
class ViewArea;
class VolumePanel;
class WindowLayout;

/// The main window of the program: creates the parts of the window and connects them to each other.
class MainWindow final : public QMainWindow {
  Q_OBJECT

public:
  /// `settings` has to outlive the window. `registry` has the coordinate systems to choose from, `clock`
  /// drives the sequences.
  MainWindow(Settings& settings, coordinates::Registry registry, live::Player::Clock clock,
             QWidget* parent = nullptr);
  ~MainWindow() override;

  Workspace& workspace() { return workspace_; }
  Playback& playback() { return playback_; }
  PoseEditor& poses() { return poses_; }
  const VolumeMonitor& volumes() const { return volumes_; }
  FileActions& files() { return *files_; }
  ImportController& imports() { return *imports_; }
  ExportActions& exports() { return *exports_; }
  LessonExport& lessons() { return *lessons_; }
  ArchiveActions& archive() { return *archive_; }
  SampleLoader& samples() { return *samples_; }
  SessionFiles& sessions() { return *sessions_; }
  StressMode& stress() { return *stress_; }
  ExploreMode& explore() { return *explore_; }
  ViewArea& viewArea() { return *viewArea_; }
  ViewActions& views() { return *views_; }
  ViewModel& viewModel() { return view_; }
  Slides& slides() { return *slides_; }
  const Picture& picture() const { return *picture_; }
  ArrivingSurfaces& arrivingSurfaces() { return *arriving_; }
  SlicePanes& slices() { return *slices_; }
  ScanActions& scans() { return *scans_; }
  PlayMode& play() { return *play_; }
  ModeController& modes() { return *modes_; }
  const Actions& actions() const { return actions_; }

  /// The id of the present mode.
  std::string mode() const { return modes_->present().description().id; }
  void setMode(const std::string& id) { modes_->choose(id); }
  void setTheme(ThemeKind kind);
  void showWelcome(bool shown);
  /// Replaces, for tests, the dialog that asks whether to close the window while these files are being
  /// written.
  void setUnwrittenQuestion(std::function<bool(const QStringList& names)> question) {
    unwrittenQuestion_ = std::move(question);
  }

protected:
  void closeEvent(QCloseEvent* event) override;

private:
  bool leavesUnwritten();
  void makeModes();
  void makeCorrections();
  void makeThemeActions();
  void openSettings();
  void giveTheme();
  void makeSession();
  void placePanels();
  QWidget* makePages();
  void makeMenus();
  void connectView();
  void connectFiles();
  void connectFirstPicture();
  void connectHints();
  void connectActions();
  void escape();

  Settings& settings_;
  Actions actions_;
  Workspace workspace_;
  ViewModel view_;
  PoseEditor poses_;
  Playback playback_;
  VolumeMonitor volumes_;
  HandlePlacer placer_;
  FileActions* files_;
  ExportActions* exports_;
  ArchiveActions* archive_ = nullptr;
  LessonExport* lessons_ = nullptr;
  SampleLoader* samples_;
  ScanActions* scans_;
  ViewArea* viewArea_;
  WindowLayout* layout_;
  std::unique_ptr<Picture> picture_;
  std::unique_ptr<HandleController> handles_;
  std::unique_ptr<SlicePanes> slices_;
  ArrivingSurfaces* arriving_;
  std::unique_ptr<ImportController> imports_;
  BindingMessages* bindingMessages_ = nullptr;
  std::unique_ptr<ModeController> modes_;
  ExploreMode* explore_ = nullptr; ///< Owned with the other modes, as are the next two.
  StressMode* stress_ = nullptr;
  PlayMode* play_ = nullptr;
  ViewActions* views_ = nullptr;
  Slides* slides_ = nullptr;
  LectureScreen* lecture_ = nullptr;
  OrganPanel* organPanel_ = nullptr;
  VolumePanel* volumePanel_ = nullptr;
  TimelineBar* timeline_ = nullptr;
  StatusLine* status_ = nullptr;
  Help* help_ = nullptr;
  std::unique_ptr<SessionView> sessionView_;
  SessionFiles* sessions_ = nullptr;
  ThemeKind theme_ = ThemeKind::dark;
  std::vector<Subscription> subscriptions_;
  std::unique_ptr<HandleGrip> handleGrip_;
  std::unique_ptr<ContourCorrector> corrector_;
  std::unique_ptr<ContourGrip> contourGrip_;
  std::function<bool(const QStringList&)> unwrittenQuestion_;
};

} // namespace viscera::app
