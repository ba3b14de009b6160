#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/live/moved_organs.h"
#include "viscera/strain/heart_gauge.h"
#include "viscera/strain/wall_means.h"

/// Reads the strain of a heart from its motion.
namespace viscera::live {

/// What is measured, and by which surfaces.
struct StrainOptions {
  /// Names of surfaces: cavity of the left and of the right ventricle, epicardium (or whole heart), cavity of
  /// the left atrium. Those that are empty are found by their names and places.
  std::string left, right, outer, atrium;
  strain::AxisLandmarks landmarks;
  /// The phase without strain, the end of diastole. None: the first one, or the fullest where the left
  /// ventricle holds 3 % more in another.
  std::optional<std::size_t> reference;
  int witnesses = 40'000; ///< In the outer surface, cavities included.
  std::vector<strain::ListedContour>
      contours; ///< Vertices as in the files; surfaces by name, or "" for the left.
};

/// The strain of a heart with what it was read from.
struct StrainReading {
  explicit StrainReading(const strain::FoundAxes& axes) : strain(axes) {}

  strain::HeartStrain strain;
  std::string left, right, outer, atrium; ///< Names of surfaces; empty: there is none.
  int witnesses = 0;                      ///< In the left ventricle's wall.
  std::optional<bool> corresponding;      ///< As in `MovedOrgans`.
  /// The standard deviations of the segments' strain at the peak of GLS that follow from the errors of the
  /// motion's fit; none where the motion was not fitted to points that are known.
  std::optional<strain::WallMeans> deviations;
  std::vector<Text> warnings;

  /// Whether a segment's numbers may be read: enough witness points, and material points that are known.
  bool reliable(const strain::SegmentStrain& segment) const {
    return segment.enough && corresponding.value_or(true);
  }
};

/// A heart at rest, prepared for reading its strain: axes, segments, and surfaces and points of the wall that
/// are bound to the handles. Immutable; thread-safe.
///
///     const StrainGauge gauge(organs, options, progress); // Seconds.
///     const StrainReading beat = gauge.read(organs, progress);
class StrainGauge {
public:
  /// Takes organs, handles and coordinates of `organs`; its poses do not matter. Where there is an outer
  /// surface around the left ventricle, its wall is filled with witness points, whose deformation gradients
  /// are analytic; else segments are those of the endocardium alone. Throws `DataError` for organs without a
  /// left ventricle, `UsageError` for wrong names, what binding throws, and `Cancelled`. Seconds; half of
  /// these where `before` is a gauge of the same surfaces by other axes, whose tetrahedra are taken. The
  /// numbers do not depend on `before`.
  StrainGauge(const MovedOrgans& organs, const StrainOptions& options, Progress& progress,
              Threads threads = {}, const StrainGauge* before = nullptr);

  /// Measures the poses of `moved`, which has the same organs and handles, or its measured surfaces; against
  /// the phase `reference` where it is given, else as the options say. A phase takes milliseconds; a motion
  /// that was fitted to known points a second more, for the deviations of its segments. Throws what
  /// `strain::HeartGauge::read` throws.
  StrainReading read(const MovedOrgans& moved, Progress& progress, Threads threads = {},
                     std::optional<std::size_t> reference = std::nullopt) const;

  /// The segment of each vertex of an organ, 1 to 17, or 0 where it is no wall of the left ventricle; empty
  /// for organs other than its cavity and the surface around it.
  const std::vector<int>& segmentsOn(std::size_t organ) const;

private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

/// The strain of one motion: a `StrainGauge` that is used once.
StrainReading readStrain(const MovedOrgans& organs, const StrainOptions& options, Progress& progress,
                         Threads threads = {});

/// The direction of the strain of a segment; thickening is that of the wall between both its surfaces.
enum class StrainDirection { longitudinal, circumferential, radial, thickening };

/// What is taken from a segment's curve.
enum class StrainMoment { peak, instant, timeToPeak };

/// The curve of a segment, a part for each phase; empty across the wall where no wall is known, and of the
/// thickness where no outer surface is.
const std::vector<double>& strainCurve(const strain::SegmentStrain& segment, StrainDirection direction);

/// The value of a segment, 1 to 17: per cent, or ms of a time to peak; `phase` counts for an instant only.
/// None for a segment with too few points, and where `strainCurve` is empty or was not measured.
std::optional<double> strainValue(const StrainReading& reading, int segment, StrainDirection direction,
                                  StrainMoment moment, std::size_t phase = 0);

/// How far a segment's peak may be off by the errors of the motion's fit: a standard deviation, in points of
/// per cent. None where it is not known.
std::optional<double> strainDeviation(const StrainReading& reading, int segment, StrainDirection direction);

/// Whether a segment's peak may be read against the range of healthy adults: `StrainReading::reliable`, and
/// where its deviation is known that is not larger than the distance from the nearer end of the range.
bool reliablePeak(const StrainReading& reading, int segment, StrainDirection direction);

/// Thickness (mm, in the reference phase) and thickening (per cent, the most) of a segment's wall.
struct WallThickness {
  double millimeters = 0, thickeningPercent = 0;
};
/// None where no outer surface is known, and for segments that were not measured.
std::optional<WallThickness> wallThickness(const StrainReading& reading, int segment);

/// The largest of degrees over the phases, by its size, with its sign: the twist, the torsion. None for none.
std::optional<double> largestTurn(const std::vector<double>& degrees);

/// Everything as one JSON object: the keys of `viscera strain --json` (docs/strain.md).
std::string strainJson(const StrainReading& reading);

/// All curves as a table (.csv), a row for each phase: per cent, mm and degrees. Throws `CannotCreateError`.
void writeStrainTable(const std::filesystem::path& file, const StrainReading& reading);

/// Reads contours from a JSON file (docs/strain.md): `{"contours": [{"name": "fourChamber", "surface": "LV",
/// "vertices": [...], "closed": false}]}`, or short, for the left ventricle, `{"fourChamber": [...]}`.
/// Vertices are counted from 0, or from "firstIndex". Names may be those of other programs: "4ch", "mid",
/// "rvfw"; contours of further names are measured beside the others. Throws `NoInputError`, and `DataError`
/// that names the contour.
std::vector<strain::ListedContour> readContours(const std::filesystem::path& file);

/// The name that `strain::HeartStrain` has for a contour of this or another program's name; empty for others.
std::string contourNamed(const std::string& name);

} // namespace viscera::live
