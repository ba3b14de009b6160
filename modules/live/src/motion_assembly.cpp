#include "motion_assembly.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "viscera/medical_io/label_surfaces.h"
#include "viscera/tracking/mask_distance.h"

namespace viscera::live {
namespace {

using geometry::TriangleMesh;
using tracking::MotionRig;

constexpr Eigen::Index kRigCorners = 8;
/// Colours of groups of handles, one a surface, over again.
const std::vector<Vec3>& groupColors() {
  static const std::vector<Vec3> colors = {
      {0.95, 0.6, 0.2}, {0.9, 0.3, 0.3}, {0.3, 0.5, 0.95}, {0.5, 0.8, 0.4}, {0.8, 0.5, 0.9}};
  return colors;
}

/// Of the surfaces that a motion is fitted to. `betweenSlices` leaves no terraces, and more smoothing would
/// take the surface further from the measured voxels.
constexpr double kLabelSmoothing = 0.5;

/// Handles on and around the surfaces, those of the box first: a group for it and one for each surface.
document::Rig madeRig(const std::vector<TriangleMesh>& rest, const MotionSeries& series,
                      const tracking::RigOptions& options) {
  const tracking::RigHandles made = tracking::placeMotionHandles(rest, series.outer, options);
  document::Rig rig = document::rigAt(made.rest);
  std::vector<std::vector<int>> rows(series.names.size() + 1);
  for (std::size_t i = 0; i < rig.handles.size(); ++i) {
    rig.handles[i].label = "H-" + std::to_string(i + 1);
    rows[static_cast<std::size_t>(made.ofSurface[i] + 1)].push_back(static_cast<int>(i));
  }
  rig.addGroup("Box", {0.6, 0.6, 0.6}, rows[0]);
  for (std::size_t i = 0; i < series.names.size(); ++i)
    rig.addGroup(series.names[i], groupColors()[i % groupColors().size()], rows[i + 1]);
  return rig;
}

/// The handles of a file; one that several groups share comes once, in the first of them.
document::Rig givenRig(const medical_io::HandleFile& file) {
  document::Rig rig;
  for (const medical_io::HandleGroupRecord& group : file.groups) {
    std::vector<int> rows;
    for (const medical_io::HandleRecord& record : group.handles) {
      if (rig.indexOf(record.label) >= 0)
        continue;
      rows.push_back(static_cast<int>(rig.handles.size()));
      document::Handle& handle = rig.handles.emplace_back();
      handle.id.value = rows.back() + 1;
      handle.label = record.label;
      handle.rest = record.position;
    }
    rig.addGroup(group.name, group.color, rows);
  }
  return rig;
}

} // namespace

TriangleMesh surfaceAround(const tracking::Mask& mask, const std::string& name, int triangles,
                           std::vector<Text>& warnings, Progress& progress, Threads threads) {
  const tracking::Mask fine = tracking::betweenSlices(mask);
  medical_io::LabelMap map;
  map.size = fine.size;
  map.indexToLps = fine.indexToLps;
  map.layers.emplace_back(fine.inside);
  medical_io::Segment segment;
  segment.label = 1;
  segment.name = name;
  segment.voxels = fine.count();
  const tracking::VoxelRange range = tracking::rangeOf(fine);
  segment.low = range.low;
  segment.high = range.high;
  map.segments.push_back(segment);
  medical_io::LabelSurfaceOptions options;
  options.triangles = triangles;
  options.smoothing = kLabelSmoothing;
  options.largestPieceOnly = true;
  auto surface = std::move(medical_io::labelSurfaces(map, options, progress, threads).front());
  for (const Text& warning : surface.warnings)
    warnings.push_back(phrase("%1: %2", name, warning));
  return std::move(surface.mesh);
}

std::vector<TriangleMesh> restSurfaces(const MotionSeries& series, const TrackOptions& options,
                                       std::vector<Text>& warnings, Progress& progress, Threads threads) {
  std::vector<TriangleMesh> rest;
  for (std::size_t i = 0; i < series.names.size(); ++i) {
    if (!series.corresponding.empty())
      rest.push_back(series.corresponding[i].at(0));
    else if (!series.meshes.empty())
      rest.push_back({series.meshes[0][i]->points, series.meshes[0][i]->triangles, {}});
    else
      rest.push_back(
          surfaceAround(series.masks[0][i], series.names[i], options.triangles, warnings, progress, threads));
  }
  return rest;
}

document::Rig rigFor(const std::vector<TriangleMesh>& rest, const MotionSeries& series,
                     const TrackOptions& options) {
  return options.handles ? givenRig(*options.handles) : madeRig(rest, series, options.rig);
}

MotionRig boundTo(const document::Rig& handles, std::vector<TriangleMesh> rest, const TrackOptions& options,
                  Progress& progress, Threads threads) {
  const Eigen::Index corners = options.handles ? 0 : kRigCorners;
  const Points places = handles.restPositions();
  return {std::move(rest),
          places,
          options.rig.locality,
          tracking::softnessFor(places, corners, options.rig.softness),
          progress,
          threads};
}

tracking::PhaseTargets targetsOf(const MotionSeries& series, std::size_t phase) {
  tracking::PhaseTargets targets{{}, Values(static_cast<Eigen::Index>(series.names.size()))};
  for (std::size_t i = 0; i < series.names.size(); ++i) {
    targets.volumesMl[static_cast<Eigen::Index>(i)] = series.volumesMl[phase][i];
    if (series.masks.empty())
      targets.distances.push_back(std::make_shared<const tracking::MeshDistance>(series.meshes[phase][i]));
    else
      targets.distances.push_back(std::make_shared<const tracking::MaskDistance>(series.masks[phase][i]));
    if (!series.rims.empty())
      for (const tracking::Rim& rim : series.rims[phase][i])
        targets.rims.push_back(tracking::pointsOf(rim, series.meshes[phase][i]->points));
  }
  return targets;
}

tracking::PhaseQuality Assessment::of(std::size_t phase) const {
  tracking::PhaseQuality quality;
  const Points vertices = rig_.vertices(fit_.poses[phase]);
  const Values volumes = rig_.volumesMl(vertices);
  const tracking::PhaseTargets targets =
      series_.corresponding.empty() ? targetsOf(series_, phase) : tracking::PhaseTargets{{}, {}};
  Values all(vertices.rows()), weights(vertices.rows());
  for (std::size_t i = 0; i < series_.names.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    const Points own = vertices.middleRows(rig_.firstRow(i), rig_.rows(i));
    tracking::SurfaceQuality surface;
    surface.measuredMl = series_.volumesMl[phase][i];
    surface.freeMl = fit_.freeVolumesMl[phase][column];
    surface.fittedMl = volumes[column];
    const Values residuals = residualsOf(own, phase, i, targets, surface);
    const Values areas = tracking::vertexAreas(own, rig_.surfaces()[i].triangles);
    const tracking::Spread spread = tracking::spreadOf(residuals, areas);
    surface.meanMm = spread.mean;
    surface.p95Mm = spread.p95;
    surface.maxMm = spread.max;
    all.segment(rig_.firstRow(i), rig_.rows(i)) = residuals;
    weights.segment(rig_.firstRow(i), rig_.rows(i)) = areas / areas.sum();
    if (surface.dice)
      quality.dice = std::min(quality.dice.value_or(1), *surface.dice);
    quality.surfaces.push_back(surface);
  }
  const tracking::Spread spread = tracking::spreadOf(all, weights);
  quality.meanMm = spread.mean;
  quality.p95Mm = spread.p95;
  quality.maxMm = spread.max;
  quality.steps = fit_.steps[phase];
  quality.volumesMet = fit_.volumes.empty() || fit_.volumes[phase].met;
  return quality;
}

/// Distances of the vertices of one surface, mm; fills in flips and Dice.
Values Assessment::residualsOf(const Points& own, std::size_t phase, std::size_t i,
                               const tracking::PhaseTargets& targets,
                               tracking::SurfaceQuality& surface) const {
  const Triangles& triangles = rig_.surfaces()[i].triangles;
  if (!series_.corresponding.empty()) {
    const Points& measured = series_.corresponding[i].phases[phase];
    surface.flipped = tracking::opposedTriangles(triangles, own, measured);
    return (own - measured).rowwise().norm();
  }
  Values residuals(own.rows());
  for (Eigen::Index v = 0; v < own.rows(); ++v) {
    Vec3 ignored;
    residuals[v] = std::abs(targets.distances[i]->at(own.row(v).transpose(), ignored));
  }
  surface.flipped = tracking::opposedTriangles(triangles, own, *targets.distances[i]);
  if (!series_.masks.empty()) {
    const tracking::Mask& mask = series_.masks[phase][i];
    surface.dice = tracking::diceOf(tracking::voxelised({own, triangles, {}}, mask), mask);
  }
  return residuals;
}

SequenceFile sequenceOf(const std::vector<std::string>& names, const tracking::PhaseTimes& times,
                        const MotionRig& rig, const std::vector<Points>& poses,
                        const document::Rig& handles) {
  SequenceFile file;
  file.track.name = "Measured";
  file.track.restHandles = rig.rest();
  for (const document::Group& group : handles.groups) {
    sequences::HandleGroup& rows = file.track.groups.emplace_back();
    rows.name = group.name;
    rows.color = group.color;
    for (const document::HandleId id : group.handles)
      rows.handles.push_back(handles.indexOf(id));
  }
  file.track.periodSeconds = times.periodSeconds;
  file.track.loop = times.loop;
  file.track.interpolation = sequences::Interpolation::curve;
  for (std::size_t phase = 0; phase < poses.size(); ++phase)
    file.track.keys.push_back({times.seconds[phase], poses[phase], sequences::Easing::smooth});
  for (const document::Handle& handle : handles.handles)
    file.labels.push_back(handle.label);
  document::SystemChoice system;
  system.id = "s-celestial";
  system.parameters.set("locality", rig.locality());
  system.parameters.set("softness", rig.softnessMm());
  file.system = system;
  for (std::size_t i = 0; i < names.size(); ++i)
    file.organs.push_back({names[i], std::make_shared<const TriangleMesh>(rig.surfaces()[i])});
  return file;
}

} // namespace viscera::live
