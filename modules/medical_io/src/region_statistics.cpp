#include "viscera/medical_io/region_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace viscera::medical_io {
namespace {

/// Voxels, and a part of a side: what rounding may move a place that lies on a border.
constexpr double kRounding = 1e-6;
/// How many voxels beyond its crossing with the plane a voxel may lie that the plane's part belongs to: the
/// foot of its perpendicular is at most one and a half off, along the axis that is nearest to the normal.
constexpr int kBesideCrossing = 2;

/// Count, mean and spread of samples on their way to statistics; two of them can be joined (Chan, Golub,
/// LeVeque 1983, doi:10.1080/00031305.1983.10483115), so that no digits are lost to a large mean.
struct Moments {
  std::size_t count = 0;
  double mean = 0;
  double squares = 0; ///< Sum of the squared distances from the mean.
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double sample) {
    ++count;
    const double off = sample - mean;
    mean += off / static_cast<double>(count);
    squares += off * (sample - mean);
    low = std::min(low, sample);
    high = std::max(high, sample);
  }

  void join(const Moments& other) {
    if (other.count == 0)
      return;
    const auto a = static_cast<double>(count), b = static_cast<double>(other.count);
    const double off = other.mean - mean;
    count += other.count;
    mean += off * b / (a + b);
    squares += other.squares + off * off * a * b / (a + b);
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

/// Voxels from `low` up to `high`, both included; none along an axis where `high` is less.
struct Box {
  std::array<int, 3> low{}, high{};
};

/// The voxels of the scan whose centres lie between two places in voxels.
Box boxOf(const Scan& scan, const Vec3& low, const Vec3& high) {
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double last = scan.size[k] - 1;
    box.low[k] = static_cast<int>(std::ceil(std::clamp(low[axis], 0.0, last + 1)));
    box.high[k] = static_cast<int>(std::floor(std::clamp(high[axis], -1.0, last)));
  }
  return box;
}

/// Hands every voxel of a sphere to `take`, layer by layer.
class SphereVoxels {
public:
  SphereVoxels(const Scan& scan, const SphereRegion& sphere) : scan_(scan), sphere_(sphere) {
    const Eigen::Matrix3d toIndex = scan.indexToLps.linear().inverse();
    const Vec3 middle = toIndex * (sphere.center - scan.indexToLps.translation());
    // A sphere of radius r reaches r |row_k| voxels along axis k, row_k that of the matrix from mm to voxels.
    const Vec3 reach = sphere.radius * toIndex.rowwise().norm();
    box_ = boxOf(scan, middle - reach, middle + reach);
  }

  int first() const { return box_.low[2]; }
  int last() const { return box_.high[2]; }

  template <class Take>
  void layer(int k, Take take) const {
    const double square = (1 + kRounding) * sphere_.radius * sphere_.radius;
    const Vec3 step = scan_.indexToLps.linear().col(0);
    for (int j = box_.low[1]; j <= box_.high[1]; ++j) {
      const Vec3 start = scan_.indexToLps * Vec3(0, j, k) - sphere_.center;
      for (int i = box_.low[0]; i <= box_.high[0]; ++i)
        if ((start + i * step).squaredNorm() <= square)
          take(i, j, k);
    }
  }

private:
  const Scan& scan_;
  const SphereRegion& sphere_;
  Box box_;
};

/// The same of a rectangle. Layers are along the slower of the two axes that the plane lies along most.
class RectangleVoxels {
public:
  RectangleVoxels(const Scan& scan, const RectangleRegion& rectangle)
      : scan_(scan), rectangle_(rectangle), toIndex_(scan.indexToLps.inverse()) {
    const Vec3 across = rectangle.first.cross(rectangle.second);
    if (!(across.norm() > 0))
      return;
    normal_ = across.normalized();
    // The plane in voxels: its points q have inIndex_ . q = offset_.
    inIndex_ = scan.indexToLps.linear().transpose() * normal_;
    offset_ = normal_.dot(rectangle.corner - scan.indexToLps.translation());
    Eigen::Index through = 0;
    inIndex_.cwiseAbs().maxCoeff(&through);
    through_ = static_cast<int>(through);
    slow_ = through_ == 2 ? 1 : 2;
    fast_ = through_ == 0 ? 1 : 0;
    Vec3 low = toIndex_ * rectangle.corner, high = low;
    for (const Vec3& corner :
         {Vec3(rectangle.corner + rectangle.first), Vec3(rectangle.corner + rectangle.second),
          Vec3(rectangle.corner + rectangle.first + rectangle.second)}) {
      low = low.cwiseMin(toIndex_ * corner);
      high = high.cwiseMax(toIndex_ * corner);
    }
    // The foot of a voxel's perpendicular is in the voxel: at most half of it away from the centre.
    box_ = boxOf(scan, low.array() - 1, high.array() + 1);
  }

  int first() const { return box_.low[std::size_t(slow_)]; }
  int last() const { return box_.high[std::size_t(slow_)]; }

  template <class Take>
  void layer(int at, Take take) const {
    const auto through = std::size_t(through_);
    std::array<int, 3> voxel{};
    voxel[std::size_t(slow_)] = at;
    for (int f = box_.low[std::size_t(fast_)]; f <= box_.high[std::size_t(fast_)]; ++f) {
      voxel[std::size_t(fast_)] = f;
      // Where inIndex . q = offset along the axis through the plane, plus 1/2 so that rounding down finds the
      // voxel.
      const double crossing =
          (offset_ - inIndex_[slow_] * at - inIndex_[fast_] * f) / inIndex_[through_] + 0.5;
      if (!(crossing > -kBesideCrossing && crossing < scan_.size[through] + kBesideCrossing))
        continue;
      const int middle = static_cast<int>(std::floor(crossing));
      const int low = std::max(box_.low[through], middle - kBesideCrossing);
      const int high = std::min(box_.high[through], middle + kBesideCrossing);
      for (voxel[through] = low; voxel[through] <= high; ++voxel[through])
        if (holds(voxel))
          take(voxel[0], voxel[1], voxel[2]);
    }
  }

private:
  bool holds(const std::array<int, 3>& voxel) const {
    const Vec3 index(voxel[0], voxel[1], voxel[2]);
    const Vec3 center = scan_.indexToLps * index;
    const Vec3 foot = center - normal_.dot(center - rectangle_.corner) * normal_;
    const Vec3 from = foot - rectangle_.corner;
    for (const Vec3* side : {&rectangle_.first, &rectangle_.second}) {
      const double part = from.dot(*side) / side->squaredNorm();
      if (!(part >= -kRounding && part <= 1 + kRounding))
        return false;
    }
    const Vec3 off = toIndex_ * foot - index;
    return (off.array() >= -0.5 - kRounding).all() && (off.array() < 0.5 - kRounding).all();
  }

  const Scan& scan_;
  const RectangleRegion& rectangle_;
  Eigen::Affine3d toIndex_;
  Vec3 normal_ = Vec3::Zero(), inIndex_ = Vec3::Zero();
  double offset_ = 0;
  int through_ = 2, slow_ = 1, fast_ = 0;
  Box box_{{0, 0, 0}, {-1, -1, -1}}; ///< Nothing, for a rectangle without an area.
};

/// Each layer by itself, and then their sums in order: no matter how many threads there are.
template <class Sample, class Voxels>
Moments momentsOf(const Scan& scan, const std::vector<Sample>& samples, const Voxels& voxels,
                  Threads threads) {
  const int layers = voxels.last() - voxels.first() + 1;
  if (layers <= 0)
    return {};
  std::vector<Moments> parts(static_cast<std::size_t>(layers));
  parallelRanges(layers, 1, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index layer = begin; layer < end; ++layer) {
      Moments& part = parts[static_cast<std::size_t>(layer)];
      voxels.layer(voxels.first() + static_cast<int>(layer), [&](int i, int j, int k) {
        const auto sample = static_cast<double>(samples[scan.indexOf(i, j, k)]);
        if (std::isfinite(sample) && !(scan.padding && sample == *scan.padding))
          part.add(sample);
      });
    }
  });
  Moments all;
  for (const Moments& part : parts)
    all.join(part);
  return all;
}

template <class Sample>
Moments momentsOf(const Scan& scan, const std::vector<Sample>& samples, const Region& region,
                  Threads threads) {
  if (const auto* sphere = std::get_if<SphereRegion>(&region))
    return momentsOf(scan, samples, SphereVoxels(scan, *sphere), threads);
  return momentsOf(scan, samples, RectangleVoxels(scan, std::get<RectangleRegion>(region)), threads);
}

} // namespace

double SphereRegion::volumeMl() const {
  return 4.0 / 3.0 * M_PI * radius * radius * radius / kMm3PerMl;
}

RegionStatistics statisticsOf(const Scan& scan, const Region& region, Threads threads) {
  RegionStatistics statistics;
  if (scan.voxelCount() == 0)
    return statistics;
  const Moments moments = std::visit(
      [&](const auto& samples) { return momentsOf(scan, samples, region, threads); }, scan.samples);
  if (moments.count == 0)
    return statistics;
  const auto value = [&scan](double sample) { return scan.slope * sample + scan.intercept; };
  statistics.count = moments.count;
  statistics.mean = value(moments.mean);
  if (moments.count > 1)
    statistics.deviation =
        std::abs(scan.slope) * std::sqrt(moments.squares / static_cast<double>(moments.count - 1));
  statistics.minimum = std::min(value(moments.low), value(moments.high));
  statistics.maximum = std::max(value(moments.low), value(moments.high));
  return statistics;
}

} // namespace viscera::medical_io
