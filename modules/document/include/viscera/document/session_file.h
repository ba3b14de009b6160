#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/document/document.h"
#include "viscera/medical_io/archive_origin.h"
#include "viscera/sample_organs/sample_organ.h"

/// Reads and writes session files (`.viscera`, docs/session_format.md), which hold everything that is needed
/// to restore the same picture and the same numbers.
namespace viscera::document {

/// The extension of session files.
inline constexpr const char* kSessionEnding = ".viscera";

/// An organ of a session whose surface was not found when the session was opened. It is not in the document,
/// but saving writes it again unchanged, so that it can be opened when its file is found.
struct MissingOrgan {
  std::string name;
  nlohmann::ordered_json record; ///< As in the file.
  std::size_t place = 0;         ///< Among the organs of the session.
  OrganId id;                    ///< As `parent` of organs in `children`.
  std::vector<OrganId> children; ///< Organs of the document that are its cavities.
};

/// The contents of a session file: document, view and missing organs.
struct SessionContents {
  DocumentState state;
  /// What the window shows, an object of its own (`presentation::toJson`); kept as it is.
  nlohmann::ordered_json view = nlohmann::ordered_json::object();
  /// Whether all surfaces are inside the file. Else those that can be read or made again are named only; a
  /// surface that was edited, or whose file is not what was read, is inside in any case.
  bool embedSurfaces = false;
  /// Whether the scan's samples are inside, too. One that is in no file (any more) is inside in any case.
  bool embedScan = false;
  std::vector<MissingOrgan> missing;
  /// The record of a scan that was not found: written again as it was unless `state` has another scan. Else
  /// null.
  nlohmann::ordered_json missingScan = {};
  /// The same of a cine study.
  nlohmann::ordered_json missingStudy = {};
  /// The session file that these contents belong to, when they are a recovery file's; empty else.
  std::filesystem::path recovers;
};

/// The source of an organ's surface when a session was opened.
struct SurfaceFinding {
  enum class State {
    embedded, ///< It is inside the session file.
    found,    ///< Its file, or its sample organ, is unchanged.
    moved,    ///< The same file, in another place.
    changed,  ///< Another surface than the one that was saved is there now, and is used.
    missing   ///< No readable file was found; the organ was left out.
  };
  std::string organ;  ///< Its name.
  std::string source; ///< The file as found (or as it was), "sample:heart/lv@medium", or empty.
  State state = State::found;
};

/// "embedded", "found", "moved", "changed", "missing".
std::string nameOf(SurfaceFinding::State state);

/// The result of reading a session: its contents and where each surface was found.
struct OpenedSession {
  SessionContents contents;
  std::vector<SurfaceFinding> surfaces; ///< One for each organ, in the order of the file.
  std::vector<Text> warnings;           ///< What a user should know: missing, changed and moved files,
                                        ///< keys of the file that nothing is known about.
};

/// The archive that has the images of a `missingScan` or `missingStudy`; none where they came from none.
std::optional<medical_io::ArchiveOrigin> archiveOriginOf(const nlohmann::ordered_json& record);

/// Whether the name ends like a session file (.viscera).
bool isSessionFile(const std::filesystem::path& file);

/// Reads a session. An organ's file is looked for where it was relative to the session file, where it was,
/// beside the session file, and by its contents in those folders; sample organs are made again (seconds, the
/// first time); the scan is read anew where it is not inside. Organs' files and the scan are looked for in
/// the folders `alsoIn`, too. What cannot be found is left out and named, the rest is opened. Throws
/// `NoInputError` when the session file cannot be read; `DataError` that names file, place and reason for one
/// that is damaged, no session, or of a later version; `Cancelled`. For any thread.
OpenedSession readSession(const std::filesystem::path& file, const sample_organs::SampleLibrary& samples,
                          Progress& progress, const std::vector<std::filesystem::path>& alsoIn = {});

/// Writes a session; reading it back gives the same document to the last bit, and writing that again the same
/// bytes. Atomic: what was there before stays until the new file is complete on the disk. Reads the organs'
/// files to check that they are unchanged. Throws `CannotCreateError` (also for a name that does not end in
/// .viscera), `DataError` for a state that is not valid (validate.h), `Cancelled`. For any thread.
void writeSession(const std::filesystem::path& file, const SessionContents& contents, Progress& progress);

} // namespace viscera::document
