#pragma once

#include <string>
#include <vector>

#include "viscera/circulation/beat.h"
#include "viscera/circulation/indices.h"
#include "viscera/circulation/parameters.h"

namespace viscera::circulation {

/// A column of the circulation's curves over one beat, with its name, such as "lv_mmHg".
struct NamedCurve {
  std::string name; ///< With its unit: `_s`, `_mmHg`, `_ml`, `_ml_s`, `_open` (0 to 1), `_mV`.
  std::vector<double> values;
};

/// All curves of a beat as columns of one length, `time_s` first, then pressures, volumes, flows, openings,
/// `ecg_mV` and `sound`. O(samples).
std::vector<NamedCurve> curvesOf(const Parameters& parameters, const Beat& beat, const Indices& indices);

/// The part of a beat of `samples` even steps by which diagrams and the moving heart begin earlier than its
/// curves, which begin with the ventricles' contraction: a whole number of steps. O(1).
double drawnBefore(const Parameters& parameters, int samples, double beforeAtria);

/// The sample of a beat with which diagrams and the moving heart begin: `beforeAtria` seconds before the
/// atria contract. The curves of a beat begin later, with the ventricles' contraction.
std::size_t firstDrawn(const Parameters& parameters, const Beat& beat, double beforeAtria);

/// A curve over one beat from that sample on, as long as it was.
std::vector<double> drawnFrom(std::size_t first, const std::vector<double>& curve);

/// How long the early wave of the left ventricle's filling lasts after the mitral valve has opened, s: until
/// the flow has fallen to a tenth of its height, or the atria contract.
double earlyFillingSeconds(const Parameters& parameters, const Beat& beat, const Indices& indices);

/// The names of chambers ("lv") and valves ("mitral") in tables and JSON.
std::string nameOf(Compartment compartment);
std::string nameOf(Valve valve);

} // namespace viscera::circulation
