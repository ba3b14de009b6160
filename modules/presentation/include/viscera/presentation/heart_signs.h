#pragma once

namespace viscera::presentation {

/// What is drawn of a beating heart's physiology below the view in lectures, and below the picture of a
/// movie. Pressures and loops are those of a circulation; the textbook's beat has the other three. A session
/// keeps the choice. What is chosen takes the room of what is not.
struct HeartSigns {
  /// Pressures of the left ventricle, the aorta and the left atrium over the beat, and the volume of the left
  /// ventricle.
  bool pressures = true;
  /// Pressure-volume loops of both ventricles.
  bool loops = true;
  bool ecg = true;    ///< The electrocardiogram.
  bool valves = true; ///< A bar for each valve while it is open.
  bool sounds = true; ///< The heart sounds.

  /// Whether a circulation has any of those that are chosen.
  bool anyOfCirculation() const { return pressures || loops || anyOfTextbook(); }
  /// Whether the textbook's beat has any of them.
  bool anyOfTextbook() const { return ecg || valves || sounds; }

  bool operator==(const HeartSigns&) const = default;
};

/// How much of the height of a lecture or of a movie the charts of a circulation take, and how much at most
/// the strip of a textbook's beat.
inline constexpr double kCirculationSignsPart = 0.36, kMostBeatSignsPart = 0.3;

} // namespace viscera::presentation
