#include "viscera/scene/color_map.h"

#include <array>
#include <cmath>
#include <limits>

#include <vtkColorTransferFunction.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::scene {
namespace {

constexpr int kMapSize = 256;

/// A published map at evenly spaced places, 0xrrggbb.
using Samples = std::array<unsigned, 20>;
constexpr Samples kViridis = {0x440154, 0x481567, 0x482677, 0x453781, 0x404788, 0x39568c, 0x33638d,
                              0x2d708e, 0x287d8e, 0x238a8d, 0x1f968b, 0x20a387, 0x29af7f, 0x3cbb75,
                              0x55c667, 0x73d055, 0x95d840, 0xb8de29, 0xdce319, 0xfde725};
constexpr Samples kCividis = {0x00224e, 0x002c64, 0x0c3470, 0x273e6e, 0x38476c, 0x46516c, 0x535a6d,
                              0x5f636f, 0x6b6d72, 0x777776, 0x828079, 0x908b78, 0x9c9576, 0xaaa073,
                              0xb8aa6e, 0xc6b667, 0xd4c15f, 0xe4ce53, 0xf2da44, 0xfee838};
constexpr Samples kInferno = {0x000004, 0x08051d, 0x180c3c, 0x2f0a5b, 0x450a69, 0x5c126e, 0x71196e,
                              0x87216b, 0x9b2964, 0xb1325a, 0xc43c4e, 0xd74b3f, 0xe55c30, 0xf1711f,
                              0xf8870e, 0xfca108, 0xfbba1f, 0xf6d543, 0xf1ed71, 0xfcffa4};
/// The ends of the grey map: darker or lighter ones would be lost on the grounds of the window.
constexpr unsigned kDarkGrey = 0x1c1c1c;
constexpr unsigned kLightGrey = 0xf4f4f4;

ColorMap sampled(std::string name, std::string title, vtkColorTransferFunction* function) {
  ColorMap map;
  map.name = std::move(name);
  map.title = std::move(title);
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

ColorMap interpolated(std::string name, std::string title, const Samples& samples) {
  vtkNew<vtkColorTransferFunction> function;
  function->SetColorSpaceToLab();
  for (std::size_t i = 0; i < samples.size(); ++i)
    addHex(function, double(i) / (samples.size() - 1), samples[i]);
  return sampled(std::move(name), std::move(title), function);
}

ColorMap grey() {
  vtkNew<vtkColorTransferFunction> function;
  function->SetColorSpaceToLab();
  addHex(function, 0, kDarkGrey);
  addHex(function, 1, kLightGrey);
  return sampled("grey", "Grey", function);
}

} // namespace

ColorMap viridis() {
  return interpolated("viridis", "Viridis", kViridis);
}

ColorMap diverging() {
  vtkNew<vtkColorTransferFunction> function;
  function->SetColorSpaceToDiverging();
  addHex(function, 0, 0x3b4cc0);
  addHex(function, 1, 0xb40426);
  return sampled("diverging", "Blue to red", function);
}

const std::vector<ColorMap>& colorMaps() {
  static const std::vector<ColorMap> all = {viridis(), interpolated("cividis", "Cividis", kCividis),
                                            interpolated("inferno", "Inferno", kInferno), grey(),
                                            diverging()};
  return all;
}

const ColorMap& colorMapByName(const std::string& name) {
  std::string names;
  for (const ColorMap& map : colorMaps()) {
    if (map.name == name)
      return map;
    names += (names.empty() ? "" : ", ") + map.name;
  }
  throw UsageError(misuse("there is no colour map of this name"), name, misuse("use one of %1", names));
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
