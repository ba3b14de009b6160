#include "cine_planes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string_view>

namespace viscera::medical_io {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSameDirection = 1 * kDegree, kSameSize = 1e-3;
/// Slices nearer than this part of their thickness show one place.
constexpr double kSameHeight = 0.1;
constexpr double kEvenDistance = 0.05;
/// How far the axis of a ventricle may be from the usual one, a long axis out of its plane, and a plane from
/// the direction that names it.
constexpr double kUsualAxis = 40 * kDegree, kOutOfPlane = 30 * kDegree, kSurePlane = 20 * kDegree;
constexpr double kLeastGapMm = 0.05;

/// Direction from the base to the apex of a left ventricle, LPS: to the left, the front and the feet.
Vec3 usualAxis() {
  return Vec3(0.6, -0.6, -0.53).normalized();
}

double angleBetweenLines(const Vec3& a, const Vec3& b) {
  return std::acos(std::min(1.0, std::abs(a.normalized().dot(b.normalized()))));
}

bool nearlyEqual(double a, double b) {
  return std::abs(a - b) <= kSameSize * std::max(std::abs(a), std::abs(b));
}

bool ofOneStack(const CineGeometry& a, const CineGeometry& b) {
  return a.columns == b.columns && a.rows == b.rows && nearlyEqual(a.betweenColumns, b.betweenColumns) &&
         nearlyEqual(a.betweenRows, b.betweenRows) && (a.row - b.row).norm() <= kSameDirection &&
         (a.column - b.column).norm() <= kSameDirection;
}

/// A text's letters and digits, small.
std::string condensed(const std::string& text) {
  std::string word;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

bool saysShortAxis(const std::string& description) {
  const std::string word = condensed(description);
  return word.find("sax") != std::string::npos || word.find("shortaxis") != std::string::npos ||
         word.find("kurzeachse") != std::string::npos || word == "sa" || word.ends_with("cinesa");
}

/// "cine 4CH": the number of chambers that a description names; 0 for none.
int chambersNamed(const std::string& description) {
  const std::string word = condensed(description);
  for (std::size_t at = 0; at + 2 < word.size(); ++at) {
    const bool alone = at == 0 || std::isdigit(static_cast<unsigned char>(word[at - 1])) == 0;
    if (alone && word[at] >= '2' && word[at] <= '4' && word.compare(at + 1, 2, "ch") == 0)
      return word[at] - '0';
  }
  return 0;
}

CinePlane planeOfChambers(int chambers) {
  constexpr std::array<CinePlane, 3> kPlanes = {CinePlane::twoChamber, CinePlane::threeChamber,
                                                CinePlane::fourChamber};
  return chambers < 2 ? CinePlane::longAxis : kPlanes[static_cast<std::size_t>(chambers - 2)];
}

/// Orders slices along the normal of the first one. A place that was taken again counts by the later series,
/// because a breath-hold is repeated when it went wrong.
void orderStack(CineStudy& study, CineStack& stack) {
  const Vec3 normal = study.slices[stack.slices[0]].geometry.normal();
  const auto height = [&](std::size_t s) { return normal.dot(study.slices[s].geometry.center()); };
  std::stable_sort(stack.slices.begin(), stack.slices.end(),
                   [&](std::size_t a, std::size_t b) { return height(a) < height(b); });
  std::vector<std::size_t> kept;
  for (const std::size_t s : stack.slices) {
    const double apart = kSameHeight * std::max(study.slices[s].geometry.thickness, 1.0);
    if (kept.empty() || height(s) - height(kept.back()) > apart) {
      kept.push_back(s);
      continue;
    }
    const std::size_t later = std::max(s, kept.back()), earlier = std::min(s, kept.back());
    kept.back() = later;
    study.findings.push_back(
        phrase("Series %1 shows the same place as series %2, and stands in for it in the "
               "stack",
               seriesLabel(study.slices[later]), seriesLabel(study.slices[earlier])));
  }
  stack.slices = std::move(kept);
  for (std::size_t i = 1; i < stack.slices.size(); ++i) {
    const std::size_t below = stack.slices[i - 1], above = stack.slices[i];
    const double distance = height(above) - height(below);
    const double covered =
        0.5 * (study.slices[below].geometry.thickness + study.slices[above].geometry.thickness);
    const double gap = distance - covered;
    stack.distances.push_back(distance);
    stack.gaps.push_back(gap > kLeastGapMm ? gap : 0);
  }
}

void findStacks(CineStudy& study) {
  std::vector<CineStack> all;
  for (std::size_t s = 0; s < study.slices.size(); ++s) {
    auto stack = std::find_if(all.begin(), all.end(), [&](const CineStack& one) {
      return ofOneStack(study.slices[one.slices[0]].geometry, study.slices[s].geometry);
    });
    if (stack == all.end())
      stack = all.insert(all.end(), CineStack{});
    stack->slices.push_back(s);
  }
  for (CineStack& stack : all) {
    orderStack(study, stack);
    if (stack.slices.size() > 1)
      study.stacks.push_back(std::move(stack));
  }
}

/// The stack of the short axis comes first, if any; gives whether there is one.
bool putShortAxisFirst(CineStudy& study) {
  const auto first = [&](const CineStack& stack) -> const CineSlice& {
    return study.slices[stack.slices[0]];
  };
  const auto isShort = [&](const CineStack& stack) {
    return saysShortAxis(first(stack).description) ||
           (chambersNamed(first(stack).description) == 0 &&
            angleBetweenLines(first(stack).geometry.normal(), usualAxis()) <= kUsualAxis);
  };
  std::stable_sort(study.stacks.begin(), study.stacks.end(), [&](const CineStack& a, const CineStack& b) {
    const bool shortA = isShort(a), shortB = isShort(b);
    return shortA != shortB ? shortA : a.slices.size() > b.slices.size();
  });
  return !study.stacks.empty() && isShort(study.stacks.front());
}

/// Tells them by the direction in which the plane cuts the short axis: from the front wall, up, to the
/// septum.
CinePlane longAxisPlane(const CineSlice& slice, Vec3 axis) {
  if (axis.dot(usualAxis()) < 0)
    axis = -axis;
  const Vec3 normal = slice.geometry.normal();
  if (std::asin(std::min(1.0, std::abs(normal.dot(axis)))) > kOutOfPlane)
    return CinePlane::other;
  const Vec3 front = (Vec3::UnitZ() - axis.z() * axis).normalized(), septum = axis.cross(front);
  const Vec3 cut = normal.cross(axis);
  const double angle = std::atan2(cut.dot(septum), cut.dot(front));
  for (const int chambers : {2, 3, 4}) {
    const double off = angle - (chambers - 2) * 60 * kDegree;
    if (std::abs(std::remainder(off, std::numbers::pi)) <= kSurePlane)
      return planeOfChambers(chambers);
  }
  return planeOfChambers(chambersNamed(slice.description));
}

void namePlanes(CineStudy& study) {
  if (!putShortAxisFirst(study)) {
    for (CineSlice& slice : study.slices)
      if (const int chambers = chambersNamed(slice.description); chambers > 0)
        slice.plane = planeOfChambers(chambers);
      else if (saysShortAxis(slice.description))
        slice.plane = CinePlane::shortAxis;
    return;
  }
  const Vec3 axis = study.slices[study.stacks.front().slices[0]].geometry.normal();
  for (CineSlice& slice : study.slices)
    slice.plane = angleBetweenLines(slice.geometry.normal(), axis) <= kOutOfPlane
                      ? CinePlane::shortAxis
                      : longAxisPlane(slice, axis);
}

/// Says which gaps a stack has, and where one is wider than the others.
void reportStack(CineStudy& study, const CineStack& stack) {
  const auto [least, most] = std::minmax_element(stack.gaps.begin(), stack.gaps.end());
  const std::string plane = nameOf(study.slices[stack.slices[0]].plane);
  const Text narrowest = inDigits(*least, 3), widest = inDigits(*most, 3);
  if (*most > 0 && narrowest == widest)
    study.findings.push_back(
        phrase("The %1 slices of a stack (%2) have gaps of %3 mm between them, in which nothing was seen",
               stack.slices.size(), named(plane), widest));
  else if (*most > 0)
    study.findings.push_back(phrase(
        "The %1 slices of a stack (%2) have gaps of %3 to %4 mm between them, in which nothing was seen",
        stack.slices.size(), named(plane), narrowest, widest));
  std::vector<double> sorted = stack.distances;
  std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2), sorted.end());
  const double usual = sorted[sorted.size() / 2];
  for (std::size_t i = 0; i < stack.distances.size(); ++i)
    if (stack.distances[i] > (1 + kEvenDistance) * usual)
      study.findings.push_back(phrase("Series %1 and %2 are %3 mm apart, other slices of the stack %4 mm: a "
                                      "slice between them may be missing",
                                      seriesLabel(study.slices[stack.slices[i]]),
                                      seriesLabel(study.slices[stack.slices[i + 1]]),
                                      inDigits(stack.distances[i], 3), inDigits(usual, 3)));
}

} // namespace

Text seriesLabel(const CineSlice& slice) {
  return slice.number != 0 || slice.description.empty() ? Text(std::to_string(slice.number))
                                                        : Text(slice.description);
}

void arrangePlanes(CineStudy& study) {
  findStacks(study);
  namePlanes(study);
  for (const CineStack& stack : study.stacks)
    reportStack(study, stack);
}

} // namespace viscera::medical_io
