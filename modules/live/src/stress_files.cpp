#include "viscera/live/stress_files.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <ostream>
#include <utility>

#include "degrees.h"
#include "tissue_columns.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/text.h"
#include "viscera/medical_io/solid_file.h"

namespace viscera::live {
namespace {

constexpr int kStressDigits = 9;

std::vector<std::uint8_t> foldedFlags(const deformation::StressMap& map) {
  std::vector<std::uint8_t> flags;
  for (const double ratio : map.volumeRatio)
    flags.push_back(ratio <= 0 ? 1 : 0);
  return flags;
}

} // namespace

void writeStressSolid(const std::filesystem::path& file, const deformation::WitnessMesh& mesh,
                      const Points& posed, const deformation::StressMap& map,
                      const elasticity::StatedMaterial& material) {
  std::vector<std::uint8_t> witness(static_cast<std::size_t>(mesh.points.rows()), 0);
  std::fill_n(witness.begin(), mesh.witnesses, std::uint8_t{1});
  std::vector<medical_io::SolidArray> arrays = {
      {"RotationalStress_deg", Values(kDegrees * map.rotationalStress)},
      {"VolumeRatio", map.volumeRatio},
      {"StretchMax", map.stretchMax},
      {"StretchMin", map.stretchMin},
      {"Folded", foldedFlags(map)},
      {"Witness", witness},
      {"Displacement_mm", Points(posed - mesh.points)}};
  if (material.stated())
    for (const auto& [name, quantity] : {std::pair("VonMises_kPa, ", StressQuantity::vonMises),
                                         std::pair("StrainEnergy_kPa, ", StressQuantity::energy)}) {
      Values values;
      quantityOf(map, {quantity, material}, values);
      arrays.push_back({name + nameOf(material).english(), values});
    }
  medical_io::writeSolid(file, posed, mesh.tetrahedra, arrays);
}

void writeStressTable(const std::filesystem::path& file, const deformation::WitnessMesh& mesh,
                      const Points& posed, const deformation::StressMap& map,
                      const elasticity::StatedMaterial& material) {
  Values vonMises, energy;
  quantityOf(map, {StressQuantity::vonMises, material}, vonMises);
  quantityOf(map, {StressQuantity::energy, material}, energy);
  writeAtomically(file, [&](std::ostream& stream) {
    stream << "rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm,RotationalStress_deg,VolumeRatio,StretchMax,"
              "StretchMin,Folded,stress_degrees,volume_ratio,stretch_max,stretch_min"
           << tissueHead(material) << '\n';
    for (Eigen::Index i = 0; i < mesh.witnesses; ++i) {
      const auto rest = mesh.points.row(i), now = posed.row(i);
      const double ratio = map.volumeRatio[i];
      for (const double value :
           {rest[0], rest[1], rest[2], now[0], now[1], now[2], kDegrees * map.rotationalStress[i], ratio,
            map.stretchMax[i], map.stretchMin[i]})
        stream << significant(value, kStressDigits) << ',';
      stream << (ratio <= 0 ? 1 : 0);
      // Once more under the names that JSON and Python have.
      for (const double value :
           {kDegrees * map.rotationalStress[i], ratio, map.stretchMax[i], map.stretchMin[i]})
        stream << ',' << significant(value, kStressDigits);
      stream << tissueCells(vonMises[i], energy[i], kStressDigits, material) << '\n';
    }
  });
}

StressHistogram histogramOf(const Values& values, Eigen::Index count, int bars) {
  StressHistogram histogram;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (Eigen::Index i = 0; i < count; ++i) {
    if (!std::isfinite(values[i])) {
      ++histogram.missing;
      continue;
    }
    low = std::min(low, values[i]);
    high = std::max(high, values[i]);
  }
  if (!(low <= high))
    return histogram;
  for (int edge = 0; edge < bars; ++edge)
    histogram.edges.push_back(low + (high - low) * edge / bars);
  histogram.edges.push_back(high);
  histogram.points.assign(static_cast<std::size_t>(bars), 0);
  const double scale = high > low ? bars / (high - low) : 0;
  for (Eigen::Index i = 0; i < count; ++i)
    if (std::isfinite(values[i]))
      ++histogram.points[static_cast<std::size_t>(std::clamp((values[i] - low) * scale, 0.0, bars - 1.0))];
  return histogram;
}

void writeStressHistogram(const std::filesystem::path& file, const StressHistogram& histogram,
                          const StressMeasure& measure) {
  const StressQuantityDescription& quantity = describe(measure.quantity);
  const std::string material =
      quantity.ofMaterial ? ',' + csvField(nameOf(measure.material).english()) : std::string();
  const std::string unit = quantity.unit.empty() ? "" : '_' + quantity.unit;
  double all = 0;
  for (const int points : histogram.points)
    all += points;
  writeAtomically(file, [&](std::ostream& stream) {
    stream << "from" << unit << ",to" << unit << ",points,percent" << (quantity.ofMaterial ? ",material" : "")
           << '\n';
    for (std::size_t bar = 0; bar < histogram.points.size(); ++bar)
      stream << significant(histogram.edges[bar], kStressDigits) << ','
             << significant(histogram.edges[bar + 1], kStressDigits) << ',' << histogram.points[bar] << ','
             << significant(100 * histogram.points[bar] / all, kStressDigits) << material << '\n';
    if (histogram.missing > 0)
      stream << "folded,folded," << histogram.missing << ',' << material << '\n';
  });
}

void writeStressCurve(const std::filesystem::path& file, const std::vector<StressSample>& samples) {
  writeAtomically(file, [&](std::ostream& stream) {
    stream << "time_s,min_deg,mean_deg,p95_deg,max_deg,folded,stress_degrees_min,stress_degrees_mean,"
              "stress_degrees_p95,stress_degrees_max\n";
    for (const StressSample& sample : samples) {
      stream << significant(sample.seconds, kStressDigits);
      std::string degrees;
      for (const double value : {sample.statistics.min, sample.statistics.mean,
                                 sample.statistics.percentile95, sample.statistics.max})
        degrees += ',' + significant(kDegrees * value, kStressDigits);
      stream << degrees << ',' << sample.statistics.folded << degrees << '\n';
    }
  });
}

} // namespace viscera::live
