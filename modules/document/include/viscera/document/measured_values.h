#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/document/measurement.h"
#include "viscera/geometry/surface_gap.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/medical_io/region_statistics.h"

namespace viscera::document {

struct DocumentState;

/// The present value of a measurement: a length, an angle, or the statistics of a region.
struct MeasuredValues {
  double rest = 0; ///< mm or degrees, at rest; of a region the mean, NaN where the scan has no values. Of a
                   ///< gap 0 where the surfaces touch or cross.
  double now = 0;  ///< With organs and tissue where they are given; of a region as at rest.
  std::vector<Vec3> places; ///< Where its points are now, mm, LPS.
  /// Statistics of a region, if there is a scan, of its recorded values, without deformation by the
  /// pose.
  std::optional<medical_io::RegionStatistics> region;
};

/// Returns an organ's present points, `n x 3` mm; called for organs of the document only.
using PointsOf = std::function<const Points&(OrganId)>;

/// Where the tissue of the scan that is at a place at rest is shown now, mm, LPS. Empty where the scan is
/// shown as it was recorded.
using TissueMotion = std::function<Vec3(const Vec3& rest)>;

/// Where a point is now, mm, LPS. A point on no organ stays, or goes with the tissue of a scan that is shown
/// warped; one whose organ is not in the document is at rest. O(1).
Vec3 placeNow(const MeasuredPoint& point, const DocumentState& state, const PointsOf& pointsOf,
              const TissueMotion& tissue = {});

/// Where the points of a measurement are now, as many as it has so far. A region keeps its size and shape, by
/// which the scan is measured, and goes with the tissue at its first point.
std::vector<Vec3> placesNow(const Measurement& measurement, const DocumentState& state,
                            const PointsOf& pointsOf, const TissueMotion& tissue = {});

/// A cache for what takes longer to measure than a frame may: the statistics of regions of a scan, and the
/// arranged surfaces of organs whose gap is measured. For one thread.
class MeasuringMemory {
public:
  /// The statistics of a region; none without a scan. O(voxels of the region) if it is not in the cache.
  std::optional<medical_io::RegionStatistics> of(const Measurement& measurement, const DocumentState& state);

  /// The gap of two organs at rest, and with other points. None where an organ is not in the document.
  struct Gap {
    double restMm = 0;
    geometry::SurfaceGap now;
  };
  std::optional<Gap> gapOf(const Measurement& measurement, const DocumentState& state,
                           const PointsOf& pointsOf);

private:
  /// A surface that follows an organ.
  struct Follower {
    std::shared_ptr<const geometry::TriangleMesh> mesh;
    Points points; ///< That it has now.
    std::unique_ptr<geometry::SurfaceBoxes> boxes;
  };
  struct KeptGap {
    std::shared_ptr<const geometry::TriangleMesh> from, to;
    double restMm = 0;
    geometry::SurfaceGap last;
  };
  const geometry::SurfaceBoxes& follow(const Organ& organ, const Points& points);

  struct Kept {
    Measurement measurement;
    std::shared_ptr<const medical_io::Scan> scan;
    medical_io::RegionStatistics statistics;
  };
  std::map<MeasurementId, Kept> kept_;
  std::map<OrganId, Follower> followers_;
  std::map<MeasurementId, KeptGap> gaps_;
};

/// The distance of two places in mm, or the angle at the second of three in degrees, 0 to 180. The angle is 0
/// where one of its legs has no length.
double measuredValue(const std::vector<Vec3>& places);

/// Computes the value of a measurement in the present pose. A point of an organ that the document does not
/// have stays at its place at rest. O(organs), of a region that `memory` does not have O(its voxels), of a
/// gap O(points of both organs), and once O(m log m).
MeasuredValues measure(const Measurement& measurement, const DocumentState& state, const PointsOf& pointsOf,
                       MeasuringMemory* memory = nullptr, const TissueMotion& tissue = {});

/// The region of a rectangle or a sphere; none for the other kinds.
std::optional<medical_io::Region> regionOf(const Measurement& measurement);

/// "mm", "deg", or of a region the scan's unit; empty where that has none.
std::string unitOf(const Measurement& measurement, const DocumentState& state);

} // namespace viscera::document
