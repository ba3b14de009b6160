#include "viscera/presentation/slice_presenter.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "phantom_scan.h"
#include "session_fixture.h"
#include "viscera/core/error.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/document/scan_item.h"
#include "viscera/presentation/presenter.h"

namespace viscera::presentation {
namespace {

/// A ball of 30 mm with ten handles, and a scan in which it is bright.
struct ScannedBall : tests::BoundSession {
  ViewState view;
  SlicePresenter slices;

  ScannedBall() {
    undo.perform(document::openScan(
        document::scanItem(tests::phantomScan({60, 60, 60}, Vec3(2, 2, 2), Vec3(-59, -59, -59),
                                              tests::ballValue(Vec3::Zero(), 30)),
                           {})));
    view.scan.focus = Vec3(0, 0, 5);
    update();
  }
  void update() {
    slices.update({document.state(), live, view}, {{0, 200, 160}, {1, 200, 160}, {2, 120, 160}});
  }
  std::uint8_t greyAt(int direction, const Vec3& place) const {
    const Eigen::Vector2d pixel = slices.frame(direction).pixelOf(place);
    const scene::SlicePicture& picture = slices.picture(direction);
    return picture.grey[std::size_t(std::lround(pixel.y()) * picture.width + std::lround(pixel.x()))];
  }
};

TEST(SlicePresenter, ShowsScanContourAndCrosshairInOnePlace) {
  ScannedBall ball;
  for (int direction = 0; direction < 3; ++direction) {
    const scene::SlicePicture& picture = ball.slices.picture(direction);
    EXPECT_GT(ball.greyAt(direction, Vec3(0, 0, 5)), ball.greyAt(direction, Vec3(40, 40, 40)));
    ASSERT_EQ(picture.lines.size(), 1u);
    EXPECT_TRUE(picture.lines.front().closed && !picture.lines.front().thin);
    // The contour is where grey turns: in it is bright, around it dark.
    const medical_io::SliceFrame& frame = ball.slices.frame(direction);
    const Vec3 middle = direction == 0 ? Vec3(0, 0, 5) : Vec3::Zero();
    for (const Eigen::Vector2d& point : picture.lines.front().points) {
      const Vec3 place = frame.at(point.x(), point.y());
      EXPECT_GT(ball.greyAt(direction, middle + 0.85 * (place - middle)), 150);
      EXPECT_LT(ball.greyAt(direction, middle + 1.15 * (place - middle)), 110);
    }
    ASSERT_TRUE(picture.cross);
    EXPECT_LT((frame.at(picture.cross->x(), picture.cross->y()) - Vec3(0, 0, 5)).norm(), 1e-9);
  }
  EXPECT_EQ(ball.slices.picture(0).edges[0], "R");
  EXPECT_EQ(ball.slices.picture(0).title, "Axial  S 5.0 mm");
  EXPECT_EQ(ball.slices.picture(0).note, "L 40  W 400");
}

TEST(SlicePresenter, KeepsTheRestContourThinBesideThePosedOne) {
  ScannedBall ball;
  EXPECT_EQ(ball.slices.picture(1).lines.size(), 1u);
  ball.undo.perform(document::moveHandles({ball.handle(8)}, tests::row(0, 0, 60)));
  ball.update();
  const auto& lines = ball.slices.picture(1).lines;
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_TRUE(lines[0].thin && !lines[1].thin);
  const auto top = [](const scene::SliceLine& line) {
    double highest = -1e9;
    for (const auto& point : line.points)
      highest = std::max(highest, point.y());
    return highest;
  };
  EXPECT_GT(top(lines[1]), top(lines[0]) + 1);
  ball.view.scan.rest = false;
  ball.update();
  EXPECT_EQ(ball.slices.picture(1).lines.size(), 1u);
  ball.view.scan.contours = false;
  ball.update();
  EXPECT_TRUE(ball.slices.picture(1).lines.empty());
  EXPECT_TRUE(ball.slices.contours(1).empty());
}

TEST(SlicePresenter, CutsTheSameAfterStepsAsAtOnce) {
  ScannedBall ball;
  ball.undo.perform(document::addOrgans({tests::ball("Other", 12, 3, Vec3(25, 10, 3))}));
  for (int step = 0; step < 4; ++step) {
    ball.view.scan.focus = Vec3(2 * step, step, 5 - step);
    if (step == 2)
      ball.undo.perform(document::moveHandles({ball.handle(8)}, tests::row(0, 10, 55)));
    ball.update();
  }
  SlicePresenter fresh;
  fresh.update({ball.document.state(), ball.live, ball.view}, {{0, 200, 160}, {1, 200, 160}, {2, 120, 160}});
  for (int direction = 0; direction < 3; ++direction) {
    const auto &a = ball.slices.picture(direction), &b = fresh.picture(direction);
    ASSERT_EQ(a.lines.size(), b.lines.size());
    for (std::size_t i = 0; i < a.lines.size(); ++i)
      EXPECT_EQ(a.lines[i].points, b.lines[i].points);
    EXPECT_EQ(a.grey, b.grey);
  }
  EXPECT_EQ(fresh.contours(0).size(), 2u);
}

TEST(SlicePresenter, ReadsValuePlaceAndInnermostOrgan) {
  ScannedBall ball;
  ball.undo.perform(document::addOrgans({tests::ball("Inner", 8, 3, Vec3(0, 0, 5))}));
  ball.update();
  const auto read = [&](const Vec3& place) {
    return ball.slices.read(0, ball.slices.frame(0).pixelOf(place));
  };
  EXPECT_EQ(read(Vec3(2, 1, 5)).organ, ball.organ(1));
  EXPECT_EQ(read(Vec3(20, 1, 5)).organ, ball.organ(0));
  EXPECT_FALSE(read(Vec3(40, 1, 5)).organ);
  EXPECT_NEAR(read(Vec3(20, 1, 5)).value.value(), 100, 1e-3);
  EXPECT_NEAR(read(Vec3(50, 1, 5)).value.value(), -50, 1e-3);
  EXPECT_LT((read(Vec3(20, 1, 5)).position - Vec3(20, 1, 5)).norm(), 1e-9);
  EXPECT_FALSE(ball.slices.read(0, {-5, 3}).value);
}

/// Rest is that much farther on than the pose; `folded` says where the tissue is folded.
Warping shifted(const Vec3& by, std::uint64_t revision, bool folded = false) {
  return {[=](const deformation::SamplePlane& plane, deformation::RestPoints& rest) {
            rest.points.resize(plane.columns * plane.rows, 3);
            rest.states.assign(std::size_t(rest.points.rows()), deformation::RestState::moved);
            for (Eigen::Index i = 0; i < rest.points.rows(); ++i) {
              const Vec3 place = plane.at(i % plane.columns, i / plane.columns);
              rest.points.row(i) = (place + by).transpose();
              if (folded && place.x() > 0)
                rest.states[std::size_t(i)] = deformation::RestState::folded;
            }
          },
          revision};
}

TEST(SlicePresenter, WritesDecimalsWithTheMarkOfTheLanguage) {
  ScannedBall ball;
  ball.slices.setDecimalMark(',');
  ball.view.scan.focus = Vec3(0, 0, 12.5);
  ball.view.scan.slabMm = 2.5;
  ball.update();
  EXPECT_EQ(ball.slices.picture(0).title, "Axial  S 12,5 mm");
  EXPECT_EQ(ball.slices.picture(0).note, "L 40  W 400  Mean of 2,5 mm");
  EXPECT_EQ(formatSlicePosition(2, -7.25, ','), "I 7,2 mm");
  EXPECT_EQ(formatPlace({-110.08, -3, 5}), "R 110.1, A 3.0, S 5.0");
  EXPECT_EQ(formatPlace({110.08, 3, -5}, ','), "L 110,1; P 3,0; I 5,0");
  EXPECT_EQ(formatPlace({-1e-9, 1e-9, -0.01}), "L 0.0, P 0.0, S 0.0") << "noise has no side";
  EXPECT_EQ(formatMeasured(document::MeasurementKind::distance, 83.4, {}, ','), "83,4 mm");
  EXPECT_EQ(formatMeasured(document::MeasurementKind::sphere, 41.3, "HU"), "41.3 HU");
}

TEST(SlicePresenter, WarpsTheScanByTheRestPositionsItIsGiven) {
  ScannedBall ball;
  ball.view.scan.warped = true;
  Warping warping = shifted(Vec3(-20, 0, 0), 1);
  const SliceScene scene{ball.document.state(), ball.live, ball.view, &warping};
  ball.slices.update(scene, {{0, 200, 160}, {1, 200, 160}, {2, 120, 160}});
  EXPECT_GT(ball.greyAt(0, Vec3(45, 0, 5)), 150) << "what was at 25 mm is 20 mm farther on";
  EXPECT_LT(ball.greyAt(0, Vec3(-20, 0, 5)), 110);
  EXPECT_NE(ball.slices.picture(0).note.find("Warped"), std::string::npos);
  warping = shifted(Vec3::Zero(), 2);
  ball.slices.update(scene, {{0, 200, 160}});
  EXPECT_GT(ball.greyAt(0, Vec3(-20, 0, 5)), 150);
}

TEST(SlicePresenter, HatchesWhereThePoseFoldsTheTissue) {
  ScannedBall ball;
  const auto plain = ball.slices.picture(0).grey;
  ball.view.scan.warped = true;
  const Warping warping = shifted(Vec3::Zero(), 1, true);
  ball.slices.update({ball.document.state(), ball.live, ball.view, &warping}, {{0, 200, 160}});
  const scene::SlicePicture& picture = ball.slices.picture(0);
  std::size_t white = 0, black = 0, pixels = 0;
  for (std::size_t i = 0; i < picture.grey.size(); ++i) {
    const Vec3 place = ball.slices.frame(0).at(double(i % 200), double(i / 200));
    if (place.x() <= 0) {
      ASSERT_EQ(picture.grey[i], plain[i]) << "only what is folded";
      continue;
    }
    ++pixels;
    white += picture.grey[i] == 255 && plain[i] != 255 ? 1 : 0;
    black += picture.grey[i] == 0 && plain[i] != 0 ? 1 : 0;
  }
  EXPECT_GT(white, pixels / 8) << "seen on dark tissue";
  EXPECT_GT(black, pixels / 16) << "and on bright tissue";
  EXPECT_LT(white + black, pixels / 2) << "with the tissue between";
  EXPECT_NE(picture.note.find("folded"), std::string::npos);
  EXPECT_TRUE(ball.slices.read(0, ball.slices.frame(0).pixelOf(Vec3(10, 0, 5))).folded);
  EXPECT_FALSE(ball.slices.read(0, ball.slices.frame(0).pixelOf(Vec3(-10, 0, 5))).folded);
}

TEST(SlicePresenter, HatchesNoLineOfSinglePixels) {
  ScannedBall ball;
  const auto plain = ball.slices.picture(0).grey;
  ball.view.scan.warped = true;
  Warping warping = shifted(Vec3::Zero(), 1);
  warping.rest = [whole = warping.rest](const deformation::SamplePlane& plane,
                                        deformation::RestPoints& rest) {
    whole(plane, rest);
    for (Eigen::Index column = 0; column < plane.columns; ++column)
      rest.states[std::size_t(80 * plane.columns + column)] = deformation::RestState::folded;
  };
  ball.slices.update({ball.document.state(), ball.live, ball.view, &warping}, {{0, 200, 160}});
  EXPECT_EQ(ball.slices.picture(0).grey, plain);
  EXPECT_EQ(ball.slices.picture(0).note.find("folded"), std::string::npos);
  EXPECT_TRUE(ball.slices.read(0, Eigen::Vector2d(60, 80)).folded) << "what is read there is an estimate";
}

TEST(SlicePresenter, ShowsThePhaseOfTheInstantAndSaysWhatIsMissing) {
  ScannedBall ball;
  const auto phase = [](double radius, int number) {
    medical_io::Scan scan = tests::phantomScan({60, 60, 60}, Vec3(2, 2, 2), Vec3(-59, -59, -59),
                                               tests::ballValue(Vec3::Zero(), radius));
    scan.phase = number;
    return std::make_shared<const medical_io::Scan>(std::move(scan));
  };
  const std::vector<std::shared_ptr<const medical_io::Scan>> phases = {phase(30, 0), phase(15, 1)};
  medical_io::ScanOverTime time;
  time.fractions = {0, 1.0 / 3};
  time.missing = {2.0 / 3};
  time.numbers = {0, 1};
  time.volume = [phases](std::size_t number) { return phases[number]; };
  document::ScanItem item{"beat", phases[0], {}, {}, 0};
  item.time = std::make_shared<const medical_io::ScanOverTime>(std::move(time));
  ball.undo.perform(document::openScan(item));
  const auto show = [&](double fraction) {
    ball.view.scan.cine.fraction = fraction;
    ball.update();
    return ball.slices.read(0, ball.slices.frame(0).pixelOf(Vec3(20, 0, 5))).value;
  };
  const auto large = show(0.95), small = show(0.3);
  ASSERT_TRUE(large && small);
  EXPECT_GT(*large, *small + 20) << "within the larger ball, beside the smaller one";
  EXPECT_TRUE(ball.slices.picture(0).title.ends_with("phase 2 of 3")) << ball.slices.picture(0).title;
  EXPECT_FALSE(show(0.7));
  EXPECT_TRUE(ball.slices.picture(0).grey.empty());
  EXPECT_EQ(ball.slices.picture(0).note, "The picture of this phase is missing");
  EXPECT_EQ(show(0), large);
}

TEST(SlicePresenter, DrawsHandlesNearTheSliceAndFindsThemThere) {
  ScannedBall ball;
  EXPECT_TRUE(ball.slices.picture(0).marks.empty()) << "they are not shown";
  ball.view.shown.handles = ball.view.shown.movable = true;
  ball.view.scan.focus = Vec3(0, 0, 38); // The handle at (0, 0, 40) is 2 mm away.
  ball.update();
  ASSERT_EQ(ball.slices.picture(0).marks.size(), 1u);
  const Eigen::Vector2d pixel = ball.slices.frame(0).pixelOf(Vec3(0, 0, 40));
  EXPECT_LT((ball.slices.picture(0).marks[0].place - pixel).norm(), 1e-9);
  EXPECT_EQ(ball.slices.handleAt(0, pixel + Eigen::Vector2d(3, -2), 8), 8);
  EXPECT_EQ(ball.slices.handleAt(0, pixel + Eigen::Vector2d(30, 0), 8), -1);
  ASSERT_EQ(ball.slices.picture(1).marks.size(), 2u) << "also (40, 3, -1), 3 mm in front";
  ball.view.scan.focus = Vec3(0, 0, 30);
  ball.update();
  EXPECT_TRUE(ball.slices.picture(0).marks.empty());
  ball.view.scan.slabMm = 20;
  ball.update();
  EXPECT_EQ(ball.slices.picture(0).marks.size(), 1u) << "within the thickness of the slice";
  ball.undo.perform(document::moveHandles({ball.handle(8)}, tests::row(0, 0, 60)));
  ball.update();
  EXPECT_TRUE(ball.slices.picture(0).marks.empty()) << "it is where it is posed";
  ball.undo.undo();
  ball.view.shown.movable = false;
  ball.update();
  EXPECT_EQ(ball.slices.picture(0).marks.size(), 1u);
  EXPECT_EQ(ball.slices.handleAt(0, ball.slices.frame(0).pixelOf(Vec3(0, 0, 40)), 8), -1);
}

TEST(SlicePresenter, DrawsWhatIsMeasuredOnTheSlicesThatItLiesIn) {
  ScannedBall ball;
  const auto at = [](double x, double y, double z) {
    document::MeasuredPoint point;
    point.rest = Vec3(x, y, z);
    return point;
  };
  using Kind = document::MeasurementKind;
  ball.undo.perform(document::addMeasurement({at(-10, 0, 5), at(10, 0, 5)}));
  ball.undo.perform(document::addMeasurement(
      document::Measurement{{}, {}, {at(-8, -6, 5), at(8, 6, 5)}, Kind::rectangle, 2}));
  ball.undo.perform(
      document::addMeasurement(document::Measurement{{}, {}, {at(0, 0, 0), at(0, 0, 13)}, Kind::sphere}));
  ball.update();
  const scene::SlicePicture& axial = ball.slices.picture(0);
  ASSERT_EQ(axial.texts.size(), 3u);
  EXPECT_EQ(axial.texts[0].words, "Distance 1: 20.0 mm");
  EXPECT_EQ(axial.texts[1].words.substr(0, 21), "Rectangle 1: 100.0 HU");
  EXPECT_NE(axial.texts[1].words.find("192 mm\u00b2"), std::string::npos) << axial.texts[1].words;
  ASSERT_EQ(axial.lines.size(), 4u) << "the organ's contour, and one each";
  // The sphere's circle in this slice: 13 mm around a middle that is 5 mm away.
  const scene::SliceLine& circle = axial.lines[3];
  EXPECT_TRUE(circle.closed);
  for (const Eigen::Vector2d& point : circle.points)
    EXPECT_NEAR((ball.slices.frame(0).at(point.x(), point.y()) - Vec3(0, 0, 5)).norm(), 12, 1e-9);
  const auto mark = ball.slices.measuredAt(0, ball.slices.frame(0).pixelOf(Vec3(8, 6, 5)), 6);
  ASSERT_TRUE(mark);
  EXPECT_EQ(*mark, (scene::MeasurementGlyphs::Mark{1, 1}));
  // From the side the distance lies in the slice, the rectangle is a line that is not drawn.
  EXPECT_EQ(ball.slices.picture(1).texts.size(), 2u);
  ball.view.scan.focus = Vec3(0, 0, 20);
  ball.update();
  EXPECT_TRUE(ball.slices.picture(0).texts.empty());
  ball.view.scan.focus = Vec3(0, 0, 5);
  ball.view.measurements = false;
  ball.update();
  EXPECT_TRUE(ball.slices.picture(0).texts.empty());
}

TEST(SlicePresenter, DrawsMeasuredPlacesWhereTheWarpedScanHasThem) {
  ScannedBall ball;
  document::MeasuredPoint from, to;
  from.rest = Vec3(-10, 0, 5);
  to.rest = Vec3(10, 0, 5);
  ball.undo.perform(document::addMeasurement({from, to}));
  const auto stretched = [](const Vec3& rest) { return Vec3(1.5 * rest.x(), rest.y(), rest.z()); };
  Warping warping = shifted(Vec3::Zero(), 1);
  warping.posed = stretched;
  const SliceScene scene{ball.document.state(), ball.live, ball.view, &warping};
  const auto words = [&] {
    ball.slices.update(scene, {{0, 200, 160}});
    return ball.slices.picture(0).texts.at(0).words;
  };
  EXPECT_EQ(words(), "Distance 1: 20.0 mm") << "the scan is as it was recorded";
  ball.view.scan.warped = true;
  EXPECT_EQ(words(), "Distance 1: 30.0 mm");
  const medical_io::SliceFrame& frame = ball.slices.frame(0);
  EXPECT_EQ(ball.slices.measuredAt(0, frame.pixelOf(stretched(to.rest)), 2),
            (scene::MeasurementGlyphs::Mark{0, 1}));
  EXPECT_FALSE(ball.slices.measuredAt(0, frame.pixelOf(to.rest), 2));
}

TEST(SlicePresenter, BreaksTheLineBehindValuesAlsoWhereSemicolonsDivideThem) {
  ScannedBall ball;
  document::MeasuredPoint from, to;
  from.rest = Vec3(-8, -6, 5);
  to.rest = Vec3(8, 6, 5);
  ball.undo.perform(document::addMeasurement(
      document::Measurement{{}, {}, {from, to}, document::MeasurementKind::rectangle, 2}));
  SlicePresenter german({}, [](const char* text) {
    std::string said = text;
    std::replace(said.begin(), said.end(), ',', ';');
    return said;
  });
  german.setDecimalMark(',');
  german.update({ball.document.state(), ball.live, ball.view}, {{0, 200, 160}});
  ASSERT_EQ(german.picture(0).texts.size(), 1u);
  const std::string& words = german.picture(0).texts[0].words;
  EXPECT_EQ(words.substr(0, words.rfind("; ")),
            "Rectangle 1: 100,0 HU\n\u00b1 0,0; 100 to 100 HU\n192 mm\u00b2");
}

TEST(ScanLook, ComesBackFromASessionAndOldSessionsHaveNone) {
  ViewState view;
  view.scan.layout = "four";
  view.scan.focus = Vec3(1, -2, 3.5);
  view.scan.level = -600;
  view.scan.width = 1500;
  view.scan.slabMm = 5;
  view.scan.maximum = view.scan.standing = true;
  view.scan.rest = false;
  view.scan.framings[2] = {3, -4, 2.5};
  EXPECT_EQ(viewFromJson(toJson(view)).scan, view.scan);
  EXPECT_EQ(viewFromJson({{"format", 2}, {"mode", "explore"}}).scan, ScanLook());
  // What nothing can be drawn with is as at first.
  const ViewState odd = viewFromJson(nlohmann::ordered_json::parse(
      R"({"format": 2, "scan": {"width": -1, "level": 3, "slabMm": 1e9, "framings": [{"zoom": 0}]}})"));
  EXPECT_EQ(odd.scan.width, 0);
  EXPECT_EQ(odd.scan.slabMm, 0);
  EXPECT_EQ(odd.scan.framings[0].zoom, 1);
}

} // namespace
} // namespace viscera::presentation
