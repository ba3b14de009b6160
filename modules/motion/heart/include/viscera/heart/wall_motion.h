#pragma once

#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/heart/heart_frame.h"

namespace viscera::heart {

/// The vertices of a heart's surfaces, each `n x 3` mm, in the order of its mesh.
struct HeartSurfaces {
  const Points& leftCavity;
  const Points& rightCavity;
  const Points& outer;
};

/// The positions of the ventricles' walls at one instant.
struct WallPlaces {
  double leftBaseMm = 0;  ///< How far the rim of the left cavity's base has come towards the apex.
  double rightBaseMm = 0; ///< The same of the right cavity's base at its free wall.
  double baseTurn = 0;    ///< How far the left cavity has turned about its axis, near the base, rad,
  double apexTurn = 0;    ///< and near the apex; from the base to the apex clockwise is positive.
  double wallMm = 0;      ///< The left ventricle's free wall between base and apex.
};

/// Clinical measures of the ventricles' motion over a beat: descent of the valve planes, twist, wall
/// thickening.
struct WallMotion {
  double mapseMm = 0;           ///< Excursion of the mitral annulus' plane.
  double tapseMm = 0;           ///< That of the tricuspid annulus at the free wall.
  double twistDegrees = 0;      ///< Apex against base, the largest.
  double thickeningPercent = 0; ///< Of the free wall, from its thinnest to its thickest.
  double thinnestWallMm = 0;
  double thickestWallMm = 0;
};

/// Measures the motion of the ventricles' walls on the surfaces of a heart: vertices are chosen once, at
/// rest, and followed. Rings of the left cavity 2 to 8 mm (base), 4 to 14 and 70 to 82 mm (turn) below the
/// mitral valve; the right cavity's base within 0.35 rad of its free wall's middle; the free wall opposite to
/// the right ventricle, 15 to 50 mm below the valve, as the mean distance of both its surfaces from the axis
/// in slices of 7 mm. Immutable; thread-safe.
class WallGauge {
public:
  /// Throws `DataError` naming the place where a surface has too few vertices to be measured. O(n).
  WallGauge(const HeartFrame& frame, const HeartSurfaces& rest);

  /// Throws `DataError` when a surface has another number of vertices than at rest. O(n).
  WallPlaces at(const HeartSurfaces& now) const;

private:
  /// A vertex and where it is at rest.
  struct Followed {
    Eigen::Index row;
    HeartPoint rest;
  };
  using Region = std::vector<Followed>;
  /// One slice of the free wall.
  struct Slice {
    Region inner, outer;
  };

  double alongOf(const Region& region, const Points& points) const;
  double turnOf(const Region& region, const Points& points) const;
  double rhoOf(const Region& region, const Points& points) const;

  HeartFrame frame_;
  Eigen::Index leftCount_ = 0, rightCount_ = 0, outerCount_ = 0;
  Region leftBase_, rightBase_, turningBase_, turningApex_;
  std::vector<Slice> wall_;
};

/// Computes the measures of a beat from its instants, at least one.
WallMotion wallMotion(const std::vector<WallPlaces>& beat);

/// The normal range of a measure of wall motion: low, high, unit and source.
struct WallMotionRange {
  const char* name;  ///< "MAPSE"
  const char* about; ///< "excursion of the mitral annulus"
  double WallMotion::*value;
  double low, high;
  const char* unit;
  const char* source;
};
const std::vector<WallMotionRange>& wallMotionRanges();

} // namespace viscera::heart
