#include "window/play/play_mode.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/document/circulation_commands.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/study_item.h"
#include "viscera/heart/beating_heart.h"
#include "viscera/live/cine_reading.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/presentation/strain_figure.h"
#include "viscera/workbench/loaded_sample.h"
#include "window/movie/shown_signs.h"
#include "window/play/play_page.h"
#include "window/strain/axis_picker.h"
#include "window/strain/heart_segments.h"
#include "window/style/language.h"
#include "window/timeline/sample_loader.h"
#include "window/timeline/status_line.h"
#include "window/view/view_area.h"

namespace viscera::app {
namespace {

/// An organ without cavities hides nothing of its own, only its neighbours.
constexpr double kPlainOpacity = 0.45;
constexpr double kOpaque = 0.99;

bool hasInside(const document::OrganList& organs, document::OrganId id) {
  return std::any_of(organs.begin(), organs.end(), [id](const auto& other) { return other->parent == id; });
}

/// The organs through which one looks: walls of cavities, or all of them when there is none.
std::vector<std::shared_ptr<const document::Organ>> wallsOf(const document::OrganList& organs) {
  std::vector<std::shared_ptr<const document::Organ>> walls;
  std::copy_if(organs.begin(), organs.end(), std::back_inserter(walls),
               [&](const auto& organ) { return hasInside(organs, organ->id); });
  return walls.empty() ? organs : walls;
}

bool holdsSampleHeart(const Playback& playback) {
  const auto motions = playback.motions();
  return std::any_of(motions.begin(), motions.end(),
                     [](const auto& motion) { return live::sampleHeartOf(motion.recipe).has_value(); });
}

QString keyRemark(const document::SequenceKey& key) {
  return PlayMode::tr("Key at %1 s").arg(formatNumber(key.seconds, 2));
}

} // namespace

PlayMode::PlayMode(const ModeParts& parts, Actions& actions)
    : Mode(parts, {"play", "beat", 5, tr("Play"),
                   tr("Space plays or pauses; drag the timeline to look at one instant")}),
      comparison_(std::make_unique<Comparison>(Comparison::First{parts.workspace, parts.playback,
                                                                 parts.volumes, parts.area, parts.settings,
                                                                 parts.view, parts.picture})),
      recorder_(std::make_unique<MovieRecorder>(parts.workspace)),
      keySequence_(std::make_unique<KeySequencePlayback>(parts.workspace, parts.playback)),
      circulation_(std::make_unique<CirculationModel>(parts.workspace, parts.playback)),
      measured_(std::make_unique<MeasuredMotion>(parts.workspace, parts.playback, parts.picture)),
      strain_(std::make_unique<StrainModel>(parts.workspace, parts.playback)) {
  parts.volumes.setMeasured(*measured_);
  strain_->setMeasured(*measured_);
  connect(recorder_.get(), &MovieRecorder::finished, this, &PlayMode::reportMovieWritten);
  makeLookActions(actions);
  makeMotionActions(actions);
  makeComparisonActions(actions);
  makeCirculationActions(actions);
  makeStrainActions(actions);
  connect(circulation_.get(), &CirculationModel::changed, this, &Mode::chartWantedChanged);
  connect(circulation_.get(), &CirculationModel::changed, this,
          [this] { comparison_->setBeside(circulation_->keptBeat()); });
  connect(&parts.view, &ViewModel::changed, this, &Mode::chartWantedChanged);
  subscription_ = parts.workspace.onChange([this](const document::Change& change) {
    if (change.keySequence())
      retractKey();
    if (change.organs())
      syncStrain(); // Axes are those of a heart of that shape.
    if (change.study() && parts_.workspace.state().study)
      takePerson();
  });
  connect(measured_.get(), &MeasuredMotion::found, this, &PlayMode::showImages);
}

/// Takes the body surface that a study states for the normal ranges, unless a user has given one.
void PlayMode::takePerson() {
  const auto surface = live::statedBodySurface(*parts_.workspace.state().study->study);
  if (surface && parts_.view.state().person.bodySurfaceM2 <= 0)
    parts_.view.change([&surface](presentation::ViewState& state) { state.person.bodySurfaceM2 = *surface; });
}

PlayMode::~PlayMode() {
  delete seriesDialog_; // The dialog uses objects that are destroyed now.
  comparison_->end();
  if (status_)
    status_->unwatch(recorder_->jobs());
}

void PlayMode::makeMotionActions(Actions& actions) {
  actions.add("play.slower",
              {tr("Slow &motion"), "tour", {Qt::Key_S}, tr("Slower, down to a tenth; then real time again")},
              [this] { slower(); });
  parts_.view.addToggle(actions, "play.cycle",
                        {tr("&Chart of one cycle"),
                         "chart",
                         {Qt::Key_O},
                         tr("Draw one cycle with a cursor instead of the last seconds")},
                        &presentation::ViewState::chartOfCycle);
  parts_.view.addToggle(actions, "play.beatSigns",
                        {tr("&ECG, sounds and valves"),
                         "chart",
                         {Qt::Key_E},
                         tr("Under the phases of a heart: a schematic electrocardiogram, S1 and S2, and "
                            "which valves are open")},
                        &presentation::ViewState::beatSigns);
  makeValvesAction(actions);
  actions.add("play.addKey",
              {tr("Record a &key"), "record", {tr("Ctrl+K")}, tr("Add the present pose to the key sequence")},
              [this] { addKey(); });
  actions.add("play.motionFromSeries",
              {tr("Motion from a ser&ies..."),
               "patient",
               {},
               tr("Compute a patient's own motion from surfaces or label maps of each phase of the cycle, or "
                  "from cine images and the labels of a few phases")},
              [this] { chooseSeries(); });
}

void PlayMode::makeValvesAction(Actions& actions) {
  valves_ = actions.addToggle(
      "play.valves",
      {tr("&Valves and flow"),
       "beat",
       {Qt::Key_V},
       tr("In the beating sample heart: leaflets as far open as the valves are, and arrows whose "
          "width shows the opening and whose length shows the speed of the blood")},
      false, [this](bool on) {
        if (valves_->isEnabled()) // Else the mark goes because no valves can be drawn.
          parts_.view.change([on](presentation::ViewState& state) { state.valves = on; });
      });
  valvesTip_ = valves_->toolTip();
  actions.onSync([this] { syncValves(); });
  connect(&parts_.playback, &Playback::stateChanged, this, &PlayMode::syncValves);
  connect(comparison_.get(), &Comparison::toggled, this, [this](bool on) {
    if (on)
      connect(&comparison_->playback(), &Playback::stateChanged, this, &PlayMode::syncValves);
    syncValves();
  });
}

/// The reason of both views; empty where one of them can draw valves.
QString PlayMode::whyNoValves() const {
  const auto tells = [](const Playback& playback) {
    const sequences::Sequence* sequence = playback.sequence();
    return sequence && heart::valvesAt(*sequence, 0, playback.player().ratePerMinute()).has_value();
  };
  const bool here = hasSampleHeart();
  const bool beside = comparison_->on() && holdsSampleHeart(comparison_->playback());
  if ((here && tells(parts_.playback)) || (beside && tells(comparison_->playback())))
    return {};
  return here || beside ? tr("This sequence has no valves; choose the heartbeat")
                        : tr("Only the sample heart has valves to show");
}

/// The action is checked if the view's choice has an effect; the choice itself is not changed.
void PlayMode::syncValves() {
  const QString why = whyNoValves();
  valves_->setEnabled(why.isEmpty());
  valves_->setToolTip(why.isEmpty() ? valvesTip_ : why);
  valves_->setChecked(why.isEmpty() && parts_.view.state().valves);
}

/// Contours that move on the images are to be seen, unless the user has chosen a layout with slices.
void PlayMode::showImages() {
  if (measured_->isOfStudy() && parts_.view.state().scan.layout == "3d")
    parts_.view.change([](presentation::ViewState& state) { state.scan.layout = "four"; });
}

MotionDialog& PlayMode::chooseSeries() {
  if (!seriesDialog_)
    seriesDialog_ = new MotionDialog(parts_.workspace, *measured_, parts_.settings, parts_.area.window());
  seriesDialog_->offerStudy();
  seriesDialog_->show();
  seriesDialog_->raise();
  seriesDialog_->activateWindow();
  return *seriesDialog_;
}

QWidget* PlayMode::makeResiduals() {
  residuals_ = new ResidualTable(*measured_, parts_.playback);
  return residuals_;
}

void PlayMode::makeComparisonActions(Actions& actions) {
  actions.add(
      "play.compare",
      {tr("Compare two &rates"),
       "compare",
       {tr("Ctrl+2")},
       tr("Show the same organs beside these at another rate, or with the circulation kept as before")},
      [this] { comparison_->showSameOrgan(); });
  actions.add("play.compareSystems",
              {tr("Compare &coordinates"),
               "compare",
               {tr("Ctrl+3")},
               tr("Show the same organs and handles beside these with another coordinate system")},
              [this] { comparison_->showOtherCoordinates(); });
  actions.add("play.comparePose",
              {tr("Compare with the present &pose"),
               "compare",
               {},
               tr("Show the present pose in a second view, to compare it with later poses")},
              [this] { comparison_->showKeptPose(); });
  actions.add("play.compareFiles",
              {tr("Compare with another &organ..."),
               "patient",
               {},
               tr("Open files in a second view beside these organs")},
              [this] { comparison_->chooseFiles(); });
  actions.add("play.compareTextbook",
              {tr("Compare with the te&xtbook's heart"),
               "heart",
               {},
               tr("Show the sample heart with its textbook beat beside these organs, at their rate")},
              [this] { comparison_->showSample(QStringLiteral("heart")); });
  actions.enableWhile({"play.comparePose", "play.compareTextbook"},
                      [this] { return !parts_.workspace.document().organs().empty(); });
  QAction* single =
      actions.add("play.single", {tr("&One view"), nullptr, {tr("Ctrl+1")}, tr("Close the second view")},
                  [this] { comparison_->end(); });
  single->setEnabled(false);
  connect(comparison_.get(), &Comparison::toggled, this, [this, single](bool on) {
    single->setEnabled(on);
    if (!status_)
      return;
    if (secondJobs_)
      status_->unwatch(*secondJobs_);
    secondJobs_ = on ? &comparison_->workspace().jobs() : nullptr;
    if (secondJobs_)
      status_->watch(*secondJobs_);
  });
}

void PlayMode::makeCirculationActions(Actions& actions) {
  parts_.view.addToggle(
      actions, "play.circulationChart",
      {tr("&Pressures and loops"),
       "chart",
       {Qt::Key_P},
       tr("Where a circulation moves the heart, show its curves below the view instead of the volumes")},
      &presentation::ViewState::circulationChart);
  actions.add("play.keepBefore",
              {tr("Keep circ&ulation for comparison"),
               "compare",
               {tr("Ctrl+B")},
               tr("Keep this circulation to compare with: dashed loops and a second column of numbers")},
              [this] { parts_.workspace.perform(document::keepCirculation()); });
  actions.add("play.forgetBefore", {tr("&Discard kept circulation"), "remove", {}, tr("End the comparison")},
              [this] { parts_.workspace.perform(document::forgetKeptCirculation()); });
  actions.enableWhile({"play.keepBefore", "play.circulationChart"}, [this] { return circulation_->on(); });
  actions.enableWhile({"play.forgetBefore"},
                      [this] { return circulation_->on() && circulation_->choice().kept.has_value(); });
}

void PlayMode::makeStrainActions(Actions& actions) {
  using presentation::ViewState;
  parts_.view.addToggle(actions, "play.strain",
                        {tr("&Strain of the wall"),
                         "chart",
                         {},
                         tr("Below the view, show curves and bull's eye of the heart's strain instead of the "
                            "volumes")},
                        [](ViewState& state) -> bool& { return state.strain.chart; });
  parts_.view.addToggle(actions, "play.strainOnOrgan",
                        {tr("Se&gments on the organ"),
                         "stress",
                         {},
                         tr("Colour the heart's wall by the strain of its segments; a click chooses one")},
                        [](ViewState& state) -> bool& { return state.strain.onOrgan; });
  actions.add("play.exportStrain", {tr("Expo&rt strain..."), "export", {}, {}},
              [this] { chooseStrainFile(); });
  actions.enableWhile({"play.strain", "play.strainOnOrgan"}, [this] { return strain_->possible(); });
  actions.enableWhile({"play.exportStrain"}, [this] { return strain_->cycle() != nullptr; });
  connect(strain_.get(), &StrainModel::changed, &actions, &Actions::sync);
  connect(strain_.get(), &StrainModel::changed, this, &PlayMode::syncSegments);
  connect(&parts_.playback, &Playback::advanced, this, [this] {
    if (parts_.view.state().strain.moment == live::StrainMoment::instant)
      syncSegments();
  });
  connect(&parts_.view, &ViewModel::changed, this, &PlayMode::syncStrain);
  connect(comparison_.get(), &Comparison::toggled, this, [this](bool on) {
    secondStrain_.reset();
    if (on) {
      secondStrain_ = std::make_unique<StrainModel>(comparison_->workspace(), comparison_->playback());
      connect(secondStrain_.get(), &StrainModel::changed, this, &PlayMode::syncSegments);
      connect(&comparison_->playback(), &Playback::advanced, secondStrain_.get(), [this] {
        if (parts_.view.state().strain.moment == live::StrainMoment::instant)
          syncSegments();
      });
    }
    if (strainPanel_)
      strainPanel_->setSecond(secondStrain_.get());
    syncStrain();
  });
}

StrainPanel* PlayMode::makeStrain(const Actions& actions) {
  strainPanel_ =
      new StrainPanel({*strain_, parts_.playback, parts_.view, parts_.picture, *parts_.area.view()}, actions);
  syncStrain();
  return strainPanel_;
}

void PlayMode::syncStrain() {
  const presentation::StrainLook& look = parts_.view.state().strain;
  const auto left = workspace_.document().organ(look.axesOf);
  const StrainChoice choice{
      look.reference, {look.base, look.apex, look.insertion}, left ? left->mesh : nullptr};
  strain_->choose(choice);
  strain_->setWanted(look.chart || look.onOrgan);
  if (secondStrain_) {
    secondStrain_->choose(choice);
    secondStrain_->setWanted(look.chart || look.onOrgan);
  }
  syncSegments();
}

/// Only the modes that move the heart have the switch, and so the colours.
bool PlayMode::segmentsWanted() const {
  const presentation::ViewState& view = parts_.view.state();
  const bool moves = view.mode == "play" || view.mode == "deform";
  return view.strain.onOrgan && moves && !view.shown.stress;
}

void PlayMode::syncSegments() {
  const auto colors = [this](const HeartSegments& heart) {
    return segmentsWanted() && heart.known() ? std::optional(heart.now(parts_.view.state().strain))
                                             : std::nullopt;
  };
  parts_.picture.setSegments(colors({*strain_, parts_.playback}));
  if (secondStrain_ && comparison_->on())
    comparison_->picture().setSegments(colors({*secondStrain_, comparison_->playback()}));
}

std::function<presentation::SurfaceMap(double)> PlayMode::segmentsOverTime(const StrainModel* strain,
                                                                           const Playback& playback) const {
  if (!strain || !segmentsWanted())
    return nullptr;
  return HeartSegments(*strain, playback).overTime(parts_.view.state().strain);
}

void PlayMode::click(const ClickedPlace* place) {
  Mode::click(place);
  if (strainPanel_ && strainPanel_->axes().picking())
    return;
  const std::vector<int>* segments =
      place && parts_.view.state().strain.onOrgan ? strain_->segmentsOn(place->organ) : nullptr;
  if (!segments)
    return;
  const Points& points = parts_.workspace.live().points(place->organ);
  if (points.rows() != static_cast<Eigen::Index>(segments->size()))
    return;
  Eigen::Index nearest = 0;
  (points.rowwise() - place->position.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  const int segment = (*segments)[static_cast<std::size_t>(nearest)];
  parts_.view.change([segment](presentation::ViewState& state) {
    state.strain.segment = state.strain.segment == segment ? 0 : segment;
  });
}

void PlayMode::chooseStrainFile() {
  const QString folder = parts_.settings.folder(kFolderKey, QStandardPaths::DocumentsLocation);
  const QString chosen =
      QFileDialog::getSaveFileName(parts_.area.window(), tr("Strain"), folder + QStringLiteral("/strain.csv"),
                                   tr("Comma-separated values (*.csv)") + QStringLiteral(";;PNG (*.png)"));
  if (!chosen.isEmpty())
    exportStrain(chosen);
}

void PlayMode::exportStrain(const QString& file) {
  const StrainModel::Reading reading = strain_->cycle();
  if (!reading)
    return;
  presentation::StrainPicture picture;
  picture.translate = [](const std::string& english) { return inWords(english).toStdString(); };
  const bool drawn = file.endsWith(QLatin1String(".png"), Qt::CaseInsensitive);
  parts_.workspace.inBackground<bool>(
      tr("Strain"), Workspace::slotOf(file),
      [reading, picture, drawn, path = file.toStdString()](Progress&) {
        drawn ? presentation::writeStrainPicture(path, *reading, picture)
              : live::writeStrainTable(path, *reading);
        return true;
      },
      [this, file](bool) {
        parts_.settings.setValue(kFolderKey, QFileInfo(file).absolutePath());
        parts_.workspace.noteWritten(tr("Written to %1.").arg(QFileInfo(file).fileName()), file);
      });
}

QWidget* PlayMode::makeChart() {
  chart_ = new CirculationPanel(*circulation_, parts_.playback, parts_.volumes, parts_.view);
  return chart_;
}

/// Until the heart beats with a circulation, volumes are the curves that there are.
bool PlayMode::chartWanted() const {
  return circulation_->on() && circulation_->present() && parts_.view.state().circulationChart;
}

void PlayMode::setTheme(const Theme& theme) {
  comparison_->setTheme(theme);
  if (residuals_)
    residuals_->setTheme(theme);
  if (chart_)
    chart_->setTheme(theme);
  if (strainPanel_)
    strainPanel_->setTheme(theme);
}

void PlayMode::chooseScenario(const QString& id) {
  const bool done = parts_.workspace.perform(id.isEmpty() ? document::driveHeart(true)
                                                          : document::chooseScenario(id.toStdString()));
  if (done && !playSampleHeart() && parts_.workspace.document().organs().empty())
    parts_.samples.load(QStringLiteral("heart"), true);
}

bool PlayMode::playSampleHeart() {
  for (const Playback::Motion& motion : parts_.playback.motions())
    if (live::sampleHeartOf(motion.recipe)) {
      parts_.playback.choose(motion.sequence.get());
      parts_.playback.play();
      return true;
    }
  return false;
}

void PlayMode::makeLookActions(Actions& actions) {
  parts_.view.addToggle(actions, "view.labels",
                        {tr("Organ &labels"), "label", {Qt::Key_N}, tr("Write names beside the organs")},
                        &presentation::ViewState::labels);
  QAction* through = actions.addToggle("view.seeThrough",
                                       {tr("See &through"),
                                        "see_through",
                                        {Qt::Key_X},
                                        tr("Make the wall translucent, so that the cavities are seen")},
                                       false, [this, &actions](bool on) {
                                         setSeeThrough(on);
                                         actions.sync(); // Where it was refused, the mark goes again.
                                       });
  actions.onSync([this, through] {
    through->setChecked(seesThrough());
    through->setEnabled(!workspace_.document().organs().empty());
  });
}

std::vector<const char*> PlayMode::actions() const {
  return {"play.addKey",
          "play.motionFromSeries",
          "",
          "play.slower",
          "play.cycle",
          "play.valves",
          "play.beatSigns",
          "play.circulationChart",
          "play.keepBefore",
          "play.forgetBefore",
          "",
          "play.strain",
          "play.strainOnOrgan",
          "play.exportStrain",
          "",
          "view.labels",
          "view.seeThrough"};
}

QWidget* PlayMode::makePage(const Actions& actions) {
  return new PlayPage(parts_, *this, actions);
}

void PlayMode::setStatus(StatusLine& status) {
  status_ = &status;
  status.watch(recorder_->jobs());
}

void PlayMode::chooseSequence(const QString& id) {
  for (const Playback::Motion& motion : parts_.playback.motions()) {
    if (text(motion.sequence->id()) != id)
      continue;
    parts_.playback.choose(motion.sequence.get());
    parts_.playback.play();
    return;
  }
  for (const live::SampleSequence& sample : live::sampleSequences())
    if (text(sample.id) == id)
      parts_.samples.load(text(sample.organ), true);
}

bool PlayMode::hasSampleHeart() const {
  return holdsSampleHeart(parts_.playback);
}

bool PlayMode::replacesOrgans(const QString& sequence) const {
  const auto& motions = parts_.playback.motions();
  const document::OrganList& organs = parts_.workspace.document().organs();
  return std::none_of(motions.begin(), motions.end(),
                      [&](const auto& motion) { return text(motion.sequence->id()) == sequence; }) &&
         std::any_of(organs.begin(), organs.end(),
                     [](const auto& organ) { return organ->origin.sample.empty(); });
}

bool PlayMode::seesThrough() const {
  const auto walls = wallsOf(parts_.workspace.document().organs());
  return !walls.empty() && std::all_of(walls.begin(), walls.end(),
                                       [](const auto& organ) { return organ->look.opacity < kOpaque; });
}

void PlayMode::setSeeThrough(bool on) {
  if (on == seesThrough())
    return;
  const document::OrganList& organs = parts_.workspace.document().organs();
  std::vector<document::Command> commands;
  for (const auto& organ : wallsOf(organs)) {
    document::OrganLook look = organ->look;
    if (!on && look.opacity < kOpaque) // The user may have chosen another one than the usual.
      throughOpacity_[organ->id] = look.opacity;
    const auto before = throughOpacity_.find(organ->id);
    look.opacity = !on                               ? 1
                   : before != throughOpacity_.end() ? before->second
                   : hasInside(organs, organ->id)    ? workbench::kWallOpacity
                                                     : kPlainOpacity;
    commands.push_back(document::setOrganLook(organ->id, look));
  }
  for (const auto& organ : organs) {
    document::OrganLook look = organ->look;
    look.visible = true;
    look.opacity = 1;
    if (on && organ->parent)
      commands.push_back(document::setOrganLook(organ->id, look));
  }
  if (!commands.empty())
    parts_.workspace.perform(document::combined(
        (on ? tr("See through") : tr("Make the wall opaque")).toStdString(), std::move(commands)));
}

void PlayMode::slower() {
  const double speed = parts_.playback.player().speed();
  const auto* next = std::find_if(std::begin(kPlaybackSpeeds), std::end(kPlaybackSpeeds),
                                  [speed](double other) { return other < speed - 1e-9; });
  parts_.playback.setSpeed(next == std::end(kPlaybackSpeeds) ? 1 : *next);
}

void PlayMode::addKey() {
  if (!keySequence_->addKey(keySequence_->nextSeconds(), sequences::Easing::smooth))
    return;
  const document::SequenceKey& key = workspace_.document().keySequence().keys.back();
  toldKey_ = key.id;
  keyRemark_ = keyRemark(key);
  parts_.area.showBadge(keyRemark_);
}

/// Removes the remark about a key when undo has removed the key or changed its time.
void PlayMode::retractKey() {
  const document::SequenceKey* key = workspace_.document().keySequence().key(toldKey_);
  if (!keyRemark_.isEmpty() && (!key || keyRemark(*key) != keyRemark_))
    parts_.area.retractBadge(std::exchange(keyRemark_, {}));
}

bool PlayMode::record(const MoviePlan& plan) {
  std::vector<MovieStage::Source> sources = {
      {parts_.workspace, parts_.playback, parts_.picture, segmentsOverTime(strain_.get(), parts_.playback)}};
  if (comparison_->on())
    sources.push_back({comparison_->workspace(), comparison_->playback(), comparison_->picture(),
                       segmentsOverTime(secondStrain_.get(), comparison_->playback())});
  const bool begun = recorder_->start(
      plan, sources,
      MovieSigns::of(shownSigns(parts_.playback, *circulation_, parts_.view.state().heartSigns,
                                parts_.picture.view().theme()),
                     plan.size));
  if (begun && std::any_of(sources.begin(), sources.end(),
                           [](const auto& source) { return source.picture.hasMoreThanMovies(); }))
    parts_.workspace.note(
        tr("The movie does not show distance colours, measured surfaces or warped slices."));
  return begun;
}

void PlayMode::reportMovieWritten(bool complete, const MoviePlan& plan) {
  if (complete)
    parts_.workspace.noteWritten(tr("Recorded as %1").arg(plan.file), plan.file);
}

} // namespace viscera::app
