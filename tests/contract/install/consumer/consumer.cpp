// A cube of handles, points inside it, S-Celestial coordinates: the points must come back, and follow the
// handles.
#include <cmath>
#include <cstdio>

#include <viscera/coordinates/systems.h>
#include <viscera/core/error.h>
#include <viscera/deformation/bind_organ.h>

namespace {

viscera::Points cube(double half) {
  viscera::Points corners(8, 3);
  for (int i = 0; i < 8; ++i)
    corners.row(i) << (i & 1 ? half : -half), (i & 2 ? half : -half), (i & 4 ? half : -half);
  return corners;
}

std::shared_ptr<const viscera::coordinates::CoordinateSystem> celestial() {
  for (const auto& system : viscera::coordinates::builtInSystems())
    if (system->id() == "s-celestial")
      return system;
  throw viscera::UsageError("there is no s-celestial");
}

} // namespace

int main() try {
  const viscera::coordinates::HandleSet handles{cube(10), {}, {}};
  const viscera::Points points = cube(4);
  viscera::Progress progress;
  const auto binding = viscera::deformation::bindOrgan(*celestial(), handles, points, {}, progress);

  viscera::Points moved;
  binding->deform(handles.positions * 2, moved);
  const double error = (moved - points * 2).cwiseAbs().maxCoeff();
  std::printf("identity error %g mm, error after scaling %g mm\n", binding->report().identityError, error);
  return binding->report().identityError < 1e-8 && error < 1e-8 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
