#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>

#include "viscera/core/arrays.h"

class vtkLookupTable;

namespace viscera::scene {

/// A scale of colours for numbers. All maps rise evenly in lightness (or fall evenly away from the middle),
/// so that readers who are colour-blind, and prints without colour, show the same order.
struct ColorMap {
  std::string name;  ///< "viridis"
  std::string title; ///< For users: "Viridis".
  Colors colors;     ///< `k x 3`, from the lowest value to the highest, k >= 2.
  std::array<std::uint8_t, 3> missing = {128, 128, 128}; ///< Colour of NaN.
};

/// The smallest and the largest value that a colour map shows.
struct ValueRange {
  double low = 0;
  double high = 1;
  bool logarithmic = false; ///< Equal factors take equal parts of the map; `low` is above 0 then.
  bool operator==(const ValueRange&) const = default;
};

/// The position of a number in the range: 0 at `low`, 1 at `high`, less or more beyond them. On a logarithmic
/// range numbers that are not above 0 lie at minus infinity.
double partOf(ValueRange range, double value);
/// The number at a part of the way from `low` to `high`: the inverse of `partOf`.
double valueAt(ValueRange range, double part);

/// Dark blue over green to yellow, for amounts (influence, stress): 256 colours interpolated between samples
/// of matplotlib's viridis (Smith and van der Walt, CC0).
ColorMap viridis();

/// Blue over light grey to red, for signed values: 256 colours computed in Msh space after Moreland,
/// "Diverging Color Maps for Scientific Visualization", 2009, DOI 10.1007/978-3-642-10520-3_9.
ColorMap diverging();

/// All colour maps, in the order of a list: viridis, cividis, inferno, grey, diverging. Cividis is made to
/// look the same with and without red-green blindness (Nunez, Anderton and Renslow 2018, DOI
/// 10.1371/journal.pone.0199239); inferno (Smith and van der Walt, CC0) runs from black to light yellow; grey
/// is even in CIE lightness.
const std::vector<ColorMap>& colorMaps();

/// A map by name; throws `UsageError` that lists them for any other name.
const ColorMap& colorMapByName(const std::string& name);

/// The range of the finite values; widened a little when they are equal, {0, 1} when there is none. O(n).
ValueRange rangeOf(const Values& values);

/// A lookup table with those colours; values beyond the range take the end colours, values that are not
/// numbers the map's `missing`. The scale is logarithmic if the range is.
vtkSmartPointer<vtkLookupTable> lookupTable(const ColorMap& map, ValueRange range);

} // namespace viscera::scene
