#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "session_json.h"
#include "viscera/document/scan_item.h"
#include "viscera/document/session_file.h"

/// Reads and writes the scan of a session file, which names or contains it (docs/session_format.md, "scan").
namespace viscera::document {

/// The place of a scan, also relative to the session file's `folder`; with its samples when it shall be
/// `inside`, and in any case when it is in no file (any more). Throws `CannotCreateError` for samples of more
/// than 1 GB.
nlohmann::ordered_json sessionScanJson(const ScanItem& item, bool inside,
                                       const std::filesystem::path& folder);

/// The place of a scan or study of a session: relative to the session file in `folder`, where it was, beside
/// the session file, in the folders `alsoIn`, which may be its own: the first that is there.
std::optional<std::filesystem::path> findImage(const std::filesystem::path& relative,
                                               const std::filesystem::path& absolute,
                                               const std::filesystem::path& folder,
                                               const std::vector<std::filesystem::path>& alsoIn);

/// Adds to the record of a scan or study the archive that its images came from, where they did.
void addArchiveOrigin(nlohmann::ordered_json& record, const std::filesystem::path& place);

/// What to say of images that are gone: that the record's archive has them, `otherwise` without one.
Text lostImages(const nlohmann::ordered_json& record, const Text& otherwise);

/// Removes the folders from the paths in a scan's record, so that only the name of its file or folder stays.
void forgetFolders(nlohmann::ordered_json& scan);

/// Reads the scan that `item` holds or names into `opened`; it is looked for in `alsoIn`, too. One that is
/// not there, or cannot be read, becomes a warning and stays as `missingScan`. Throws `DataError` for a
/// record that is none, `Cancelled`.
void readSessionScan(SessionReader& reader, const nlohmann::ordered_json& item,
                     const std::filesystem::path& folder, const std::vector<std::filesystem::path>& alsoIn,
                     OpenedSession& opened, Progress& progress);

} // namespace viscera::document
