#include "window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QFileInfo>
#include <QLayout>
#include <QMenu>
#include <QShortcut>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>

#include "viscera/scene/vtkVisceraGizmoWidget.h"
#include "viscera/scene/vtkVisceraHandleSetWidget.h"
#include "window/binding_messages.h"
#include "window/export_actions.h"
#include "window/import/import_desk.h"
#include "window/import/import_panel.h"
#include "window/measure/measure_box.h"
#include "window/measure/measuring.h"
#include "window/panels/deform_page.h"
#include "window/panels/explore_page.h"
#include "window/panels/handle_panel.h"
#include "window/panels/handles_page.h"
#include "window/panels/organ_panel.h"
#include "window/panels/play_page.h"
#include "window/play_parts.h"
#include "window/session/view_state.h"
#include "window/status_line.h"
#include "window/stress/stress_chart.h"
#include "window/stress/stress_mode.h"
#include "window/stress/stress_page.h"
#include "window/timeline/timeline_bar.h"
#include "window/timeline/volume_panel.h"
#include "window/view/click_tool.h"
#include "window/view/gizmo_scene.h"
#include "window/view/handle_scene.h"
#include "window/view/motion_guide.h"
#include "window/view/organ_scene.h"
#include "window/view/region_scene.h"
#include "window/view/view_area.h"
#include "window/widgets/mode_rail.h"
#include "window/widgets/panel_dock.h"
#include "window/widgets/shortcut_card.h"
#include "window/widgets/tour_card.h"
#include "window/widgets/welcome_card.h"

namespace viscera::app {
namespace {

constexpr int kLeftWidth = 272;
constexpr int kRightWidth = 288;
constexpr int kImportWidth = 360;
constexpr std::size_t kProperties = 2; ///< Among the docks.
constexpr int kChartHeight = 200;

} // namespace

MainWindow::MainWindow(Settings& settings, plugin::Registry registry, motion::Player::Clock clock,
                       QWidget* parent)
    : QMainWindow(parent), settings_(settings), actions_(this), workspace_(std::move(registry)),
      poses_(workspace_), playback_(workspace_, clock), volumes_(workspace_, playback_),
      groupLayout_(workspace_), placer_(workspace_),
      files_(new FileActions(workspace_, placer_, settings, this)),
      exports_(new ExportActions(workspace_, settings, this)),
      samples_(new SampleLoader(workspace_, placer_, playback_, this)), viewArea_(new ViewArea(this)) {
  setDockOptions(AnimatedDocks | AllowNestedDocks);
  setCentralWidget(viewArea_);
  organScene_ = std::make_unique<OrganScene>(workspace_, viewArea_->view()->view());
  handleScene_ = std::make_unique<HandleScene>(workspace_, poses_, viewArea_->view()->view());
  regionScene_ = std::make_unique<RegionScene>(workspace_, groupLayout_, viewArea_->view()->view());
  makeDeformScene();
  clickTool_ =
      std::make_unique<ClickTool>(workspace_, *viewArea_->view(), *organScene_, *handleScene_, *gizmoScene_);
  measuring_ = std::make_unique<Measuring>(workspace_, *viewArea_, *organScene_, *handleScene_,
                                           [this] { setMode(Mode::explore); });
  play_ = std::make_unique<PlayParts>(PlayParts::Window{workspace_, playback_, volumes_, *samples_,
                                                        *organScene_, *handleScene_, *viewArea_, settings_});
  imports_ = std::make_unique<ImportDesk>(workspace_, *files_, *viewArea_->view(), nullptr);
  bindingMessages_ = new BindingMessages(workspace_, viewArea_->messages(), this);
  makeFileActions();
  makeSessionActions();
  makeEditActions();
  makeModeActions();
  makeViewActions();
  measuring_->addTo(actions_);
  makeHandleActions();
  makeRegionActions();
  makeDeformActions();
  makeSequenceActions();
  makeHelpActions();
  stress_ = std::make_unique<StressMode>(workspace_, playback_, settings_, actions_, *viewArea_, *organScene_,
                                         *handleScene_);
  makeDocks();
  makeMenus();
  makeCards();
  connectParts();
  connectImports();
  connectTimeline();
  makeSession();
  setTheme(themeFromName(settings_.value("window/theme", QStringLiteral("dark")).toString()));
  setMode(Mode::explore);
  restoreLayout();
}

MainWindow::~MainWindow() = default;

void MainWindow::makeDocks() {
  rail_ = new ModeRail(this);
  auto* railBar = new QToolBar(tr("Modes"), this);
  railBar->setObjectName(QStringLiteral("modes"));
  railBar->setMovable(false);
  railBar->setContextMenuPolicy(Qt::PreventContextMenu);
  railBar->toggleViewAction()->setVisible(false);
  railBar->layout()->setContentsMargins(0, 0, 0, 0);
  railBar->setStyleSheet(QStringLiteral("QToolBar { border: none; padding: 0; spacing: 0; }"));
  railBar->addWidget(rail_);
  addToolBar(Qt::LeftToolBarArea, railBar);

  const auto addDock = [this](const QString& title, const char* id, Qt::DockWidgetArea area,
                              QWidget* contents, bool scrolling) {
    auto* dock = new PanelDock(title, id, this);
    dock->setContents(contents, scrolling);
    addDockWidget(area, dock);
    docks_.push_back(dock);
    return dock;
  };
  organPanel_ = new OrganPanel(workspace_, poses_, volumes_);
  handlePanel_ = new HandlePanel(workspace_, placer_);
  for (const char* id : {"handles.addEnclosing", "handles.remove", "handles.influence", "handles.save"})
    handlePanel_->addTool(actions_[id]);
  timeline_ = new TimelineBar;
  volumePanel_ = new VolumePanel(volumes_, playback_);
  charts_ = new QStackedWidget;
  charts_->addWidget(volumePanel_);
  charts_->addWidget(stress_->makeChart());
  auto* organs = addDock(tr("Organs"), "organs", Qt::LeftDockWidgetArea, organPanel_, true);
  auto* handles = addDock(tr("Handles"), "handles", Qt::LeftDockWidgetArea, handlePanel_, true);
  auto* properties = addDock(tr("Properties"), "properties", Qt::RightDockWidgetArea, makePages(), false);
  auto* timeline = addDock(tr("Timeline"), "timeline", Qt::BottomDockWidgetArea, timeline_, false);
  timeline->setTitleBarWidget(new QWidget(timeline));
  auto* chart = addDock(tr("Volumes"), "volumes", Qt::BottomDockWidgetArea, charts_, false);
  chart->setTitleBarWidget(new QWidget(chart));
  splitDockWidget(timeline, chart, Qt::Vertical);
  resizeDocks({organs, properties}, {kLeftWidth, kRightWidth}, Qt::Horizontal);
  resizeDocks({organs, handles}, {2, 3}, Qt::Vertical);
  resizeDocks({chart}, {kChartHeight}, Qt::Vertical);
  // Only there while files are looked at: in front of the properties, and in no menu.
  importDock_ = new PanelDock(tr("Import"), "import", this);
  importDock_->setContents(imports_->panel(), false);
  tabifyDockWidget(properties, importDock_);
  importDock_->hide();
  status_ = new StatusLine(workspace_, volumes_, statusBar());
  play_->connectPanels(*timeline_, *volumePanel_, *status_);
}

QWidget* MainWindow::makePages() {
  pages_ = new QStackedWidget;
  pages_->addWidget(scrolled(new ExplorePage(workspace_, actions_, measuring_->makeBox())));
  pages_->addWidget(scrolled(new HandlesPage(workspace_, groupLayout_, actions_)));
  pages_->addWidget(scrolled(new DeformPage(workspace_, poses_, volumes_, actions_)));
  pages_->addWidget(scrolled(stress_->makePage()));
  pages_->addWidget(scrolled(play_->makePage(actions_)));
  return pages_;
}

void MainWindow::makeCards() {
  welcome_ = new WelcomeCard(sampleMenu_, viewArea_);
  viewArea_->addCard(welcome_, Qt::AlignTop | Qt::AlignHCenter);
  welcome_->hide();
  shortcuts_ = new ShortcutCard(actions_, viewArea_);
  viewArea_->addCard(shortcuts_, Qt::AlignCenter);
  connect(welcome_, &WelcomeCard::openRequested, files_, [this] { files_->chooseAndOpen(); });
  connect(welcome_, &WelcomeCard::tourRequested, this, &MainWindow::startTour);
  connect(welcome_, &WelcomeCard::closed, this, [this] { settings_.setValue("window/welcome", false); });
}

void MainWindow::connectParts() {
  ViewWidget* view = viewArea_->view();
  connect(rail_, &ModeRail::modeChosen, this, &MainWindow::setMode);
  connect(&workspace_, &Workspace::messageRaised, viewArea_->messages(), &MessageBar::showMessage);
  connect(organScene_.get(), &OrganScene::changed, view, &ViewWidget::scheduleRender);
  connect(handleScene_.get(), &HandleScene::changed, view, &ViewWidget::scheduleRender);
  connect(regionScene_.get(), &RegionScene::changed, view, &ViewWidget::scheduleRender);
  connect(measuring_.get(), &Measuring::stateChanged, this, [this] {
    clickTool_->setPaused(measuring_->active());
    syncHint();
  });
  connect(view, &ViewWidget::filesDropped, files_, [this](const QStringList& files) { files_->open(files); });
  connect(files_, &FileActions::filesOpened, this, [this] {
    showWelcome(false);
    frameFromFront();
  });
  connect(files_, &FileActions::recentFilesChanged, this, &MainWindow::fillRecentMenu);
  connect(samples_, &SampleLoader::loaded, this, &MainWindow::frameFromFront);
  connect(bindingMessages_, &BindingMessages::bound, this, [this](double seconds) {
    if (mode_ == Mode::handles)
      viewArea_->showBadge(tr("Bound in %1 ms").arg(1000 * seconds, 0, 'f', 1));
  });
  connect(organPanel_, &OrganPanel::focusRequested, this, [this](document::OrganId organ) {
    workspace_.selection().setOrgan(organ);
    focusSelection();
  });
  subscriptions_.push_back(workspace_.undo().onChange([this] { syncActions(); }));
  subscriptions_.push_back(workspace_.onChange([this](const document::Change&) { syncActions(); }));
  subscriptions_.push_back(workspace_.selection().onChange([this] { syncActions(); }));
  connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this,
          &MainWindow::escape);
  syncActions();
}

void MainWindow::connectImports() {
  files_->setChecker([this](document::ImportDraft draft, const QStringList& files) {
    imports_->begin(std::move(draft), files);
  });
  connect(imports_.get(), &ImportDesk::opened, this, &MainWindow::showImports);
  connect(imports_.get(), &ImportDesk::closed, this, [this] {
    importDock_->hide();
    resizeDocks({docks_[kProperties]}, {kRightWidth}, Qt::Horizontal);
    viewArea_->view()->view().frame();
  });
  importDock_->installEventFilter(imports_.get()); // The cross of the panel cancels.
  connect(files_, &FileActions::foundNothingOdd, this, [this](const QStringList& files) {
    viewArea_->showBadge(tr("%1: checked, nothing odd").arg(QFileInfo(files.front()).fileName()));
  });
}

void MainWindow::showImports() {
  showWelcome(false);
  importDock_->show();
  importDock_->raise();
  resizeDocks({importDock_}, {kImportWidth}, Qt::Horizontal);
}

void MainWindow::connectTimeline() {
  connect(timeline_, &TimelineBar::playToggled, &playback_, &Playback::toggle);
  connect(timeline_, &TimelineBar::loopToggled, &playback_, &Playback::setLooping);
  connect(timeline_, &TimelineBar::rateChosen, &playback_, &Playback::setRate);
  connect(timeline_, &TimelineBar::scrubbed, &playback_, &Playback::seek);
  connect(timeline_, &TimelineBar::stepRequested, &playback_, &Playback::step);
  connect(timeline_, &TimelineBar::startRequested, &playback_, &Playback::toStart);
  connect(&playback_, &Playback::stateChanged, this, [this] {
    syncTimeline();
    viewArea_->view()->view().setMoving(playback_.player().playing());
    viewArea_->view()->scheduleRender();
  });
  connect(&playback_, &Playback::advanced, this, [this] {
    timeline_->setInstant(playback_.player().fraction(), playback_.player().secondsInCycle());
  });
  connect(&playback_, &Playback::playModeWanted, this, [this] { setMode(Mode::play); });
  syncTimeline();
}

void MainWindow::syncTimeline() {
  const motion::Player& player = playback_.player();
  const sequences::Sequence* sequence = playback_.sequence();
  for (const char* id : {"play.toggle", "play.loop", "play.forward", "play.back", "play.start"})
    actions_[id]->setEnabled(sequence);
  if (!sequence)
    return timeline_->clearSequence();
  timeline_->setSequence(text(sequence->name()), tr("/ min"), sequence->lowestRatePerMinute(),
                         sequence->highestRatePerMinute());
  timeline_->setRate(player.ratePerMinute());
  timeline_->setPlaying(player.playing());
  timeline_->setLooping(player.loop());
  actions_["play.loop"]->setChecked(player.loop());
  std::vector<PhaseBand> bands;
  for (const sequences::Phase& phase : sequence->phases(player.ratePerMinute()))
    bands.push_back({text(phase.name), phase.begin, phase.end});
  timeline_->setPhases(std::move(bands));
  timeline_->setInstant(player.fraction(), player.secondsInCycle());
}

void MainWindow::setMode(Mode mode) {
  mode_ = mode;
  rail_->setMode(mode);
  handleScene_->setMode(mode);
  regionScene_->setMode(mode);
  gizmoScene_->setMode(mode);
  motionGuide_->setMode(mode);
  clickTool_->setMode(mode);
  measuring_->setMode(mode);
  playback_.setMode(mode);
  handleScene_->setPlayed(playback_.showing());
  stress_->setActive(mode == Mode::stress);
  charts_->setCurrentIndex(mode == Mode::stress ? 1 : 0);
  pages_->setCurrentIndex(static_cast<int>(mode));
  syncDeformActions();
  syncHint();
}

void MainWindow::syncHint() {
  for (const ModeDescription& description : modeDescriptions())
    if (description.mode == mode_)
      status_->setHint(measuring_->active() ? measuring_->hint() : description.hint);
}

void MainWindow::setTheme(ThemeKind kind) {
  theme_ = kind;
  const Theme theme = themeOf(kind);
  applyTheme(*qApp, theme);
  viewArea_->view()->setTheme(theme);
  play_->setTheme(theme);
  measuring_->setTheme();
  volumePanel_->setTheme(theme);
  stress_->setTheme(theme);
  organScene_->setGhostColor({theme.muted.redF(), theme.muted.greenF(), theme.muted.blueF()});
  actions_[kind == ThemeKind::dark ? "theme.dark" : "theme.light"]->setChecked(true);
  settings_.setValue("window/theme", nameOf(kind));
}

void MainWindow::showWelcome(bool shown) {
  welcome_->setVisible(shown);
  if (shown)
    welcome_->raise();
}

void MainWindow::frameFromFront() {
  viewArea_->view()->view().lookFrom(scene::StandardView::anterior);
  viewArea_->view()->scheduleRender();
}

void MainWindow::focusSelection() {
  scene::OrganView& view = viewArea_->view()->view();
  const document::OrganId selected = workspace_.selection().organ();
  Bounds bounds = view.bounds();
  for (const auto& organ : view.organs())
    if (organScene_->organOf(organ.get()) == selected)
      bounds = organ->bounds();
  view.frame(bounds);
  viewArea_->view()->scheduleRender();
}

void MainWindow::escape() {
  vtkVisceraHandleSetWidget* widget = viewArea_->view()->view().handleWidget();
  if (widget->IsDragging())
    widget->CancelDrag();
  else if (gizmoScene_->dragging())
    viewArea_->view()->view().gizmoWidget()->CancelDrag();
  else if (stress_->escape() || measuring_->escape())
    return;
  else if (shortcuts_->isVisible())
    shortcuts_->hide();
  else if (!viewArea_->messages()->isHidden())
    viewArea_->messages()->dismiss();
  else
    workspace_.selection().clear();
}

void MainWindow::restoreLayout() {
  resize(1440, 900);
  standardLayout_ = saveState();
  restoreGeometry(settings_.value("window/geometry").toByteArray());
  restoreState(settings_.value("window/layout").toByteArray());
}

} // namespace viscera::app
