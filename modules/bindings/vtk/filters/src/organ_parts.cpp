#include "organ_parts.h"

#include <algorithm>
#include <cmath>

#include <vtkPointSet.h>
#include <vtkPoints.h>

#include "viscera/core/cubic_root.h"
#include "viscera/deformation/volume_lock.h"
#include "viscera/geometry/exact_volume.h"

namespace viscera::vtk_filters {
namespace {

/// Systems that fill the handles with tetrahedra first get all points at once.
vtkIdType portionFor(const Rig& rig, vtkIdType count) {
  return rig.system->traits().needsTetrahedra ? std::max<vtkIdType>(count, 1) : kPortion;
}

KeptWeights::Key keyOf(const Leaf& leaf) {
  return {leaf.from->GetPoints(), leaf.from->GetPoints()->GetMTime()};
}

/// Points moved by a portion of coordinates.
void deformInto(const coordinates::Binding& binding, const Points& pose, Threads threads, double* out) {
  Points moved;
  binding.deform(pose, moved, threads);
  std::copy_n(moved.data(), moved.size(), out);
}

} // namespace

void OrganParts::pose(KeptWeights& kept, bool keep, const Told& told) {
  std::map<KeptWeights::Key, Portions> before;
  if (rig_.bindsAs(kept.rig))
    before = std::move(kept.portions);
  kept.rig = rig_;
  kept.portions.clear();
  vtkIdType done = 0, all = 0;
  for (const Leaf& leaf : leaves_)
    all += leaf.from->GetNumberOfPoints();
  for (const Leaf& leaf : leaves_) {
    const vtkIdType count = leaf.from->GetNumberOfPoints();
    Posed& posed = posed_.emplace_back();
    posed.points = newPoints(count);
    if (count == 0)
      continue;
    auto* ghosts = leaf.from->GetPointGhostArray();
    const auto found = before.find(keyOf(leaf));
    Portions portions = found == before.end() ? Portions() : found->second;
    const vtkIdType portion = portionFor(rig_, count);
    portions.resize(static_cast<std::size_t>((count + portion - 1) / portion));
    for (vtkIdType begin = 0; begin < count; begin += portion) {
      const vtkIdType end = std::min(count, begin + portion);
      auto& binding = portions[static_cast<std::size_t>(begin / portion)];
      if (!binding) {
        Progress unheard;
        binding = rig_.system->bind(rig_.handles, pointsOf(leaf.from, begin, end), rig_.options, unheard);
      }
      for (const int point : binding->report().failures)
        posed.unbound += isGhostPoint(ghosts, begin + point) ? 0 : 1;
      deformInto(*binding, rig_.pose, rig_.options.threads, memoryOf(posed.points) + 3 * begin);
      if (!keep)
        binding.reset();
      done += end - begin;
      told(static_cast<double>(done) / static_cast<double>(all));
    }
    if (keep)
      kept.portions[keyOf(leaf)] = std::move(portions);
    leaf.to->SetPoints(posed.points);
  }
}

const Portions& OrganParts::portionsOf(const KeptWeights& kept, std::size_t leaf) const {
  return kept.portions.at(keyOf(leaves_[leaf]));
}

void OrganParts::poseAgain(const KeptWeights& kept, const Points& pose) {
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    if (leaves_[i].from->GetNumberOfPoints() == 0)
      continue;
    double* out = memoryOf(posed_[i].points);
    for (const auto& binding : portionsOf(kept, i)) {
      deformInto(*binding, pose, rig_.options.threads, out);
      out += 3 * binding->pointCount();
    }
    posed_[i].points->Modified();
  }
}

void OrganParts::forEachPart(const std::function<void(std::size_t, vtkPointSet*)>& visit) const {
  ranks_.together([&] {
    for (std::size_t i = 0; i < leaves_.size(); ++i)
      if (leaves_[i].from->GetNumberOfPoints() > 0)
        visit(i, leaves_[i].from);
  });
}

GlobalVolume OrganParts::volumeOf(const Memory& memory, const Vec3& origin) const {
  geometry::ExactVolume surface(origin), solid(origin);
  std::int64_t tetrahedra = 0;
  forEachPart([&](std::size_t i, vtkPointSet* cells) {
    const double* at = memory(i);
    forEachCell(
        cells,
        [&](vtkIdType a, vtkIdType b, vtkIdType c) {
          surface.addTriangle(corner(at, a), corner(at, b), corner(at, c));
        },
        [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d) {
          solid.addTetrahedron(corner(at, a), corner(at, b), corner(at, c), corner(at, d));
          ++tetrahedra;
        });
  });
  ranks_.add({&surface.sixfold(), &solid.sixfold()});
  ranks_.add(tetrahedra);
  return {tetrahedra > 0 ? solid.mm3() : surface.mm3(), tetrahedra > 0};
}

void OrganParts::measureClosedness(const Memory& memory, RestVolume& rest) const {
  ExactSum area, vectorArea[3];
  forEachPart([&](std::size_t i, vtkPointSet* cells) {
    const double* at = memory(i);
    forEachCell(
        cells,
        [&](vtkIdType a, vtkIdType b, vtkIdType c) {
          const Vec3 p = corner(at, a);
          const Vec3 normal = (corner(at, b) - p).cross(corner(at, c) - p);
          area.add(normal.norm());
          for (int axis = 0; axis < 3; ++axis)
            vectorArea[axis].add(normal[axis]);
        },
        [](vtkIdType, vtkIdType, vtkIdType, vtkIdType) {});
  });
  ranks_.add({&area, &vectorArea[0], &vectorArea[1], &vectorArea[2]});
  rest.areaMm2 = area.value() / 2;
  rest.vectorAreaMm2 = Vec3(vectorArea[0].value(), vectorArea[1].value(), vectorArea[2].value()).norm() / 2;
}

RestVolume OrganParts::restVolume(KeptWeights& kept) const {
  std::vector<KeptWeights::Key> parts;
  for (const Leaf& leaf : leaves_)
    parts.emplace_back(leaf.from, leaf.from->GetMTime());
  std::int64_t changed = parts == kept.measured ? 0 : 1;
  ranks_.add(changed);
  if (changed == 0)
    return kept.rest;
  std::vector<Points> rest;
  ranks_.together([&] {
    for (const Leaf& leaf : leaves_)
      rest.push_back(pointsOf(leaf.from, 0, leaf.from->GetNumberOfPoints()));
  });
  const auto memory = [&](std::size_t leaf) -> const double* { return rest[leaf].data(); };
  // An origin that stays when handles change, so that what is kept has the same bits as what is new.
  kept.rest.volume = volumeOf(memory, Vec3::Zero());
  measureClosedness(memory, kept.rest);
  kept.measured = std::move(parts);
  return kept.rest;
}

GlobalVolume OrganParts::volume() const {
  return volumeOf([&](std::size_t leaf) { return memoryOf(posed_[leaf].points); },
                  rig_.pose.row(0).transpose());
}

std::int64_t OrganParts::unboundPoints() const {
  std::int64_t unbound = 0;
  for (const Posed& posed : posed_)
    unbound += posed.unbound;
  ranks_.add(unbound);
  return unbound;
}

namespace {

__extension__ using Wide = __int128;

/// The resolution to which a corner's derivative is rounded: fixed point, so that sums do not depend on their
/// order. With 40 bits and weights of 30 the direction is good to 1e-9, and the volume is made exact along it
/// anyway.
constexpr double kDerivativeBits = 1099511627776.0; // 2^40
constexpr double kWeightBits = 1073741824.0;        // 2^30

/// A whole number of up to 127 bits as a sum that ranks can add.
void addWide(ExactSum& sum, Wide value) {
  for (int part = 0; part < 4; ++part) {
    const auto low = static_cast<std::int64_t>(static_cast<std::uint32_t>(value & 0xffffffff));
    sum.add(std::ldexp(static_cast<double>(low), 32 * part));
    value = (value - low) / (Wide(1) << 32);
  }
  sum.add(std::ldexp(static_cast<double>(value), 128));
}

/// Calls `corner(point, derivative)` for the corners of all cells: the derivative of six volumes by them.
template <typename Corner>
void forEachDerivative(vtkPointSet* set, const double* at, const Vec3& origin, bool solid, Corner corner_) {
  forEachCell(
      set,
      [&](vtkIdType a, vtkIdType b, vtkIdType c) {
        if (solid)
          return;
        // 6 V = p . (q x r), so that its derivatives are q x r, r x p and p x q; a tetrahedron's first corner
        // has minus the sum of the others'.
        const Vec3 p = corner(at, a) - origin, q = corner(at, b) - origin, r = corner(at, c) - origin;
        corner_(a, Vec3(q.cross(r)));
        corner_(b, Vec3(r.cross(p)));
        corner_(c, Vec3(p.cross(q)));
      },
      [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d) {
        const Vec3 o = corner(at, a), p = corner(at, b) - o, q = corner(at, c) - o, r = corner(at, d) - o;
        const Vec3 u = q.cross(r), v = r.cross(p), w = p.cross(q);
        corner_(b, u);
        corner_(c, v);
        corner_(d, w);
        corner_(a, Vec3(-u - v - w));
      });
}

/// Adds, for every free handle, its coordinates times the derivatives at the points (three numbers each).
void pullBack(const Portions& portions, const std::vector<int>& free,
              const std::vector<std::int64_t>& atPoints, std::vector<ExactSum>& sums) {
  const std::int64_t* from = atPoints.data();
  for (const auto& binding : portions) {
    for (std::size_t f = 0; f < free.size(); ++f) {
      const Values weights = binding->influence(free[f]);
      Wide whole[3] = {0, 0, 0};
      for (Eigen::Index p = 0; p < weights.size(); ++p) {
        const std::int64_t weight = std::llround(weights[p] * kWeightBits);
        for (int axis = 0; axis < 3; ++axis)
          whole[axis] += Wide(weight) * from[3 * p + axis];
      }
      for (std::size_t axis = 0; axis < 3; ++axis)
        addWide(sums[3 * f + axis], whole[axis]);
    }
    from += 3 * binding->pointCount();
  }
}

} // namespace

Points OrganParts::direction(const KeptWeights& kept, const std::vector<int>& free, bool solid) const {
  const Vec3 origin = rig_.pose.row(0).transpose();
  double most = 0;
  forEachPart([&](std::size_t i, vtkPointSet* cells) {
    forEachDerivative(cells, memoryOf(posed_[i].points), origin, solid,
                      [&](vtkIdType, const Vec3& by) { most = std::max(most, by.cwiseAbs().maxCoeff()); });
  });
  most = ranks_.largest(most);
  const double scale = most > 0 ? kDerivativeBits / most : 0;
  std::vector<ExactSum> sums(3 * free.size());
  forEachPart([&](std::size_t i, vtkPointSet* cells) {
    std::vector<std::int64_t> atPoints(static_cast<std::size_t>(3 * cells->GetNumberOfPoints()), 0);
    forEachDerivative(cells, memoryOf(posed_[i].points), origin, solid, [&](vtkIdType point, const Vec3& by) {
      for (int axis = 0; axis < 3; ++axis)
        atPoints[static_cast<std::size_t>(3 * point + axis)] += std::llround(by[axis] * scale);
    });
    pullBack(portionsOf(kept, i), free, atPoints, sums);
  });
  std::vector<ExactSum*> all;
  for (ExactSum& sum : sums)
    all.push_back(&sum);
  ranks_.add(all);
  Points found = Points::Zero(rig_.pose.rows(), 3);
  for (std::size_t f = 0; f < free.size(); ++f)
    for (std::size_t axis = 0; axis < 3; ++axis)
      found(free[f], static_cast<Eigen::Index>(axis)) = sums[3 * f + axis].value();
  const double length = found.cwiseAbs().maxCoeff();
  return length > 0 ? Points(found / length) : found;
}

Points OrganParts::motionOf(const KeptWeights& kept, std::size_t leaf, const Points& to) const {
  const vtkIdType count = leaves_[leaf].from->GetNumberOfPoints();
  Points moved(count, 3);
  double* out = moved.data();
  for (const auto& binding : portionsOf(kept, leaf)) {
    deformInto(*binding, to, rig_.options.threads, out);
    out += 3 * binding->pointCount();
  }
  moved -= Eigen::Map<const Points>(memoryOf(posed_[leaf].points), count, 3);
  return moved;
}

std::array<double, 4> OrganParts::along(const KeptWeights& kept, const Points& pose, const Points& direction,
                                        bool solid) const {
  geometry::ExactVolumeAlong sums(rig_.pose.row(0).transpose());
  forEachPart([&](std::size_t i, vtkPointSet* cells) {
    const double* at = memoryOf(posed_[i].points);
    const Points motion = motionOf(kept, i, pose + direction);
    const double* by = motion.data();
    forEachCell(
        cells,
        [&](vtkIdType a, vtkIdType b, vtkIdType c) {
          if (solid)
            return;
          Eigen::Matrix3d p, u;
          p << corner(at, a), corner(at, b), corner(at, c);
          u << corner(by, a), corner(by, b), corner(by, c);
          sums.addTriangle(p, u);
        },
        [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d) {
          Eigen::Matrix<double, 3, 4> p, u;
          p << corner(at, a), corner(at, b), corner(at, c), corner(at, d);
          u << corner(by, a), corner(by, b), corner(by, c), corner(by, d);
          sums.addTetrahedron(p, u);
        });
  });
  auto& terms = sums.sixfold();
  ranks_.add({&terms[0], &terms[1], &terms[2], &terms[3]});
  return sums.mm3();
}

Points OrganParts::restoreVolume(const KeptWeights& kept, double targetMm3) {
  constexpr double kGoodEnough = 1e-13, kRequired = 1e-10;
  constexpr int kMostSteps = 4;
  const std::vector<int> free = deformation::restingHandles(rig_.handles.positions, rig_.pose);
  if (free.empty())
    throw UsageError("no handle is left to compensate the change of volume", "volume lock",
                     "leave some at rest");
  Points pose = rig_.pose;
  const double limit = boundsOf(rig_.handles.positions).diagonal();
  GlobalVolume now = volume();
  if (!kept.rest.closed())
    throw DataError("the surface is open, or cells that lie on several ranks are not marked as ghosts",
                    "volume lock", "close it, or mark them");
  for (int step = 0; step < kMostSteps && std::abs(now.mm3 / targetMm3 - 1) > kGoodEnough; ++step) {
    const Points way = direction(kept, free, now.solid);
    auto cubic = along(kept, pose, way, now.solid);
    cubic[0] -= targetMm3;
    const auto root = nearestCubicRoot(cubic, -limit, limit);
    if (!root)
      throw DataError("the handles at rest cannot make up for the volume", "volume lock",
                      "leave more handles at rest, or ask for a volume nearer to the present one");
    pose += *root * way;
    ranks_.together([&] { poseAgain(kept, pose); });
    now = volume();
  }
  if (!(std::abs(now.mm3 / targetMm3 - 1) <= kRequired))
    throw DataError("the volume is not met", "volume lock", "use coordinates that are linear in the handles");
  return pose;
}

} // namespace viscera::vtk_filters
