#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "shapes.h"
#include "viscera/core/job_queue.h"
#include "viscera/document/document.h"
#include "viscera/document/group_commands.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/live_binding.h"

/// Documents from which tests of sessions start.
namespace viscera::tests {

inline document::NewOrgan ball(const std::string& name, double radius = 30, int levels = 3,
                               const Vec3& center = Vec3::Zero()) {
  return {document::makeOrgan(name, viscera::tests::sphere(levels, radius, center)), -1};
}

/// The corners of a cube around the balls, and a few handles on a larger sphere.
inline std::vector<document::NewHandle> cubeHandles(double half = 60) {
  std::vector<document::NewHandle> handles;
  for (int i = 0; i < 8; ++i)
    handles.push_back({Vec3((i & 1) ? half : -half, (i & 2) ? half : -half, (i & 4) ? half : -half)});
  handles.push_back({Vec3(0, 0, 40)});
  handles.push_back({Vec3(40, 3, -1)});
  return handles;
}

/// A rig of them, without labels.
inline document::Rig cubeRig(double half = 60) {
  Points places(0, 3);
  for (const document::NewHandle& handle : cubeHandles(half)) {
    places.conservativeResize(places.rows() + 1, 3);
    places.bottomRows(1) = handle.rest.transpose();
  }
  return document::rigAt(places);
}

/// A box with its corners at the first eight of `cubeHandles`.
inline std::shared_ptr<geometry::TriangleMesh> cubeCage(double half = 60) {
  auto cage = std::make_shared<geometry::TriangleMesh>(viscera::tests::box(2 * half, 2 * half, 2 * half));
  cage->points.array() -= half;
  return cage;
}

inline Points row(double x, double y, double z) {
  Points points(1, 3);
  points << x, y, z;
  return points;
}

/// A document with one ball and ten handles, at rest.
struct Session {
  document::Document document;
  document::UndoStack undo{document};

  Session() {
    undo.perform(document::addOrgans({ball("Ball")}));
    undo.perform(document::addHandles(cubeHandles()));
    undo.reset(document.state());
  }

  document::HandleId handle(std::size_t row) const { return document.rig().handles.at(row).id; }
  document::OrganId organ(std::size_t place = 0) const { return document.organs().at(place)->id; }
};

/// The same, bound at once by the coordinates that there are without plugins.
struct BoundSession : Session {
  coordinates::Registry registry = coordinates::builtInRegistry();
  ManualEventLoop box;
  JobQueue jobs{box.post()};
  live::LiveBinding live{document, registry, jobs, {std::numeric_limits<double>::infinity(), {}}};
};

} // namespace viscera::tests
