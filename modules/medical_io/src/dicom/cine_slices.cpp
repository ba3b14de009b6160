#include "dicom/cine_slices.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "cine_planes.h"
#include "dicom/cine_times.h"
#include "dicom/dicom_header.h"
#include "dicom/for_all.h"
#include "dicom/pixel_conversion.h"
#include "dicom/slice_stack.h"
#include "image_ring.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {
namespace {

/// The part of the work that headers are; the rest unpacks what is packed.
/// Sizes that a person can have.
constexpr double kSmallestCm = 30, kTallestM = 2.5, kLightestKg = 1, kHeaviestKg = 400, kCmPerM = 100;
constexpr double kHeaderPart = 0.5;
constexpr double kSamePositionMm = 0.05, kSameDirections = 1e-3;
constexpr double kSecondsPerMs = 1e-3;
/// Files and phases that a sentence names one by one.
constexpr std::size_t kMostFilesNamed = 20, kMostPhasesNamed = 12;

/// The files of a study, from which its pictures are decoded.
class CineFiles {
public:
  CineFiles(std::vector<DicomHeader> files, std::size_t keptBytes)
      : files_(std::move(files)), ring_(keptBytes) {}

  /// A slice's frames, one a phase; before any is decoded.
  std::size_t add(std::vector<DicomFrame> frames) {
    slices_.push_back(std::move(frames));
    return slices_.size() - 1;
  }
  ImageRing::Picture image(std::size_t slice, std::size_t phase) {
    return ring_.get({slice, phase}, [&] { return decode(slices_.at(slice).at(phase)); });
  }

private:
  CineImage decode(const DicomFrame& frame) {
    const DicomHeader& header = files_[frame.file];
    CineImage image(header.rows, header.columns);
    const DicomPixels pixels = pixelsOf(header, frame);
    convertPixels(pixels, frame, SampleForm{header.format, frame.slope, frame.intercept, false},
                  image.data());
    return image;
  }

  /// A file of many frames stays open, because opening it again reads all of them.
  DicomPixels pixelsOf(const DicomHeader& header, const DicomFrame& frame) {
    if (header.frames.size() == 1)
      return DicomPixelReader(header).read(frame.frame);
    const std::lock_guard lock(mutex_);
    if (!open_ || openFile_ != frame.file) {
      open_ = std::make_unique<DicomPixelReader>(header);
      openFile_ = frame.file;
    }
    return open_->read(frame.frame);
  }

  std::vector<DicomHeader> files_;
  std::vector<std::vector<DicomFrame>> slices_;
  ImageRing ring_;
  std::mutex mutex_; ///< Of the two below.
  std::unique_ptr<DicomPixelReader> open_;
  std::size_t openFile_ = 0;
};

/// A file that is left out.
struct DamagedFile {
  std::filesystem::path file;
  Text problem;
  DicomHeader remains;
};

/// Pictures of one plane of one series, in a cycle.
struct FoundSlice {
  const DicomHeader* file = nullptr; ///< Of the first picture.
  DicomFrame first;
  CineTimes times;
  std::vector<std::size_t> damaged; ///< Indices of damaged files, as `times.ofDamaged`.
};

/// Numbers in words may be infinite or none.
bool isUsable(const DicomFrame& frame) {
  return frame.position.allFinite() && frame.row.allFinite() && frame.column.allFinite() &&
         std::isfinite(frame.betweenColumns) && std::isfinite(frame.betweenRows) &&
         std::isfinite(frame.slope) && std::isfinite(frame.intercept);
}

bool samePlace(const DicomFrame& a, const DicomFrame& b) {
  return (a.position - b.position).norm() <= kSamePositionMm && (a.row - b.row).norm() <= kSameDirections &&
         (a.column - b.column).norm() <= kSameDirections;
}

/// Frames of one geometry by their positions. `copies` counts those that are left out.
std::vector<std::vector<std::size_t>> placesOf(const FrameList& list, const SliceGroup& group,
                                               std::size_t& copies) {
  const Vec3 normal = list.frames[group.frames[0]].normal();
  const auto height = [&](std::size_t f) { return normal.dot(list.frames[f].position); };
  std::vector<std::size_t> frames = group.frames;
  std::stable_sort(frames.begin(), frames.end(),
                   [&](std::size_t a, std::size_t b) { return height(a) < height(b); });
  std::vector<std::vector<std::size_t>> places;
  std::set<std::string> seen;
  for (const std::size_t f : frames) {
    if (!list.frames[f].uid.empty() && !seen.insert(list.frames[f].uid).second) {
      ++copies;
      continue;
    }
    auto place = places.rbegin();
    while (place != places.rend() && height(f) - height(place->front()) <= kSamePositionMm &&
           !samePlace(list.frames[place->front()], list.frames[f]))
      ++place;
    if (place == places.rend() || !samePlace(list.frames[place->front()], list.frames[f]))
      places.push_back({f});
    else
      place->push_back(f);
  }
  return places;
}

class StudyReader {
public:
  StudyReader(std::filesystem::path root, FolderHeaders&& folder) : root_(std::move(root)) {
    for (std::size_t i = 0; i < folder.files.size(); ++i)
      if (folder.errors[i])
        leaveOut(folder.files[i], folder.errors[i]->problem());
      else if (!std::all_of(folder.headers[i].frames.begin(), folder.headers[i].frames.end(), isUsable))
        leaveOut(folder.files[i], diagnostic("its header is damaged: one of its numbers is none"));
      else if (!folder.headers[i].notAScan.empty())
        placeless_.push_back(std::move(folder.headers[i]));
      else
        list_.files.push_back(std::move(folder.headers[i]));
    listAllFrames();
  }

  std::optional<CineStudy> run(Progress& progress, const CineOptions& options) {
    refuseSeveralPatients();
    findSlices();
    if (leaveOutDamagedPixels(progress))
      findSlices();
    chooseStudy();
    if (slices_.empty())
      return std::nullopt;
    leaveOutPlaceless();
    CineStudy study = described();
    addSlices(study, options);
    reportDamaged(study);
    reportLeftOut(study);
    progress.report(1);
    return study;
  }

private:
  void leaveOut(const std::filesystem::path& file, const Text& problem) {
    damaged_.push_back({file, problem, remainsOfDicomHeader(file)});
  }

  void listAllFrames() {
    list_.frames.clear();
    for (std::size_t file = 0; file < list_.files.size(); ++file)
      for (DicomFrame& frame : list_.files[file].frames) {
        frame.file = file;
        list_.frames.push_back(frame);
      }
  }

  /// Compares the number that a hospital gives, where all files have one, else the name.
  void refuseSeveralPatients() const {
    std::vector<const DicomHeader*> images;
    for (const DicomHeader& file : list_.files)
      if (!file.frames.empty())
        images.push_back(&file);
    const bool numbered = std::all_of(images.begin(), images.end(),
                                      [](const DicomHeader* file) { return !file->patientId.empty(); });
    std::map<std::string, const DicomHeader*> patients;
    for (const DicomHeader* file : images)
      if (const std::string& who = numbered ? file->patientId : file->patientName; !who.empty())
        patients.emplace(who, file);
    if (patients.size() > 1)
      throw DataError(phrase("It has the images of %1 patients: \"%2\" and \"%3\" are of two",
                             patients.size(), nameOfFile(patients.begin()->second->file),
                             nameOfFile(std::next(patients.begin())->second->file)),
                      root_.string(), "name the folder of one patient");
  }

  std::string nameOfFile(const std::filesystem::path& file) const {
    const std::string name = file.lexically_relative(root_).string();
    return name.empty() ? file.filename().string() : name;
  }

  void findSlices() {
    slices_.clear();
    uncounted_.clear();
    copies_ = 0;
    for (const SliceGroup& group : groupFrames(list_))
      for (const auto& place : placesOf(list_, group, copies_))
        addPlace(place);
  }

  void addPlace(const std::vector<std::size_t>& place) {
    FoundSlice found;
    found.first = list_.frames[place[0]];
    found.file = &list_.files[found.first.file];
    std::vector<DicomFrame> lost;
    for (std::size_t d = 0; d < damaged_.size(); ++d) {
      const DicomHeader& remains = damaged_[d].remains;
      for (const DicomFrame& frame : remains.frames)
        if (remains.seriesUid == found.file->seriesUid && samePlace(frame, found.first)) {
          lost.push_back(frame);
          found.damaged.push_back(d);
        }
    }
    auto times = cineTimesOf(list_, place, lost);
    if (!times) {
      uncounted_.insert(found.file);
      return;
    }
    found.times = std::move(*times);
    slices_.push_back(std::move(found));
  }

  /// Unpacks the packed pictures once; true when files were left out.
  bool leaveOutDamagedPixels(Progress& progress) {
    std::set<std::size_t> packed;
    for (const FoundSlice& slice : slices_)
      for (const std::size_t f : slice.times.frames)
        if (list_.files[list_.frames[f].file].packed)
          packed.insert(list_.frames[f].file);
    const std::vector<std::size_t> files(packed.begin(), packed.end());
    std::vector<std::optional<Text>> problems(files.size());
    forAll(files.size(), progress, kHeaderPart, 1, "slices", [&](std::size_t i) {
      const DicomHeader& header = list_.files[files[i]];
      try {
        DicomPixelReader reader(header);
        for (std::size_t frame = 0; frame < header.frames.size(); ++frame)
          reader.read(static_cast<int>(frame));
      } catch (const DataError& error) {
        problems[i] = error.problem();
      }
    });
    std::size_t left = 0;
    for (std::size_t i = files.size(); i-- > 0;)
      if (problems[i]) {
        leaveOut(list_.files[files[i]].file, *problems[i]);
        list_.files.erase(list_.files.begin() + std::ptrdiff_t(files[i]));
        ++left;
      }
    if (left > 0)
      listAllFrames();
    return left > 0;
  }

  /// Keeps the slices of the study and of the frame of reference that have most of them.
  void chooseStudy() {
    const auto keepMost = [&](std::string DicomHeader::*member) {
      std::map<std::string, std::size_t> counts;
      for (const FoundSlice& slice : slices_)
        ++counts[slice.file->*member];
      const auto most = std::max_element(counts.begin(), counts.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
      std::vector<FoundSlice> kept, others;
      for (FoundSlice& slice : slices_)
        (slice.file->*member == most->first ? kept : others).push_back(std::move(slice));
      slices_ = std::move(kept);
      return others;
    };
    if (slices_.empty())
      return;
    otherStudies_ = keepMost(&DicomHeader::studyUid);
    otherFrames_ = keepMost(&DicomHeader::frameOfReference);
  }

  /// Files without a place or pixels: they are damaged where others of their series are slices.
  void leaveOutPlaceless() {
    std::erase_if(placeless_, [&](const DicomHeader& header) {
      const bool ofSlice = std::any_of(slices_.begin(), slices_.end(), [&](const FoundSlice& slice) {
        return slice.file->seriesUid == header.seriesUid;
      });
      if (ofSlice)
        damaged_.push_back({header.file, header.notAScan, {}});
      return ofSlice;
    });
  }

  CineStudy described() const {
    const DicomHeader& file = *slices_.front().file;
    CineStudy study;
    study.patientName = file.patientName;
    study.patientId = file.patientId;
    study.studyUid = file.studyUid;
    study.date = file.studyDate;
    study.modality = file.modality;
    addSize(study);
    return study;
  }

  /// The first height and weight that a person can have; some scanners write the height in cm.
  void addSize(CineStudy& study) const {
    for (const FoundSlice& slice : slices_) {
      const double height = slice.file->heightM.value_or(0), weight = slice.file->weightKg.value_or(0);
      const double cm = height > kTallestM ? height : kCmPerM * height;
      if (study.heightCm == 0 && cm >= kSmallestCm && cm <= kCmPerM * kTallestM)
        study.heightCm = cm;
      if (study.weightKg == 0 && weight >= kLightestKg && weight <= kHeaviestKg)
        study.weightKg = weight;
    }
  }

  void addSlices(CineStudy& study, const CineOptions& options) {
    std::stable_sort(slices_.begin(), slices_.end(), [](const FoundSlice& a, const FoundSlice& b) {
      return std::make_tuple(a.file->seriesNumber, a.file->seriesUid) <
             std::make_tuple(b.file->seriesNumber, b.file->seriesUid);
    });
    const auto files = std::make_shared<CineFiles>(list_.files, options.keptBytes);
    for (const FoundSlice& found : slices_) {
      CineSlice slice = sliceOf(found);
      std::vector<DicomFrame> frames;
      for (const std::size_t f : found.times.frames)
        frames.push_back(list_.frames[f]);
      const std::size_t number = files->add(std::move(frames));
      slice.image = [files, number](std::size_t phase) { return files->image(number, phase); };
      reportSlice(study, found, slice);
      study.slices.push_back(std::move(slice));
    }
  }

  static CineSlice sliceOf(const FoundSlice& found) {
    CineSlice slice;
    slice.series = found.file->seriesUid;
    slice.number = found.file->seriesNumber;
    slice.description = found.file->description;
    slice.date = found.file->seriesDate.empty() ? found.file->studyDate : found.file->seriesDate;
    const double stated = found.first.sliceThickness;
    const double thickness = std::isfinite(stated) && stated > 0 ? stated : 0;
    slice.geometry = {found.first.position,       found.first.row,         found.first.column,
                      found.first.betweenColumns, found.first.betweenRows, thickness,
                      found.file->columns,        found.file->rows};
    slice.fractions = found.times.fractions;
    slice.missing = found.times.missing;
    slice.interval = kSecondsPerMs * found.times.intervalMs;
    return slice;
  }

  void reportSlice(CineStudy& study, const FoundSlice& found, const CineSlice& slice) const {
    if (!slice.missing.empty()) {
      std::vector<Text> phases;
      for (const double fraction : slice.missing)
        if (phases.size() < kMostPhasesNamed)
          phases.push_back(phaseNumber(slice, fraction));
      if (phases.size() < slice.missing.size())
        phases.push_back("...");
      study.findings.push_back(phrase("%n {phase|phases} of series %2 {is|are} missing: %3 of %4 (the first "
                                      "is 0)",
                                      slice.missing.size(), seriesLabel(slice), listOf(std::move(phases)),
                                      slice.phasesInCycle()));
    }
    if (found.times.doubled > 0)
      study.findings.push_back(phrase("%n {picture|pictures} of series %2 {has|have} the time of another one "
                                      "and {is|are} left out",
                                      found.times.doubled, seriesLabel(slice)));
    if (found.times.stated > 0 && std::size_t(found.times.stated) != slice.phasesInCycle())
      study.findings.push_back(phrase("Series %1 states %2 phases and has %3", seriesLabel(slice),
                                      found.times.stated, slice.phasesInCycle()));
    if (!found.file->assumed.empty())
      study.findings.push_back(phrase("Series %1: %2", seriesLabel(slice), found.file->assumed));
    if (found.times.wrongIntervalMs)
      study.findings.push_back(
          phrase("Series %1 states a cycle of %2 ms, which is shorter than its phases; %3 "
                 "ms were taken from their distance",
                 seriesLabel(slice), inDigits(*found.times.wrongIntervalMs, 4),
                 inDigits(found.times.intervalMs, 4)));
  }

  /// The place of a fraction among the phases that there should be.
  static std::size_t phaseNumber(const CineSlice& slice, double fraction) {
    const auto before = [&](const std::vector<double>& list) {
      return std::count_if(list.begin(), list.end(), [&](double one) { return one < fraction; });
    };
    return static_cast<std::size_t>(before(slice.fractions) + before(slice.missing));
  }

  void reportDamaged(CineStudy& study) const {
    for (std::size_t d = 0; d < damaged_.size() && d < kMostFilesNamed; ++d)
      study.findings.push_back(damageOf(study, d));
    if (damaged_.size() > kMostFilesNamed)
      study.findings.push_back(
          phrase("%n other {file is|files are} damaged and left out", damaged_.size() - kMostFilesNamed));
  }

  Text damageOf(const CineStudy& study, std::size_t d) const {
    const std::string name = nameOfFile(damaged_[d].file);
    for (std::size_t s = 0; s < slices_.size(); ++s)
      for (std::size_t i = 0; i < slices_[s].damaged.size(); ++i)
        if (const double at = slices_[s].times.ofDamaged[i]; slices_[s].damaged[i] == d && at >= 0) {
          const CineSlice& slice = study.slices[s];
          // A phase that was found missing has its fraction from its neighbours.
          double fraction = at;
          for (const double missing : slice.missing)
            if (std::abs(missing - at) < 0.5 / static_cast<double>(slice.phasesInCycle()))
              fraction = missing;
          return phrase("\"%1\" is damaged and left out, phase %2 of series %3 (%4)", name,
                        phaseNumber(slice, fraction), seriesLabel(slice), damaged_[d].problem);
        }
    return phrase("\"%1\" is damaged and left out (%2)", name, damaged_[d].problem);
  }

  void reportLeftOut(CineStudy& study) const {
    if (!otherStudies_.empty())
      study.findings.push_back(phrase("%n {slice|slices} of another study left out (series %2)",
                                      otherStudies_.size(), seriesOf(otherStudies_)));
    if (!otherFrames_.empty())
      study.findings.push_back(
          phrase("%n {slice|slices} of the study in another frame of reference left out (series %2)",
                 otherFrames_.size(), seriesOf(otherFrames_)));
    if (copies_ > 0)
      study.findings.push_back(
          phrase("%n {file is a copy|files are copies} of another one and left out", copies_));
    std::set<std::string> told;
    for (const DicomHeader& file : placeless_)
      if (file.studyUid == study.studyUid && told.insert(file.seriesUid).second)
        study.findings.push_back(
            phrase("Series %1 is left out: \"%2\" %3", labelOf(file), nameOfFile(file.file), file.notAScan));
    std::map<std::string, Text> still;
    for (const DicomHeader* file : uncounted_)
      still.emplace(file->seriesUid, labelOf(*file));
    for (const CineSlice& slice : study.slices)
      still.erase(slice.series);
    std::vector<Text> labels;
    for (const auto& [uid, label] : still)
      labels.push_back(label);
    if (!labels.empty())
      study.findings.push_back(phrase("%n {series|series} without the phases of a heart's cycle left out: %2",
                                      labels.size(), listOf(labels)));
  }

  static Text labelOf(const DicomHeader& file) {
    CineSlice slice;
    slice.number = file.seriesNumber;
    slice.description = file.description;
    return seriesLabel(slice);
  }

  static Text seriesOf(const std::vector<FoundSlice>& slices) {
    std::vector<Text> labels;
    for (const FoundSlice& found : slices)
      if (const Text label = seriesLabel(sliceOf(found));
          std::find(labels.begin(), labels.end(), label) == labels.end())
        labels.push_back(label);
    return listOf(std::move(labels));
  }

  std::filesystem::path root_;
  FrameList list_;
  std::vector<DamagedFile> damaged_;
  std::vector<DicomHeader> placeless_; ///< Files that are no slices.
  std::size_t copies_ = 0;
  std::vector<FoundSlice> slices_, otherStudies_, otherFrames_;
  std::set<const DicomHeader*> uncounted_; ///< Of places without phases; a file of each.
};

} // namespace

std::optional<CineStudy> dicomCine(const std::filesystem::path& root,
                                   const std::vector<std::filesystem::path>& files, Progress& progress,
                                   const CineOptions& options) {
  return StudyReader(root, readDicomHeaders(files, progress, kHeaderPart)).run(progress, options);
}

} // namespace viscera::medical_io
