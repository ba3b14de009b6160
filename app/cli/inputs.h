#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/document/document.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/sample_organs/sample_organ.h"

/// Reads the organs and handles that a command names in its arguments.
namespace viscera::app::cli {

/// The parts of a reference to a sample organ, such as "sample:heart/lv@high".
struct SampleReference {
  std::string organ;   ///< "heart"
  std::string surface; ///< "lv"; empty: the outer one.
  sample_organs::Resolution resolution = sample_organs::Resolution::medium;
};

/// Takes `[sample:]NAME[/SURFACE][@RESOLUTION]` apart. Throws `UsageError` for an empty name or a resolution
/// that there is not.
SampleReference sampleReference(const std::string& text);

/// Whether ORGAN names a sample organ ("sample:...") and not a file.
bool isSample(const std::string& organ);

/// Whether ORGAN names one label of a label map ("abdomen.nrrd/liver").
bool namesLabel(const std::string& organ);

/// The organ of a surface file that ORGAN names behind a slash ("organs.obj/Liver"); nothing for a file
/// alone. Throws as `medical_io::readSurfacePart`.
std::optional<medical_io::SurfacePart> surfacePartInput(const std::string& organ);

/// The parts of a reference to an organ of a session, such as "patient.viscera/Liver".
struct SessionReference {
  std::filesystem::path session;
  std::string organ; ///< Its name, or its number in the session's list, from 1.
};

/// Parses `SESSION.viscera/ORGAN`; empty for other texts and for a session that does not exist.
std::optional<SessionReference> sessionReference(const std::string& text);

/// Reads the file, or makes the sample organ, that ORGAN names; of a sample organ with cavities the outer
/// surface unless another one is named; of a label map the label that is named behind a slash
/// ("abdomen.nrrd/liver"), which may be left out when there is only one, and so of a surface file the organ
/// ("organs.obj/Liver"); of a session the organ that is named behind a slash ("patient.viscera/Liver"). The
/// mesh has a size, else `DataError`; throws also what `document::readOrgan` and `sample_organs::sampleOrgan`
/// throw, and `UsageError` for a surface that the sample does not have.
document::Organ organInput(const std::string& organ, const sample_organs::SampleLibrary& samples,
                           Progress& progress);

/// The same with all surfaces of a sample organ or of a file, and all labels of a label map, when none is
/// named.
std::vector<document::Organ> organInputs(const std::string& organ,
                                         const sample_organs::SampleLibrary& samples, Progress& progress);

/// The organs of a label map that was read from the file ORGAN. Throws as above.
std::vector<document::Organ> organInputs(medical_io::LabelMap map, const std::string& organ,
                                         Progress& progress);

/// All organs of the file or session that the argument ORGAN refers to, each cavity with its organ.
struct OrgansAround {
  document::OrganList organs;
  std::string name; ///< Behind the slash; empty for a whole file.
};

/// Reads all organs of the file or session that the argument ORGAN refers to. Of a file that cannot be read,
/// and of a sample organ, none: `organInput` says why.
OrgansAround organsAround(const std::string& organ, const sample_organs::SampleLibrary& samples,
                          Progress& progress);

/// Reads a handle file as rest handles. Throws `NoInputError`, and `DataError` also for handles that nothing
/// can be bound to: fewer than four, all in one plane, two at one place. Where `cage` names a surface file,
/// the handles at its vertices get its triangles; throws as `document::readCage` and `coordinates::cageOver`.
document::Rig rigInput(const std::filesystem::path& file, std::vector<Text>& warnings,
                       const std::filesystem::path& cage = {});

/// Reads a handle file as points that are only drawn, such as landmarks: any number of them, anywhere. Throws
/// `NoInputError`, and `DataError` for what is no handle file.
document::Rig drawnHandles(const std::filesystem::path& file, std::vector<Text>& warnings);

/// The row of the handle with that label. Throws `UsageError` that lists some existing labels.
int rowOfHandle(const document::Rig& rig, const std::string& label);

/// Reads a handle file as a pose of `rest`, `n x 3` mm: handles are matched by label, those that the file
/// does not have stay at rest. Throws `DataError` for a label that the rest handles do not have or that comes
/// twice.
Points poseInput(const std::filesystem::path& file, const document::Rig& rest, std::vector<Text>& warnings);

} // namespace viscera::app::cli
