#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "viscera/document/key_sequence.h"
#include "viscera/live/cine_motion.h"
#include "viscera/tracking/cine_correction.h"

namespace viscera {
class JsonReader;
}

/// Contours that a user corrected, on their way from files and windows into the fit of a motion.
namespace viscera::live {

/// The same correction with its slice, series and surface set. Throws `UsageError` for a phase that the study
/// has not, for one with labels, which are exact, for a surface, slice or series that it has not, and for
/// points that are none, not finite, or more than 1 mm from the plane of the slice that is named, or of
/// every slice where none is.
ContourCorrection resolved(const LabelledStudy& study, const ContourCorrection& correction);

/// Corrections as `tracking::CineFitter` takes them. Throws what `resolved` throws.
std::vector<tracking::CorrectedContour> correctedContours(const LabelledStudy& study,
                                                          const std::vector<ContourCorrection>& corrections);

/// A list with one more correction. It joins the one of the same phase, slice and surface, of which points
/// within 3 mm of `covered` (`k x 3` mm: the contour as it was where it is corrected anew) are dropped.
std::vector<ContourCorrection> withCorrection(std::vector<ContourCorrection> corrections,
                                              const ContourCorrection& added, const Points& covered);

/// A correction as a document keeps it, and back. It has to be `resolved`.
document::CorrectedContour stored(const ContourCorrection& correction);
ContourCorrection restored(const document::CorrectedContour& correction);

/// The phases in which two motions of one tracker have different poses.
std::vector<std::size_t> phasesThatDiffer(const CineMotion& a, const CineMotion& b);

/// Corrections as JSON: a list of objects with `phase`, `slice` or `series` or neither, `surface` (may be
/// left out) and `pointsMm`.
nlohmann::ordered_json toJson(const std::vector<ContourCorrection>& corrections);
/// Reads the list `corrections` of an object; none where it has no such list. Throws `JsonError`.
std::vector<ContourCorrection> correctionsFrom(const JsonReader& reader, const nlohmann::ordered_json& object,
                                               const std::string& place);

/// Reads a file `{"corrections": [...]}`, as `viscera track --correct` takes it. Throws `NoInputError`,
/// `JsonError`.
std::vector<ContourCorrection> readCorrections(const std::filesystem::path& file);

} // namespace viscera::live
