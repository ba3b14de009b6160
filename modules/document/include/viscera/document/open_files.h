#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/document/command.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_surfaces.h"
#include "viscera/medical_io/space.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/sample_organs/sample_organ.h"

/// Reads files of organs and handles, and makes the command that adds them to a document. Reading does not
/// access the document, so a worker does it; the command is performed afterwards.
namespace viscera::document {

/// A surface as it was read from its file, before an organ is made of it (which may turn its triangles
/// around).
struct ReadSurface {
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  std::optional<medical_io::Space> statedSpace; ///< None: the file does not say.
};

/// The organs and handles read from some files, not in a document yet: organs may still be repaired, or left
/// out.
struct OpenedFiles {
  Text name; ///< Of the undo step: "Open liver.stl".
  std::vector<NewOrgan> organs;
  std::map<std::size_t, ReadSurface> surfaces; ///< Of those `organs` that come from surface files.
  std::optional<Rig> rig;                      ///< When there was a handle file.
  std::shared_ptr<const ScanItem> scan;        ///< Of `openPatient`; not among what `command` adds.
  std::vector<Text> warnings;                  ///< What a user should know, each with its file's name.
  std::vector<Error> failures;                ///< Of files that could not be read, each with its file's name.
  std::vector<std::filesystem::path> leftOut; ///< Those files, in the same order.

  /// Adds every organ, and the rig: one undo step.
  Command command() const;
};

/// The handles for an organ that is new in a document: `organs` are all that it then has.
using PlaceHandles = std::function<Command(const Organ& organ, const OrganList& organs)>;

/// One command, and so one change, that brings the contents of files into a document. With `replacing` all
/// organs make room for those of the files, and the handles for theirs; without organs in the files nothing
/// makes room. Where the document is left without handles, `place` gives the first new organ some, when it
/// is applied.
Command openCommand(Text name, OpenedFiles files, bool replacing, PlaceHandles place);

/// An organ that is already read, of a file of which others are still being read.
struct ArrivingOrgan {
  std::string name;
  Vec3 color;                                         ///< The colour that it will have.
  std::shared_ptr<const geometry::TriangleMesh> mesh; ///< As it was read; never null.
  Bounds whole; ///< mm LPS: what the organs of its file will fill, as far as that is known.
};

/// Called with every organ as soon as its surface is read, before the others are: on any thread, never on two
/// at a time.
using ArrivingOrganListener = std::function<void(ArrivingOrgan)>;

/// How the caller treats session files: `alone` opens one in place of everything, `nowhere` cannot open them.
enum class Sessions { alone, nowhere };

/// Whether the name ends like a handle file (.mrk.json, .fcsv).
bool isHandleFile(const std::filesystem::path& file);

/// Reads all files: surfaces, label maps and folders of masks (an organ for each label), and the first handle
/// file. A file that cannot be read is left out and listed in `failures`, and so are further handle files and
/// sessions; when nothing is left, throws what the first of them throws (`NoInputError`, `DataError`,
/// `UsageError` for a session or an unknown extension). Throws `UsageError` for no file at all, `Cancelled`.
/// `arrives` is called with a copy of each surface. The error for sessions depends on whether the caller can
/// open them otherwise.
OpenedFiles openFiles(const std::vector<std::filesystem::path>& files, Progress& progress,
                      const ArrivingOrganListener& arrives = {}, Sessions sessions = Sessions::alone);

/// The same, and the first of the files that is a scan as `scan`. Each image file is read once, whether it is
/// a scan or a label map. With a scan, files that cannot be read are only listed in `failures`, whatever is
/// left. Of label maps over time the phase of that scan is opened, or of `present`, the scan that the
/// document has, where they have as many phases.
OpenedFiles openPatient(const std::vector<std::filesystem::path>& files, Progress& progress,
                        const ArrivingOrganListener& arrives = {}, Sessions sessions = Sessions::alone,
                        std::shared_ptr<const ScanItem> present = nullptr);

/// Reads a label map or a folder of masks, and makes an organ, named and coloured, of each of the labels that
/// are asked for by name or value; of all when none are. A heart that is labelled part by part
/// (`medical_io::heartLabels`) is then "Heart", muscle and chambers together, first, with the chambers "LV",
/// "RV", "LA", "RA" as its cavities; by "heart" it may be asked for, too. Throws what
/// `medical_io::readLabelMap`, `medical_io::segmentsNamed` and `medical_io::labelSurfaces` throw.
std::vector<NewOrgan> readLabelBatch(const std::filesystem::path& file,
                                     const std::vector<std::string>& labels, Progress& progress,
                                     const ArrivingOrganListener& arrives = {});
/// The same of a map that was read from `file`.
std::vector<NewOrgan> labelBatch(medical_io::LabelMap map, const std::filesystem::path& file,
                                 const std::vector<std::string>& labels, Progress& progress,
                                 const ArrivingOrganListener& arrives = {});
/// The same without parents of cavities.
std::vector<Organ> readLabelOrgans(const std::filesystem::path& file, const std::vector<std::string>& labels,
                                   Progress& progress, const ArrivingOrganListener& arrives = {});

/// Organs of surfaces that were made from a label map, which was read from `file`. The first has the warnings
/// of the map as a whole.
std::vector<Organ> organsFrom(const medical_io::LabelMap& map, std::vector<medical_io::LabelSurface> surfaces,
                              const std::filesystem::path& file);

/// Reads the one organ of a surface file, with its warnings. Throws as `medical_io::readSurface`.
Organ readOrgan(const std::filesystem::path& file,
                medical_io::SeveralOrgans several = medical_io::SeveralOrgans::refuse);

/// Reads all organs of a surface file, or the one that is named or numbered as for `medical_io::partNamed`.
/// Throws as `medical_io::readSurfaces` and `medical_io::partNamed`.
std::vector<NewOrgan> readOrgans(const std::filesystem::path& file, const std::string& part = {});

/// A handle file's contents as a rig: one group a markup list; a handle that lists share (same label, same
/// place) is one handle in several groups. Throws `DataError` for a rig that nothing can be bound to: fewer
/// than four handles, all in one plane, two at one place.
Rig rigFrom(const medical_io::HandleFile& file, const std::string& where);
/// The rig at rest as the contents of a handle file; handles without a group form the list "Handles". A rig
/// of no document is `completed` first.
medical_io::HandleFile handleFile(const Rig& rig);

/// One surface of a sample organ, painted as the sample is.
Organ organFrom(const sample_organs::SampleSurface& surface, std::string name);

/// A sample organ's surfaces: the outer one, with the others as its cavities.
std::vector<NewOrgan> organsFrom(const sample_organs::SampleOrgan& sample);

} // namespace viscera::document
