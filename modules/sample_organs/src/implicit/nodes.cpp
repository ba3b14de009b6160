#include "implicit/nodes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "implicit/smooth_functions.h"

namespace viscera::sample_organs {
namespace {

constexpr double kNarrowestSeam = 0.5; // mm; a colour step sharper than this only shows the triangles

class Ellipsoid final : public ImplicitNode {
public:
  Ellipsoid(const Vec3& center, const Vec3& radii, const Eigen::Matrix3d& axes)
      : ImplicitNode(extentOf(center, radii, axes)), center_(center), radii_(radii),
        toAxes_(axes.transpose()) {}

  double distanceUpTo(const Vec3& point, double /*limit*/) const override {
    // d = f / |grad f|, right to first order at the surface, for f = |s| - 1 with s = (p - c) / r along the
    // axes: |grad f| = |s / r| / |s|.
    const Vec3 scaled = (toAxes_ * (point - center_)).cwiseQuotient(radii_);
    const double level = scaled.norm();
    const double slope = scaled.cwiseQuotient(radii_).norm();
    // The quotient below is 0 / 0 at the centre; its limit along the shortest axis is the honest answer.
    if (level < 1e-9)
      return -radii_.minCoeff();
    return level * (level - 1) / slope;
  }

private:
  static Extent extentOf(const Vec3& center, const Vec3& radii, const Eigen::Matrix3d& axes) {
    // The largest x of the ellipsoid is |(r_1 a_1x, r_2 a_2x, r_3 a_3x)|, a_k its axes; and so for y and z.
    const Vec3 half = (axes * radii.asDiagonal()).rowwise().norm();
    return {Vec3(center - half), Vec3(center + half)};
  }

  Vec3 center_;
  Vec3 radii_;
  Eigen::Matrix3d toAxes_;
};

class HalfSpace final : public ImplicitNode {
public:
  HalfSpace(const Vec3& point, const Vec3& normal)
      : ImplicitNode(unlimited()), point_(point), normal_(normal.normalized()) {}

  double distanceUpTo(const Vec3& point, double /*limit*/) const override {
    return (point - point_).dot(normal_);
  }

private:
  /// A box that stands for "everywhere", small enough to be turned and scaled.
  static Extent unlimited() { return {Vec3::Constant(-1e6), Vec3::Constant(1e6)}; }

  Vec3 point_;
  Vec3 normal_;
};

/// Takes another part into what is known of a point: `share` of its looks, and its distance over a fillet.
void melt(Shade& result, const Shade& other, double share, double blend) {
  result.color += share * (other.color - result.color);
  result.edgeScale += share * (other.edgeScale - result.edgeScale);
  result.distance = smoothMin(result.distance, other.distance, blend);
}

class Union final : public ImplicitNode {
public:
  Union(std::vector<NodePtr> children, double blend)
      : ImplicitNode(extentOf(children, blend)), children_(std::move(children)), blend_(blend) {}

  double distanceUpTo(const Vec3& point, double limit) const override {
    double result = kUnlimited;
    for (const NodePtr& child : children_) {
      const double least = std::min(result, limit);
      if (!cannotMatter(*child, point, least))
        result = smoothMin(result, child->distanceUpTo(point, least + blend_), blend_);
    }
    return result;
  }

private:
  static Extent extentOf(const std::vector<NodePtr>& children, double blend) {
    Extent extent;
    for (const NodePtr& child : children)
      extent.extend(child->extent());
    // Two children take b / 4 off where they meet equally. For n at the same distance d_1 = 0 and d_n+1 = d_n
    // - b (1 + d_n / b)^2 / 4, -0.39 b for three and never below -b: only where three meet at the border of
    // this box does their fillet leave it.
    return grown(extent, 0.25 * blend);
  }

  Shade shadeUnfinished(const Vec3& point) const override {
    const double seam = std::max(0.6 * blend_, kNarrowestSeam);
    Shade result{kUnlimited};
    bool first = true;
    for (const NodePtr& child : children_) {
      if (cannotMatter(*child, point, result.distance))
        continue;
      const Shade other = child->shade(point);
      melt(result, other, first ? 1.0 : smoothStep(-seam, seam, result.distance - other.distance), blend_);
      first = false;
    }
    return result;
  }

  bool cannotMatter(const ImplicitNode& child, const Vec3& point, double distance) const {
    return child.distanceToExtent(point) >
           kDistanceShortfall * (std::max(distance, 0.0) + blend_ + kNarrowestSeam);
  }

  std::vector<NodePtr> children_;
  double blend_;
};

class SurfaceVessels final : public ImplicitNode {
public:
  SurfaceVessels(const NodePtr& base, std::vector<SurfaceVessel> vessels, double blend)
      : ImplicitNode(extentOf(base, vessels, blend)), base_(base), vessels_(std::move(vessels)),
        blend_(blend) {}

  double distanceUpTo(const Vec3& point, double limit) const override {
    double result = base_->distanceUpTo(point, limit + blend_);
    for (const SurfaceVessel& vessel : vessels_) {
      const double least = std::min(result, limit);
      if (!cannotMatter(vessel, point, least))
        result = smoothMin(result, vessel.node->distanceUpTo(point, least + blend_), blend_);
    }
    return result;
  }

private:
  static Extent extentOf(const NodePtr& base, const std::vector<SurfaceVessel>& vessels, double blend) {
    Extent extent = base->extent();
    for (const SurfaceVessel& vessel : vessels)
      extent.extend(vessel.node->extent());
    return grown(extent, 0.25 * blend);
  }

  Shade shadeUnfinished(const Vec3& point) const override {
    Shade result = base_->shade(point);
    for (const SurfaceVessel& vessel : vessels_) {
      if (cannotMatter(vessel, point, result.distance))
        continue;
      const Shade other = vessel.node->shade(point);
      melt(result, other, smoothStep(-vessel.seam, vessel.seam, result.distance - other.distance), blend_);
    }
    return result;
  }

  bool cannotMatter(const SurfaceVessel& vessel, const Vec3& point, double distance) const {
    return vessel.node->distanceToExtent(point) > std::max(distance, 0.0) + blend_ + vessel.seam;
  }

  NodePtr base_;
  std::vector<SurfaceVessel> vessels_;
  double blend_;
};

class Frame final : public ImplicitNode {
public:
  Frame(const NodePtr& child, const Placement& placement)
      : ImplicitNode(extentOf(*child, placement)), child_(child), placement_(placement) {}

  double distanceUpTo(const Vec3& point, double limit) const override {
    // p = o + s R (m q), with the mirror m by components, turns distances into s times as many:
    // d(p) = s d_child(q).
    return placement_.scale * child_->distanceUpTo(local(point), limit / placement_.scale);
  }

private:
  static Extent extentOf(const ImplicitNode& child, const Placement& at) {
    Extent extent;
    for (int i = 0; i < 8; ++i) {
      const Vec3 corner = child.extent().corner(static_cast<Extent::CornerType>(i));
      extent.extend(Vec3(at.origin + at.rotation * (at.scale * corner.cwiseProduct(at.mirror))));
    }
    return extent;
  }

  Shade shadeUnfinished(const Vec3& point) const override {
    Shade shade = child_->shade(local(point));
    shade.distance *= placement_.scale;
    return shade;
  }

  Vec3 local(const Vec3& point) const {
    const Vec3 turned = placement_.rotation.transpose() * (point - placement_.origin);
    return turned.cwiseProduct(placement_.mirror) / placement_.scale;
  }

  NodePtr child_;
  Placement placement_;
};

/// A node that looks like its child and has another surface.
class Altered : public ImplicitNode {
public:
  double distanceUpTo(const Vec3& point, double limit) const final {
    return altered(child_->distanceUpTo(point, limit + margin_), point, limit);
  }

protected:
  /// The surface lies at most `margin` mm inside the child's.
  Altered(const NodePtr& child, const Extent& extent, double margin)
      : ImplicitNode(extent), child_(child), margin_(margin) {}

private:
  /// The distance from this surface where the child is `distance` mm away; as `distanceUpTo`.
  virtual double altered(double distance, const Vec3& point, double limit) const = 0;

  Shade shadeUnfinished(const Vec3& point) const final {
    Shade shade = child_->shade(point);
    shade.distance = altered(shade.distance, point, kUnlimited);
    return shade;
  }

  NodePtr child_;
  double margin_;
};

class Intersection final : public Altered {
public:
  Intersection(std::vector<NodePtr> children, double blend)
      : Altered(children.front(), extentOf(children), 0), children_(std::move(children)), blend_(blend) {}

private:
  static Extent extentOf(const std::vector<NodePtr>& children) {
    Extent extent = children.front()->extent();
    for (const NodePtr& child : children)
      extent = extent.intersection(child->extent());
    return extent;
  }

  double altered(double distance, const Vec3& point, double limit) const override {
    for (std::size_t i = 1; i < children_.size() && distance < limit; ++i)
      distance = smoothMax(distance, children_[i]->distanceUpTo(point, limit), blend_);
    return distance;
  }

  std::vector<NodePtr> children_;
  double blend_;
};

class Subtraction final : public Altered {
public:
  Subtraction(const NodePtr& body, std::vector<NodePtr> cuts, double blend)
      : Altered(body, body->extent(), 0), cuts_(std::move(cuts)), blend_(blend) {}

private:
  double altered(double distance, const Vec3& point, double limit) const override {
    if (!(distance < limit))
      return distance;
    for (const NodePtr& other : cuts_) {
      const double reach = std::max(-distance, 0.0) + blend_;
      if (other->distanceToExtent(point) <= kDistanceShortfall * reach)
        distance = smoothMax(distance, -other->distanceUpTo(point, reach), blend_);
    }
    return distance;
  }

  std::vector<NodePtr> cuts_;
  double blend_;
};

class Offset final : public Altered {
public:
  Offset(const NodePtr& child, double distance)
      : Altered(child, grown(child->extent(), std::max(distance, 0.0)), distance), offset_(distance) {}

private:
  double altered(double distance, const Vec3& /*point*/, double /*limit*/) const override {
    return distance - offset_;
  }

  double offset_;
};

class Displacement final : public Altered {
public:
  Displacement(const NodePtr& child, const Roughness& roughness)
      : Altered(child, grown(child->extent(), 2 * roughness.amplitude), 2 * roughness.amplitude),
        roughness_(roughness) {}

private:
  double altered(double distance, const Vec3& point, double /*limit*/) const override {
    // Away from the surface the noise only costs time; it fades out, because a step would look like another
    // surface.
    const double reach = 4 * roughness_.amplitude;
    const double away = std::abs(distance);
    if (away >= 2 * reach)
      return distance;
    // sum_k a 2^-k noise(2.03^k p / wavelength) stays below 2 a, however many octaves there are.
    double sum = 0, amplitude = roughness_.amplitude, frequency = 1 / roughness_.wavelength;
    for (int octave = 0; octave < roughness_.octaves; ++octave) {
      sum += amplitude * valueNoise(frequency * point, roughness_.seed + octave);
      amplitude *= 0.5;
      frequency *= 2.03; // not 2: the lattices of two octaves must not lie on each other
    }
    return distance - sum * (1 - smoothStep(reach, 2 * reach, away));
  }

  Roughness roughness_;
};

} // namespace

NewNode makeEllipsoid(const Vec3& center, const Vec3& radii, const Eigen::Matrix3d& axes) {
  return std::make_shared<Ellipsoid>(center, radii, axes);
}

NewNode makeHalfSpace(const Vec3& point, const Vec3& normal) {
  return std::make_shared<HalfSpace>(point, normal);
}

NewNode makeUnion(std::vector<NodePtr> children, double blend) {
  return std::make_shared<Union>(std::move(children), blend);
}

NewNode makeIntersection(std::vector<NodePtr> children, double blend) {
  return std::make_shared<Intersection>(std::move(children), blend);
}

NewNode makeSubtraction(const NodePtr& body, std::vector<NodePtr> cuts, double blend) {
  return std::make_shared<Subtraction>(body, std::move(cuts), blend);
}

NewNode makeOffset(const NodePtr& child, double distance) {
  return std::make_shared<Offset>(child, distance);
}

NewNode makeDisplacement(const NodePtr& child, const Roughness& roughness) {
  return std::make_shared<Displacement>(child, roughness);
}

NewNode makeFrame(const NodePtr& child, const Placement& placement) {
  return std::make_shared<Frame>(child, placement);
}

NewNode makeSurfaceVessels(const NodePtr& base, std::vector<SurfaceVessel> vessels, double blend) {
  return std::make_shared<SurfaceVessels>(base, std::move(vessels), blend);
}

} // namespace viscera::sample_organs
