#include "viscera/circulation/curves.h"

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
