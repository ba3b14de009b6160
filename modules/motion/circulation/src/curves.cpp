#include "viscera/circulation/curves.h"

#include <algorithm>
#include <cmath>

#include "circuit.h"
#include "viscera/circulation/signs.h"

namespace viscera::circulation {

std::string nameOf(Compartment compartment) {
  constexpr std::array<const char*, kCompartments> kNames = {
      "lv", "rv", "la", "ra", "aorta", "systemic_veins", "pulmonary_artery", "pulmonary_veins"};
  return kNames[at(compartment)];
}

std::string nameOf(Valve valve) {
  constexpr std::array<const char*, kValves> kNames = {"mitral", "aortic", "tricuspid", "pulmonic"};
  return kNames[at(valve)];
}

namespace {

long stepsBefore(const Parameters& parameters, double period, std::size_t count, double beforeAtria) {
  const double back = (conductionSeconds(parameters) + beforeAtria) / period;
  return std::lround(back * static_cast<double>(count));
}

} // namespace

double drawnBefore(const Parameters& parameters, int samples, double beforeAtria) {
  const auto count = static_cast<std::size_t>(samples);
  return static_cast<double>(stepsBefore(parameters, 60 / parameters.rate, count, beforeAtria)) / samples;
}

std::size_t firstDrawn(const Parameters& parameters, const Beat& beat, double beforeAtria) {
  const std::size_t count = beat.time.size() - 1;
  const auto samples = static_cast<std::size_t>(stepsBefore(parameters, beat.period, count, beforeAtria));
  return (2 * count - samples) % count;
}

std::vector<double> drawnFrom(std::size_t first, const std::vector<double>& curve) {
  // The last sample is the first of the next beat.
  std::vector<double> drawn(curve.begin() + static_cast<std::ptrdiff_t>(first), curve.end() - 1);
  drawn.insert(drawn.end(), curve.begin(), curve.begin() + static_cast<std::ptrdiff_t>(first) + 1);
  return drawn;
}

double earlyFillingSeconds(const Parameters& parameters, const Beat& beat, const Indices& indices) {
  constexpr double kOver = 0.1;
  const auto& mitral = indices.valves[at(Valve::mitral)];
  if (!mitral)
    return 0;
  const double atria = beat.period - conductionSeconds(parameters);
  const auto& flow = beat.flowOf(Valve::mitral);
  double highest = 0;
  for (std::size_t i = 0; i < flow.size(); ++i) {
    if (beat.time[i] < mitral->opens || beat.time[i] >= atria)
      continue;
    highest = std::max(highest, flow[i]);
    if (highest > 0 && flow[i] < kOver * highest && flow[i] < flow[i - 1])
      return beat.time[i] - mitral->opens;
  }
  return std::max(0.0, atria - mitral->opens);
}

std::vector<NamedCurve> curvesOf(const Parameters& parameters, const Beat& beat, const Indices& indices) {
  std::vector<NamedCurve> curves;
  curves.push_back({"time_s", beat.time});
  for (std::size_t i = 0; i < kCompartments; ++i)
    curves.push_back({nameOf(static_cast<Compartment>(i)) + "_mmHg", beat.pressure[i]});
  curves.push_back({"pericardium_mmHg", beat.pericardium});
  for (std::size_t i = 0; i < kCompartments; ++i)
    curves.push_back({nameOf(static_cast<Compartment>(i)) + "_ml", beat.volume[i]});
  for (std::size_t i = 0; i < kValves; ++i)
    curves.push_back({nameOf(static_cast<Valve>(i)) + "_ml_s", beat.flow[i]});
  curves.push_back({"systemic_ml_s", beat.systemicFlow});
  curves.push_back({"pulmonary_ml_s", beat.pulmonaryFlow});
  for (std::size_t i = 0; i < kValves; ++i)
    curves.push_back({nameOf(static_cast<Valve>(i)) + "_open", beat.open[i]});
  NamedCurve ecg{"ecg_mV", {}};
  for (const double seconds : beat.time)
    ecg.values.push_back(electrocardiogram(parameters, seconds));
  curves.push_back(std::move(ecg));
  curves.push_back({"sound", phonocardiogram(parameters, beat, indices)});
  return curves;
}

} // namespace viscera::circulation
