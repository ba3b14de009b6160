#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/progress.h"

/// Asks an archive of images (PACS) for studies, fetches series, and sends files to it.
namespace viscera::clinic {

enum class ArchiveKind { dicomWeb, dimse };

/// Where an archive is and how it is spoken to. It has no password: that is an argument of each function.
struct ArchiveConnection {
  std::string name;
  ArchiveKind kind = ArchiveKind::dicomWeb;
  std::string address;              ///< DICOMweb: "https://host/dicom-web". DIMSE: the host.
  int port = 104;                   ///< DIMSE only.
  std::string calledTitle;          ///< DIMSE: the archive's application entity, at most 16 characters.
  std::string ownTitle = "VISCERA"; ///< DIMSE: this program's.
  bool tls = false;                 ///< DIMSE: with TLS. DICOMweb has it by "https:".
  std::string certificates;         ///< PEM file of trusted issuers; empty: those of the system.
  std::string user;                 ///< DICOMweb; empty: without a user.
  int patienceSeconds = 30;         ///< How long the archive may be silent.
};

/// Which studies are wanted. What is empty is not asked for; `*` and `?` stand for any characters.
struct ArchiveQuery {
  std::string patientName, patientId;
  std::string from, to; ///< Days of the study, "20240301", both included.
  std::string modality; ///< "CT"
  std::string studyUid; ///< With it, the series of this study are listed too.
};

struct ArchiveSeries {
  std::string seriesUid, modality, description, number;
  int images = -1; ///< -1: the archive does not say.
};

struct ArchiveStudy {
  std::string patientName, patientId; ///< "Doe^Jane", UTF-8.
  std::string studyUid, date, description;
  std::string modalities;            ///< "CT, SEG"; empty: the archive does not say.
  std::vector<ArchiveSeries> series; ///< Only where the query has a `studyUid`.
};

/// The exit code of the error by which an archive refuses user and password, after sysexits.h. Of all other
/// errors between program and archive it is 69.
inline constexpr int kPasswordRefused = 77;

/// The studies that match, as the archive lists them. Throws `ArchiveError`, `Cancelled`.
std::vector<ArchiveStudy> queryArchive(const ArchiveConnection& connection, const std::string& password,
                                       const ArchiveQuery& query, Progress& progress);

/// What to do with a folder that is there already.
enum class Existing { refuse, replace };

/// Fetches one series into `folder`; one file an image, named by the image's UID, and one that notes where
/// they came from (`medical_io::ArchiveOrigin`). The folder appears when the series is complete; after an
/// error, or when cancelled, all is as it was. Only the user may read it. Returns the images, sorted. Throws
/// `ArchiveError`, `CannotCreateError` (a full disk, or the folder is there and shall not be replaced),
/// `Cancelled`.
std::vector<std::filesystem::path> retrieveSeries(const ArchiveConnection& connection,
                                                  const std::string& password, const std::string& studyUid,
                                                  const std::string& seriesUid,
                                                  const std::filesystem::path& folder, Progress& progress,
                                                  Existing existing = Existing::refuse);

/// Fetches all series of a study, each into a folder of its own in `folder`, as `retrieveSeries` does.
/// Returns the number of images. Throws as that does; what was complete by then stays in no case.
std::size_t retrieveStudy(const ArchiveConnection& connection, const std::string& password,
                          const std::string& studyUid, const std::filesystem::path& folder,
                          Progress& progress, Existing existing = Existing::refuse);

/// Stores DICOM files in the archive, as they are. Throws `ArchiveError` (also when the archive keeps only a
/// part of them), `NoInputError`, `DataError` for a file that is no DICOM, `Cancelled`.
void sendToArchive(const ArchiveConnection& connection, const std::string& password,
                   const std::vector<std::filesystem::path>& files, Progress& progress);

/// Whether the archive answers (C-ECHO, or a query for one study). Throws `ArchiveError` with what is wrong.
void testArchive(const ArchiveConnection& connection, const std::string& password, Progress& progress);

/// `$XDG_CONFIG_HOME/viscera/archives.json`
std::filesystem::path archiveConnectionsFile();
/// Where fetched images are kept for the window: `$XDG_CACHE_HOME/viscera/archive`
std::filesystem::path archiveFolder();
/// None where the file is not there. Throws `DataError` for a damaged one.
std::vector<ArchiveConnection> readArchiveConnections(const std::filesystem::path& file);
/// Makes the folder where it is missing. Throws `CannotCreateError`.
void writeArchiveConnections(const std::filesystem::path& file,
                             const std::vector<ArchiveConnection>& connections);
/// Throws `UsageError` for what cannot work: no address, a port or a title that does not exist.
void checkArchiveConnection(const ArchiveConnection& connection);

} // namespace viscera::clinic
