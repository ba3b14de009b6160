#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "library_for_tests.h"
#include "viscera/core/error.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::tests {
namespace {

using sample_organs::Resolution;
using testing::AllOf;
using testing::HasSubstr;

/// The message of the error of type `Expected` with which `organ` of `library` cannot be made.
template <class Expected>
std::string messageOf(const TemporaryLibrary& files, const std::string& organ) {
  Progress progress;
  try {
    sample_organs::sampleOrgan(files.library(), organ, Resolution::low, progress);
  } catch (const Expected& error) {
    EXPECT_FALSE(error.tryThis().empty()) << error.what() << " says nothing to try";
    return error.what();
  }
  return "no error";
}

/// The message for a definition whose surface has this root, and these nodes.
std::string rootError(const std::string& root, const std::string& nodes = "") {
  TemporaryLibrary files;
  files.writeRoot("thing", root, nodes);
  return messageOf<DataError>(files, "thing");
}

const std::string kTubeStart = R"({"type": "tube", "points": )";

} // namespace

TEST(DefinitionErrors, NameTheOrgansThereAre) {
  TemporaryLibrary files;
  files.writeRoot("ball", kBall);
  files.writeRoot("egg", kBall);
  EXPECT_THAT(messageOf<UsageError>(files, "bal"),
              AllOf(HasSubstr("\"bal\""), HasSubstr("\"ball\" and \"egg\"")));
}

TEST(DefinitionErrors, NameASwitchThatIsNeitherOnNorOff) {
  for (const std::string key : {"hidden", "check_only"}) {
    TemporaryLibrary files;
    files.write("thing",
                R"({"name": "thing", "units": "mm", "frame": "LPS", "surfaces": [{"name": "outer", ")" + key +
                    R"(": "yes", "root": )" + kBall + "}]}");
    EXPECT_THAT(messageOf<DataError>(files, "thing"),
                AllOf(HasSubstr(key), HasSubstr("neither true nor false")));
  }
}

TEST(DefinitionErrors, SayWhereTheFileIsNotJson) {
  TemporaryLibrary files;
  files.write("thing", "{\n \"name\": \"thing\",\n ]");
  EXPECT_THAT(messageOf<DataError>(files, "thing"), AllOf(HasSubstr("thing.json"), HasSubstr("line 3")));
}

TEST(DefinitionErrors, NameThePointAndTheTimeOfAWay) {
  const auto wayError = [](const std::string& points) {
    TemporaryLibrary files;
    files.write("thing", R"({"name": "thing", "units": "mm", "frame": "LPS", "nodes": [], "surfaces": [)"
                         R"({"name": "outer", "root": )" +
                             std::string(kBall) + R"(, "ways": [{"name": "bundle", "points": )" + points +
                             "}]}]}");
    return messageOf<DataError>(files, "thing");
  };
  EXPECT_THAT(wayError("[[0, 0, 0, 5], [1, 0, 0]]"), HasSubstr("points[1]"));
  EXPECT_THAT(wayError("[[0, 0, 0, 5], [1, 0, 0, 4]]"), AllOf(HasSubstr("points[1]"), HasSubstr("time 4")));
  EXPECT_THAT(wayError("[[0, 0, 0, -1], [1, 0, 0, 4]]"), HasSubstr("points[0]"));
  EXPECT_THAT(wayError("[[0, 0, 0, 0]]"), HasSubstr("points"));
}

TEST(DefinitionErrors, NameTheVesselWhoseNameIsNone) {
  for (const std::string name : {"5", R"(["artery", "vein"])", R"(["artery", 0.5, 2])"}) {
    TemporaryLibrary files;
    files.writeRoot("ball", R"({"type": "surface_vessels", "base": )" + std::string(kBall) +
                                R"(, "paths": [{"points": [[0, 0, 20], [20, 0, 0]], "vessel": )" + name +
                                "}]}");
    EXPECT_THAT(messageOf<DataError>(files, "ball"), HasSubstr("vessel")) << name;
  }
}

TEST(DefinitionErrors, NameANumberBeyondDoubles) {
  TemporaryLibrary files;
  files.write("thing", "{\"name\": \"thing\", \"scale\": 1e999}");
  EXPECT_THAT(messageOf<DataError>(files, "thing"), AllOf(HasSubstr("thing.json"), HasSubstr("1e999")));
}

TEST(DefinitionErrors, SayThatAFileIsEmpty) {
  TemporaryLibrary files;
  files.write("thing", "");
  EXPECT_THAT(messageOf<DataError>(files, "thing"), AllOf(HasSubstr("thing.json"), HasSubstr("JSON")));
}

TEST(DefinitionErrors, NameFileNodeAndField) {
  const std::string nodes =
      R"({"name": "bean", "type": "ellipsoid", "center": [0, 0, 0], "radii": [1, "a", 2]})";
  EXPECT_THAT(rootError(R"("bean")", nodes), AllOf(HasSubstr("thing.json"), HasSubstr("\"bean\""),
                                                   HasSubstr("\"radii\""), HasSubstr("[x, y, z]")));
}

TEST(DefinitionErrors, FindAMisspeltField) {
  EXPECT_THAT(
      rootError(R"({"type": "ellipsoid", "center": [0, 0, 0], "radii": [9, 9, 9], "pant": [1, 0, 0]})"),
      AllOf(HasSubstr("\"pant\""), HasSubstr("\"paint\"")));
}

TEST(DefinitionErrors, FindAMissingField) {
  EXPECT_THAT(rootError(R"({"type": "ellipsoid", "radii": [9, 9, 9]})"),
              AllOf(HasSubstr("\"center\""), HasSubstr("missing")));
}

TEST(DefinitionErrors, NameTheTypesThereAre) {
  EXPECT_THAT(rootError(R"({"type": "torus"})"), AllOf(HasSubstr("\"torus\""), HasSubstr("\"tube\"")));
}

TEST(DefinitionErrors, SuggestTheNodeThatIsMeant) {
  const std::string nodes =
      R"({"name": "bean", "type": "ellipsoid", "center": [0, 0, 0], "radii": [9, 9, 9]})";
  EXPECT_THAT(rootError(R"({"type": "union", "children": ["been"]})", nodes),
              AllOf(HasSubstr("\"been\""), HasSubstr("\"bean\"")));
}

TEST(DefinitionErrors, FindACircleOfReferences) {
  const std::string nodes = R"({"name": "a", "type": "union", "children": ["b"]},
                               {"name": "b", "type": "union", "children": ["a"]})";
  EXPECT_THAT(rootError(R"("a")", nodes), HasSubstr("made of itself"));
}

TEST(DefinitionErrors, FindTwoNodesOfOneName) {
  const std::string nodes = R"({"name": "a", "type": "ellipsoid"}, {"name": "a", "type": "ellipsoid"})";
  EXPECT_THAT(rootError(R"("a")", nodes), AllOf(HasSubstr("\"a\""), HasSubstr("another node")));
}

TEST(DefinitionErrors, FindPointsThatMakeNoTube) {
  EXPECT_THAT(rootError(kTubeStart + "[[0, 0, 0, 5]]}"), HasSubstr("at least 2"));
  EXPECT_THAT(rootError(kTubeStart + "[[0, 0, 0, 5], [0, 0, 9]]}"), HasSubstr("points[1]"));
  EXPECT_THAT(rootError(kTubeStart + "[[0, 0, 0, 5], [0, 0, 9, 0]]}"), HasSubstr("points[1]"));
  EXPECT_THAT(rootError(kTubeStart + "[[0, 0, 0, 5], [0, 0, 0, 4]]}"), HasSubstr("the point before"));
}

TEST(DefinitionErrors, FindALumenOfSomethingElseThanVessels) {
  const std::string start = R"({"type": "lumen", "child": )";
  EXPECT_THAT(rootError(start + kBall + R"(, "wall": 1})"), HasSubstr("inside a lumen"));
  EXPECT_THAT(rootError(start + kTubeStart + R"([[0, 0, 0, 5], [0, 0, 9, 5]]}, "wall": 0})"),
              HasSubstr("\"wall\""));
}

/// A vessel with a lumen through it, of which `less` takes its part.
std::string vesselWith(const std::string& less, const std::string& lumenType) {
  const std::string tube =
      R"({"type": "tube", "caps": ["flat", "flat"], "points": [[0, 0, 0, 10], [0, 0, 60, 10]]})";
  return R"({"name": "vessel", "units": "mm", "frame": "LPS", "surfaces": [
    {"name": "outer", "check_only": true, "triangles": {"low": 4000, "medium": 4000, "high": 4000}, "root": )" +
         tube + R"(}, {"name": "blood", "check_only": true,
     "triangles": {"low": 3000, "medium": 3000, "high": 3000}, "root": )" +
         lumenType + R"(}, {"name": "wall", "from": "outer", "less": [")" + less + R"("]}]})";
}

TEST(DefinitionErrors, FindAWallOfAnUnknownSurface) {
  TemporaryLibrary files;
  files.write("vessel", vesselWith("bloot", kBall));
  EXPECT_THAT(messageOf<DataError>(files, "vessel"), AllOf(HasSubstr("\"bloot\""), HasSubstr("\"less\"")));
}

TEST(DefinitionErrors, FindALumenThatDoesNotLeaveItsBody) {
  TemporaryLibrary files;
  files.write("vessel",
              vesselWith("blood", R"({"type": "ellipsoid", "center": [0, 0, 30], "radii": [5, 5, 5]})"));
  EXPECT_THAT(messageOf<DataError>(files, "vessel"), HasSubstr("does not leave the body"));
}

/// pi (10^2 - 8^2) 60 mm^3, and one way through.
TEST(JoinedSurface, OfAVesselIsItsWall) {
  TemporaryLibrary files;
  const std::string tube =
      R"({"type": "tube", "caps": ["flat", "flat"], "points": [[0, 0, 0, 10], [0, 0, 60, 10]]})";
  files.write("vessel", vesselWith("blood", R"({"type": "lumen", "wall": 2, "child": )" + tube + "}"));
  Progress progress;
  const auto organ = sample_organs::sampleOrgan(files.library(), "vessel", Resolution::low, progress);
  ASSERT_EQ(organ.surfaces.size(), 1U);
  const geometry::TriangleMesh& mesh = *organ.surfaces[0].mesh;
  const geometry::SurfaceReport report = geometry::checkSurface(mesh);
  EXPECT_TRUE(report.outward() && report.manifold());
  EXPECT_EQ(mesh.points.rows() - mesh.triangles.rows() / 2, 0);
  EXPECT_NEAR(report.volumeMm3, 6786, 0.03 * 6786);
  EXPECT_EQ(geometry::countSelfIntersections(mesh, progress), 0);
}

TEST(DefinitionErrors, FindALumenInARoundEnd) {
  EXPECT_THAT(rootError(kTubeStart + R"([[0, 0, 0, 5], [0, 0, 9, 5]], "lumen": {"ends": [0]}})"),
              AllOf(HasSubstr("lumen"), HasSubstr("round")));
}

TEST(DefinitionErrors, NameThePathsThatABranchMayStartFrom) {
  const std::string vessels = R"({"type": "surface_vessels", "base": )" + std::string(kBall) + R"(, "paths": [
      {"name": "stem", "points": [[21, 2, 3], [15, 16, 3]]},
      {"from": {"path": "stam", "at": 0.5}, "points": [[1, 22, 3]]}]})";
  EXPECT_THAT(rootError(vessels), AllOf(HasSubstr("paths[1]"), HasSubstr("\"path\""), HasSubstr("\"stem\"")));
}

TEST(DefinitionErrors, FindAPathThatShrinksToAPoint) {
  const std::string vessels = R"({"type": "surface_vessels", "base": )" + std::string(kBall) +
                              R"(, "paths": [{"points": [[21, 2, 3], [21.2, 2, 3]]}]})";
  EXPECT_THAT(rootError(vessels), AllOf(HasSubstr("paths[0]"), HasSubstr("\"points\"")));
}

TEST(DefinitionErrors, FindAxesThatAreNotPerpendicular) {
  EXPECT_THAT(rootError(R"({"type": "frame", "axes": [[1, 0, 0], [1, 1, 0], [0, 0, 1]], "child": )" +
                        std::string(kBall) + "}"),
              HasSubstr("perpendicular"));
}

TEST(DefinitionErrors, RefuseASurfaceWithoutEnd) {
  EXPECT_THAT(rootError(R"({"type": "half_space", "point": [0, 0, 0], "normal": [0, 0, 1]})"),
              AllOf(HasSubstr("\"outer\""), HasSubstr("unlimited")));
}

TEST(DefinitionErrors, RefuseAnEmptySurface) {
  EXPECT_THAT(rootError(R"({"type": "offset", "distance": -30, "child": )" + std::string(kBall) + "}"),
              HasSubstr("empty"));
}

TEST(DefinitionErrors, RefuseOtherUnitsAndFrames) {
  TemporaryLibrary files;
  files.write("thing", R"({"name": "thing", "units": "cm", "frame": "LPS", "surfaces": []})");
  EXPECT_THAT(messageOf<DataError>(files, "thing"), HasSubstr("\"units\""));
  files.write("thing", R"({"name": "thing", "units": "mm", "frame": "RAS", "surfaces": []})");
  EXPECT_THAT(messageOf<DataError>(files, "thing"), HasSubstr("\"frame\""));
}

TEST(DefinitionErrors, NameAnIncludedFileThatIsNotThere) {
  TemporaryLibrary files;
  files.write("thing", R"({"name": "thing", "units": "mm", "frame": "LPS", "include": ["gone.json"],
                           "surfaces": []})");
  EXPECT_THAT(messageOf<NoInputError>(files, "thing"), HasSubstr("gone.json"));
}

TEST(DefinitionErrors, FindAFileThatIncludesItself) {
  TemporaryLibrary files;
  files.write("thing", R"({"name": "thing", "units": "mm", "frame": "LPS", "include": ["thing.json"],
                           "surfaces": []})");
  EXPECT_THAT(messageOf<DataError>(files, "thing"), HasSubstr("includes itself"));
}

} // namespace viscera::tests
