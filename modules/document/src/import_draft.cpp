#include "viscera/document/import_draft.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/plausible_size.h"
#include "viscera/medical_io/surface_repairs.h"

namespace viscera::document {
namespace {

using medical_io::Finding;
using medical_io::FindingSeverity;
using medical_io::FindingSubject;

/// Whether a user who asks for this repair knows the axes.
bool changesAxes(const std::string& repair) {
  return repair == "ras-to-lps" || repair.starts_with("y-up") || repair.starts_with("flip-");
}

/// A resolution that is finer by less than this part is not worth another try.
constexpr double kFiner = 0.98;
/// Organs of people are not larger or smaller than those of the middle by as much as this, along a side.
constexpr double kNotOnePerson = 1.6;

std::string threeDigits(double value) {
  std::array<char, 32> digits{};
  const auto [end, error] =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 3);
  return {digits.data(), end};
}

/// Where no unit explains the size, the factor that leads to life size; and of a detail that was lost, the
/// resolution that may keep it.
void offerFactors(DraftOrgan& organ, bool labelMap) {
  auto& findings = organ.assessment.findings;
  for (Finding& finding : findings) {
    if (finding.subject != FindingSubject::size || finding.severity < FindingSeverity::doubt || labelMap)
      continue;
    const auto factor = medical_io::lifeSizeFactor(organ.name, organ.assessment.volumeMl);
    const bool far = factor && std::max(*factor, 1 / *factor) > kNotOnePerson;
    if (finding.repairs.empty() && far)
      finding.repairs.push_back("scale=" + threeDigits(*factor));
    if (finding.severity == FindingSeverity::fault || far)
      finding.repairs.emplace_back("scale");
  }
  const auto lost = organ.remade ? medical_io::doubtAbout(*organ.remade) : std::nullopt;
  if (!lost)
    return;
  std::vector<std::string> finer;
  if (organ.beforeRemesh) {
    const double finest = medical_io::finestResolutionMm(*organ.beforeRemesh);
    const double half = std::max(organ.resolutionMm / 2, finest);
    if (half < organ.resolutionMm * kFiner)
      finer.push_back("remesh=" + threeDigits(std::max(half, finest * (2 - kFiner))));
  }
  findings.push_back({FindingSeverity::doubt, *lost, std::move(finer), FindingSubject::detail});
}

/// `report` as in `assessSurface`; none: not known.
void assess(DraftOrgan& organ, const std::optional<geometry::SurfaceReport>& report, const OpenedFiles& files,
            std::size_t place, Progress& progress) {
  const auto read = files.surfaces.find(place);
  const bool labelMap = read == files.surfaces.end();
  const bool stated = labelMap || read->second.statedSpace ||
                      std::any_of(organ.repairs.begin(), organ.repairs.end(), changesAxes);
  const auto space = labelMap || !read->second.statedSpace ? std::optional(medical_io::Space::lps)
                                                           : read->second.statedSpace;
  const medical_io::SurfaceOrigin origin{organ.name, stated ? space : std::nullopt, labelMap,
                                         files.organs[place].cut};
  organ.answered.reset();
  organ.assessment = report ? medical_io::assessSurface(*organ.mesh, *report, origin, progress)
                            : medical_io::assessSurface(*organ.mesh, origin, progress);
  offerFactors(organ, labelMap);
}

bool remeshes(const std::string& id) {
  return id == "remesh" || id.starts_with("remesh=");
}

/// A remeshing after another one begins where that one did.
void takeBackRemesh(DraftOrgan& organ, const std::string& next) {
  if (!organ.beforeRemesh || !remeshes(next) || organ.repairs.empty())
    return;
  organ.mesh = organ.beforeRemesh;
  organ.repairs.pop_back();
}

void noteRemesh(DraftOrgan& organ, const std::string& id) {
  organ.beforeRemesh = remeshes(id) ? organ.mesh : nullptr;
  if (organ.beforeRemesh)
    organ.resolutionMm = id == "remesh" ? medical_io::usualResolutionMm(*organ.mesh)
                                        : std::strtod(id.c_str() + std::strlen("remesh="), nullptr);
}

void repair(DraftOrgan& organ, const medical_io::SurfaceRepair& what, Progress& progress) {
  takeBackRemesh(organ, what.id);
  auto mesh = std::make_shared<const geometry::TriangleMesh>(what.apply(*organ.mesh, progress, {}));
  noteRemesh(organ, what.id);
  organ.change = what.remakes ? std::optional(medical_io::surfaceChange(*organ.mesh, *mesh)) : std::nullopt;
  if (organ.change)
    organ.remade = organ.change;
  organ.mesh = std::move(mesh);
  organ.repairs.push_back(what.id);
  organ.refusal.reset();
}

/// The finding about the axes of an organ's file and its side.
Finding* axesFindingOf(DraftOrgan& organ) {
  auto& findings = organ.assessment.findings;
  const auto found = std::find_if(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.subject == FindingSubject::axes;
  });
  return found == findings.end() ? nullptr : &*found;
}

/// Where a file has its origin is its own affair: which side an organ is on, the other organs know better.
void answerSides(ImportDraft& draft, const std::vector<std::size_t>& places) {
  for (DraftOrgan& organ : draft.organs)
    if (Finding* finding = axesFindingOf(organ); finding && organ.answered)
      *finding = *std::exchange(organ.answered, std::nullopt);
  if (!draft.patient.sidesChecked())
    return;
  const auto& misplaced = draft.patient.misplaced;
  for (std::size_t i = 0; i < places.size(); ++i) {
    Finding* finding = axesFindingOf(draft.organs[places[i]]);
    const bool wrong = std::find(misplaced.begin(), misplaced.end(), i) != misplaced.end();
    if (wrong || !finding || finding->severity < FindingSeverity::doubt)
      continue;
    draft.organs[places[i]].answered = *finding;
    *finding = {FindingSeverity::good,
                "among the other organs it lies on the side that its name says",
                {},
                FindingSubject::axes};
  }
}

void assessTogether(ImportDraft& draft) {
  std::vector<medical_io::PlacedOrgan> placed;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < draft.organs.size(); ++i)
    if (const DraftOrgan& organ = draft.organs[i]; organ.included) {
      placed.push_back({organ.name, boundsOf(organ.mesh->points), organ.assessment.volumeMl});
      places.push_back(i);
    }
  draft.patient = medical_io::assessPatient(placed);
  draft.arrangement.reset();
  draft.size.reset();
  for (const Finding& finding : draft.patient.findings)
    (finding.subject == FindingSubject::size ? draft.size : draft.arrangement) = finding;
  answerSides(draft, places);
}

bool isIncluded(const ImportDraft& draft, std::size_t organ) {
  const int parent = draft.files.organs[organ].parentInBatch;
  return draft.organs[organ].included && (parent < 0 || isIncluded(draft, static_cast<std::size_t>(parent)));
}

std::string joined(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words)
    list += (list.empty() ? "" : ", ") + word;
  return list;
}

struct FoundIn {
  std::size_t organ;
  const Finding* finding;
};

/// A factor or a resolution is found for one organ, or asked for it.
bool isOfOneOrgan(const std::string& id) {
  return id == "scale" || id.starts_with("scale=") || id.starts_with("remesh=");
}

/// Repairs that every organ's finding names, in the order of the first.
std::vector<std::string> commonRepairs(const std::vector<FoundIn>& where) {
  std::vector<std::string> common = where.front().finding->repairs;
  for (const FoundIn& one : where)
    std::erase_if(common, [&](const std::string& id) {
      return isOfOneOrgan(id) ||
             std::count(one.finding->repairs.begin(), one.finding->repairs.end(), id) == 0;
    });
  return common;
}

/// The repair that most organs need first; none where no organ names one.
std::vector<std::string> commonestRepair(const std::vector<FoundIn>& where) {
  std::vector<std::pair<std::string, int>> votes;
  for (const FoundIn& one : where) {
    if (one.finding->repairs.empty() || isOfOneOrgan(one.finding->repairs.front()))
      continue;
    const std::string& id = one.finding->repairs.front();
    auto known = std::find_if(votes.begin(), votes.end(), [&](const auto& vote) { return vote.first == id; });
    if (known == votes.end())
      known = votes.insert(votes.end(), {id, 0});
    ++known->second;
  }
  const auto most = std::max_element(votes.begin(), votes.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == votes.end() ? std::vector<std::string>() : std::vector{most->first};
}

SharedFinding sharedBy(FindingSubject subject, const std::vector<FoundIn>& where) {
  SharedFinding shared;
  shared.subject = subject;
  for (const FoundIn& one : where) {
    shared.severity = std::max(shared.severity, one.finding->severity);
    shared.organs.push_back(one.organ);
  }
  shared.repairs = commonRepairs(where);
  shared.repairable = shared.organs;
  return shared;
}

/// One unit for the patient, where sizes of most organs are in doubt.
void unify(SharedFinding& size, const std::vector<FoundIn>& where, const ImportDraft& draft) {
  std::vector<std::size_t> read;
  for (std::size_t place = 0; place < draft.organs.size(); ++place)
    if (draft.organs[place].included && draft.files.surfaces.count(place) > 0)
      read.push_back(place);
  std::vector<std::string> unit = commonestRepair(where);
  if (2 * where.size() <= read.size() || unit.empty())
    return;
  size.repairs = std::move(unit);
  size.repairable = std::move(read);
  size.ofThePatient = true;
}

/// The organ with the draft's surface; its name, look and parent stay as read from the file.
Organ finished(const Organ& read, const DraftOrgan& organ) {
  if (organ.mesh == organ.asRead)
    return read;
  Organ result = makeOrgan(read.name, organ.mesh, organ.assessment.report);
  result.look = read.look;
  result.parent = read.parent;
  result.file = read.file;
  if (!organ.repairs.empty())
    result.warnings.push_back(phrase("repaired on import: %1", joined(organ.repairs)));
  if (organ.remade) {
    result.warnings.push_back(inWords(*organ.remade));
    if (auto lost = medical_io::doubtAbout(*organ.remade))
      result.warnings.push_back(std::move(*lost));
  }
  return result;
}

} // namespace

bool ImportDraft::questionable() const {
  return arrangement || size || std::any_of(organs.begin(), organs.end(), [](const DraftOrgan& organ) {
           return organ.included && organ.assessment.questionable();
         });
}

bool ImportDraft::empty() const {
  return !files.rig &&
         std::none_of(organs.begin(), organs.end(), [](const DraftOrgan& organ) { return organ.included; });
}

ImportDraft draftOf(OpenedFiles files, Progress& progress) {
  ImportDraft draft;
  draft.files = std::move(files);
  draft.organs.resize(draft.files.organs.size());
  const auto count = static_cast<Eigen::Index>(draft.organs.size());
  std::atomic<int> done{0};
  parallelRanges(count, 1, {}, [&](Eigen::Index place, Eigen::Index) {
    const auto i = static_cast<std::size_t>(place);
    const NewOrgan& item = draft.files.organs[i];
    progress.report(static_cast<double>(done++) / static_cast<double>(count),
                    phrase("Checking %1", named(item.organ.name)));
    const auto known = draft.files.surfaces.find(i);
    DraftOrgan& organ = draft.organs[i];
    organ.name = item.organ.name;
    organ.file = item.organ.file.filename().string();
    organ.asRead = known == draft.files.surfaces.end() ? item.organ.mesh : known->second.mesh;
    organ.mesh = organ.asRead;
    assess(organ, item.report, draft.files, i, progress);
  });
  assessTogether(draft);
  progress.report(1);
  return draft;
}

ImportDraft repaired(ImportDraft draft, const std::vector<std::size_t>& organs, const std::string& id,
                     Progress& progress) {
  const medical_io::SurfaceRepair what = medical_io::surfaceRepair(id);
  for (std::size_t done = 0; done < organs.size(); ++done) {
    DraftOrgan& organ = draft.organs.at(organs[done]);
    progress.report(static_cast<double>(done) / static_cast<double>(organs.size()),
                    phrase("Repairing %1", named(organ.name)));
    try {
      DraftOrgan mended = organ;
      repair(mended, what, progress);
      assess(mended, {}, draft.files, organs[done], progress);
      organ = std::move(mended);
    } catch (const DataError& error) {
      organ.refusal.emplace(error.problem(), organ.name, error.tryThis());
    }
  }
  assessTogether(draft);
  return draft;
}

ImportDraft reverted(ImportDraft draft, std::size_t place, Progress& progress) {
  DraftOrgan& organ = draft.organs.at(place);
  organ.mesh = organ.asRead;
  organ.repairs.clear();
  organ.change.reset();
  organ.remade.reset();
  organ.beforeRemesh.reset();
  organ.refusal.reset();
  assess(organ, draft.files.organs[place].report, draft.files, place, progress);
  assessTogether(draft);
  return draft;
}

ImportDraft withIncluded(ImportDraft draft, const std::vector<std::size_t>& organs, bool included) {
  for (const std::size_t organ : organs)
    draft.organs.at(organ).included = included;
  assessTogether(draft);
  return draft;
}

std::vector<SharedFinding> sharedFindings(const ImportDraft& draft) {
  std::map<FindingSubject, std::vector<FoundIn>> found;
  for (std::size_t place = 0; place < draft.organs.size(); ++place)
    if (draft.organs[place].included)
      for (const Finding& finding : draft.organs[place].assessment.findings)
        if (finding.severity >= FindingSeverity::doubt)
          found[finding.subject].push_back({place, &finding});
  std::vector<SharedFinding> shared;
  for (const auto& [subject, where] : found) {
    if (where.size() < 2)
      continue;
    shared.push_back(sharedBy(subject, where));
    if (subject == FindingSubject::size)
      unify(shared.back(), where, draft);
  }
  std::stable_sort(shared.begin(), shared.end(), [](const SharedFinding& a, const SharedFinding& b) {
    return std::pair(a.severity, a.organs.size()) > std::pair(b.severity, b.organs.size());
  });
  return shared;
}

OpenedFiles accepted(const ImportDraft& draft) {
  OpenedFiles files = draft.files;
  files.organs.clear();
  files.surfaces.clear();
  std::vector<int> places(draft.organs.size(), -1);
  for (std::size_t i = 0; i < draft.organs.size(); ++i) {
    if (!isIncluded(draft, i))
      continue;
    NewOrgan organ = draft.files.organs[i];
    organ.organ = finished(organ.organ, draft.organs[i]);
    if (organ.parentInBatch >= 0)
      organ.parentInBatch = places[static_cast<std::size_t>(organ.parentInBatch)];
    places[i] = static_cast<int>(files.organs.size());
    files.organs.push_back(std::move(organ));
  }
  return files;
}

} // namespace viscera::document
