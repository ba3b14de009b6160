#include <algorithm>

#include "fuzz_target.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/live/motion_series.h"
#include "viscera/live/retarget.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/surface_file.h"

/// Folders of surfaces as a motion, and landmarks.
namespace viscera::fuzz {
namespace {

// ---- series of surfaces -----------------------------------------------------------------------------------

constexpr std::string_view kNextPhase = "\n==next phase==\n";
constexpr int kMostPhases = 6;

/// Files of one folder, all of the format that the first byte chooses, as phases of one surface.
void readSurfacePhases(Bytes bytes) {
  const auto& endings = medical_io::endingsOf(medical_io::FileKind::surface);
  const Choice choice = choose(bytes, endings.size());
  const std::filesystem::path folder = scratchFolder() / "phases";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const std::string text = textOf(choice.rest);
  std::size_t begin = 0;
  for (int phase = 0; phase < kMostPhases && begin <= text.size(); ++phase) {
    const std::size_t end = std::min(text.find(kNextPhase, begin), text.size());
    scratchFile("phases/organ_" + std::to_string(phase) + endings[choice.kind],
                choice.rest.subspan(begin, end - begin));
    begin = end + kNextPhase.size();
  }
  live::SeriesRequest request;
  request.inputs = {folder};
  request.periodSeconds = 0.8;
  Progress progress;
  const live::MotionSeries series = live::readMotionSeries(request, progress);
  require(series.phases() >= 2, "A series has phases.");
  require(std::is_sorted(series.times.seconds.begin(), series.times.seconds.end()), "Times ascend.");
  require(series.volumesMl.size() == series.phases(), "Each phase has its volumes.");
  for (const tracking::SurfaceSeries& surface : series.corresponding)
    for (const Points& points : surface.phases)
      require(points.allFinite() && surface.triangles.maxCoeff() < points.rows(),
              "Each phase has the points of its triangles.");
  for (const auto& phase : series.meshes)
    for (const auto& mesh : phase)
      geometry::requireValid(*mesh, "a phase");
}

/// A tetrahedron that grows and shrinks again, of the same points in all phases or of others in the third.
std::string surfacePhases(std::size_t format, bool corresponding) {
  const tests::TemporaryFolder folder;
  const auto file = folder / ("a" + medical_io::endingsOf(medical_io::FileKind::surface)[format]);
  std::string out;
  int phase = 0;
  for (const double size : {60, 63, 66, 63}) {
    geometry::TriangleMesh mesh = tests::tetrahedron(size, size, size);
    if (!corresponding && phase == 2)
      mesh.triangles.row(0).swap(mesh.triangles.row(1));
    medical_io::writeSurface(file, mesh);
    out += (phase++ > 0 ? std::string(kNextPhase) : "") + tests::contentsOf(file);
  }
  return chosen(format, out);
}

std::vector<std::string> surfacePhaseSeeds() {
  std::vector<std::string> out;
  for (std::size_t format = 0; format < medical_io::endingsOf(medical_io::FileKind::surface).size(); ++format)
    try {
      out.push_back(surfacePhases(format, true));
    } catch (const CannotCreateError&) { // It is read, but not written.
    }
  out.push_back(surfacePhases(0, false));
  return out;
}

// ---- landmarks --------------------------------------------------------------------------------------------

const std::vector<std::string> kLandmarkEndings = {".mrk.json", ".fcsv"};
const std::vector<std::string> kFittedSequences = {"heartbeat", "peristalsis", "breathing"};

/// The first byte chooses the format and the sequence that asks for them.
void readLandmarks(Bytes bytes) {
  const Choice choice = choose(bytes, kLandmarkEndings.size() * kFittedSequences.size());
  const std::string& ending = kLandmarkEndings[choice.kind % kLandmarkEndings.size()];
  const std::string& sequence = kFittedSequences[choice.kind / kLandmarkEndings.size()];
  const auto read = [&](const std::filesystem::path& file) {
    return live::landmarksFrom(medical_io::readHandles(file), sequence, file.string());
  };
  const live::Landmarks landmarks = read(scratchFile("a" + ending, choice.rest));
  const auto written = scratchFolder() / "b.mrk.json";
  medical_io::writeHandles(written, live::landmarkFile(landmarks, "again"));
  const live::Landmarks again = read(written);
  require(again.points.size() == landmarks.points.size(), "Landmarks that are written and read are as many.");
  for (const live::Landmark& landmark : landmarks.points) {
    require(landmark.position.allFinite(), "A landmark has a place.");
    const auto same = [&](const live::Landmark& other) {
      return other.role == landmark.role && other.position == landmark.position;
    };
    require(std::any_of(again.points.begin(), again.points.end(), same),
            "Landmarks that are written and read have the same roles and places.");
  }
}

std::vector<std::string> landmarkSeeds() {
  const tests::TemporaryFolder folder;
  std::vector<std::string> out;
  for (std::size_t sequence = 0; sequence < kFittedSequences.size(); ++sequence) {
    live::Landmarks landmarks;
    for (const live::LandmarkRole& role : live::landmarkRoles(kFittedSequences[sequence]))
      for (int i = 0; i < (role.several ? 3 : 1); ++i)
        landmarks.points.push_back({role.role, Vec3(10 * i, 5, 40), false});
    if (landmarks.points.empty())
      continue; // No file of handles is without a point.
    for (std::size_t ending = 0; ending < kLandmarkEndings.size(); ++ending) {
      const auto file = folder / ("a" + kLandmarkEndings[ending]);
      medical_io::writeHandles(file, live::landmarkFile(landmarks, "landmarks"));
      out.push_back(chosen(sequence * kLandmarkEndings.size() + ending, tests::contentsOf(file)));
    }
  }
  return out;
}

} // namespace

std::vector<Target> motionTargets() {
  return {{"surface_series", readSurfacePhases, surfacePhaseSeeds},
          {"landmarks", readLandmarks, landmarkSeeds}};
}

} // namespace viscera::fuzz
