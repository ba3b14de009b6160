#include "handle_owners.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

namespace viscera::presentation {
namespace {

/// Enough to tell two organs apart, and quick for organs of a million vertices.
constexpr Eigen::Index kMostPoints = 2000;

/// Some points of an organ's surface, and the box around them.
struct SparseOrgan {
  Points points;
  Eigen::AlignedBox3d box;
};

SparseOrgan sparse(const Points& points) {
  const Eigen::Index step = std::max<Eigen::Index>(1, points.rows() / kMostPoints);
  SparseOrgan organ;
  organ.points.resize((points.rows() + step - 1) / step, 3);
  for (Eigen::Index i = 0; i < organ.points.rows(); ++i) {
    organ.points.row(i) = points.row(i * step);
    organ.box.extend(Vec3(organ.points.row(i).transpose()));
  }
  return organ;
}

std::vector<std::shared_ptr<const document::Organ>> nearestOrgans(const document::Rig& rig,
                                                                  const document::OrganList& organs) {
  std::vector<SparseOrgan> surfaces;
  for (const auto& organ : organs)
    surfaces.push_back(sparse(organ->mesh->points));
  std::vector<std::shared_ptr<const document::Organ>> owners(rig.handles.size());
  const Points places = rig.restPositions();
  for (std::size_t row = 0; row < owners.size(); ++row) {
    const Vec3 place = places.row(static_cast<Eigen::Index>(row)).transpose();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      if (surfaces[i].points.rows() == 0 || surfaces[i].box.squaredExteriorDistance(place) >= least)
        continue;
      const double squared =
          (surfaces[i].points.rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff();
      if (squared < least) {
        least = squared;
        owners[row] = organs[i];
      }
    }
  }
  return owners;
}

} // namespace

bool HandleOwners::isOf(const document::DocumentState& state, std::size_t row, document::OrganId organ) {
  if (rig_ != state.rig || organs_ != state.organs) {
    rig_ = state.rig;
    organs_ = state.organs;
    owners_ = nearestOrgans(*rig_, *organs_);
  }
  const document::Organ* owner = owners_.at(row).get();
  if (!owner)
    return false;
  const auto belongs = [&](const document::Organ& other) {
    return other.id == organ && other.parent == owner->id;
  };
  return owner->id == organ || owner->parent == organ ||
         std::any_of(organs_->begin(), organs_->end(), [&](const auto& other) { return belongs(*other); });
}

} // namespace viscera::presentation
