#include "dicom/dicom_scan.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <set>

#include "dicom/dicom_folder.h"
#include "dicom/dicom_header.h"
#include "dicom/for_all.h"
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

std::vector<ScanSeries> listDicomScans(const std::filesystem::path& fileOrFolder, Progress& progress) {
  const Folder folder = openFolder(fileOrFolder, progress, 1);
  std::vector<ScanSeries> list;
  for (const SliceGroup& group : folder.groups) {
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
  progress.report(1);
  return list;
}

Scan readDicomScan(const std::filesystem::path& fileOrFolder, const ScanOptions& options,
                   Progress& progress) {
  const Folder folder = openFolder(fileOrFolder, progress, kHeaders);
  const SeriesAndPart chosen = divided(options.series);
  const SliceGroup& group = chosenGroup(folder, fileOrFolder, chosen.series);
  Scan scan;
  append(scan.findings, group.findings);
  const std::vector<SlicePhase> phases = phasesOf(folder.list, group, scan.findings);
  if (options.phase < 0 || static_cast<std::size_t>(options.phase) >= phases.size())
    throw UsageError(phrase("It has no phase %1; it has %2", options.phase, phases.size()),
                     fileOrFolder.string(), "the first one is 0");
  const SliceStack stack =
      chosenStack(folder.list, phases[static_cast<std::size_t>(options.phase)], chosen.part, fileOrFolder);
  append(scan.findings, stack.findings);
  sayPartFirst(scan.findings);
  append(scan.findings, folder.damaged);
  describe(scan, folder, group);
  const DicomHeader& first = folder.list.files[folder.list.frames[stack.frames[0]].file];
  scan.size = {first.columns, first.rows,
               axisSize(FileBytes{fileOrFolder, {}}, std::int64_t(stack.depth()), "k")};
  scan.indexToLps = stack.indexToLps;
  RawImage grid;
  grid.size = scan.size;
  grid.indexToLps = scan.indexToLps;
  requireUsableGrid(grid, FileBytes{fileOrFolder, {}});
  scan.phase = options.phase;
  for (const SlicePhase& phase : phases)
    if (phases.size() > 1)
      scan.phaseTimesMs.push_back(phase.timeMs);
  const SampleForm form = formOf(folder.list, stack);
  if (form.uniform) {
    scan.slope = form.slope;
    scan.intercept = form.intercept;
    if (form.format.padding)
      scan.padding = double((*form.format.padding)[0]);
  }
  try {
    scan.samples = samplesOf(folder.list, stack, form, progress);
    if (!stack.mixes.empty())
      scan.samples = mixedSlices(scan.samples, std::size_t(first.columns) * std::size_t(first.rows),
                                 stack.mixes, scan.padding);
  } catch (const std::bad_alloc&) {
    throw DataError("it does not fit into memory", fileOrFolder.string(), "crop the image to the organs");
  }
  return scan;
}

} // namespace viscera::medical_io
