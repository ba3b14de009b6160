#include "window/circulation/circulation_model.h"

#include <utility>

#include "viscera/circulation/indices.h"
#include "viscera/circulation/scenario.h"
#include "viscera/core/error.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/sample_organs/sample_organ.h"
#include "window/work/mailbox.h"

namespace viscera::app {
namespace {

/// One worker solves the circulation while the other computes the heart's motion.
constexpr int kWorkers = 2;
/// ms after which a control rests.
constexpr int kControlRestMilliseconds = 200;
/// Instants at which the heart must be able to beat similarly where it beats on.
constexpr Eigen::Index kTriedOfSimilar = 8;

heart::HeartCourse courseOf(const CirculationModel::Shown& shown) {
  return live::heartCourse(phrase("Heartbeat: %1", shown.name), shown.parameters, shown.beat, shown.indices,
                           circulation::leftMuscleOf(shown.name.english()));
}

} // namespace

CirculationModel::CirculationModel(Workspace& workspace, Playback& playback, QObject* parent)
    : QObject(parent), workspace_(workspace), playback_(playback), jobs_(mailbox(), kWorkers) {
  subscription_ = workspace.onChange([this](const document::Change& change) {
    if (change.circulation() || change.organs())
      scheduleSolve();
  });
  connect(&playback, &Playback::stateChanged, this, &CirculationModel::scheduleSolve);
  rests_.setSingleShot(true);
  rests_.setInterval(kControlRestMilliseconds);
  connect(&rests_, &QTimer::timeout, this, &CirculationModel::sync);
}

/// Deferred, because a motion cannot be exchanged while observers of a change are called.
void CirculationModel::scheduleSolve() {
  if (!std::exchange(asked_, true))
    QMetaObject::invokeMethod(this, &CirculationModel::sync, Qt::QueuedConnection);
}

void CirculationModel::sync() {
  asked_ = false;
  if (!on())
    return clear();
  if (solve())
    follow();
  syncPresent();
}

/// The heart may have come back, with the beat that it had.
CirculationModel::SolvedPointer CirculationModel::wantedPresent() const {
  const auto motion = heartMotion();
  if (!motion || refused_ == solved_)
    return solved_;
  return followed_.sequence && motion->sequence == followed_.sequence ? beatBy_ : nullptr;
}

void CirculationModel::syncPresent() {
  const SolvedPointer now = wantedPresent();
  if (std::exchange(present_, now) != now)
    Q_EMIT changed();
}

bool CirculationModel::isPlayed() const {
  return present_ && beatBy_ == present_ && followed_.sequence &&
         playback_.sequence() == followed_.sequence.get();
}

void CirculationModel::clear() {
  rests_.stop();
  restoreTextbookBeat();
  if (!solved_ && !present_ && !kept_ && failureReason_.isEmpty())
    return;
  solved_ = present_ = kept_ = refused_ = nullptr;
  failureReason_.clear();
  Q_EMIT changed();
}

CirculationModel::SolvedPointer CirculationModel::solved(Text name, const circulation::Parameters& parameters,
                                                         const SolvedPointer& nearby, Progress& progress) {
  circulation::PeriodicState found =
      circulation::findPeriodicState(parameters, progress, {}, nearby ? &nearby->start : nullptr);
  const circulation::Indices indices = circulation::indicesOf(parameters, found.beat);
  return std::make_shared<const Solved>(Solved{
      {std::move(name), parameters, std::move(found.beat), indices}, found.start, found.failureReason});
}

/// Returns true when everything that the document needs is computed; else a worker computes it.
bool CirculationModel::solve() {
  const auto isOf = [](const SolvedPointer& known, const circulation::Parameters& parameters,
                       const Text& name) {
    return known && known->shown.parameters == parameters && known->shown.name == name;
  };
  const document::CirculationChoice& wanted = choice();
  const Text name = document::nameOf(wanted);
  if (isOf(present_, wanted.parameters, name)) // An undo may have gone back to what is seen.
    solved_ = present_;
  const bool refused = isOf(refused_, wanted.parameters, name);
  const bool present = refused || isOf(solved_, wanted.parameters, name);
  if (present && !refused && refused_) { // The choice went back to one that can be.
    refused_.reset();
    failureReason_.clear();
    Q_EMIT changed();
  }
  if (!wanted.kept && kept_) {
    kept_.reset();
    Q_EMIT changed();
  }
  const bool kept = !wanted.kept || isOf(kept_, wanted.kept->parameters, wanted.kept->name);
  if (present && kept)
    return true;
  if (std::exchange(solving_, true))
    return false;
  jobs_.submit<Solutions>(
      tr("Circulation").toStdString(), {},
      [wanted, name, present, kept, nearby = solved_, beat = shownBeat()](Progress& progress) {
        Solutions found;
        if (!present) {
          found.present = solved(name, wanted.parameters, nearby, progress);
          if (found.present->failureReason.empty())
            found.similarBeat = beat.similar(found.present->shown);
        }
        if (!kept)
          found.kept = solved(wanted.kept->name, wanted.kept->parameters, {}, progress);
        return found;
      },
      [this](const JobResult<Solutions>& result) { take(result); });
  return false;
}

void CirculationModel::take(const JobResult<Solutions>& result) {
  solving_ = false;
  if (result.error)
    workspace_.report(*result.error);
  if (!result.value || !on())
    return;
  if (const SolvedPointer& found = result.value->present) {
    failureReason_ = found->failureReason.empty() ? QString() : asSentence(found->failureReason);
    (failureReason_.isEmpty() ? solved_ : refused_) = found;
  }
  if (result.value->kept)
    kept_ = result.value->kept;
  if (showSimilar(result.value->similarBeat))
    rests_.start();
  else
    follow();
  present_ = wantedPresent();
  Q_EMIT changed();
  sync(); // The choice may be another one by now.
}

CirculationModel::ShownBeat CirculationModel::shownBeat() const {
  const auto motion = heartMotion();
  if (!motion || motion->sequence != followed_.sequence)
    return {};
  return {followed_.sequence, playback_.player().fraction(), playback_.player().playing()};
}

/// Works on a worker. The heart must be able to take the shape in which it will be drawn first; where it
/// beats on, others as well: it would stand still while the time goes on.
std::shared_ptr<const heart::CourseHeartbeat> CirculationModel::ShownBeat::similar(const Shown& shown) const {
  if (!beat)
    return nullptr;
  try {
    auto found = std::make_shared<const heart::CourseHeartbeat>(*beat, courseOf(shown));
    const auto tryAt = [&](double part) {
      Points pose;
      found->poseAt(part * shown.beat.period, found->standardRatePerMinute(), pose);
    };
    tryAt(fraction);
    if (playing)
      parallelRanges(kTriedOfSimilar, 1, {}, [&](Eigen::Index begin, Eigen::Index end) {
        for (Eigen::Index i = begin; i < end; ++i)
          tryAt(static_cast<double>(i) / kTriedOfSimilar);
      });
    return found;
  } catch (const DataError&) { // The courses are not similar enough: `follow` will report errors.
    return nullptr;
  }
}

bool CirculationModel::showSimilar(const std::shared_ptr<const heart::CourseHeartbeat>& beat) {
  const auto motion = heartMotion();
  if (!beat || !motion || !followed_.sequence || motion->sequence != followed_.sequence)
    return false;
  beatBy_ = solved_;
  give(*motion, beat);
  return true;
}

/// Whether a circulation moves the heart, be it the present one.
bool CirculationModel::followsOne(const Playback::Motion& motion) const {
  const auto follower = followers_.find(motion.organ);
  return follower != followers_.end() && follower->second.given == motion.sequence;
}

void CirculationModel::give(const Playback::Motion& motion,
                            std::shared_ptr<const heart::CourseHeartbeat> beat) {
  if (!followsOne(motion))
    followers_[motion.organ].textbook = motion.sequence;
  followers_[motion.organ].given = beat;
  followed_.sequence = std::move(beat);
  playback_.exchange(motion.sequence.get(), followed_.sequence);
}

std::optional<Playback::Motion> CirculationModel::heartMotion() const {
  for (const Playback::Motion& motion : playback_.motions())
    if (live::sampleHeartOf(motion.recipe))
      return motion;
  return {};
}

void CirculationModel::follow() {
  const auto motion = heartMotion();
  if (!motion || !solved_ || following_ || rests_.isActive())
    return;
  const bool present =
      refused_ == solved_ || (motion->sequence == followed_.sequence && followedBy_ == solved_);
  const bool kept = !kept_ || keptBeatBy_ == kept_;
  if (present && kept)
    return;
  following_ = true;
  jobs_.submit<Followed>(
      tr("Heart of the circulation").toStdString(), {},
      [by = present ? nullptr : solved_, keptBy = kept ? nullptr : kept_, known = followed_,
       resolution = *live::sampleHeartOf(motion->recipe),
       library = sample_organs::standardLibrary()](Progress& progress) {
        Followed next{resolution, known.heart, nullptr, nullptr};
        if (!next.heart || known.resolution != resolution)
          next.heart = std::make_shared<const live::CirculatingHeart>(library, resolution, progress);
        const auto beatOf = [&](const Shown& shown) { return next.heart->follow(courseOf(shown), progress); };
        if (by)
          next.sequence = beatOf(by->shown);
        if (keptBy)
          next.keptBeat = beatOf(keptBy->shown);
        return next;
      },
      [this, asked = Following{solved_, kept_, beatBy_, motion->organ}](JobResult<Followed> result) {
        take(std::move(result), asked);
      });
}

void CirculationModel::take(JobResult<Followed> result, const Following& asked) {
  following_ = false;
  if (result.error) {
    refused_ = asked.by;
    keptBeatBy_ = asked.kept;
    keptBeat_ = nullptr;
    failureReason_ = asSentence(result.error->problem());
    Q_EMIT changed();
  }
  const auto motion = heartMotion();
  if (result.value && on() && motion && motion->organ == asked.organ) {
    followed_.heart = result.value->heart;
    followed_.resolution = result.value->resolution;
    const bool late = asked.by != solved_ && asked.before != beatBy_; // A beat of a newer choice is shown.
    if (result.value->sequence && !late) {
      followedBy_ = beatBy_ = asked.by;
      give(*motion, result.value->sequence);
    }
    if (result.value->keptBeat) {
      keptBeat_ = result.value->keptBeat;
      keptBeatBy_ = asked.kept;
      Q_EMIT changed();
    }
  }
  if (on())
    syncPresent();
  scheduleSolve();
}

void CirculationModel::restoreTextbookBeat() {
  const auto motion = heartMotion();
  if (!motion || !followsOne(*motion))
    return;
  followed_.sequence = nullptr;
  followedBy_ = beatBy_ = nullptr;
  playback_.exchange(motion->sequence.get(), followers_.at(motion->organ).textbook);
}

} // namespace viscera::app
