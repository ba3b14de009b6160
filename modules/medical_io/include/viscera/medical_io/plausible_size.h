#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"

/// Whether a surface has the size of an organ, by which files in another unit are found.
namespace viscera::medical_io {

/// "liver" of 239 ml: as a sentence, when its volume is less than half or more than twice what 19 of 20
/// adults have, or, where only averages are known, beyond three times those.
std::optional<Text> doubtAboutVolume(std::string_view name, double volumeMl);

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
std::optional<Text> doubtAboutSize(std::string_view name, double diagonalMm);

/// The factor by which an organ of that name and volume becomes as large as people's organs are in the
/// middle; also for one whose volume depends on what it holds. None without a known volume, and for no
/// volume.
std::optional<double> lifeSizeFactor(std::string_view name, double volumeMl);

} // namespace viscera::medical_io
