#include "viscera/live/series_contents.h"

#include <algorithm>

#include "heart_labels.h"
#include "series_files.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_series.h"

namespace viscera::live {
namespace {

using medical_io::LabelMap;
using medical_io::Segment;

/// How many voxels the box around a segment has.
double boxOf(const Segment& segment) {
  double voxels = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
    voxels *= segment.high[axis] - segment.low[axis] + 1;
  return voxels;
}

/// The labels of a map, each with its probable role.
std::vector<SeriesItem> itemsOf(const LabelMap& map) {
  std::vector<SeriesItem> items;
  const std::vector<LabelledSurface> heart = heartSurfaces(map);
  const auto largest = std::max_element(map.segments.begin(), map.segments.end(),
                                        [](const auto& a, const auto& b) { return boxOf(a) < boxOf(b); });
  for (auto segment = map.segments.begin(); segment != map.segments.end(); ++segment) {
    SeriesItem item{segment->name, std::to_string(segment->label),
                    segment == largest ? SeriesPart::tissue : SeriesPart::cavity};
    if (!heart.empty())
      item.part = SeriesPart::unused;
    for (const LabelledSurface& surface : heart) {
      const auto& labels = surface.labels;
      if (std::find(labels.begin(), labels.end(), segment->name) == labels.end())
        continue;
      item.part = &surface == &heart.front() ? SeriesPart::tissue : SeriesPart::cavity;
      if (item.part == SeriesPart::cavity)
        item.name = surface.name;
    }
    items.push_back(std::move(item));
  }
  return items;
}

} // namespace

SeriesContents lookIntoSeries(const std::vector<std::filesystem::path>& inputs, Progress& progress) {
  if (isHeartFolder(inputs)) {
    SeriesContents image;
    image.labels = true;
    image.phases = 1;
    image.items = itemsOf(medical_io::readLabelFolder(inputs.front(), progress));
    return image;
  }
  SeriesRequest request;
  request.inputs = inputs;
  const SeriesFiles files = seriesFiles(request);
  SeriesContents contents;
  contents.phases = files.phases;
  contents.labels = files.kind != SeriesFiles::Kind::surfaces;
  if (!contents.labels) {
    for (const auto& [name, list] : files.files)
      contents.items.push_back({name, {}, SeriesPart::tissue});
    return contents;
  }
  const std::vector<std::filesystem::path>& list = files.files.at("");
  medical_io::SeriesTimes times;
  if (files.kind == SeriesFiles::Kind::volumes) {
    times = medical_io::readLabelSeries(list.front(), progress, [&](std::size_t phase, LabelMap&& map) {
      if (phase == 0)
        contents.items = itemsOf(map);
      contents.phases = phase + 1;
    });
  } else {
    contents.items = itemsOf(medical_io::readLabelMap(list.front(), progress));
    times = dicomTimes(list);
  }
  contents.periodSeconds = times.periodSeconds;
  contents.doubt = times.doubt;
  return contents;
}

SeriesContents lookIntoPhase(const PhaseLabels& labels, Progress& progress) {
  const SeriesFiles files = labelledFiles({labels}, {});
  SeriesContents contents;
  contents.phases = 1;
  contents.labels = files.kind != SeriesFiles::Kind::surfaces;
  if (!contents.labels) {
    for (const auto& [name, list] : files.files)
      contents.items.push_back({name, {}, SeriesPart::tissue});
    return contents;
  }
  const std::filesystem::path& map = files.files.at("").front();
  std::error_code error;
  contents.items =
      itemsOf(std::filesystem::is_directory(map, error) ? medical_io::readLabelFolder(map, progress)
                                                        : medical_io::readLabelMap(map, progress));
  return contents;
}

std::vector<LabelledSurface> chosenSurfaces(const SeriesContents& contents, const std::string& outerName) {
  std::vector<LabelledSurface> surfaces;
  LabelledSurface outer{outerName, {}};
  bool tissue = false;
  for (const SeriesItem& item : contents.items) {
    if (item.part == SeriesPart::unused)
      continue;
    outer.labels.push_back(item.label);
    tissue = tissue || item.part == SeriesPart::tissue;
    if (!contents.labels)
      surfaces.push_back({item.name, {}});
    else if (item.part == SeriesPart::cavity)
      surfaces.push_back({item.name, {item.label}});
  }
  if (outer.labels.empty())
    throw UsageError("No surface is chosen", "series", "choose at least one");
  if (contents.labels && (tissue || surfaces.size() > 1))
    surfaces.insert(surfaces.begin(), std::move(outer));
  return surfaces;
}

} // namespace viscera::live
