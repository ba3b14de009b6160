#include "viscera/phantom/write_phantom.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

#include "noise.h"
#include "phantom_json.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/cine_writer.h"
#include "viscera/medical_io/displacement_file.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/phantom/tissue.h"

namespace viscera::phantom {
namespace {

namespace fs = std::filesystem;

constexpr double kRoomMm = 5; ///< Around the skin.
constexpr double kMostVoxels = 2e8;

std::string numbered(const std::string& name, int number, const std::string& ending) {
  char digits[16];
  std::snprintf(digits, sizeof digits, "_%03d", number);
  return name + digits + ending;
}

/// Axis-parallel voxels over the whole body.
ImageGrid bodyGrid(const PhantomBody& body, const Vec3& spacing) {
  const Bounds bounds = body.bounds();
  ImageGrid grid;
  double voxels = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double count = std::floor((bounds.high[axis] - bounds.low[axis] + 2 * kRoomMm) / spacing[axis]) + 1;
    voxels *= count;
    grid.size[static_cast<std::size_t>(axis)] = static_cast<int>(count);
  }
  if (voxels > kMostVoxels)
    throw UsageError(misuse("the images would have more than 200 million voxels"), {},
                     misuse("ask for a larger spacing"));
  grid.indexToLps = Eigen::Translation3d(bounds.low - Vec3::Constant(kRoomMm)) * Eigen::Scaling(spacing);
  return grid;
}

/// Makes the folders, and knows what is in them.
class Folder {
public:
  explicit Folder(fs::path root) : root_(std::move(root)) { make(root_); }

  /// The path of a file, which is listed.
  fs::path add(const std::string& name) {
    const fs::path file = root_ / name;
    make(file.parent_path());
    files.push_back(name);
    return file;
  }

  std::vector<std::string> files;

private:
  static void make(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error || !fs::is_directory(folder, error))
      throw CannotCreateError("the folder cannot be made", folder.string(), "choose another one");
  }

  fs::path root_;
};

/// Writes a phantom phase by phase.
class PhantomWriter {
public:
  PhantomWriter(const fs::path& folder, const PhantomOptions& options,
                const sample_organs::SampleLibrary& library, Progress& progress, Threads threads)
      : options_(options), threads_(threads),
        body_(phantomBody(library, options.resolution, progress, threads)),
        motion_(library, body_, options.motion, progress, threads), wall_(body_),
        grid_(bodyGrid(body_, gridSpacing(options))), folder_(folder) {
    json_ = headOf(options_, motion_);
    if (options_.modality == Modality::cine)
      planes_ = studyPlanes(body_.heart, options_);
    for (const StudyPlane& plane : planes_)
      json_["slices"].push_back(jsonOf(plane));
  }

  PhantomReport run(Progress& progress) {
    for (int phase = 0; phase < options_.phases; ++phase) {
      progress.report(static_cast<double>(phase) / options_.phases, "Making the phantom");
      progress.throwIfCancelled();
      writePhase(phase);
    }
    writeSeries();
    measureEjection();
    json_["files"] = folder_.files;
    const std::string text = json_.dump(1) + "\n";
    writeAtomically(folder_.add("phantom.json"), [&](std::ostream& out) { out << text; });
    report_.files = folder_.files;
    progress.report(1);
    return std::move(report_);
  }

private:
  /// A cine's own spacing is that of its planes; its label maps have cubes.
  static Vec3 gridSpacing(const PhantomOptions& options) {
    return options.modality == Modality::cine ? Vec3::Constant(3) : options.spacing;
  }

  /// The phases that were kept, each kind as one file.
  void writeSeries() {
    const std::string ending = options_.format == ".nrrd" ? ".seq.nrrd" : options_.format;
    const double intervalMs = 1000 * motion_.periodSeconds() / options_.phases;
    if (!labels_.empty())
      medical_io::writeLabelSeries(folder_.add("labels" + ending), labels_, intervalMs);
    if (!scans_.empty())
      medical_io::writeScanSeries(folder_.add("ct" + ending), scans_, intervalMs);
  }

  void writePhase(int phase) {
    motion_.setSeconds(motion_.periodSeconds() * phase / options_.phases);
    const PhantomInstant instant = instantOf(body_, motion_);
    report_.phases.push_back(truthOf(instant, motion_.periodSeconds() * phase / options_.phases));
    report_.foldedMl = std::max(report_.foldedMl, motion_.foldedMl());
    json_["phases"].push_back(jsonOf(report_.phases.back(), body_, motion_, wall_));
    const std::vector<std::uint8_t> labels = renderLabels(body_, instant, grid_, threads_);
    writeLabels(labels, phase);
    if (options_.modality == Modality::ct)
      writeCt(instant, phase);
    for (std::size_t p = 0; p < planes_.size(); ++p)
      writePlane(instant, p, phase);
    if (options_.fieldSpacingMm > 0)
      writeFields(instant, phase);
  }

  PhantomPhase truthOf(const PhantomInstant& instant, double seconds) const {
    PhantomPhase truth{seconds, motion_.beatFraction(), motion_.inspiration(), {}};
    for (std::size_t s = 0; s < body_.surfaces.size(); ++s)
      truth.volumesMl[body_.surfaces[s].tissue] =
          geometry::volume(instant.surfaces[s], body_.surfaces[s].mesh.triangles) / kMm3PerMl;
    return truth;
  }

  void measureEjection() {
    if (!options_.motion.heartbeat)
      return;
    const geometry::TriangleMesh& left = body_.surfaceOf("left ventricle").mesh;
    const auto volumeAt = [&](double seconds) {
      motion_.setSeconds(seconds);
      return geometry::volume(motion_.moved(left.points), left.triangles) / kMm3PerMl;
    };
    const double full = volumeAt(0), least = volumeAt(motion_.endSystoleSeconds());
    report_.ejectionFraction = 1 - least / full;
    json_["ejectionFraction"] = report_.ejectionFraction;
    json_["endDiastolicVolumeMl"] = full;
    json_["endSystolicVolumeMl"] = least;
  }

  void writeLabels(const std::vector<std::uint8_t>& labels, int phase) {
    medical_io::LabelMap map;
    map.size = grid_.size;
    map.indexToLps = grid_.indexToLps;
    map.layers.emplace_back(labels);
    for (const Tissue& tissue : tissues())
      if (tissue.label > 0)
        map.segments.push_back(
            {.label = tissue.label, .name = tissue.name, .named = true, .color = tissue.color});
    if (options_.overTime) {
      labels_.push_back(std::move(map));
      return;
    }
    const bool nrrd = options_.format == ".nrrd";
    medical_io::writeLabelMap(folder_.add(numbered("labels", phase, nrrd ? ".seg.nrrd" : options_.format)),
                              map);
  }

  Contrast contrastOf(Contrast::Kind kind) const {
    return {kind, options_.noise, options_.deviation, options_.seed,
            kind == Contrast::Kind::ct ? LinesOfARow{2, 2} : LinesOfARow{2, 4}};
  }

  void writeCt(const PhantomInstant& instant, int phase) {
    const std::vector<float> values = renderImage(body_, instant, grid_, contrastOf(Contrast::Kind::ct),
                                                  static_cast<std::uint64_t>(phase), threads_);
    medical_io::Scan scan;
    scan.size = grid_.size;
    scan.indexToLps = grid_.indexToLps;
    std::vector<std::int16_t> samples;
    samples.reserve(values.size());
    for (const float value : values)
      samples.push_back(static_cast<std::int16_t>(std::lround(std::clamp(value, -1024.0F, 3071.0F))));
    scan.samples = std::move(samples);
    if (options_.overTime) {
      scans_.push_back(std::move(scan));
      return;
    }
    medical_io::writeScan(folder_.add(numbered("ct", phase, options_.format)), scan);
  }

  medical_io::CineSeries seriesOf(std::size_t plane) const {
    const StudyPlane& place = planes_[plane];
    const Eigen::Affine3d& axes = place.grid.indexToLps;
    // UIDs of the kind that needs no registration (ISO/IEC 9834-8), from the seed.
    const std::string root = "2.25." + std::to_string(mixed(options_.seed, 0x554944));
    medical_io::CineSeries series;
    series.patientName = "Phantom^Moving";
    series.patientId = "PHANTOM";
    series.studyUid = root + ".1";
    series.seriesUid = root + ".1." + std::to_string(plane + 1);
    series.frameOfReferenceUid = root + ".2";
    series.number = static_cast<int>(plane) + 1;
    series.description = place.description;
    series.geometry = {axes.translation(),
                       axes.linear().col(0).normalized(),
                       axes.linear().col(1).normalized(),
                       axes.linear().col(0).norm(),
                       axes.linear().col(1).norm(),
                       axes.linear().col(2).norm(),
                       place.grid.size[0],
                       place.grid.size[1]};
    series.intervalMs = 1000 * motion_.periodSeconds();
    series.phases = options_.phases;
    return series;
  }

  void writePlane(const PhantomInstant& instant, std::size_t plane, int phase) {
    const std::uint64_t number = 1000 * (plane + 1) + static_cast<std::uint64_t>(phase);
    const std::vector<float> values = renderImage(body_, instant, planes_[plane].imaged(),
                                                  contrastOf(Contrast::Kind::cineMr), number, threads_);
    std::vector<std::uint16_t> pixels;
    for (const float value : values)
      pixels.push_back(static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 65535.0F))));
    medical_io::writeCinePicture(
        folder_.add("cine/" + planes_[plane].name + numbered("/image", phase, ".dcm")), seriesOf(plane),
        phase, pixels);
  }

  /// `forward`: at places at rest; else from places to those at rest. Still tissue has zeros.
  deformation::DisplacementGrid fieldOf(const ImageGrid& grid, const std::vector<std::uint8_t>& labels,
                                        bool forward) const {
    deformation::DisplacementGrid field;
    field.size = Eigen::Vector3i(grid.size[0], grid.size[1], grid.size[2]);
    field.origin = grid.indexToLps.translation();
    field.spacing = options_.fieldSpacingMm;
    field.vectors.resize(static_cast<Eigen::Index>(grid.voxels()), 3);
    Points places(field.vectors.rows(), 3);
    for (Eigen::Index row = 0; row < places.rows(); ++row)
      places.row(row) = field.point(row).transpose();
    field.vectors = (forward ? motion_.moved(places) : motion_.restOf(places).points) - places;
    for (Eigen::Index row = 0; row < places.rows(); ++row)
      if (tissues()[labels[static_cast<std::size_t>(row)]].still)
        field.vectors.row(row).setZero();
    return field;
  }

  void writeFields(const PhantomInstant& instant, int phase) {
    const ImageGrid grid = bodyGrid(body_, Vec3::Constant(options_.fieldSpacingMm));
    const std::vector<std::uint8_t> rest = renderLabels(body_, atRest(body_, motion_), grid, threads_);
    const std::vector<std::uint8_t> now = renderLabels(body_, instant, grid, threads_);
    medical_io::writeTransform(folder_.add(numbered("forward", phase, options_.format)),
                               fieldOf(grid, rest, true));
    medical_io::writeTransform(folder_.add(numbered("backward", phase, options_.format)),
                               fieldOf(grid, now, false));
  }

  const PhantomOptions& options_;
  Threads threads_;
  PhantomBody body_;
  PhantomMotion motion_;
  WallPoints wall_;
  ImageGrid grid_;
  Folder folder_;
  std::vector<StudyPlane> planes_;
  std::vector<medical_io::Scan> scans_; ///< Of all phases, for one file over time.
  std::vector<medical_io::LabelMap> labels_;
  nlohmann::ordered_json json_;
  PhantomReport report_;
};

} // namespace

PhantomReport writePhantom(const fs::path& folder, const PhantomOptions& options,
                           const sample_organs::SampleLibrary& library, Progress& progress, Threads threads) {
  requireSound(options);
  std::unique_ptr<PhantomWriter> writer;
  constexpr double kPreparation = 0.1;
  runPart(progress, 0, kPreparation, [&](Progress& part) {
    writer = std::make_unique<PhantomWriter>(folder, options, library, part, threads);
  });
  PhantomReport report;
  runPart(progress, kPreparation, 1, [&](Progress& part) { report = writer->run(part); });
  return report;
}

} // namespace viscera::phantom
