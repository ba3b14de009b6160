#include "viscera/live/heart_vessels.h"

#include <algorithm>
#include <utility>

namespace viscera::live {
namespace {

bool isVein(const geometry::NamedVessel& vessel) {
  return vessel.color.z() > vessel.color.x();
}

std::vector<geometry::NamedVessel> arteriesFirst(std::vector<geometry::NamedVessel> vessels) {
  std::stable_partition(vessels.begin(), vessels.end(), [](const auto& vessel) { return !isVein(vessel); });
  return vessels;
}

Points linesOf(const std::vector<geometry::NamedVessel>& vessels) {
  Eigen::Index rows = 0;
  for (const auto& vessel : vessels)
    rows += vessel.axis.rows();
  Points all(rows, 3);
  Eigen::Index row = 0;
  for (const auto& vessel : vessels) {
    all.middleRows(row, vessel.axis.rows()) = vessel.axis;
    row += vessel.axis.rows();
  }
  return all;
}

} // namespace

HeartVessels::HeartVessels(std::vector<geometry::NamedVessel> vessels, const Points& carriers,
                           Threads threads)
    : vessels_(arteriesFirst(std::move(vessels))), carried_(linesOf(vessels_), carriers, threads) {
  Eigen::Index row = 0;
  for (const auto& vessel : vessels_) {
    first_.push_back(row);
    row += vessel.axis.rows();
  }
  const Points lines = linesOf(vessels_);
  const auto veins =
      static_cast<std::size_t>(std::find_if(vessels_.begin(), vessels_.end(), isVein) - vessels_.begin());
  sides_.push_back(sideOf(0, veins, lines));
  sides_.push_back(sideOf(veins, vessels_.size(), lines));
}

HeartVessels::Side HeartVessels::sideOf(std::size_t begin, std::size_t end, const Points& lines) const {
  std::vector<Eigen::Index> counts;
  std::vector<double> radii;
  for (std::size_t i = begin; i < end; ++i) {
    counts.push_back(vessels_[i].axis.rows());
    for (const double radius : vessels_[i].radii)
      radii.push_back(radius + kOverMm);
  }
  const auto rows = static_cast<Eigen::Index>(radii.size());
  Side side{begin < end ? first_[begin] : lines.rows(), rows,
            geometry::SweptTubes(std::move(counts), Values(Eigen::Map<const Values>(radii.data(), rows))),
            begin < end ? vessels_[begin].color : Vec3(Vec3::Ones()), nullptr};
  geometry::TriangleMesh mesh;
  side.tubes.at(lines.middleRows(side.begin, rows), mesh.points);
  mesh.triangles = side.tubes.triangles();
  side.mesh = std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
  return side;
}

void HeartVessels::linesAt(const Points& carriers, Points& lines, Threads threads) const {
  carried_.at(carriers, lines, threads);
}

void HeartVessels::surfaceAt(Kind kind, const Points& lines, Points& out) const {
  const Side& which = side(kind);
  which.tubes.at(lines.middleRows(which.begin, which.rows), out);
}

} // namespace viscera::live
