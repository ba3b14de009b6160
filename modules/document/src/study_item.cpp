#include "viscera/document/study_item.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <system_error>
#include <utility>

#include "viscera/core/content_hash.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/medical_io/scan.h"

namespace viscera::document {
namespace {

using medical_io::CineSlice;
using medical_io::CineStudy;

/// Adds numbers and texts to a hash one by one.
class StudyHash {
public:
  void add(const std::string& text) { hash_ = contentHash(text + '\n', hash_); }
  /// Written with few digits: the last bits are another machine's.
  void add(double number) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.4f", number + 0.0);
    add(std::string(digits));
  }
  void add(const Vec3& place) {
    for (int axis = 0; axis < 3; ++axis)
      add(place[axis]);
  }
  std::string text() const {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_));
    return digits;
  }

private:
  std::uint64_t hash_ = 0;
};

void addSlice(StudyHash& hash, const CineSlice& slice) {
  hash.add(slice.series);
  hash.add(slice.number);
  hash.add(slice.description);
  const medical_io::CineGeometry& place = slice.geometry;
  for (const Vec3& vector : {place.origin, place.row, place.column})
    hash.add(vector);
  for (const double number : {place.betweenColumns, place.betweenRows, place.thickness, double(place.columns),
                              double(place.rows), slice.interval})
    hash.add(number);
  for (const double fraction : slice.fractions)
    hash.add(fraction);
}

/// A normal farther from every axis of the patient is that of a plane of its own: one within 10 degrees is
/// read well enough on the patient's axes.
constexpr double kAxisCosine = 0.985;
constexpr double kThickPixels = 2; ///< Slices thicker than so many of their pixels have no other view.

constexpr float kBelowMr = -500; ///< Values of magnetic resonance are not negative.

bool isOblique(const Vec3& normal) {
  return normal.cwiseAbs().maxCoeff() < kAxisCosine;
}

/// Whether a file may have volumes over time in planes of their own, by its header.
bool mayHaveOwnPlanes(const std::filesystem::path& file, Progress& progress) {
  const std::vector<medical_io::ScanSeries> all = medical_io::listScans(file, progress);
  if (all.size() != 1 || all.front().phases < 2 || all.front().size[2] < 2)
    return false;
  const medical_io::ScanSeries& scan = all.front();
  const Vec3 normal = scan.indexToLps.linear().col(0).cross(scan.indexToLps.linear().col(1)).normalized();
  const double pixel = std::max(scan.spacing[0], scan.spacing[1]);
  const bool own = isOblique(normal) || (scan.modality != "CT" && scan.spacing[2] > kThickPixels * pixel);
  return own && medical_io::imageContents(file, progress) == medical_io::ImageContents::values;
}

/// Whether images are of CT, by what the files say or, where they say nothing, by air at -1000.
bool isOfCt(const CineStudy& study) {
  if (!study.modality.empty() || study.slices.front().fractions.empty())
    return study.modality == "CT";
  const std::shared_ptr<const medical_io::CineImage> image = study.slices.front().image(0);
  return (image->array() < kBelowMr).any();
}

} // namespace

std::vector<StudySeries> seriesOf(const CineStudy& study) {
  std::vector<StudySeries> all;
  for (std::size_t i = 0; i < study.slices.size(); ++i) {
    const CineSlice& slice = study.slices[i];
    const bool same = i > 0 && study.slices[i - 1].series == slice.series;
    if (!same)
      all.push_back({slice.number,
                     slice.description,
                     slice.date,
                     slice.plane,
                     {},
                     0,
                     0,
                     slice.interval,
                     slice.geometry.betweenColumns,
                     slice.geometry.thickness});
    StudySeries& series = all.back();
    series.slices.push_back(i);
    if (slice.phasesInCycle() >= series.phasesInCycle) {
      series.phases = slice.fractions.size();
      series.phasesInCycle = slice.phasesInCycle();
    }
  }
  return all;
}

std::string studyHash(const CineStudy& study) {
  StudyHash hash;
  hash.add(study.studyUid);
  hash.add(study.modality);
  for (const CineSlice& slice : study.slices)
    addSlice(hash, slice);
  return hash.text();
}

bool identical(const std::shared_ptr<const StudyItem>& a, const std::shared_ptr<const StudyItem>& b) {
  if (a == b || !a || !b)
    return a == b;
  return a->name == b->name && a->place == b->place && (a->study == b->study || a->hash == b->hash);
}

StudyItem studyItem(CineStudy study, const std::filesystem::path& place) {
  std::string name = study.modality;
  if (const std::filesystem::path last = place.has_filename() ? place : place.parent_path(); !last.empty())
    name += (name.empty() ? "" : ", ") + last.filename().string();
  std::string hash = studyHash(study);
  return {name.empty() ? "Study" : name, std::make_shared<const CineStudy>(std::move(study)), place,
          std::move(hash)};
}

bool hasOwnPlanes(const CineStudy& study) {
  if (study.slices.empty())
    return false;
  const CineSlice& first = study.slices.front();
  const medical_io::CineGeometry& place = first.geometry;
  const double pixel = std::max(place.betweenColumns, place.betweenRows);
  return isOblique(place.normal()) || (place.thickness > kThickPixels * pixel && !isOfCt(study));
}

std::optional<StudyItem> findStudy(const std::filesystem::path& place, Progress& progress) {
  std::error_code ignored;
  const bool isFolder = std::filesystem::is_directory(place, ignored);
  try {
    if (!isFolder && !mayHaveOwnPlanes(place, progress))
      return std::nullopt;
    std::optional<CineStudy> study = medical_io::findCineStudy(place, progress);
    if (!study || (seriesOf(*study).size() < 2 && !hasOwnPlanes(*study)))
      return std::nullopt;
    return studyItem(std::move(*study), place);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    return std::nullopt;
  }
}

StudyItem readStudy(const std::filesystem::path& place, Progress& progress) {
  return studyItem(medical_io::readCineStudy(place, progress), place);
}

Command openStudy(StudyItem item) {
  const Text name = phrase("Open study %1", item.name);
  auto shared = std::make_shared<const StudyItem>(std::move(item));
  return {name, [shared](DocumentState state, IdSource&) {
            state.study = shared;
            state.scan = nullptr;
            return state;
          }};
}

Command closeStudy() {
  return {"Close study", [](DocumentState state, IdSource&) {
            if (!state.study)
              throw UsageError("There is no study to close");
            state.study = nullptr;
            return state;
          }};
}

} // namespace viscera::document
