#include "viscera/presentation/cine_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "viscera/core/error.h"

namespace viscera::presentation {
namespace {

using medical_io::CineGeometry;
using medical_io::CineImage;
using medical_io::CinePlane;
using medical_io::CineSlice;
using medical_io::CineStudy;

/// A slice's picture with this much room fits into the pane.
constexpr double kCineRoom = 1.04;
/// The share of a direction that gives an edge a second letter.
constexpr double kSecondLetter = 0.4;
/// Planes whose normals differ by less (sine) do not cross.
constexpr double kNearlyParallel = 0.05;
constexpr double kLowShare = 0.01, kHighShare = 0.99;

/// How far two fractions of a cycle are apart, around its end as well.
double apart(double a, double b) {
  return std::abs(std::remainder(a - b, 1.0));
}

bool isShown(const std::vector<std::size_t>& taken, std::size_t slice) {
  return std::find(taken.begin(), taken.end(), slice) != taken.end();
}

std::optional<std::size_t> firstOf(const CineStudy& study, CinePlane plane,
                                   const std::vector<std::size_t>& taken) {
  for (std::size_t i = 0; i < study.slices.size(); ++i)
    if (study.slices[i].plane == plane && !isShown(taken, i))
      return i;
  return std::nullopt;
}

/// The middle of the first stack, the first short axis, or the first slice.
std::size_t middleOfShortAxis(const CineStudy& study) {
  if (!study.stacks.empty())
    return study.stacks[0].slices[study.stacks[0].slices.size() / 2];
  return firstOf(study, CinePlane::shortAxis, {}).value_or(0);
}

/// The first plane of a kind, by preference, that is not shown yet; else any slice that is not, else any.
std::size_t preferred(const CineStudy& study, const std::vector<CinePlane>& kinds,
                      const std::vector<std::size_t>& taken) {
  for (const CinePlane kind : kinds)
    if (const auto found = firstOf(study, kind, taken))
      return *found;
  for (std::size_t i = 0; i < study.slices.size(); ++i)
    if (!isShown(taken, i))
      return i;
  return taken.front();
}

} // namespace

std::array<std::size_t, 3> cineSlices(const CineStudy& study, const CineLook& look) {
  std::vector<std::size_t> proposed = {middleOfShortAxis(study)};
  proposed.push_back(preferred(
      study, {CinePlane::fourChamber, CinePlane::threeChamber, CinePlane::longAxis, CinePlane::twoChamber},
      proposed));
  proposed.push_back(preferred(
      study, {CinePlane::twoChamber, CinePlane::threeChamber, CinePlane::longAxis, CinePlane::fourChamber},
      proposed));
  std::array<std::size_t, 3> slices{};
  for (std::size_t pane = 0; pane < slices.size(); ++pane) {
    const int chosen = look.slices[pane];
    const bool there = chosen >= 0 && static_cast<std::size_t>(chosen) < study.slices.size();
    slices[pane] = there ? static_cast<std::size_t>(chosen) : proposed[pane];
  }
  return slices;
}

std::vector<std::size_t> cineGroup(const CineStudy& study, std::size_t slice) {
  std::vector<std::size_t> single;
  for (std::size_t i = 0; i < study.slices.size(); ++i) {
    const auto stack = std::find_if(study.stacks.begin(), study.stacks.end(),
                                    [i](const auto& one) { return isShown(one.slices, i); });
    if (stack == study.stacks.end())
      single.push_back(i);
    else if (i == slice)
      return stack->slices;
  }
  return single;
}

std::size_t cineStepped(const CineStudy& study, std::size_t slice, int steps) {
  const std::vector<std::size_t> group = cineGroup(study, slice);
  const auto found = std::find(group.begin(), group.end(), slice);
  if (found == group.end())
    return slice;
  const int last = static_cast<int>(group.size()) - 1;
  const int place = std::clamp(static_cast<int>(found - group.begin()) + steps, 0, last);
  return group[static_cast<std::size_t>(place)];
}

std::optional<std::size_t> cinePhase(const CineSlice& slice, double fraction) {
  if (slice.fractions.empty())
    return std::nullopt;
  const std::size_t phase = slice.phaseAt(fraction);
  const double distance = apart(slice.fractions[phase], fraction);
  const bool lost = std::any_of(slice.missing.begin(), slice.missing.end(),
                                [&](double missing) { return apart(missing, fraction) < distance; });
  return lost ? std::nullopt : std::optional(phase);
}

double cineStep(const CineSlice& slice, double fraction, int steps) {
  std::vector<double> all = slice.fractions;
  all.insert(all.end(), slice.missing.begin(), slice.missing.end());
  if (all.empty())
    return fraction;
  std::sort(all.begin(), all.end());
  const auto nearest = std::min_element(
      all.begin(), all.end(), [&](double a, double b) { return apart(a, fraction) < apart(b, fraction); });
  const auto count = static_cast<long>(all.size());
  const long place = ((nearest - all.begin() + steps) % count + count) % count;
  return all[static_cast<std::size_t>(place)];
}

double cineAdvanced(double fraction, double seconds, double cycleSeconds, bool loop) {
  const double next = fraction + (cycleSeconds > 0 ? seconds / cycleSeconds : 0);
  return loop ? next - std::floor(next) : std::clamp(next, 0.0, 1.0);
}

double cineSeconds(const CineStudy& study) {
  std::vector<double> intervals;
  for (const CineSlice& slice : study.slices)
    if (slice.interval > 0)
      intervals.push_back(slice.interval);
  if (intervals.empty())
    return 1;
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

/// The scanner's column goes down in the picture, so right x up points against row x column.
geometry::Plane cinePlane(const CineGeometry& geometry) {
  return {geometry.center(), -geometry.normal()};
}

medical_io::SliceFrame cineFrame(const CineGeometry& geometry, const SliceFraming& framing, int width,
                                 int height) {
  const double across = geometry.columns * geometry.betweenColumns;
  const double along = geometry.rows * geometry.betweenRows;
  const double mm = kCineRoom / framing.zoom * std::max(across / width, along / height);
  const Vec3 up = -geometry.column;
  medical_io::SliceFrame frame;
  frame.right = mm * geometry.row;
  frame.up = mm * up;
  frame.width = width;
  frame.height = height;
  frame.corner = geometry.center() + framing.rightMm * geometry.row + framing.upMm * up -
                 0.5 * (width - 1) * frame.right - 0.5 * (height - 1) * frame.up;
  return frame;
}

std::array<std::string, 4> cineEdges(const medical_io::SliceFrame& frame) {
  constexpr std::array<std::array<const char*, 2>, 3> kSides = {{{"R", "L"}, {"A", "P"}, {"I", "S"}}};
  const auto letters = [&](const Vec3& towards) {
    const Vec3 size = towards.normalized().cwiseAbs();
    std::array<int, 3> order = {0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return size[a] > size[b]; });
    std::string words;
    for (int i = 0; i < 2; ++i) {
      const auto axis = static_cast<std::size_t>(order[static_cast<std::size_t>(i)]);
      if (i == 0 || size[static_cast<Eigen::Index>(axis)] > kSecondLetter)
        words += kSides[axis][towards[static_cast<Eigen::Index>(axis)] > 0 ? 1 : 0];
    }
    return words;
  };
  return {letters(-frame.right), letters(frame.right), letters(-frame.up), letters(frame.up)};
}

namespace {

/// The value at a place in pixels; NaN outside of the picture.
float valueAt(const CineImage& image, const Eigen::Vector2d& place, bool smooth) {
  constexpr float kNotSeen = std::numeric_limits<float>::quiet_NaN();
  const double x = place.x(), y = place.y();
  const Eigen::Index columns = image.cols(), rows = image.rows();
  if (!(x >= -0.5 && y >= -0.5 && x <= double(columns) - 0.5 && y <= double(rows) - 0.5))
    return kNotSeen;
  const auto inside = [](double at, Eigen::Index count) {
    return std::clamp(static_cast<Eigen::Index>(at), Eigen::Index{0}, count - 1);
  };
  if (!smooth)
    return image(inside(std::floor(y + 0.5), rows), inside(std::floor(x + 0.5), columns));
  const double cx = std::clamp(x, 0.0, double(columns - 1)), cy = std::clamp(y, 0.0, double(rows - 1));
  const Eigen::Index i = inside(cx, columns), j = inside(cy, rows);
  const Eigen::Index i1 = std::min(i + 1, columns - 1), j1 = std::min(j + 1, rows - 1);
  const auto fx = static_cast<float>(cx - double(i)), fy = static_cast<float>(cy - double(j));
  const float upper = image(j, i) + fx * (image(j, i1) - image(j, i));
  const float lower = image(j1, i) + fx * (image(j1, i1) - image(j1, i));
  return upper + fy * (lower - upper);
}

} // namespace

void sampleCine(const CineImage& image, const CineGeometry& geometry, const medical_io::SliceFrame& frame,
                bool smooth, medical_io::ValueImage& values) {
  values.width = frame.width;
  values.height = frame.height;
  values.values.resize(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height));
  const Eigen::Vector2d first = geometry.pixelOf(frame.corner);
  const Eigen::Vector2d right = geometry.pixelOf(frame.corner + frame.right) - first;
  const Eigen::Vector2d up = geometry.pixelOf(frame.corner + frame.up) - first;
  std::size_t pixel = 0;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x)
      values.values[pixel++] = valueAt(image, first + x * right + y * up, smooth);
}

medical_io::ValueWindow cineWindow(const CineStudy& study) {
  std::vector<float> all;
  for (const CineSlice& slice : study.slices) {
    if (slice.fractions.empty())
      continue;
    try {
      const auto image = slice.image(0);
      std::copy_if(image->data(), image->data() + image->size(), std::back_inserter(all),
                   [](float value) { return std::isfinite(value); });
    } catch (const DataError&) {
      continue; // Another slice has values.
    }
  }
  if (all.empty())
    return {0, 1};
  const auto share = [&](double part) {
    const auto place = all.begin() + static_cast<std::ptrdiff_t>(part * double(all.size() - 1));
    std::nth_element(all.begin(), place, all.end());
    return double(*place);
  };
  const double low = share(kLowShare), high = share(kHighShare);
  return {0.5 * (low + high), std::max(high - low, 1.0)};
}

std::optional<std::array<Eigen::Vector2d, 2>> cineCross(const medical_io::SliceFrame& frame,
                                                        const geometry::Plane& plane) {
  if (frame.plane().normal.cross(plane.normal).norm() < kNearlyParallel)
    return std::nullopt;
  // The plane in pixels is a x + b y + c = 0.
  const double a = plane.normal.dot(frame.right), b = plane.normal.dot(frame.up),
               c = plane.height(frame.corner);
  const double w = frame.width - 1, h = frame.height - 1;
  std::vector<Eigen::Vector2d> ends;
  const auto add = [&](double x, double y) {
    const Eigen::Vector2d end(x, y);
    if (x >= 0 && x <= w && y >= 0 && y <= h &&
        std::none_of(ends.begin(), ends.end(), [&](const auto& other) { return (other - end).norm() < 1; }))
      ends.push_back(end);
  };
  if (b != 0)
    for (const double x : {0.0, w})
      add(x, -(c + a * x) / b);
  if (a != 0)
    for (const double y : {0.0, h})
      add(-(c + b * y) / a, y);
  if (ends.size() < 2)
    return std::nullopt;
  return std::array{ends[0], ends[1]};
}

} // namespace viscera::presentation
