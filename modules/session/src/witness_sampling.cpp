#include "viscera/session/witness_sampling.h"

#include <chrono>
#include <cmath>
#include <cstdlib>

#include "viscera/core/error.h"
#include "viscera/deformation/grid_witnesses.h"

namespace viscera::session {
namespace {

void requireInRange(const WitnessOptions& options) {
  if (options.wanted < WitnessOptions::kFewest || options.wanted > WitnessOptions::kMost)
    throw UsageError("cannot place " + std::to_string(options.wanted) + " witness points", "witnesses",
                     "choose " + std::to_string(WitnessOptions::kFewest) + " to " +
                         std::to_string(WitnessOptions::kMost));
}

} // namespace

WitnessSample sampleWitnesses(const geometry::TriangleMesh& surface, const WitnessOptions& options,
                              Progress& progress) {
  requireInRange(options);
  const auto begin = std::chrono::steady_clock::now();
  WitnessSample sample;
  sample.origin = WitnessOrigin::grid;
  sample.mesh = std::make_shared<deformation::WitnessMesh>(
      deformation::gridWitnesses(surface, options.wanted, progress, options.threads));
  sample.remarks = {"The witness points lie on a regular grid inside the surface."};
  sample.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return sample;
}

} // namespace viscera::session
