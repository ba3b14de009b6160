#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// The table of organs: one row for each, with all that the program knows of it.
namespace viscera::anatomy {

/// Where an organ lies in the body.
enum class Place {
  anywhere, ///< There are many of its kind, such as vessels and muscles.
  middle,
  right,
  left,
  eitherSide, ///< There are two, each on the side that its name says.
};

/// One row of the table of organs.
struct OrganFacts {
  std::string_view id = {};     ///< "kidney"
  std::string_view title = {};  ///< "Kidney"
  std::string_view system = {}; ///< One of `organSystems`.
  Place place = Place::middle;
  /// Where a name has several organs, the one of the highest rank is meant: an artery is named after the
  /// organ that it serves.
  int rank = 1;
  std::array<std::uint8_t, 3> color = {}; ///< Red, green, blue.
  std::string_view snomed = {};           ///< Its SNOMED CT concept; empty where none is in the table.
  std::string_view volume =
      {}; ///< Its row in the table of normal ranges, of the left one where there are two.
  std::string_view volumeOfRight = volume; ///< The row of the right one.
  bool rigid = false;                      ///< It keeps its shape among tissue that bends: a bone.
  bool still = false;                      ///< It keeps its place while the body breathes: spine and pelvis.
  bool fills = false;                      ///< Its volume depends on what it holds, more than on the person.
  /// Names in small letters, separated by "|". "*": any end of a word; "#": a number. A phrase that begins
  /// with "~" means a piece of the organ; one with "!" counts only where no unknown word is beside it,
  /// because it means something else in another language.
  std::string_view words = {};
};

/// All rows. O(1) after the first call; thread-safe.
const std::vector<OrganFacts>& organs();

/// The row of that id. Throws `UsageError` when there is none. O(rows).
const OrganFacts& organ(std::string_view id);

/// The systems of the body in the order of a list: "Heart", "Arteries", "Veins", ..., "Other".
const std::vector<std::string>& organSystems();

/// The system of the organ that a name means (`partNamed`; of several organs, of the first), else the last
/// one of `organSystems`. O(length).
const std::string& systemNamed(std::string_view name);

/// Whether a name means a bone, or a piece of one: not cartilage, and no organ that a bone is named beside.
/// O(length).
bool isBoneNamed(std::string_view name);

/// Whether a name means an organ, or a piece of one, that keeps its place while the body breathes. O(length).
bool isStillNamed(std::string_view name);

} // namespace viscera::anatomy
