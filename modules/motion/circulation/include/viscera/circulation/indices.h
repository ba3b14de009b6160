#pragma once

#include <array>
#include <optional>

#include "viscera/circulation/beat.h"
#include "viscera/circulation/parameters.h"
#include "viscera/circulation/valve_state.h"

namespace viscera::circulation {

/// Volumes, pressures and derived numbers of one chamber over a beat.
struct ChamberIndices {
  double edvMl = 0; ///< The largest volume.
  double esvMl = 0; ///< The smallest.
  double svMl = 0;  ///< Their difference: of a leaking ventricle forward and backward together.
  double ef = 0;    ///< svMl / edvMl
  /// Pressure of a ventricle when it begins to contract, of an atrium when it is fullest.
  double edpMmHg = 0;
  double meanMmHg = 0;
  double highestMmHg = 0;
  double dpdtMax = 0;             ///< mmHg/s
  double strokeWorkJ = 0;         ///< The area of the pressure-volume loop.
  double strokeWorkByEnergyJ = 0; ///< The work integrated with the equations; the same to 1e-6.
};

struct ArteryIndices {
  double systolic = 0; ///< mmHg, as the other two.
  double diastolic = 0;
  double mean = 0;
};

/// The numbers computed from a beat: pressures, volumes, cardiac output, valve times.
struct Indices {
  std::array<ChamberIndices, kChambers> chambers; ///< In the order of `Compartment`.
  ArteryIndices aorta, pulmonaryArtery;
  double forwardStrokeMl = 0;           ///< Net volume that a beat ejects into the aorta.
  double cardiacOutputLMin = 0;         ///< The same each minute, l.
  double mitralRegurgitationMl = 0;     ///< Backward volume of a beat while the left ventricle contracts.
  double aorticRegurgitationMl = 0;     ///< Backward volume of a beat through the aortic valve.
  double mitralRegurgitantFraction = 0; ///< Of the left ventricle's stroke volume.
  double aorticMeanGradient = 0;        ///< mmHg, while blood flows forward through the open valve.
  double aorticPeakGradient = 0;
  double mitralMeanGradient = 0;
  /// Time from the shutting of the mitral to the opening of the aortic valve, and from the shutting of the
  /// aortic to the opening of the mitral valve; 0 where the other valve opens first.
  double isovolumicContractionSeconds = 0;
  double isovolumicRelaxationSeconds = 0;
  double ejectionSeconds = 0; ///< How long the aortic valve is open.
  double relaxationSeconds =
      0; ///< Time constant with which the left ventricle's pressure falls between the valves.
  double arterialElastance = 0; ///< Ea, mmHg/ml: end-systolic pressure by stroke volume (Sunagawa; Kelly and
                                ///< others 1992, doi 10.1161/01.CIR.86.2.513).
  double couplingRatio = 0;     ///< Ea / Ees
  /// The times between which each valve is shut for longest; empty for one that never opens or never shuts.
  std::array<std::optional<ValveTimes>, kValves> valves;

  const ChamberIndices& of(Compartment c) const { return chambers[static_cast<std::size_t>(c)]; }
};

/// Computes these numbers from a beat and the parameters that it was solved with. Extremes are those of
/// parabolas through three samples. O(samples).
Indices indicesOf(const Parameters& parameters, const Beat& beat);

/// The pressure of the end-systolic (e = 1) and of the relaxed chamber (e = 0) at a volume, mmHg above the
/// pericardium's: the two relations between which a pressure-volume loop lies.
double endSystolicPressure(const Chamber& chamber, double volumeMl);
double relaxedPressure(const Chamber& chamber, double volumeMl);

} // namespace viscera::circulation
