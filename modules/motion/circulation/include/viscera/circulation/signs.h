#pragma once

#include <string>
#include <vector>

#include "viscera/circulation/beat.h"
#include "viscera/circulation/indices.h"
#include "viscera/circulation/parameters.h"

namespace viscera::circulation {

/// The electrocardiogram (about lead II) at `seconds` after the beginning of the ventricles' contraction, mV;
/// periodic. A sum of Gaussians for P, Q, R, S and T after McSharry and others 2003,
/// doi 10.1109/TBME.2003.808805, but in time and not in phase: P lies where the atria begin to contract, QRS
/// before the ventricles do, T before the end of systole. Schematic: it shows the timing of events, not the
/// shape in disease. O(1).
double electrocardiogram(const Parameters& parameters, double seconds);

/// A heart sound: when it is heard, how loud it is and its frequency.
struct HeartSound {
  std::string name;     ///< "S1 mitral", "S1 tricuspid", "S2 aortic", "S2 pulmonic", "S3", "S4"
  double seconds = 0;   ///< When it begins.
  double loudness = 0;  ///< 1: the first sound at rest.
  double frequency = 0; ///< Hz
  double fading = 0;    ///< Time constant, s.
};

/// The sounds of a beat, in the order of their names. S1 and S2 come with the shutting of their valves,
/// louder the faster the pressure rises or the higher it stands; S3 and S4 occur when rapid filling, or the
/// atrium's contraction, raises the left ventricle's pressure unusually fast, as in a failing, an overfilled
/// or a stiff heart.
std::vector<HeartSound> heartSounds(const Parameters& parameters, const Beat& beat, const Indices& indices);

/// The phonocardiogram at the beat's samples, without unit: the sounds as oscillations that fade, and murmurs
/// where blood passes a valve at more than 2 m/s. Deterministic.
std::vector<double> phonocardiogram(const Parameters& parameters, const Beat& beat, const Indices& indices);

} // namespace viscera::circulation
