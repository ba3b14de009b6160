#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/progress.h"

/// Says whose the objects are that are written as DICOM, and which images they refer to.
namespace viscera::clinic {

/// An image of a series: one slice.
struct SourceImage {
  std::string classUid, instanceUid;
  Vec3 position = Vec3::Zero();                     ///< Of the first pixel's centre, mm LPS.
  Vec3 row = Vec3::UnitX(), column = Vec3::UnitY(); ///< Unit vectors along a row and along a column.
  double betweenColumns = 1, betweenRows = 1;       ///< mm: the steps along a row and along a column.
  int columns = 0, rows = 0;                        ///< Pixels.

  Vec3 normal() const { return row.cross(column).normalized(); }
};

/// The elements that say whose an object is, as DICOM writes them ("Doe^Jane", "19700131"), in UTF-8; empty:
/// not stated.
struct StudyIdentity {
  std::string patientName, patientId, birthDate, sex;
  std::string studyUid, studyId, studyDate, studyTime, studyDescription, accessionNumber, referringPhysician;
  std::string frameOfReference;    ///< UID of the coordinate system of images and objects.
  std::string seriesUid;           ///< Of the images below; empty without.
  std::vector<SourceImage> images; ///< From the lowest to the highest along their normal.
  bool identityRemoved = false;    ///< `withoutIdentity` has made it.
};

/// One element that says whose an object is, for a list that a user reads.
struct IdentifyingElement {
  const char* keyword = ""; ///< "PatientName", DICOM's own word.
  std::string value;
};

/// Gives those that are not empty.
std::vector<IdentifyingElement> identifyingElements(const StudyIdentity& identity);

/// Reads it from the files of one series. Slices in another direction, of another size or twice at one place
/// are no images to refer to. Throws `NoInputError`, `DataError` where no file is a DICOM image, `Cancelled`.
StudyIdentity readStudyIdentity(const std::vector<std::filesystem::path>& files, Progress& progress);

/// Makes one for organs that came from no DICOM images: a patient without a name in a study of its own, with
/// new UIDs.
StudyIdentity newStudyIdentity();

/// The same study without whose it is (basic profile of PS3.15, annex E): no name, numbers, dates,
/// descriptions or physician; UIDs are replaced by others that follow from them and `secret`, so that all
/// files of one export, and of a later one with the same secret, still belong together.
///
///     const StudyIdentity clean = withoutIdentity(newStudyIdentity(), "secret of this export");
///     const std::vector<IdentifyingElement> left = identifyingElements(clean);
StudyIdentity withoutIdentity(const StudyIdentity& identity, std::string_view secret);

/// A UID that is new: "2.25." with 128 random bits.
std::string newUid();

/// A UID that follows from another one and a secret, the same for the same two.
std::string uidFrom(std::string_view uid, std::string_view secret);

} // namespace viscera::clinic
