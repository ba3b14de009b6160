#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viscera/core/progress.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/organs/sample_organ.h"
#include "viscera/session/command.h"
#include "viscera/session/organ_commands.h"
#include "viscera/session/rig_commands.h"

/// Files into commands. Reading touches no document, so a worker does it; the command is performed
/// afterwards.
namespace viscera::session {

/// What some files are worth.
struct OpenedFiles {
  Command command; ///< Adds every organ, and the rig when there was a handle file: one undo step.
  std::vector<std::string> warnings; ///< What a user should know, each with its file's name.
  int organs = 0;
  int handles = 0;
};

/// Whether the name ends like a handle file (.mrk.json).
bool isHandleFile(const std::filesystem::path& file);

/// Reads all files, surfaces and at most one handle file, or throws what the first that fails throws
/// (`NoInputError`, `DataError`, `UsageError` for an ending that nothing is known about or no file at all,
/// `Cancelled`).
OpenedFiles openFiles(const std::vector<std::filesystem::path>& files, Progress& progress);

/// Reads one surface as an organ, with its warnings.
Organ readOrgan(const std::filesystem::path& file);

/// A handle file's contents as a rig: one group a markup list; a handle that lists share (same label, same
/// place) is one handle in several groups. Throws `DataError` for a rig that nothing can be bound to: fewer
/// than four handles, all in one plane, two at one place.
NewRig rigFrom(const medical_io::HandleFile& file, const std::string& where);
/// The rig at rest as a handle file has it; handles without a group form the list "Handles".
medical_io::HandleFile handleFile(const Rig& rig);
/// The same of a rig that is not in a document.
medical_io::HandleFile handleFile(const NewRig& rig);

/// A sample organ's surfaces: the outer one, with the others as its cavities.
std::vector<NewOrgan> organsFrom(const organs::SampleOrgan& sample);

} // namespace viscera::session
