#include "dicom/slice_stack.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <utility>

#include "viscera/core/phrase.h"

#include "file_bytes.h"

namespace viscera::medical_io {
namespace {

constexpr double kSameSliceDirection = 1e-3; ///< Of unit vectors.
constexpr double kSamePixelSpacing = 1e-3;   ///< Of pixels, relative.
constexpr double kEven = 0.01;               ///< Of the distance of slices.
/// Many scanners write positions with two digits; that is no unevenness as long as slices are not as close.
constexpr double kRoundedMm = 0.0101, kMostOfRounding = 0.05;
constexpr double kSamePlaceMm = 1e-3;
/// Tilts below this angle come from rounded directions, and so does a shift below this part of a pixel.
constexpr double kLeastTiltDegrees = 0.05, kLeastShift = 0.1;
/// How far a gap is off a multiple of the distance to be missing slices.
constexpr double kWholeNumber = 0.05;
constexpr std::size_t kMostNamed = 3; ///< Gaps that are named one by one.
/// A grid of resampled slices has at most so many for each one that was measured.
constexpr std::size_t kMostResampled = 4;
constexpr double kMsPerSecond = 1000;

Text shortNumber(double value) {
  return inDigits(value, 4);
}

/// "z = -120 mm", along the axis of the patient that the slices are stacked on most.
Text placeOf(const DicomFrame& frame) {
  Eigen::Index axis = 0;
  frame.normal().cwiseAbs().maxCoeff(&axis);
  return phrase("%1 = %2 mm", std::string(1, "xyz"[axis]), shortNumber(frame.position[axis]));
}

std::string sizeOf(const DicomHeader& file) {
  return std::to_string(file.columns) + " x " + std::to_string(file.rows);
}

bool near(double a, double b, double relative) {
  return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b));
}

class Grouping {
public:
  explicit Grouping(const FrameList& list) : list_(list) {}

  bool together(std::size_t a, std::size_t b) const {
    const DicomFrame &x = list_.frames[a], &y = list_.frames[b];
    const DicomHeader &f = list_.files[x.file], &g = list_.files[y.file];
    return sameSize(f, g) && sameDirections(x, y) && near(x.betweenRows, y.betweenRows, kSamePixelSpacing) &&
           near(x.betweenColumns, y.betweenColumns, kSamePixelSpacing) && x.echo == y.echo;
  }

  static bool sameSize(const DicomHeader& f, const DicomHeader& g) {
    return f.rows == g.rows && f.columns == g.columns;
  }
  static bool sameDirections(const DicomFrame& x, const DicomFrame& y) {
    return (x.row - y.row).norm() <= kSameSliceDirection &&
           (x.column - y.column).norm() <= kSameSliceDirection;
  }

  /// Why the slices of `other` are not in `group`.
  ScanFinding difference(const SliceGroup& group, const SliceGroup& other) const {
    const DicomFrame &x = list_.frames[group.frames[0]], &y = list_.frames[other.frames[0]];
    const DicomHeader &f = list_.files[x.file], &g = list_.files[y.file];
    const std::size_t count = other.frames.size();
    if (!sameSize(f, g))
      return {ScanFinding::Kind::mixedSizes, phrase("The series has images of several sizes: %n "
                                                    "{image|images} of %2 left out, those of %3 read",
                                                    count, sizeOf(g), sizeOf(f))};
    if (!sameDirections(x, y))
      return {ScanFinding::Kind::other,
              phrase("%n {image|images} in the series that {lies|lie} in another direction left out", count)};
    if (x.echo != y.echo)
      return {ScanFinding::Kind::other,
              phrase("%n {image|images} in the series of another echo left out", count)};
    return {ScanFinding::Kind::mixedSizes,
            phrase("The series has pixels of several sizes: %n {image|images} of %2 mm left out, those "
                   "of %3 mm read",
                   count, shortNumber(y.betweenColumns), shortNumber(x.betweenColumns))};
  }

private:
  const FrameList& list_;
};

/// The value that distinguishes phases, by one of several criteria.
using TimeOf = std::optional<double> DicomFrame::*;

/// Slices by their position, from the lowest to the highest.
std::vector<std::vector<std::size_t>> byPlace(const FrameList& list, std::vector<std::size_t> frames) {
  const Vec3 normal = list.frames[frames[0]].normal();
  const auto height = [&](std::size_t f) { return normal.dot(list.frames[f].position); };
  std::stable_sort(frames.begin(), frames.end(),
                   [&](std::size_t a, std::size_t b) { return height(a) < height(b); });
  std::vector<std::vector<std::size_t>> places;
  for (const std::size_t f : frames) {
    if (places.empty() || height(f) - height(places.back().front()) > kSamePlaceMm)
      places.emplace_back();
    places.back().push_back(f);
  }
  return places;
}

/// Whether that time is known for all slices and differs among those at each place.
bool tellsApart(const FrameList& list, const std::vector<std::vector<std::size_t>>& places, TimeOf time) {
  for (const auto& place : places) {
    std::set<double> times;
    for (const std::size_t f : place)
      if (const auto at = list.frames[f].*time)
        times.insert(*at);
    if (times.size() != place.size())
      return false;
  }
  return true;
}

/// The times of phases in ms from the first on, or their numbers.
void setTimes(const FrameList& list, std::vector<SlicePhase>& phases, std::vector<ScanFinding>& findings) {
  const auto timesBy = [&](TimeOf member, double unit) {
    std::vector<double> times;
    for (const SlicePhase& phase : phases)
      if (const auto at = list.frames[phase.frames[0]].*member)
        times.push_back(unit * *at);
    for (std::size_t i = 1; i < times.size(); ++i)
      if (!(times[i] > times[i - 1]))
        return false;
    if (times.size() != phases.size())
      return false;
    for (std::size_t i = 0; i < phases.size(); ++i)
      phases[i].timeMs = times[i] - times[0];
    return true;
  };
  if (timesBy(&DicomFrame::triggerMs, 1) || timesBy(&DicomFrame::acquisitionSeconds, kMsPerSecond))
    return;
  const auto step = list.files[list.frames[phases[0].frames[0]].file].temporalResolutionMs;
  for (std::size_t i = 0; i < phases.size(); ++i)
    phases[i].timeMs = step.value_or(1) * double(i);
  if (!step)
    findings.push_back(
        {ScanFinding::Kind::other,
         phrase("It does not say the times of its %n {phase|phases}; they are numbered", phases.size())});
}

/// Phases by the times that the slices at each position state.
std::vector<SlicePhase> phasesBy(std::vector<std::vector<std::size_t>> places,
                                 const std::function<bool(std::size_t, std::size_t)>& before) {
  std::vector<SlicePhase> phases(places[0].size());
  for (auto& place : places) {
    std::stable_sort(place.begin(), place.end(), before);
    for (std::size_t phase = 0; phase < place.size(); ++phase)
      phases[phase].frames.push_back(place[phase]);
  }
  return phases;
}

/// Slices with different temporal positions are different phases, even when one of them lacks slices.
std::vector<SlicePhase> phasesByPosition(const FrameList& list, const std::vector<std::size_t>& frames) {
  std::map<double, SlicePhase> byTime;
  for (const std::size_t f : frames) {
    if (!list.frames[f].temporalPosition)
      return {};
    byTime[*list.frames[f].temporalPosition].frames.push_back(f);
  }
  std::vector<SlicePhase> phases;
  for (auto& [time, phase] : byTime)
    phases.push_back(std::move(phase));
  return phases;
}

/// Slices that state one of a few times, of which each is stated at half of the places at least: phases some
/// of which lack slices.
std::vector<SlicePhase> phasesByValue(const FrameList& list,
                                      const std::vector<std::vector<std::size_t>>& places, TimeOf time) {
  std::map<double, SlicePhase> byTime;
  for (const auto& place : places) {
    std::set<double> here;
    for (const std::size_t f : place) {
      const auto at = list.frames[f].*time;
      if (!at || !here.insert(*at).second)
        return {};
      byTime[*at].frames.push_back(f);
    }
  }
  std::vector<SlicePhase> phases;
  for (auto& [at, phase] : byTime) {
    if (2 * phase.frames.size() < places.size())
      return {};
    phases.push_back(std::move(phase));
  }
  return phases;
}

std::vector<std::size_t> withoutCopies(const FrameList& list, const std::vector<std::size_t>& frames,
                                       std::vector<ScanFinding>& findings) {
  std::set<std::string> seen;
  std::vector<std::size_t> kept;
  for (const std::size_t f : frames)
    if (list.frames[f].uid.empty() || seen.insert(list.frames[f].uid).second)
      kept.push_back(f);
  if (kept.size() < frames.size())
    findings.push_back({ScanFinding::Kind::doubledSlice,
                        phrase("%n {file is a copy|files are copies} of another one and left out",
                               frames.size() - kept.size())});
  return kept;
}

Vec3 stepOf(const FrameList& list, const std::vector<std::size_t>& slices, std::size_t gap) {
  return list.frames[slices[gap + 1]].position - list.frames[slices[gap]].position;
}

bool sameStep(const Vec3& a, const Vec3& b) {
  const double length = std::max(a.norm(), b.norm());
  return (a - b).norm() <= std::max(kEven * length, std::min(kRoundedMm, kMostOfRounding * length));
}

/// All parts whose steps are equal, from the lowest; neighbours share a slice.
std::vector<SlicePart> evenRuns(const FrameList& list, const std::vector<std::size_t>& slices) {
  std::vector<SlicePart> runs;
  for (std::size_t first = 0; first + 1 < slices.size();) {
    const Vec3 step = stepOf(list, slices, first);
    std::size_t last = first + 1;
    while (last + 1 < slices.size() && sameStep(stepOf(list, slices, last), step))
      ++last;
    runs.push_back({first, last});
    first = last;
  }
  if (runs.empty())
    runs.push_back({0, 0});
  return runs;
}

/// The longest even part, the lowest of several, and then the others that have two equal steps.
std::vector<SlicePart> evenParts(const FrameList& list, const std::vector<std::size_t>& slices) {
  std::vector<SlicePart> parts = evenRuns(list, slices);
  const auto longest = std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return a.last - a.first < b.last - b.first;
  });
  std::rotate(parts.begin(), longest, longest + 1);
  parts.erase(std::remove_if(parts.begin() + 1, parts.end(),
                             [](const SlicePart& part) { return part.last - part.first < 2; }),
              parts.end());
  return parts;
}

ScanFinding describeGap(const DicomFrame& below, double gap, double usual, std::size_t number) {
  const double times = gap / usual;
  const Text here = placeOf(below), apart = shortNumber(gap), instead = shortNumber(usual);
  const double missing = std::round(times) - 1;
  if (missing >= 1 && std::abs(times - std::round(times)) <= kWholeNumber)
    return {ScanFinding::Kind::missingSlice,
            phrase("%n {slice is|slices are} missing between slice %2 (%3) and the next, which are %4 mm "
                   "apart in place of %5 mm",
                   static_cast<std::int64_t>(missing), number + 1, here, apart, instead)};
  return {ScanFinding::Kind::unevenSpacing,
          phrase("The spacing is uneven between slice %1 (%2) and the next, which are %3 mm apart in place "
                 "of %4 mm (%5 %)",
                 number + 1, here, apart, instead, shortNumber(100 * std::abs(times - 1)))};
}

/// Names the gaps that end an even part.
void reportGaps(const FrameList& list, const std::vector<std::size_t>& slices, const SlicePart& part,
                std::vector<ScanFinding>& findings) {
  if (part.last - part.first + 1 == slices.size())
    return;
  const Vec3 step = stepOf(list, slices, part.first);
  std::vector<ScanFinding> found;
  for (std::size_t gap = 0; gap + 1 < slices.size(); ++gap) {
    const Vec3 here = stepOf(list, slices, gap);
    if (sameStep(here, step))
      continue;
    if (near(here.norm(), step.norm(), kEven))
      found.push_back({ScanFinding::Kind::unevenSpacing,
                       phrase("Slice %1 (%2) is shifted sideways against those below it", gap + 2,
                              placeOf(list.frames[slices[gap + 1]]))});
    else
      found.push_back(describeGap(list.frames[slices[gap]], here.norm(), step.norm(), gap));
  }
  const std::size_t more = found.size() > kMostNamed ? found.size() - kMostNamed : 0;
  found.resize(std::min(found.size(), kMostNamed));
  Text& last = found.back().sentence;
  if (more > 0)
    last = phrase("%1 and %2 more", last, more);
  findings.insert(findings.end(), found.begin(), found.end());
}

/// Says how many of the slices the scan has, where these are not all of them as they are.
void reportPart(const SliceStack& stack, std::vector<ScanFinding>& findings) {
  if (stack.part.resampled)
    findings.push_back({ScanFinding::Kind::resampled,
                        phrase("All %1 slices were resampled to a distance of %2 mm; values between two "
                               "slices are mixed from both",
                               stack.slices, shortNumber(stack.indexToLps.linear().col(2).norm()))});
  else if (stack.frames.size() < stack.slices)
    findings.push_back(
        {ScanFinding::Kind::partRead,
         phrase("%1 of %2 slices were read, slices %3 to %4, which are even; the others, or "
                "all of them resampled, can be chosen as a series",
                stack.frames.size(), stack.slices, stack.part.first + 1, stack.part.last + 1)});
}

/// One slice for each position: the first one there by its number.
std::vector<std::size_t> orderedSlices(const FrameList& list, const SlicePhase& phase,
                                       std::vector<ScanFinding>& findings) {
  std::vector<std::size_t> slices;
  std::vector<Text> doubled;
  for (const auto& place : byPlace(list, phase.frames)) {
    slices.push_back(*std::min_element(place.begin(), place.end(), [&](std::size_t a, std::size_t b) {
      return list.frames[a].instance < list.frames[b].instance;
    }));
    if (place.size() > 1)
      doubled.push_back(placeOf(list.frames[slices.back()]));
  }
  if (!doubled.empty())
    findings.push_back(
        {ScanFinding::Kind::doubledSlice,
         phrase(
             "%n {place has|places have} more than one slice (%2); the one with the lowest number was read",
             doubled.size(), doubled.size() > 1 ? phrase("%1, ...", doubled.front()) : doubled.front())});
  return slices;
}

/// Whether the files, in the order of their names, in which they are listed, go up or down through the
/// slices.
bool namesInOrder(const std::vector<std::size_t>& slices) {
  bool up = true, down = true;
  for (std::size_t i = 1; i < slices.size(); ++i) {
    up = up && slices[i] > slices[i - 1];
    down = down && slices[i] < slices[i - 1];
  }
  return up || down;
}

void reportTilt(const DicomFrame& frame, const Vec3& step, std::size_t steps,
                std::vector<ScanFinding>& findings) {
  const Vec3 normal = frame.normal();
  const double along = normal.dot(step);
  const Vec3 sideways = step - along * normal;
  const double degrees = std::atan2(sideways.norm(), std::abs(along)) * 180 / std::numbers::pi;
  if (degrees < kLeastTiltDegrees ||
      sideways.norm() * double(steps) < kLeastShift * std::min(frame.betweenRows, frame.betweenColumns))
    return;
  findings.push_back({ScanFinding::Kind::tilt, phrase("The slices are tilted by %1 degrees against the way "
                                                      "they are stacked (a tilted gantry); the shear is kept",
                                                      shortNumber(degrees))});
}

/// p(i, j, k) = p_0 + i d_c row + j d_r column + k step: the step between slices is as it is, not along the
/// normal, so that a tilted gantry's shear is kept.
Eigen::Affine3d stackGrid(const DicomFrame& frame, const Vec3& origin, const Vec3& step) {
  Eigen::Affine3d grid;
  grid.linear() << frame.row * frame.betweenColumns, frame.column * frame.betweenRows, step;
  grid.translation() = origin;
  grid.makeAffine();
  return grid;
}

SliceStack evenStack(const FrameList& list, const std::vector<std::size_t>& slices, const SlicePart& part) {
  SliceStack stack;
  stack.part = part;
  stack.slices = slices.size();
  reportGaps(list, slices, part, stack.findings);
  stack.frames.assign(slices.begin() + std::ptrdiff_t(part.first),
                      slices.begin() + std::ptrdiff_t(part.last) + 1);
  const DicomFrame &first = list.frames[stack.frames.front()], &last = list.frames[stack.frames.back()];
  const std::size_t steps = stack.frames.size() - 1;
  Vec3 step = first.normal() * (first.thickness > 0 ? first.thickness : 1);
  if (steps > 0) {
    step = (last.position - first.position) / double(steps);
    reportTilt(first, step, steps, stack.findings);
  } else if (!(first.thickness > 0)) {
    stack.findings.push_back({ScanFinding::Kind::other, "It does not say how thick its slice is; 1 mm is "
                                                        "assumed, so volumes in it are not measured"});
  }
  stack.indexToLps = stackGrid(first, first.position, step);
  return stack;
}

/// All slices on the grid of the longest even part, continued to both ends: slices of that part stay as they
/// are, and others are mixed from their neighbours. None when slices do not lie on one line.
std::optional<SliceStack> resampledStack(const FrameList& list, const std::vector<std::size_t>& slices,
                                         const SlicePart& longest) {
  const auto at = [&](std::size_t slice) -> const DicomFrame& { return list.frames[slices[slice]]; };
  const Vec3 normal = at(0).normal(), origin = at(0).position;
  const auto height = [&](std::size_t slice) { return normal.dot(at(slice).position - origin); };
  const std::size_t last = slices.size() - 1;
  const Vec3 slope = (at(last).position - origin) / height(last); // Of height 1 mm.
  for (std::size_t s = 0; s <= last; ++s)
    if ((at(s).position - origin - height(s) * slope).norm() >
        kLeastShift * std::min(at(0).betweenRows, at(0).betweenColumns))
      return std::nullopt;
  const double begin = height(longest.first);
  double step = (height(longest.last) - begin) / double(longest.last - longest.first);
  step = std::max(step, height(last) / double(kMostResampled * slices.size()));
  const double below = std::round(begin / step), above = std::round((height(last) - begin) / step);
  SliceStack stack;
  stack.part = {0, last, true};
  stack.slices = slices.size();
  stack.frames = slices;
  std::size_t under = 0;
  for (double k = -below; k <= above; ++k) {
    const double here = std::clamp(begin + k * step, 0.0, height(last));
    while (under + 2 <= last && height(under + 1) <= here)
      ++under;
    const double part = (here - height(under)) / (height(under + 1) - height(under));
    stack.mixes.push_back({under, std::clamp(part, 0.0, 1.0)});
  }
  stack.indexToLps = stackGrid(at(0), origin + (begin - below * step) * slope, step * slope);
  return stack;
}

} // namespace

std::vector<SliceGroup> groupFrames(const FrameList& list) {
  const Grouping grouping(list);
  std::map<std::string, std::vector<SliceGroup>> bySeries;
  for (std::size_t f = 0; f < list.frames.size(); ++f) {
    auto& groups = bySeries[list.files[list.frames[f].file].seriesUid];
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const SliceGroup& one) { return grouping.together(one.frames[0], f); });
    if (group == groups.end())
      group = groups.insert(groups.end(), SliceGroup{});
    group->frames.push_back(f);
  }
  std::vector<SliceGroup> all;
  for (auto& [uid, groups] : bySeries) {
    std::stable_sort(groups.begin(), groups.end(), [](const SliceGroup& a, const SliceGroup& b) {
      return a.frames.size() > b.frames.size();
    });
    for (std::size_t i = 0; i < groups.size(); ++i) {
      groups[i].ofSeries = static_cast<int>(i);
      for (std::size_t other = 0; other < groups.size(); ++other)
        if (other != i)
          groups[i].findings.push_back(grouping.difference(groups[i], groups[other]));
    }
    std::move(groups.begin(), groups.end(), std::back_inserter(all));
  }
  return all;
}

std::vector<SlicePhase> phasesOf(const FrameList& list, const SliceGroup& group,
                                 std::vector<ScanFinding>& findings) {
  const std::vector<std::size_t> frames = withoutCopies(list, group.frames, findings);
  const auto places = byPlace(list, frames);
  const std::size_t each = places[0].size();
  const bool even =
      std::all_of(places.begin(), places.end(), [&](const auto& p) { return p.size() == each; });
  if (places.size() == frames.size())
    return {{frames, 0}};
  std::vector<SlicePhase> phases = phasesByPosition(list, frames);
  if (phases.size() > 1) {
    setTimes(list, phases, findings);
    return phases;
  }
  phases.clear();
  for (const TimeOf time : {&DicomFrame::triggerMs, &DicomFrame::percent, &DicomFrame::acquisitionSeconds})
    if (phases.empty() && even && tellsApart(list, places, time))
      phases = phasesBy(
          places, [&](std::size_t a, std::size_t b) { return list.frames[a].*time < list.frames[b].*time; });
  for (const TimeOf time : {&DicomFrame::percent, &DicomFrame::triggerMs})
    if (phases.empty() && !even)
      phases = phasesByValue(list, places, time);
  if (phases.empty())
    return {{frames, 0}};
  setTimes(list, phases, findings);
  return phases;
}

std::vector<SliceStack> stackSlices(const FrameList& list, const SlicePhase& phase) {
  std::vector<ScanFinding> common;
  const std::vector<std::size_t> slices = orderedSlices(list, phase, common);
  if (!namesInOrder(slices))
    common.push_back({ScanFinding::Kind::order, "The files' names are not in the order of the slices; they "
                                                "were put in order by position"});
  std::vector<SliceStack> stacks;
  const std::vector<SlicePart> parts = evenParts(list, slices);
  for (const SlicePart& part : parts)
    stacks.push_back(evenStack(list, slices, part));
  if (stacks.front().frames.size() < slices.size())
    if (auto all = resampledStack(list, slices, parts.front()))
      stacks.push_back(std::move(*all));
  for (SliceStack& stack : stacks) {
    std::vector<ScanFinding> own = std::exchange(stack.findings, {});
    reportPart(stack, stack.findings);
    stack.findings.insert(stack.findings.end(), common.begin(), common.end());
    stack.findings.insert(stack.findings.end(), own.begin(), own.end());
  }
  return stacks;
}

} // namespace viscera::medical_io
