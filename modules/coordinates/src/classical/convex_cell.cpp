#include "classical/convex_cell.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace viscera::coordinates {

ConvexCell::ConvexCell(double half) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-half, half}) {
      Face face;
      for (const auto& [u, v] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
        Vec3 corner;
        corner[axis] = side;
        corner[(axis + 1) % 3] = u * half;
        corner[(axis + 2) % 3] = v * half;
        face.push_back(corner);
      }
      if (side < 0)
        std::reverse(face.begin(), face.end());
      faces_.push_back(std::move(face));
    }
}

bool ConvexCell::cut(const Vec3& normal, double offset) {
  bool touched = false;
  for (const Face& face : faces_)
    for (const Vec3& corner : face)
      touched = touched || normal.dot(corner) > offset;
  if (!touched)
    return false;
  std::vector<Vec3> rim;
  std::vector<Face> kept;
  Face piece;
  for (const Face& face : faces_) {
    piece.clear();
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec3 &from = face[i], &to = face[(i + 1) % face.size()];
      const double begin = normal.dot(from) - offset, end = normal.dot(to) - offset;
      if (begin <= 0)
        piece.push_back(from);
      if ((begin <= 0) != (end <= 0)) {
        piece.push_back(from + begin / (begin - end) * (to - from));
        rim.push_back(piece.back());
      }
    }
    if (piece.size() >= 3)
      kept.push_back(piece);
  }
  faces_ = std::move(kept);
  close(rim, normal);
  return true;
}

/// The new face: the corners on the plane, in the order of their angles around their middle.
void ConvexCell::close(std::vector<Vec3>& rim, const Vec3& normal) {
  if (rim.size() < 3)
    return;
  Vec3 middle = Vec3::Zero();
  for (const Vec3& corner : rim)
    middle += corner;
  middle /= static_cast<double>(rim.size());
  const Vec3 x = normal.unitOrthogonal(), y = normal.normalized().cross(x);
  std::vector<std::pair<double, Vec3>> around;
  for (const Vec3& corner : rim)
    around.emplace_back(std::atan2(y.dot(corner - middle), x.dot(corner - middle)), corner);
  std::sort(around.begin(), around.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Face face;
  for (const auto& [angle, corner] : around)
    face.push_back(corner);
  faces_.push_back(std::move(face));
}

double ConvexCell::volume() const {
  if (empty())
    return 0;
  const Vec3 apex = faces_[0][0]; // Near the cell: the origin may be far from what is left.
  double volume = 0;
  for (const Face& face : faces_)
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      volume += (face[0] - apex).dot((face[i] - apex).cross(face[i + 1] - apex));
  return std::max(0.0, volume / 6);
}

double ConvexCell::reach() const {
  double reach = 0;
  for (const Face& face : faces_)
    for (const Vec3& corner : face)
      reach = std::max(reach, corner.cwiseAbs().maxCoeff());
  return reach;
}

} // namespace viscera::coordinates
