#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viscera/clinic/archive.h"
#include "viscera/core/error.h"

/// What the two ways to an archive share.
namespace viscera::clinic {

inline constexpr int kUnavailable = 69; ///< A service is not there, after sysexits.h.

/// Thrown where the archive is to blame, or the way to it.
struct ArchiveError : Error {
  ArchiveError(Text what, const ArchiveConnection& connection, Text tryThis, int exitCode = kUnavailable);
};

/// The errors, each with what to try.
ArchiveError unknownHost(const ArchiveConnection& connection);
ArchiveError withoutTls(const ArchiveConnection& connection);
ArchiveError unreachable(const ArchiveConnection& connection);
ArchiveError silent(const ArchiveConnection& connection);
ArchiveError wrongTitles(const ArchiveConnection& connection);
ArchiveError wrongPassword(const ArchiveConnection& connection);
ArchiveError untrusted(const ArchiveConnection& connection);
ArchiveError cut(const ArchiveConnection& connection);
ArchiveError strangeAnswer(const ArchiveConnection& connection);
ArchiveError refusal(const ArchiveConnection& connection, const std::string& reason);
ArchiveError notOffered(const ArchiveConnection& connection, const std::string& service);
ArchiveError notStored(const ArchiveConnection& connection, std::size_t failed, std::size_t files);
ArchiveError noSeries(const ArchiveConnection& connection);
CannotCreateError cannotKeep(const std::filesystem::path& file);

/// "20240301-20240331", "" without days.
std::string dayRange(const ArchiveQuery& query);

/// Whether it is a UID, which may be the name of a file.
bool isUid(const std::string& text);

/// One way to an archive.
class ArchiveChannel {
public:
  virtual ~ArchiveChannel() = default;
  virtual void test(Progress& progress) = 0;
  virtual std::vector<ArchiveStudy> query(const ArchiveQuery& query, Progress& progress) = 0;
  virtual void retrieve(const std::string& studyUid, const std::string& seriesUid,
                        const std::filesystem::path& folder, Progress& progress) = 0;
  virtual void send(const std::vector<std::filesystem::path>& files, Progress& progress) = 0;
};

std::unique_ptr<ArchiveChannel> webChannel(const ArchiveConnection& connection, const std::string& password);
std::unique_ptr<ArchiveChannel> dimseChannel(const ArchiveConnection& connection);

} // namespace viscera::clinic
