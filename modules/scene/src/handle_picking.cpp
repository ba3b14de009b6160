#include "handle_picking.h"

#include <algorithm>
#include <cmath>

#include <vtkActor.h>
#include <vtkProperty.h>

#include "ray_mesh.h"

namespace viscera::scene {
namespace {

/// From here on an actor lets the handles behind it be seen.
constexpr double kOpaque = 0.999;

struct Ranked {
  HandleCandidate candidate;
  bool onBall; ///< The position is on the ball itself, not beside it.
  double rank; ///< Depth on the ball, pixels beside it.
  bool operator<(const Ranked& other) const { return onBall != other.onBall ? onBall : rank < other.rank; }
};

} // namespace

std::vector<HandleCandidate> handlesNear(const ViewGeometry& view, const Points& positions,
                                         const std::vector<double>& radii, double reach, double x, double y) {
  std::vector<Ranked> found;
  for (int i = 0; i < positions.rows(); ++i) {
    const double ball = radii[std::size_t(i)];
    const auto at = view.project(positions.row(i).transpose());
    const double dx = x - at.x, dy = y - at.y, away = std::hypot(dx, dy);
    if (ball <= 0 || at.depth <= 0 || !(away <= std::max(ball, reach)))
      continue;
    // The nearest point of the ball's disc, lifted onto the front of the ball.
    const bool onBall = away <= ball;
    const double inward = onBall ? 1 : ball / away, along = std::min(away, ball);
    const double lift = std::sqrt(ball * ball - along * along) * view.worldPerPixel(at.depth);
    const double depth = std::max(at.depth - lift, 1e-3 * at.depth);
    const Vec3 seen = view.unproject(at.x + inward * dx, at.y + inward * dy, depth);
    found.push_back({{i, seen}, onBall, onBall ? depth : away});
  }
  std::stable_sort(found.begin(), found.end());
  std::vector<HandleCandidate> candidates;
  for (const auto& ranked : found)
    candidates.push_back(ranked.candidate);
  return candidates;
}

bool isHidden(const ViewGeometry& view, const Vec3& point,
              const std::vector<vtkSmartPointer<vtkActor>>& actors) {
  const auto at = view.project(point);
  const Ray ray = view.ray(at.x, at.y);
  const double distance = (point - ray.origin).dot(ray.direction);
  return std::any_of(actors.begin(), actors.end(), [&](const auto& actor) {
    if (!actor->GetVisibility() || actor->GetProperty()->GetOpacity() < kOpaque)
      return false;
    const ActorMesh mesh(actor);
    return nearestHit(ray, mesh.view(), distance).has_value();
  });
}

} // namespace viscera::scene
