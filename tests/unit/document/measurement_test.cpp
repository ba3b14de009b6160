#include "viscera/document/measured_values.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "phantom_scan.h"
#include "session_scene.h"
#include "viscera/core/error.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/scan_item.h"
#include "viscera/document/tables.h"

namespace viscera::document {
namespace {

using testing::HasSubstr;
using tests::Session;
using viscera::tests::contentsOf;
using viscera::tests::TemporaryFolder;

MeasuredPoint fixedAt(double x, double y, double z) {
  MeasuredPoint point;
  point.rest = {x, y, z};
  return point;
}

/// A box of 20 x 30 x 40 mm and what is measured on it.
struct BoxSession : Session {
  BoxSession() {
    undo.perform(addOrgans({{makeOrgan("Box", viscera::tests::box(20, 30, 40)), -1}}));
    undo.reset(document.state());
  }
  const Organ& box() const { return *document.organs()[1]; }
  MeasuredPoint vertex(int triangle, int corner) const {
    return surfacePoint(box(), triangle, Vec3::Unit(corner));
  }
  const Measurement& only() const { return document.measurements().at(0); }
  MeasuredValues valuesWith(const Points& boxPoints) const {
    return measure(only(), document.state(), [&](OrganId organ) -> const Points& {
      return organ == box().id ? boxPoints : document.organ(organ)->mesh->points;
    });
  }
};

TEST(MeasuredValue, IsTheDistanceOfTwoPlacesAndTheAngleAtTheMiddleOneOfThree) {
  EXPECT_DOUBLE_EQ(measuredValue({{1, 2, 3}, {1 + 2, 2 + 3, 3 + 6}}), 7);
  EXPECT_DOUBLE_EQ(measuredValue({{5, 0, 0}, {0, 0, 0}, {0, 0, 9}}), 90);
  EXPECT_NEAR(measuredValue({{1, 0, 0}, {0, 0, 0}, {1, std::sqrt(3), 0}}), 60, 1e-12);
  EXPECT_DOUBLE_EQ(measuredValue({{-2, 1, 1}, {1, 1, 1}, {9, 1, 1}}), 180);
  EXPECT_DOUBLE_EQ(measuredValue({{2, 1, 1}, {1, 1, 1}, {9, 1, 1}}), 0);
}

TEST(MeasuredValue, OfATinyAngleIsAsExactAsThatOfALargeOne) {
  for (const double angle : {1e-9, 1e-5, 0.5, 3.1415}) // rad
    EXPECT_NEAR(measuredValue({{3, 0, 0}, {0, 0, 0}, {2 * std::cos(angle), 2 * std::sin(angle), 0}}),
                angle * 180 / M_PI, 1e-13);
}

TEST(MeasuredValue, OfAnAngleWithALegOfNoLengthIsZeroAndNotUndefined) {
  EXPECT_EQ(measuredValue({{1, 1, 1}, {1, 1, 1}, {2, 0, 0}}), 0);
}

TEST(SurfacePoint, IsWhereItsWeightsSayAndRefusesWhatIsNoPlaceOnTheSurface) {
  const BoxSession s;
  const auto corners = s.box().mesh->triangles.row(4);
  const MeasuredPoint point = surfacePoint(s.box(), 4, {0.5, 0.25, 0.25});
  const Vec3 expected = 0.5 * s.box().mesh->points.row(corners[0]).transpose() +
                        0.25 * s.box().mesh->points.row(corners[1]).transpose() +
                        0.25 * s.box().mesh->points.row(corners[2]).transpose();
  EXPECT_LT((point.rest - expected).norm(), 1e-12);
  EXPECT_EQ(point.organ, s.box().id);
  EXPECT_THROW(surfacePoint(s.box(), 12, {1, 0, 0}), DataError);
  EXPECT_THROW(surfacePoint(s.box(), -1, {1, 0, 0}), DataError);
  EXPECT_THROW(surfacePoint(s.box(), 0, {0.5, 0.5, 0.5}), DataError);
  EXPECT_THROW(surfacePoint(s.box(), 0, {1.5, -0.5, 0}), DataError);
  EXPECT_THROW(surfacePoint(s.box(), 0, {std::nan(""), 0.5, 0.5}), DataError);
}

/// The box beside another one, 12 mm away along x and 5 mm along y.
struct TwoBoxSession : BoxSession {
  TwoBoxSession() {
    geometry::TriangleMesh other = viscera::tests::box(20, 30, 40);
    other.points.rowwise() += Eigen::RowVector3d(32, 35, 0);
    undo.perform(addOrgans({{makeOrgan("Other", other), -1}}));
    undo.reset(document.state());
  }
  const Organ& other() const { return *document.organs()[2]; }
};

TEST(Gap, IsTheShortestWayBetweenTwoOrgansInEveryPose) {
  TwoBoxSession s;
  s.undo.perform(addGap(s.box().id, s.other().id));
  EXPECT_EQ(s.only().name, "Box - Other");
  EXPECT_EQ(s.only().kind, MeasurementKind::gap);
  EXPECT_EQ(unitOf(s.only(), s.document.state()), "mm");
  MeasuringMemory memory;
  Points moved = s.box().mesh->points;
  const auto values = [&] {
    return measure(
        s.only(), s.document.state(),
        [&](OrganId organ) -> const Points& {
          return organ == s.box().id ? moved : s.document.organ(organ)->mesh->points;
        },
        &memory);
  };
  EXPECT_NEAR(values().now, 13, 1e-12);
  EXPECT_NEAR(values().rest, 13, 1e-12);
  moved.col(0).array() += 9;
  EXPECT_NEAR(values().now, std::hypot(3, 5), 1e-12);
  EXPECT_NEAR(values().rest, 13, 1e-12);
  EXPECT_NEAR((values().places[1] - values().places[0]).norm(), values().now, 1e-12);
  moved.col(0).array() += 9;
  moved.col(1).array() += 9;
  EXPECT_EQ(values().now, 0) << "they cross";
  s.undo.undo();
  EXPECT_TRUE(s.document.measurements().empty());
}

TEST(Gap, IsBetweenTwoOrgansAndCannotBeDragged) {
  TwoBoxSession s;
  EXPECT_THROW(s.undo.perform(addGap(s.box().id, s.box().id)), UsageError);
  s.undo.perform(addGap(s.box().id, s.other().id));
  EXPECT_THROW(s.undo.perform(moveMeasuredPoint(s.only().id, 0, s.vertex(1, 1))), UsageError);
  s.undo.perform(removeOrgans({s.other().id}));
  EXPECT_TRUE(s.document.measurements().empty()) << "it goes with its organ";
}

/// The least distance from a place to points that are spread over all triangles.
double sampledDistance(const Organ& organ, const Vec3& place) {
  constexpr int kSteps = 10;
  double least = HUGE_VAL;
  for (int triangle = 0; triangle < organ.mesh->triangles.rows(); ++triangle)
    for (int i = 0; i <= kSteps; ++i)
      for (int k = 0; k <= kSteps - i; ++k) {
        const Vec3 weights = Vec3(i, k, kSteps - i - k) / kSteps;
        least = std::min(least, (surfacePoint(organ, triangle, weights).rest - place).norm());
      }
  return least;
}

TEST(NearestPoint, IsNearerThanAnyOtherOfTheSurface) {
  const Session s;
  const Organ& ball = *s.document.organs()[0];
  for (const Vec3& place :
       {Vec3(10, 20, 30), Vec3(-90, 3, 0), Vec3(0, 0, -29), Vec3(-1, -1, 5), Vec3(4, 0, 31)}) {
    const MeasuredPoint point = nearestPoint(ball, place);
    const double away = (point.rest - place).norm();
    const double sampled = sampledDistance(ball, place);
    EXPECT_LE(away, sampled + 1e-9) << place.transpose();
    EXPECT_GT(away, sampled - 0.1) << place.transpose();
    EXPECT_GE(point.weights.minCoeff(), 0);
  }
}

TEST(NearestPoint, OfAPlaceOnTheSurfaceIsThatPlace) {
  const Session s;
  const Organ& ball = *s.document.organs()[0];
  const MeasuredPoint again = nearestPoint(ball, surfacePoint(ball, 17, {0.2, 0.3, 0.5}).rest);
  EXPECT_EQ(again.triangle, 17);
  EXPECT_LT((again.weights - Vec3(0.2, 0.3, 0.5)).norm(), 1e-9);
}

TEST(Measure, FollowsTheSurfaceAndKeepsTheValueAtRest) {
  BoxSession s;
  const MeasuredPoint a = nearestPoint(s.box(), s.box().mesh->points.row(0).transpose());
  const MeasuredPoint b =
      nearestPoint(s.box(), s.box().mesh->points.colwise().mean() * 2 - s.box().mesh->points.row(0));
  s.undo.perform(addMeasurement({a, b}));
  EXPECT_NEAR(s.valuesWith(s.box().mesh->points).now, std::sqrt(400.0 + 900 + 1600), 1e-9);
  Points grown = s.box().mesh->points;
  grown.col(2) *= 2;
  const MeasuredValues values = s.valuesWith(grown);
  EXPECT_NEAR(values.rest, std::sqrt(400.0 + 900 + 1600), 1e-9);
  EXPECT_NEAR(values.now, std::sqrt(400.0 + 900 + 6400), 1e-9);
}

TEST(Measure, LeavesAPlaceThatIsOnNoOrganWhereItIs) {
  BoxSession s;
  s.undo.perform(addMeasurement({fixedAt(1, 2, 3), s.vertex(0, 1)}));
  const MeasuredValues values = s.valuesWith(Points(s.box().mesh->points.array() + 5));
  EXPECT_EQ(values.places[0], Vec3(1, 2, 3));
  EXPECT_LT((values.places[1] - s.only().points[1].rest - Vec3::Constant(5)).norm(), 1e-12);
}

TEST(MeasurementCommands, AddWithNumberedNamesRenameMoveRemoveAndTakeBack) {
  BoxSession s;
  s.undo.perform(addMeasurement({s.vertex(0, 0), s.vertex(1, 1)}));
  s.undo.perform(addMeasurement({s.vertex(0, 0), s.vertex(1, 1)}));
  s.undo.perform(addMeasurement({s.vertex(0, 0), s.vertex(1, 1), s.vertex(3, 2)}));
  ASSERT_EQ(s.document.measurements().size(), 3u);
  EXPECT_EQ(s.document.measurements()[1].name, "Distance 2");
  EXPECT_EQ(s.document.measurements()[2].name, "Angle 1");
  EXPECT_EQ(s.document.measurements()[2].kind, MeasurementKind::angle);
  const DocumentState three = s.document.state();

  const MeasurementId first = s.only().id;
  s.undo.perform(renameMeasurement(first, "Length"));
  s.undo.perform(moveMeasuredPoint(first, 1, fixedAt(1, 1, 1)));
  EXPECT_EQ(s.only().name, "Length");
  EXPECT_EQ(s.only().points[1].rest, Vec3(1, 1, 1));
  s.undo.perform(removeMeasurements({first}));
  EXPECT_EQ(s.document.measurements().size(), 2u);
  s.undo.perform(addMeasurement({s.vertex(0, 0), s.vertex(1, 1)}));
  EXPECT_EQ(s.document.measurements().back().name, "Distance 1") << "the number is free again";
  s.undo.perform(removeAllMeasurements());
  EXPECT_TRUE(s.document.measurements().empty());
  for (int i = 0; i < 5; ++i)
    s.undo.undo();
  EXPECT_EQ(s.document.state(), three);
}

TEST(MeasurementCommands, MakeOneStepOfADraggedPoint) {
  BoxSession s;
  s.undo.perform(addMeasurement({s.vertex(0, 0), s.vertex(1, 1)}));
  const auto steps = s.undo.position();
  UndoStack::Step step(s.undo, "Move measured point");
  for (int triangle = 0; triangle < 5; ++triangle)
    s.undo.perform(moveMeasuredPoint(s.only().id, 0, s.vertex(triangle, 2)));
  step.finish();
  EXPECT_EQ(s.undo.position(), steps + 1);
}

TEST(MeasurementCommands, RefuseWhatMeasuresNothingAndLeaveTheDocument) {
  BoxSession s;
  s.undo.perform(addMeasurement({s.vertex(0, 0), s.vertex(1, 1)}));
  const DocumentState before = s.document.state();
  MeasuredPoint unknown = s.vertex(0, 0);
  unknown.organ = OrganId{4711};
  MeasuredPoint outside = s.vertex(0, 0);
  outside.triangle = 12;
  EXPECT_THROW(s.undo.perform(addMeasurement({fixedAt(0, 0, 0)})), UsageError);
  EXPECT_THROW(s.undo.perform(addMeasurement(std::vector<MeasuredPoint>(4))), UsageError);
  EXPECT_THROW(s.undo.perform(addMeasurement({fixedAt(0, 0, 0), unknown})), UsageError);
  EXPECT_THROW(s.undo.perform(addMeasurement({fixedAt(0, 0, 0), outside})), DataError);
  EXPECT_THROW(s.undo.perform(addMeasurement({fixedAt(0, 0, 0), fixedAt(0, HUGE_VAL, 0)})), DataError);
  EXPECT_THROW(s.undo.perform(moveMeasuredPoint(s.only().id, 2, fixedAt(0, 0, 0))), UsageError);
  EXPECT_THROW(s.undo.perform(moveMeasuredPoint({4711}, 0, fixedAt(0, 0, 0))), UsageError);
  EXPECT_THROW(s.undo.perform(renameMeasurement(s.only().id, "")), DataError);
  EXPECT_NO_THROW(s.undo.perform(removeMeasurements({s.only().id, s.only().id}))) << "named twice";
  s.undo.undo();
  EXPECT_THROW(s.undo.perform(removeMeasurements({{4711}})), UsageError);
  EXPECT_EQ(s.document.state(), before);
}

TEST(MeasurementCommands, GoWithTheOrganThatTheyAreOnInOneStep) {
  BoxSession s;
  const Organ& ball = *s.document.organs()[0];
  s.undo.perform(addMeasurement({s.vertex(0, 0), s.vertex(1, 1)}, "on the box"));
  s.undo.perform(addMeasurement({s.vertex(0, 0), surfacePoint(ball, 0, {1, 0, 0})}, "between both"));
  s.undo.perform(addMeasurement({surfacePoint(ball, 1, {1, 0, 0}), fixedAt(0, 0, 0)}, "on the ball"));
  const DocumentState before = s.document.state();
  s.undo.perform(removeOrgans({s.box().id}));
  ASSERT_EQ(s.document.measurements().size(), 1u);
  EXPECT_EQ(s.only().name, "on the ball");
  s.undo.undo();
  EXPECT_EQ(s.document.state(), before);
  s.undo.perform(removeAllOrgans());
  EXPECT_TRUE(s.document.measurements().empty());
  s.undo.undo();
  EXPECT_EQ(s.document.state(), before);
}

TEST(MeasurementCommands, StayInPlaceWhenTheHolesOfTheirOrganAreClosed) {
  Session s;
  geometry::TriangleMesh open = viscera::tests::box(20, 30, 40);
  open.triangles = open.triangles.bottomRows(11).eval();
  s.undo.perform(addOrgans({{makeOrgan("Cup", open), -1}}));
  const OrganId cup = s.organ(1);
  const MeasuredPoint a = surfacePoint(*s.document.organ(cup), 3, {0.2, 0.3, 0.5});
  const MeasuredPoint b = surfacePoint(*s.document.organ(cup), 8, {0.6, 0.3, 0.1});
  s.undo.perform(addMeasurement({a, b}));
  s.undo.perform(closeHoles(cup));
  ASSERT_TRUE(s.document.organ(cup)->closed());
  const MeasuredValues values =
      measure(s.document.measurements()[0], s.document.state(),
              [&](OrganId organ) -> const Points& { return s.document.organ(organ)->mesh->points; });
  EXPECT_LT((values.places[0] - a.rest).norm(), 1e-9);
  EXPECT_LT((values.places[1] - b.rest).norm(), 1e-9);
  const auto steps = s.undo.position();
  s.undo.perform(closeHoles(cup));
  EXPECT_EQ(s.undo.position(), steps) << "nothing was open any more";
}

TEST(MeasurementTable, HasOneRowAMeasurementWithItsValuesAndPlaces) {
  const TemporaryFolder folder;
  BoxSession s;
  s.undo.perform(renameOrgan(s.box().id, "Box, \"large\""));
  s.undo.perform(addMeasurement({nearestPoint(s.box(), {0, 30, 40}), fixedAt(0, 30, 50)}, "A;\"b\""));
  s.undo.perform(addMeasurement({fixedAt(1, 0, 0), fixedAt(0, 0, 0), fixedAt(0, 2, 0)}));
  Points grown = s.box().mesh->points;
  grown.col(2) *= 2;
  const auto rows = measurementRows(s.document.state(), [&](OrganId) -> const Points& { return grown; });
  writeMeasurementTable(folder / "m.csv", rows);
  EXPECT_EQ(contentsOf(folder / "m.csv"),
            "name,kind,value_at_rest,value_now,unit,organ_1,rest_x_1_mm,rest_y_1_mm,rest_z_1_mm,x_1_mm,"
            "y_1_mm,z_1_mm,organ_2,rest_x_2_mm,rest_y_2_mm,rest_z_2_mm,x_2_mm,y_2_mm,z_2_mm,organ_3,"
            "rest_x_3_mm,rest_y_3_mm,rest_z_3_mm,x_3_mm,y_3_mm,z_3_mm,"
            "standard_deviation,minimum,maximum,voxels,area_mm2,volume_ml\n"
            "\"A;\"\"b\"\"\",distance,10.000000,30.000000,mm,\"Box, \"\"large\"\"\",0.000000,30.000000,"
            "40.000000,0.000000,30.000000,80.000000,,0.000000,30.000000,50.000000,0.000000,30.000000,"
            "50.000000,,,,,,,,,,,,,\n"
            "Angle 1,angle,90.000000,90.000000,deg,,1.000000,0.000000,0.000000,1.000000,0.000000,0.000000,"
            ",0.000000,0.000000,0.000000,0.000000,0.000000,0.000000,,0.000000,2.000000,0.000000,0.000000,"
            "2.000000,0.000000,,,,,,\n");
}

class MeasurementsInSessions : public testing::Test {
protected:
  /// A session of one ball from a file with one distance on it.
  void saveBall() {
    s_.undo.perform(removeAllOrgans());
    s_.undo.perform(addOrgans({{readOrgan(tests::ballFile(folder_, "ball.vtp")), -1}}));
    const Organ& ball = *s_.document.organs()[0];
    s_.undo.perform(
        addMeasurement({surfacePoint(ball, 3, {0.5, 0.25, 0.25}), surfacePoint(ball, 100, {0, 1, 0})}));
    contents_.state = s_.document.state();
    tests::write(folder_ / "a.viscera", contents_);
  }

  /// The failure to open the session after `spoil` has changed its JSON.
  std::string failureOf(const std::function<void(nlohmann::ordered_json&)>& spoil) {
    auto root = nlohmann::ordered_json::parse(contentsOf(folder_ / "a.viscera"));
    spoil(root["measurements"]);
    std::ofstream(folder_ / "spoilt.viscera") << root.dump();
    try {
      tests::readBack(folder_ / "spoilt.viscera");
    } catch (const DataError& error) {
      return error.what();
    }
    return "was opened";
  }

  TemporaryFolder folder_;
  Session s_;
  SessionContents contents_;
};

TEST_F(MeasurementsInSessions, AreWrittenOnlyWhenThereAreSome) {
  saveBall();
  EXPECT_THAT(contentsOf(folder_ / "a.viscera"), HasSubstr("\"measurements\""));
  s_.undo.perform(removeAllMeasurements());
  contents_.state = s_.document.state();
  tests::write(folder_ / "a.viscera", contents_);
  EXPECT_THAT(contentsOf(folder_ / "a.viscera"), testing::Not(HasSubstr("\"measurements\"")));
}

TEST_F(MeasurementsInSessions, ThatAreDamagedAreRefusedWithThePlace) {
  saveBall();
  using Json = nlohmann::ordered_json;
  const auto point = [](Json& list) -> Json& { return list[0]["points"][0]; };
  EXPECT_THAT(failureOf([](Json& list) { list = 7; }), HasSubstr("measurements"));
  EXPECT_THAT(failureOf([](Json& list) { list[0]["id"] = 0; }), HasSubstr("measurements[0]"));
  EXPECT_THAT(failureOf([](Json& list) { list.push_back(list[0]); }), HasSubstr("comes twice"));
  EXPECT_THAT(failureOf([](Json& list) { list[0]["name"] = ""; }), HasSubstr("measurements[0]"));
  EXPECT_THAT(failureOf([](Json& list) { list[0]["points"].erase(1); }),
              HasSubstr("An angle has three points"));
  EXPECT_THAT(failureOf([&](Json& list) {
                point(list)["rest"] = {1, 2};
              }),
              HasSubstr("measurements[0].points[0].rest"));
  EXPECT_THAT(failureOf([&](Json& list) { point(list)["organ"] = 4711; }),
              HasSubstr("measurements[0].points[0].organ"));
  EXPECT_THAT(failureOf([&](Json& list) { point(list)["triangle"] = 128; }), HasSubstr("no such triangle"));
  EXPECT_THAT(failureOf([&](Json& list) { point(list)["triangle"] = 1e15; }),
              HasSubstr("measurements[0].points[0].triangle"));
  EXPECT_THAT(failureOf([&](Json& list) { point(list)["triangle"] = -1; }),
              HasSubstr("measurements[0].points[0].triangle"));
  EXPECT_THAT(failureOf([&](Json& list) {
                point(list)["weights"] = {0.5, 0.5, 0.5};
              }),
              HasSubstr("Barycentric weights must be at least 0 and sum to 1"));
  EXPECT_THAT(failureOf([&](Json& list) { point(list).erase("weights"); }), HasSubstr("weights"));
  EXPECT_EQ(failureOf([&](Json& list) { point(list)["triangle"] = 127; }), "was opened");
}

TEST_F(MeasurementsInSessions, GoToTheNearestPlacesOfASurfaceThatHasChangedAndItIsSaid) {
  saveBall();
  medical_io::writeSurface(folder_ / "ball.vtp", viscera::tests::sphere(1, 33));
  const OpenedSession opened = tests::readBack(folder_ / "a.viscera");
  ASSERT_EQ(opened.contents.state.measurements->size(), 1u);
  const Measurement& measurement = opened.contents.state.measurements->at(0);
  for (std::size_t i = 0; i < 2; ++i) {
    const MeasuredPoint& point = measurement.points[i];
    EXPECT_LT(point.triangle, 32);
    EXPECT_LT((point.rest - contents_.state.measurements->at(0).points[i].rest).norm(), 4);
  }
  EXPECT_THAT(inEnglish(opened.warnings), testing::Contains(HasSubstr("nearest places")));
}

TEST_F(MeasurementsInSessions, OfAMissingOrganStayAndComeBackWithIt) {
  saveBall();
  std::filesystem::create_directory(folder_ / "away");
  std::filesystem::rename(folder_ / "ball.vtp", folder_ / "away" / "ball.vtp");
  Document document;
  UndoStack undo(document);
  OpenedSession opened = tests::readBack(folder_ / "a.viscera");
  undo.reset(opened.contents.state);
  ASSERT_EQ(document.measurements().size(), 1u);
  const MeasuredValues values =
      measure(document.measurements()[0], document.state(),
              [](OrganId) -> const Points& { throw std::logic_error("there is no organ to ask for"); });
  EXPECT_EQ(values.now, values.rest);
  // What is new must not be taken for the missing organ.
  undo.perform(addOrgans({tests::ball("Other")}));
  EXPECT_NE(document.organs()[0]->id, document.measurements()[0].points[0].organ);
  opened.contents.state = document.state();
  tests::write(folder_ / "b.viscera", opened.contents);
  std::filesystem::rename(folder_ / "away" / "ball.vtp", folder_ / "ball.vtp");
  EXPECT_EQ(*tests::readBack(folder_ / "b.viscera").contents.state.measurements,
            *contents_.state.measurements);
}

TEST_F(MeasurementsInSessions, OfAnOrganThatIsNowhereAnyMoreAreWrittenAsPlacesThatStay) {
  saveBall();
  contents_.state.organs = std::make_shared<const OrganList>();
  tests::write(folder_ / "a.viscera", contents_);
  const OpenedSession opened = tests::readBack(folder_ / "a.viscera");
  const Measurement& measurement = opened.contents.state.measurements->at(0);
  EXPECT_FALSE(measurement.points[0].organ);
  EXPECT_EQ(measurement.points[0].rest, contents_.state.measurements->at(0).points[0].rest);
}

/// A session with a scan whose value is 100 in a ball of 20 mm, -50 around it.
struct ScannedSession : BoxSession {
  ScannedSession() {
    undo.perform(
        openScan(scanItem(viscera::tests::phantomScan({41, 41, 41}, Vec3(2, 2, 2), Vec3(-40, -40, -40),
                                                      viscera::tests::ballValue(Vec3::Zero(), 20)),
                          {})));
  }
  MeasuredValues valuesOf(const Measurement& measurement) {
    return measure(
        measurement, document.state(),
        [&](OrganId organ) -> const Points& { return document.organ(organ)->mesh->points; }, &memory);
  }
  MeasuringMemory memory;
};

TEST(MeasuredRegion, HasTheScansValuesAreaOrVolumeAndANameOfItsKind) {
  ScannedSession s;
  s.undo.perform(addMeasurement(
      Measurement{{}, {}, {fixedAt(-8, -6, 4), fixedAt(8, 6, 4)}, MeasurementKind::rectangle, 2}));
  s.undo.perform(
      addMeasurement(Measurement{{}, {}, {fixedAt(0, 0, 0), fixedAt(0, 9, 12)}, MeasurementKind::sphere}));
  const Measurement rectangle = s.document.measurements()[0], sphere = s.document.measurements()[1];
  EXPECT_EQ(rectangle.name, "Rectangle 1");
  EXPECT_EQ(sphere.name, "Sphere 1");
  EXPECT_EQ(s.undo.undoName().english(), "Measure sphere");
  const MeasuredValues flat = s.valuesOf(rectangle), round = s.valuesOf(sphere);
  ASSERT_TRUE(flat.region && round.region);
  EXPECT_EQ(flat.region->count, 9u * 7u) << "voxels of 2 mm, borders and all";
  EXPECT_EQ(flat.now, 100);
  EXPECT_EQ(flat.region->deviation, 0);
  EXPECT_EQ(round.now, 100) << "a radius of 15 mm lies within the ball";
  EXPECT_NEAR(std::get<medical_io::SphereRegion>(*regionOf(sphere)).volumeMl(), 4.0 / 3 * M_PI * 3.375, 1e-9);
  EXPECT_EQ(std::get<medical_io::RectangleRegion>(*regionOf(rectangle)).areaMm2(), 16 * 12);
  EXPECT_EQ(unitOf(sphere, s.document.state()), "HU");
  EXPECT_EQ(unitOf(s.document.measurements()[0], DocumentState()), "");
}

TEST(Measured, PlacesOfAWarpedScanGoWithItsTissueAndOrgansAsTheyWere) {
  ScannedSession s;
  // Twice as long along x, and 5 mm towards the head.
  const TissueMotion tissue = [](const Vec3& rest) { return Vec3(2 * rest.x(), rest.y(), rest.z() + 5); };
  const MeasuredPoint corner = s.vertex(0, 0);
  s.undo.perform(addMeasurement({fixedAt(-3, 0, 0), fixedAt(3, 0, 8)}));
  s.undo.perform(addMeasurement({fixedAt(1, 0, 0), fixedAt(0, 0, 0), fixedAt(1, 2, 0)}));
  s.undo.perform(addMeasurement({corner, fixedAt(4, 1, 1)}));
  s.undo.perform(
      addMeasurement(Measurement{{}, {}, {fixedAt(4, 0, 0), fixedAt(4, 9, 12)}, MeasurementKind::sphere}));
  const auto valuesOf = [&](std::size_t i) {
    return measure(
        s.document.measurements()[i], s.document.state(),
        [&](OrganId organ) -> const Points& { return s.document.organ(organ)->mesh->points; }, nullptr,
        tissue);
  };
  EXPECT_DOUBLE_EQ(valuesOf(0).rest, 10);
  EXPECT_DOUBLE_EQ(valuesOf(0).now, std::hypot(12, 8));
  EXPECT_NEAR(valuesOf(1).rest, std::atan2(2, 1) * 180 / M_PI, 1e-12);
  EXPECT_NEAR(valuesOf(1).now, 45, 1e-12) << "a leg of 2 mm along x now";
  EXPECT_EQ(valuesOf(2).places[0], corner.rest) << "a point of an organ follows that";
  EXPECT_EQ(valuesOf(2).places[1], tissue(Vec3(4, 1, 1)));
  const MeasuredValues sphere = valuesOf(3);
  EXPECT_EQ(sphere.places[0], tissue(Vec3(4, 0, 0)));
  EXPECT_DOUBLE_EQ((sphere.places[1] - sphere.places[0]).norm(), 15) << "it keeps its size";
  EXPECT_EQ(sphere.now, s.valuesOf(s.document.measurements()[3]).now) << "and the scan's values";
  const auto rows = measurementRows(
      s.document.state(),
      [&](OrganId organ) -> const Points& { return s.document.organ(organ)->mesh->points; }, tissue);
  EXPECT_DOUBLE_EQ(rows.at(0).values.now, std::hypot(12, 8));
}

TEST(MeasuredRegion, IsReadAgainWhenItOrTheScanIsAnotherAndHasNoValueWithoutScan) {
  ScannedSession s;
  s.undo.perform(
      addMeasurement(Measurement{{}, "Spot", {fixedAt(0, 0, 0), fixedAt(0, 0, 6)}, MeasurementKind::sphere}));
  EXPECT_EQ(s.valuesOf(s.only()).now, 100);
  s.undo.perform(moveMeasuredPoint(s.only().id, 0, fixedAt(30, 0, 0)));
  EXPECT_EQ(s.only().points[1].rest, Vec3(30, 0, 6)) << "its middle takes it along";
  EXPECT_EQ(s.valuesOf(s.only()).now, -50);
  s.undo.perform(
      openScan(scanItem(viscera::tests::phantomScan({41, 41, 41}, Vec3(2, 2, 2), Vec3(-40, -40, -40),
                                                    [](const Vec3&) { return 7.0; }),
                        {})));
  EXPECT_EQ(s.valuesOf(s.only()).now, 7);
  s.undo.perform(closeScan());
  EXPECT_TRUE(std::isnan(s.valuesOf(s.only()).now));
  s.undo.undo();
  EXPECT_EQ(s.valuesOf(s.only()).now, 7);
}

TEST(MeasuredRegion, StaysFlatAndOffOrgansAndOutlivesThem) {
  ScannedSession s;
  s.undo.perform(
      addMeasurement(Measurement{{}, {}, {s.vertex(0, 0), fixedAt(8, 6, 4)}, MeasurementKind::rectangle, 1}));
  EXPECT_FALSE(s.only().points[0].organ);
  EXPECT_EQ(s.only().points[1].rest.y(), s.only().points[0].rest.y());
  s.undo.perform(moveMeasuredPoint(s.only().id, 1, fixedAt(3, 11, 5)));
  EXPECT_EQ(s.only().points[0].rest.y(), 11) << "both corners lie in one slice";
  s.undo.perform(addMeasurement({s.vertex(0, 0), fixedAt(1, 2, 3)}));
  s.undo.perform(removeAllOrgans());
  ASSERT_EQ(s.document.measurements().size(), 1u);
  EXPECT_EQ(s.only().kind, MeasurementKind::rectangle);
  EXPECT_THROW(
      s.undo.perform(addMeasurement(Measurement{{}, {}, {fixedAt(0, 0, 0)}, MeasurementKind::sphere})),
      UsageError);
  EXPECT_THROW(s.undo.perform(addMeasurement(
                   Measurement{{}, {}, {fixedAt(0, 0, 0), fixedAt(1, 1, 1)}, MeasurementKind::rectangle, 3})),
               UsageError);
}

TEST(MeasuredRegion, IsARowOfTheTableWithItsSpread) {
  ScannedSession s;
  s.undo.perform(addMeasurement({fixedAt(0, 0, 0), fixedAt(0, 0, 6)}));
  s.undo.perform(addMeasurement(
      Measurement{{}, {}, {fixedAt(-8, -6, 4), fixedAt(8, 6, 4)}, MeasurementKind::rectangle, 2}));
  s.undo.perform(
      addMeasurement(Measurement{{}, {}, {fixedAt(500, 0, 0), fixedAt(500, 0, 6)}, MeasurementKind::sphere}));
  TemporaryFolder folder;
  writeMeasurementTable(folder / "m.csv",
                        measurementRows(s.document.state(), [&](OrganId organ) -> const Points& {
                          return s.document.organ(organ)->mesh->points;
                        }));
  std::ifstream file(folder / "m.csv");
  std::string header, distance, rectangle, beside;
  std::getline(file, header);
  std::getline(file, distance);
  std::getline(file, rectangle);
  std::getline(file, beside);
  EXPECT_TRUE(header.ends_with(",standard_deviation,minimum,maximum,voxels,area_mm2,volume_ml")) << header;
  const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  for (const std::string* line : {&distance, &rectangle, &beside})
    EXPECT_EQ(commas(*line), commas(header)) << *line;
  EXPECT_TRUE(distance.ends_with(",,,,,,")) << distance;
  EXPECT_TRUE(rectangle.starts_with("Rectangle 1,rectangle,100.000000,100.000000,HU,")) << rectangle;
  EXPECT_TRUE(rectangle.ends_with(",0.000000,100.000000,100.000000,63,192.000000,")) << rectangle;
  EXPECT_TRUE(beside.starts_with("Sphere 1,sphere,,,HU,")) << beside;
  EXPECT_THAT(beside, HasSubstr(",,,,0,,0.90"));
}

TEST(MeasuredRegion, ComesBackFromASessionAndDamagedOnesAreRefused) {
  ScannedSession s;
  s.undo.perform(addMeasurement(
      Measurement{{}, {}, {fixedAt(-8, 3, 4), fixedAt(8, 3, 9)}, MeasurementKind::rectangle, 1}));
  s.undo.perform(
      addMeasurement(Measurement{{}, {}, {fixedAt(0, 0, 0), fixedAt(0, 9, 12)}, MeasurementKind::sphere}));
  TemporaryFolder folder;
  SessionContents contents;
  contents.state.measurements = s.document.state().measurements;
  tests::write(folder / "a.viscera", contents);
  EXPECT_EQ(*tests::readBack(folder / "a.viscera").contents.state.measurements, *contents.state.measurements);
  EXPECT_THAT(contentsOf(folder / "a.viscera"), HasSubstr("\"slice\": \"coronal\""));
  const auto failureOf = [&](const std::string& from, const std::string& to) -> std::string {
    std::string text = contentsOf(folder / "a.viscera");
    text.replace(text.find(from), from.size(), to);
    try {
      tests::readBack(folder.put("b.viscera", text));
    } catch (const DataError& error) {
      return error.what();
    }
    return "was opened";
  };
  EXPECT_THAT(failureOf("\"coronal\"", "\"sloping\""), HasSubstr("measurements[0].slice"));
  EXPECT_THAT(failureOf("\"sphere\"", "\"cube\""), HasSubstr("There is no kind \"cube\""));
  EXPECT_THAT(failureOf("\"sphere\"", "\"angle\""), HasSubstr("An angle has three points"));
}

} // namespace
} // namespace viscera::document
