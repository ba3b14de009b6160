#include "viscera/live/heart_tissue.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "sample_heart.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::live {
namespace {

using Mesh = std::shared_ptr<const geometry::TriangleMesh>;

constexpr const char *kOuter = "outer", *kTissue = "tissue";
constexpr std::array<std::string_view, 4> kCavities = {"lv", "rv", "la", "ra"};
/// Making the outer surface, which is in the cache as a rule, and then the tissue.
constexpr double kOuterPart = 0.1, kTissueDone = 0.95;

std::vector<Mesh> meshesOf(const SampleHeartOrgans& heart) {
  std::vector<Mesh> meshes = {heart.outer->mesh};
  for (const auto& cavity : heart.cavities)
    meshes.push_back(cavity->mesh);
  return meshes;
}

/// All points below each other, in their order.
template <class Parts, class PointsOf>
Points stacked(const Parts& parts, const PointsOf& pointsOf) {
  Eigen::Index rows = 0;
  for (const auto& part : parts)
    rows += pointsOf(part).rows();
  Points all(rows, 3);
  Eigen::Index row = 0;
  for (const auto& part : parts) {
    const Points& points = pointsOf(part);
    all.middleRows(row, points.rows()) = points;
    row += points.rows();
  }
  return all;
}

bool sameSurface(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b) {
  return a.points.rows() == b.points.rows() && a.triangles.rows() == b.triangles.rows() &&
         a.points == b.points && a.triangles == b.triangles;
}

Points verticesOf(const std::vector<Mesh>& meshes) {
  return stacked(meshes, [](const Mesh& mesh) -> const Points& { return mesh->points; });
}

} // namespace

std::optional<SampleHeartOrgans> sampleHeartIn(const document::DocumentState& state) {
  SampleHeartOrgans heart;
  for (const auto& organ : *state.organs)
    if (organ->look.visible && organ->origin.surface == kOuter && heartResolutionOf(organ->origin)) {
      heart.outer = organ;
      break;
    }
  if (!heart.outer)
    return std::nullopt;
  // The command line has the surfaces beside each other, without a parent.
  const auto isOfIt = [&](const document::Organ& organ) {
    return (!organ.parent || organ.parent == heart.outer->id) &&
           organ.origin.sample == heart.outer->origin.sample;
  };
  for (const auto& organ : *state.organs)
    if (isOfIt(*organ) && std::count(kCavities.begin(), kCavities.end(), organ->origin.surface) > 0)
      heart.cavities.push_back(organ);
  return heart;
}

bool sameSurfaces(const SampleHeartOrgans& a, const SampleHeartOrgans& b) {
  return meshesOf(a) == meshesOf(b);
}

HeartTissue::HeartTissue(HeartSurfaces surfaces, const SampleHeartOrgans& heart, Threads threads)
    : mesh_(std::move(surfaces.tissue)), heart_(heart),
      carried_(mesh_->points, verticesOf(meshesOf(heart)), threads),
      vessels_(std::move(surfaces.vessels), verticesOf(meshesOf(heart)), threads),
      septum_(std::move(surfaces.septum)) {
  if (septum_)
    carriedSeptum_.emplace(septum_->points, verticesOf(meshesOf(heart)), threads);
  for (std::size_t side = 0; side < blood_.size(); ++side)
    if (surfaces.lumina[side])
      blood_[side] = std::make_unique<const HeartBlood>(*surfaces.lumina[side], *mesh_);
}

Points HeartTissue::carriersAt(const SampleHeartOrgans& heart, const PosedOrgans& organs) const {
  std::vector<std::shared_ptr<const Points>> parts = {organs.sharedPoints(heart.outer->id)};
  for (const auto& cavity : heart.cavities)
    parts.push_back(organs.sharedPoints(cavity->id));
  return stacked(parts, [](const auto& part) -> const Points& { return *part; });
}

void HeartTissue::at(const Points& carriers, Points& out, Threads threads) const {
  carried_.at(carriers, out, threads);
}

void HeartTissue::septumAt(const Points& carriers, Points& out, Threads threads) const {
  if (!carriedSeptum_)
    throw UsageError(misuse("this heart has nothing between its atria"));
  carriedSeptum_->at(carriers, out, threads);
}

void HeartTissue::at(const SampleHeartOrgans& heart, const PosedOrgans& organs, Points& out,
                     Threads threads) const {
  at(carriersAt(heart, organs), out, threads);
}

std::shared_ptr<const HeartTissue> makeHeartTissue(const SampleHeartOrgans& heart,
                                                   const sample_organs::SampleLibrary& library,
                                                   Progress& progress, Threads threads) {
  const auto resolution = heartResolutionOf(heart.outer->origin).value();
  const auto surface = [&](const char* name, double from, double to) {
    Mesh mesh;
    runPart(progress, from, to,
            [&](Progress& part) { mesh = heartSurface(library, name, resolution, part, threads); });
    return mesh;
  };
  if (!sameSurface(*surface(kOuter, 0, kOuterPart), *heart.outer->mesh))
    return nullptr;
  HeartSurfaces surfaces{surface(kTissue, kOuterPart, kTissueDone)};
  // The tissue was made of these, so that they are in the cache.
  surfaces.lumina = {surface("blood_left", kTissueDone, 1), surface("blood_right", kTissueDone, 1)};
  surfaces.vessels = heartVessels(library, resolution);
  surfaces.septum = surface("atrial_septum", kTissueDone, 1);
  return std::make_shared<const HeartTissue>(std::move(surfaces), heart, threads);
}

} // namespace viscera::live
