#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/deformation/organ_solid.h"
#include "viscera/medical_io/solid_model_file.h"

namespace viscera::medical_io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using tests::TemporaryFolder;

/// Two tetrahedra with a common face; the last point is on the second wall alone.
deformation::OrganSolid twoTetrahedra() {
  deformation::OrganSolid solid;
  solid.points.resize(5, 3);
  solid.points << 0, 0, 0, 10.5, 0, 0, 0, 1.0 / 3, 0, 0, 0, 10, -1.23456789012345e-5, 1e7, 20;
  solid.tetrahedra.resize(2, 4);
  solid.tetrahedra << 0, 1, 2, 3, 1, 2, 3, 4;
  solid.walls = {{"OUTER", {0, 1, 2, 3}, {{0, 3}, {0, 2}, {0, 1}}},
                 {"Ventrículo 1", {4}, {{1, 0}, {1, 1}}},
                 {"outer", {}, {}}};
  return solid;
}

/// The lines of each block of an input deck, by the block's first line.
std::map<std::string, std::vector<std::string>> blocksOf(const std::string& text) {
  std::map<std::string, std::vector<std::string>> blocks;
  std::istringstream lines(text);
  std::string block;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with('*'))
      blocks[block = line];
    else
      blocks[block].push_back(line);
  return blocks;
}

TEST(SolidModel, AnInputDeckHasNodesElementsSetsAndFaces) {
  const TemporaryFolder folder;
  writeSolidModel(folder / "heart.inp", twoTetrahedra(), "Left heart");
  const auto blocks = blocksOf(tests::contentsOf(folder / "heart.inp"));
  EXPECT_THAT(blocks.at("*HEADING"), ElementsAre(HasSubstr("SPACE=LPS; mm")));
  EXPECT_THAT(blocks.at("*NODE, NSET=NALL"),
              ElementsAre("1, 0., 0., 0.", "2, 10.5, 0., 0.", "3, 0., 0.333333333333, 0.", "4, 0., 0., 10.",
                          "5, -1.23456789012e-05, 10000000., 20."));
  EXPECT_THAT(blocks.at("*ELEMENT, TYPE=C3D4, ELSET=LEFT_HEART"),
              ElementsAre("1, 1, 2, 3, 4", "2, 2, 3, 4, 5"));
  EXPECT_THAT(blocks.at("*NSET, NSET=OUTER"), ElementsAre("1, 2, 3, 4,"));
  EXPECT_THAT(blocks.at("*NSET, NSET=VENTR__CULO_1"), ElementsAre("5,"));
  EXPECT_TRUE(blocks.contains("*NSET, NSET=OUTER_2"));
  // S1 is the face of nodes 1 2 3, S2 of 1 4 2, S3 of 2 4 3, S4 of 3 4 1.
  EXPECT_THAT(blocks.at("*SURFACE, NAME=OUTER_FACES, TYPE=ELEMENT"), ElementsAre("1, S1", "1, S2", "1, S4"));
  EXPECT_THAT(blocks.at("*SURFACE, NAME=VENTR__CULO_1_FACES, TYPE=ELEMENT"), ElementsAre("2, S3", "2, S4"));
}

TEST(SolidModel, LinesAreShortEnoughForBothPrograms) {
  const TemporaryFolder folder;
  deformation::OrganSolid solid = twoTetrahedra();
  for (std::int32_t node = 0; node < 100; ++node)
    solid.walls[0].nodes.push_back(node);
  writeSolidModel(folder / "a.inp", solid, "a");
  std::istringstream lines(tests::contentsOf(folder / "a.inp"));
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(std::count(line.begin(), line.end(), ','), 16) << line;
}

TEST(SolidModel, AGridHasAnArrayForEveryWall) {
  const TemporaryFolder folder;
  writeSolidModel(folder / "heart.vtu", twoTetrahedra(), "Heart");
  const std::string text = tests::contentsOf(folder / "heart.vtu");
  EXPECT_THAT(text, HasSubstr("UnstructuredGrid"));
  EXPECT_THAT(text, HasSubstr("Name=\"OUTER\""));
  EXPECT_THROW(writeSolidModel(folder / "heart.stl", twoTetrahedra(), "Heart"), CannotCreateError);
}

} // namespace
} // namespace viscera::medical_io
