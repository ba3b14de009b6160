#include "viscera/live/stress_marks_reader.h"

namespace viscera::live {

namespace {
/// Part of the mesh's diagonal: a place on the skin counts as tissue in spite of rounding.
constexpr double kOnSkin = 1e-9;
} // namespace

void StressMarksReader::place() {
  probes_.clear();
  lines_.clear();
  atProbes_.reset();
  alongLines_.clear();
  for (const document::StressProbe& probe : marks_->probes)
    if (probe.organ == organ_)
      probes_.push_back(probe);
  if (probes_.empty() || !mesh_)
    return;
  Points rest(static_cast<Eigen::Index>(probes_.size()), 3);
  for (std::size_t i = 0; i < probes_.size(); ++i)
    rest.row(static_cast<Eigen::Index>(i)) = probes_[i].rest.transpose();
  atProbes_.emplace(mesh_, rest, probeReach(*mesh_));
  for (const document::StressLine& line : marks_->lines) {
    const document::StressProbe *from = marks_->probe(line.from), *to = marks_->probe(line.to);
    if (!from || !to || from->organ != organ_)
      continue;
    lines_.push_back(line);
    alongLines_.emplace_back(mesh_, placesAlong(from->rest, to->rest, kProfilePoints),
                             kOnSkin * boundsOf(mesh_->points).diagonal());
  }
}

ReadMarks StressMarksReader::read(const document::DocumentState& state, document::OrganId organ,
                                  const std::shared_ptr<const deformation::WitnessMesh>& mesh,
                                  const Points& posed, const deformation::StressMap& map) {
  if (marks_ != state.stressMarks || organ_ != organ || mesh_ != mesh) {
    marks_ = state.stressMarks;
    organ_ = organ;
    mesh_ = mesh;
    place();
  }
  ReadMarks read;
  if (!atProbes_ || posed.rows() != mesh_->points.rows() || map.volumeRatio.size() != posed.rows())
    return read;
  const std::vector<StressReading> readings = atProbes_->read(posed, map);
  for (std::size_t i = 0; i < probes_.size(); ++i)
    read.probes.push_back({probes_[i], readings[i]});
  for (std::size_t i = 0; i < lines_.size(); ++i)
    read.profiles.push_back(
        {lines_[i], marks_->nameOf(lines_[i]), profileOf(alongLines_[i].read(posed, map))});
  return read;
}

} // namespace viscera::live
