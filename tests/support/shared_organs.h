#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "viscera/geometry/triangle_mesh.h"

/// Real surfaces beside the project, for tests that pass over them where they are absent.
namespace viscera::tests {

/// Reads the `v x y z` and triangular `f` lines of a Wavefront OBJ; all else is passed over. Only for tests
/// of modules that have no readers below them.
inline geometry::TriangleMesh readObj(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<Vec3> points;
  std::vector<Eigen::Vector3i> triangles;
  for (std::string line, word; std::getline(stream, line);) {
    std::istringstream words(line);
    words >> word;
    if (word == "v") {
      Vec3& point = points.emplace_back();
      words >> point[0] >> point[1] >> point[2];
    } else if (word == "f") {
      Eigen::Vector3i& triangle = triangles.emplace_back();
      for (int corner = 0; corner < 3; ++corner) {
        words >> word;
        triangle[corner] = std::stoi(word) - 1; // Stops at a slash.
      }
    }
  }
  geometry::TriangleMesh mesh;
  mesh.points.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    mesh.points.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    mesh.triangles.row(static_cast<Eigen::Index>(i)) = triangles[i].transpose();
  return mesh;
}

/// The Stanford bunny (35,947 vertices), scaled from metres to mm; nothing where `folder` has no bunny.obj.
inline std::optional<geometry::TriangleMesh> bunny(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "bunny.obj";
  if (!std::filesystem::exists(file))
    return std::nullopt;
  geometry::TriangleMesh mesh = readObj(file);
  mesh.points *= 1000;
  return mesh;
}

} // namespace viscera::tests
