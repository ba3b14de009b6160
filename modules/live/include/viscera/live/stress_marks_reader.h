#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/document/document.h"
#include "viscera/live/stress_reading.h"

namespace viscera::live {

/// A probe and its stress values.
struct ReadProbe {
  document::StressProbe probe;
  StressReading reading;
};

/// A line of the document with the stress along it.
struct ReadProfile {
  document::StressLine line;
  std::string name; ///< "1-2", by its probes.
  StressProfile profile;
};

/// The values at the probes and along the lines of one organ.
struct ReadMarks {
  std::vector<ReadProbe> probes; ///< In the document's order; those of other organs are left out.
  std::vector<ReadProfile> profiles;
};

/// Reads the probes and profiles of one organ from its stress maps. It caches the places of the marks in the
/// mesh, which are found again only when the mesh or the marks change. For one thread.
class StressMarksReader {
public:
  /// The values of the marks in `organ` in a pose (see `TissuePoints::read`); empty while `mesh` is null or
  /// the map has another number of points. O(marks), after another mesh or mark O(mesh).
  ReadMarks read(const document::DocumentState& state, document::OrganId organ,
                 const std::shared_ptr<const deformation::WitnessMesh>& mesh, const Points& posed,
                 const deformation::StressMap& map);

private:
  void place();

  std::shared_ptr<const document::StressMarks> marks_;
  document::OrganId organ_;
  std::shared_ptr<const deformation::WitnessMesh> mesh_;
  std::vector<document::StressProbe> probes_; ///< Of the organ.
  std::vector<document::StressLine> lines_;
  std::optional<TissuePoints> atProbes_;
  std::vector<TissuePoints> alongLines_; ///< One a line.
};

} // namespace viscera::live
