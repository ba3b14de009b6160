#include "cut_picture.h"

#include <algorithm>

#include "viscera/geometry/plane_cut.h"
#include "viscera/presentation/resection.h"

namespace viscera::presentation {
namespace {

/// A face is a little paler than the surface, as cut flesh is.
constexpr double kPaler = 0.25;
/// The face of blood lies that far behind that of the tissue, mm, which so is seen where both are.
constexpr double kBloodBehind = 0.2;
/// The face of a vessel lies that far before that of the tissue around it, mm; that of the fat between the
/// atria, which reaches into their walls, that far behind it.
constexpr double kVesselsBefore = 0.1, kSeptumBehind = 0.1;
/// Corners of a face that lie that near to the line without them are left out, mm: filling a face takes most
/// of a frame, and more than in proportion to its corners.
constexpr double kStraightMm = 0.05;

using LayerKind = HeartPicture::Layer::Kind;

/// How far the face of a layer lies before that of the tissue, mm.
double towardsReader(LayerKind kind) {
  if (kind == LayerKind::vessels)
    return kVesselsBefore;
  return kind == LayerKind::septum ? -kSeptumBehind : -kBloodBehind;
}

bool cutWanted(const Scene& scene) {
  return scene.view.cut.on && !scene.view.shown.stress && !scene.state.organs->empty();
}

const document::Organ* parentOf(const document::Organ& organ, const document::DocumentState& state) {
  for (const auto& other : *state.organs)
    if (other->id == organ.parent)
      return other.get();
  return nullptr;
}

/// Whether an organ is a hollow in another one that is seen.
bool hollow(const document::Organ& organ, const document::DocumentState& state) {
  const document::Organ* parent = parentOf(organ, state);
  return parent && parent->look.visible;
}

Vec3 paler(const Vec3& color) {
  return (1 - kPaler) * color + kPaler * Vec3::Ones();
}

Vec3 faceColor(const document::Organ& organ) {
  return paler(shownColor(organ.look.color));
}

double distanceToSegment(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double length = along.squaredNorm();
  const double part = length > 0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0.0;
  return (from + part * along - point).norm();
}

/// The corners that a closed line keeps: from each the next one as far as all between lie on the way.
std::vector<Eigen::Index> cornersOf(const Points& points, Eigen::Index begin, Eigen::Index end) {
  std::vector<Eigen::Index> kept = {begin};
  for (Eigen::Index next = begin + 2; next <= end; ++next) {
    const Vec3 from = points.row(kept.back()), to = points.row(next < end ? next : begin);
    bool straight = true;
    for (Eigen::Index between = kept.back() + 1; straight && between < next; ++between)
      straight = distanceToSegment(points.row(between), from, to) <= kStraightMm;
    if (!straight)
      kept.push_back(next - 1);
  }
  return kept;
}

/// The closed lines of a cut with fewer corners.
geometry::PlaneCut withoutStraightCorners(const geometry::PlaneCut& cut) {
  constexpr std::size_t kFewest = 3;
  geometry::PlaneCut few;
  std::vector<Vec3> corners;
  few.first = {0};
  for (std::size_t line = 0; line < cut.lines(); ++line) {
    const auto kept = cornersOf(cut.points, cut.first[line], cut.first[line + 1]);
    if (!cut.closed[line] || kept.size() < kFewest)
      continue;
    for (const Eigen::Index corner : kept)
      corners.push_back(cut.points.row(corner).transpose());
    few.first.push_back(static_cast<std::int32_t>(corners.size()));
    few.closed.push_back(true);
  }
  few.points = pointsOf(corners);
  few.lengthMm = cut.lengthMm;
  return few;
}

bool isIn(const document::Organ& organ, const live::SampleHeartOrgans& heart) {
  const auto same = [&](const auto& other) { return other->id == organ.id; };
  return same(heart.outer) || std::any_of(heart.cavities.begin(), heart.cavities.end(), same);
}

} // namespace

std::vector<scene::CutCaps::Face> CutPicture::facesOf(const Scene& scene, const HeartPicture& heart) const {
  const geometry::Plane plane{plane_->origin, plane_->normal};
  const auto cutOf = [&scene](const document::Organ& organ, const geometry::Plane& at) {
    const auto points = scene.organs.sharedPoints(organ.id);
    return geometry::cutSurface({points.get(), &organ.mesh->triangles}, at);
  };
  std::vector<scene::CutCaps::Face> faces;
  if (const auto& opened = heart.opened()) {
    faces.push_back({withoutStraightCorners(geometry::cutSurface(heart.surface(), plane)),
                     {},
                     faceColor(*opened->heart.outer)});
    for (const HeartPicture::Layer& layer : heart.layers()) {
      const geometry::Plane at{plane.origin - towardsReader(layer.kind) * plane.normal, plane.normal};
      const Vec3 color = layer.kind == LayerKind::blood ? layer.color : paler(layer.color);
      faces.push_back({withoutStraightCorners(geometry::cutSurface(layer.surface, at)), {}, color});
    }
  }
  for (const auto& organ : *scene.state.organs) {
    if (!organ->look.visible || !organ->closed() || hollow(*organ, scene.state) ||
        (heart.opened() && isIn(*organ, heart.opened()->heart)))
      continue;
    scene::CutCaps::Face face{cutOf(*organ, plane), {}, faceColor(*organ)};
    for (const auto& other : *scene.state.organs)
      if (other->parent == organ->id && other->closed())
        face.cavities.push_back(cutOf(*other, plane));
    faces.push_back(std::move(face));
  }
  return faces;
}

void CutPicture::update(const Scene& scene, const HeartPicture& heart) {
  const auto plane = cutWanted(scene) ? std::optional(planeOf(scene.view.cut, scene.state)) : std::nullopt;
  Moment moment;
  if (plane)
    for (const auto& organ : *scene.state.organs)
      moment[organ->id] = {scene.organs.sharedPoints(organ->id), scene.organs.revision(organ->id)};
  if (plane == plane_ && moment == moment_ && heart_ == heart.revision() &&
      (!plane || organs_ == scene.state.organs))
    return;
  plane_ = plane;
  moment_ = std::move(moment);
  heart_ = heart.revision();
  organs_ = scene.state.organs;
  caps_.setFaces(plane_ ? facesOf(scene, heart) : std::vector<scene::CutCaps::Face>(),
                 plane_ ? Vec3(-plane_->normal) : Vec3::UnitZ());
}

void CutPicture::apply(const Scene& scene, std::map<document::OrganId, Appearance>& appearances) const {
  if (!plane_)
    return;
  for (const auto& organ : *scene.state.organs) {
    const auto [found, fresh] = appearances.try_emplace(organ->id);
    if (fresh)
      found->second = {organ->look.visible, organ->look.opacity};
    found->second.clip = plane_;
  }
}

} // namespace viscera::presentation
