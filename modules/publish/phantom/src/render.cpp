#include "viscera/phantom/render.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "noise.h"
#include "viscera/geometry/winding_number.h"
#include "viscera/phantom/tissue.h"

namespace viscera::phantom {
namespace {

/// What a tissue adds to a voxel that it fills.
struct Look {
  double mean = 0;
  double grain = 0; ///< Times that of the place.
  bool still = false;
};

std::vector<Look> looksOf(Contrast::Kind kind) {
  std::vector<Look> looks;
  for (const Tissue& tissue : tissues()) {
    const double signal = steadyStateSignal(tissue);
    looks.push_back(kind == Contrast::Kind::ct ? Look{tissue.hounsfield, tissue.textureHu, tissue.still}
                                               : Look{signal, tissue.textureShare * signal, tissue.still});
  }
  return looks;
}

/// The grain at the rest of the voxels of moving tissue; 0 for others.
std::vector<float> movedGrain(const PhantomBody& body, const PhantomInstant& instant, const ImageGrid& grid,
                              std::uint64_t seed, Threads threads) {
  const std::vector<std::uint8_t> labels = renderLabels(body, instant, grid, threads);
  std::vector<float> grain(grid.voxels(), 0);
  constexpr Eigen::Index kAtOnce = 512;
  const std::size_t layer = std::size_t(grid.size[0]) * std::size_t(grid.size[1]);
  for (int k = 0; k < grid.size[2]; ++k) {
    const Points centers = grid.centersOf(k);
    std::vector<Eigen::Index> voxels;
    for (Eigen::Index v = 0; v < centers.rows(); ++v)
      if (!tissues()[labels[std::size_t(k) * layer + std::size_t(v)]].still)
        voxels.push_back(v);
    Points moving(static_cast<Eigen::Index>(voxels.size()), 3);
    for (Eigen::Index row = 0; row < moving.rows(); ++row)
      moving.row(row) = centers.row(voxels[std::size_t(row)]);
    const Points rest = instant.motion->restOf(moving).points;
    parallelRanges(rest.rows(), kAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index row = begin; row < end; ++row)
        grain[std::size_t(k) * layer + std::size_t(voxels[std::size_t(row)])] =
            float(grainAt(rest.row(row).transpose(), seed));
    });
  }
  return grain;
}

/// Adds a part of a row to the voxels that it goes through; `add(voxel along i, length in voxels)`.
template <class Add>
void forVoxelsOf(const RowPart& part, int columns, const Add& add) {
  const double begin = std::max(part.begin, -0.5), end = std::min(part.end, columns - 0.5);
  for (int i = static_cast<int>(std::floor(begin + 0.5)); i < columns && i - 0.5 < end; ++i)
    if (const double length = std::min(end, i + 0.5) - std::max(begin, i - 0.5); length > 0)
      add(i, length);
}

double noisy(double value, const Contrast& contrast, std::uint64_t number, std::uint64_t voxel) {
  const std::uint64_t seed = mixed(contrast.seed, number + 1, voxel);
  switch (contrast.noise) {
  case Contrast::Noise::none:
    return value;
  case Contrast::Noise::gaussian:
    return value + contrast.deviation * normalPair(seed).x();
  case Contrast::Noise::rician:
    return ricianOf(value, contrast.deviation, seed);
  }
  return value;
}

} // namespace

PhantomInstant instantOf(const PhantomBody& body, const PhantomMotion& motion) {
  PhantomInstant instant;
  instant.motion = &motion;
  for (const BodySurface& surface : body.surfaces)
    instant.surfaces.push_back(surface.still ? surface.mesh.points : motion.moved(surface.mesh.points));
  return instant;
}

PhantomInstant atRest(const PhantomBody& body, const PhantomMotion& motion) {
  PhantomInstant instant;
  instant.motion = &motion;
  for (const BodySurface& surface : body.surfaces)
    instant.surfaces.push_back(surface.mesh.points);
  return instant;
}

std::vector<float> renderImage(const PhantomBody& body, const PhantomInstant& instant, const ImageGrid& grid,
                               const Contrast& contrast, std::uint64_t number, Threads threads) {
  const std::vector<Look> looks = looksOf(contrast.kind);
  const std::vector<float> moved = movedGrain(body, instant, grid, contrast.seed, threads);
  std::vector<float> image(grid.voxels());
  const double share = 1.0 / (contrast.lines.acrossJ * contrast.lines.acrossK);
  const std::size_t layerSize = std::size_t(grid.size[0]) * std::size_t(grid.size[1]);
  const auto fill = [&](const std::vector<RowPart>& layer, int k) {
    std::vector<double> sums(layerSize, 0), covered(layerSize, 0);
    const std::size_t first = std::size_t(k) * layerSize;
    for (const RowPart& part : layer) {
      const Look& look = looks[static_cast<std::size_t>(part.paint)];
      forVoxelsOf(part, grid.size[0], [&](int i, double length) {
        const std::size_t voxel = std::size_t(part.j) * std::size_t(grid.size[0]) + std::size_t(i);
        const double grain = look.still ? grainAt(grid.indexToLps * Vec3(i, part.j, k), contrast.seed)
                                        : double(moved[first + voxel]);
        covered[voxel] += share * length;
        sums[voxel] += share * length * (look.mean + look.grain * grain);
      });
    }
    for (std::size_t v = 0; v < layerSize; ++v) {
      const double value = sums[v] + (1 - covered[v]) * looks[0].mean;
      image[first + v] = static_cast<float>(noisy(value, contrast, number, first + v));
    }
  };
  coverRows(grid, body.painted(instant.surfaces), contrast.lines, threads, fill);
  return image;
}

std::vector<std::uint8_t> renderLabels(const PhantomBody& body, const PhantomInstant& instant,
                                       const ImageGrid& grid, Threads threads) {
  return paintAtCenters(grid, body.painted(instant.surfaces), threads);
}

struct RestTissue::Surfaces {
  struct Inside {
    int label;
    Bounds box;
    geometry::WindingNumber winding;

    bool operator()(const Vec3& point) const {
      return (point.array() >= box.low.array()).all() && (point.array() <= box.high.array()).all() &&
             winding.inside(point);
    }
  };
  std::vector<Inside> still, moving; ///< The highest label first.
};

RestTissue::RestTissue(const PhantomBody& body) {
  auto surfaces = std::make_unique<Surfaces>();
  for (auto surface = body.surfaces.rbegin(); surface != body.surfaces.rend(); ++surface)
    (surface->still ? surfaces->still : surfaces->moving)
        .push_back({tissueNamed(surface->tissue).label, boundsOf(surface->mesh.points),
                    geometry::WindingNumber(surface->mesh)});
  surfaces_ = std::move(surfaces);
}

RestTissue::~RestTissue() = default;

int RestTissue::labelAt(const Vec3& place, const Vec3& rest) const {
  int still = 0;
  for (const Surfaces::Inside& inside : surfaces_->still)
    if (inside(place)) {
      still = inside.label;
      break;
    }
  for (const Surfaces::Inside& inside : surfaces_->moving)
    if (inside.label > still && inside(rest))
      return inside.label;
  return still;
}

std::vector<std::uint8_t> warpLabels(const RestTissue& tissue, const PhantomMotion& motion,
                                     const ImageGrid& grid, Threads threads) {
  std::vector<std::uint8_t> labels(grid.voxels(), 0);
  constexpr Eigen::Index kAtOnce = 256;
  for (int k = 0; k < grid.size[2]; ++k) {
    const Points centers = grid.centersOf(k);
    const Points rest = motion.restOf(centers).points;
    const auto first = std::size_t(k) * std::size_t(centers.rows());
    parallelRanges(centers.rows(), kAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index v = begin; v < end; ++v)
        labels[first + std::size_t(v)] =
            static_cast<std::uint8_t>(tissue.labelAt(centers.row(v).transpose(), rest.row(v).transpose()));
    });
  }
  return labels;
}

} // namespace viscera::phantom
