#include "slice_cuts.h"

#include <algorithm>
#include <utility>

#include "viscera/document/rig.h"

namespace viscera::presentation {
namespace {

bool samePlane(const geometry::Plane& a, const geometry::Plane& b) {
  return a.origin == b.origin && a.normal == b.normal;
}

bool posed(const document::DocumentState& state, const live::PosedOrgans& organs) {
  const Points& now = organs.shownPose();
  const Points& rest = state.rig->restPositions();
  return now.rows() == rest.rows() && now != rest;
}

} // namespace

/// Cuts these organs by these planes, and keeps the results in their places.
void SliceCuts::cut(const std::vector<std::size_t>& which, const std::vector<std::size_t>& planes,
                    bool rest) {
  if (which.empty() || planes.empty())
    return;
  std::vector<geometry::SurfaceView> surfaces;
  for (const std::size_t i : which) {
    const geometry::TriangleMesh& mesh = *known_[i].mesh;
    surfaces.push_back({rest ? &mesh.points : known_[i].points.get(), &mesh.triangles});
  }
  std::vector<geometry::Plane> by;
  for (const std::size_t k : planes)
    by.push_back(planes_[k]);
  auto cuts = geometry::cutSurfaces(surfaces, by, threads_);
  for (std::size_t i = 0; i < which.size(); ++i) {
    auto& kept = rest ? organs_[which[i]].rest : organs_[which[i]].posed;
    kept.resize(planes_.size());
    for (std::size_t k = 0; k < planes.size(); ++k)
      kept[planes[k]] = std::move(cuts[i][k]);
  }
}

void SliceCuts::update(const document::DocumentState& state, const live::PosedOrgans& organs,
                       const std::vector<geometry::Plane>& planes, bool rest) {
  std::vector<std::size_t> moved, all;
  const bool others = planes.size() != planes_.size();
  for (std::size_t k = 0; k < planes.size(); ++k) {
    all.push_back(k);
    if (others || !samePlane(planes[k], planes_[k]))
      moved.push_back(k);
  }
  planes_ = planes;
  std::vector<Organ> before = std::exchange(organs_, {});
  std::vector<Known> knownBefore = std::exchange(known_, {});
  const bool withRest = rest && posed(state, organs);
  std::vector<std::size_t> anew, stayed, restAnew, restStayed;
  for (const auto& organ : *state.organs) {
    if (!organ->look.visible)
      continue;
    const std::size_t index = organs_.size();
    const Known now{organs.sharedPoints(organ->id), organs.revision(organ->id), organ->mesh};
    const auto found = std::find_if(before.begin(), before.end(), [&](const Organ& item) {
      return item.organ && item.organ->id == organ->id; // Those that were found are empty.
    });
    const Known* known = found == before.end() ? nullptr : &knownBefore[std::size_t(found - before.begin())];
    organs_.push_back(known && !others ? std::move(*found) : Organ());
    organs_.back().organ = organ;
    const bool sameMesh = known && known->mesh == now.mesh && !others;
    const bool same = sameMesh && known->points == now.points && known->revision == now.revision;
    (same ? stayed : anew).push_back(index);
    if (withRest)
      (sameMesh && !organs_.back().rest.empty() ? restStayed : restAnew).push_back(index);
    else
      organs_.back().rest.clear();
    known_.push_back(now);
  }
  cut(anew, all, false);
  cut(stayed, moved, false);
  cut(restAnew, all, true);
  cut(restStayed, moved, true);
}

} // namespace viscera::presentation
