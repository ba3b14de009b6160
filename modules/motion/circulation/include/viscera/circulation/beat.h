#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace viscera::circulation {

/// The compartments that hold blood (four chambers, arteries and veins), in the order of all arrays.
enum class Compartment { lv, rv, la, ra, systemicArteries, systemicVeins, pulmonaryArteries, pulmonaryVeins };
inline constexpr std::size_t kCompartments = 8;
inline constexpr std::size_t kChambers = 4; ///< The first of them.

/// The four valves, in the order in which arrays hold them.
enum class Valve { mitral, aortic, tricuspid, pulmonic };
inline constexpr std::size_t kValves = 4;

/// The state of the whole circulation at one instant: 8 volumes (ml), 4 flows through valves (ml/s), 4
/// openings of valves (0 to 1), in the orders above.
inline constexpr std::size_t kStateSize = kCompartments + 2 * kValves;
using State = std::array<double, kStateSize>;

/// Pressures, volumes, flows and valve openings over one beat, sampled at even steps from the beginning of
/// the ventricles' contraction to the same instant a beat later, both included. All vectors are equally long.
struct Beat {
  double period = 0;        ///< s
  std::vector<double> time; ///< s, 0 to `period`.
  /// Mean activation of the chambers, 0 to 1.
  std::array<std::vector<double>, kChambers> activation;
  std::array<std::vector<double>, kCompartments> volume; ///< ml (of vessels: the stressed part)
  /// mmHg; of the arteries: at their root, behind the valve.
  std::array<std::vector<double>, kCompartments> pressure;
  std::array<std::vector<double>, kChambers> pressureRate; ///< mmHg/s
  std::vector<double> pericardium;                         ///< mmHg
  std::array<std::vector<double>, kValves> flow;           ///< ml/s, forward positive.
  std::array<std::vector<double>, kValves> open;           ///< 0 shut, 1 open.
  std::vector<double> systemicFlow;                        ///< From arteries to veins, ml/s.
  std::vector<double> pulmonaryFlow;                       ///< The same of the lungs.
  std::array<double, kChambers> work{}; ///< Done by the wall on the blood over the beat, J.
  double dissipated = 0;                ///< What valves and vessels turn into heat over the beat, J.

  const std::vector<double>& volumeOf(Compartment c) const { return volume[static_cast<std::size_t>(c)]; }
  const std::vector<double>& pressureOf(Compartment c) const { return pressure[static_cast<std::size_t>(c)]; }
  const std::vector<double>& flowOf(Valve v) const { return flow[static_cast<std::size_t>(v)]; }
  const std::vector<double>& openOf(Valve v) const { return open[static_cast<std::size_t>(v)]; }
};

} // namespace viscera::circulation
