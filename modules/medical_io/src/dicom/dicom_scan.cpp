#include "dicom/dicom_scan.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <set>

#include "dicom/dicom_folder.h"
#include "dicom/dicom_header.h"
#include "dicom/for_all.h"
#include "dicom/gated_series.h"
#include "dicom/mixed_slices.h"
#include "dicom/pixel_conversion.h"
#include "dicom/slice_stack.h"
#include "file_bytes.h"
#include "image_formats/raw_image.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

/// The part of the work that headers are.
constexpr double kHeaders = 0.2;

/// All slices at one position.
struct Folder {
  FrameList list;
  std::vector<SliceGroup> groups; ///< The largest first.
  std::vector<GatedSeries> gated; ///< Those that are the phases of one scan.
  std::vector<ScanFinding> damaged;
};

std::string seriesId(const Folder& folder, const SliceGroup& group) {
  const DicomHeader& file = folder.list.files[folder.list.frames[group.frames[0]].file];
  return file.seriesUid + (group.ofSeries > 0 ? "#" + std::to_string(group.ofSeries + 1) : "");
}

/// What follows the series: nothing for the part that is read when none is named.
std::string partId(const SliceStack& stack, std::size_t number) {
  return stack.part.resampled ? "@all" : number == 0 ? "" : "@" + std::to_string(number + 1);
}

/// Behind the id of the first of several series that are the phases of one scan.
constexpr const char* kGatedPart = "@gated";

/// "1.2.3@all": the series, which may be empty, and the part of it.
struct SeriesAndPart {
  std::string series, part;
};

SeriesAndPart divided(const std::string& id) {
  const std::size_t at = std::min(id.rfind('@'), id.size());
  return {id.substr(0, at), id.substr(at)};
}

/// The part that is asked for.
SliceStack chosenStack(const FrameList& list, const SlicePhase& phase, const std::string& part,
                       const std::filesystem::path& place) {
  std::vector<SliceStack> stacks = stackSlices(list, phase);
  std::string known;
  for (std::size_t number = 0; number < stacks.size(); ++number) {
    const std::string id = partId(stacks[number], number);
    if (id == part)
      return std::move(stacks[number]);
    known += id.empty() ? "" : (known.empty() ? "" : ", ") + id;
  }
  if (part == "@all" && stacks.size() == 1 && stacks[0].frames.size() == stacks[0].slices)
    return std::move(stacks[0]); // It is even, and so needs no grid of its own.
  throw UsageError(misuse("Its slices have no part %1", part), place.string(),
                   known.empty() ? misuse("all of them are read without one")
                                 : misuse("there are: %1", known));
}

std::uint64_t voxelsOf(const Folder& folder, const SliceGroup& group) {
  const DicomHeader& file = folder.list.files[folder.list.frames[group.frames[0]].file];
  return std::uint64_t(file.rows) * std::uint64_t(file.columns) * group.frames.size();
}

void listFrames(Folder& folder) {
  for (std::size_t file = 0; file < folder.list.files.size(); ++file)
    for (DicomFrame& frame : folder.list.files[file].frames) {
      frame.file = file;
      folder.list.frames.push_back(frame);
    }
}

/// Why no file can be read, from the first one that has a reason.
[[noreturn]] void failWithoutSlices(const std::filesystem::path& place, const FrameList& list,
                                    const std::vector<std::optional<DataError>>& errors) {
  for (const auto& error : errors)
    if (error)
      throw DataError(*error);
  for (const DicomHeader& header : list.files)
    if (!header.notAScan.empty())
      throw DataError(
          phrase("It has no slices of a scan: \"%1\" %2", header.file.filename().string(), header.notAScan),
          place.string(), "name the folder of a CT or MR series");
  throw DataError("It has no slices of a scan", place.string(), "name the folder of a CT or MR series");
}

Folder openFolder(const std::filesystem::path& place, Progress& progress, double until) {
  auto [files, headers, errors] = readDicomHeaders(dicomImages(place), progress, until);
  std::error_code ignored;
  for (std::size_t i = 0; i < files.size() && !std::filesystem::is_directory(place, ignored); ++i)
    if (files[i].filename() == place.filename() && errors[i])
      throw DataError(*errors[i]);
  Folder folder;
  folder.list.files = std::move(headers);
  listFrames(folder);
  if (folder.list.frames.empty())
    failWithoutSlices(place, folder.list, errors);
  const auto damaged =
      std::find_if(errors.begin(), errors.end(), [](const auto& e) { return e.has_value(); });
  if (damaged != errors.end()) {
    const auto count = static_cast<std::uint64_t>(
        std::count_if(errors.begin(), errors.end(), [](const auto& e) { return e.has_value(); }));
    folder.damaged.push_back(
        {ScanFinding::Kind::damaged,
         phrase("%n {file is|files are} damaged and left out (%2: %3)", count,
                files[std::size_t(damaged - errors.begin())].filename().string(), (*damaged)->problem())});
  }
  folder.groups = groupFrames(folder.list);
  std::stable_sort(folder.groups.begin(), folder.groups.end(),
                   [&](const auto& a, const auto& b) { return voxelsOf(folder, a) > voxelsOf(folder, b); });
  folder.gated = gatedSeriesOf(folder.list, folder.groups);
  return folder;
}

/// The group that is asked for; else that of the file that was named, else the largest.
const SliceGroup& chosenGroup(const Folder& folder, const std::filesystem::path& place,
                              const std::string& series) {
  for (const SliceGroup& group : folder.groups)
    if (!series.empty() && seriesId(folder, group) == series)
      return group;
  if (!series.empty()) {
    std::string known;
    for (const SliceGroup& group : folder.groups)
      known += (known.empty() ? "" : ", ") + seriesId(folder, group);
    throw UsageError(misuse("It has no series %1", series), place.string(), misuse("there are: %1", known));
  }
  std::error_code error;
  if (std::filesystem::is_directory(place, error))
    return folder.groups.front();
  for (const SliceGroup& group : folder.groups)
    for (const std::size_t f : group.frames)
      if (folder.list.files[folder.list.frames[f].file].file.filename() == place.filename())
        return group;
  Text why = "It is not a slice of a scan";
  for (const DicomHeader& header : folder.list.files)
    if (header.file.filename() == place.filename() && !header.notAScan.empty())
      why = phrase("It is not a slice of a scan: it %1", header.notAScan);
  throw DataError(why, place.string(), "name the folder, or another file in it");
}

/// The series over time that is asked for, or that a folder's largest one is a phase of; null: it is none.
const GatedSeries* chosenGated(const Folder& folder, const std::filesystem::path& place,
                               const std::string& series) {
  const SeriesAndPart chosen = divided(series);
  std::error_code error;
  const bool whole =
      chosen.part.empty() && chosen.series.empty() && std::filesystem::is_directory(place, error);
  for (const GatedSeries& gated : folder.gated)
    if (whole
            ? std::count(gated.groups.begin(), gated.groups.end(), std::size_t{0}) > 0
            : chosen.part == kGatedPart && seriesId(folder, folder.groups[gated.groups[0]]) == chosen.series)
      return &gated;
  return nullptr;
}

SampleForm formOf(const FrameList& list, const SliceStack& stack) {
  const DicomFrame& first = list.frames[stack.frames[0]];
  SampleForm form{list.files[first.file].format, first.slope, first.intercept, true};
  for (const std::size_t f : stack.frames) {
    const DicomFrame& frame = list.frames[f];
    form.uniform = form.uniform && frame.slope == form.slope && frame.intercept == form.intercept &&
                   list.files[frame.file].format == form.format;
  }
  return form;
}

/// Calls `read`, which reads from the file of `header`. A slice that cannot be unpacked, or whose file has
/// vanished since it was listed, ends the reading: a scan must not have a hole that the user does not expect.
template <class Read>
auto ofSlice(const DicomHeader& header, const Read& read) -> decltype(read()) {
  try {
    return read();
  } catch (const DataError& error) {
    throw DataError(phrase("A slice cannot be read, so the series is not opened: %1", error.problem()),
                    header.file.string(),
                    "copy the file anew, or take it out of the folder to read the others");
  }
}

template <class Sample>
Scan::Samples readSamples(const FrameList& list, const SliceStack& stack, const SampleForm& form,
                          Progress& progress) {
  const DicomHeader& any = list.files[list.frames[stack.frames[0]].file];
  const std::size_t slice = std::size_t(any.rows) * std::size_t(any.columns);
  std::vector<Sample> samples(slice * stack.frames.size());
  // Frames of one file follow each other on one thread; each file is opened once.
  std::vector<std::pair<std::size_t, std::vector<std::size_t>>> byFile;
  std::vector<std::size_t> order(stack.frames.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return list.frames[stack.frames[a]].file < list.frames[stack.frames[b]].file;
  });
  for (const std::size_t k : order) {
    const std::size_t file = list.frames[stack.frames[k]].file;
    if (byFile.empty() || byFile.back().first != file)
      byFile.emplace_back(file, std::vector<std::size_t>{});
    byFile.back().second.push_back(k);
  }
  forAll(byFile.size(), progress, kHeaders, 1, "slices", [&](std::size_t number) {
    const DicomHeader& header = list.files[byFile[number].first];
    DicomPixelReader reader = ofSlice(header, [&] { return DicomPixelReader(header); });
    for (const std::size_t k : byFile[number].second) {
      progress.throwIfCancelled();
      const DicomFrame& frame = list.frames[stack.frames[k]];
      const DicomPixels pixels = ofSlice(header, [&] { return reader.read(frame.frame); });
      Sample* out = samples.data() + k * slice;
      convertPixels(pixels, frame, form, out);
    }
  });
  return samples;
}

Scan::Samples samplesOf(const FrameList& list, const SliceStack& stack, const SampleForm& form,
                        Progress& progress) {
  const auto as = [&]<class Sample>(Sample) { return readSamples<Sample>(list, stack, form, progress); };
  const bool isSigned = form.format.isSigned;
  if (!form.uniform)
    return as(float());
  if (form.format.allocated == 8)
    return isSigned ? as(std::int8_t()) : as(std::uint8_t());
  if (form.format.allocated == 16)
    return isSigned ? as(std::int16_t()) : as(std::uint16_t());
  return isSigned ? as(std::int32_t()) : as(std::uint32_t());
}

void describe(Scan& scan, const Folder& folder, const SliceGroup& group) {
  const DicomHeader& file = folder.list.files[folder.list.frames[group.frames[0]].file];
  scan.modality = file.modality;
  scan.description = file.description;
  scan.patientName = file.patientName;
  scan.studyDate = file.studyDate;
  scan.transferSyntax = file.transferSyntax;
  scan.window = file.window;
  scan.space = "LPS";
  if (!file.assumed.empty())
    scan.findings.push_back({ScanFinding::Kind::other, file.assumed});
  if (file.modality == "CT" && (file.rescaleType.empty() || file.rescaleType == "HU"))
    scan.unit = "HU";
}

void append(std::vector<ScanFinding>& list, const std::vector<ScanFinding>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

/// Missing slices in what is read come before any other doubt.
void sayPartFirst(std::vector<ScanFinding>& findings) {
  std::stable_partition(findings.begin(), findings.end(), [](const ScanFinding& finding) {
    return finding.kind == ScanFinding::Kind::partRead || finding.kind == ScanFinding::Kind::resampled;
  });
}

} // namespace

namespace {

/// Appends what can be chosen of a group: its parts.
void listGroup(const Folder& folder, const SliceGroup& group, std::vector<ScanSeries>& list) {
  std::vector<ScanFinding> findings;
  const std::vector<SlicePhase> phases = phasesOf(folder.list, group, findings);
  const DicomHeader& first = folder.list.files[folder.list.frames[group.frames[0]].file];
  std::set<std::filesystem::path> files;
  for (const std::size_t f : group.frames)
    files.insert(folder.list.files[folder.list.frames[f].file].file);
  const std::vector<SliceStack> stacks = stackSlices(folder.list, phases[0]);
  for (std::size_t number = 0; number < stacks.size(); ++number) {
    const SliceStack& stack = stacks[number];
    ScanSeries& series = list.emplace_back();
    series.id = seriesId(folder, group) + partId(stack, number);
    series.description = first.description;
    series.modality = first.modality;
    series.size = {first.columns, first.rows, static_cast<int>(stack.depth())};
    series.spacing = stack.indexToLps.linear().colwise().norm();
    series.indexToLps = stack.indexToLps;
    series.phases = static_cast<int>(phases.size());
    series.slices = {static_cast<int>(stack.part.first) + 1, static_cast<int>(stack.part.last) + 1,
                     static_cast<int>(stack.slices), stack.part.resampled};
    series.frameOfReference = first.frameOfReference;
    series.files.assign(files.begin(), files.end());
  }
}

/// Series that are phases of one scan are listed once, with the files of all.
void listGated(const Folder& folder, const GatedSeries& gated, std::vector<ScanSeries>& list) {
  std::vector<ScanSeries> all;
  for (const std::size_t group : gated.groups)
    listGroup(folder, folder.groups[group], all);
  ScanSeries& series = list.emplace_back(all.front());
  series.id = seriesId(folder, folder.groups[gated.groups[0]]) + kGatedPart;
  series.phases = static_cast<int>(gated.groups.size());
  std::set<std::filesystem::path> files;
  for (const ScanSeries& one : all)
    files.insert(one.files.begin(), one.files.end());
  series.files.assign(files.begin(), files.end());
}

/// What is read of a folder: the phases of a group, or groups that are phases.
struct ChosenScan {
  const SliceGroup* group = nullptr; ///< Of the first phase.
  std::vector<SlicePhase> phases;
  std::vector<ScanFinding> findings;
  std::string part;
};

ChosenScan chosenScan(const Folder& folder, const std::filesystem::path& place, const std::string& series) {
  ChosenScan chosen;
  if (const GatedSeries* gated = chosenGated(folder, place, series)) {
    chosen.group = &folder.groups[gated->groups[0]];
    chosen.phases = gated->phases;
    return chosen;
  }
  const SeriesAndPart named = divided(series);
  chosen.part = named.part;
  chosen.group = &chosenGroup(folder, place, named.series);
  append(chosen.findings, chosen.group->findings);
  chosen.phases = phasesOf(folder.list, *chosen.group, chosen.findings);
  return chosen;
}

/// Takes the samples of the slices in their order, mixed where the grid is made from them.
void takeSamples(Scan& scan, const FrameList& list, const SliceStack& stack,
                 const std::filesystem::path& place, Progress& progress) {
  const SampleForm form = formOf(list, stack);
  if (form.uniform) {
    scan.slope = form.slope;
    scan.intercept = form.intercept;
    if (form.format.padding)
      scan.padding = double((*form.format.padding)[0]);
  }
  try {
    scan.samples = samplesOf(list, stack, form, progress);
    if (!stack.mixes.empty())
      scan.samples = mixedSlices(scan.samples, std::size_t(scan.size[0]) * std::size_t(scan.size[1]),
                                 stack.mixes, scan.padding);
  } catch (const std::bad_alloc&) {
    throw DataError("it does not fit into memory", place.string(), "crop the image to the organs");
  }
}

/// The volume of one phase.
Scan readVolume(const Folder& folder, const ChosenScan& chosen, std::size_t phase,
                const std::filesystem::path& place, Progress& progress) {
  Scan scan;
  scan.findings = chosen.findings;
  const SliceStack stack = chosenStack(folder.list, chosen.phases[phase], chosen.part, place);
  append(scan.findings, stack.findings);
  sayPartFirst(scan.findings);
  append(scan.findings, folder.damaged);
  describe(scan, folder, *chosen.group);
  const DicomHeader& first = folder.list.files[folder.list.frames[stack.frames[0]].file];
  scan.size = {first.columns, first.rows, axisSize(FileBytes{place, {}}, std::int64_t(stack.depth()), "k")};
  scan.indexToLps = stack.indexToLps;
  RawImage grid;
  grid.size = scan.size;
  grid.indexToLps = scan.indexToLps;
  requireUsableGrid(grid, FileBytes{place, {}});
  for (const SlicePhase& one : chosen.phases)
    if (chosen.phases.size() > 1)
      scan.phaseTimesMs.push_back(one.timeMs);
  takeSamples(scan, folder.list, stack, place, progress);
  return scan;
}

} // namespace

std::vector<ScanSeries> listDicomScans(const std::filesystem::path& fileOrFolder, Progress& progress) {
  const Folder folder = openFolder(fileOrFolder, progress, 1);
  std::vector<ScanSeries> list;
  std::set<std::size_t> listed;
  for (std::size_t group = 0; group < folder.groups.size(); ++group) {
    if (listed.contains(group))
      continue;
    const auto gated = std::find_if(folder.gated.begin(), folder.gated.end(), [&](const GatedSeries& one) {
      return std::count(one.groups.begin(), one.groups.end(), group) > 0;
    });
    if (gated == folder.gated.end()) {
      listGroup(folder, folder.groups[group], list);
      continue;
    }
    listed.insert(gated->groups.begin(), gated->groups.end());
    listGated(folder, *gated, list);
  }
  progress.report(1);
  return list;
}

Scan readDicomScan(const std::filesystem::path& fileOrFolder, const ScanOptions& options,
                   Progress& progress) {
  const Folder folder = openFolder(fileOrFolder, progress, kHeaders);
  const ChosenScan chosen = chosenScan(folder, fileOrFolder, options.series);
  if (options.phase < 0 || static_cast<std::size_t>(options.phase) >= chosen.phases.size())
    throw UsageError(phrase("It has no phase %1; it has %2", options.phase, chosen.phases.size()),
                     fileOrFolder.string(), "the first one is 0");
  Scan scan = readVolume(folder, chosen, static_cast<std::size_t>(options.phase), fileOrFolder, progress);
  scan.phase = options.phase;
  return scan;
}

std::optional<TimedVolumes> dicomVolumes(const std::filesystem::path& fileOrFolder, const std::string& series,
                                         Progress& progress) {
  const auto folder = std::make_shared<const Folder>(openFolder(fileOrFolder, progress, kHeaders));
  ChosenScan chosen = chosenScan(*folder, fileOrFolder, series);
  if (chosen.phases.size() < 2)
    return std::nullopt;
  TimedVolumes volumes;
  const GatedSeries* gated = chosenGated(*folder, fileOrFolder, series);
  const SliceStack stack = chosenStack(folder->list, chosen.phases[0], chosen.part, fileOrFolder);
  const DicomHeader& first = folder->list.files[folder->list.frames[stack.frames[0]].file];
  volumes.series = gated != nullptr ? seriesId(*folder, *chosen.group) + kGatedPart : series;
  volumes.description = first.description;
  volumes.modality = first.modality;
  volumes.size = {first.columns, first.rows, static_cast<int>(stack.depth())};
  volumes.sampleBytes = formOf(folder->list, stack).uniform ? std::size_t(first.format.allocated) / 8 : 4;
  auto inTime = chosen.phases;
  setPhaseTimes(folder->list, inTime, volumes);
  if (volumes.count() < 2)
    return std::nullopt;
  for (const ScanFinding& finding : folder->damaged)
    volumes.findings.push_back(finding.sentence);
  volumes.read = [folder, fileOrFolder, chosen = std::move(chosen),
                  numbers = volumes.numbers](std::size_t phase, Progress& reading) {
    const auto number = static_cast<std::size_t>(numbers.at(phase));
    Scan scan = readVolume(*folder, chosen, number, fileOrFolder, reading);
    scan.phase = numbers[phase];
    return scan;
  };
  return volumes;
}

} // namespace viscera::medical_io
