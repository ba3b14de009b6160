#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viscera/core/arrays.h"

/// Usual volume and place of adult organs, by which doubtful surfaces are found.
namespace viscera::medical_io {

/// The side of the body on which an organ lies.
enum class BodySide { right, middle, left };

/// The usual volume and side of an organ, found by its name. A heart is the whole organ with its blood, a
/// myocardium its muscle.
struct OrganNorm {
  std::string_view name;   ///< "kidney"
  std::string_view one;    ///< "a kidney", for sentences.
  std::string_view volume; ///< Its row in the table of `anatomy`; empty where fillings differ too much.
  BodySide side = BodySide::middle;
};

/// Finds the norm of an organ by its name: "Kidney_left 2" is a left kidney, "liver tumour" has no norm.
std::optional<OrganNorm> organNorm(std::string_view name);

/// "liver" of 239 ml: as a sentence, when its volume is less than half or more than twice what 19 of 20
/// adults have, or, where only averages are known, beyond three times those.
std::optional<std::string> doubtAboutVolume(std::string_view name, double volumeMl);

/// A unit in which a file may have been written.
struct LengthUnit {
  std::string_view id;   ///< "m", as in `viscera convert --unit`.
  std::string_view name; ///< "metres"
  double mm = 1;         ///< One of it.
};

/// mm, cm, m, in, um, and other units that occur in files. The first is mm.
const std::vector<LengthUnit>& lengthUnits();

/// Units, mm apart, in which the surface would have a size that is usual for the organ named (by its volume;
/// 0: it is open) or, if that is not conclusive or no unit fits, for any organ (by its box's diagonal). Empty
/// when mm do, or nothing does. Best first.
std::vector<LengthUnit> unitsThatFit(std::string_view name, double diagonalMm, double volumeMl);

/// "the size of 0.24 mm is implausible for an organ", if the size is implausible; else none.
std::optional<std::string> doubtAboutSize(std::string_view name, double diagonalMm);

} // namespace viscera::medical_io
