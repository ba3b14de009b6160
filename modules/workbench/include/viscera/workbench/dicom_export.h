#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "viscera/clinic/measurement_report.h"
#include "viscera/clinic/study_identity.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/workbench/workbench.h"

/// Writes what is open as DICOM objects for an archive.
namespace viscera::workbench {

/// An organ that is exported.
struct ExportedOrgan {
  std::string name;
  Vec3 color = {0.8, 0.45, 0.4};                      ///< 0 to 1.
  std::shared_ptr<const geometry::TriangleMesh> mesh; ///< Its triangles; never null.
};

/// One instant of the organs' motion, or the pose that is shown.
struct ExportedPhase {
  double seconds = 0;
  std::vector<Points> points; ///< Of each organ, mm LPS.
};

/// Which objects are written.
struct DicomKinds {
  bool segmentation = false; ///< DICOM-SEG, one for each phase.
  bool measurements = false; ///< SR TID 1500, one for each phase.
  bool surfaces = false;     ///< Encapsulated STL of each organ, in the first phase.
  bool contours = false;     ///< RTSTRUCT, in the first phase.
  bool document = false;     ///< Encapsulated PDF.
};

/// What is exported.
struct DicomExport {
  DicomKinds kinds;
  std::vector<ExportedOrgan> organs;
  std::vector<ExportedPhase> phases;           ///< One at least, in the order of time.
  std::vector<clinic::MeasuredOrgan> findings; ///< Numbers of no organ's segment, for the first report.
  clinic::StudyIdentity identity;              ///< Of the scan, or `clinic::newStudyIdentity`.
  double spacingMm = 1;                        ///< Of the segmentation where the scan has no grid.
  std::string dateTime;                        ///< When it is made: "20240301143000".
  std::string pdf;                             ///< Bytes of the report.
  std::string pdfTitle = "Report";             ///< What it is called.
  bool pdfIsAnonymous = false;                 ///< It was made without patient and file names.
  bool withoutIdentity = false;                ///< Basic profile of PS3.15, annex E.
  std::string secret;                          ///< Of the new UIDs; empty: one of this export alone.
  std::vector<std::string> alsoPrivate;        ///< Further names of the patient that no text may have.
};

/// One file that was written.
struct DicomFile {
  std::filesystem::path file;
  std::string kind;  ///< "segmentation", "measurements", "surface", "contours", "document".
  std::string organ; ///< Of a surface.
  int phase = 0;     ///< From 0.
  clinic::WrittenObject object;
};

/// Takes the organs of a workbench by their names, all closed ones without; `phases` instants of one cycle of
/// its motion, or with 0 the pose that is shown, which is shown again afterwards; its distances and angles;
/// and whose they are, from the DICOM files of its scan where they are still there. What is left out becomes
/// a sentence in `warnings`. The caller says what is written. Throws `UsageError` for an organ that does not
/// exist and for phases without a motion, `DataError` without a closed organ, `Cancelled`.
DicomExport dicomExportOf(Workbench& bench, const std::vector<std::string>& organs, int phases,
                          std::vector<Text>& warnings, Progress& progress);

/// The study of the DICOM files in a folder; throws as `clinic::readStudyIdentity`. `series`: as
/// `medical_io::ScanOptions`.
clinic::StudyIdentity studyIdentityOf(const std::filesystem::path& fileOrFolder, const std::string& series,
                                      Progress& progress);

/// The text without the parts of the patient's name, the numbers and dates of `identity`, and `alsoPrivate`,
/// whatever the case of ASCII letters; a word of fewer than four letters goes only where it stands alone.
/// May become empty.
std::string withoutPrivateWords(const std::string& text, const clinic::StudyIdentity& identity,
                                const std::vector<std::string>& alsoPrivate = {});

/// Writes the objects into a folder, which is made where it is not there; all or, when it throws, none.
/// `withoutIdentity` removes from the organs' names and notes what names the patient, makes 1900-01-01 the
/// date of making, and refuses a report that is not made for it. Throws `UsageError` when nothing is chosen,
/// `DataError` as the objects' writers, and for such a report, `CannotCreateError` for a file that is there
/// already, `Cancelled`. O(phases x voxels x organs).
std::vector<DicomFile> writeDicomExport(const std::filesystem::path& folder, const DicomExport& what,
                                        Progress& progress);

} // namespace viscera::workbench
