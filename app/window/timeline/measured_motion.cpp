#include "window/timeline/measured_motion.h"

#include <QTimer>

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/document/rig_commands.h"
#include "viscera/live/cine_reading.h"
#include "viscera/live/sequence_file.h"
#include "viscera/scene/color_map.h"
#include "viscera/workbench/loaded_sample.h"
#include "window/style/language.h"

namespace viscera::app {

struct MeasuredMotion::Result {
  Found found;
  std::vector<document::NewOrgan> organs;
  std::shared_ptr<const document::StudyItem> study; ///< Null for a motion without images.
};

namespace {

constexpr const char* kTrackSlot = "track";
constexpr const char* kPhaseSlot = "measuredPhase";
constexpr std::size_t kKnown = 2; ///< One to compare with.
constexpr double kGhostOpacity = 0.4;
const Vec3 kGhost(0.97, 0.83, 0.42);
constexpr double kLeastReach = 0.5; ///< Of the colours, mm.
constexpr int kSaidSeconds = 12;

/// Says where a surface came from: it has the shape of the first of its files.
void nameFiles(const std::vector<std::filesystem::path>& files, document::Organ& organ) {
  if (files.empty())
    return;
  organ.file = files.front();
  if (files.size() > 1)
    organ.warnings.push_back(phrase("the shape of the first of %1 files of its motion; the last one is %2",
                                    files.size(), files.back().filename().string()));
}

/// The surfaces on their way into the document: cavities within the outer one.
std::vector<document::NewOrgan> organsOf(const live::PatientMotion& motion,
                                         const live::MotionSeries& series) {
  const auto& surfaces = motion.sequence.organs;
  std::vector<document::NewOrgan> organs;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    document::NewOrgan organ{document::makeOrgan(surfaces[i].name, surfaces[i].mesh), -1};
    if (i < series.files.size())
      nameFiles(series.files[i], organ.organ);
    if (i != motion.outer)
      organ.parentInBatch = static_cast<int>(motion.outer);
    else if (surfaces.size() > 1)
      organ.organ.look.opacity = workbench::kWallOpacity;
    organs.push_back(std::move(organ));
  }
  return organs;
}

/// The verdict on the worst phase of a motion, and the mean distance of its surfaces.
QString summaryOf(const MeasuredMotion::Found& found) {
  const live::PatientMotion& motion = *found.motion;
  QStringList parts;
  for (std::size_t i = 0; i < motion.sequence.organs.size(); ++i) {
    double mean = 0;
    for (const live::TrackedPhase& phase : motion.phases)
      mean += phase.quality.surfaces[i].meanMm / static_cast<double>(motion.phases.size());
    parts.push_back(
        MeasuredMotion::tr("%1 %2 mm").arg(text(motion.sequence.organs[i].name)).arg(formatNumber(mean, 2)));
  }
  const QString apart = parts.join(QStringLiteral(", "));
  const int phases = static_cast<int>(motion.phases.size());
  if (!found.images)
    return MeasuredMotion::tr("Motion of %n phases. Mean distance from the measured surfaces: %1.", nullptr,
                              phases)
        .arg(apart);
  QStringList labelled;
  for (const std::size_t phase : found.images->found.labelled)
    labelled.push_back(QString::number(phase + 1));
  const QString pattern =
      found.images->found.estimate
          ? MeasuredMotion::tr(
                "An estimate of %n phases from the images and the labels of phase %1 alone. Mean "
                "distance from labels and followed tissue: %2.",
                nullptr, phases)
          : MeasuredMotion::tr(
                "Motion of %n phases from the images and the labels of phases %1. Mean distance "
                "from labels and followed tissue: %2.",
                nullptr, phases);
  return pattern.arg(labelled.join(listSeparator()), apart);
}

/// Says at the organs that their numbers are estimates: reports list it, and other lists of organs.
void markEstimate(const live::CineMotion& found, std::vector<document::NewOrgan>& organs) {
  if (found.estimate)
    for (document::NewOrgan& organ : organs)
      organ.organ.warnings.push_back(phrase(
          "its volumes over the beat and its ejection fraction are estimates: only phase %1 has labels",
          found.labelled.front() + 1));
}

/// Reads the images unless they are there, joins them with the labels, and finds the motion. On a worker.
MeasuredMotion::Result findInImages(const live::CineRequest& request, const live::TrackOptions& options,
                                    std::shared_ptr<const document::StudyItem> study, Progress& progress) {
  MeasuredMotion::Result result;
  live::LabelledStudy joined;
  runPart(progress, 0, 0.15, [&](Progress& part) {
    result.study =
        study ? std::move(study)
              : std::make_shared<const document::StudyItem>(document::readStudy(request.images, part));
    joined = live::joinStudy(*result.study->study, request, part);
  });
  auto record = std::make_shared<live::CineRecord>();
  runPart(progress, 0.15, 1, [&](Progress& part) { record->found = live::trackCine(joined, options, part); });
  record->request = request;
  record->study = result.study->hash;
  record->handles = options.rig.handles;
  record->keepVolumes = options.keepVolumes;
  result.found.options = options;
  result.found.series = std::make_shared<const live::MotionSeries>(live::wholeCycle(joined, record->found));
  result.found.motion = std::shared_ptr<const live::PatientMotion>(record, &record->found.motion);
  result.found.labels = std::make_shared<const live::MotionSeries>(std::move(joined.labels));
  result.found.images = record;
  result.organs = organsOf(*result.found.motion, *result.found.series);
  markEstimate(record->found, result.organs);
  return result;
}

/// The phase's row among the measured surfaces: of a motion from images only labelled phases have them.
std::size_t rowOf(const MeasuredMotion::Found& found, std::size_t phase) {
  if (!found.images)
    return phase;
  const auto& labelled = found.images->found.labelled;
  return static_cast<std::size_t>(std::lower_bound(labelled.begin(), labelled.end(), phase) -
                                  labelled.begin());
}

/// The number in the series of a phase of the motion, where some were left out.
std::size_t numberInSeries(std::size_t phase, std::vector<std::size_t> leftOut) {
  std::sort(leftOut.begin(), leftOut.end());
  for (const std::size_t out : leftOut)
    if (out <= phase)
      ++phase;
  return phase;
}

} // namespace

MeasuredMotion::MeasuredMotion(Workspace& workspace, Playback& playback, Picture& picture, QObject* parent)
    : QObject(parent), workspace_(workspace), playback_(playback), picture_(picture) {
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      sync();
  }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent&) { followSoon(); }));
  connect(&playback, &Playback::stateChanged, this, &MeasuredMotion::followSoon);
  connect(&playback, &Playback::advanced, this, &MeasuredMotion::followSoon);
}

MeasuredMotion::~MeasuredMotion() {
  workspace_.jobs().cancelSlot(kTrackSlot);
  workspace_.jobs().cancelSlot(kPhaseSlot);
}

void MeasuredMotion::cancel() {
  workspace_.jobs().cancelSlot(kTrackSlot);
}

void MeasuredMotion::find(const live::SeriesRequest& request, const live::TrackOptions& options) {
  search(tr("Motion from a series"), [request, options](Progress& progress) {
    Result result{{request, options, {}, {}}, {}, nullptr};
    runPart(progress, 0, 0.15, [&](Progress& part) {
      result.found.series = std::make_shared<const live::MotionSeries>(live::readMotionSeries(request, part));
    });
    runPart(progress, 0.15, 1, [&](Progress& part) {
      result.found.motion =
          std::make_shared<const live::PatientMotion>(live::trackMotion(*result.found.series, options, part));
    });
    result.organs = organsOf(*result.found.motion, *result.found.series);
    return result;
  });
}

void MeasuredMotion::findFromImages(const live::CineRequest& request, const live::TrackOptions& options,
                                    std::shared_ptr<const document::StudyItem> study) {
  search(tr("Motion from images"), [request, options, study = std::move(study)](Progress& progress) {
    return findInImages(request, options, study, progress);
  });
}

void MeasuredMotion::search(const QString& name, std::function<Result(Progress&)> work) {
  auto done = [this, search = ++searches_](JobResult<Result> result) {
    if (search != searches_)
      return; // Another one took its place.
    if (result.cancelled())
      return Q_EMIT ended(tr("The search for the motion was cancelled."));
    if (result.error)
      return Q_EMIT ended(sentenceOf(*result.error));
    take(result.value->found, result.value->organs, result.value->study);
    Q_EMIT ended({});
  };
  workspace_.jobs().submit<Result>(name.toStdString(), kTrackSlot, std::move(work), std::move(done));
}

void MeasuredMotion::know(const Found& found) {
  if (known_.size() == kKnown)
    known_.erase(known_.begin());
  known_.push_back(found);
  present_ = nullptr;
}

std::optional<live::MeasuredRecord> MeasuredMotion::record() const {
  if (!present_)
    return {};
  live::MeasuredRecord record{{}, {}, *present_->motion, present_->images};
  record.series.names = present_->series->names;
  record.series.times = present_->series->times;
  for (const live::SequenceOrgan& surface : present_->motion->sequence.organs)
    for (const auto& organ : workspace_.document().organs())
      if (organ->mesh == surface.mesh)
        record.organs.push_back(organ->id);
  return record;
}

void MeasuredMotion::recall(live::MeasuredRecord record) {
  for (std::size_t i = 0; i < record.organs.size(); ++i) {
    const auto organ = workspace_.document().organ(record.organs[i]);
    if (!organ)
      return; // Organs of a session whose files are gone.
    record.motion.sequence.organs.push_back({record.series.names[i], organ->mesh});
  }
  live::TrackOptions options;
  if (record.images) {
    options.rig.handles = record.images->handles;
    options.keepVolumes = record.images->keepVolumes;
  }
  know({{},
        options,
        std::make_shared<const live::MotionSeries>(std::move(record.series)),
        std::make_shared<const live::PatientMotion>(std::move(record.motion)),
        std::move(record.images)});
  sync();
}

void MeasuredMotion::takeCorrected(const live::CineMotion& corrected) {
  const auto known =
      std::find_if(known_.begin(), known_.end(), [this](const Found& found) { return &found == present_; });
  if (known == known_.end() || !known->images)
    return;
  auto record = std::make_shared<live::CineRecord>(*known->images);
  record->found = corrected;
  record->found.motion.sequence.organs = known->motion->sequence.organs; // The document's.
  auto series = std::make_shared<live::MotionSeries>(*known->series);
  series->volumesMl.clear();
  for (const live::TrackedPhase& phase : corrected.motion.phases) {
    std::vector<double>& volumes = series->volumesMl.emplace_back();
    for (const tracking::SurfaceQuality& surface : phase.quality.surfaces)
      volumes.push_back(surface.measuredMl);
  }
  known->series = std::move(series);
  known->motion = std::shared_ptr<const live::PatientMotion>(record, &record->found.motion);
  known->images = std::move(record);
  workspace_.afterChange([this] {
    followSoon();
    Q_EMIT changed();
  });
}

/// The series with the surfaces that were measured.
std::shared_ptr<const live::MotionSeries> MeasuredMotion::shownSeries() const {
  return present_->labels ? present_->labels : present_->series;
}

bool MeasuredMotion::surfacesKnown() const {
  if (!present_)
    return false;
  const auto series = shownSeries();
  return !(series->masks.empty() && series->meshes.empty() && series->corresponding.empty());
}

const live::CineMotion* MeasuredMotion::images() const {
  return present_ && present_->images ? &present_->images->found : nullptr;
}

bool MeasuredMotion::isEstimate() const {
  return images() && images()->estimate;
}

bool MeasuredMotion::isLabelled(std::size_t phase) const {
  return present_ && (!images() || images()->isLabelled(phase));
}

bool MeasuredMotion::isOfStudy() const {
  const auto& study = workspace_.state().study;
  return images() && study && !study->hash.empty() && study->hash == present_->images->study;
}

QString MeasuredMotion::caution() const {
  return !present_ || present_->motion->corresponding
             ? QString()
             : tr("The series does not show how points move along a wall. The mean and the 95th percentile "
                  "over the beat are reliable, the local pattern of this map is not.");
}

void MeasuredMotion::take(const Found& found, const std::vector<document::NewOrgan>& organs,
                          const std::shared_ptr<const document::StudyItem>& study) {
  know(found); // First, because the document notifies observers of its new organs within the step.
  playback_.setSequence(nullptr, {});
  const bool done = workspace_.guarded([&] {
    document::UndoStack& undo = workspace_.undo();
    document::UndoStack::Step step(undo, tr("Motion from a series").toStdString());
    if (study && !document::identical(workspace_.state().study, study))
      undo.perform(document::openStudy(*study));
    if (!workspace_.document().organs().empty())
      undo.perform(document::removeAllOrgans());
    undo.perform(document::replaceRig({}));
    undo.perform(document::addOrgans(organs));
    undo.perform(live::openSequence(found.motion->sequence));
    step.finish();
  });
  sync();
  if (!done)
    return;
  workspace_.selection().setOrgan(workspace_.document().organs().front()->id);
  Q_EMIT this->found();
  say(found);
  playback_.play();
}

/// Shows a message with the result, doubts about it, and offers. It ends with the organs of the motion.
void MeasuredMotion::say(const Found& found) {
  const live::PatientMotion& motion = *found.motion;
  Message message{Message::Severity::info, summaryOf(found), {}, kSaidSeconds};
  const auto doubtful =
      std::count_if(motion.phases.begin(), motion.phases.end(), [](const live::TrackedPhase& phase) {
        return phase.verdict.light != tracking::FitLight::good;
      });
  if (doubtful > 0) {
    message.severity = Message::Severity::warning;
    message.seconds = 0;
    message.text += QLatin1Char(' ') + tr("%n phases need attention: see the table beside the chart.",
                                          nullptr, static_cast<int>(doubtful));
  }
  if (!motion.outliers.empty()) {
    live::SeriesRequest fewer = found.request;
    QStringList numbers;
    for (const std::size_t phase : motion.outliers) {
      const std::size_t number = numberInSeries(phase, found.request.leftOut);
      fewer.leftOut.push_back(number);
      numbers.push_back(QString::number(number + 1));
    }
    message.offers.push_back({tr("Leave out phase %1").arg(numbers.join(QStringLiteral(", "))),
                              [this, fewer, options = found.options] { find(fewer, options); }});
  }
  if (found.images && !found.images->found.findings.empty())
    message.text += QLatin1Char(' ') + asSentence(found.images->found.findings.front().text);
  said_ = message.text;
  workspace_.say(message);
}

const MeasuredMotion::Found* MeasuredMotion::before() const {
  const auto other =
      std::find_if(known_.begin(), known_.end(), [this](const Found& found) { return &found != present_; });
  return other == known_.end() ? nullptr : &*other;
}

std::optional<std::size_t> MeasuredMotion::surfaceBefore(std::size_t surface) const {
  const Found* other = before();
  if (!present_ || !other)
    return std::nullopt;
  const auto& now = present_->series->names;
  const auto& then = other->series->names;
  if (now.size() == 1 && then.size() == 1)
    return 0;
  const auto found = std::find(then.begin(), then.end(), now[surface]);
  return found == then.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - then.begin()));
}

std::optional<std::size_t> MeasuredMotion::surfaceOf(document::OrganId id) const {
  const auto organ = present_ ? workspace_.document().organ(id) : nullptr;
  if (!organ)
    return std::nullopt;
  const auto& surfaces = present_->motion->sequence.organs;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i].mesh == organ->mesh)
      return i;
  return std::nullopt;
}

/// Undo and redo remove the organs of a motion from the document and restore them.
void MeasuredMotion::sync() {
  const auto& organs = workspace_.document().organs();
  const auto isThere = [&](const Found& found) {
    const auto& surfaces = found.motion->sequence.organs;
    return std::all_of(surfaces.begin(), surfaces.end(), [&](const live::SequenceOrgan& surface) {
      return std::any_of(organs.begin(), organs.end(),
                         [&](const auto& organ) { return organ->mesh == surface.mesh; });
    });
  };
  const auto found = std::find_if(known_.rbegin(), known_.rend(), isThere);
  const Found* present = found == known_.rend() ? nullptr : &*found;
  if (present == present_)
    return;
  present_ = present;
  if (!said_.isEmpty())
    workspace_.retract(std::exchange(said_, {}));
  workspace_.jobs().cancelSlot(kPhaseSlot);
  phases_.clear();
  reported_ = false;
  if (present_)
    phases_.resize(present_->series->phases());
  ghostOf_.reset();
  workspace_.afterChange([this] {
    followSoon();
    Q_EMIT changed();
  });
}

std::size_t MeasuredMotion::phaseNow() const {
  if (!present_)
    return 0;
  const tracking::PhaseTimes& times = present_->series->times;
  const double now = playback_.player().fraction() * times.periodSeconds;
  std::size_t nearest = 0;
  double least = times.periodSeconds;
  for (std::size_t phase = 0; phase < times.count(); ++phase) {
    double apart = std::abs(times.seconds[phase] - now);
    if (times.loop)
      apart = std::min(apart, times.periodSeconds - apart);
    if (apart < least) {
      least = apart;
      nearest = phase;
    }
  }
  return nearest;
}

void MeasuredMotion::showPhase(std::size_t phase) {
  if (!present_ || phase >= present_->series->phases())
    return;
  playback_.pause();
  playback_.seek(present_->series->times.seconds[phase] / present_->series->times.periodSeconds);
}

void MeasuredMotion::setGhostShown(bool on) {
  ghost_ = on;
  ghostOf_.reset();
  followSoon();
}

void MeasuredMotion::setDistancesShown(bool on) {
  distances_ = on;
  followSoon();
}

/// Once for a frame.
void MeasuredMotion::followSoon() {
  if (waiting_ || (!present_ && !drawn_))
    return;
  waiting_ = true;
  QTimer::singleShot(0, this, [this] {
    waiting_ = false;
    follow();
  });
}

void MeasuredMotion::clearView() {
  if (!drawn_)
    return;
  drawn_ = false;
  ghostOf_.reset();
  ghosts_ = 0;
  picture_.setMeasured({});
  picture_.setMap(std::nullopt);
}

/// A worker makes that of label maps, and the picture follows when it is there.
const live::MeasuredPhase* MeasuredMotion::measured(std::size_t phase) {
  if (phases_[phase])
    return phases_[phase].get();
  const auto series = shownSeries();
  const std::size_t row = rowOf(*present_, phase);
  if (series->masks.empty() || !isLabelled(phase)) {
    phases_[phase] = std::make_unique<live::MeasuredPhase>();
    if (isLabelled(phase))
      workspace_.guarded([&] {
        Progress progress;
        *phases_[phase] = live::measuredPhase(*series, row, progress);
      });
    return phases_[phase].get();
  }
  if (making_)
    return nullptr;
  making_ = true;
  workspace_.jobs().submit<live::MeasuredPhase>(
      tr("Surface of phase %1").arg(phase + 1).toStdString(), kPhaseSlot,
      [series, row](Progress& progress) { return live::measuredPhase(*series, row, progress); },
      [this, series, phase](JobResult<live::MeasuredPhase> result) {
        making_ = false;
        if (present_ && shownSeries() == series && !result.cancelled()) {
          if (result.error && !std::exchange(reported_, true))
            workspace_.report(*result.error);
          // Stores an empty phase after an error, so that it is not computed again.
          phases_[phase] = std::make_unique<live::MeasuredPhase>(result.value ? std::move(*result.value)
                                                                              : live::MeasuredPhase());
        }
        followSoon();
      });
  return nullptr;
}

presentation::SurfaceMap MeasuredMotion::distanceMap(const live::MeasuredPhase& measured) const {
  presentation::SurfaceMap map;
  map.colors = scene::viridis();
  map.title = tr("Distance from the measured surface").toStdString();
  map.unit = "mm";
  double reach = kLeastReach; // The same in all phases, so that a colour means the same.
  for (const live::TrackedPhase& phase : present_->motion->phases)
    reach = std::max(reach, std::ceil(2 * phase.quality.p95Mm) / 2);
  map.range = {0, reach};
  for (const auto& organ : workspace_.document().organs()) {
    const auto surface = surfaceOf(organ->id);
    const Points& now = workspace_.live().points(organ->id);
    if (surface && now.rows() == organ->mesh->points.rows())
      map.values[organ->id] = std::make_shared<const Values>(measured.apartMm(*surface, now));
  }
  return map;
}

void MeasuredMotion::follow() {
  if (!surfacesKnown() || !playback_.showing() || (!ghost_ && !distances_))
    return clearView();
  const std::size_t phase = phaseNow();
  const live::MeasuredPhase* shown = measured(phase);
  if (!shown)
    return; // What was drawn stays until it is there.
  if (shown->surfaces.empty())
    return clearView();
  drawn_ = true;
  picture_.setMap(distances_ ? std::optional(distanceMap(*shown)) : std::nullopt);
  if (ghostOf_ == phase)
    return;
  ghostOf_ = phase;
  std::vector<presentation::TransientSurface> ghosts;
  for (const auto& organ : workspace_.document().organs())
    if (const auto surface = surfaceOf(organ->id); surface && ghost_ && organ->look.visible)
      ghosts.push_back({shown->surfaces[*surface], kGhost, kGhostOpacity});
  ghosts_ = ghosts.size();
  picture_.setMeasured(std::move(ghosts));
}

} // namespace viscera::app
