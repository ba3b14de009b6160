#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"

/// Reads a patient's images over time: planes through the heart, each in many phases of its cycle.
namespace viscera::medical_io {

/// The values of one picture, `rows x columns`; row 0 is the first one in the file, at the top. NaN where the
/// file marks a pixel as not measured.
using CineImage = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// What a plane shows of the heart.
enum class CinePlane { shortAxis, twoChamber, threeChamber, fourChamber, longAxis, other };

/// "short axis", "2-chamber", "3-chamber", "4-chamber", "long axis", "other plane".
std::string nameOf(CinePlane plane);

/// The place of a picture's pixels in the patient, mm LPS.
struct CineGeometry {
  Vec3 origin = Vec3::Zero();  ///< The centre of the first pixel.
  Vec3 row = Vec3::UnitX();    ///< Unit vector along a row, in which the columns follow each other.
  Vec3 column = Vec3::UnitY(); ///< Unit vector along a column, in which the rows follow each other.
  double betweenColumns = 1;   ///< mm from a column to the next.
  double betweenRows = 1;      ///< mm from a row to the next.
  double thickness = 0;        ///< Of the slice, mm; 0: the file does not say.
  int columns = 0;             ///< Pixels in a row.
  int rows = 0;                ///< Pixels in a column.

  Vec3 normal() const { return row.cross(column).normalized(); }
  /// The place of a pixel; whole numbers are centres.
  Vec3 at(double column, double row) const;
  Vec3 center() const { return at(0.5 * (columns - 1), 0.5 * (rows - 1)); }
  /// Column and row of the pixel that lies in front of a point or behind it.
  Eigen::Vector2d pixelOf(const Vec3& point) const;
};

/// Pictures of one plane over the heart's cycle. Phases that are missing have no picture; nothing is made up
/// for them.
struct CineSlice {
  std::string series;      ///< UID of its series; several slices may have one. Empty for a file of volumes.
  int number = 0;          ///< Of the series.
  std::string description; ///< Of the series: "cine_trufi_retro 4CH".
  std::string date;        ///< Of the series, "20240301"; empty: not stated.
  CinePlane plane = CinePlane::other;
  CineGeometry geometry;
  /// The part of this slice's own cycle that has gone by at each picture, in [0, 1), ascending.
  std::vector<double> fractions;
  std::vector<double> missing; ///< The same of phases that should be there and are not.
  double interval = 0;         ///< Duration of its cycle, s; 0: not stated, and not to be told.
  /// Decodes the picture of a phase, or finds it among those decoded last. Throws `DataError` when the file
  /// has changed since the study was read. For any thread.
  std::function<std::shared_ptr<const CineImage>(std::size_t phase)> image;

  /// The phase whose fraction lies nearest, around the end of the cycle as well; 0 without phases. Slices
  /// are matched in this way, because each has its own interval. O(phases).
  std::size_t phaseAt(double fraction) const;
  /// Phases that there should be.
  std::size_t phasesInCycle() const { return fractions.size() + missing.size(); }
};

/// Parallel slices of one geometry. Nothing is known between them where there is a gap.
struct CineStack {
  std::vector<std::size_t> slices; ///< Two or more of the study's, along the normal of the first one.
  std::vector<double> distances;   ///< mm from the middle of each slice to that of the next.
  std::vector<double> gaps;        ///< mm between them that no slice covers; 0 where they touch.
};

/// The cine images of one study of one patient.
///
///     Progress progress;
///     const CineStudy study = readCineStudy("patient1", progress);
///     std::vector<std::shared_ptr<const CineImage>> endSystole;
///     for (const CineSlice& slice : study.slices)
///       endSystole.push_back(slice.image(slice.phaseAt(0.35)));
struct CineStudy {
  std::string patientName;       ///< "Doe, Jane"; empty where the files do not say, as the others here.
  std::string patientId;         ///< Of the hospital.
  std::string studyUid;          ///< Of the study.
  std::string date;              ///< "20240301".
  std::string modality;          ///< "MR".
  double heightCm = 0;           ///< Of the patient; 0: not stated, or no height of a person.
  double weightKg = 0;           ///< The same.
  std::vector<CineSlice> slices; ///< By the numbers of their series, and along their normals.
  std::vector<CineStack> stacks; ///< The short axis first, then the others with most slices first.
  std::vector<Text> findings;    ///< What is missing, damaged or left out, by file, series and phase.
};

/// How a study is read.
struct CineOptions {
  /// Decoded pictures that the slices of a study keep together, those used last; at least one is kept.
  std::size_t keptBytes = std::size_t{256} << 20U;
};

/// Reads the cine images in a DICOM folder (four folders deep), or of volumes over time (4D NIfTI or
/// MetaImage, .seq.nrrd, DICOM series that are the phases of one scan; scan_over_time.h), whose layers become
/// the slices of one stack. Reads headers; pictures are decoded when they are asked for, but packed ones and
/// volumes once here as well, so that damaged ones are found.
///
/// A series belongs to the study when its images at one place show a heart's whole cycle, by trigger times,
/// by parts of the cycle, or by their numbers in it. Left out, and said in `findings`: files that are
/// damaged, whose phases are `missing` then; series of one phase; those in another frame of reference; all
/// studies but the one with the most slices. None when no series has phases. Throws `DataError` for the
/// images of several patients, and as `readScan`; `Cancelled`. O(files).
std::optional<CineStudy> findCineStudy(const std::filesystem::path& place, Progress& progress,
                                       const CineOptions& options = {});

/// The same; throws `DataError` where no series has phases.
CineStudy readCineStudy(const std::filesystem::path& place, Progress& progress,
                        const CineOptions& options = {});

/// The same of chosen DICOM files; others are left out.
CineStudy readCineStudy(const std::vector<std::filesystem::path>& files, Progress& progress,
                        const CineOptions& options = {});

} // namespace viscera::medical_io
