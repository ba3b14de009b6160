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

/// When the electrocardiogram's waves are, s after the beginning of the ventricles' contraction: what the
/// excitation does then.
struct Excitation {
  double sinusNode = 0;       ///< P begins: the sinus node fires.
  double atriaDone = 0;       ///< P ends.
  double ventriclesBegin = 0; ///< Q begins.
  double ventriclesDone = 0;  ///< S ends.
};
Excitation excitationOf(const Parameters& parameters);

/// The same in the healthy beat whose times the heart's conduction system is given in, ms after the sinus
/// node has fired: the atria are done, the ventricles begin and are done.
inline constexpr double kAtriaDoneMs = 100, kVentriclesBeginMs = 160, kVentriclesDoneMs = 245;

/// How far the excitation is at `seconds` after the beginning of the ventricles' contraction: the time of
/// that healthy beat, ms, at which its excitation has come as far. From 0 when the sinus node fires to the
/// end of QRS the electrocardiogram's waves are the marks, with even progress between them: a longer
/// conduction stays longer in the atrioventricular node; where P reaches into QRS, the atria take four fifths
/// of the time to Q. Then it goes on until the node fires again. O(1).
double excitationMs(const Parameters& parameters, double seconds);

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
