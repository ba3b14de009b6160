#pragma once

#include <string>
#include <vector>

#include "viscera/circulation/indices.h"
#include "viscera/circulation/parameters.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"

namespace viscera::circulation {

/// The measurements of a patient's left ventricle to which a circulation is fitted.
struct MeasuredVentricle {
  double edvMl = 0; ///< Its largest volume.
  double ef = 0;    ///< Its ejection fraction, 0 to 1.
  double ratePerMinute = 72;
  double meanAorticMmHg = 0; ///< The mean pressure in the aorta; 0: not measured, that of `start` is kept.
};

/// The circulation that was fitted to a patient's left ventricle, and how well it fits.
struct PatientFit {
  Parameters parameters;
  PeriodicState state = {};
  Indices indices = {};
  double edvErrorMl = 0;                 ///< Fitted less measured.
  double efError = 0;                    ///< The same of the ejection fraction.
  double pressureErrorMmHg = 0;          ///< The same of the mean aortic pressure.
  std::vector<std::string> atLimit = {}; ///< Names of parameters that would have to leave their ranges.

  /// Whether volume, ejection fraction and pressure match the measured ones: within 0.5 ml, 0.002 and 0.5
  /// mmHg.
  bool met() const;
  /// The result of the fit, as a sentence.
  Text remark() const;
};

/// The names of the parameters that the fit determines, and that cannot be given with it: the names of
/// parameters.
const std::vector<std::string>& fittedParameters();

/// Finds the circulation in which the left ventricle has the measured end-diastolic volume and ejection
/// fraction. Two numbers do not determine everything, so these assumptions are made: the ventricle is that of
/// `start` at another size (volumes by the ratio of the end-diastolic ones, elastances by its inverse), the
/// right ventricle by the ratio of the stroke volumes; then contractility (`lvEes`), preload
/// (`stressedVolume`) and afterload (`systemicResistance`) are found so that ejection fraction, volume and
/// mean aortic pressure are met (Gauss-Newton steps on their logarithms, damped, within their ranges). Values
/// that cannot be reached are reported in `atLimit` and in the errors.
///
/// Takes 0.1 to 1 s. Throws `UsageError` for implausible measurements, `DataError` if there is no periodic
/// beat, `Cancelled`. Thread-safe.
PatientFit fitToVentricle(const MeasuredVentricle& measured, Progress& progress,
                          const Parameters& start = {});

} // namespace viscera::circulation
