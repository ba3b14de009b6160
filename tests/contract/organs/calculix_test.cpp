#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <unistd.h>

#include "viscera/core/error.h"
#include "viscera/elasticity/elastic_organ.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::elasticity {
namespace {

constexpr double kYoungKpa = 6, kPoisson = 0.45;

/// CalculiX's neo-Hookean energy, mu / 2 (J^(-2/3) |F|^2 - 3) beside K / 2 (J - 1)^2. For small strains it is
/// that of `NeoHookean`.
class CalculixNeoHooke final : public Material {
public:
  Response respond(const Eigen::Matrix3d& f) const override {
    const double j = f.determinant(), scale = shear() * std::pow(j, -2.0 / 3), square = f.squaredNorm();
    const Eigen::Matrix3d inverse = f.inverse().transpose();
    Response response;
    response.energy = 0.5 * (scale * square - 3 * shear());
    const Eigen::Matrix3d deviator = f - square / 3 * inverse;
    response.stress = scale * deviator;
    for (int column = 0; column < 9; ++column) {
      Eigen::Matrix3d step = Eigen::Matrix3d::Zero();
      step(column / 3, column % 3) = 1;
      const Eigen::Matrix3d change = scale * (step - 2.0 / 3 * inverse.cwiseProduct(step).sum() * deviator -
                                              2.0 / 3 * f.cwiseProduct(step).sum() * inverse +
                                              square / 3 * inverse * step.transpose() * inverse);
      for (int row = 0; row < 9; ++row)
        response.tangent(row, column) = change(row / 3, row % 3);
    }
    return response;
  }
  double bulk() const override { return kYoungKpa / (3 * (1 - 2 * kPoisson)); }
  double shear() const override { return kYoungKpa / (2 * (1 + kPoisson)); }
};

/// The same energy, all of it in the displacements: next to nothing is left for our pressures, so that our
/// elements are those of CalculiX, but for their quadrature (14 points; C3D10 has 4).
class DisplacementsOnly final : public Material {
public:
  Response respond(const Eigen::Matrix3d& f) const override {
    Response response = whole_.respond(f);
    const double j = f.determinant(), bulk = whole_.bulk();
    const Eigen::Matrix3d inverse = f.inverse().transpose();
    response.energy += 0.5 * bulk * (j - 1) * (j - 1);
    response.stress += bulk * (j - 1) * j * inverse;
    for (int column = 0; column < 9; ++column) {
      Eigen::Matrix3d step = Eigen::Matrix3d::Zero();
      step(column / 3, column % 3) = 1;
      const Eigen::Matrix3d change = bulk * j *
                                     ((2 * j - 1) * inverse.cwiseProduct(step).sum() * inverse -
                                      (j - 1) * inverse * step.transpose() * inverse);
      for (int row = 0; row < 9; ++row)
        response.tangent(row, column) += change(row / 3, row % 3);
    }
    return response;
  }
  double bulk() const override { return 1e-6 * whole_.shear(); }
  double shear() const override { return whole_.shear(); }

private:
  CalculixNeoHooke whole_;
};

/// A folder that is removed at the end.
struct CalculixFolder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("calculix_" + std::to_string(::getpid()));
  CalculixFolder() { std::filesystem::create_directories(path); }
  ~CalculixFolder() { std::filesystem::remove_all(path); }
  CalculixFolder(const CalculixFolder&) = delete;
  CalculixFolder& operator=(const CalculixFolder&) = delete;
};

bool calculixThere() {
  return std::system("command -v ccx >/dev/null 2>&1") == 0;
}

/// The nodes of the organ's tetrahedra by ABAQUS's order, which is ours: corners, then edges 01, 12, 02, 03,
/// 13, 23. Neo-Hooke there is C10 (I1 - 3) + (J - 1)^2 / D1 with the invariants of the part of F that keeps
/// the volume: C10 = mu / 2, D1 = 2 / bulk modulus.
void writeCalculix(const std::filesystem::path& file, const QuadraticMesh& mesh, const Loads& loads) {
  std::ofstream out(file);
  out.precision(12);
  out << "*NODE, NSET=ALL\n";
  for (Eigen::Index n = 0; n < mesh.nodes.rows(); ++n)
    out << n + 1 << "," << mesh.nodes(n, 0) << "," << mesh.nodes(n, 1) << "," << mesh.nodes(n, 2) << "\n";
  out << "*ELEMENT, TYPE=C3D10, ELSET=ORGAN\n";
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
    out << t + 1;
    for (int k = 0; k < 10; ++k)
      out << "," << mesh.tetrahedra(t, k) + 1;
    out << "\n";
  }
  const CalculixNeoHooke material;
  out << "*MATERIAL, NAME=TISSUE\n*HYPERELASTIC, NEO HOOKE\n"
      << material.shear() / 2 << "," << 2 / material.bulk()
      << "\n*SOLID SECTION, ELSET=ORGAN, MATERIAL=TISSUE\n"
      << "*STEP, NLGEOM, INC=100\n*STATIC\n0.5,1.\n*BOUNDARY\n";
  for (const Prescribed& one : loads.prescribed)
    out << one.node + 1 << "," << one.axis + 1 << "," << one.axis + 1 << "," << one.displacementMm << "\n";
  out << "*NODE PRINT, NSET=ALL, FREQUENCY=1000\nU\n*END STEP\n";
}

/// The last table of displacements in a `.dat` file.
Points readCalculix(const std::filesystem::path& file, Eigen::Index nodes) {
  Points displacements = Points::Constant(nodes, 3, std::nan(""));
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream row(line);
    Eigen::Index node = 0;
    double x = 0, y = 0, z = 0;
    if (row >> node >> x >> y >> z && node >= 1 && node <= nodes)
      displacements.row(node - 1) << x, y, z;
  }
  return displacements;
}

/// The whole skin moves by a smooth map that bends and twists the organ; `size` 1 is by up to a tenth of it.
Loads bent(const ElasticOrgan& organ, double size) {
  const Points& nodes = organ.body().mesh().nodes;
  const Bounds box = boundsOf(nodes);
  const double half = 0.5 * box.diagonal();
  Loads loads;
  for (const std::int32_t node : organ.skin()) {
    const Vec3 p = (nodes.row(node).transpose() - box.center()) / half;
    const Vec3 move =
        0.1 * size * half *
        Vec3(p[1] * p[1] - p[0] * p[2], 2 * p[0] * p[0] * p[1] - p[2] * p[0], 2 * p[0] * p[0] + p[0] * p[1]);
    for (int axis = 0; axis < 3; ++axis)
      loads.prescribed.push_back({node, axis, move[axis]});
  }
  return loads;
}

/// How far CalculiX's displacements are from ours, in per cent of the largest displacement.
struct Apart {
  double largest = -1; ///< -1 where CalculiX fails.
  double typical = -1; ///< The root of the mean square.
};

/// One of 14 handles around the organ is dragged by 3 % of the diagonal of its box; the others hold it.
Loads dragged(const ElasticOrgan& organ) {
  const Bounds box = boundsOf(organ.body().mesh().nodes);
  Points rest(14, 3);
  Eigen::Index next = 0;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (const int axes = std::abs(x) + std::abs(y) + std::abs(z); axes == 1 || axes == 3)
          rest.row(next++) = box.center() + 0.5 * box.diagonal() * Vec3(x, y, z).normalized();
  Points pose = rest;
  pose.row(5) += 0.03 * box.diagonal() * Eigen::RowVector3d(0.6, 0.64, 0.48);
  return {gripsOf(organ, rest, pose, {}).prescribed, {}};
}

/// The sample liver in about so many tetrahedra.
ElasticOrgan liverOf(std::shared_ptr<const Material> material, int tetrahedra) {
  OrganOptions options;
  options.tetrahedra = tetrahedra;
  Progress progress;
  const auto liver = sample_organs::sampleOrgan(sample_organs::standardLibrary(), "liver",
                                                sample_organs::Resolution::low, progress);
  return {*liver.surfaces.front().mesh, options, std::move(material), progress};
}

Apart apartPerCent(const ElasticOrgan& organ, const Loads& loads) {
  Progress progress;
  const StaticSolution ours = solveStatic(organ.body(), loads, {}, progress);
  const CalculixFolder folder;
  writeCalculix(folder.path / "organ.inp", organ.body().mesh(), loads);
  const std::string command = "cd '" + folder.path.string() + "' && OMP_NUM_THREADS=1 ccx organ >log 2>&1";
  if (std::system(command.c_str()) != 0)
    return {};
  const Points theirs = readCalculix(folder.path / "organ.dat", organ.body().mesh().nodes.rows());
  if (!theirs.allFinite())
    return {};
  const double largest = ours.displacements.rowwise().norm().maxCoeff();
  const Values apart = (theirs - ours.displacements).rowwise().norm();
  return {100 * apart.maxCoeff() / largest,
          100 * apart.norm() / std::sqrt(static_cast<double>(apart.size())) / largest};
}

/// Skips the test where there is no CalculiX; continuous integration has it.
class CalculiX : public testing::Test {
protected:
  void SetUp() override {
    if (calculixThere())
      return;
    ASSERT_EQ(std::getenv("CI"), nullptr) << "the package calculix-ccx is missing";
    GTEST_SKIP() << "there is no ccx (Debian's package calculix-ccx)";
  }

  static void expectAgreement(const Apart& apart, double largest, double typical) {
    RecordProperty("largestPerCent", std::to_string(apart.largest));
    RecordProperty("typicalPerCent", std::to_string(apart.typical));
    EXPECT_GE(apart.largest, 0) << "CalculiX found no equilibrium";
    EXPECT_LE(apart.largest, largest);
    EXPECT_LE(apart.typical, typical);
  }
};

TEST_F(CalculiX, AgreesOnASmallMotionOfOurMaterial) {
  const ElasticOrgan organ = liverOf(std::make_shared<NeoHookean>(kYoungKpa, kPoisson), 1200);
  expectAgreement(apartPerCent(organ, bent(organ, 0.1)), 1, 0.25);
}

TEST_F(CalculiX, AgreesOnALargeMotionOfTheSameEnergyAndElements) {
  const ElasticOrgan organ = liverOf(std::make_shared<DisplacementsOnly>(), 1200);
  expectAgreement(apartPerCent(organ, bent(organ, 1)), 0.1, 0.01);
}

TEST_F(CalculiX, AgreesOnADraggedHandleOfTheSameEnergyAndElements) {
  const ElasticOrgan organ = liverOf(std::make_shared<DisplacementsOnly>(), 600);
  expectAgreement(apartPerCent(organ, dragged(organ)), 1, 0.1);
}

} // namespace
} // namespace viscera::elasticity
