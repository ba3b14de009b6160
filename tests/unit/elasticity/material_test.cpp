#include "viscera/elasticity/material.h"

#include <cmath>
#include <memory>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "viscera/anatomy/organ_facts.h"
#include "viscera/core/arrays.h"
#include "viscera/core/error.h"
#include "viscera/elasticity/tissues.h"

namespace viscera::elasticity {
namespace {

constexpr double kStep = 1e-5;          ///< Of central differences.
constexpr double kByDifferences = 1e-7; ///< Their error here, relative to stress and tangent.

Eigen::Matrix3d someGradient() {
  Eigen::Matrix3d f;
  f << 1.10, 0.12, -0.05, 0.03, 0.92, 0.08, -0.07, 0.04, 1.05;
  return f;
}

std::vector<std::shared_ptr<const Material>> someMaterials() {
  const Eigen::Matrix3d axes = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  return {std::make_shared<NeoHookean>(6, 0.49),
          std::make_shared<Guccione>(Guccione::Constants{2, 8, 2, 4}, 1e3, axes)};
}

TEST(Material, StressAndTangentAreTheDerivativesOfTheEnergy) {
  for (const auto& material : someMaterials()) {
    const Eigen::Matrix3d f = someGradient();
    const Response at = material->respond(f);
    EXPECT_LT((at.tangent - at.tangent.transpose()).norm(), 1e-12 * at.tangent.norm());
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        Eigen::Matrix3d more = f, less = f;
        more(i, j) += kStep;
        less(i, j) -= kStep;
        const Response above = material->respond(more), below = material->respond(less);
        EXPECT_NEAR((above.energy - below.energy) / (2 * kStep), at.stress(i, j),
                    kByDifferences * at.stress.norm());
        const Eigen::Matrix3d slope = (above.stress - below.stress) / (2 * kStep);
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l)
            EXPECT_NEAR(slope(k, l), at.tangent(3 * k + l, 3 * i + j), kByDifferences * at.tangent.norm());
      }
  }
}

TEST(Material, RotationsChangeNoEnergyAndTurnTheStress) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, -2, 3).normalized()).toRotationMatrix();
  for (const auto& material : someMaterials()) {
    const Response before = material->respond(someGradient()),
                   after = material->respond(turn * someGradient());
    EXPECT_NEAR(after.energy, before.energy, 1e-12 * before.energy);
    EXPECT_LT((after.stress - turn * before.stress).norm(), 1e-12 * before.stress.norm());
    EXPECT_LT(material->respond(turn).stress.norm(), 1e-12 * material->shear());
  }
}

TEST(Material, NeoHookeanIsHookesLawForSmallStrains) {
  constexpr double young = 6, poisson = 0.3, strain = 1e-6;
  const NeoHookean material(young, poisson);
  // A bar that is pulled along x and free across.
  const Eigen::Matrix3d f = Vec3(1 + strain, 1 - poisson * strain, 1 - poisson * strain).asDiagonal();
  Eigen::Matrix3d stress = material.respond(f).stress;
  stress += material.bulk() * (f.determinant() - 1) * Eigen::Matrix3d::Identity();
  EXPECT_NEAR(stress(0, 0), young * strain, 1e-5 * young * strain);
  EXPECT_NEAR(stress(1, 1), 0, 1e-5 * young * strain);
}

TEST(Material, RefusesConstantsThatNoMaterialHas) {
  EXPECT_THROW(NeoHookean(0, 0.4), UsageError);
  EXPECT_THROW(NeoHookean(5, 0.5), UsageError);
  EXPECT_THROW(Guccione({-1, 1, 1, 1}, 1e3), UsageError);
}

TEST(Tissues, HaveTheirSourcesAndAreFoundByName) {
  for (const Tissue& tissue : tissues()) {
    EXPECT_GT(tissue.youngKpa, 0);
    EXPECT_EQ(tissue.doi.substr(0, 3), "10.");
    EXPECT_NO_THROW(anatomy::organ(tissue.organ)) << tissue.name;
    EXPECT_EQ(tissueNamed(anatomy::organ(tissue.organ).title).name, tissue.name);
  }
  EXPECT_EQ(tissueNamed("liver").doi, "10.1002/jmri.24084");
  EXPECT_EQ(tissueNamed("Leber").name, "liver");
  EXPECT_EQ(tissueNamed("kidney_left").name, "kidney");
  EXPECT_THROW(tissueNamed("liver tumour"), UsageError);
  EXPECT_THROW(tissueNamed("left ventricle"), UsageError) << "blood";
  EXPECT_THROW(tissueNamed("hair"), UsageError);
}

TEST(VonMisesStress, OfAShearIsRootThreeTimesTheShearStress) {
  constexpr double shear = 1e-6;
  const NeoHookean material(6, 0.49);
  Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
  f(0, 1) = shear;
  EXPECT_NEAR(vonMisesKpa(material, f), std::sqrt(3.0) * material.shear() * shear, 1e-10);
  EXPECT_NEAR(vonMisesKpa(material, 1.1 * Eigen::Matrix3d::Identity()), 0, 1e-12) << "pressure has no part";
  EXPECT_TRUE(std::isnan(vonMisesKpa(material, -Eigen::Matrix3d::Identity())));
}

} // namespace
} // namespace viscera::elasticity
