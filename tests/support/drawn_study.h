#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "viscera/medical_io/cine_study.h"

/// A cine study without files, drawn from a function of place and phase.
namespace viscera::tests {

using DrawnValue = std::function<double(const Vec3& place, double fraction)>;

/// A plane of 64 x 64 pixels of 2 mm around `center`, in `phases` even phases.
inline medical_io::CineSlice drawnSlice(int number, medical_io::CinePlane plane, const Vec3& center,
                                        const Vec3& row, const Vec3& column, int phases,
                                        const DrawnValue& value) {
  medical_io::CineSlice slice;
  slice.series = "1.2." + std::to_string(number);
  slice.number = number;
  slice.plane = plane;
  medical_io::CineGeometry& geometry = slice.geometry;
  geometry.row = row;
  geometry.column = column;
  geometry.betweenColumns = geometry.betweenRows = 2;
  geometry.thickness = 6;
  geometry.columns = geometry.rows = 64;
  geometry.origin = center - 63 * row - 63 * column;
  slice.interval = 0.8;
  for (int phase = 0; phase < phases; ++phase)
    slice.fractions.push_back(double(phase) / phases);
  slice.image = [geometry, value, fractions = slice.fractions](std::size_t phase) {
    auto image = std::make_shared<medical_io::CineImage>(geometry.rows, geometry.columns);
    for (int j = 0; j < geometry.rows; ++j)
      for (int i = 0; i < geometry.columns; ++i)
        (*image)(j, i) = static_cast<float>(value(geometry.at(i, j), fractions[phase]));
    return image;
  };
  return slice;
}

/// Three slices of a short axis 20 mm apart around the origin, one plane with four chambers and one with two
/// across them, eight phases each.
inline medical_io::CineStudy drawnStudy(const DrawnValue& value) {
  using medical_io::CinePlane;
  medical_io::CineStudy study;
  study.modality = "MR";
  for (int i = 0; i < 3; ++i)
    study.slices.push_back(drawnSlice(i + 1, CinePlane::shortAxis, Vec3(0, 0, 20 * i - 20), Vec3::UnitX(),
                                      Vec3::UnitY(), 8, value));
  study.slices.push_back(
      drawnSlice(7, CinePlane::twoChamber, Vec3::Zero(), Vec3::UnitY(), -Vec3::UnitZ(), 8, value));
  study.slices.push_back(
      drawnSlice(9, CinePlane::fourChamber, Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ(), 8, value));
  study.stacks.push_back({{0, 1, 2}, {20, 20}, {14, 14}});
  return study;
}

/// 100 in a ball of 30 mm around the origin, and the phase's number of eight.
inline double ballAndPhase(const Vec3& place, double fraction) {
  return (place.norm() < 30 ? 100 : 0) + std::round(8 * fraction);
}

} // namespace viscera::tests
