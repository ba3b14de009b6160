#include <string>

#include "dicom_object.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/plane_cut.h"

namespace viscera::clinic {
namespace {

/// Slices are cut a little above, so that no vertex lies in one.
constexpr double kAsideMm = 1e-6;
constexpr double kUnevenDecimals = 1e4; ///< Coordinates have four digits behind the point: 0.1 um.

/// Whether a contour has a corner within the picture.
bool reachesInto(const SourceImage& image, const Points& corners) {
  for (const auto& corner : corners.rowwise()) {
    const Vec3 from = corner.transpose() - image.position;
    const double x = from.dot(image.row) / image.betweenColumns,
                 y = from.dot(image.column) / image.betweenRows;
    if (x >= -0.5 && x <= image.columns - 0.5 && y >= -0.5 && y <= image.rows - 0.5)
      return true;
  }
  return false;
}

class StructureSetWriter {
public:
  StructureSetWriter(const StudyIdentity& identity, const ObjectSeries& series)
      : identity_(identity), series_(series), dataset_(*format_.getDataset()) {}

  WrittenObject run(const std::filesystem::path& file, const std::vector<WrittenOrgan>& organs,
                    Progress& progress) {
    putHeader();
    for (std::size_t o = 0; o < organs.size(); ++o) {
      progress.report(double(o) / double(organs.size()), "contours");
      putOrgan(organs[o], static_cast<int>(o) + 1);
    }
    // A contour in the implicit form may have any number of points: an explicit decimal string has 64 kB.
    WrittenObject written = save(format_, file, series_, EXS_LittleEndianImplicit);
    for (const WrittenOrgan& organ : organs)
      written.segments.push_back(organ.name);
    progress.report(1);
    return written;
  }

private:
  void putHeader() {
    putCommon(dataset_, identity_, series_, UID_RTStructureSetStorage, "RTSTRUCT");
    put(dataset_, DCM_OperatorsName, "");
    put(dataset_, DCM_FrameOfReferenceUID, identity_.frameOfReference);
    put(dataset_, DCM_PositionReferenceIndicator, "");
    put(dataset_, DCM_StructureSetLabel, "Organs");
    put(dataset_, DCM_StructureSetName, series_.note);
    put(dataset_, DCM_StructureSetDate, series_.dateTime.substr(0, 8));
    put(dataset_, DCM_StructureSetTime, series_.dateTime.substr(8));
    put(dataset_, DCM_ApprovalStatus, "UNAPPROVED");
    DcmItem& frame = addItem(dataset_, DCM_ReferencedFrameOfReferenceSequence);
    put(frame, DCM_FrameOfReferenceUID, identity_.frameOfReference);
    DcmItem& study = addItem(frame, DCM_RTReferencedStudySequence);
    put(study, DCM_ReferencedSOPClassUID, UID_RETIRED_DetachedStudyManagementSOPClass);
    put(study, DCM_ReferencedSOPInstanceUID, identity_.studyUid);
    DcmItem& images = addItem(study, DCM_RTReferencedSeriesSequence);
    put(images, DCM_SeriesInstanceUID, identity_.seriesUid);
    for (const SourceImage& image : identity_.images)
      putImage(images, image);
  }

  static void putImage(DcmItem& item, const SourceImage& image) {
    DcmItem& one = addItem(item, DCM_ContourImageSequence);
    put(one, DCM_ReferencedSOPClassUID, image.classUid);
    put(one, DCM_ReferencedSOPInstanceUID, image.instanceUid);
  }

  void putOrgan(const WrittenOrgan& organ, int number) {
    DcmItem& region = addItem(dataset_, DCM_StructureSetROISequence);
    put(region, DCM_ROINumber, std::to_string(number));
    put(region, DCM_ReferencedFrameOfReferenceUID, identity_.frameOfReference);
    put(region, DCM_ROIName, organ.name);
    put(region, DCM_ROIGenerationAlgorithm, "SEMIAUTOMATIC");
    DcmItem& drawn = addItem(dataset_, DCM_ROIContourSequence);
    const Eigen::Vector3i color = (255 * organ.color.array()).round().cast<int>();
    put(drawn, DCM_ROIDisplayColor,
        std::to_string(color.x()) + '\\' + std::to_string(color.y()) + '\\' + std::to_string(color.z()));
    std::size_t contours = 0;
    for (const SourceImage& image : identity_.images)
      contours += putContours(drawn, organ, image);
    if (contours == 0)
      throw DataError("No image of the scan crosses the organ", organ.name, "choose the scan that shows it");
    put(drawn, DCM_ReferencedROINumber, std::to_string(number));
    DcmItem& observation = addItem(dataset_, DCM_RTROIObservationsSequence);
    put(observation, DCM_ObservationNumber, std::to_string(number));
    put(observation, DCM_ReferencedROINumber, std::to_string(number));
    put(observation, DCM_RTROIInterpretedType, "ORGAN");
    put(observation, DCM_ROIInterpreter, "");
  }

  static std::size_t putContours(DcmItem& drawn, const WrittenOrgan& organ, const SourceImage& image) {
    const Vec3 normal = image.normal();
    const geometry::Plane plane{image.position + kAsideMm * normal, normal};
    const geometry::PlaneCut cut =
        geometry::cutSurface({&organ.surface->points, &organ.surface->triangles}, plane);
    std::size_t written = 0;
    for (std::size_t line = 0; line < cut.lines(); ++line) {
      const std::int32_t begin = cut.first[line], count = cut.first[line + 1] - begin;
      if (!cut.closed[line] || count < 3 || !reachesInto(image, cut.points.middleRows(begin, count)))
        continue;
      DcmItem& contour = addItem(drawn, DCM_ContourSequence);
      putImage(contour, image);
      put(contour, DCM_ContourGeometricType, "CLOSED_PLANAR");
      put(contour, DCM_NumberOfContourPoints, std::to_string(count));
      std::vector<double> numbers;
      numbers.reserve(static_cast<std::size_t>(3 * count));
      for (std::int32_t i = begin; i < begin + count; ++i)
        for (int axis = 0; axis < 3; ++axis)
          numbers.push_back(std::round(kUnevenDecimals * cut.points(i, axis)) / kUnevenDecimals);
      putNumbers(contour, DCM_ContourData, numbers);
      ++written;
    }
    return written;
  }

  const StudyIdentity& identity_;
  const ObjectSeries& series_;
  DcmFileFormat format_;
  DcmDataset& dataset_;
};

} // namespace

WrittenObject writeStructureSet(const std::filesystem::path& file, const StudyIdentity& identity,
                                const ObjectSeries& series, const std::vector<WrittenOrgan>& organs,
                                Progress& progress) {
  if (identity.images.empty())
    throw DataError("Contours need the images whose planes they lie in", file.string(),
                    "open the DICOM scan of the organs, or write a segmentation");
  return StructureSetWriter(identity, series).run(file, organs, progress);
}

} // namespace viscera::clinic
