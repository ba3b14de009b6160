#include "window/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QStatusBar>

#include "window/archive/archive_actions.h"
#include "window/deform/deform_mode.h"
#include "window/export/dicom_exports.h"
#include "window/export/export_actions.h"
#include "window/export/lesson_export.h"
#include "window/export/report_export.h"
#include "window/handles/handle_panel.h"
#include "window/handles/handle_table.h"
#include "window/handles/handles_mode.h"
#include "window/help.h"
#include "window/import/arriving_surfaces.h"
#include "window/import/import_controller.h"
#include "window/import/import_panel.h"
#include "window/lecture/lecture_screen.h"
#include "window/lecture/slide_panel.h"
#include "window/lecture/slides.h"
#include "window/menus.h"
#include "window/modes/mode_charts.h"
#include "window/modes/mode_rail.h"
#include "window/modes/window_layout.h"
#include "window/organs/explore_mode.h"
#include "window/organs/organ_panel.h"
#include "window/play/play_mode.h"
#include "window/session/session_files.h"
#include "window/session/session_view.h"
#include "window/settings_dialog.h"
#include "window/slices/handle_grip.h"
#include "window/slices/patient_offer.h"
#include "window/slices/scan_actions.h"
#include "window/slices/slice_panes.h"
#include "window/slices/warp_export.h"
#include "window/stress/stress_mode.h"
#include "window/timeline/status_line.h"
#include "window/timeline/timeline_bar.h"
#include "window/timeline/volume_panel.h"
#include "window/track/contour_grip.h"
#include "window/track/plane_table.h"
#include "window/view/framing.h"
#include "window/view/organ_pointer.h"
#include "window/view/view_actions.h"
#include "window/view/view_area.h"
#include "window/widgets/first_picture.h"
#include "window/widgets/panel_dock.h"
#include "window/widgets/ready_made.h"
#include "window/work/binding_messages.h"

namespace viscera::app {

MainWindow::MainWindow(Settings& settings, coordinates::Registry registry, live::Player::Clock clock,
                       QWidget* parent)
    : QMainWindow(parent), settings_(settings), actions_(this), workspace_(std::move(registry)),
      poses_(workspace_, view_), playback_(workspace_, clock), volumes_(workspace_, playback_),
      placer_(workspace_), files_(new FileActions(workspace_, placer_, settings, this)),
      exports_(new ExportActions(workspace_, settings, this)),
      samples_(new SampleLoader(workspace_, placer_, playback_, this)),
      scans_(new ScanActions(workspace_, view_, settings, this)), viewArea_(new ViewArea(this)),
      layout_(new WindowLayout(*this, actions_)) {
  setCentralWidget(viewArea_);
  picture_ = std::make_unique<Picture>(workspace_, view_, *viewArea_->view());
  picture_->setValves([this] { return playback_.valves(); });
  picture_->setClock([this] { return playback_.clock(); });
  handles_ = std::make_unique<HandleController>(workspace_, poses_, view_, *picture_);
  imports_ = std::make_unique<ImportController>(workspace_, *files_, *picture_, nullptr);
  arriving_ = new ArrivingSurfaces(playback_, *picture_, this);
  files_->setArrivingSurfaces(arriving_);
  bindingMessages_ = new BindingMessages(workspace_, viewArea_->messages(), this);
  bindingMessages_->setMoved([this] { return playback_.player().movable(); });
  connect(&playback_, &Playback::stateChanged, bindingMessages_, &BindingMessages::followMotion);
  slices_ = std::make_unique<SlicePanes>(workspace_, view_, *picture_, *viewArea_, *scans_->sliceMenu());
  handleGrip_ = std::make_unique<HandleGrip>(*slices_, *picture_);
  slices_->addGrip(*handleGrip_);
  files_->addTo(actions_);
  scans_->addTo(actions_);
  new PatientOffer(
      workspace_, *files_, *scans_, [this] { return imports_->isOpen(); }, this);
  archive_ = new ArchiveActions(
      workspace_, settings_, [this](const QStringList& files) { files_->open(files); }, this);
  archive_->addTo(actions_);
  exports_->addTo(actions_);
  (new WarpExport(workspace_, settings_, this))->addTo(actions_);
  (new DicomExports({workspace_, playback_, archive_->client(), settings_}, this))->addTo(actions_);
  lessons_ = new LessonExport({workspace_, playback_, *picture_, view_, settings_}, this);
  lessons_->addTo(actions_);
  actions_.add("file.quit", {tr("&Quit"), nullptr, {QKeySequence::Quit}, {}}, [this] { close(); });
  views_ = new ViewActions({workspace_, *picture_, *viewArea_, view_, settings_}, actions_, this);
  makeModes();
  makeCorrections();
  (new HandleTable(workspace_, poses_, *picture_, *viewArea_->view(), this))->addTo(actions_);
  makeThemeActions();
  actions_.add("edit.settings",
               {tr("&Settings..."),
                nullptr,
                {QKeySequence::Preferences},
                tr("Language, theme, folders and what is shown at the start")},
               [this] { openSettings(); });
  actions_["edit.settings"]->setMenuRole(QAction::PreferencesRole);
  slides_ = new Slides(workspace_, view_, *viewArea_->view(), playback_, actions_, this);
  makeSession();
  lecture_ = new LectureScreen(
      {*layout_, *viewArea_, *slides_, playback_, volumes_, play_->circulation(), view_}, actions_, this);
  connect(actions_["view.lecture"], &QAction::toggled, this, [this] {
    showWelcome(false);
    giveTheme();
  });
  help_ = new Help({workspace_, playback_, *modes_, *files_, settings_, *viewArea_}, actions_, this);
  placePanels();
  makeMenus();
  connectView();
  connectFiles();
  connectHints();
  connectActions();
  setTheme(themeFromName(settings_.value("window/theme", QStringLiteral("dark")).toString()));
  layout_->restore(settings_);
}

MainWindow::~MainWindow() {
  // A drag under way ends while everything that observes the document is there.
  workspace_.guarded([this] { workspace_.undo().cancelStep(); });
}

/// Contours are corrected while the document has a motion from the images of its study.
void MainWindow::makeCorrections() {
  corrector_ = std::make_unique<ContourCorrector>(workspace_);
  MeasuredMotion& measured = play_->measured();
  corrector_->setSource([this, &measured]() -> std::optional<ContourCorrector::Origin> {
    const MeasuredMotion::Found* found = measured.present();
    if (!found || !found->images || !measured.isOfStudy())
      return std::nullopt;
    ContourCorrector::Origin origin{
        found->images->request, found->options, found->images->found.labelled, {}};
    for (const auto& organ : workspace_.document().organs())
      if (const auto surface = measured.surfaceOf(organ->id))
        origin.surfaces.emplace_back(organ->id, found->series->names[*surface]);
    return origin;
  });
  connect(corrector_.get(), &ContourCorrector::corrected, &measured,
          [&measured](const auto& motion) { measured.takeCorrected(*motion); });
  connect(&measured, &MeasuredMotion::changed, this, [this] { actions_.sync(); });
  contourGrip_ = std::make_unique<ContourGrip>(workspace_, *slices_, *corrector_, playback_);
  slices_->addCineGrip(*contourGrip_);
  contourGrip_->addTo(actions_, *scans_->sliceMenu());
}

void MainWindow::makeModes() {
  modes_ = std::make_unique<ModeController>(
      ModeController::Parts{playback_, view_, *viewArea_->view(), *picture_, *handles_});
  const ModeParts parts{workspace_,        playback_, poses_,     volumes_, placer_,   *samples_,
                        *bindingMessages_, settings_, *viewArea_, view_,    *picture_, *handles_};
  explore_ = &modes_->add(std::make_unique<ExploreMode>(parts, *slices_, actions_));
  modes_->add(std::make_unique<HandlesMode>(parts, actions_));
  modes_->add(std::make_unique<DeformMode>(parts, actions_));
  stress_ = &modes_->add(std::make_unique<StressMode>(parts, actions_));
  play_ = &modes_->add(std::make_unique<PlayMode>(parts, actions_));
  modes_->addTo(actions_);
}

void MainWindow::makeThemeActions() {
  auto* themes = new QActionGroup(this);
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    const bool dark = kind == ThemeKind::dark;
    themes->addAction(actions_.addToggle(dark ? "theme.dark" : "theme.light",
                                         {dark ? tr("&Dark") : tr("&Light"), "theme", {}, {}}, false,
                                         [this, kind](bool on) {
                                           if (on && theme_ != kind)
                                             setTheme(kind);
                                         }));
  }
}

void MainWindow::openSettings() {
  auto* dialog = findChild<SettingsDialog*>();
  if (!dialog) {
    dialog = new SettingsDialog(settings_, actions_, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
  }
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

void MainWindow::makeSession() {
  sessionView_ = std::make_unique<SessionView>(SessionView::Window{
      workspace_, playback_, view_, *picture_, *modes_, play_->measured(), play_->comparison(), *slides_});
  sessions_ = new SessionFiles(workspace_, playback_, *sessionView_, settings_, this);
  sessions_->addTo(actions_);
  (new ReportExport({workspace_, playback_, *sessionView_, *sessions_, settings_}, this))->addTo(actions_);
  connect(sessions_, &SessionFiles::fetchWanted, this,
          [this](const medical_io::ArchiveOrigin& origin, const QString& name, const QString& session) {
            archive_->fetchAgain(origin, name.toStdString(), [this, session](const QString& folder) {
              sessions_->open(session, folder);
            });
          });
  files_->setSessionOpener([this](const QString& file) { sessions_->open(file); });
}

void MainWindow::placePanels() {
  timeline_ = new TimelineBar(playback_, actions_);
  timeline_->follow(view_, *new StudyPlayer(workspace_, view_, playback_, this), volumes_);
  organPanel_ = new OrganPanel(workspace_, poses_, volumes_);
  organPanel_->addTo(actions_);
  auto* handlePanel = new HandlePanel(workspace_, placer_);
  for (const char* id : {"handles.addEnclosing", "handles.remove", "handles.influence", "handles.save"})
    handlePanel->addTool(actions_[id]);
  volumePanel_ = new VolumePanel(volumes_, playback_, view_);
  volumePanel_->setMeasured(play_->measured(), play_->makeResiduals());
  layout_->place({new ModeRail(*modes_), organPanel_, handlePanel, makePages(), timeline_,
                  new ModeCharts(*modes_, volumePanel_, play_->makeStrain(actions_), *layout_),
                  new SlidePanel(*slides_, actions_), imports_->panel()});
  const auto follow = [this] { layout_->follow(modes_->present()); };
  connect(modes_.get(), &ModeController::changed, layout_, follow);
  for (const auto& mode : modes_->all())
    connect(mode.get(), &Mode::panelsChanged, layout_, follow);
  connect(&playback_, &Playback::stateChanged, layout_, follow);
  connect(&playback_, &Playback::advanced, layout_, follow); // The timeline was dragged.
  follow();
  status_ = new StatusLine(workspace_, volumes_, statusBar());
  play_->setStatus(*status_);
}

QWidget* MainWindow::makePages() {
  auto* pages = new QStackedWidget;
  for (const auto& mode : modes_->all())
    pages->addWidget(scrolled(mode->makePage(actions_)));
  connect(modes_.get(), &ModeController::changed, pages,
          [this, pages] { pages->setCurrentIndex(modes_->index()); });
  return pages;
}

void MainWindow::makeMenus() {
  menuBar()->setObjectName(QStringLiteral("menus"));
  auto* menus = new Menus(
      *menuBar(), {actions_, *modes_, *files_, *samples_, *scans_, workspace_, settings_, layout_->docks()});
  connect(files_, &FileActions::recentFilesChanged, menus, &Menus::fillRecent);
  connect(sessions_, &SessionFiles::recentFilesChanged, menus, &Menus::fillRecent);
  help_->makeCards(*menuBar(), menus->samples());
}

void MainWindow::connectView() {
  ViewWidget* view = viewArea_->view();
  connect(&view_, &ViewModel::changed, volumePanel_,
          [this] { volumePanel_->setCycleShown(view_.state().chartOfCycle); });
  connect(&playback_, &Playback::stateChanged, view, [this, view] {
    view->view().setMoving(playback_.player().playing());
    view->scheduleRender();
  });
  auto* pointer = new OrganPointer({workspace_, view_, *picture_, *view}, organPanel_->menu(), this);
  connect(pointer, &OrganPointer::aloneWanted, actions_["organ.showOnly"], &QAction::trigger);
  connect(pointer, &OrganPointer::allWanted, actions_["organ.showAll"], &QAction::trigger);
}

void MainWindow::connectFiles() {
  const auto fromFront = [this] { views_->lookFrom(scene::StandardView::anterior); };
  connect(viewArea_->view(), &ViewWidget::filesDropped, files_,
          [this](const QStringList& files) { files_->open(files); });
  connect(files_, &FileActions::filesOpened, this, [this, fromFront] {
    showWelcome(false);
    fromFront();
  });
  connect(files_, &FileActions::foundNothingOdd, this, [this](const QStringList& files) {
    const QString name = shortenedName(QFileInfo(files.front()).fileName(), *viewArea_);
    viewArea_->showBadge(tr("%1: checked, no problems found").arg(name));
  });
  connect(slides_, &Slides::kept, this,
          [this](const QString& caption) { viewArea_->showBadge(tr("View kept as %1").arg(caption)); });
  connect(files_, &FileActions::scanOpened, scans_, [this] {
    showWelcome(false);
    scans_->opened();
  });
  connect(scans_, &ScanActions::layoutChosen, viewArea_, &ViewArea::frameSoon);
  connect(new Framing(workspace_, view_, this), &Framing::wanted, viewArea_, &ViewArea::frameSoon);
  // Undone or redone images give the view another size; a session, which has no steps yet, has a camera.
  subscriptions_.push_back(workspace_.onChange([this](const document::Change& change) {
    if ((change.scan() || change.study()) && !workspace_.undo().names().empty())
      viewArea_->frameSoon();
  }));
  connect(files_, &FileActions::scansFound, scans_, &ScanActions::open);
  connect(files_, &FileActions::filesOpened, scans_, &ScanActions::reportScanFit);
  connect(sessionView_.get(), &SessionView::framingWanted, this, [this, fromFront] {
    fromFront();
    viewArea_->frameSoon(); // Once the layout of the session has its sizes.
  });
  connect(samples_, &SampleLoader::loaded, this, fromFront);
  connectFirstPicture();
  connect(&play_->measured(), &MeasuredMotion::changed, this,
          [this] { stress_->model().setCaution(play_->measured().caution()); });
  slices_->setVerdicts(
      [this](std::size_t slice) { return planeVerdict(play_->measured(), playback_, slice); });
  connect(&play_->measured(), &MeasuredMotion::changed, slices_.get(), &SlicePanes::markOutdated);
  connect(&play_->measured(), &MeasuredMotion::found, this, [this, fromFront] {
    showWelcome(false);
    play_->comparison().end();
    setMode("play"); // Where its table is.
    fromFront();
    viewArea_->frameSoon(); // Once the table has its place.
  });
  connect(samples_, &SampleLoader::loaded, sessions_, &SessionFiles::sampleLoaded);
  connect(sessions_, &SessionFiles::opened, this, [this] {
    viewArea_->messages()->dismiss(); // Its offers were for the document before.
    showWelcome(false);
    play_->comparison().end();
  });
  files_->setChecker([this](document::ImportDraft draft, const QStringList& files) {
    imports_->begin(std::move(draft), files);
  });
  connect(imports_.get(), &ImportController::opened, this, [this] {
    showWelcome(false);
    layout_->showImports();
  });
  connect(imports_.get(), &ImportController::closed, this, [this] {
    layout_->hideImports();
    viewArea_->view()->view().frame();
  });
  layout_->imports()->installEventFilter(imports_.get()); // The cross of the panel cancels.
}

/// An empty window shows the sample that a worker makes.
void MainWindow::connectFirstPicture() {
  auto* picture = new FirstPicture(viewArea_);
  viewArea_->addCard(picture, {});
  picture->stackUnder(viewArea_->messages());
  connect(samples_, &SampleLoader::began, picture, [this, picture](const QString& name) {
    if (!workspace_.document().organs().empty())
      return;
    picture->showSample(name);
    organPanel_->setWaiting(true);
  });
  connect(samples_, &SampleLoader::ended, picture, [this, picture] {
    picture->hide();
    organPanel_->setWaiting(false);
  });
}

void MainWindow::connectHints() {
  connect(&workspace_, &Workspace::messageRaised, viewArea_->messages(), &MessageBar::showMessage);
  connect(&workspace_, &Workspace::messageRetracted, viewArea_->messages(), &MessageBar::retract);
  const auto hint = [this] { status_->setHint(modes_->present().hint()); };
  connect(modes_.get(), &ModeController::hintChanged, status_, hint);
  hint();
  connect(modes_.get(), &ModeController::dragUndone, this,
          [this] { workspace_.note(tr("Viscera cancelled the drag because you chose another mode.")); });
  // The reason why a drag stops is shown in place of the mode's hint.
  connect(&poses_, &PoseEditor::obstacleChanged, status_, [this, hint](const QString& obstacle) {
    if (obstacle.isEmpty())
      hint();
    else
      status_->setHint(tr("Only partly possible: %1").arg(obstacle));
  });
}

void MainWindow::connectActions() {
  const auto sync = [this] { actions_.sync(); };
  subscriptions_.push_back(workspace_.undo().onChange(sync));
  subscriptions_.push_back(workspace_.onChange([sync](const document::Change&) { sync(); }));
  subscriptions_.push_back(workspace_.selection().onChange(sync));
  connect(&view_, &ViewModel::changed, &actions_, &Actions::sync);
  connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this,
          &MainWindow::escape);
  sync();
}

void MainWindow::setTheme(ThemeKind kind) {
  theme_ = kind;
  applyTheme(*qApp, themeOf(kind));
  giveTheme();
  actions_[kind == ThemeKind::dark ? "theme.dark" : "theme.light"]->setChecked(true);
  settings_.setValue("window/theme", nameOf(kind));
}

/// Views and charts paint themselves; in a lecture they are read from afar.
void MainWindow::giveTheme() {
  Theme theme = themeOf(theme_);
  theme.lecture = lecture_->on();
  viewArea_->view()->setTheme(theme);
  slices_->setTheme(theme);
  lecture_->setTheme(theme);
  for (const auto& mode : modes_->all())
    mode->setTheme(theme);
  volumePanel_->setTheme(theme);
}

void MainWindow::showWelcome(bool shown) {
  help_->showWelcome(shown);
}

void MainWindow::escape() {
  if (lecture_->end() || modes_->escape() || help_->close())
    return;
  if (!viewArea_->messages()->isHidden())
    viewArea_->messages()->dismiss();
  else
    workspace_.selection().clear();
}

/// Whether no file is being written, or the user does without it.
bool MainWindow::leavesUnwritten() {
  QStringList writing = workspace_.writing();
  if (play_->recorder().running())
    writing.push_back(tr("Writing a movie"));
  if (writing.isEmpty())
    return true;
  if (unwrittenQuestion_)
    return unwrittenQuestion_(writing);
  QMessageBox box(QMessageBox::Question, tr("Close without these files?"),
                  tr("Viscera is still writing: %1.").arg(writing.join(QStringLiteral(", "))),
                  QMessageBox::NoButton, this);
  box.setInformativeText(tr("If you close Viscera now, it does not finish these files."));
  QPushButton* close = box.addButton(tr("&Close"), QMessageBox::DestructiveRole);
  box.setDefaultButton(box.addButton(tr("&Wait"), QMessageBox::RejectRole));
  box.exec();
  return box.clickedButton() == close;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  // Saving goes on behind this, and closes the window when it is done.
  const auto atOnce = std::make_shared<bool>(true);
  const bool leaves = sessions_->whenSaved([this, atOnce] {
    if (!*atOnce)
      close();
  });
  *atOnce = false;
  if (!leaves || !leavesUnwritten())
    return event->ignore();
  imports_->cancel();
  lecture_->end();
  layout_->save(settings_);
  workspace_.jobs().cancelAll();
  sessions_->endCleanly();
  QMainWindow::closeEvent(event);
}

} // namespace viscera::app
