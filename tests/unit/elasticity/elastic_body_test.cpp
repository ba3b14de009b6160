#include "viscera/elasticity/elastic_body.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "elastic_grids.h"
#include "viscera/core/error.h"
#include "viscera/elasticity/static_solution.h"

namespace viscera::elasticity {
namespace {

/// A curved block, and a state in which nothing is balanced.
ElasticBody curvedBlock() {
  const auto place = [](const Vec3& p) { return Vec3(3 * p[0], 2 * p[1] + 0.2 * std::sin(2 * p[0]), p[2]); };
  return {test::elasticGrid({1, 1, 1}, place), std::make_shared<NeoHookean>(5, 0.49)};
}

Values unbalancedState(const ElasticBody& body) {
  Values state(body.unknowns());
  for (Eigen::Index i = 0; i < state.size(); ++i)
    state[i] = 0.05 * std::sin(1.7 * static_cast<double>(i));
  return state;
}

/// Compares forces and stiffness of each tetrahedron with central differences; `share` fills them in.
template <class Share>
void expectDerivatives(const ElasticBody& body, const Share& share, bool withEnergy) {
  constexpr double kDelta = 1e-5, kAllowed = 1e-6;
  const Values state = unbalancedState(body);
  ElementShare at, above, below;
  share(state, at);
  ASSERT_GT(at.smallestJacobian, 0);
  ElementShare::Matrix slopes;
  for (int k = 0; k < ElementShare::kUnknowns; ++k) {
    Values more = state, less = state;
    more[body.unknown(2, k)] += kDelta;
    less[body.unknown(2, k)] -= kDelta;
    share(more, above);
    share(less, below);
    if (withEnergy) {
      EXPECT_NEAR((above.energy - below.energy) / (2 * kDelta), at.force[k], kAllowed * at.force.norm());
    }
    slopes.col(k) = (above.force - below.force) / (2 * kDelta);
  }
  const ElementShare::Matrix symmetric = 0.5 * (slopes + slopes.transpose());
  EXPECT_LT((symmetric - at.stiffness).norm(), kAllowed * at.stiffness.norm());
  if (withEnergy) {
    EXPECT_LT((slopes - at.stiffness).norm(), kAllowed * at.stiffness.norm());
  }
}

TEST(ElasticBody, ForceAndStiffnessAreTheDerivativesOfTheMixedEnergy) {
  const ElasticBody body = curvedBlock();
  expectDerivatives(
      body, [&](const Values& state, ElementShare& share) { body.shareOf(2, state, share); }, true);
}

TEST(ElasticBody, PressureHasTheSymmetricPartOfItsTangent) {
  const ElasticBody body = curvedBlock();
  expectDerivatives(
      body,
      [&](const Values& state, ElementShare& share) {
        body.shareOf(2, state, share);
        addPressure(body, {2, 1}, 3, state, share);
      },
      false);
}

TEST(ElasticBody, PressureOnAllFacesIsInBalance) {
  const ElasticBody body = curvedBlock();
  const Values state = unbalancedState(body);
  Vec3 force = Vec3::Zero();
  double largest = 0;
  for (const Face& face : boundaryFaces(body.mesh())) {
    ElementShare share;
    share.force.setZero();
    share.stiffness.setZero();
    addPressure(body, face, 2, state, share);
    for (int i = 0; i < 3; ++i)
      force[i] += share.force.segment<10>(10 * i).sum();
    largest = std::max(largest, share.force.norm());
  }
  EXPECT_LT(force.norm(), 1e-12 * largest);
}

TEST(ElasticBody, HasTheVolumeOfItsCurvedShape) {
  // x is stretched by 3, y by 2 and shifted, which keeps the volume; quadratic edges follow the sine nearly.
  EXPECT_NEAR(curvedBlock().volumeMm3(), 6, 0.05);
  const ElasticBody straight(test::elasticGrid({2, 1, 3}, [](const Vec3& p) { return Vec3(2 * p); }),
                             std::make_shared<NeoHookean>(5, 0.4));
  EXPECT_NEAR(straight.volumeMm3(), 8, 1e-12);
}

TEST(ElasticBody, RefusesATetrahedronThatIsTurnedAround) {
  EXPECT_THROW(
      ElasticBody(test::elasticGrid({1, 1, 1}, [](const Vec3& p) { return Vec3(-p[0], p[1], p[2]); }),
                  std::make_shared<NeoHookean>(5, 0.4)),
      DataError);
}

} // namespace
} // namespace viscera::elasticity
