#include <limits>
#include <set>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "library_for_tests.h"
#include "viscera/core/progress.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::tests {
namespace {

/// mm. A name is written beside a vertex, not beside a place that was meant.
constexpr double kFarthestFromSurface = 8;
constexpr double kLeastApart = 5;

class NamedPlaces : public testing::TestWithParam<std::string> {};

TEST_P(NamedPlaces, LieOnTheSurfaceApartFromEachOther) {
  Progress progress;
  // Vessels of the liver are there from the middle resolution on.
  const auto resolution =
      GetParam().ends_with("liver") ? sample_organs::Resolution::medium : sample_organs::Resolution::low;
  const std::size_t slash = GetParam().find('/');
  const std::string organ = GetParam().substr(0, slash);
  const std::string name = slash == std::string::npos ? "outer" : GetParam().substr(slash + 1);
  const auto surface = sample_organs::sampleSurface(projectLibrary(), organ, name, resolution, progress);
  ASSERT_GE(surface.places.size(), 5U);
  EXPECT_EQ(surface.places, sample_organs::namedPlaces(projectLibrary(), organ, name));
  std::set<std::string> names;
  Points vertices(0, 3);
  for (const geometry::NamedPlace& place : surface.places) {
    EXPECT_TRUE(names.insert(place.name).second) << place.name << " is there twice";
    Eigen::Index nearest = 0;
    const double away = std::sqrt(
        (surface.mesh->points.rowwise() - place.at.transpose()).rowwise().squaredNorm().minCoeff(&nearest));
    EXPECT_LT(away, kFarthestFromSurface) << place.name;
    const Vec3 vertex = surface.mesh->points.row(nearest);
    if (vertices.rows() > 0) {
      EXPECT_GT((vertices.rowwise() - vertex.transpose()).rowwise().norm().minCoeff(), kLeastApart)
          << place.name << " lies on another part";
    }
    vertices.conservativeResize(vertices.rows() + 1, 3);
    vertices.row(vertices.rows() - 1) = vertex.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(OfOrgan, NamedPlaces,
                         testing::Values("heart", "stomach", "liver", "kidney_left", "kidney_right",
                                         "stomach_and_bowel", "digestive_system", "digestive_system/spleen",
                                         "digestive_system/liver", "digestive_system/pancreas"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::erase_if(name, [](char c) { return c == '_' || c == '/'; });
                           return name;
                         });

/// A place of a surface, by its name.
Vec3 placeOf(const std::string& organ, const std::string& surface, const std::string& name) {
  for (const auto& place : sample_organs::namedPlaces(projectLibrary(), organ, surface))
    if (place.name == name)
      return place.at;
  ADD_FAILURE() << organ << " has no part " << name;
  return Vec3::Zero();
}

/// Where a part lies of another one, in the patient (LPS).
enum class Side { left, right, anterior, posterior, superior, inferior };

double along(Side side, const Vec3& way) {
  switch (side) {
  case Side::left:
    return way.x();
  case Side::right:
    return -way.x();
  case Side::posterior:
    return way.y();
  case Side::anterior:
    return -way.y();
  case Side::superior:
    return way.z();
  default:
    return -way.z();
  }
}

struct Neighbours {
  const char *organ, *surface, *part;
  Side side;
  const char* other;
};

TEST(NamedPlacesOfTheBody, LieOfEachOtherAsTheOrgansDo) {
  using enum Side;
  const Neighbours all[] = {
      {"heart", "outer", "Aortic arch", superior, "Ascending aorta"},
      {"heart", "outer", "Pulmonary trunk", anterior, "Ascending aorta"},
      {"heart", "outer", "Pulmonary trunk", left, "Ascending aorta"},
      {"heart", "outer", "Left pulmonary artery", superior, "Pulmonary trunk"},
      {"heart", "outer", "Superior vena cava", superior, "Inferior vena cava"},
      {"heart", "outer", "Superior vena cava", right, "Ascending aorta"},
      {"heart", "outer", "Left atrium", posterior, "Right atrium"},
      {"heart", "outer", "Left atrium", left, "Right atrium"},
      {"heart", "outer", "Left auricle", anterior, "Left atrium"},
      {"heart", "outer", "Pulmonary vein", posterior, "Left auricle"},
      {"heart", "outer", "Left anterior descending artery", left, "Right coronary artery"},
      {"heart", "outer", "Apex", left, "Left anterior descending artery"},
      {"heart", "outer", "Apex", inferior, "Left anterior descending artery"},
      {"stomach", "outer", "Oesophagus", superior, "Cardia"},
      {"stomach", "outer", "Fundus", left, "Cardia"},
      {"stomach", "outer", "Fundus", superior, "Body"},
      {"stomach", "outer", "Fundus", superior, "Cardial notch"},
      {"stomach", "outer", "Fundus", left, "Cardial notch"},
      {"stomach", "outer", "Angular incisure", right, "Body"},
      {"stomach", "outer", "Antrum", inferior, "Angular incisure"},
      {"stomach", "outer", "Greater curvature", left, "Lesser curvature"},
      {"stomach", "outer", "Antrum", inferior, "Body"},
      {"stomach", "outer", "Pylorus", right, "Antrum"},
      {"stomach", "outer", "Duodenum", right, "Pylorus"},
      {"liver", "outer", "Right lobe", right, "Left lobe"},
      {"liver", "outer", "Dome under the diaphragm", superior, "Right lobe"},
      {"liver", "outer", "Gallbladder", anterior, "Portal vein"},
      {"liver", "outer", "Gallbladder", inferior, "Right lobe"},
      {"liver", "outer", "Inferior vena cava", posterior, "Portal vein"},
      {"liver", "outer", "Caudate lobe", posterior, "Portal vein"},
      {"kidney_left", "outer", "Lateral border", left, "Renal pelvis"},
      {"kidney_right", "outer", "Lateral border", right, "Renal pelvis"},
      {"kidney_left", "outer", "Upper pole", superior, "Lower pole"},
      {"kidney_right", "outer", "Upper pole", superior, "Lower pole"},
      {"kidney_left", "outer", "Renal vein", anterior, "Renal artery"},
      {"kidney_right", "outer", "Renal vein", anterior, "Renal artery"},
      {"kidney_left", "outer", "Renal pelvis", posterior, "Renal artery"},
      {"kidney_right", "outer", "Renal pelvis", posterior, "Renal artery"},
      {"kidney_left", "outer", "Ureter", inferior, "Renal pelvis"},
      {"kidney_right", "outer", "Ureter", inferior, "Renal pelvis"},
      {"stomach_and_bowel", "outer", "Caecum", inferior, "Ascending colon"},
      {"stomach_and_bowel", "outer", "Appendix", inferior, "Caecum"},
      {"stomach_and_bowel", "outer", "Ascending colon", right, "Descending colon"},
      {"stomach_and_bowel", "outer", "Ascending colon", inferior, "Right colic flexure"},
      {"stomach_and_bowel", "outer", "Left colic flexure", superior, "Right colic flexure"},
      {"stomach_and_bowel", "outer", "Left colic flexure", left, "Right colic flexure"},
      {"stomach_and_bowel", "outer", "Transverse colon", anterior, "Duodenum"},
      {"stomach_and_bowel", "outer", "Sigmoid colon", inferior, "Descending colon"},
      {"stomach_and_bowel", "outer", "Rectum", posterior, "Sigmoid colon"},
      {"stomach_and_bowel", "outer", "Duodenum", right, "Body of the stomach"},
      {"stomach_and_bowel", "outer", "Fundus", superior, "Body of the stomach"},
      {"digestive_system", "liver", "Right lobe", right, "Left lobe"},
      {"digestive_system", "liver", "Inferior vena cava", posterior, "Gallbladder"},
      {"digestive_system", "liver", "Bile duct", anterior, "Portal vein"},
      {"digestive_system", "liver", "Bile duct", right, "Portal vein"},
      {"digestive_system", "pancreas", "Head", right, "Neck"},
      {"digestive_system", "pancreas", "Neck", right, "Body"},
      {"digestive_system", "pancreas", "Body", right, "Tail"},
      {"digestive_system", "pancreas", "Uncinate process", inferior, "Head"},
      {"digestive_system", "pancreas", "Uncinate process", posterior, "Neck"},
      {"digestive_system", "spleen", "Diaphragmatic surface", left, "Hilum"},
      {"digestive_system", "spleen", "Superior border", superior, "Anterior end"},
      {"digestive_system", "spleen", "Posterior end", posterior, "Hilum"},
      {"digestive_system", "spleen", "Anterior end", anterior, "Hilum"}};
  for (const auto& [organ, surface, part, side, other] : all)
    EXPECT_GT(along(side, placeOf(organ, surface, part) - placeOf(organ, surface, other)), 5)
        << organ << ": " << part << " and " << other;
}

/// A name beside a vessel is not on it: its vertex has the vessel's paint.
TEST(NamedPlacesOfTheBody, OfTheCoronaryArteriesLieOnThem) {
  Progress progress;
  const auto surface = sample_organs::sampleSurface(projectLibrary(), "heart", "outer",
                                                    sample_organs::Resolution::medium, progress);
  const Eigen::RowVector3d artery = 255 * Eigen::RowVector3d(0.80, 0.12, 0.09);
  for (const char* name : {"Right coronary artery", "Left anterior descending artery"}) {
    Eigen::Index vertex = 0;
    (surface.mesh->points.rowwise() - placeOf("heart", "outer", name).transpose())
        .rowwise()
        .squaredNorm()
        .minCoeff(&vertex);
    EXPECT_LT((surface.mesh->colors.row(vertex).cast<double>() - artery).norm(), 40) << name;
  }
}

/// Each valve is at the base of its ventricle, with the size of its ring.
TEST(NamedPlacesOfTheBody, OfTheValvesAreOnTheirVentricles) {
  Progress progress;
  const std::pair<const char*, const char*> valves[] = {
      {"lv", "Mitral valve"}, {"lv", "Aortic valve"}, {"rv", "Tricuspid valve"}, {"rv", "Pulmonary valve"}};
  for (const auto& [surface, name] : valves) {
    const auto cavity = sample_organs::sampleSurface(projectLibrary(), "heart", surface,
                                                     sample_organs::Resolution::low, progress);
    const Vec3 at = placeOf("heart", surface, name);
    EXPECT_LT((cavity.mesh->points.rowwise() - at.transpose()).rowwise().norm().minCoeff(),
              kFarthestFromSurface)
        << name;
    for (const geometry::NamedPlace& place : cavity.places)
      EXPECT_TRUE(place.ringMm > 8 && place.ringMm < 20) << place.name;
  }
}

/// Parts of the right atrium's inner surface are points on its wall, none of them a valve.
TEST(NamedPlacesOfTheBody, OfTheRightAtriumAreOnItsWall) {
  Progress progress;
  const auto cavity =
      sample_organs::sampleSurface(projectLibrary(), "heart", "ra", sample_organs::Resolution::low, progress);
  ASSERT_EQ(cavity.places.size(), 3U);
  for (const geometry::NamedPlace& place : cavity.places) {
    EXPECT_LT((cavity.mesh->points.rowwise() - place.at.transpose()).rowwise().norm().minCoeff(),
              kFarthestFromSurface)
        << place.name;
    EXPECT_EQ(place.ringMm, 0) << place.name;
  }
}

/// The definition of the heart has its parts apart from each other.
TEST(NamedPlacesOfTheBody, OfTheHeartLieOnTheirOwnPart) {
  const std::pair<const char*, const char*> parts[] = {
      {"Aortic arch", "aorta"},         {"Ascending aorta", "aorta"},
      {"Pulmonary trunk", "pulmonary"}, {"Left pulmonary artery", "pulmonary"},
      {"Superior vena cava", "cavae"},  {"Inferior vena cava", "cavae"},
      {"Right atrium", "RA"},           {"Left atrium", "LA"},
      {"Left auricle", "LA"},           {"Pulmonary vein", "veins_pulm"},
      {"Apex", "ventricles"},           {"Left anterior descending artery", "ventricles"}};
  for (const auto& [name, node] : parts) {
    const Vec3 place = placeOf("heart", "outer", name);
    std::string nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const char* other : {"aorta", "pulmonary", "cavae", "RA", "LA", "veins_pulm", "ventricles"})
      if (const double away = sample_organs::implicitSurface(projectLibrary(), "heart", other)(place);
          away < least) {
        least = away;
        nearest = other;
      }
    EXPECT_EQ(nearest, node) << name;
    EXPECT_LT(least, kFarthestFromSurface) << name;
  }
}

} // namespace
} // namespace viscera::tests
