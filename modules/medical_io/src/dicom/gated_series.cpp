#include "dicom/gated_series.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

namespace viscera::medical_io {
namespace {

constexpr double kSameHeightMm = 0.5, kSecondsInMs = 1e-3, kWholeCycle = 100;
/// A volume has so many slices at least, when its time alone tells it from others.
constexpr std::size_t kFewestSlices = 3;
/// Series of one place share this part of their slices at least; a damaged one lacks some.
constexpr double kSharedSlices = 0.5;
constexpr double kSamePart = 1e-6;

/// "30" of "CorCTA 0.75 B26f 30%", and the text before and behind it.
struct NamedPercent {
  double percent = 0;
  std::string others;
};

std::optional<NamedPercent> percentIn(const std::string& description) {
  const std::size_t mark = description.find('%');
  if (mark == std::string::npos)
    return std::nullopt;
  std::size_t end = mark;
  while (end > 0 && description[end - 1] == ' ')
    --end;
  std::size_t begin = end;
  while (begin > 0 && (std::isdigit(static_cast<unsigned char>(description[begin - 1])) != 0 ||
                       description[begin - 1] == '.'))
    --begin;
  double percent = -1;
  std::from_chars(description.data() + begin, description.data() + end, percent);
  if (begin == end || !(percent >= 0 && percent <= kWholeCycle))
    return std::nullopt;
  return NamedPercent{percent, description.substr(0, begin) + description.substr(mark)};
}

/// The value that all frames have; none where they differ or one has none.
std::optional<double> sharedBy(const FrameList& list, const std::vector<std::size_t>& frames,
                               std::optional<double> DicomFrame::*member) {
  const std::optional<double> first = list.frames[frames.front()].*member;
  const bool all = std::all_of(frames.begin(), frames.end(),
                               [&](std::size_t f) { return list.frames[f].*member == first; });
  return all ? first : std::nullopt;
}

const DicomHeader& fileOf(const FrameList& list, const std::vector<std::size_t>& frames) {
  return list.files[list.frames[frames.front()].file];
}

/// The part of the cycle, in percent, of frames of one phase.
std::optional<double> percentOf(const FrameList& list, const std::vector<std::size_t>& frames) {
  if (const auto stated = sharedBy(list, frames, &DicomFrame::percent))
    return stated;
  const auto found = percentIn(fileOf(list, frames).description);
  return found ? std::optional(found->percent) : std::nullopt;
}

/// The slices' heights along their normal, in steps within which places are the same.
std::set<long> heightsOf(const FrameList& list, const std::vector<std::size_t>& frames) {
  const Vec3 normal = list.frames[frames.front()].normal();
  std::set<long> heights;
  for (const std::size_t f : frames)
    heights.insert(std::lround(normal.dot(list.frames[f].position) / kSameHeightMm));
  return heights;
}

bool isOneVolume(const FrameList& list, const SliceGroup& group) {
  std::vector<ScanFinding> ignored;
  return phasesOf(list, group, ignored).size() == 1;
}

/// What series of one scan have in common; none for one that has no time of its own.
std::optional<std::string> gatedKey(const FrameList& list, const SliceGroup& group) {
  const DicomHeader& file = fileOf(list, group.frames);
  const DicomFrame& frame = list.frames[group.frames.front()];
  const bool transmitted = file.modality == "CT" || file.modality == "PT";
  const auto named = percentIn(file.description);
  const bool percent = named || sharedBy(list, group.frames, &DicomFrame::percent);
  const bool trigger = transmitted && group.frames.size() >= kFewestSlices &&
                       sharedBy(list, group.frames, &DicomFrame::triggerMs);
  if (!percent && !trigger)
    return std::nullopt;
  std::ostringstream key;
  key << file.studyUid << '|' << file.frameOfReference << '|' << file.modality << '|' << file.columns << '|'
      << file.rows << '|' << (percent ? "part" : "trigger") << '|'
      << (named ? named->others : file.description) << '|';
  for (const Vec3& vector : {frame.row, frame.column})
    for (int axis = 0; axis < 3; ++axis)
      key << std::lround(1e3 * vector[axis]) << ' ';
  key << std::lround(1e3 * frame.betweenColumns) << ' ' << std::lround(1e3 * frame.betweenRows) << ' '
      << frame.echo;
  return key.str();
}

/// The members that lie where the one with most slices lies.
std::vector<std::size_t> ofOnePlace(const FrameList& list, const std::vector<SliceGroup>& groups,
                                    const std::vector<std::size_t>& members) {
  const std::size_t largest = *std::max_element(members.begin(), members.end(), [&](auto a, auto b) {
    return groups[a].frames.size() < groups[b].frames.size();
  });
  const std::set<long> there = heightsOf(list, groups[largest].frames);
  std::vector<std::size_t> kept;
  for (const std::size_t member : members) {
    const std::set<long> own = heightsOf(list, groups[member].frames);
    const auto shared = static_cast<double>(std::count_if(own.begin(), own.end(), [&](long height) {
      return there.contains(height) || there.contains(height - 1) || there.contains(height + 1);
    }));
    if (shared >= kSharedSlices * double(there.size()))
      kept.push_back(member);
  }
  return kept;
}

/// Ascending in time, one of each time: the one with most slices, then the earlier one in the list.
GatedSeries inOrder(const FrameList& list, const std::vector<SliceGroup>& groups,
                    const std::vector<std::size_t>& members) {
  std::map<double, std::size_t> byTime;
  for (const std::size_t member : members) {
    const auto& frames = groups[member].frames;
    const auto percent = percentOf(list, frames);
    const double time = percent ? *percent : sharedBy(list, frames, &DicomFrame::triggerMs).value_or(0);
    const auto [known, isNew] = byTime.emplace(time, member);
    if (!isNew && groups[known->second].frames.size() < frames.size())
      known->second = member;
  }
  GatedSeries series;
  for (const auto& [time, member] : byTime) {
    series.groups.push_back(member);
    series.phases.push_back({groups[member].frames, time - byTime.begin()->first});
  }
  return series;
}

double medianInterval(const FrameList& list, const std::vector<SlicePhase>& phases) {
  std::vector<double> intervals;
  for (const SlicePhase& phase : phases)
    if (const auto interval = list.frames[phase.frames.front()].intervalMs; interval && *interval > 0)
      intervals.push_back(*interval);
  if (intervals.empty())
    return 0;
  const auto middle = intervals.begin() + std::ptrdiff_t(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

/// The times of all phases by one criterion; empty where one has none.
template <class TimeOfPhase>
std::vector<double> timesOfAll(const std::vector<SlicePhase>& phases, const TimeOfPhase& timeOf) {
  std::vector<double> times;
  for (const SlicePhase& phase : phases)
    if (const std::optional<double> time = timeOf(phase))
      times.push_back(*time);
  return times.size() == phases.size() ? times : std::vector<double>();
}

/// Parts of the cycle by milliseconds; the stated interval counts where the times fit into it.
std::vector<double> partsOfMs(const std::vector<double>& times, double statedMs, TimedVolumes& volumes) {
  const auto [first, last] = std::minmax_element(times.begin(), times.end());
  const double span = *last - *first, count = double(times.size());
  const double cycle = statedMs > span ? statedMs : span / (count - 1) * count;
  const double begin = *first >= 0 && *last < cycle ? 0 : *first;
  volumes.periodSeconds = isCycle(kSecondsInMs * cycle) ? kSecondsInMs * cycle : 0;
  std::vector<double> parts;
  for (const double time : times)
    parts.push_back((time - begin) / cycle);
  return parts;
}

std::vector<double> partsOf(const FrameList& list, const std::vector<SlicePhase>& phases,
                            TimedVolumes& volumes) {
  const double statedMs = medianInterval(list, phases);
  const auto percents =
      timesOfAll(phases, [&](const SlicePhase& one) { return percentOf(list, one.frames); });
  if (std::set<double>(percents.begin(), percents.end()).size() > 1) {
    volumes.periodSeconds = isCycle(kSecondsInMs * statedMs) ? kSecondsInMs * statedMs : 0;
    std::vector<double> parts;
    for (const double percent : percents)
      parts.push_back(std::fmod(std::max(percent, 0.0) / kWholeCycle, 1.0));
    return parts;
  }
  auto times =
      timesOfAll(phases, [&](const SlicePhase& one) { return list.frames[one.frames.front()].triggerMs; });
  if (std::set<double>(times.begin(), times.end()).size() < 2)
    times = timesOfAll(phases, [](const SlicePhase& one) { return std::optional(one.timeMs); });
  return partsOfMs(times, statedMs, volumes);
}

} // namespace

std::vector<GatedSeries> gatedSeriesOf(const FrameList& list, const std::vector<SliceGroup>& groups) {
  std::map<std::string, std::vector<std::size_t>> byKey;
  for (std::size_t group = 0; group < groups.size(); ++group)
    if (const auto key = gatedKey(list, groups[group]))
      byKey[*key].push_back(group);
  std::vector<GatedSeries> all;
  for (auto& [key, members] : byKey) {
    if (members.size() < 2)
      continue;
    std::erase_if(members, [&](std::size_t member) { return !isOneVolume(list, groups[member]); });
    if (members.size() < 2)
      continue;
    GatedSeries series = inOrder(list, groups, ofOnePlace(list, groups, members));
    if (series.groups.size() > 1)
      all.push_back(std::move(series));
  }
  return all;
}

void setPhaseTimes(const FrameList& list, std::vector<SlicePhase>& phases, TimedVolumes& volumes) {
  const std::vector<double> parts = partsOf(list, phases, volumes);
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return parts[a] < parts[b]; });
  std::vector<SlicePhase> kept;
  for (const std::size_t phase : order) {
    const auto percent = percentOf(list, phases[phase].frames);
    const Text name = percent ? phrase("phase %1 %", inDigits(*percent)) : phrase("phase %1", phase);
    if (!volumes.fractions.empty() && parts[phase] - volumes.fractions.back() < kSamePart) {
      volumes.findings.push_back(
          phrase("The %1 shows the same instant as the %2, and is left out", name, volumes.names.back()));
      continue;
    }
    volumes.fractions.push_back(parts[phase]);
    volumes.numbers.push_back(static_cast<int>(phase));
    volumes.names.push_back(name);
    kept.push_back(phases[phase]);
  }
  phases = std::move(kept);
  if (volumes.periodSeconds <= 0)
    volumes.findings.push_back(
        "It does not say how long the heart's cycle is; its phases are spread over one");
}

} // namespace viscera::medical_io
