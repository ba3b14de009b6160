#include "viscera/tracking/plane_tracks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "image_filters.h"

namespace viscera::tracking {
namespace {

constexpr double kPixelMm = 1.4, kPixelMost = 1.25; ///< Other pixels than these are resampled.
constexpr double kMarginPixels = 16;
constexpr int kFewestPixels = 24; ///< A side of a window.
constexpr double kCorrelationMm = 7;
/// Below this part of the deviation in the whole window grey values are noise: 20 of 135 in the study that
/// the method was made with.
constexpr float kNoiseOfDeviation = 0.15F;
constexpr int kPatch = 4; ///< Pixels on each side of a point, which are compared.
constexpr double kCoarseBlur = 0.9;
constexpr float kLongestStep = 1.5F; ///< Pixels.
constexpr double kComposedBlur = 0.7;

/// How images are brought to each other: rounds, and Gaussians (pixels) of the whole flow, which keep it
/// elastic, and of each step, which keep it fluid.
struct Matching {
  int rounds;
  double elastic, fluid;
};
constexpr Matching kCoarse{20, 0.45, 1.5}, kFine{8, 0.5, 2}, kToFirst{5, 0.4, 2};

/// Grey values less their local mean, over their local deviation.
CineImage normalised(const CineImage& image, double pixelMm, float noise) {
  const double sigma = kCorrelationMm / pixelMm;
  const CineImage mean = smoothed(image, sigma);
  const CineImage variance = smoothed(image.square(), sigma) - mean.square();
  return (image - mean) / (variance.max(0.0F) + noise * noise).sqrt();
}

/// Every second pixel of every second row.
CineImage halved(const CineImage& image) {
  const CineImage blurred = smoothed(image, kCoarseBlur);
  CineImage half((image.rows() + 1) / 2, (image.cols() + 1) / 2);
  for (Eigen::Index row = 0; row < half.rows(); ++row)
    for (Eigen::Index column = 0; column < half.cols(); ++column)
      half(row, column) = blurred(2 * row, 2 * column);
  return half;
}

/// Improves `flow` until b(x + flow(x)) is a(x): Gauss-Newton steps on the squared difference with the slopes
/// of both images, as in demons (Thirion 1998, Vercauteren 2009).
void match(const CineImage& a, const CineImage& b, const Matching& how, Flow& flow) {
  const ImageSlope own = slopeOf(a);
  for (int round = 0; round < how.rounds; ++round) {
    const CineImage moved = warped(b, flow);
    const ImageSlope other = slopeOf(moved);
    const CineImage down = (own.row + other.row) / 2, across = (own.column + other.column) / 2;
    const CineImage apart = a - moved;
    // One Gauss-Newton step of a pixel: g r / (|g|^2 + r^2 / 4 + floor), both parts smoothed first.
    const CineImage size =
        smoothed(down.square() + across.square() + 0.25F * apart.square() + 1e-3F, how.fluid);
    CineImage stepDown = smoothed(down * apart, how.fluid) / size;
    CineImage stepAcross = smoothed(across * apart, how.fluid) / size;
    const CineImage shorten =
        (kLongestStep / (stepDown.square() + stepAcross.square()).sqrt().max(1e-9F)).min(1.0F);
    flow.row = smoothed(flow.row + shorten * stepDown, how.elastic);
    flow.column = smoothed(flow.column + shorten * stepAcross, how.elastic);
  }
}

/// The two scales of one phase at which images are matched.
struct Scales {
  CineImage fine, coarse;
};

} // namespace

/// The part of a plane that is followed, in pixels of its own: square ones, the same along both axes.
struct PlaneTracker::Window {
  Vec3 corner, alongRow, alongColumn; ///< The first pixel, mm, and unit vectors.
  double pixelMm = 1;
  Eigen::Index rows = 0, columns = 0;
  std::vector<CineImage> images; ///< One for each phase; empty where there is none.
  std::vector<Scales> scales;

  Eigen::Vector2d placeOf(const Vec3& point) const {
    const Vec3 from = point - corner;
    return {from.dot(alongColumn) / pixelMm, from.dot(alongRow) / pixelMm};
  }
  Vec3 shift(double down, double across) const { return pixelMm * (across * alongRow + down * alongColumn); }
  void choose(const CinePlane& plane, const Points& around);
  CineImage takenFrom(const CinePlane& plane, const CineImage& image) const;
  double deviation() const;
  Flow between(const Scales& from, const Scales& to) const;
  Followed followedBy(const Flow& flow, const Points& points, const CineImage& from,
                      const CineImage& to) const;
};

void PlaneTracker::Window::choose(const CinePlane& plane, const Points& around) {
  alongRow = plane.alongRow;
  alongColumn = plane.alongColumn;
  const bool asIs = std::abs(plane.spacing[0] - plane.spacing[1]) < 1e-3 * plane.spacing[0] &&
                    plane.spacing[0] < kPixelMost * kPixelMm && plane.spacing[0] > kPixelMm / kPixelMost;
  pixelMm = asIs ? plane.spacing[0] : kPixelMm;
  const Points from = around.rowwise() - plane.origin.transpose();
  const Values across = from * plane.alongRow / pixelMm, down = from * plane.alongColumn / pixelMm;
  const CineImage& image = plane.images[0];
  // How many of the window's own pixels the image has.
  const auto count = [&](Eigen::Index pixels, double spacing) {
    return static_cast<Eigen::Index>(static_cast<double>(pixels - 1) * spacing / pixelMm + 1e-6) + 1;
  };
  const auto range = [](const Values& places, Eigen::Index most) {
    const auto low =
        std::clamp<Eigen::Index>(static_cast<Eigen::Index>(std::floor(places.minCoeff() - kMarginPixels)), 0,
                                 std::max<Eigen::Index>(most - kFewestPixels, 0));
    const auto high = static_cast<Eigen::Index>(std::ceil(places.maxCoeff() + kMarginPixels)) + 1;
    return std::array<Eigen::Index, 2>{
        low, std::min(most, std::max<Eigen::Index>(high, low + kFewestPixels)) - low};
  };
  const auto [left, width] = range(across, count(image.cols(), plane.spacing[0]));
  const auto [top, height] = range(down, count(image.rows(), plane.spacing[1]));
  columns = width;
  rows = height;
  corner = plane.origin + shift(static_cast<double>(top), static_cast<double>(left));
}

CineImage PlaneTracker::Window::takenFrom(const CinePlane& plane, const CineImage& image) const {
  const Vec3 from = corner - plane.origin;
  const double firstColumn = from.dot(alongRow) / plane.spacing[0],
               firstRow = from.dot(alongColumn) / plane.spacing[1];
  const double across = pixelMm / plane.spacing[0], down = pixelMm / plane.spacing[1];
  // Finer pixels are averaged before some of them are left out.
  const double blur = 0.5 * std::max(across, down);
  const CineImage source = blur > 0.7 ? smoothed(image, blur) : image;
  CineImage taken(rows, columns);
  for (Eigen::Index row = 0; row < rows; ++row)
    for (Eigen::Index column = 0; column < columns; ++column)
      taken(row, column) = valueAt(source, firstRow + down * static_cast<double>(row),
                                   firstColumn + across * static_cast<double>(column));
  return taken;
}

double PlaneTracker::Window::deviation() const {
  double sum = 0, squares = 0, count = 0;
  for (const CineImage& image : images) {
    sum += image.cast<double>().sum();
    squares += image.cast<double>().square().sum();
    count += static_cast<double>(image.size());
  }
  const double mean = count > 0 ? sum / count : 0;
  return count > 0 ? std::sqrt(std::max(squares / count - mean * mean, 0.0)) : 0;
}

Flow PlaneTracker::Window::between(const Scales& from, const Scales& to) const {
  Flow coarse = Flow::zero(from.coarse.rows(), from.coarse.cols());
  match(from.coarse, to.coarse, kCoarse, coarse);
  Flow flow{2.0F * resized(coarse.row, rows, columns), 2.0F * resized(coarse.column, rows, columns)};
  match(from.fine, to.fine, kFine, flow);
  return flow;
}

PlaneTracker::Followed PlaneTracker::Window::followedBy(const Flow& flow, const Points& points,
                                                        const CineImage& from, const CineImage& to) const {
  constexpr int kSide = 2 * kPatch + 1;
  using Patch = Eigen::Array<double, kSide * kSide, 1>;
  Followed followed{Points(points.rows(), 3), Values(points.rows())};
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vec3 point = points.row(i);
    const Eigen::Vector2d place = placeOf(point);
    followed.at.row(i) =
        (point + shift(valueAt(flow.row, place[0], place[1]), valueAt(flow.column, place[0], place[1])))
            .transpose();
    Patch a, b;
    for (int k = 0; k < kSide * kSide; ++k) {
      const double row = place[0] + k / kSide - kPatch, column = place[1] + k % kSide - kPatch;
      a[k] = valueAt(from, row, column);
      b[k] = valueAt(to, row + valueAt(flow.row, row, column), column + valueAt(flow.column, row, column));
    }
    a -= a.mean();
    b -= b.mean();
    const double likeness = (a * b).sum() / (std::sqrt(a.square().sum() * b.square().sum()) + 1e-6);
    const bool seen = place.minCoeff() >= 0 && place[0] <= static_cast<double>(rows - 1) &&
                      place[1] <= static_cast<double>(columns - 1);
    followed.likeness[i] = seen ? std::pow(std::clamp((likeness - 0.3) / 0.6, 0.0, 1.0), 2) : 0;
  }
  return followed;
}

PlaneTracker::PlaneTracker(const CinePlane& plane, const std::vector<double>& phaseFractions,
                           const Points& around) {
  auto window = std::make_unique<Window>();
  window->choose(plane, around);
  const double tolerance = 0.75 / static_cast<double>(phaseFractions.size());
  for (const double fraction : phaseFractions) {
    const int image = plane.imageAt(fraction, tolerance);
    window->images.push_back(
        image < 0 ? CineImage() : window->takenFrom(plane, plane.images[static_cast<std::size_t>(image)]));
  }
  const auto noise = std::max(kNoiseOfDeviation * static_cast<float>(window->deviation()), 1e-6F);
  for (const CineImage& image : window->images) {
    Scales& scales = window->scales.emplace_back();
    if (image.size() == 0)
      continue;
    scales.fine = normalised(image, window->pixelMm, noise);
    scales.coarse = normalised(halved(image), 2 * window->pixelMm, noise);
  }
  window_ = std::move(window);
}

PlaneTracker::~PlaneTracker() = default;
PlaneTracker::PlaneTracker(PlaneTracker&&) noexcept = default;
PlaneTracker& PlaneTracker::operator=(PlaneTracker&&) noexcept = default;

bool PlaneTracker::has(std::size_t phase) const {
  return window_->images[phase].size() > 0;
}

std::vector<PlaneTracker::Followed> PlaneTracker::follow(const Points& points, std::size_t from,
                                                         const std::vector<std::size_t>& order,
                                                         Progress& progress) const {
  const Window& window = *window_;
  std::vector<Followed> result(order.size());
  if (!has(from))
    return result;
  Flow whole = Flow::zero(window.rows, window.columns);
  std::size_t before = from;
  for (std::size_t i = 0; i < order.size(); ++i) {
    progress.throwIfCancelled();
    if (!has(order[i]))
      continue;
    const Flow step = window.between(window.scales[before], window.scales[order[i]]);
    // u(x) + v(x + u(x)): the way so far, and from there on.
    whole = {smoothed(whole.row + warped(step.row, whole), kComposedBlur),
             smoothed(whole.column + warped(step.column, whole), kComposedBlur)};
    match(window.scales[from].fine, window.scales[order[i]].fine, kToFirst, whole);
    result[i] = window.followedBy(whole, points, window.images[from], window.images[order[i]]);
    before = order[i];
  }
  return result;
}

} // namespace viscera::tracking
