#include "viscera/phantom/phantom_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "breathing_field.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/inverse_map.h"
#include "viscera/document/rig_commands.h"
#include "viscera/geometry/volume.h"
#include "viscera/heart/cardiac_cycle.h"
#include "viscera/heart/course_heartbeat.h"
#include "viscera/live/circulating_heart.h"

namespace viscera::phantom {
namespace {

constexpr double kAccuracyMm = 0.1;
/// Of the grid: its spacing is 8 mm then. A finer one shows the kinks of the coordinates next to handles, and
/// folds where the right ventricle is nearly empty.
constexpr double kMostWeights = 1.2e7;
constexpr int kInstants = 96; ///< Of a beat.
constexpr double kStandardEjection = 0.58;
constexpr double kMostAsked = 0.78; ///< Beyond it the right ventricle would be empty.
constexpr double kEjectionTolerance = 1e-4;
constexpr int kMostCorrections = 8;
constexpr Eigen::Index kPointsAtOnce = 1024;

void requireRange(double value, double low, double high, const char* what) {
  if (!(value >= low && value <= high))
    throw UsageError(misuse("%1 has to lie between %2 and %3", what, inDigits(low), inDigits(high)));
}

/// The textbook's beat with another ejection fraction. Both ventricles eject the same volume.
heart::HeartCourse courseOf(double ejectionFraction, double beatsPerMinute) {
  using heart::CardiacCycle;
  const double stroke = CardiacCycle::kEndDiastole.leftMl * ejectionFraction;
  const CardiacCycle cycle(CardiacCycle::kEndDiastole, {CardiacCycle::kEndDiastole.leftMl - stroke,
                                                        CardiacCycle::kEndDiastole.rightMl - stroke});
  const heart::CardiacBeat beat = cycle.beat(beatsPerMinute);
  heart::HeartCourse course;
  course.name = "Heartbeat";
  course.period = 60 / beatsPerMinute;
  course.phases = {{"heartbeat", 0, 1}};
  // Descent of the base and twist go with the ejection fraction.
  const double strength = ejectionFraction / kStandardEjection;
  // The ventricles begin to contract at the beginning, as after the R wave that triggers a scanner.
  const double begins = beat.left().inletShuts;
  for (int i = 0; i < kInstants; ++i) {
    heart::HeartInstant instant = heart::heartInstant(cycle, beat.at(begins + course.period * i / kInstants));
    instant.state.emptying *= strength;
    instant.state.rightEmptying *= strength;
    instant.state.twist *= std::min(strength, 1.0);
    course.instants.push_back(instant);
  }
  return course;
}

std::shared_ptr<const coordinates::CoordinateSystem> systemOf(const document::SystemChoice& choice) {
  for (const auto& system : coordinates::builtInSystems())
    if (system->id() == choice.id)
      return system;
  throw UsageError(misuse("there is no coordinate system \"%1\"", choice.id));
}

} // namespace

/// The beating heart, and the map of the space around it.
struct PhantomMotion::Beat {
  std::shared_ptr<const sequences::Sequence> sequence;
  std::unique_ptr<deformation::InverseMap> map;
  double period = 0;
  double smallest = 0; ///< When the left ventricle is smallest, s.

  Beat(const sample_organs::SampleLibrary& library, const geometry::TriangleMesh& leftVentricle,
       const MotionOptions& options, double beatsPerMinute, Progress& progress, Threads threads) {
    period = 60 / beatsPerMinute;
    const live::CirculatingHeart heart(library, sample_organs::Resolution::medium, progress, threads);
    // The motion between the grid's nodes empties a ventricle a little less than the handles do: ask for more
    // until the surface has the wanted ejection fraction.
    double asked = options.ejectionFraction;
    for (int round = 0; round < kMostCorrections; ++round) {
      follow(heart, asked, threads, progress);
      const double found = ejectionFraction(leftVentricle);
      if (std::abs(found - options.ejectionFraction) <= kEjectionTolerance)
        return;
      asked = std::min(asked * options.ejectionFraction / found, kMostAsked);
    }
    throw DataError(misuse("the sample heart does not come to this ejection fraction"), {},
                    misuse("ask for one nearer to 0.58"));
  }

private:
  void follow(const live::CirculatingHeart& heart, double asked, Threads threads, Progress& progress) {
    const heart::HeartCourse course = courseOf(asked, 60 / period);
    const auto least = std::min_element(course.instants.begin(), course.instants.end(),
                                        [](const heart::HeartInstant& a, const heart::HeartInstant& b) {
                                          return a.volumes.leftMl < b.volumes.leftMl;
                                        });
    smallest = period * static_cast<double>(least - course.instants.begin()) / kInstants;
    const live::SequenceSetup setup = heart.setup(course, progress);
    sequence = setup.sequence;
    if (map)
      return;
    coordinates::HandleSet handles;
    handles.positions = sequence->restHandles();
    Points pose;
    // The grid is as fine as the end of systole wants it, whatever instants are asked for later.
    sequence->poseAt(smallest, 60 / period, pose);
    map = std::make_unique<deformation::InverseMap>(
        *systemOf(setup.system), handles, pose, coordinates::BindOptions{setup.system.parameters, threads},
        deformation::InverseMapOptions{.accuracyMm = kAccuracyMm, .mostWeights = kMostWeights}, progress);
  }
  double volumeAt(const geometry::TriangleMesh& surface, double seconds) {
    Points pose;
    sequence->poseAt(seconds, 60 / period, pose);
    map->setPose(pose);
    return geometry::volume(map->posedPoints(surface.points), surface.triangles);
  }
  double ejectionFraction(const geometry::TriangleMesh& leftVentricle) {
    const double full = volumeAt(leftVentricle, 0);
    return 1 - volumeAt(leftVentricle, smallest) / full;
  }
};

/// The breath at one rate.
struct PhantomMotion::Breath {
  BreathingField field;
  double rate = 15;
};

PhantomMotion::PhantomMotion(const sample_organs::SampleLibrary& library, const PhantomBody& body,
                             const MotionOptions& options, Progress& progress, Threads threads)
    : options_(options), threads_(threads) {
  if (!options.heartbeat && !options.breathing)
    throw UsageError(misuse("nothing of the phantom would move"), {},
                     misuse("ask for --heartbeat, --breathing or both"));
  requireRange(options.ejectionFraction, 0.2, 0.7, "the ejection fraction");
  requireRange(options.beatsPerMinute, 40, 150, "the heart rate");
  requireRange(options.breathsPerMinute, 4, 40, "the rate of breathing");
  if (options.breathing)
    breath_ = std::make_unique<const Breath>(
        Breath{BreathingField(boundsOf(body.surfaceOf("liver").mesh.points)), options.breathsPerMinute});
  if (options.heartbeat)
    beat_ = std::make_unique<Beat>(library, body.surfaceOf("left ventricle").mesh, options, beatsPerMinute(),
                                   progress, threads);
  setSeconds(0);
}

PhantomMotion::~PhantomMotion() = default;

double PhantomMotion::beatsPerMinute() const {
  if (!options_.breathing)
    return options_.beatsPerMinute;
  const double inABreath = std::max(1.0, std::round(options_.beatsPerMinute / options_.breathsPerMinute));
  return inABreath * options_.breathsPerMinute;
}

double PhantomMotion::periodSeconds() const {
  return 60 / (options_.breathing ? options_.breathsPerMinute : options_.beatsPerMinute);
}

void PhantomMotion::setSeconds(double seconds) {
  seconds_ = seconds;
  if (!beat_)
    return;
  Points pose;
  beat_->sequence->poseAt(seconds, 60 / beat_->period, pose);
  beat_->map->setPose(pose);
}

double PhantomMotion::beatFraction() const {
  if (!beat_)
    return 0;
  const double beats = seconds_ / beat_->period;
  return beats - std::floor(beats);
}

double PhantomMotion::inspiration() const {
  return breath_ ? breath_->field.inspirationAt(seconds_, breath_->rate) : 0;
}

double PhantomMotion::endSystoleSeconds() const {
  return beat_ ? beat_->smallest : 0;
}

Points PhantomMotion::moved(const Points& rest) const {
  Points points = beat_ ? beat_->map->posedPoints(rest) : rest;
  if (breath_) {
    const double depth = inspiration();
    parallelRanges(points.rows(), kPointsAtOnce, threads_, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index i = begin; i < end; ++i)
        points.row(i) = breath_->field.moved(points.row(i).transpose(), depth).transpose();
    });
  }
  return points;
}

PhantomRest PhantomMotion::restOf(const Points& moved) const {
  Points points = moved;
  if (breath_) {
    const double depth = inspiration();
    parallelRanges(points.rows(), kPointsAtOnce, threads_, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index i = begin; i < end; ++i)
        points.row(i) = breath_->field.restOf(points.row(i).transpose(), depth).transpose();
    });
  }
  if (!beat_)
    return {std::move(points), std::vector<std::uint8_t>(static_cast<std::size_t>(moved.rows()), 0)};
  deformation::RestPoints rest = beat_->map->restPoints(points);
  PhantomRest result{std::move(rest.points), {}};
  for (const deformation::RestState state : rest.states)
    result.unsure.push_back(state == deformation::RestState::folded ? 1 : 0);
  return result;
}

double PhantomMotion::foldedMl() const {
  return beat_ ? beat_->map->foldedMl() : 0;
}

double PhantomMotion::gridErrorMm() const {
  return beat_ ? beat_->map->errorMm() : 0;
}

} // namespace viscera::phantom
