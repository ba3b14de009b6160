#include "viscera/live/motion_series.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "heart_labels.h"
#include "labelled_phases.h"
#include "phase_name.h"
#include "series_checks.h"
#include "series_files.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/geometry/clean_surface.h"
#include "viscera/geometry/close_holes.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/label_series.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/medical_io/surface_series_file.h"

namespace viscera::live {
namespace {

namespace fs = std::filesystem;
using medical_io::LabelMap;
using medical_io::SeriesTimes;

constexpr double kSamePhaseMm = 0.1;
constexpr double kSamePhase = 0.2; ///< Of the step before: of 500 phases all neighbours are near.
constexpr double kSameGridVoxels = 0.01, kMostShear = 1e-3;
constexpr int kMargin = 2; ///< Voxels around what is kept of a mask.
constexpr double kApartLaterMm = 0.01;

// ---- surfaces ---------------------------------------------------------------------------------------------

/// Refuses files of which some say RAS and others say nothing.
void requireStatedAlike(const std::map<std::string, medical_io::SurfaceSeriesFile>& files) {
  bool ras = false;
  Text silent;
  for (const auto& [name, file] : files)
    for (std::size_t phase = 0; phase < file.spaces.size(); ++phase) {
      ras = ras || file.spaces[phase] == medical_io::Space::ras;
      if (!file.spaceStated[phase] && silent.empty())
        silent = phrase("%1, %2", name, phaseName(phase));
    }
  if (ras && !silent.empty())
    throw DataError("This file does not state its axes, but other files of the series are in RAS", silent,
                    "export all surfaces of a patient in the same way (viscera convert --space LPS)");
}

/// Says what was done to make a surface closed.
void warnOf(const tracking::TidySeries& tidy, MotionSeries& series) {
  const std::string& name = tidy.series.name;
  if (tidy.closedHoles > 0)
    series.warnings.push_back(
        phrase("%1: %n {hole|holes} closed by {a flat cap|flat caps}", name, tidy.closedHoles));
  if (tidy.mergedApartMm > kApartLaterMm)
    series.warnings.push_back(phrase(
        "%1: points that coincide in the first phase separate by up to %2 mm; Viscera keeps them together",
        name, inFixed(tidy.mergedApartMm, 2)));
}

/// Keeps the rims of each surface that are the same opening in every phase.
void keepCommonRims(MotionSeries& series) {
  if (series.rims.empty())
    return;
  for (std::size_t i = 0; i < series.names.size(); ++i) {
    std::vector<tracking::RimmedSurface> phases;
    for (std::size_t phase = 0; phase < series.meshes.size(); ++phase)
      phases.push_back({series.meshes[phase][i].get(), &series.rims[phase][i]});
    const auto common = tracking::commonRims(phases);
    for (std::size_t phase = 0; phase < series.meshes.size(); ++phase)
      series.rims[phase][i] = common.empty() ? std::vector<tracking::Rim>() : common[phase];
  }
}

/// Surfaces of which each phase has triangles of its own.
void readFreeMeshes(const SeriesFiles& files, MotionSeries& series, Progress& progress) {
  series.meshes.assign(files.phases, {});
  series.rims.assign(files.phases, {});
  for (const auto& [name, list] : files.files)
    for (std::size_t phase = 0; phase < list.size(); ++phase) {
      progress.throwIfCancelled();
      geometry::TriangleMesh mesh = medical_io::readSurface(list[phase]).mesh;
      geometry::faceOutward(mesh);
      geometry::ClosedSurface closed = geometry::closeHoles(mesh);
      mesh = std::move(closed.mesh);
      geometry::faceOutward(mesh);
      series.rims[phase].push_back(std::move(closed.rims));
      series.meshes[phase].push_back(std::make_shared<const geometry::TriangleMesh>(std::move(mesh)));
    }
}

/// The surfaces that a request names; all where it names none.
SeriesFiles chosenOf(const SeriesFiles& all, const SeriesRequest& request) {
  if (request.surfaces.empty())
    return all;
  SeriesFiles chosen = all;
  chosen.files.clear();
  for (const LabelledSurface& surface : request.surfaces) {
    if (!surface.labels.empty())
      throw UsageError("Only label maps have labels", "--surface", "leave it out for surfaces");
    const auto found = all.files.find(surface.name);
    if (found == all.files.end())
      throw UsageError(phrase("There is no surface \"%1\"", surface.name), "series",
                       phrase("the first one is: \"%1\"", all.files.begin()->first));
    chosen.files.insert(*found);
  }
  return chosen;
}

void readSurfaces(const SeriesFiles& files, MotionSeries& series, Progress& progress) {
  std::map<std::string, medical_io::SurfaceSeriesFile> read;
  Text differs;
  for (const auto& [name, list] : files.files) {
    series.names.push_back(name);
    series.files.push_back(list);
    const auto& file = read[name] = medical_io::readSurfaceSeries(list, progress);
    if (!file.correspond && differs.empty())
      differs =
          phrase("%1 has other triangles in %2 than in the first: surfaces are fitted by their distances, "
                 "which do not see motion along the wall",
                 name, phaseName(file.differs));
  }
  requireStatedAlike(read);
  if (!differs.empty()) {
    series.warnings.push_back(differs);
    readFreeMeshes(files, series, progress);
    return;
  }
  for (auto& [name, file] : read) {
    const tracking::TidySeries tidy =
        tracking::tidySeries({name, std::move(file.triangles), std::move(file.phases)});
    warnOf(tidy, series);
    series.corresponding.push_back(tidy.series);
  }
}

// ---- label maps -------------------------------------------------------------------------------------------

/// Takes label maps one after the other and keeps the voxels of the surfaces.
class MaskReader {
public:
  MaskReader(const std::vector<LabelledSurface>& surfaces, MotionSeries& series)
      : surfaces_(surfaces), series_(series) {}
  /// Messages name the phases by these numbers.
  MaskReader(const std::vector<LabelledSurface>& surfaces, const std::vector<PhaseLabels>& numbers,
             MotionSeries& series)
      : surfaces_(surfaces), series_(series) {
    for (const PhaseLabels& phase : numbers)
      numbers_.push_back(phase.phase);
  }

  void add(const LabelMap& map, const Text& where) {
    const std::size_t phase = series_.masks.size();
    if (phase == 0)
      begin(map, where);
    requireGrid(map, phase, where);
    std::vector<tracking::Mask>& masks = series_.masks.emplace_back();
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      tracking::Mask mask = maskOf(map, surfaces_[i], phase, where);
      tracking::VoxelRange range = tracking::rangeOf(mask);
      if (range.high[0] < 0)
        throw DataError(missing(surfaces_[i].name, phase), where, kMissingAdvice);
      bool atEdge = false;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        atEdge = atEdge ||
                 (map.size[axis] > 1 && (range.low[axis] == 0 || range.high[axis] == map.size[axis] - 1));
        all_[i].low[axis] = std::min(all_[i].low[axis], range.low[axis]);
        all_[i].high[axis] = std::max(all_[i].high[axis], range.high[axis]);
      }
      atEdge_[i].push_back(atEdge);
      ranges_[i].push_back(range);
      masks.push_back(tracking::cropped(mask, range));
    }
  }

  /// All masks of a surface on one grid.
  void finish() {
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
      for (std::size_t phase = 0; phase < series_.masks.size(); ++phase) {
        tracking::VoxelRange range = all_[i];
        for (std::size_t axis = 0; axis < 3; ++axis) {
          range.low[axis] -= kMargin + ranges_[i][phase].low[axis];
          range.high[axis] += kMargin - ranges_[i][phase].low[axis];
        }
        series_.masks[phase][i] = tracking::cropped(series_.masks[phase][i], range);
      }
  }

  /// A surface that the image cuts in some phases only has no volumes that could be compared.
  void checkEdges() const {
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      const auto cut = std::count(atEdge_[i].begin(), atEdge_[i].end(), true);
      const auto first = static_cast<std::size_t>(std::find(atEdge_[i].begin(), atEdge_[i].end(), true) -
                                                  atEdge_[i].begin());
      if (cut == 0)
        continue;
      const bool always = cut == static_cast<std::ptrdiff_t>(atEdge_[i].size());
      if (!always && (i != series_.outer || surfaces_.size() == 1))
        throw DataError(
            phrase("%1 touches the edge of the image in %2 and not in others, so that its volumes would be "
                   "cut off",
                   named(surfaces_[i].name), nameOf(first)),
            "series", "use images that show all of it in every phase");
      series_.warnings.push_back(
          always ? phrase("%1 touches the edge of the image in every phase: what lies beyond is not in its "
                          "volume",
                          named(surfaces_[i].name))
                 : phrase("%1 touches the edge of the image in %2: what lies beyond is not in its volume",
                          named(surfaces_[i].name), nameOf(first)));
    }
  }

private:
  static constexpr const char* kMissingAdvice = "label it in every phase, or leave this phase out";

  Text nameOf(std::size_t phase) const {
    return numbers_.empty() ? phaseName(phase) : phrase("phase %1", numbers_[phase]);
  }
  Text missing(const std::string& label, std::size_t phase) const {
    return phrase("The label \"%1\" is missing in %2", label, nameOf(phase));
  }

  void begin(const LabelMap& map, const Text& where) {
    if (surfaces_.empty() && map.segments.size() == 1)
      surfaces_.push_back({map.segments.front().name, {map.segments.front().name}});
    if (surfaces_.empty()) {
      surfaces_ = heartSurfaces(map);
      if (!surfaces_.empty())
        series_.warnings.push_back("its labels are those of a heart: muscle and chambers are its outer "
                                   "surface, each chamber is a cavity");
    }
    if (map.segments.empty())
      throw DataError(phrase("No voxel has a label in %1", nameOf(0)), where, kMissingAdvice);
    if (surfaces_.empty()) {
      std::string names;
      for (const medical_io::Segment& segment : map.segments)
        names += (names.empty() ? "" : ", ") + segment.name + " (" + std::to_string(segment.label) + ")";
      throw UsageError(
          phrase("It has several labels: %1", names), where,
          "say which surfaces they make, as in --surface LV=1 --surface RV=2 --surface EPI=1,2,3 "
          "with all labels within the outer one");
    }
    for (const LabelledSurface& surface : surfaces_) {
      series_.names.push_back(surface.name);
      medical_io::segmentsNamed(map, surface.labels, where); // Throws, with a list, if one is missing.
    }
    size_ = map.size;
    grid_ = map.indexToLps;
    const Eigen::Matrix3d axes = grid_.linear() * map.spacing().cwiseInverse().asDiagonal();
    if ((axes.transpose() * axes - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() > kMostShear)
      throw DataError("Its grid is sheared: its axes are not at right angles", where,
                      "resample the images to an upright grid");
    all_.assign(surfaces_.size(), {map.size, {-1, -1, -1}});
    atEdge_.resize(surfaces_.size());
    ranges_.resize(surfaces_.size());
    for (const Text& warning : map.warnings)
      series_.warnings.push_back(phrase("%1: %2", where, warning));
  }

  void requireGrid(const LabelMap& map, std::size_t phase, const Text& where) const {
    const Eigen::Affine3d between = grid_.inverse() * map.indexToLps;
    const Vec3 last(size_[0] - 1, size_[1] - 1, size_[2] - 1);
    if (map.size != size_ || !((between * Vec3::Zero()).norm() < kSameGridVoxels) ||
        !((between * last - last).norm() < kSameGridVoxels))
      throw DataError(phrase("The grid of %1 is another one than that of the first phase", nameOf(phase)),
                      where, "resample all phases to one grid, in the same axes");
  }

  tracking::Mask maskOf(const LabelMap& map, const LabelledSurface& surface, std::size_t phase,
                        const Text& where) const {
    tracking::Mask mask{map.size, map.indexToLps, std::vector<std::uint8_t>(map.voxelCount(), 0)};
    std::vector<std::size_t> segments;
    for (const std::string& label : surface.labels)
      try {
        const auto found = medical_io::segmentsNamed(map, {label}, where);
        segments.insert(segments.end(), found.begin(), found.end());
      } catch (const UsageError&) {
        throw DataError(missing(label, phase), where, kMissingAdvice);
      }
    if (surface.labels.empty())
      segments = medical_io::segmentsNamed(map, {}, where);
    for (const std::size_t segment : segments) {
      const medical_io::LabelLayer& layer = map.layers[static_cast<std::size_t>(map.segments[segment].layer)];
      for (std::size_t v = 0; v < layer.size(); ++v)
        mask.inside[v] |= layer[v] == segment + 1 ? 1 : 0;
    }
    return mask;
  }

  std::vector<LabelledSurface> surfaces_;
  MotionSeries& series_;
  std::vector<std::size_t> numbers_;
  std::array<int, 3> size_ = {};
  Eigen::Affine3d grid_ = Eigen::Affine3d::Identity();
  std::vector<tracking::VoxelRange> all_;                 ///< Of each surface in all phases.
  std::vector<std::vector<tracking::VoxelRange>> ranges_; ///< Of each surface in each phase.
  std::vector<std::vector<bool>> atEdge_;                 ///< The same.
};

SeriesTimes readMasks(const SeriesFiles& files, MaskReader& reader, Progress& progress) {
  const std::vector<fs::path>& list = files.files.at("");
  if (files.kind == SeriesFiles::Kind::volumes)
    return medical_io::readLabelSeries(list.front(), progress, [&](std::size_t phase, LabelMap&& map) {
      reader.add(map, phrase("%1, %2", list.front().string(), phaseName(phase)));
    });
  for (std::size_t phase = 0; phase < list.size(); ++phase) {
    progress.report(static_cast<double>(phase) / static_cast<double>(list.size()),
                    list[phase].filename().string());
    Progress quiet;
    reader.add(medical_io::readLabelMap(list[phase], quiet), list[phase].string());
    progress.throwIfCancelled();
  }
  return dicomTimes(list);
}

// ---- the whole --------------------------------------------------------------------------------------------

void measureVolumes(MotionSeries& series, std::size_t phases) {
  series.volumesMl.assign(phases, {});
  for (std::size_t phase = 0; phase < phases; ++phase)
    for (std::size_t i = 0; i < series.names.size(); ++i) {
      if (!series.masks.empty()) {
        series.volumesMl[phase].push_back(series.masks[phase][i].volumeMl());
        continue;
      }
      const geometry::TriangleMesh mesh =
          series.corresponding.empty() ? *series.meshes[phase][i] : series.corresponding[i].at(phase);
      series.volumesMl[phase].push_back(geometry::volume(mesh.points, mesh.triangles) / kMm3PerMl);
    }
}

/// The surface with the largest volume at first.
std::size_t outerOf(const MotionSeries& series) {
  const std::vector<double>& first = series.volumesMl.front();
  return static_cast<std::size_t>(std::max_element(first.begin(), first.end()) - first.begin());
}

void dropPhase(MotionSeries& series, std::size_t phase) {
  const auto at = static_cast<std::ptrdiff_t>(phase);
  for (tracking::SurfaceSeries& surface : series.corresponding)
    surface.phases.erase(surface.phases.begin() + at);
  if (!series.meshes.empty())
    series.meshes.erase(series.meshes.begin() + at);
  if (!series.rims.empty())
    series.rims.erase(series.rims.begin() + at);
  if (!series.masks.empty())
    series.masks.erase(series.masks.begin() + at);
  series.volumesMl.erase(series.volumesMl.begin() + at);
}

/// A last phase that is the first one again says that the period is one step shorter.
bool dropRepeated(MotionSeries& series, SeriesTimes& stated, std::vector<double>& given) {
  const std::size_t last = series.volumesMl.size() - 1;
  const double back = apartMm(series, last, 0);
  if (!(back < kSamePhaseMm) || !(back < kSamePhase * apartMm(series, last - 1, last)))
    return false;
  dropPhase(series, last);
  for (std::vector<double>* seconds : {&stated.seconds, &given})
    if (seconds->size() == last + 1)
      seconds->pop_back();
  if (stated.periodSeconds && stated.seconds.size() == last)
    stated.periodSeconds = stated.seconds.back() / static_cast<double>(last - 1) * static_cast<double>(last);
  series.warnings.push_back(
      phrase("the last phase equals the first and is left out: phase %1 would be phase 1 again", last + 1));
  return true;
}

tracking::PhaseTimes timesOf(const SeriesRequest& request, const std::vector<double>& given,
                             const SeriesTimes& stated, std::size_t count) {
  if (!given.empty() && given.size() != count)
    throw UsageError(phrase("There {is|are} %n {time|times} for %2 phases", given.size(), count),
                     "--times-ms", "give one for each phase");
  if (!request.periodSeconds && !stated.periodSeconds)
    throw UsageError("The duration of one cycle is unknown", "series",
                     "give it with --period-ms, or the rate with --rate");
  const double period = request.periodSeconds.value_or(stated.periodSeconds.value_or(0));
  if (!(period > 0) || !std::isfinite(period))
    throw UsageError("The period is not a positive time", "--period-ms", "as in --period-ms 829");
  tracking::PhaseTimes times = tracking::PhaseTimes::even(count, period, request.loop);
  if (!given.empty()) {
    times.seconds = given;
  } else if (stated.seconds.size() == count) {
    times.seconds = stated.seconds;
    // Frame numbers, and another rate than the files', are stretched.
    const double own = stated.periodSeconds.value_or(stated.seconds.back() / static_cast<double>(count - 1) *
                                                     static_cast<double>(count));
    if (request.periodSeconds)
      for (double& seconds : times.seconds)
        seconds *= period / own;
  }
  for (std::size_t phase = 0; phase < count; ++phase) {
    const double seconds = times.seconds[phase];
    if (!(seconds >= 0) || !(seconds < period) || (phase > 0 && !(seconds > times.seconds[phase - 1])))
      throw DataError(
          phrase("The times of the phases do not ascend within one period of %1 ms: %2 is at %3 ms",
                 inFixed(1000 * period, 0), phaseName(phase), inFixed(1000 * seconds, 1)),
          "series", "check their order, and the period");
  }
  return times;
}

void leaveOut(MotionSeries& series, std::vector<std::size_t> phases) {
  std::sort(phases.begin(), phases.end());
  phases.erase(std::unique(phases.begin(), phases.end()), phases.end());
  for (auto phase = phases.rbegin(); phase != phases.rend(); ++phase) {
    if (*phase >= series.phases())
      throw UsageError(phrase("There is no %1", phaseName(*phase)), "--leave-out",
                       phrase("there are %1", series.phases()));
    dropPhase(series, *phase);
    series.times.seconds.erase(series.times.seconds.begin() + static_cast<std::ptrdiff_t>(*phase));
  }
}

/// The outer surface comes first, the others stay in their order.
void putOuterFirst(MotionSeries& series) {
  const auto outer = static_cast<std::ptrdiff_t>(series.outer);
  const auto toFront = [outer](auto& list) {
    if (!list.empty())
      std::rotate(list.begin(), list.begin() + outer, list.begin() + outer + 1);
  };
  toFront(series.names);
  toFront(series.files);
  toFront(series.corresponding);
  for (auto& phase : series.meshes)
    toFront(phase);
  for (auto& phase : series.rims)
    toFront(phase);
  for (auto& phase : series.masks)
    toFront(phase);
  for (auto& phase : series.volumesMl)
    toFront(phase);
  series.outer = 0;
}

} // namespace

double MotionSeries::sliceMm() const {
  return masks.empty() ? 0 : masks.front().front().spacing().maxCoeff();
}

MotionSeries readOnePhase(const SeriesRequest& request, Progress& progress) {
  const bool masks = isHeartFolder(request.inputs);
  const SeriesFiles files = masks ? SeriesFiles() : seriesFiles(request);
  MotionSeries series;
  if (!masks && files.kind == SeriesFiles::Kind::surfaces) {
    readSurfaces(chosenOf(files, request), series, progress);
  } else {
    MaskReader reader(request.surfaces, series);
    Progress quiet;
    const fs::path& image = masks ? request.inputs.front() : files.files.at("").front();
    reader.add(masks ? medical_io::readLabelFolder(image, quiet) : medical_io::readLabelMap(image, quiet),
               image.string());
    reader.finish();
  }
  measureVolumes(series, 1);
  series.outer = outerOf(series);
  series.times = tracking::PhaseTimes::even(1, 1);
  putOuterFirst(series);
  keepCommonRims(series);
  requireCavitiesInside(series);
  return series;
}

MotionSeries readLabelledPhases(const std::vector<PhaseLabels>& phases,
                                const std::vector<LabelledSurface>& surfaces, Progress& progress) {
  SeriesRequest request;
  request.surfaces = surfaces;
  const SeriesFiles files = labelledFiles(phases, request.surfaces);
  MotionSeries series;
  if (files.kind == SeriesFiles::Kind::surfaces) {
    readSurfaces(chosenOf(files, request), series, progress);
  } else {
    MaskReader masks(surfaces, phases, series);
    for (const fs::path& file : files.files.at("")) {
      Progress quiet;
      std::error_code error;
      masks.add(fs::is_directory(file, error) ? medical_io::readLabelFolder(file, quiet)
                                              : medical_io::readLabelMap(file, quiet),
                file.string());
      progress.throwIfCancelled();
    }
    masks.finish();
    series.files.assign(series.names.size(), files.files.at(""));
  }
  measureVolumes(series, phases.size());
  series.outer = outerOf(series);
  series.times = tracking::PhaseTimes::even(phases.size(), 1);
  putOuterFirst(series);
  keepCommonRims(series);
  requireOneSpace(series);
  requireCavitiesInside(series);
  return series;
}

MotionSeries readMotionSeries(const SeriesRequest& request, Progress& progress) {
  if (isHeartFolder(request.inputs))
    requirePhases(1);
  const SeriesFiles files = seriesFiles(request);
  MotionSeries series;
  SeriesTimes stated;
  MaskReader masks(request.surfaces, series);
  if (files.kind != SeriesFiles::Kind::volumes)
    requirePhases(files.phases);
  if (files.kind == SeriesFiles::Kind::surfaces) {
    readSurfaces(chosenOf(files, request), series, progress);
  } else {
    stated = readMasks(files, masks, progress);
    requirePhases(series.masks.size());
    masks.finish();
  }
  if (series.files.empty()) // Label maps hold all surfaces.
    series.files.assign(series.names.size(), files.files.at(""));
  const std::size_t count = files.kind == SeriesFiles::Kind::surfaces ? files.phases : series.masks.size();
  measureVolumes(series, count);
  series.outer = outerOf(series);
  if (!series.masks.empty())
    masks.checkEdges();
  putOuterFirst(series);
  if (!stated.doubt.empty())
    series.warnings.push_back(stated.doubt);
  std::vector<double> given = request.seconds;
  if (request.loop)
    dropRepeated(series, stated, given);
  requirePhases(series.volumesMl.size());
  series.times = timesOf(request, given, stated, series.volumesMl.size());
  leaveOut(series, request.leftOut);
  requirePhases(series.phases());
  keepCommonRims(series);
  requireOneSpace(series);
  requireCavitiesInside(series);
  requireClosedLoop(series);
  requireSteadyVolumes(series);
  return series;
}

} // namespace viscera::live
