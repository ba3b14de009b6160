#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/circulation/normal_values.h"

namespace viscera::circulation {

/// The parameters of one chamber of the heart. Its pressure above that of the pericardium is `(1 - e) a
/// (exp(b (V - v0)) - 1) + e ees (V - v0)`, with e(t) from 0 (relaxed) to 1 (end of systole) (Burkhoff and
/// Tyberg 1993, doi 10.1152/ajpheart.1993.265.5.H1819).
struct Chamber {
  double ees = 0; ///< Elastance at the end of systole, mmHg/ml.
  double v0 = 0;  ///< Volume without pressure, ml.
  double a = 0;   ///< Relaxed: the curve's scale, mmHg.
  double b = 0;   ///< Relaxed: its steepness, 1/ml.
  double tau = 0; ///< Time constant with which contraction fades, s.

  friend bool operator==(const Chamber&, const Chamber&) = default;
};

/// The effective areas of a valve when it is open and when it is closed, cm^2.
struct ValveAreas {
  double open = 0;
  double leak = 0; ///< 0: tight.

  friend bool operator==(const ValveAreas&, const ValveAreas&) = default;
};

/// The parameters of the arteries and veins of the systemic or the pulmonary circulation: arteries as a
/// three-element windkessel (Westerhof and others 2009, doi 10.1007/s11517-008-0359-2), then veins that hold
/// blood and resist.
struct Vessels {
  double impedance = 0;        ///< Characteristic impedance of the great artery, mmHg s/ml.
  double arteryCompliance = 0; ///< ml/mmHg
  double resistance = 0;       ///< From arteries to veins, mmHg s/ml.
  double veinCompliance = 0;   ///< ml/mmHg
  double veinResistance = 0;   ///< From veins to the atrium, mmHg s/ml.

  friend bool operator==(const Vessels&, const Vessels&) = default;
};

/// All parameters of the circulation; the defaults are those of an adult at rest. A plain value.
struct Parameters {
  double rate = 72;          ///< Beats a minute.
  double stressedVolume = 0; ///< The blood volume that stretches vessels and chambers (preload), ml.
  double conduction = 0;     ///< From the beginning of the atria's contraction to that of the ventricles', s.
  Chamber lv, rv, la, ra;
  Vessels systemic, pulmonary;
  ValveAreas mitral, aortic, tricuspid, pulmonic;
  double pericardialFluid = 0; ///< ml
  double pericardialRoom = 0;  ///< The volume of heart and fluid above which the pericardium exerts pressure,
                               ///< ml.
  double pericardialScale = 0; ///< The additional volume, ml, that multiplies its pressure by e.

  Parameters();
  friend bool operator==(const Parameters&, const Parameters&) = default;
};

/// Name, unit, range and source of one parameter, for controls and the option `--param`.
struct ParameterInfo {
  std::string name;  ///< "lvEes"
  std::string title; ///< "Contractility of the left ventricle"
  std::string unit;  ///< "mmHg/ml"; empty for none.
  double rest = 0;   ///< The default.
  double lowest = 0; ///< The allowed range, which `checkParameters` enforces.
  double highest = 0;
  std::string source;   ///< Where the default comes from: a DOI, or "fitted to the values at rest".
  bool control = false; ///< Whether lessons use it as a control: rate, preload, afterload, contractility,
                        ///< valves.
  std::optional<NormalValues> normal = {}; ///< For controls: the range that the slider marks.
};

/// Every parameter, in the order of the documentation. O(1) after the first call; thread-safe.
const std::vector<ParameterInfo>& parameterInfos();

/// All parameters as a table in Markdown, with its header: the one of docs/circulation.md.
std::string parameterTable();

/// Returns the value of the parameter with that name. Throws `UsageError` that names the nearest ones for an
/// unknown name.
double parameter(const Parameters& parameters, const std::string& name);

/// Sets the value of the parameter with that name. Throws `UsageError` for an unknown name, and for a value
/// that is not finite or out of range.
void setParameter(Parameters& parameters, const std::string& name, double value);

/// Throws `UsageError` naming the first parameter that is out of its range, and when a valve leaks through a
/// larger area than it opens to.
void checkParameters(const Parameters& parameters);

/// Seconds from the beginning of the ventricles' contraction to the end of systole: 0.9 of isovolumic
/// contraction and ejection, which lasts max(413 - 1.7 rate, 371 - 1.2 rate) ms but 130 ms at least (Weissler
/// and others 1968, doi 10.1161/01.CIR.37.2.149, at rest; the flatter line in exercise).
double endSystoleSeconds(double ratePerMinute);

/// Seconds from the beginning of the atria's contraction to that of the ventricles': `conduction`, in a fast
/// heart no more than a part of the beat.
double conductionSeconds(const Parameters& parameters);

} // namespace viscera::circulation
