#include "heart_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace viscera::presentation {
namespace {

bool sameHeart(const OpenedHeart& a, const OpenedHeart& b) {
  return a.heart.outer == b.heart.outer && a.heart.cavities == b.heart.cavities && a.blood == b.blood;
}

/// Blood rich and poor in oxygen, as atlases paint it.
const std::array<Vec3, 2> kBloodColors = {Vec3(0.78, 0.16, 0.15), Vec3(0.27, 0.36, 0.66)};
/// So near to the cut, vessels in the muscle are seen in its face.
constexpr double kSeenInFaceMm = 1.5;
/// Between the ventricles' vertices that far from the cut at most, muscle that is that thick at most is their
/// septum in its face; its place is that little behind the plane, which so does not cut it away.
constexpr double kNearCutMm = 3, kThickestSeptumMm = 15, kInFaceMm = 0.01;
/// The ventricle of each side; one that is hidden has no blood.
constexpr std::array<const char*, 2> kVentricles = {"lv", "rv"};
constexpr const char *kSeptum = "Interventricular septum", *kAtrialSeptum = "Interatrial septum";

/// The face of a cut is in that point's place on the plane; it is moved there along the normal.
Points inFace(const Vec3& point, const scene::CutPlane& plane) {
  const double height = (point - plane.origin).dot(plane.normal) - kInFaceMm;
  return (point - height * plane.normal).transpose();
}

Vec3 colorOf(const geometry::TriangleMesh& mesh) {
  constexpr double kBrightest = 255;
  if (mesh.colors.rows() == 0)
    return Vec3::Ones();
  return mesh.colors.row(0).cast<double>().transpose() / kBrightest;
}

std::vector<Eigen::Index> verticesNear(const scene::CutPlane& plane, const Points& points) {
  std::vector<Eigen::Index> near;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (std::abs((points.row(i).transpose() - plane.origin).dot(plane.normal)) < kNearCutMm)
      near.push_back(i);
  return near;
}

using Kind = live::HeartVessels::Kind;
constexpr std::array<Kind, 2> kKinds = {Kind::arteries, Kind::veins};

} // namespace

HeartPicture::~HeartPicture() {
  leave();
}

void HeartPicture::leave() {
  if (!opened_)
    return;
  view_.remove(actor_);
  for (Drawn& layer : layers_)
    if (std::exchange(layer.added, false))
      view_.remove(layer.actor);
  opened_.reset();
  septum_.reset();
  atrialMet_ = false;
  septumPlane_.reset();
  ++revision_;
}

void HeartPicture::take(std::shared_ptr<const live::HeartTissue> tissue) {
  if (tissue_ == tissue)
    return;
  leave();
  tissue_ = std::move(tissue);
  actor_ = std::make_shared<scene::OrganActor>(tissue_->mesh(), threads_);
  actor_->setRole(scene::SurfaceRole::picture);
  addActors();
  points_ = std::make_shared<Points>();
  moment_.clear();
  plane_.reset();
}

HeartPicture::Layer::Kind HeartPicture::kindOf(std::size_t layer) {
  if (layer == kSeptumLayer)
    return Layer::Kind::septum;
  return layer < kVesselLayers ? Layer::Kind::vessels : Layer::Kind::blood;
}

/// What a layer is drawn from, at rest; null where there is nothing of it.
std::shared_ptr<const geometry::TriangleMesh> HeartPicture::meshOf(std::size_t layer) const {
  if (layer == kSeptumLayer)
    return tissue_->septum();
  if (layer < kVesselLayers)
    return tissue_->vessels().mesh(kKinds[layer]);
  const auto& blood = tissue_->blood()[layer - kFirstBlood];
  return blood ? blood->mesh() : nullptr;
}

void HeartPicture::addActors() {
  for (std::size_t i = 0; i < kLayers; ++i) {
    const auto mesh = meshOf(i);
    layers_[i] = {};
    if (!mesh || mesh->triangles.rows() == 0)
      continue;
    const Layer::Kind kind = kindOf(i);
    scene::OrganActor& actor = *(layers_[i].actor = std::make_shared<scene::OrganActor>(mesh, threads_));
    actor.setRole(kind == Layer::Kind::blood ? scene::SurfaceRole::filling : scene::SurfaceRole::picture);
    actor.setVertexColorsShown(false);
    if (kind == Layer::Kind::septum)
      actor.setColor(colorOf(*mesh));
    else
      actor.setColor(kind == Layer::Kind::vessels ? tissue_->vessels().color(kKinds[i])
                                                  : kBloodColors[i - kFirstBlood]);
  }
}

/// Whether a layer belongs into the picture of the opened heart.
bool HeartPicture::wanted(std::size_t layer) const {
  if (kindOf(layer) != Layer::Kind::blood || !layers_[layer].actor)
    return layers_[layer].actor != nullptr;
  const auto& cavities = opened_->heart.cavities;
  return opened_->blood && std::any_of(cavities.begin(), cavities.end(), [&](const auto& cavity) {
           return cavity->origin.surface == kVentricles[layer - kFirstBlood] && cavity->look.visible;
         });
}

void HeartPicture::showLayers() {
  for (std::size_t i = 0; i < kLayers; ++i) {
    Drawn& layer = layers_[i];
    if (wanted(i) == layer.added)
      continue;
    layer.added = !layer.added;
    if (layer.added)
      view_.add(layer.actor);
    else
      view_.remove(layer.actor);
    moment_.clear(); // What is hidden is not kept up to date.
    plane_.reset();
    ++revision_;
  }
}

void HeartPicture::update(const Scene& scene, bool numbers) {
  std::optional<OpenedHeart> wanted;
  if (scene.heartTissue && !numbers)
    wanted = openedHeart(scene.state, scene.view);
  if (!wanted || !scene.heartTissue->isOf(wanted->heart))
    return leave();
  take(scene.heartTissue);
  if (!opened_)
    view_.add(actor_);
  if (!opened_ || !sameHeart(*opened_, *wanted))
    ++revision_;
  opened_ = std::move(wanted);
  showLayers();
  follow(scene.organs);
}

void HeartPicture::moveLayers(const Points& carriers) {
  tissue_->vessels().linesAt(carriers, *lines_, Threads{1}); // So few that waking others takes longer.
  for (std::size_t i = 0; i < kLayers; ++i) {
    Drawn& layer = layers_[i];
    if (!layer.added)
      continue;
    if (i < kVesselLayers)
      tissue_->vessels().surfaceAt(kKinds[i], *lines_, *layer.points);
    else if (i == kSeptumLayer)
      tissue_->septumAt(carriers, *layer.points, Threads{1});
    else
      tissue_->blood()[i - kFirstBlood]->at(*points_, *layer.points);
    layer.actor->setPoints(layer.points);
  }
}

std::vector<HeartPicture::Layer> HeartPicture::layers() const {
  std::vector<Layer> drawn;
  for (std::size_t i = 0; i < kLayers; ++i)
    if (const Drawn& layer = layers_[i]; opened_ && layer.added)
      drawn.push_back(
          {{layer.points.get(), &layer.actor->mesh().triangles}, layer.actor->color(), kindOf(i)});
  return drawn;
}

bool HeartPicture::full() const {
  return opened_ && std::any_of(layers_.begin() + kFirstBlood, layers_.end(),
                                [](const Drawn& layer) { return layer.added; });
}

bool HeartPicture::isCavity(document::OrganId organ) const {
  return opened_ && std::any_of(opened_->heart.cavities.begin(), opened_->heart.cavities.end(),
                                [&](const auto& cavity) { return cavity->id == organ; });
}

/// The middle of the longest part that stays of a vessel with each name: at rest, so that names stay in one
/// place while the heart beats.
std::vector<HeartPicture::VesselName> HeartPicture::vesselNames(const scene::CutPlane& plane) const {
  if (!opened_)
    return {};
  std::map<std::string, std::pair<std::size_t, VesselName>> best; // How much stays, and where.
  const auto& vessels = tissue_->vessels().vessels();
  for (std::size_t i = 0; i < vessels.size(); ++i) {
    std::vector<Eigen::Index> kept;
    const double highest = vessels[i].inWall ? kSeenInFaceMm : std::numeric_limits<double>::infinity();
    for (Eigen::Index p = 0; p < vessels[i].axis.rows(); ++p) {
      const double height = (vessels[i].axis.row(p).transpose() - plane.origin).dot(plane.normal);
      if (height > 0 && height < highest)
        kept.push_back(tissue_->vessels().first(i) + p);
    }
    auto& [most, where] = best[vessels[i].name];
    if (kept.size() > most) {
      most = kept.size();
      where = {vessels[i].name, kept[kept.size() / 2], vessels[i].inWall};
    }
  }
  std::vector<VesselName> names;
  for (const auto& [name, place] : best)
    if (place.first > 0)
      names.push_back(place.second);
  return names;
}

/// The muscle between the ventricles where the plane meets it: of the left one's vertices there that have the
/// right one behind them, the one in the middle.
void HeartPicture::findSeptum(const scene::CutPlane& plane) {
  septum_.reset();
  const auto ventricle = [&](const char* surface) -> const document::Organ* {
    const auto& cavities = opened_->heart.cavities;
    const auto found = std::find_if(cavities.begin(), cavities.end(),
                                    [&](const auto& cavity) { return cavity->origin.surface == surface; });
    return found == cavities.end() ? nullptr : found->get();
  };
  const document::Organ *left = ventricle(kVentricles[0]), *right = ventricle(kVentricles[1]);
  if (!left || !right)
    return;
  const Points &leftPoints = left->mesh->points, &rightPoints = right->mesh->points;
  const std::vector<Eigen::Index> lefts = verticesNear(plane, leftPoints);
  const std::vector<Eigen::Index> rights = verticesNear(plane, rightPoints);
  std::vector<std::pair<Eigen::Index, Eigen::Index>> across;
  Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
  for (const Eigen::Index i : lefts) {
    const auto away = [&](Eigen::Index k) { return (rightPoints.row(k) - leftPoints.row(i)).norm(); };
    const auto nearest =
        std::min_element(rights.begin(), rights.end(), [&](auto a, auto b) { return away(a) < away(b); });
    if (nearest == rights.end() || away(*nearest) > kThickestSeptumMm)
      continue;
    across.emplace_back(i, *nearest);
    middle += leftPoints.row(i);
  }
  if (across.empty())
    return;
  middle /= static_cast<double>(across.size());
  const auto fromMiddle = [&](const auto& pair) { return (leftPoints.row(pair.first) - middle).norm(); };
  const auto best = *std::min_element(across.begin(), across.end(), [&](const auto& a, const auto& b) {
    return fromMiddle(a) < fromMiddle(b);
  });
  septum_ = Septum{left->id, right->id, best.first, best.second};
}

/// The mean of those vertices of the septum between the atria that are near the plane now: in its middle
/// there, since what a plane cuts of it is small and convex.
void HeartPicture::updateAtrialSeptum(const scene::CutPlane& plane) {
  atrialMet_ = false;
  const Drawn& layer = layers_[kSeptumLayer];
  if (!layer.added || layer.points->rows() == 0)
    return;
  const Values heights = *layer.points * plane.normal;
  const double level = plane.origin.dot(plane.normal);
  if (heights.minCoeff() >= level || heights.maxCoeff() <= level)
    return;
  const std::vector<Eigen::Index> near = verticesNear(plane, *layer.points);
  if (near.empty())
    return;
  Vec3 sum = Vec3::Zero();
  for (const Eigen::Index vertex : near)
    sum += layer.points->row(vertex).transpose();
  *atrialPoint_ = inFace(sum / static_cast<double>(near.size()), plane);
  atrialMet_ = true;
}

std::vector<HeartPicture::SeptumName> HeartPicture::septa() const {
  std::vector<SeptumName> met;
  if (opened_ && septum_)
    met.push_back({kSeptum, septumPoint_});
  if (opened_ && atrialMet_)
    met.push_back({kAtrialSeptum, atrialPoint_});
  return met;
}

void HeartPicture::updateSepta(const scene::CutPlane& plane, const live::PosedOrgans& organs) {
  if (!opened_)
    return;
  if (septumPlane_ != plane)
    findSeptum(plane);
  septumPlane_ = plane;
  if (septum_) {
    const Vec3 left = organs.sharedPoints(septum_->left)->row(septum_->leftVertex).transpose();
    const Vec3 right = organs.sharedPoints(septum_->right)->row(septum_->rightVertex).transpose();
    *septumPoint_ = inFace((left + right) / 2, plane);
  }
  updateAtrialSeptum(plane);
}

void HeartPicture::follow(const live::PosedOrgans& organs) {
  const live::SampleHeartOrgans& heart = opened_->heart;
  const auto placeOf = [&](const document::Organ& organ) {
    return std::pair(organs.sharedPoints(organ.id), organs.revision(organ.id));
  };
  Moment now = {placeOf(*heart.outer)};
  for (const auto& cavity : heart.cavities)
    now.push_back(placeOf(*cavity));
  if (now == moment_)
    return;
  const bool first = moment_.empty();
  moment_ = std::move(now);
  const Points carriers = tissue_->carriersAt(heart, organs);
  tissue_->at(carriers, *points_, threads_);
  if (first)
    actor_->setPoints(points_);
  else
    actor_->pointsChanged();
  moveLayers(carriers);
  ++revision_;
}

void HeartPicture::apply(std::map<document::OrganId, Appearance>& appearances) const {
  if (!opened_)
    return;
  const auto hide = [&](const document::Organ& organ) {
    Appearance& appearance =
        appearances.try_emplace(organ.id, Appearance{organ.look.visible, organ.look.opacity}).first->second;
    appearance.drawn = false;
    appearance.opacity = 1; // Names are hidden by tissue, which is opaque.
  };
  hide(*opened_->heart.outer);
  for (const auto& cavity : opened_->heart.cavities)
    hide(*cavity);
}

void HeartPicture::updateLook(const scene::OrganActor& outer, const scene::CutPlane& plane) {
  const document::OrganLook& look = opened_->heart.outer->look;
  actor_->setColor(shownColor(look.color));
  actor_->setVertexColorsShown(look.vertexColors);
  actor_->setSelected(outer.selected());
  if (plane_ != plane) {
    actor_->setClipPlane(plane.origin, plane.normal);
    for (const Drawn& layer : layers_)
      if (layer.actor)
        layer.actor->setClipPlane(plane.origin, plane.normal);
  }
  plane_ = plane;
}

} // namespace viscera::presentation
