#include "viscera/coordinates/measure/scene.h"

#include <cmath>
#include <istream>
#include <locale>
#include <numbers>
#include <random>
#include <sstream>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/core/text.h"

namespace viscera::coordinates {
namespace {

constexpr int kOuterHandles = 12;
constexpr int kInnerHandles = 8;
constexpr double kRadius = 50;         ///< mm
constexpr double kInnerHandlesTo = 28; ///< Half a cube's side, mm.
constexpr double kPointsWithin = 30;   ///< mm; everything this near is inside the outer handles' hull.
constexpr unsigned kSceneSeed = 7;

/// The generator's numbers are the same everywhere; a standard distribution's are not.
class Uniform {
public:
  explicit Uniform(unsigned seed) : random_(seed) {}
  Vec3 inCube(double half) { return {within(half), within(half), within(half)}; }

private:
  double within(double half) {
    return half * (2 * static_cast<double>(random_()) / static_cast<double>(std::mt19937::max()) - 1);
  }
  std::mt19937 random_;
};

} // namespace

HandleSet handlesOfTable(std::istream& table, const std::string& where) {
  std::vector<Vec3> rows;
  int number = 0;
  for (std::string line; std::getline(table, line);) {
    ++number;
    if (line.empty() || line.starts_with('#'))
      continue;
    std::istringstream cells(line.substr(line.find(',') + 1));
    cells.imbue(std::locale::classic());
    Vec3& row = rows.emplace_back();
    char comma = 0;
    if (!(cells >> row[0] >> comma >> row[1] >> comma >> row[2]))
      throw DataError("It is not a row of a fiducial table", where + ", line " + std::to_string(number),
                      "it has to begin with id,x,y,z");
  }
  requireReadToEnd(table, where);
  return {pointsOf(rows), {}, {}};
}

Scene cloudScene(int points) {
  Scene scene;
  scene.name = "cloud";
  scene.handles.positions.resize(kOuterHandles + kInnerHandles, 3);
  Uniform random(kSceneSeed);
  // Even steps of z are even areas of the sphere, and turns by the golden angle never come near each other:
  // Fibonacci's lattice.
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < kOuterHandles; ++i) {
    const double z = 1 - (2 * i + 1.0) / kOuterHandles, r = std::sqrt(1 - z * z);
    // A little off the sphere: handles on one sphere are a special case for some systems.
    const double radius = kRadius * (1 + 0.04 * std::sin(3.0 * i));
    scene.handles.positions.row(i) << radius * Eigen::RowVector3d(r * std::cos(golden * i),
                                                                  r * std::sin(golden * i), z);
  }
  for (int i = 0; i < kInnerHandles; ++i)
    scene.handles.positions.row(kOuterHandles + i) = random.inCube(kInnerHandlesTo).transpose();
  scene.points.resize(points, 3);
  for (Eigen::Index i = 0; i < scene.points.rows();) {
    const Vec3 point = random.inCube(kPointsWithin);
    if (point.norm() <= kPointsWithin)
      scene.points.row(i++) = point.transpose();
  }
  return scene;
}

} // namespace viscera::coordinates
