#include "viscera/live/stress_difference.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "viscera/core/atomic_file.h"
#include "viscera/core/text.h"
#include "viscera/medical_io/solid_file.h"

namespace viscera::live {
namespace {

constexpr int kDifferenceDigits = 9;

/// A quantity with its name in files.
struct NamedDifference {
  std::string name;
  const Values& values;
};

std::vector<NamedDifference> namedDifferences(const StressDifference& difference) {
  std::vector<NamedDifference> all = {{"stress_degrees_difference", difference.stressDegrees},
                                      {"volume_ratio_difference", difference.volumeRatio},
                                      {"stretch_max_difference", difference.stretchMax},
                                      {"stretch_min_difference", difference.stretchMin}};
  if (difference.material.stated()) {
    const std::string material = ", " + nameOf(difference.material).english();
    all.push_back({"von_mises_kpa_difference" + material, difference.vonMisesKpa});
    all.push_back({"strain_energy_kpa_difference" + material, difference.energyKpa});
  }
  return all;
}

void writeDifferenceTable(const std::filesystem::path& file, const StressFrame& frame,
                          const StressDifference& difference) {
  writeAtomically(file, [&](std::ostream& stream) {
    stream << "rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm";
    for (const NamedDifference& one : namedDifferences(difference))
      stream << ',' << csvField(one.name);
    stream << '\n';
    for (Eigen::Index i = 0; i < frame.mesh->witnesses; ++i) {
      std::string row;
      for (const Points* places : {&frame.mesh->points, frame.points.get()})
        for (int axis = 0; axis < 3; ++axis)
          row += (row.empty() ? "" : ",") + significant((*places)(i, axis), kDifferenceDigits);
      for (const NamedDifference& one : namedDifferences(difference))
        row += ',' +
               (std::isfinite(one.values[i]) ? significant(one.values[i], kDifferenceDigits) : std::string());
      stream << row << '\n';
    }
  });
}

} // namespace

std::optional<StressDifference> stressDifference(const StressFrame& a, const StressFrame& b,
                                                 const elasticity::StatedMaterial& material) {
  auto degrees = differenceOf(a, b, StressQuantity::rotationalStress);
  auto ratio = differenceOf(a, b, StressQuantity::volumeRatio);
  auto most = differenceOf(a, b, StressQuantity::stretchMax);
  auto least = differenceOf(a, b, StressQuantity::stretchMin);
  if (!degrees || !ratio || !most || !least)
    return std::nullopt;
  StressDifference difference{std::move(*degrees), std::move(*ratio), std::move(*most), std::move(*least)};
  if (material.stated()) {
    difference.vonMisesKpa = *differenceOf(a, b, {StressQuantity::vonMises, material});
    difference.energyKpa = *differenceOf(a, b, {StressQuantity::energy, material});
    difference.material = material;
  }
  return difference;
}

void writeStressDifference(const std::filesystem::path& file, const StressFrame& a,
                           const StressDifference& difference) {
  if (file.extension() != ".vtu")
    return writeDifferenceTable(file, a, difference);
  std::vector<std::uint8_t> witness(static_cast<std::size_t>(a.mesh->points.rows()), 0);
  std::fill_n(witness.begin(), a.mesh->witnesses, std::uint8_t{1});
  std::vector<medical_io::SolidArray> arrays;
  for (const NamedDifference& one : namedDifferences(difference))
    arrays.push_back({one.name, one.values});
  arrays.push_back({"Witness", witness});
  medical_io::writeSolid(file, *a.points, a.mesh->tetrahedra, arrays);
}

} // namespace viscera::live
