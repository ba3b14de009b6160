#include "viscera/live/cine_draft.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/live/motion_series.h"

namespace viscera::live {
namespace {

namespace fs = std::filesystem;
using medical_io::CineImage;
using medical_io::CineSlice;

/// The part of the cycle in which hearts are emptiest, from the slowest to the fastest.
constexpr double kEarliestSystole = 0.2, kLatestSystole = 0.66;
/// The middle of a picture's sides that is compared: the heart lies there, and limbs and air do not.
constexpr double kComparedPart = 0.6;
constexpr std::size_t kBesideSystole = 2; ///< Phases beside the emptiest one that still show it.

// ---- images -----------------------------------------------------------------------------------------------

/// The mean square by which two pictures differ around their middle.
double differenceOf(const CineImage& a, const CineImage& b) {
  const Eigen::Index rows = a.rows(), columns = a.cols();
  if (b.rows() != rows || b.cols() != columns)
    return 0;
  const auto height = std::max<Eigen::Index>(1, std::lround(kComparedPart * static_cast<double>(rows)));
  const auto width = std::max<Eigen::Index>(1, std::lround(kComparedPart * static_cast<double>(columns)));
  const auto first = a.block((rows - height) / 2, (columns - width) / 2, height, width).array();
  const auto second = b.block((rows - height) / 2, (columns - width) / 2, height, width).array();
  const auto apart = (first - second).isFinite().select(first - second, 0.0F);
  return static_cast<double>(apart.square().mean());
}

/// How much each of a slice's pictures differs from its first, 0 to 1, at `phases` parts of the cycle.
std::vector<double> differencesOf(const CineSlice& slice, std::size_t phases, Progress& progress) {
  std::vector<double> apart(phases, 0);
  try {
    const auto first = slice.image(slice.phaseAt(0));
    for (std::size_t phase = 0; phase < phases; ++phase) {
      progress.throwIfCancelled();
      const double part = static_cast<double>(phase) / static_cast<double>(phases);
      apart[phase] = differenceOf(*first, *slice.image(slice.phaseAt(part)));
    }
  } catch (const DataError&) {
    return {}; // The search for the motion says what is damaged.
  }
  const double most = *std::max_element(apart.begin(), apart.end());
  for (double& each : apart)
    each = most > 0 ? each / most : 0;
  return apart;
}

std::size_t emptiestOf(const medical_io::CineStudy& study, std::size_t phases, Progress& progress) {
  std::vector<double> apart(phases, 0);
  for (std::size_t i = 0; i < study.slices.size(); ++i) {
    progress.report(static_cast<double>(i) / static_cast<double>(study.slices.size()), "reading the images");
    if (study.slices[i].fractions.empty())
      continue;
    const std::vector<double> own = differencesOf(study.slices[i], phases, progress);
    for (std::size_t phase = 0; phase < own.size(); ++phase)
      apart[phase] += own[phase];
  }
  std::size_t best = 0;
  double most = 0;
  for (std::size_t phase = 1; phase + 1 < phases; ++phase) {
    const double part = static_cast<double>(phase) / static_cast<double>(phases);
    const double around = apart[phase - 1] + 2 * apart[phase] + apart[phase + 1];
    if (part < kEarliestSystole || part > kLatestSystole || around <= most)
      continue;
    most = around;
    best = phase;
  }
  return best;
}

std::optional<double> statedPeriod(const medical_io::CineStudy& study) {
  std::vector<double> intervals;
  for (const CineSlice& slice : study.slices)
    if (slice.interval > 0)
      intervals.push_back(slice.interval);
  if (intervals.empty())
    return std::nullopt;
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

// ---- names ------------------------------------------------------------------------------------------------

/// What a name says of its phase.
struct NamedPhase {
  std::optional<std::size_t> number;
  bool diastole = false, systole = false;

  bool saysSomething() const { return number || diastole || systole; }
};

/// The words of a name in small letters, numbers apart from letters: "frame", "14" of "Frame14".
std::vector<std::string> nameWords(const std::string& name) {
  std::vector<std::string> words;
  const auto kind = [](char c) {
    const auto u = static_cast<unsigned char>(c);
    return std::isdigit(u) != 0 ? 2 : std::isalpha(u) != 0 ? 1 : 0;
  };
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (kind(name[i]) == 0)
      continue;
    if (i == 0 || kind(name[i]) != kind(name[i - 1]))
      words.emplace_back();
    words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  return words;
}

std::optional<std::size_t> numberFrom(const std::string& word) {
  constexpr std::size_t kMostDigits = 6;
  return word.empty() || word.size() > kMostDigits || std::isdigit(static_cast<unsigned char>(word[0])) == 0
             ? std::nullopt
             : std::optional(static_cast<std::size_t>(std::stoul(word)));
}

NamedPhase namedPhase(const std::string& stem) {
  static const std::set<std::string> kDiastole = {"ed",        "edv",         "diastole",
                                                  "diastolic", "enddiastole", "enddiastolic"};
  static const std::set<std::string> kSystole = {"es",       "esv",        "systole",
                                                 "systolic", "endsystole", "endsystolic"};
  static const std::set<std::string> kBeforeNumber = {"phase", "frame", "ph", "time", "t"};
  const std::vector<std::string> words = nameWords(stem);
  NamedPhase named;
  for (std::size_t i = 0; i < words.size(); ++i) {
    named.diastole = named.diastole || kDiastole.contains(words[i]);
    named.systole = named.systole || kSystole.contains(words[i]);
    if (i > 0 && (kBeforeNumber.contains(words[i - 1]) || kDiastole.contains(words[i - 1]) ||
                  kSystole.contains(words[i - 1])))
      if (const auto number = numberFrom(words[i]))
        named.number = number;
  }
  // A number at the end counts, unless the name says its phase in words: "patient1_ed" is no phase 1.
  if (!named.number && !named.diastole && !named.systole && words.size() > 1)
    named.number = numberFrom(words.back());
  return named;
}

std::string stemOfLabels(const fs::path& file) {
  std::string stem = file.filename().string();
  for (const char* ending : {".gz", ".seg"})
    if (stem.ends_with(ending))
      stem.erase(stem.size() - std::string(ending).size());
  for (const char* ending : {".nii", ".nrrd", ".mha", ".mhd", ".nhdr", ".seg"})
    if (stem.ends_with(ending))
      stem.erase(stem.size() - std::string(ending).size());
  const std::string without = fs::path(stem).stem().string();
  return without.empty() ? stem : without;
}

NamedPhase namedPhaseOf(const fs::path& file) {
  const NamedPhase own = namedPhase(stemOfLabels(file));
  return own.saysSomething() || !file.has_parent_path() ? own
                                                        : namedPhase(file.parent_path().filename().string());
}

/// Whether the names count the first phase as 1: one of them counts past the last, or none says 0 while the
/// lowest is 1 or is the end of diastole with 1.
bool countFromOne(const std::vector<NamedPhase>& names, std::size_t phases) {
  std::optional<std::size_t> least;
  for (const NamedPhase& name : names) {
    if (!name.number)
      continue;
    if (*name.number == phases)
      return true;
    least = std::min(least.value_or(*name.number), *name.number);
  }
  return least == std::size_t{1};
}

Text fileName(const CineDraft::Labels& labels) {
  return labels.file.filename().string();
}

} // namespace

CineCycle cycleOf(const medical_io::CineStudy& study, const fs::path& place, Progress& progress) {
  CineCycle cycle;
  cycle.place = place;
  cycle.phases = phasesOf(study);
  cycle.periodSeconds = statedPeriod(study);
  if (cycle.phases > 0)
    cycle.emptiest = emptiestOf(study, cycle.phases, progress);
  progress.report(1);
  return cycle;
}

void CineDraft::setCycle(std::optional<CineCycle> cycle) {
  cycle_ = std::move(cycle);
  guess();
}

void CineDraft::add(std::vector<fs::path> files) {
  std::sort(files.begin(), files.end());
  for (fs::path& file : files)
    if (std::none_of(labels_.begin(), labels_.end(), [&](const Labels& each) { return each.file == file; }))
      labels_.push_back({std::move(file), std::nullopt, true});
  guess();
}

void CineDraft::remove(std::size_t row) {
  if (row >= labels_.size())
    throw UsageError(misuse("There is no file %1", row));
  labels_.erase(labels_.begin() + static_cast<std::ptrdiff_t>(row));
  guess();
}

void CineDraft::setPhase(std::size_t row, std::size_t phase) {
  if (row >= labels_.size())
    throw UsageError(misuse("There is no file %1", row));
  labels_[row].phase = phase;
  labels_[row].guessed = false;
}

void CineDraft::guess() {
  std::vector<NamedPhase> names;
  for (const Labels& each : labels_)
    names.push_back(namedPhaseOf(each.file));
  const std::size_t phases = cycle_ ? cycle_->phases : 0;
  const std::size_t first = countFromOne(names, phases) ? 1 : 0;
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    Labels& labels = labels_[i];
    if (!labels.guessed)
      continue;
    labels.phase.reset();
    if (names[i].number && *names[i].number >= first)
      labels.phase = *names[i].number - first;
    else if (names[i].diastole)
      labels.phase = 0;
    else if (names[i].systole && cycle_ && cycle_->emptiest > 0)
      labels.phase = cycle_->emptiest;
    if (labels.phase && phases > 0 && *labels.phase >= phases)
      labels.phase.reset();
  }
}

std::vector<std::size_t> CineDraft::labelled() const {
  std::set<std::size_t> phases;
  for (const Labels& each : labels_)
    if (each.phase)
      phases.insert(*each.phase);
  return {phases.begin(), phases.end()};
}

Text CineDraft::missing() const {
  if (!cycle_)
    return "Choose the images first";
  if (labels_.empty())
    return "Choose the labels of a phase: those of the ends of diastole and systole, where there are any";
  std::map<std::size_t, const Labels*> maps;
  for (const Labels& each : labels_) {
    if (!each.phase)
      return phrase("Enter the phase of %1", fileName(each));
    if (*each.phase >= cycle_->phases)
      return phrase("The images have %1 phases: enter another one for %2", cycle_->phases, fileName(each));
    const auto [known, isNew] = maps.emplace(*each.phase, &each);
    if (!isNew && seriesName(known->second->file.filename()).first == seriesName(each.file.filename()).first)
      return phrase("%1 and %2 are both labels of phase %3", fileName(*known->second), fileName(each),
                    *each.phase + 1);
  }
  return {};
}

Text CineDraft::remark() const {
  const std::vector<std::size_t> phases = labelled();
  if (!missing().empty())
    return {};
  if (phases.size() == 1)
    return phrase(
        "Only phase %1 has labels: the motion, its volumes and ejection fractions will be estimates. "
        "Label the end of systole too, if you can",
        phases.front() + 1);
  const std::size_t emptiest = cycle_->emptiest;
  const bool near = std::any_of(phases.begin(), phases.end(), [emptiest](std::size_t phase) {
    return phase + kBesideSystole >= emptiest && phase <= emptiest + kBesideSystole;
  });
  if (emptiest > 0 && !near)
    return phrase("The images differ most from the first phase in phase %1, which has no labels: see whether "
                  "the end of systole is labelled",
                  emptiest + 1);
  return {};
}

CineRequest CineDraft::request() const {
  if (const Text lacks = missing(); !lacks.empty())
    throw UsageError(lacks);
  CineRequest request;
  request.images = cycle_->place;
  request.firstPhase = 1;
  std::map<std::size_t, PhaseLabels> byPhase;
  for (const Labels& each : labels_) {
    PhaseLabels& labels = byPhase[*each.phase];
    labels.phase = *each.phase;
    labels.files.push_back(each.file);
  }
  for (auto& [phase, labels] : byPhase)
    request.labels.push_back(std::move(labels));
  return request;
}

} // namespace viscera::live
