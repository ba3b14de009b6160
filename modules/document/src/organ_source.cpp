#include "organ_source.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <system_error>
#include <vector>

#include "sha256.h"
#include "viscera/core/error.h"
#include "viscera/core/file_facts.h"
#include "viscera/core/phrase.h"
#include "viscera/document/open_files.h"

namespace viscera::document {
namespace {

namespace fs = std::filesystem;

/// More files in a folder than this are not looked through.
constexpr int kMostFiles = 10000;
constexpr std::size_t kFileBytesAtOnce = std::size_t{1} << 18U; ///< Bytes.

bool isThere(const fs::path& file) {
  std::error_code error;
  return !file.empty() && fs::is_regular_file(file, error);
}

std::int64_t sizeOf(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  return error ? -1 : static_cast<std::int64_t>(size);
}

bool hasContents(const fs::path& file, const FileSource& source) {
  return !source.hash.empty() && sizeOf(file) == source.bytes && sha256OfFile(file) == source.hash;
}

/// Any file with these contents in a folder, by name the first.
std::optional<fs::path> sameInFolder(const fs::path& folder, const FileSource& source) {
  std::error_code error;
  std::set<fs::path> candidates;
  int seen = 0;
  for (fs::directory_iterator item(folder, error), end; !error && item != end && seen < kMostFiles;
       item.increment(error), ++seen)
    if (isThere(item->path()) && sizeOf(item->path()) == source.bytes)
      candidates.insert(item->path());
  for (const fs::path& candidate : candidates)
    if (hasContents(candidate, source))
      return candidate;
  return std::nullopt;
}

fs::path absoluteOf(const fs::path& file) {
  return absolutePath(file).lexically_normal();
}

} // namespace

std::string sha256OfFile(const std::filesystem::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    return {};
  std::ifstream source(file, std::ios::binary);
  if (!source)
    return {};
  Sha256 hash;
  std::vector<char> block(kFileBytesAtOnce);
  do {
    source.read(block.data(), static_cast<std::streamsize>(block.size()));
    hash.add({block.data(), static_cast<std::size_t>(source.gcount())});
  } while (source);
  return source.eof() ? hash.hex() : std::string();
}

std::optional<FoundFile> findFile(const FileSource& source, const fs::path& folder,
                                  const std::vector<fs::path>& alsoIn) {
  std::vector<fs::path> places;
  if (!source.relative.empty())
    places.push_back(absoluteOf(folder / source.relative));
  if (!source.absolute.empty()) {
    if (source.absolute.is_absolute()) // An embedded session has the name alone: never a place to look from.
      places.push_back(source.absolute);
    places.push_back(absoluteOf(folder / source.absolute.filename()));
  }
  const fs::path& named = source.absolute.empty() ? source.relative : source.absolute;
  for (const fs::path& also : alsoIn)
    places.push_back(absoluteOf(also / named.filename()));
  std::vector<fs::path> there;
  std::copy_if(places.begin(), places.end(), std::back_inserter(there), isThere);
  for (const fs::path& place : there)
    if (hasContents(place, source))
      return FoundFile{place, true};
  std::set<fs::path> searched;
  for (const fs::path& place : places) {
    if (source.hash.empty() || !searched.insert(place.parent_path()).second)
      continue;
    if (const auto same = sameInFolder(place.parent_path(), source))
      return FoundFile{*same, true};
  }
  if (there.empty())
    return std::nullopt;
  return FoundFile{there.front(), source.hash.empty()};
}

FileSource fileSource(const Organ& organ, const fs::path& folder) {
  FileSource source;
  source.absolute = absoluteOf(organ.file);
  source.relative = source.absolute.lexically_relative(absoluteOf(folder));
  source.hash = organ.origin.fileHash;
  source.bytes = std::max<std::int64_t>(sizeOf(source.absolute), 0);
  return source;
}

std::optional<FileSource> unchangedFile(const Organ& organ, const fs::path& folder) {
  if (organ.file.empty() || organ.origin.fileHash.empty())
    return std::nullopt;
  FileSource source = fileSource(organ, folder);
  if (!hasContents(source.absolute, source))
    return std::nullopt;
  return source;
}

Organ SampleMaker::make(const std::string& sample, const std::string& surface, Progress& progress) {
  auto made = made_.find(sample);
  if (made == made_.end()) {
    const std::size_t at = std::min(sample.rfind('@'), sample.size());
    const auto resolution = at == sample.size() ? sample_organs::Resolution::medium
                                                : sample_organs::resolutionFromName(sample.substr(at + 1));
    const auto organ = sample_organs::sampleOrgan(library_, sample.substr(0, at), resolution, progress);
    made = made_.emplace(sample, organsFrom(organ)).first;
  }
  for (const NewOrgan& organ : made->second)
    if (organ.organ.origin.surface == surface)
      return organ.organ;
  throw UsageError(phrase("It has no surface \"%1\"", surface), "sample:" + sample);
}

std::vector<geometry::NamedPlace> SampleMaker::placesOf(const std::string& sample,
                                                        const std::string& surface) const {
  try {
    return sample_organs::namedPlaces(library_, sample.substr(0, sample.find('@')), surface);
  } catch (const Error&) {
    return {}; // A session of another version's organs: its surface is inside.
  }
}

std::vector<geometry::NamedWay> SampleMaker::waysOf(const std::string& sample,
                                                    const std::string& surface) const {
  try {
    return sample_organs::namedWays(library_, sample.substr(0, sample.find('@')), surface);
  } catch (const Error&) {
    return {};
  }
}

} // namespace viscera::document
