#pragma once

#include <array>
#include <optional>
#include <vector>

#include "implicit/nodes.h"
#include "implicit/tube_axis.h"

namespace viscera::sample_organs {

/// The pouches of the colon: constrictions between them, and three bands (taeniae) that run along it.
struct Haustra {
  double period = 30;  ///< mm of axis from one constriction to the next.
  double depth = 0.25; ///< How much of the radius a constriction takes.
  int taeniae = 3;
  double taeniaDepth = 0.12; ///< How much of the radius a band takes.
  double taeniaWidth = 0.22; ///< rad
  double stagger = 0.5;      ///< Shift from one row of pouches to the next round the tube, in periods.
  double jitter = 0;         ///< Irregularity of the constrictions, in periods.
  int seed = 1;
  double from = 0, to = 1e9; ///< Part of the axis, mm; fades in and out over one period.
};

/// Gentle rings, as in the small bowel.
struct Waves {
  double period = 60;      ///< mm
  double amplitude = 0.05; ///< Of the radius.
  double phase = 0;        ///< In periods.
};

/// Folds that run along the tube, as in the stomach's wall.
struct Folds {
  int count = 10;         ///< Round the tube.
  double depth = 0.02;    ///< Of the radius, from the mean to the top.
  double wander = 0.5;    ///< How far they stray sideways, in folds.
  double wavelength = 60; ///< mm of axis over which they do.
  int seed = 1;
  double from = 0, to = 1e9; ///< Part of the axis, mm; fades in and out over one wavelength.
};

/// The relief that modifies a tube's radius: haustra, waves and folds.
struct TubeRelief {
  std::optional<Haustra> haustra;
  std::optional<Waves> waves;
  std::optional<Folds> folds;

  bool plain() const { return !haustra && !waves && !folds; }
  /// The factor on the radius at `arc` mm along the axis, at `angle` rad round it.
  double factor(double arc, double angle) const;
  /// The largest possible factor.
  double largestFactor() const { return (waves ? 1 + waves->amplitude : 1) * (folds ? 1 + folds->depth : 1); }
};

/// A dimple in a flat end, so that a cut vessel looks hollow.
struct Lumen {
  double wall = 2;  ///< mm left around it.
  double depth = 6; ///< mm
};

/// Everything about a tube but its axis.
struct TubeShape {
  Vec3 flattenDirection = Vec3::UnitX();        ///< Unit.
  double flattenFactor = 1;                     ///< Thickness along that direction relative to a round tube.
  std::array<bool, 2> flatEnd = {false, false}; ///< Start, end: cut flat instead of a half ball.
  std::array<std::optional<Lumen>, 2> lumen;    ///< Only in flat ends.
  double beyond = 0;                            ///< mm that a flat end lies beyond the axis' end.
  double rim = 0.8;                             ///< Radius in mm that rounds the edge of a flat end.
  TubeRelief relief;
  double step = 1; ///< mm between samples of the axis.
};

/// A tube of varying radius along a smooth axis through `points`: at least two, with positive radii. Its
/// bends must be wider than its radius.
NewNode makeTube(std::vector<AxisPoint> points, const TubeShape& shape);

} // namespace viscera::sample_organs
