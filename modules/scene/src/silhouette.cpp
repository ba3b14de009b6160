#include "silhouette.h"

namespace viscera::scene {

void silhouette(const geometry::TriangleMesh& mesh, const geometry::Normals& normals, const Eye& eye,
                std::vector<float>& segments) {
  segments.clear();
  Values facing(mesh.points.rows());
  for (Eigen::Index i = 0; i < facing.size(); ++i) {
    const Vec3 toEye =
        eye.parallel ? Vec3(-eye.forward) : Vec3(eye.position - mesh.points.row(i).transpose());
    facing[i] = toEye.dot(normals.row(i).transpose().cast<double>());
  }
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corners = mesh.triangles.row(t);
    const bool front[3] = {facing[corners[0]] > 0, facing[corners[1]] > 0, facing[corners[2]] > 0};
    if (front[0] == front[1] && front[1] == front[2])
      continue;
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3;
      if (front[c] == front[d])
        continue;
      const double from = facing[corners[c]], to = facing[corners[d]];
      const double part = from / (from - to);
      for (int k = 0; k < 3; ++k) {
        const double a = mesh.points(corners[c], k), b = mesh.points(corners[d], k);
        segments.push_back(static_cast<float>(a + part * (b - a)));
      }
    }
  }
}

} // namespace viscera::scene
