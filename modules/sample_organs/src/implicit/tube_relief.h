#pragma once

#include <optional>

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

/// Folds that run along the tube, as the stomach's wall has them.
struct Folds {
  int count = 10;         ///< Round the tube.
  double depth = 0.02;    ///< Of the radius, from the mean to the top.
  double wander = 0.5;    ///< How far they stray sideways, in folds.
  double wavelength = 60; ///< mm of axis over which they do.
  int seed = 1;
  double from = 0, to = 1e9; ///< Part of the axis, mm; fades in and out over one wavelength.
};

/// What makes a tube's radius differ from its axis's.
struct TubeRelief {
  std::optional<Haustra> haustra;
  std::optional<Waves> waves;
  std::optional<Folds> folds;

  bool plain() const { return !haustra && !waves && !folds; }
  /// The factor on the radius at `arc` mm along the axis, at `angle` rad round it.
  double factor(double arc, double angle) const;
  /// The largest factor there can be.
  double largestFactor() const { return (waves ? 1 + waves->amplitude : 1) * (folds ? 1 + folds->depth : 1); }
};

} // namespace viscera::sample_organs
