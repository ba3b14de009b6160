#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/medical_io/assess_surface.h"
#include "viscera/medical_io/label_map.h"

/// Judges the organs of a patient together: whether left, right, front, back, head and feet are where LPS has
/// them, and whether all organs have the size of life. One organ says little of this, all of them much.
namespace viscera::medical_io {

/// The name, place and volume of an organ, for judging it together with others.
struct PlacedOrgan {
  std::string name;
  Bounds bounds;       ///< mm, in what is taken as LPS.
  double volumeMl = 0; ///< 0: not known, as of an open surface.
};

/// What the organs say of one direction of the body.
enum class Direction {
  unknown,
  kept,      ///< As in LPS.
  exchanged, ///< The other way round.
};

/// Pairs of organs whose order along a direction is the same in every body.
struct OrderVotes {
  int kept = 0;      ///< Those in the order of LPS.
  int exchanged = 0; ///< Those in the opposite order.
};

/// The judgement of a patient.
struct PatientAssessment {
  /// Right to left, front to back, foot to head.
  std::array<Direction, 3> directions = {};
  std::array<OrderVotes, 3> votes = {};
  int organs = 0; ///< The number of organs whose place in a body is known.
  /// Whether LPS explains the places of the organs about as well as anything else does. True for too few
  /// organs.
  bool fitsLps = true;
  /// How much worse LPS explains the places than the best other way does, or, where LPS fits, how much worse
  /// the best other way does than LPS: squared standard deviations. A statement needs `kClearMargin`.
  double margin = 0;
  double sizeFactor = 0; ///< Of life, by normal volumes: 0.1 for centimetres taken as mm; 0: not known.
  std::vector<Finding> findings; ///< Doubts about axes, sides and size, with repairs for all organs.
  /// The organs, as indices, on the other side of the body than their names say, where the others are right.
  std::vector<std::size_t> misplaced;

  /// Whether the sides of the body were checked and are those of LPS.
  bool sidesChecked() const { return directions[0] == Direction::kept; }
  /// Names them for JSON: "LPS" where all three directions are kept; "RAS", "mirrored", "RAS or mirrored",
  /// "head and feet exchanged" or "other" where LPS is excluded; else "undecided".
  std::string axes() const;
};

/// How much better, as a sum of squared standard deviations, one explanation has to be than another for a
/// statement.
inline constexpr double kClearMargin = 9;

/// Judges the organs whose names tell what they are (`anatomy::bodyPlaceNamed`). All 48 ways to lay a body's
/// axes along those of the file are compared by how well they bring the organs to their usual places, with
/// one factor of size and one shift for all; each organ counts with a bounded weight, so that a few wrong
/// names decide nothing. What every way that is nearly as good as the best agrees on is said, all else is
/// not: too few organs, and organs whose order is not the same in all people, give no finding. Mirror images
/// are told from situs inversus by organs whose names say the side.
///
/// O(n^2) for n organs: milliseconds for 200. Thread-safe.
PatientAssessment assessPatient(const std::vector<PlacedOrgan>& organs);

/// The segments of a map as organs to judge: the boxes of their voxels. O(segments).
std::vector<PlacedOrgan> placedOrgans(const LabelMap& map);

/// The finding of `assessPatient` about axes and sides, the first one; none when there is none.
std::optional<Finding> assessArrangement(const std::vector<PlacedOrgan>& organs);

} // namespace viscera::medical_io
