#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>
#include <benchmark/benchmark.h>

#include "viscera/geometry/volume.h"
#include "viscera/heart/cardiac_cycle.h"
#include "viscera/live/cine_motion.h"
#include "viscera/tracking/surface_distance.h"

/// The figures of a motion from cine images against a motion that is known, and of what needs no images.
namespace viscera::tests {

/// What is known of a heart's motion. Its surfaces are in the order of the found motion's.
struct CineTruth {
  std::size_t phases = 0;
  std::function<geometry::TriangleMesh(std::size_t surface, std::size_t phase)> at;
  bool material = false; ///< Whether its vertices are the same tissue in all phases.

  double ml(std::size_t surface, std::size_t phase) const {
    const geometry::TriangleMesh mesh = at(surface, phase);
    return geometry::volume(mesh.points, mesh.triangles) / kMm3PerMl;
  }
};

/// Means and largest ones of numbers.
struct MeanAndWorst {
  double mean = 0, worst = 0;
  int count = 0;

  void add(double value) {
    mean += (value - mean) / ++count;
    worst = std::max(worst, value);
  }
};

/// Where a phase is between two labelled ones, as something tells that has seen no image.
struct PlaceOfPhase {
  std::size_t from = 0, to = 0;
  double time = 0;       ///< Part of the time.
  bool emptying = false; ///< Whether it leads from the end of diastole to that of systole.
};

inline PlaceOfPhase placeOf(const live::CineMotion& found, std::size_t phase) {
  const std::size_t count = found.motion.phases.size(), a = found.labelled.front(), b = found.labelled.back();
  const bool inner = phase > a && phase < b;
  PlaceOfPhase place{inner ? a : b, inner ? b : a, 0, false};
  const auto steps = [&](std::size_t from, std::size_t to) {
    return static_cast<double>((to + count - from) % count);
  };
  place.time = steps(place.from, phase) / steps(place.from, place.to);
  place.emptying = place.from == found.endDiastole;
  return place;
}

/// The part of the way from one label to the other after a part of the time, as the textbook's left ventricle
/// goes it between its own ends of diastole and systole.
inline double textbookPart(const PlaceOfPhase& place) {
  const heart::CardiacBeat beat = heart::CardiacCycle().beat(75);
  const double begin = beat.left().inletShuts, end = beat.left().outletShuts, cycle = 60.0 / 75;
  const double seconds =
      place.emptying ? begin + place.time * (end - begin) : end + place.time * (cycle - (end - begin));
  const double emptied = (beat.at(seconds).leftEmptying - beat.at(begin).leftEmptying) /
                         (beat.at(end).leftEmptying - beat.at(begin).leftEmptying);
  return place.emptying ? emptied : 1 - emptied;
}

/// A found motion's surfaces in any pose.
class FoundSurfaces {
public:
  explicit FoundSurfaces(const live::CineMotion& found) : found_(found), rig_(rigOf(found)) {}

  Points keyPose(std::size_t phase) const { return found_.motion.sequence.track.keys[phase].pose; }
  Points vertices(const Points& pose, std::size_t surface) const { return rig_.vertices(pose, surface); }
  double ml(const Points& vertices, std::size_t surface) const {
    return geometry::volume(vertices, rig_.surfaces()[surface].triangles) / kMm3PerMl;
  }
  double apartMm(const Points& vertices, std::size_t surface, const tracking::MeshDistance& truth) const {
    Values apart(vertices.rows());
    Vec3 ignored;
    for (Eigen::Index v = 0; v < vertices.rows(); ++v)
      apart[v] = std::abs(truth.at(vertices.row(v).transpose(), ignored));
    return tracking::spreadOf(apart, tracking::vertexAreas(vertices, rig_.surfaces()[surface].triangles))
        .mean;
  }

private:
  static tracking::MotionRig rigOf(const live::CineMotion& found) {
    std::vector<geometry::TriangleMesh> surfaces;
    for (const auto& organ : found.motion.sequence.organs)
      surfaces.push_back(*organ.mesh);
    const auto& parameters = found.motion.sequence.system->parameters.all();
    Progress quiet;
    return {surfaces, found.motion.sequence.track.restHandles, parameters.at("locality"),
            parameters.at("softness"), quiet};
  }

  const live::CineMotion& found_;
  tracking::MotionRig rig_;
};

/// How far one level of a ventricle turns about its long axis, degrees.
class Twist {
public:
  /// Two levels of a surface at rest: `below` and `above` are parts of its length.
  explicit Twist(const geometry::TriangleMesh& ventricle) {
    const Points centred = ventricle.points.rowwise() - ventricle.points.colwise().mean();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(Eigen::Matrix3d(centred.transpose() * centred));
    axis_ = axes.eigenvectors().col(2);
    const Values along = ventricle.points * axis_;
    low_ = along.minCoeff();
    length_ = along.maxCoeff() - low_;
  }
  /// How much further the one end turns than the other from `rest` to `now`.
  double degrees(const Points& rest, const Points& now) const {
    return turn(rest, now, 0.2, 0.35) - turn(rest, now, 0.6, 0.75);
  }

private:
  double turn(const Points& rest, const Points& now, double from, double to) const {
    std::vector<Eigen::Index> level;
    const Values along = (rest * axis_).array() - low_;
    for (Eigen::Index v = 0; v < rest.rows(); ++v)
      if (along[v] > from * length_ && along[v] < to * length_)
        level.push_back(v);
    Points before = rest(level, Eigen::all), after = now(level, Eigen::all);
    before.rowwise() -= before.colwise().mean().eval();
    after.rowwise() -= after.colwise().mean().eval();
    double sine = 0, cosine = 0;
    for (Eigen::Index v = 0; v < before.rows(); ++v) {
      const Vec3 a = before.row(v), b = after.row(v);
      sine += axis_.dot(a.cross(b));
      cosine += a.dot(b) - axis_.dot(a) * axis_.dot(b);
    }
    return std::atan2(sine, cosine) * 180 / std::numbers::pi;
  }

  Vec3 axis_;
  double low_ = 0, length_ = 0;
};

/// Compares a motion with the truth and with three ways between the labels that look at no image; where a way
/// is nearer than the images in a phase, the label of the benchmark names it.
class CineFigures {
public:
  CineFigures(const live::CineMotion& found, const CineTruth& truth, std::vector<std::string> names)
      : found_(found), truth_(truth), names_(std::move(names)), surfaces_(found) {}

  void report(benchmark::State& state) {
    for (std::size_t surface = 0; surface < names_.size(); ++surface)
      measure(surface, state);
    reportFindings(state);
    state.SetLabel(said_);
  }

  /// How far the left ventricle's twist is from the true one, degrees.
  void reportTwist(benchmark::State& state, std::size_t surface) const {
    const geometry::TriangleMesh rest = truth_.at(surface, found_.endDiastole);
    const Twist twist(rest);
    const Points own = surfaces_.vertices(surfaces_.keyPose(found_.endDiastole), surface);
    MeanAndWorst off;
    double most = 0;
    for (std::size_t phase = 0; phase < truth_.phases; ++phase) {
      const double known = twist.degrees(rest.points, truth_.at(surface, phase).points);
      const double now = twist.degrees(own, surfaces_.vertices(surfaces_.keyPose(phase), surface));
      off.add(std::abs(now - known));
      most = std::abs(known) > std::abs(most) ? known : most;
    }
    state.counters["twist_true"] = most;
    state.counters["twist_off_mean"] = off.mean;
    state.counters["twist_off_worst"] = off.worst;
  }

private:
  /// Errors of one way through the phases that have no labels.
  struct Errors {
    MeanAndWorst volume, mm;
  };
  static constexpr std::array<const char*, 4> kWays = {"", "straight_", "cosine_", "textbook_"};

  Points poseOf(std::size_t way, std::size_t phase) const {
    if (way == 0)
      return surfaces_.keyPose(phase);
    const PlaceOfPhase place = placeOf(found_, phase);
    const double part = way == 1   ? place.time
                        : way == 2 ? (1 - std::cos(std::numbers::pi * place.time)) / 2
                                   : textbookPart(place);
    const Points from = surfaces_.keyPose(place.from);
    return from + part * (surfaces_.keyPose(place.to) - from);
  }

  void measure(std::size_t surface, benchmark::State& state) {
    const double full = truth_.ml(surface, found_.endDiastole);
    const std::size_t ways = found_.labelled.size() == 2 ? kWays.size() : 1;
    std::array<Errors, 4> errors;
    std::array<std::string, 4> nearer;
    for (std::size_t phase = 0; phase < truth_.phases; ++phase) {
      if (found_.isLabelled(phase))
        continue;
      const tracking::MeshDistance distance(
          std::make_shared<const geometry::TriangleMesh>(truth_.at(surface, phase)));
      const double ml = truth_.ml(surface, phase);
      double own = 0;
      for (std::size_t way = 0; way < ways; ++way) {
        const Points vertices = surfaces_.vertices(poseOf(way, phase), surface);
        const double mm = surfaces_.apartMm(vertices, surface, distance);
        errors[way].volume.add(100 * std::abs(surfaces_.ml(vertices, surface) - ml) / full);
        errors[way].mm.add(mm);
        own = way == 0 ? mm : own;
        if (mm < own)
          nearer[way] += " " + std::to_string(phase);
      }
    }
    for (std::size_t way = 0; way < ways; ++way) {
      const std::string name = names_[surface] + "_" + kWays[way];
      state.counters[name + "mean_percent"] = errors[way].volume.mean;
      state.counters[name + "worst_percent"] = errors[way].volume.worst;
      state.counters[name + "mm"] = errors[way].mm.mean;
      state.counters[name + "mm_worst_phase"] = errors[way].mm.worst;
      if (!nearer[way].empty())
        say(names_[surface] + ": " + kWays[way] + "nearer in" + nearer[way]);
    }
  }

  void reportFindings(benchmark::State& state) {
    double folded = 0, amber = 0;
    for (const live::TrackedPhase& phase : found_.motion.phases) {
      folded += phase.quality.folded;
      amber += phase.verdict.light != tracking::FitLight::good;
    }
    state.counters["folded"] = folded;
    state.counters["phases_not_good"] = amber;
    state.counters["findings"] = static_cast<double>(found_.findings.size());
    for (const live::CineFinding& finding : found_.findings)
      if (!finding.phase || *finding.phase == found_.emptiest)
        say(finding.text.english());
  }
  void say(const std::string& text) { said_ += (said_.empty() ? "" : "; ") + text; }

  const live::CineMotion& found_;
  const CineTruth& truth_;
  std::vector<std::string> names_;
  FoundSurfaces surfaces_;
  std::string said_;
};

} // namespace viscera::tests
