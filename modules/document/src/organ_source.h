#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/progress.h"
#include "viscera/document/organ.h"
#include "viscera/document/organ_commands.h"
#include "viscera/sample_organs/sample_organ.h"

/// Finds and reads the surfaces that a session file names but does not contain.
namespace viscera::document {

/// The SHA-256 of a file's bytes, in hexadecimal; empty when it cannot be read. Some 300 MB a second.
std::string sha256OfFile(const std::filesystem::path& file);

/// A surface file as a session remembers it.
struct FileSource {
  std::filesystem::path relative; ///< To the session file's folder.
  std::filesystem::path absolute;
  std::string hash;       ///< SHA-256 of its bytes; empty when it is not known.
  std::int64_t bytes = 0; ///< Its size.
};

/// A file, and whether it has the contents that were looked for.
struct FoundFile {
  std::filesystem::path file; ///< Absolute.
  bool same = false;
};

/// Looks for the file: relative to `folder`, where it was, in `folder` by its name, and then for any file of
/// the same contents in those folders; in the folders `alsoIn` by its name and by its contents, too. A file
/// of other contents counts only when the right ones are nowhere.
std::optional<FoundFile> findFile(const FileSource& source, const std::filesystem::path& folder,
                                  const std::vector<std::filesystem::path>& alsoIn = {});

/// The present file of an organ if its contents are unchanged since the organ was read; else empty.
std::optional<FileSource> unchangedFile(const Organ& organ, const std::filesystem::path& folder);

/// How a session names an organ's file, without reading it.
FileSource fileSource(const Organ& organ, const std::filesystem::path& folder);

/// Makes sample organs, each only once even if a session has several of their surfaces.
class SampleMaker {
public:
  explicit SampleMaker(const sample_organs::SampleLibrary& library) : library_(library) {}

  /// The surface of a sample ("heart@medium", "lv"). Throws what `sample_organs::sampleOrgan` throws, and
  /// `UsageError` for a surface that it does not have.
  Organ make(const std::string& sample, const std::string& surface, Progress& progress);

  /// The places that `make` would set, without making the organ; empty if they are not known.
  std::vector<geometry::NamedPlace> placesOf(const std::string& sample, const std::string& surface) const;
  /// The ways, in the same manner.
  std::vector<geometry::NamedWay> waysOf(const std::string& sample, const std::string& surface) const;

private:
  const sample_organs::SampleLibrary& library_;
  std::map<std::string, std::vector<NewOrgan>> made_;
};

} // namespace viscera::document
