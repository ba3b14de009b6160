#include "window/compare/comparison.h"

#include <QComboBox>
#include <QFileDialog>
#include <QMenu>
#include <QSpinBox>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidgetAction>

#include <algorithm>
#include <utility>

#include "viscera/medical_io/file_kind.h"
#include "viscera/presentation/presenter.h"
#include "window/compare/compared_stress.h"
#include "window/compare/compared_system.h"
#include "window/compare/difference_map.h"
#include "window/compare/error_table.h"
#include "window/compare/side_header.h"
#include "window/import/file_actions.h"
#include "window/style/language.h"
#include "window/timeline/sample_loader.h"
#include "window/timeline/timeline_bar.h"
#include "window/view/camera_link.h"
#include "window/view/organ_pointer.h"
#include "window/view/picture.h"
#include "window/view/view_area.h"
#include "window/widgets/ready_made.h"
#include "window/work/heap.h"

namespace viscera::app {
namespace {

/// Whether the two have the same shapes at rest, bound in the same way to the same handles.
bool sameButPosed(const document::DocumentState& a, const document::DocumentState& b) {
  const auto sameMesh = [](const auto& one, const auto& other) { return one->mesh == other->mesh; };
  return std::equal(a.organs->begin(), a.organs->end(), b.organs->begin(), b.organs->end(), sameMesh) &&
         a.pose->rows() == b.pose->rows() && a.rig->restPositions() == b.rig->restPositions() &&
         a.system->id == b.system->id && a.system->parameters.all() == b.system->parameters.all();
}

} // namespace

/// Everything that belongs to the second view; the window deletes its widgets itself.
struct Comparison::Second {
  Second(const First& first, QWidget* window)
      : workspace(first.workspace.registry()), playback(workspace, first.playback), placer(workspace),
        samples(workspace, placer, playback), files(workspace, placer, first.settings, window),
        view(new ViewWidget),
        picture(std::make_unique<Picture>(workspace, first.view, *view, Picture::Role::showing)) {
    picture->setValves([this] { return playback.valves(); });
    picture->setClock([this] { return playback.clock(); });
    names =
        std::make_unique<OrganPointer>(OrganPointer::Parts{workspace, first.view, *picture, *view}, nullptr);
  }

  Workspace workspace;
  Playback playback;
  HandlePlacer placer;
  SampleLoader samples;
  FileActions files;
  ViewWidget* view; ///< The window's, once it is there.
  std::unique_ptr<Picture> picture;
  std::unique_ptr<OrganPointer> names;
  std::unique_ptr<ComparedStress> stress;
  std::unique_ptr<CameraLink> cameras;
  std::unique_ptr<ComparedSystem> system; ///< While other coordinates are compared.
  std::unique_ptr<DifferenceMap> differences;
  std::vector<Subscription> subscriptions;
};

Comparison::Comparison(const First& first, QObject* parent) : QObject(parent), first_(first) {
  connect(&first.playback, &Playback::stateChanged, this, [this] {
    if (!on())
      return;
    if (same_)
      syncMotion();
    second_->view->view().setMoving(first_.playback.player().playing());
    second_->view->scheduleRender();
    syncHeaders();
  });
  connect(&first.volumes, &VolumeMonitor::shown, this, &Comparison::syncHeaders);
  connect(&first.volumes, &VolumeMonitor::chosenChanged, this, &Comparison::syncHeaders);
}

Comparison::~Comparison() {
  end();
}

Workspace& Comparison::workspace() {
  return second_->workspace;
}

Playback& Comparison::playback() {
  return second_->playback;
}

ViewWidget& Comparison::view() {
  return *second_->view;
}

Picture& Comparison::picture() const {
  return *second_->picture;
}

/// The first view's camera stays as it is: a view that becomes narrower moves its camera back by itself, and
/// restores it.
void Comparison::open() {
  wanted_.reset();
  if (on()) { // What it was still loading must not come in place of what is shown now.
    second_->workspace.jobs().cancelSlot(SampleLoader::kSlot);
    return;
  }
  second_ = std::make_unique<Second>(first_, first_.area.window());
  Second& second = *second_;
  firstHeader_ = new SideHeader(1);
  first_.area.splitView(firstHeader_, makeSecondPane());
  setTheme(theme_);
  second.stress = std::make_unique<ComparedStress>(
      ComparedStress::Side{first_.workspace, first_.playback, first_.picture},
      ComparedStress::Side{second.workspace, second.playback, *second.picture}, first_.view);
  connect(&second.workspace, &Workspace::messageRaised, this, [this](const Message& message) {
    offered_ = message.offers.empty() ? QString() : message.text;
    first_.workspace.say(message);
  });
  connect(&second.workspace, &Workspace::messageRetracted, &first_.workspace, &Workspace::messageRetracted);
  connect(&second.playback, &Playback::stateChanged, this, &Comparison::syncHeaders);
  connect(&second.samples, &SampleLoader::loaded, this, &Comparison::takeSample);
  connect(&second.samples, &SampleLoader::loaded, this, &Comparison::linkCameras);
  connect(&second.files, &FileActions::filesOpened, this, &Comparison::linkCameras);
  // After everyone has heard of the change: a change of the second document lets the transport of both tell
  // its state, and the pages of the first would be told in the midst of its change.
  second.subscriptions.push_back(first_.workspace.onChange([this](const document::Change&) {
    first_.workspace.afterChange([this] {
      if (on() && same_)
        mirror();
    });
  }));
  first_.volumes.setSecond(&second.workspace, &second.playback);
  Q_EMIT toggled(true);
}

QWidget* Comparison::makeSecondPane() {
  auto* pane = new QWidget;
  auto* column = makeLayout<QVBoxLayout>(pane, 0);
  secondHeader_ = new SideHeader(2, pane);
  fillHeader(*secondHeader_);
  // Views of one height show one organ in one size.
  connect(secondHeader_, &SideHeader::heightChanged, this,
          [this](int height) { first_.area.setHeaderHeight(height); });
  column->addWidget(secondHeader_);
  second_->view->setObjectName(QStringLiteral("secondView3d"));
  column->addWidget(second_->view, 1);
  return pane;
}

void Comparison::fillHeader(SideHeader& header) {
  rate_ = new QSpinBox(&header);
  rate_->setObjectName(QStringLiteral("secondRate"));
  rate_->setAccessibleName(tr("Rate of the second view"));
  rate_->setSuffix(tr(" / min"));
  rate_->setKeyboardTracking(false);
  header.addControl(rate_);
  connect(rate_, QOverload<int>::of(&QSpinBox::valueChanged), this,
          [this](int perMinute) { setSecondRate(perMinute); });
  auto* choose = makeIconButton("organs", tr("What this view shows"), &header);
  choose->setObjectName(QStringLiteral("secondOrgan"));
  choose->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(choose);
  menu->addAction(tr("The same organ at another rate"), this, &Comparison::showSameOrgan);
  menu->addAction(tr("The same organ with other coordinates"), this, &Comparison::showOtherCoordinates);
  menu->addAction(tr("The same organ, kept in the present pose"), this, &Comparison::showKeptPose);
  menu->addSeparator();
  first_.workspace.guarded([&] {
    for (const QString& name : second_->samples.names())
      menu->addAction(tr("Sample %1").arg(SampleLoader::nameInWords(name)), this,
                      [this, name] { showSample(name); });
  });
  menu->addSeparator();
  menu->addAction(tr("Open files..."), this, &Comparison::chooseFiles);
  choose->setMenu(menu);
  header.addAtEnd(choose);
  auto* close = makeIconButton("close", tr("Back to one view"), &header);
  close->setObjectName(QStringLiteral("closeSecond"));
  header.addAtEnd(close);
  // Queued: the button goes with the view that it closes.
  connect(close, &QToolButton::clicked, this, &Comparison::end, Qt::QueuedConnection);
}

ComparedSystem* Comparison::comparedSystem() const {
  return on() ? second_->system.get() : nullptr;
}

void Comparison::showOtherCoordinates() {
  open();
  what_ = presentation::Compared::What::coordinates;
  if (second_->system)
    return;
  same_ = true;
  second_->picture->setOfSameOrgans(true);
  second_->system =
      std::make_unique<ComparedSystem>(first_.workspace, second_->workspace, first_.area.messages());
  second_->differences =
      std::make_unique<DifferenceMap>(first_.workspace, second_->workspace, first_.view, *second_->picture);
  secondHeader_->addControl(second_->system->makeChooser());
  secondHeader_->addControl(makeDifferenceButton());
  secondHeader_->addControl(makeErrorsButton());
  connect(second_->system.get(), &ComparedSystem::chosen, this, [this] {
    second_->differences->restart();
    mirror();
    syncHeaders();
  });
  mirror();
  if (second_->playback.sequence())
    second_->playback.setRate(first_.playback.player().ratePerMinute());
  second_->cameras = std::make_unique<CameraLink>(*first_.area.view(), *second_->view);
  syncHeaders();
}

QToolButton* Comparison::makeDifferenceButton() {
  auto* button = makeIconButton("influence",
                                tr("Colour each vertex by its distance to the same vertex in view 1; while "
                                   "stress is shown, by what view "
                                   "1 has more than view 2"),
                                nullptr);
  button->setObjectName(QStringLiteral("differences"));
  button->setCheckable(true);
  connect(button, &QToolButton::toggled, second_->differences.get(), &DifferenceMap::setOn);
  return button;
}

/// Opens the table of the errors of both systems.
QToolButton* Comparison::makeErrorsButton() {
  auto* button = makeIconButton("info", tr("The errors of both coordinate systems"), nullptr);
  button->setObjectName(QStringLiteral("systemErrors"));
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  auto* action = new QWidgetAction(menu);
  action->setDefaultWidget(new ErrorTable(first_.workspace, second_->workspace));
  menu->addAction(action);
  button->setMenu(menu);
  return button;
}

DifferenceMap* Comparison::differences() const {
  return on() ? second_->differences.get() : nullptr;
}

/// Removes the parts that only the comparison of coordinates or poses has.
void Comparison::dropSystem() {
  if (!second_->differences)
    return;
  second_->differences.reset();
  second_->system.reset();
  delete secondHeader_->findChild<QComboBox*>(QStringLiteral("secondSystem"));
  for (const char* button : {"differences", "systemErrors"})
    delete secondHeader_->findChild<QToolButton*>(QLatin1String(button));
}

void Comparison::showSameOrgan() {
  open();
  dropSystem();
  same_ = true;
  second_->picture->setOfSameOrgans(true);
  what_ = presentation::Compared::What::rate;
  mirror();
  const live::Player& first = first_.playback.player();
  if (first_.playback.sequence()) {
    const double fastest = first_.playback.sequence()->highestRatePerMinute();
    const double slowest = first_.playback.sequence()->lowestRatePerMinute();
    const double twice = std::min(fastest, 2 * first.ratePerMinute());
    if (!beside_ && slowest < fastest)
      setSecondRate(twice > first.ratePerMinute() ? twice : first.ratePerMinute() / 2);
  }
  second_->cameras = std::make_unique<CameraLink>(*first_.area.view(), *second_->view);
  syncHeaders();
}

void Comparison::showKeptPose() {
  showPose(first_.workspace.live().shownPose());
}

void Comparison::showPose(const Points& pose) {
  open();
  dropSystem();
  same_ = false;
  what_ = presentation::Compared::What::pose;
  second_->picture->setOfSameOrgans(true);
  document::DocumentState state = first_.workspace.state();
  if (pose.rows() == state.pose->rows())
    state.pose = std::make_shared<const Points>(pose);
  second_->playback.forgetAll();
  second_->workspace.undo().reset(state);
  second_->differences =
      std::make_unique<DifferenceMap>(first_.workspace, second_->workspace, first_.view, *second_->picture);
  secondHeader_->addControl(makeDifferenceButton());
  second_->cameras = std::make_unique<CameraLink>(*first_.area.view(), *second_->view);
  syncHeaders();
}

void Comparison::setBeside(std::shared_ptr<const sequences::Sequence> sequence) {
  beside_ = std::move(sequence);
  if (on() && same_)
    syncMotion();
}

void Comparison::showSample(const QString& name) {
  show({presentation::Compared::What::sample, name.toStdString(), 0, {}});
}

/// Until the sample is loaded, the second view keeps what it has.
void Comparison::show(const presentation::Compared& sample) {
  open();
  dropSystem();
  same_ = false;
  if (what_ != presentation::Compared::What::sample)
    what_.reset();
  second_->picture->setOfSameOrgans(false);
  wanted_ = sample;
  second_->samples.load(text(sample.name), false);
}

void Comparison::showFiles(const QStringList& files) {
  open();
  dropSystem();
  what_.reset();
  second_->picture->setOfSameOrgans(false);
  if (same_) { // These organs go; they are not compared with what is opened.
    same_ = false;
    second_->playback.forgetAll();
    second_->workspace.undo().reset({});
  }
  second_->files.open(files);
}

void Comparison::chooseFiles() {
  const QString folder = first_.settings.value("files/folder").toString();
  QStringList patterns;
  for (const std::string& ending : medical_io::endingsOf(medical_io::FileKind::surface))
    patterns << QLatin1Char('*') + QString::fromStdString(ending);
  const QStringList files =
      QFileDialog::getOpenFileNames(first_.area.window(), tr("Open beside the first organ"), folder,
                                    tr("Organs (%1)").arg(patterns.join(QLatin1Char(' '))));
  if (!files.isEmpty())
    showFiles(files);
}

void Comparison::end() {
  if (!on())
    return;
  first_.workspace.retract(std::exchange(offered_, {}));
  first_.volumes.setSecond(nullptr, nullptr);
  second_->subscriptions.clear();
  const std::unique_ptr<Second> second = std::move(second_);
  same_ = false;
  if (secondHeader_) // Its table reads the second document, which goes with `second`.
    delete secondHeader_->findChild<QToolButton*>(QStringLiteral("systemErrors"));
  what_.reset();
  wanted_.reset();
  rates_.clear();
  // The picture releases the view's renderer before the view is deleted.
  second->differences.reset();
  second->system.reset();
  second->cameras.reset();
  second->stress.reset();
  second->names.reset();
  second->picture.reset();
  first_.area.joinViews();
  Q_EMIT toggled(false);
  // When `second` and the view are gone.
  QTimer::singleShot(0, [] { returnFreedMemory(); });
}

std::optional<presentation::Compared> Comparison::compared() const {
  if (on() && wanted_ && second_->samples.loading())
    return wanted_;
  if (!on() || !what_ || second_->workspace.document().organs().empty())
    return std::nullopt;
  using What = presentation::Compared::What;
  presentation::Compared compared;
  compared.what = *what_;
  if (*what_ == What::pose) {
    if (!sameButPosed(first_.workspace.state(), second_->workspace.state()))
      return std::nullopt;
    compared.pose = second_->workspace.document().pose();
  }
  if (*what_ == What::coordinates)
    compared.name = second_->system->system();
  if (*what_ == What::sample)
    compared.name = sample_.toStdString();
  if (second_->playback.sequence())
    compared.ratePerMinute = second_->playback.player().ratePerMinute();
  return compared;
}

/// Coordinates of a plugin, or samples, may be missing here.
bool Comparison::hasWhatIsIn(const presentation::Compared& compared) const {
  using What = presentation::Compared::What;
  bool there = true;
  if (compared.what == What::coordinates)
    there = first_.workspace.registry().contains(compared.name);
  if (compared.what == What::sample) {
    there = false;
    first_.workspace.guarded([&] { there = second_->samples.names().contains(text(compared.name)); });
  }
  return there;
}

void Comparison::restore(const presentation::Compared& compared) {
  using What = presentation::Compared::What;
  const bool posed =
      compared.what != What::pose || compared.pose.rows() == first_.workspace.document().pose().rows();
  const bool ofFirst = compared.what != What::sample;
  if ((ofFirst && first_.workspace.document().organs().empty()) || !posed)
    return;
  open();
  if (!hasWhatIsIn(compared)) {
    end();
    first_.workspace.say({Message::Severity::warning,
                          tr("The second view of the session is not shown: %1 is not installed here.")
                              .arg(text(compared.name)),
                          {},
                          0});
    return;
  }
  switch (compared.what) {
  case What::rate:
    showSameOrgan();
    break;
  case What::coordinates:
    showOtherCoordinates();
    second_->system->choose(compared.name);
    break;
  case What::pose:
    return showPose(compared.pose);
  case What::sample:
    return show(compared);
  }
  setSecondRate(compared.ratePerMinute);
}

void Comparison::setTheme(const Theme& theme) {
  theme_ = theme;
  if (!on())
    return;
  second_->view->setTheme(theme);
}

/// Makes the second document a copy of the first one. Organs whose surface and handles are the same stay
/// bound.
void Comparison::mirror() {
  const document::DocumentState& state = first_.workspace.state();
  second_->workspace.undo().reset(second_->system ? second_->system->applied(state) : state);
  if (second_->system)
    second_->system->mirrored();
  syncMotion();
}

void Comparison::syncMotion() {
  const Playback::Motion motion = first_.playback.motion();
  const auto& shown = beside_ && motion.sequence && !second_->system ? beside_ : motion.sequence;
  if (second_->playback.motion().sequence != shown)
    second_->playback.setSequence(shown, motion.organ);
  const auto known = rates_.find(shown);
  if (known != rates_.end() && known->second != second_->playback.player().ratePerMinute())
    setSecondRate(known->second);
}

/// Takes the first view's rate, or that of a session.
void Comparison::takeSample(const QString& name) {
  what_ = presentation::Compared::What::sample;
  sample_ = name;
  const auto wanted = std::exchange(wanted_, std::nullopt);
  if (wanted && wanted->ratePerMinute > 0)
    setSecondRate(wanted->ratePerMinute);
  else if (first_.playback.sequence())
    setSecondRate(first_.playback.player().ratePerMinute());
}

/// Sets the second view's rate, if its sequence can be played at it.
void Comparison::setSecondRate(double perMinute) {
  const sequences::Sequence* second = second_->playback.sequence();
  if (!second || perMinute < second->lowestRatePerMinute() || perMinute > second->highestRatePerMinute())
    return;
  rates_[second_->playback.motion().sequence] = perMinute;
  second_->playback.setRate(perMinute);
}

void Comparison::linkCameras() {
  ViewWidget& first = *first_.area.view();
  second_->cameras = std::make_unique<CameraLink>(first, *second_->view);
  const document::DocumentState& state = first_.workspace.state();
  const bool nothing = state.organs->empty() && !state.scan; // The camera looks at what was there.
  if (!same_)
    second_->cameras->setOffset(
        second_->view->view().bounds().center() -
        (nothing ? presentation::cameraOf(first.view()).focus : first.view().bounds().center()));
  syncHeaders();
}

QString Comparison::volumesOf(int side) const {
  const auto& lines = first_.volumes.lines();
  const std::size_t chosen = first_.volumes.chosenLine();
  QStringList parts;
  QStringList whole;
  for (const VolumeMonitor::Line& line : lines)
    if (line.side == side) {
      QStringList& texts = line.cavity ? parts : whole;
      const bool first = chosen < lines.size() && line.name == lines[chosen].name;
      texts.insert(first ? 0 : texts.size(),
                   QStringLiteral("%1 %2").arg(line.name, formatMilliliters(line.nowMl)));
    }
  // The end is cut off where there is little room: cavities say more than the organ around them, the chosen
  // one says most.
  return (parts + whole).join(QStringLiteral("   "));
}

QString Comparison::titleOf(const Workspace& workspace, const Playback& playback) const {
  if (const sequences::Sequence* sequence = playback.sequence())
    return inWords(sequence->name());
  const auto& organs = workspace.document().organs();
  return organs.empty() ? tr("No organ yet") : inWords(presentation::labelOf(*organs.front()));
}

/// The phases as long as the header names the present one.
QStringList Comparison::phasesOf(const Playback& playback) {
  QStringList names;
  if (playback.sequence() && playback.showing())
    for (const sequences::Phase& phase : playback.sequence()->phases(playback.player().ratePerMinute()))
      names.push_back(inWords(phase.name));
  return names;
}

void Comparison::syncHeaders() {
  if (!on() || !firstHeader_ || !secondHeader_)
    return;
  const live::Player& first = first_.playback.player();
  const auto systemName = [](const Workspace& workspace) {
    return inWords(workspace.registry().find(workspace.document().system().id)->name());
  };
  const bool kept = what_ == presentation::Compared::What::pose;
  QString title = second_->system ? systemName(first_.workspace)
                  : kept          ? tr("Present pose")
                                  : titleOf(first_.workspace, first_.playback);
  if (first_.playback.sequence() && !second_->system)
    title += tr("  %1 / min").arg(formatNumber(first.ratePerMinute(), 0));
  firstHeader_->setTitle(title);
  firstHeader_->setPhases(phasesOf(first_.playback));
  firstHeader_->setState(first_.playback.showing() ? inWords(first.phase()) : QString(), volumesOf(0));
  Playback& second = second_->playback;
  secondHeader_->setTitle(second_->system ? QString()
                          : kept          ? tr("Kept pose")
                                          : titleOf(second_->workspace, second));
  secondHeader_->setPhases(phasesOf(second));
  secondHeader_->setState(second.showing() ? inWords(second.player().phase()) : QString(), volumesOf(1));
  rate_->setVisible(second.sequence() != nullptr && !second_->system);
  if (second.sequence())
    showRate(*rate_, *second.sequence(), second.player().ratePerMinute());
}

} // namespace viscera::app
