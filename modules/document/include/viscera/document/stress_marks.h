#pragma once

#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/document/ids.h"

namespace viscera::document {

/// A point of an organ's tissue at which stress is displayed. It is a material point, stored by its place at
/// rest, and moves with the tissue.
struct StressProbe {
  StressProbeId id;
  int number = 1; ///< Its unique number in the view and in tables, from 1.
  OrganId organ;
  Vec3 rest = Vec3::Zero(); ///< mm, LPS.

  friend bool operator==(const StressProbe&, const StressProbe&) = default;
};

/// The straight line at rest between two probes of one organ, along which the stress is drawn as a profile.
struct StressLine {
  StressLineId id;
  StressProbeId from;
  StressProbeId to;

  friend bool operator==(const StressLine&, const StressLine&) = default;
};

/// The probes and lines that a user has marked in stress maps, each list in the order of creation.
struct StressMarks {
  std::vector<StressProbe> probes;
  std::vector<StressLine> lines;

  bool empty() const { return probes.empty() && lines.empty(); }
  /// The probe with that id, or null. O(probes).
  const StressProbe* probe(StressProbeId id) const;
  /// "1-2", by the numbers of its probes.
  std::string nameOf(const StressLine& line) const;

  friend bool operator==(const StressMarks&, const StressMarks&) = default;
};

} // namespace viscera::document
