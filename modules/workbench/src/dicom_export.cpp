#include "viscera/workbench/dicom_export.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "viscera/anatomy/part.h"
#include "viscera/core/arrays.h"
#include "viscera/core/error.h"
#include "viscera/core/output_folder.h"
#include "viscera/geometry/volume.h"

namespace viscera::workbench {
namespace {

constexpr std::size_t kShortestPart = 4; ///< Letters of a name that is taken out of longer words, too.
constexpr const char* kDateOfNothing = "19000101000000";
constexpr double kMsOfSecond = 1000;

/// One series for each kind of object.
enum SeriesNumber { kSegmentations = 901, kReports, kSurfaces, kContours, kDocuments };

std::string asciiLowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(c < 0x80 ? std::tolower(c) : c); });
  return text;
}

bool isLetter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || (c & '\x80') != 0;
}

/// Longest first, so that no rest of a longer one stays.
std::vector<std::string> privateWords(const clinic::StudyIdentity& identity,
                                      const std::vector<std::string>& more) {
  std::vector<std::string> words = {identity.patientId,       identity.birthDate, identity.studyId,
                                    identity.accessionNumber, identity.studyDate, identity.studyDescription};
  std::vector<std::string> names = {identity.patientName, identity.referringPhysician};
  names.insert(names.end(), more.begin(), more.end());
  for (const std::string& name : names) {
    std::string part;
    for (const char c : name + ' ') {
      if (isLetter(c)) {
        part += c;
        continue;
      }
      words.push_back(std::exchange(part, {}));
    }
  }
  std::erase_if(words, [](const std::string& word) { return word.size() < 2; });
  for (std::string& word : words)
    word = asciiLowered(std::move(word));
  std::sort(words.begin(), words.end(),
            [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
  return words;
}

std::string withoutWords(std::string text, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    std::size_t from = 0;
    for (;;) {
      const std::size_t at = asciiLowered(text).find(word, from);
      if (at == std::string::npos)
        break;
      const std::size_t end = at + word.size();
      const bool alone = (at == 0 || !isLetter(text[at - 1])) && (end == text.size() || !isLetter(text[end]));
      if (alone || word.size() >= kShortestPart)
        text.erase(at, word.size());
      else
        from = end;
    }
  }
  for (std::size_t at = text.find("()"); at != std::string::npos; at = text.find("()"))
    text.erase(at, 2); // What was in brackets is gone.
  std::string tidy;    // No two spaces, none at the ends.
  for (const char c : text)
    if (c != ' ' || (!tidy.empty() && tidy.back() != ' '))
      tidy += c;
  while (!tidy.empty() && !isLetter(tidy.back()) && tidy.back() != ')')
    tidy.pop_back();
  tidy.erase(0, static_cast<std::size_t>(std::find_if(tidy.begin(), tidy.end(), isLetter) - tidy.begin()));
  return tidy;
}

/// The cavity of a ventricle, as the report has it: no wall and no muscle.
bool isVentricle(const std::string& name) {
  const std::optional<anatomy::Part> chamber = anatomy::chamberNamed(name);
  return chamber == anatomy::kLeftVentricle || chamber == anatomy::kRightVentricle;
}

class Exporter {
public:
  Exporter(const std::filesystem::path& folder, const DicomExport& what, Progress& progress)
      : what_(what), progress_(progress), folder_(folder), identity_(what.identity),
        dateTime_(what.withoutIdentity || what.dateTime.empty() ? kDateOfNothing : what.dateTime) {
    if (what.withoutIdentity) {
      words_ = privateWords(what.identity, what.alsoPrivate);
      identity_ =
          clinic::withoutIdentity(what.identity, what.secret.empty() ? clinic::newUid() : what.secret);
    }
    nameOrgans();
    for (const ExportedPhase& phase : what.phases) {
      auto& surfaces = surfaces_.emplace_back();
      for (std::size_t i = 0; i < what.organs.size(); ++i) {
        surfaces.push_back(*what.organs[i].mesh);
        surfaces.back().points = phase.points[i];
      }
    }
  }

  std::vector<DicomFile> write() {
    const DicomKinds& kinds = what_.kinds;
    if (kinds.segmentation)
      grid_ = grid();
    const int count = static_cast<int>(what_.phases.size());
    const clinic::ObjectSeries segmentations = series(kSegmentations, "Organs of Viscera"),
                               reports = series(kReports, "Measurements of Viscera");
    for (int phase = 0; phase < count; ++phase)
      runPart(progress_, 0.9 * phase / count, 0.9 * (phase + 1) / count, [&](Progress& part) {
        std::optional<clinic::WrittenObject> segmentation;
        if (kinds.segmentation)
          segmentation = writeSegments(segmentations, phase, part);
        part.throwIfCancelled();
        if (kinds.measurements)
          writeNumbers(reports, segmentation, phase);
      });
    if (kinds.surfaces)
      writeSurfaces();
    if (kinds.contours) {
      const auto file = place("contours.dcm");
      add(file, "contours", 0,
          clinic::writeStructureSet(file, identity_, at(series(kContours, "Contours of Viscera"), 0),
                                    organs(0), progress_));
    }
    if (kinds.document)
      writeDocument();
    progress_.throwIfCancelled();
    folder_.keep();
    progress_.report(1);
    return std::move(files_);
  }

private:
  /// No object takes the place of a file.
  std::filesystem::path place(const std::string& name) {
    const bool taken = folder_.has(name);
    std::filesystem::path file = folder_.place(name);
    if (taken)
      throw CannotCreateError("the file is there already", file.string(), "choose an empty folder");
    return file;
  }

  void nameOrgans() {
    std::set<std::string> taken;
    for (std::size_t i = 0; i < what_.organs.size(); ++i) {
      std::string name = withoutWords(what_.organs[i].name, words_);
      if (name.empty())
        name = "Organ " + std::to_string(i + 1);
      const std::string stem = name;
      for (int number = 2; !taken.insert(name).second; ++number)
        name = stem + " " + std::to_string(number);
      names_.push_back(name);
      trackingUids_.push_back(clinic::uidFrom(identity_.frameOfReference + ' ' + name, "organ of Viscera"));
    }
  }

  clinic::ObjectSeries series(int number, const char* description) const {
    clinic::ObjectSeries made;
    made.seriesUid = clinic::newUid();
    made.number = number;
    made.description = description;
    made.dateTime = dateTime_;
    return made;
  }
  clinic::ObjectSeries at(clinic::ObjectSeries made, int phase, int instance = 1) const {
    made.instanceUid = clinic::newUid();
    made.instance = instance;
    made.note = note(phase);
    return made;
  }

  std::string note(int phase) const {
    if (what_.phases.size() < 2)
      return {};
    const double ms = kMsOfSecond * what_.phases[static_cast<std::size_t>(phase)].seconds;
    return "phase " + std::to_string(phase + 1) + " of " + std::to_string(what_.phases.size()) + ", " +
           std::to_string(std::lround(ms)) + " ms";
  }

  std::vector<clinic::WrittenOrgan> organs(int phase) const {
    std::vector<clinic::WrittenOrgan> list;
    for (std::size_t i = 0; i < what_.organs.size(); ++i)
      list.push_back({names_[i], what_.organs[i].color, &surfaces_[static_cast<std::size_t>(phase)][i]});
    return list;
  }

  clinic::WrittenGrid grid() const {
    if (identity_.images.size() > 1)
      return clinic::gridOfImages(identity_);
    std::vector<clinic::WrittenOrgan> all;
    for (int phase = 0; phase < static_cast<int>(what_.phases.size()); ++phase)
      for (const clinic::WrittenOrgan& organ : organs(phase))
        all.push_back(organ);
    return clinic::gridAround(all, what_.spacingMm);
  }

  std::string fileName(const std::string& stem, int phase) const {
    const std::string number = std::to_string(phase + 1);
    return stem + (what_.phases.size() < 2 ? "" : "_phase_" + std::string(number.size() < 2, '0') + number) +
           ".dcm";
  }

  double milliliters(int phase, std::size_t organ) const {
    const geometry::TriangleMesh& mesh = surfaces_[static_cast<std::size_t>(phase)][organ];
    return std::abs(geometry::volume(mesh.points, mesh.triangles)) / kMm3PerMl;
  }

  clinic::WrittenObject writeSegments(const clinic::ObjectSeries& base, int phase, Progress& progress) {
    const auto file = place(fileName("segmentation", phase));
    const clinic::WrittenObject object = clinic::writeSegmentation(
        file, identity_, at(base, phase, phase + 1), grid_, organs(phase), progress);
    add(file, "segmentation", phase, object);
    return object;
  }

  void writeNumbers(const clinic::ObjectSeries& base,
                    const std::optional<clinic::WrittenObject>& segmentation, int phase) {
    std::vector<clinic::MeasuredOrgan> measured;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      clinic::MeasuredOrgan organ;
      organ.name = names_[i];
      organ.trackingUid = trackingUids_[i];
      if (segmentation)
        organ.segment = static_cast<int>(i) + 1;
      organ.timePoint = note(phase);
      organ.measurements.push_back({clinic::quantities::kVolume, milliliters(phase, i), "ml", "milliliter",
                                    "volume within the surface"});
      measured.push_back(std::move(organ));
    }
    if (phase == 0) {
      appendCycle(measured);
      for (clinic::MeasuredOrgan finding : what_.findings) {
        finding.name = withoutWords(finding.name, words_);
        if (finding.name.empty())
          finding.name = "Finding";
        measured.push_back(std::move(finding));
      }
    }
    const auto file = place(fileName("measurements", phase));
    add(file, "measurements", phase,
        clinic::writeMeasurementReport(file, identity_, at(base, phase, phase + 1), segmentation, measured));
  }

  /// Largest and smallest volume of a ventricle's cavity over the phases, and what follows from them.
  void appendCycle(std::vector<clinic::MeasuredOrgan>& measured) const {
    const int count = static_cast<int>(what_.phases.size());
    for (std::size_t i = 0; count > 1 && i < names_.size(); ++i) {
      if (!isVentricle(what_.organs[i].name))
        continue;
      double largest = milliliters(0, i), smallest = largest;
      for (int phase = 1; phase < count; ++phase) {
        const double ml = milliliters(phase, i);
        largest = std::max(largest, ml);
        smallest = std::min(smallest, ml);
      }
      if (!(smallest > 0))
        continue;
      clinic::MeasuredOrgan cycle;
      cycle.name = names_[i];
      cycle.trackingUid = trackingUids_[i];
      const std::string method = "extremes of " + std::to_string(count) + " phases";
      using namespace clinic::quantities;
      cycle.measurements = {
          {kEndDiastolicVolume, largest, "ml", "milliliter", method},
          {kEndSystolicVolume, smallest, "ml", "milliliter", method},
          {kStrokeVolume, largest - smallest, "ml", "milliliter", method},
          {kEjectionFraction, 100 * (largest - smallest) / largest, "%", "percent", method}};
      measured.push_back(std::move(cycle));
    }
  }

  void writeSurfaces() {
    const clinic::ObjectSeries base = series(kSurfaces, "Surfaces of Viscera");
    const std::vector<clinic::WrittenOrgan> list = organs(0);
    for (std::size_t i = 0; i < list.size(); ++i) {
      progress_.throwIfCancelled();
      const auto file = place("surface_" + std::to_string(i + 1) + ".dcm");
      add(file, "surface", 0,
          clinic::writeSurfaceObject(file, identity_, at(base, 0, static_cast<int>(i) + 1), list[i]));
      files_.back().organ = list[i].name;
    }
  }

  void writeDocument() {
    const std::string lowered = asciiLowered(what_.pdf);
    for (const std::string& word : words_)
      if (word.size() >= kShortestPart && lowered.find(word) != std::string::npos)
        throw DataError("The report holds the patient's name or number", {}, "leave the report out");
    std::string title = withoutWords(what_.pdfTitle, words_);
    if (title.empty())
      title = "Report";
    const auto file = place("report.dcm");
    add(file, "document", 0,
        clinic::writeDocumentObject(file, identity_, at(series(kDocuments, "Report of Viscera"), 0), title,
                                    what_.pdf));
  }

  void add(const std::filesystem::path& file, const char* kind, int phase, clinic::WrittenObject object) {
    DicomFile one;
    one.file = file;
    one.kind = kind;
    one.phase = phase;
    one.object = std::move(object);
    files_.push_back(std::move(one));
  }

  const DicomExport& what_;
  Progress& progress_;
  OutputFolder folder_;
  clinic::StudyIdentity identity_;
  std::string dateTime_;
  std::vector<std::string> words_, names_, trackingUids_;
  std::vector<std::vector<geometry::TriangleMesh>> surfaces_; ///< By phase and organ.
  clinic::WrittenGrid grid_;
  std::vector<DicomFile> files_;
};

} // namespace

std::string withoutPrivateWords(const std::string& text, const clinic::StudyIdentity& identity,
                                const std::vector<std::string>& alsoPrivate) {
  return withoutWords(text, privateWords(identity, alsoPrivate));
}

std::vector<DicomFile> writeDicomExport(const std::filesystem::path& folder, const DicomExport& what,
                                        Progress& progress) {
  const DicomKinds& kinds = what.kinds;
  if (!kinds.segmentation && !kinds.measurements && !kinds.surfaces && !kinds.contours && !kinds.document)
    throw UsageError("No DICOM object is chosen", {}, "choose one at least");
  if (what.organs.empty() || what.phases.empty())
    throw DataError("There is no organ to write");
  if (kinds.document && what.withoutIdentity && !what.pdfIsAnonymous)
    throw DataError("The report names the patient or the files, and identity is to be removed", {},
                    "leave the report out, or make one without the patient");
  return Exporter(folder, what, progress).write();
}

} // namespace viscera::workbench
