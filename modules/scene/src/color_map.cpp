#include "viscera/scene/color_map.h"

#include <array>
#include <cmath>
#include <limits>

#include <vtkColorTransferFunction.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>

#include "viscera/core/error.h"

namespace viscera::scene {
namespace {

constexpr int kMapSize = 256;

/// viridis at 20 evenly spaced places, 0xrrggbb.
constexpr std::array<unsigned, 20> kViridis = {
    0x440154, 0x481567, 0x482677, 0x453781, 0x404788, 0x39568c, 0x33638d, 0x2d708e, 0x287d8e, 0x238a8d,
    0x1f968b, 0x20a387, 0x29af7f, 0x3cbb75, 0x55c667, 0x73d055, 0x95d840, 0xb8de29, 0xdce319, 0xfde725};

ColorMap sampled(std::string name, vtkColorTransferFunction* function) {
  ColorMap map;
  map.name = std::move(name);
  map.colors.resize(kMapSize, 3);
  for (int i = 0; i < kMapSize; ++i) {
    double rgb[3];
    function->GetColor(double(i) / (kMapSize - 1), rgb);
    for (int c = 0; c < 3; ++c)
      map.colors(i, c) = static_cast<std::uint8_t>(std::lround(255 * rgb[c]));
  }
  return map;
}

void addHex(vtkColorTransferFunction* function, double at, unsigned rgb) {
  function->AddRGBPoint(at, (rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0);
}

} // namespace

ColorMap viridis() {
  vtkNew<vtkColorTransferFunction> function;
  function->SetColorSpaceToLab();
  for (std::size_t i = 0; i < kViridis.size(); ++i)
    addHex(function, double(i) / (kViridis.size() - 1), kViridis[i]);
  return sampled("viridis", function);
}

ColorMap diverging() {
  vtkNew<vtkColorTransferFunction> function;
  function->SetColorSpaceToDiverging();
  addHex(function, 0, 0x3b4cc0);
  addHex(function, 1, 0xb40426);
  return sampled("diverging", function);
}

ColorMap colorMapByName(const std::string& name) {
  if (name == "viridis")
    return viridis();
  if (name == "diverging")
    return diverging();
  throw UsageError("there is no colour map of this name", name, "use viridis or diverging");
}

ValueRange rangeOf(const Values& values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!std::isfinite(value))
      continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high)
    return {0, 1};
  if (low == high) {
    const double widen = low == 0 ? 1 : 0.5 * std::abs(low);
    return {low - widen, high + widen};
  }
  return {low, high};
}

double partOf(ValueRange range, double value) {
  if (!range.logarithmic)
    return (value - range.low) / (range.high - range.low);
  return value > 0 ? std::log(value / range.low) / std::log(range.high / range.low)
                   : -std::numeric_limits<double>::infinity();
}

double valueAt(ValueRange range, double part) {
  return range.logarithmic ? range.low * std::pow(range.high / range.low, part)
                           : range.low + part * (range.high - range.low);
}

vtkSmartPointer<vtkLookupTable> lookupTable(const ColorMap& map, ValueRange range) {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(map.colors.rows());
  for (Eigen::Index i = 0; i < map.colors.rows(); ++i)
    table->SetTableValue(i, map.colors(i, 0) / 255.0, map.colors(i, 1) / 255.0, map.colors(i, 2) / 255.0, 1);
  table->SetTableRange(range.low, range.high);
  if (range.logarithmic)
    table->SetScaleToLog10();
  table->SetNanColor(map.missing[0] / 255.0, map.missing[1] / 255.0, map.missing[2] / 255.0, 1);
  return table;
}

} // namespace viscera::scene
