#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "viscera/anatomy/norms.h"
#include "viscera/core/arrays.h"

/// The parts of a body: what a name says they are, and what is known of each. No other module decides by a
/// name what an organ is. O(1) after the first call, unless something else is said; thread-safe.
namespace viscera::anatomy {

/// The side of the patient, or the side of the heart.
enum class Side { none, right, left };

enum class Chamber { none, ventricle, atrium };

/// How much of an organ a part is.
enum class Extent {
  whole,  ///< The organ or the chamber itself: its normal ranges apply.
  piece,  ///< A piece of it, such as a lobe or a wall: in its colour, but of another size.
  lesion, ///< Something in it, such as a tumour or a cyst: neither its colour nor its size.
};

/// A part of the body. Ordered by the name of the organ, so that parts can be keys.
struct Part {
  std::string_view organ; ///< The id of its row in the table of organs: "kidney".
  Side side = Side::none;
  Chamber chamber = Chamber::none; ///< Only in the heart: the cavity of a chamber, or its muscle.
  Extent extent = Extent::whole;

  friend auto operator<=>(const Part&, const Part&) = default;
};

inline constexpr Part kHeart{"heart"};
inline constexpr Part kLeftVentricle{"heart", Side::left, Chamber::ventricle};
inline constexpr Part kRightVentricle{"heart", Side::right, Chamber::ventricle};
inline constexpr Part kLeftAtrium{"heart", Side::left, Chamber::atrium};
inline constexpr Part kRightAtrium{"heart", Side::right, Chamber::atrium};

/// Finds the part of the body that a name contains, in English, German, French, Spanish, Catalan or Latin,
/// and as TotalSegmentator, 3D Slicer and atlases write it: "Model_51_right_kidney", "Niere links.stl",
/// "patient1_LV_ENDOCARDIAL". Case, accents, separators, numbers and unknown words do not matter. Only whole
/// words count, and the longest phrase counts first. Of organ and vessel, nerve, muscle or bone, the name
/// means the latter ("renal artery"). None for a name without an organ, for one that denies it ("no liver",
/// "liver phantom"), and for one with several organs ("liver and spleen"). O(length), microseconds.
///
///     const std::optional<Part> part = partNamed("lung_upper_lobe_left");
///     const bool wholeLung = part == Part{"lung", Side::left}; // No: it is a piece.
std::optional<Part> partNamed(std::string_view name);

/// Finds the chamber of the heart whose cavity a name means: "LV", "left atrium of heart". None for all else,
/// walls and muscle too.
std::optional<Part> chamberNamed(std::string_view name);

/// The key of that chamber in JSON and in Python, one for all names of it: "lv", "rv", "la" or "ra"; empty
/// for all else.
std::string chamberKey(std::string_view name);

/// The chambers among surfaces' names by their keys, each with the place of the first name that means it;
/// without those whose key is itself one of the names.
std::vector<std::pair<std::string, std::size_t>> chamberKeys(const std::vector<std::string>& names);

/// The colour of the part that a name means, red, green and blue from 0 to 1. Of several organs, the first
/// one's; of "tumour" without an organ, that of a lesion. None for other names.
std::optional<Vec3> colorNamed(std::string_view name);

/// The colour of a part: of its chamber, of a lesion, else of its organ.
Vec3 colorOf(const Part& part);

/// "Left kidney", "Right ventricle", "Liver": in English, as translations know it. A piece and a lesion have
/// the title of their organ.
std::string titleOf(const Part& part);

/// The name of a file's organ as people write it, in English, as translations know it: "Left kidney" for
/// "kidney_left", "Left rib 7" for "rib_left_7", "Upper lobe of the left lung" for "lung_upper_lobe_left",
/// "Right ventricle (patient1)" for "patient1_RV_ENDOCARDIAL". Other names with a capital letter and spaces
/// ("small_vein_2" is "Small vein 2"). O(length).
std::string readableName(std::string_view name);

/// "LV", "RV", "LA" or "RA"; empty for a part that is no cavity of a chamber.
std::string_view abbreviationOf(const Part& part);

/// The side of the body on which a whole organ lies; none where it lies in the middle or on either side.
Side bodySideOf(const Part& part);

/// Whether images of a part of the body, as most are, seldom hold the whole of it: vessels, nerves, bones,
/// muscles, skin and fat, the gullet and the airways. Pieces and lesions are as their organ.
bool isSeldomWhole(const Part& part);

/// The normal range of the volume of a whole organ; null where none is known. A kidney without a side has
/// that of the left one.
const Norm* volumeNormOf(const Part& part);

} // namespace viscera::anatomy
