#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/strain/aha_segments.h"
#include "viscera/strain/heart_axes.h"
#include "viscera/strain/material_contour.h"
#include "viscera/strain/strain_curve.h"

/// What is measured of a heart's strain over the phases of a cycle, by the two definitions of docs/strain.md:
/// of the length of contours (what echo and feature tracking report) and of the material at witness points.
namespace viscera::strain {

/// A contour of length strain with its curve.
struct ContourStrain {
  std::string name;          ///< "fourChamber"
  double referenceMm = 0;    ///< Its length in the reference phase.
  std::vector<double> curve; ///< Change of length, a part; one a phase.
  Peak peak;                 ///< The shortest; of an atrium the longest.
};

/// One segment over the phases. Strain is engineering strain, a part.
struct SegmentStrain {
  int number = 0;
  int witnesses = 0;   ///< Witness points, or triangles of the endocardium where no wall is known.
  bool enough = false; ///< Whether they are `kFewestWitnesses` at least.
  std::vector<double> longitudinal, circumferential;
  std::vector<double> radial;      ///< Empty where no wall is known.
  std::vector<double> area;        ///< Change of the endocardium's area.
  std::vector<double> thicknessMm; ///< Empty where no outer surface is known; NaN where it is not measured.
  std::vector<double> thickening;  ///< Its change against the reference, a part; as `thicknessMm`.
};

inline constexpr int kFewestWitnesses = 20;

/// Everything that is measured.
struct HeartStrain {
  explicit HeartStrain(const FoundAxes& found)
      : axes(found.axes), oriented(found.oriented), septumDegrees(found.septumDegrees) {}

  HeartAxes axes;
  bool oriented;        ///< As in `FoundAxes`.
  double septumDegrees; ///< As in `FoundAxes`.
  std::vector<double> seconds;
  std::size_t reference = 0;
  bool wall = false; ///< Whether segments are of the wall, not of the endocardium alone.

  std::vector<ContourStrain> longitudinal;    ///< In the 4-, 2- and 3-chamber plane.
  std::vector<ContourStrain> circumferential; ///< At base, middle, apex.
  std::optional<ContourStrain> gls, gcs;      ///< Means of these curves.
  std::optional<ContourStrain> grs;           ///< Of the material across the wall; peak is the largest.
  std::optional<ContourStrain> materialLongitudinal, materialCircumferential; ///< Means over the wall.
  std::optional<ContourStrain> rightFreeWall;
  std::optional<ContourStrain> leftReservoir;
  std::vector<ContourStrain> others; ///< Listed contours of other names.
  std::vector<ContourStrain> areas;  ///< Of each surface without its valves.

  std::array<SegmentStrain, kSegments> segments; ///< By number; the first is number 1.
  std::vector<double> twistDegrees;        ///< Apex against base, seen from the apex; empty: not measured.
  std::vector<double> torsionDegreesPerCm; ///< The same by the distance of both rings.
  /// Standard deviation of the times to the peak of shortening of segments 1 to 16, s; along and around.
  double dispersionLongitudinal = 0, dispersionCircumferential = 0;

  const SegmentStrain& segment(int number) const { return segments[static_cast<std::size_t>(number - 1)]; }
};

/// The strain of a contour in all phases. `phases` are the points of its surface.
ContourStrain contourStrain(const std::string& name, const MaterialContour& contour,
                            const std::vector<Points>& phases, const std::vector<double>& seconds,
                            std::size_t reference);

} // namespace viscera::strain
