#include "viscera/clinic/study_identity.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "dicom_object.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/quiet_dcmtk.h"

namespace viscera::clinic {
namespace {

constexpr double kSameDirection = 1e-4;
constexpr double kSamePlaceMm = 1e-3;

std::string textOf(DcmItem& item, const DcmTagKey& key) {
  OFString text;
  return item.findAndGetOFStringArray(key, text).good() ? std::string(text.c_str()) : std::string();
}

std::vector<double> numbersOf(DcmItem& item, const DcmTagKey& key, unsigned long count) {
  std::vector<double> numbers(count);
  for (unsigned long i = 0; i < count; ++i)
    if (item.findAndGetFloat64(key, numbers[i], i).bad() || !std::isfinite(numbers[i]))
      return {};
  return numbers;
}

/// Adds the image when it says where it lies.
void addImage(DcmDataset& dataset, std::vector<SourceImage>& images) {
  SourceImage image;
  image.classUid = textOf(dataset, DCM_SOPClassUID);
  image.instanceUid = textOf(dataset, DCM_SOPInstanceUID);
  const auto position = numbersOf(dataset, DCM_ImagePositionPatient, 3);
  const auto directions = numbersOf(dataset, DCM_ImageOrientationPatient, 6);
  const auto spacing = numbersOf(dataset, DCM_PixelSpacing, 2);
  Uint16 rows = 0, columns = 0;
  if (position.empty() || directions.empty() || spacing.empty() || image.instanceUid.empty() ||
      dataset.findAndGetUint16(DCM_Rows, rows).bad() || dataset.findAndGetUint16(DCM_Columns, columns).bad())
    return;
  image.position = {position[0], position[1], position[2]};
  image.row = Vec3(directions[0], directions[1], directions[2]).normalized();
  image.column = Vec3(directions[3], directions[4], directions[5]).normalized();
  image.betweenRows = spacing[0];
  image.betweenColumns = spacing[1];
  image.rows = rows;
  image.columns = columns;
  images.push_back(std::move(image));
}

bool isLike(const SourceImage& a, const SourceImage& b) {
  return (a.row - b.row).norm() < kSameDirection && (a.column - b.column).norm() < kSameDirection &&
         a.rows == b.rows && a.columns == b.columns &&
         std::abs(a.betweenRows - b.betweenRows) < kSamePlaceMm &&
         std::abs(a.betweenColumns - b.betweenColumns) < kSamePlaceMm;
}

/// Keeps those of the first image's kind, each place once, in the order along the normal.
void keepOneStack(std::vector<SourceImage>& images) {
  if (images.empty())
    return;
  const SourceImage first = images.front();
  std::erase_if(images, [&](const SourceImage& image) { return !isLike(image, first); });
  const Vec3 normal = first.normal();
  const auto height = [&](const SourceImage& image) { return normal.dot(image.position); };
  std::stable_sort(images.begin(), images.end(),
                   [&](const SourceImage& a, const SourceImage& b) { return height(a) < height(b); });
  images.erase(std::unique(images.begin(), images.end(),
                           [&](const SourceImage& a, const SourceImage& b) {
                             return height(b) - height(a) < kSamePlaceMm;
                           }),
               images.end());
}

void readWhose(DcmDataset& dataset, StudyIdentity& identity) {
  identity.patientName = textOf(dataset, DCM_PatientName);
  identity.patientId = textOf(dataset, DCM_PatientID);
  identity.birthDate = textOf(dataset, DCM_PatientBirthDate);
  identity.sex = textOf(dataset, DCM_PatientSex);
  identity.studyUid = textOf(dataset, DCM_StudyInstanceUID);
  identity.studyId = textOf(dataset, DCM_StudyID);
  identity.studyDate = textOf(dataset, DCM_StudyDate);
  identity.studyTime = textOf(dataset, DCM_StudyTime);
  identity.studyDescription = textOf(dataset, DCM_StudyDescription);
  identity.accessionNumber = textOf(dataset, DCM_AccessionNumber);
  identity.referringPhysician = textOf(dataset, DCM_ReferringPhysicianName);
  identity.frameOfReference = textOf(dataset, DCM_FrameOfReferenceUID);
  identity.seriesUid = textOf(dataset, DCM_SeriesInstanceUID);
}

} // namespace

std::vector<IdentifyingElement> identifyingElements(const StudyIdentity& identity) {
  std::vector<IdentifyingElement> list = {{"PatientName", identity.patientName},
                                          {"PatientID", identity.patientId},
                                          {"PatientBirthDate", identity.birthDate},
                                          {"PatientSex", identity.sex},
                                          {"StudyInstanceUID", identity.studyUid},
                                          {"StudyID", identity.studyId},
                                          {"StudyDate", identity.studyDate},
                                          {"StudyTime", identity.studyTime},
                                          {"StudyDescription", identity.studyDescription},
                                          {"AccessionNumber", identity.accessionNumber},
                                          {"ReferringPhysicianName", identity.referringPhysician},
                                          {"FrameOfReferenceUID", identity.frameOfReference},
                                          {"SeriesInstanceUID", identity.seriesUid}};
  std::erase_if(list, [](const IdentifyingElement& one) { return one.value.empty(); });
  return list;
}

StudyIdentity readStudyIdentity(const std::vector<std::filesystem::path>& files, Progress& progress) {
  medical_io::silenceDcmtk();
  StudyIdentity identity;
  bool found = false;
  for (std::size_t i = 0; i < files.size(); ++i) {
    progress.report(double(i) / double(files.size()), "headers");
    DcmFileFormat format;
    if (format
            .loadFileUntilTag(files[i].c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength, ERM_autoDetect,
                              DCM_PixelData)
            .bad())
      continue;
    DcmDataset& dataset = *format.getDataset();
    const std::string series = textOf(dataset, DCM_SeriesInstanceUID);
    if (textOf(dataset, DCM_SOPClassUID).empty() || series.empty() || (found && series != identity.seriesUid))
      continue;
    dataset.convertToUTF8(); // What cannot be converted stays as it is.
    if (!found)
      readWhose(dataset, identity);
    found = true;
    addImage(dataset, identity.images);
  }
  if (!found)
    throw DataError("There is no DICOM image whose patient and study could be taken",
                    files.empty() ? std::string() : files.front().string(),
                    "name the folder of the images that the organs were made from");
  keepOneStack(identity.images);
  progress.report(1);
  return identity;
}

StudyIdentity newStudyIdentity() {
  StudyIdentity identity;
  identity.studyUid = newUid();
  identity.frameOfReference = newUid();
  return identity;
}

StudyIdentity withoutIdentity(const StudyIdentity& identity, std::string_view secret) {
  StudyIdentity clean;
  clean.identityRemoved = true;
  const auto replaced = [&](const std::string& uid) { return uid.empty() ? uid : uidFrom(uid, secret); };
  clean.studyUid = replaced(identity.studyUid);
  clean.frameOfReference = replaced(identity.frameOfReference);
  clean.seriesUid = replaced(identity.seriesUid);
  clean.images = identity.images;
  for (SourceImage& image : clean.images)
    image.instanceUid = replaced(image.instanceUid);
  clean.patientName = "Anonymous";
  // The same patient has the same number in all files of one secret.
  clean.patientId = uidFrom(identity.patientId + '\n' + identity.patientName, secret).substr(5, 12);
  return clean;
}

} // namespace viscera::clinic
