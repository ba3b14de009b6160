#include "viscera/clinic/archive.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <random>
#include <system_error>

#include "archive_parts.h"

namespace viscera::clinic {
namespace {

constexpr int kUnavailable = 69;
constexpr std::size_t kLongestTitle = 16;
constexpr std::size_t kLongestUid = 64;

Text placeOf(const ArchiveConnection& connection) {
  if (connection.kind == ArchiveKind::dicomWeb)
    return Text(connection.address);
  return Text(connection.address + ":" + std::to_string(connection.port));
}

std::unique_ptr<ArchiveChannel> channelTo(const ArchiveConnection& connection, const std::string& password) {
  checkArchiveConnection(connection);
  return connection.kind == ArchiveKind::dicomWeb ? webChannel(connection, password)
                                                  : dimseChannel(connection);
}

bool isTitle(const std::string& title) {
  return !title.empty() && title.size() <= kLongestTitle &&
         std::all_of(title.begin(), title.end(), [](char c) { return c >= ' ' && c < 127 && c != '\\'; });
}

/// A folder beside the target that takes its name when it is complete, and else is removed.
class ArrivingFolder {
public:
  explicit ArrivingFolder(std::filesystem::path target) : target_(std::move(target)) {
    std::error_code failed;
    if (std::filesystem::exists(target_, failed))
      throw CannotCreateError("The folder is there already", target_.string());
    const std::filesystem::path parent = std::filesystem::absolute(target_).parent_path();
    std::filesystem::create_directories(parent, failed);
    arriving_ = parent / (".arriving-" + std::to_string(std::random_device()()));
    if (!std::filesystem::create_directory(arriving_, failed))
      throw CannotCreateError("The folder cannot be made", target_.string());
  }
  ~ArrivingFolder() {
    std::error_code ignored;
    if (!arriving_.empty())
      std::filesystem::remove_all(arriving_, ignored);
  }
  ArrivingFolder(const ArrivingFolder&) = delete;
  ArrivingFolder& operator=(const ArrivingFolder&) = delete;

  const std::filesystem::path& path() const { return arriving_; }
  void complete() {
    std::error_code failed;
    std::filesystem::rename(arriving_, target_, failed);
    if (failed)
      throw cannotKeep(target_);
    arriving_.clear();
  }

private:
  std::filesystem::path target_, arriving_;
};

} // namespace

ArchiveError::ArchiveError(Text what, const ArchiveConnection& connection, Text tryThis)
    : Error(kUnavailable, std::move(what), placeOf(connection), std::move(tryThis)) {}

ArchiveError unreachable(const ArchiveConnection& connection) {
  return {phrase("The archive %1 cannot be reached", connection.name), connection,
          "Check its address and port, and whether it runs"};
}

ArchiveError silent(const ArchiveConnection& connection) {
  return {phrase("The archive %1 does not answer", connection.name), connection,
          "Try again; the archive or the network may be slow"};
}

ArchiveError wrongTitles(const ArchiveConnection& connection) {
  return {phrase("The archive %1 refuses the titles: it is called %2, and this program %3", connection.name,
                 connection.calledTitle, connection.ownTitle),
          connection, "Ask its administrator for its title, and to allow that of this program"};
}

ArchiveError wrongPassword(const ArchiveConnection& connection) {
  return {phrase("The archive %1 refuses the user name or the password", connection.name), connection,
          "Type both again"};
}

ArchiveError untrusted(const ArchiveConnection& connection) {
  return {phrase("The certificate of the archive %1 is not trusted", connection.name), connection,
          "Name the file with its issuer's certificate in the connection"};
}

ArchiveError cut(const ArchiveConnection& connection) {
  return {phrase("The connection to the archive %1 was cut", connection.name), connection,
          "Try again; nothing incomplete is kept"};
}

ArchiveError strangeAnswer(const ArchiveConnection& connection) {
  return {phrase("The answer of the archive %1 is not DICOM", connection.name), connection,
          "Check its address"};
}

ArchiveError refusal(const ArchiveConnection& connection, const std::string& reason) {
  return {phrase("The archive %1 refuses: %2", connection.name, reason), connection, "Ask its administrator"};
}

ArchiveError notOffered(const ArchiveConnection& connection, const std::string& service) {
  return {phrase("The archive %1 does not offer %2", connection.name, service), connection,
          "Ask its administrator"};
}

ArchiveError notStored(const ArchiveConnection& connection, std::size_t failed, std::size_t files) {
  return {phrase("The archive %1 has not kept %2 of %3 files", connection.name, failed, files), connection,
          "Ask its administrator"};
}

ArchiveError noSeries(const ArchiveConnection& connection) {
  return {phrase("The archive %1 has no such series", connection.name), connection, {}};
}

CannotCreateError cannotKeep(const std::filesystem::path& file) {
  return CannotCreateError("What was received cannot be written", file.string(), "Is the disk full?");
}

std::string dayRange(const ArchiveQuery& query) {
  if (query.from.empty() && query.to.empty())
    return {};
  return query.from == query.to ? query.from : query.from + "-" + query.to;
}

bool isUid(const std::string& text) {
  return !text.empty() && text.size() <= kLongestUid && text.front() != '.' &&
         text.find_first_not_of("0123456789.") == std::string::npos;
}

void checkArchiveConnection(const ArchiveConnection& connection) {
  if (connection.address.empty())
    throw UsageError(misuse("the archive %1 has no address", connection.name));
  if (connection.kind == ArchiveKind::dicomWeb) {
    if (!connection.address.starts_with("http://") && !connection.address.starts_with("https://"))
      throw UsageError(misuse("the address of DICOMweb begins with http:// or https://"), connection.address);
    if (connection.address.find('@') != std::string::npos)
      throw UsageError(misuse("the address holds no user and no password"), connection.name);
    return;
  }
  if (connection.port < 1 || connection.port > 65535)
    throw UsageError(misuse("there is no port %1", connection.port), connection.name);
  for (const std::string& title : {connection.calledTitle, connection.ownTitle})
    if (!isTitle(title))
      throw UsageError(misuse("a title has 1 to 16 characters: '%1'", title), connection.name);
}

std::vector<ArchiveStudy> queryArchive(const ArchiveConnection& connection, const std::string& password,
                                       const ArchiveQuery& query, Progress& progress) {
  progress.report(0, phrase("Ask the archive %1", connection.name));
  return channelTo(connection, password)->query(query, progress);
}

std::vector<std::filesystem::path> retrieveSeries(const ArchiveConnection& connection,
                                                  const std::string& password, const std::string& studyUid,
                                                  const std::string& seriesUid,
                                                  const std::filesystem::path& folder, Progress& progress) {
  for (const std::string& uid : {studyUid, seriesUid})
    if (!isUid(uid))
      throw UsageError(misuse("'%1' is no UID", uid));
  progress.report(0, phrase("Ask the archive %1", connection.name));
  ArrivingFolder arriving(folder);
  channelTo(connection, password)->retrieve(studyUid, seriesUid, arriving.path(), progress);
  progress.throwIfCancelled();
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(arriving.path()))
    files.push_back(folder / entry.path().filename());
  if (files.empty())
    throw noSeries(connection);
  arriving.complete();
  std::sort(files.begin(), files.end());
  return files;
}

void sendToArchive(const ArchiveConnection& connection, const std::string& password,
                   const std::vector<std::filesystem::path>& files, Progress& progress) {
  for (const std::filesystem::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    std::string start(132, '\0');
    if (!in)
      throw NoInputError("The file cannot be read", file.string());
    if (!in.read(start.data(), 132) || start.substr(128) != "DICM")
      throw DataError("The file is no DICOM file", file.string());
  }
  channelTo(connection, password)->send(files, progress);
}

void testArchive(const ArchiveConnection& connection, const std::string& password, Progress& progress) {
  channelTo(connection, password)->test(progress);
}

} // namespace viscera::clinic
