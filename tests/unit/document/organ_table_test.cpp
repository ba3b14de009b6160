#include "viscera/document/tables.h"

#include <gtest/gtest.h>

#include "shapes.h"
#include "temporary_folder.h"

namespace viscera::document {
namespace {

TEST(OrganTable, HasOneRowAnOrganWithItsVolumeAtRestAndPosed) {
  const tests::TemporaryFolder folder;
  const auto box = std::make_shared<const Organ>(makeOrgan("Box, \"large\"", tests::box(100, 100, 100)));
  geometry::TriangleMesh open = tests::box(10, 20, 30);
  open.triangles.conservativeResize(11, 3);
  const auto cup = std::make_shared<const Organ>(makeOrgan("Cup", open));
  Points grown = box->mesh->points;
  grown.col(2) *= 1.5;
  writeOrganTable(folder / "t.csv", {{box, grown}, {cup, open.points}});
  EXPECT_EQ(tests::contentsOf(folder / "t.csv"),
            "name,vertices,triangles,closed,rest_ml,volume_ml,change_ml,change_percent,area_cm2,size_x_mm,"
            "size_y_mm,size_z_mm,largest_displacement_mm,volume_rest_ml,chamber\n"
            "\"Box, \"\"large\"\"\",8,12,yes,1000.000000,1500.000000,500.000000,50.000000,800.000000,"
            "100.000000,100.000000,150.000000,50.000000,1000.000000,\n"
            "Cup,8,11,no,,,,,19.000000,10.000000,20.000000,30.000000,0.000000,,\n");
}

} // namespace
} // namespace viscera::document
