#include "viscera/clinic/archive.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <random>
#include <system_error>

#include "archive_parts.h"
#include "viscera/medical_io/archive_origin.h"

namespace viscera::clinic {
namespace {

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
  ArrivingFolder(const std::filesystem::path& target, Existing existing)
      : target_(std::filesystem::absolute(target).lexically_normal()) {
    if (!target_.has_filename())
      target_ = target_.parent_path();
    std::error_code failed;
    if (existing == Existing::refuse && std::filesystem::exists(target_, failed))
      throw CannotCreateError("The folder is there already", target_.string());
    std::filesystem::create_directories(target_.parent_path(), failed);
    arriving_ = beside(".arriving-");
    if (!std::filesystem::create_directory(arriving_, failed))
      throw CannotCreateError("The folder cannot be made", target_.string());
    std::filesystem::permissions(arriving_, std::filesystem::perms::owner_all, failed);
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
    const std::filesystem::path before = beside(".before-");
    std::error_code failed, none;
    std::filesystem::rename(target_, before, none); // Most often there was none.
    std::filesystem::rename(arriving_, target_, failed);
    if (failed) {
      std::filesystem::rename(before, target_, none);
      throw cannotKeep(target_);
    }
    arriving_.clear();
    std::filesystem::remove_all(before, none);
  }

private:
  std::filesystem::path beside(const char* prefix) const {
    return target_.parent_path() / (prefix + std::to_string(std::random_device()()));
  }

  std::filesystem::path target_, arriving_;
};

struct SeriesPlace {
  std::string studyUid, seriesUid;
};

/// The images of a series, and the note on where they came from, in a folder that is there.
std::vector<std::filesystem::path> fetchInto(const std::filesystem::path& folder,
                                             const ArchiveConnection& connection, const std::string& password,
                                             const SeriesPlace& series, Progress& progress) {
  channelTo(connection, password)->retrieve(series.studyUid, series.seriesUid, folder, progress);
  progress.throwIfCancelled();
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  if (files.empty())
    throw noSeries(connection);
  medical_io::writeArchiveOrigin(folder, {connection.name, series.studyUid, series.seriesUid});
  return files;
}

} // namespace

ArchiveError::ArchiveError(Text what, const ArchiveConnection& connection, Text tryThis, int exitCode)
    : Error(exitCode, std::move(what), placeOf(connection), std::move(tryThis)) {}

ArchiveError unknownHost(const ArchiveConnection& connection) {
  return {phrase("The address of the archive %1 is not known to the network", connection.name), connection,
          "Check how its address is spelt"};
}

ArchiveError withoutTls(const ArchiveConnection& connection) {
  return {phrase("There is no secure connection (TLS) to the archive %1", connection.name), connection,
          "Ask its administrator whether this port takes TLS, and of which version"};
}

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
          "Type both again", kPasswordRefused};
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
                                                  const std::filesystem::path& folder, Progress& progress,
                                                  Existing existing) {
  for (const std::string& uid : {studyUid, seriesUid})
    if (!isUid(uid))
      throw UsageError(misuse("'%1' is no UID", uid));
  progress.report(0, phrase("Ask the archive %1", connection.name));
  ArrivingFolder arriving(folder, existing);
  std::vector<std::filesystem::path> files;
  for (const auto& file : fetchInto(arriving.path(), connection, password, {studyUid, seriesUid}, progress))
    files.push_back(folder / file.filename());
  arriving.complete();
  std::sort(files.begin(), files.end());
  return files;
}

std::size_t retrieveStudy(const ArchiveConnection& connection, const std::string& password,
                          const std::string& studyUid, const std::filesystem::path& folder,
                          Progress& progress, Existing existing) {
  if (!isUid(studyUid))
    throw UsageError(misuse("'%1' is no UID", studyUid));
  ArchiveQuery query;
  query.studyUid = studyUid;
  std::vector<std::string> series;
  for (const ArchiveStudy& study : queryArchive(connection, password, query, progress))
    for (const ArchiveSeries& one : study.series)
      if (isUid(one.seriesUid))
        series.push_back(one.seriesUid);
  if (series.empty())
    throw noSeries(connection);
  ArrivingFolder arriving(folder, existing);
  std::size_t images = 0;
  for (std::size_t i = 0; i < series.size(); ++i)
    runPart(progress, double(i) / double(series.size()), double(i + 1) / double(series.size()),
            [&](Progress& part) {
              const std::filesystem::path place = arriving.path() / series[i];
              std::filesystem::create_directory(place);
              images += fetchInto(place, connection, password, {studyUid, series[i]}, part).size();
            });
  medical_io::writeArchiveOrigin(arriving.path(), {connection.name, studyUid, {}});
  arriving.complete();
  return images;
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
