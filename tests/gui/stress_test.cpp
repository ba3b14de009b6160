#include "stress_fixture.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkActor2DCollection.h>
#include <vtkMapper.h>
#include <vtkRenderer.h>
#include <vtkScalarsToColors.h>
#include <vtkTextActor.h>

#include "temporary_folder.h"
#include "viscera/live/stress_mark_files.h"
#include "viscera/live/stress_quantity.h"
#include "viscera/presentation/slice_presenter.h"
#include "viscera/presentation/stress_values.h"
#include "window/compare/comparison.h"
#include "window/compare/side_header.h"
#include "window/play/play_mode.h"
#include "window/session/session_files.h"
#include "window/stress/histogram.h"
#include "window/stress/profile_chart.h"
#include "window/stress/stress_export.h"
#include "window/stress/stress_mode.h"
#include "window/style/language.h"
#include "window/widgets/elided_label.h"
#include "window/widgets/value_slider.h"

namespace viscera::tests {
namespace {

TEST(SteppedRange, GoesInRoundStepsAndDoesNotCreep) {
  using presentation::steppedRange;
  using Quantity = live::StressQuantity;
  const scene::ValueRange first = steppedRange(Quantity::rotationalStress, {0, 11}, {0, 0});
  EXPECT_EQ(first.low, 0);
  EXPECT_GE(first.high, 11);
  for (const double more : {10.0, 9.0, 8.0, 11.5}) {
    const scene::ValueRange next = steppedRange(Quantity::rotationalStress, {0, more}, first);
    EXPECT_EQ(next.high, first.high) << more;
  }
  EXPECT_GT(steppedRange(Quantity::rotationalStress, {0, 50}, first).high, first.high);
  EXPECT_LT(steppedRange(Quantity::rotationalStress, {0, 1}, first).high, first.high);
  const scene::ValueRange ratio = steppedRange(Quantity::volumeRatio, {0.8, 1.1}, {0, 0});
  EXPECT_NEAR(ratio.low + ratio.high, 2, 1e-12);
  EXPECT_LE(ratio.low, 0.8);
  const scene::ValueRange again = steppedRange(Quantity::volumeRatio, {0.82, 1.1}, ratio);
  EXPECT_EQ(again.low, ratio.low);
  EXPECT_EQ(again.high, ratio.high);
}

TEST_F(StressModeTest, KeyFourShowsTheMapAndLeavingPutsTheLooksBack) {
  enter();
  EXPECT_TRUE(view().view().legend().visible());
  EXPECT_TRUE(organ().scalarsShown());
  EXPECT_TRUE(clipped());
  EXPECT_TRUE(drawn().tissue()->visible());
  EXPECT_GT(drawn().tissue()->cutTriangles(), 10);
  EXPECT_NEAR(model().live().mesh()->witnesses, kFewWitnesses, 0.3 * kFewWitnesses);
  EXPECT_FALSE(label("stressOrigin").isEmpty());
  EXPECT_LT(model().shown().summary().max, 1e-6) << "nothing is distorted at rest";
  key(Qt::Key_1);
  EXPECT_FALSE(view().view().legend().visible());
  EXPECT_FALSE(organ().scalarsShown());
  EXPECT_FALSE(clipped());
  EXPECT_TRUE(organ().visible());
  EXPECT_FALSE(cut().planeWidget()->GetEnabled());
}

TEST_F(StressModeTest, DraggingAHandleMovesTheMapAndItsNumbers) {
  enter();
  const QString before = label("stressMax");
  const Points pointsBefore = model().live().points();
  dragAHandle();
  EXPECT_GT(model().shown().summary().max, 0.5);
  EXPECT_NE(label("stressMax"), before);
  EXPECT_GT((model().live().points() - pointsBefore).cwiseAbs().maxCoeff(), 1);
  // What is shown is the evaluation of the pose that is shown.
  deformation::StressMap expected;
  model().live().gradients()->evaluate(document().pose(), expected);
  Values values;
  live::quantityOf(expected, live::StressQuantity::rotationalStress, values);
  EXPECT_EQ(*model().shown().values(), values);
  const auto& bars = find<app::Histogram>("stressHistogram")->bars();
  int counted = 0;
  for (const int bar : bars)
    counted += bar;
  EXPECT_EQ(counted, model().live().mesh()->witnesses);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_LT(model().shown().summary().max, 1e-6) << "undo takes the stress back";
}

TEST_F(StressModeTest, TheCutIsPushedByItsArrowAndTurnedOffByItsKey) {
  enter();
  const scene::CutPlane before = cutPlane();
  auto* plane = cut().planeWidget()->GetPlaneRepresentation();
  look([](app::StressLook& look) { look.normal = Vec3(0.8, 0.6, 0); });
  settle();
  const scene::CutPlane turned = cutPlane();
  EXPECT_LT(turned.normal.dot(before.normal), 0.9);
  const QPoint from = onScreen(plane->GetArrowTip());
  drag(from, onScreen(plane->GetArrowTip() - 20 * turned.normal));
  EXPECT_NEAR((cutPlane().origin - turned.origin).dot(turned.normal), -20, 4);
  key(Qt::Key_C);
  EXPECT_FALSE(clipped());
  EXPECT_FALSE(cut().planeWidget()->GetEnabled());
  EXPECT_FALSE(drawn().tissue()->visible()) << "the organ's own surface carries the map";
  key(Qt::Key_C);
  EXPECT_TRUE(clipped());
}

TEST_F(StressModeTest, AClickShowsTheValuesOfThePointAndFollowsThePose) {
  enter();
  dragAHandle();
  click(onScreen(cutPlane().origin + Vec3(9, 0, -13)));
  const int point = model().probe();
  ASSERT_GE(point, 0);
  EXPECT_LT((model().live().points().row(point).transpose() - cutPlane().origin).norm(), 40);
  EXPECT_TRUE(drawn().probe().visible());
  EXPECT_NEAR((drawn().probe().position() - model().live().points().row(point).transpose()).norm(), 0, 1e-9);
  const double degrees = 180 / std::numbers::pi * model().live().map().rotationalStress[point];
  EXPECT_EQ(label("probe_rotational-stress"), QStringLiteral("%1 deg").arg(degrees, 0, 'f', 1));
  EXPECT_TRUE(find<QLabel>("probe_volume-ratio")->isVisible());
  const Vec3 rest = model().live().mesh()->points.row(point);
  EXPECT_EQ(label("probePosition"),
            QStringLiteral("At rest %1 mm").arg(QString::fromStdString(presentation::formatPlace(rest))))
      << "as a pinned probe and the report write it";
  key(Qt::Key_Escape);
  EXPECT_EQ(model().probe(), -1);
  EXPECT_FALSE(drawn().probe().visible());
}

TEST_F(StressModeTest, ALimitHidesTissueAndGlyphsShowInIt) {
  enter();
  dragAHandle();
  look([](app::StressLook& look) { look.cut = look.onSurface = false; });
  settle();
  const int all = drawn().tissue()->shownTetrahedra();
  key(Qt::Key_T);
  EXPECT_TRUE(model().look().threshold);
  EXPECT_GT(model().look().limit, 0);
  EXPECT_EQ(find<QWidget>("stressLimit")->findChild<QDoubleSpinBox*>()->suffix(), QStringLiteral(" deg"));
  EXPECT_LT(drawn().tissue()->shownTetrahedra(), all);
  EXPECT_GT(drawn().tissue()->shownTetrahedra(), 0);
  key(Qt::Key_T);
  settle();
  EXPECT_EQ(drawn().tissue()->shownTetrahedra(), all);
  look([](app::StressLook& look) { look.glyphs = app::GlyphChoice::ellipsoids; });
  settle();
  EXPECT_TRUE(drawn().glyphs().visible());
  EXPECT_GT(drawn().glyphs().count(), 50);
}

TEST_F(StressModeTest, LimitAndGlyphsAreOnThePageAndByKeysAndNoHabitOfTheNextStart) {
  constexpr int kMostGlyphs = 300;
  enter();
  dragAHandle();
  auto& limit = *find<app::ValueSlider>("stressLimit");
  auto& side = *find<QComboBox>("stressSide");
  EXPECT_TRUE(limit.isHidden() && side.isHidden()) << "there is no limit";
  key(Qt::Key_T);
  EXPECT_FALSE(limit.isHidden() || side.isHidden());
  EXPECT_EQ(limit.findChild<QDoubleSpinBox*>()->suffix().trimmed().toStdString(),
            app::inWords(live::describe(model().look().quantity).unit).toStdString());
  EXPECT_NEAR(limit.value(), model().shown().summary().mean, 0.1) << "the mean at first";
  const int above = drawn().tissue()->shownTetrahedra();
  Q_EMIT side.activated(1);
  settle();
  EXPECT_TRUE(model().look().below);
  EXPECT_NE(drawn().tissue()->shownTetrahedra(), above);
  key(Qt::Key_M);
  EXPECT_FALSE(model().look().threshold) << "it was meant for the other numbers";
  for (const app::GlyphChoice choice : {app::GlyphChoice::ellipsoids, app::GlyphChoice::crosses}) {
    key(Qt::Key_G, Qt::ShiftModifier);
    EXPECT_EQ(model().look().glyphs, choice);
    EXPECT_EQ(find<QComboBox>("stressGlyphs")->currentIndex(), static_cast<int>(choice));
    EXPECT_TRUE(drawn().glyphs().visible());
    EXPECT_LE(drawn().glyphs().count(), kMostGlyphs);
  }
  key(Qt::Key_T);
  reopenWindow();
  EXPECT_EQ(model().look().glyphs, app::GlyphChoice::none) << "they would stand there without tissue";
  EXPECT_FALSE(model().look().threshold);
}

TEST_F(StressModeTest, EveryMapHasItsLegendAndNumbers) {
  enter();
  dragAHandle();
  look([](app::StressLook& look) { look.quantity = live::StressQuantity::vonMises; });
  EXPECT_FALSE(model().shown().ready()) << "no pascals without a material";
  EXPECT_TRUE(find<QComboBox>("stressMaterial")->isVisible());
  EXPECT_EQ(find<QComboBox>("stressMaterial")->currentIndex(), 0);
  EXPECT_TRUE(label("stressSource").contains("Choose a material first"));
  look([](app::StressLook& look) {
    look.material = elasticity::materialOf("liver");
    look.quantity = live::StressQuantity::rotationalStress;
  });
  for (const live::StressQuantityDescription& quantity : live::stressQuantities()) {
    EXPECT_EQ(model().look().quantity, quantity.quantity);
    EXPECT_EQ(find<QComboBox>("stressQuantity")->currentText().toStdString(), quantity.name);
    const scene::ValueRange range = model().shown().range();
    if (quantity.ratio) {
      EXPECT_NEAR(0.5 * (range.low + range.high), 1, 1e-12) << "ratios lie around 1";
    }
    EXPECT_LE(model().shown().summary().percentile95, range.high);
    EXPECT_GE(model().shown().summary().percentile5, range.low);
    key(Qt::Key_M);
  }
}

TEST_F(StressModeTest, TheMaximumIsTheSameNumberEverywhereAndOfNoFoldedPoint) {
  enter();
  fold();
  const double degrees = 180 / std::numbers::pi * model().live().statistics().max;
  EXPECT_NEAR(model().shown().summary().max, degrees, 1e-9) << "the chart's number is the page's";
  EXPECT_NEAR(model().shown().summary().mean, 180 / std::numbers::pi * model().live().statistics().mean,
              1e-9);
  window().actions()["stress.maximum"]->trigger();
  waitForNumbers();
  ASSERT_GE(model().probe(), 0);
  EXPECT_GT(model().live().map().volumeRatio[model().probe()], 0);
  EXPECT_EQ(label("probe_rotational-stress"), label("stressMax"));
  look([](app::StressLook& look) { look.quantity = live::StressQuantity::folded; });
  window().actions()["stress.maximum"]->trigger();
  EXPECT_LE(model().live().map().volumeRatio[model().probe()], 0) << "what that map is about";
}

TEST_F(StressModeTest, TheLegendHasASwatchOnlyWhereFoldedTissueHasAColourOfItsOwn) {
  const auto marked = [this] {
    vtkActor2DCollection* actors = view().view().renderer()->GetActors2D();
    vtkCollectionSimpleIterator each;
    actors->InitTraversal(each);
    while (vtkActor2D* actor = actors->GetNextActor2D(each))
      if (auto* label = vtkTextActor::SafeDownCast(actor);
          label && label->GetVisibility() && label->GetInput() && QString(label->GetInput()) == "folded")
        return true;
    return false;
  };
  enter();
  EXPECT_FALSE(marked()) << "nothing is folded at rest";
  fold();
  EXPECT_TRUE(marked());
  look([](app::StressLook& look) { look.quantity = live::StressQuantity::folded; });
  settle();
  EXPECT_FALSE(marked()) << "it has a value, and that value's colour";
  look([](app::StressLook& look) { look.quantity = live::StressQuantity::volumeRatio; });
  settle();
  EXPECT_TRUE(marked());
}

TEST_F(StressModeTest, WhatNeedsAMapOrAnOrganIsGreyWithoutOne) {
  const QAction* maximum = window().actions()["stress.maximum"];
  const QAction* compare = window().actions()["play.comparePose"];
  enter();
  EXPECT_TRUE(maximum->isEnabled());
  EXPECT_TRUE(compare->isEnabled());
  window().actions()["organ.remove"]->trigger();
  settle();
  ASSERT_TRUE(document().organs().empty());
  EXPECT_FALSE(maximum->isEnabled());
  EXPECT_FALSE(compare->isEnabled());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([&] { return maximum->isEnabled(); }));
  EXPECT_TRUE(compare->isEnabled());
}

TEST_F(StressModeTest, TheNumberOfWitnessesAndTheLookAreKeptInTheSettings) {
  enter();
  find<QSpinBox>("stressWitnesses")->setValue(1500);
  ASSERT_TRUE(
      waitUntil([this] { return model().shown().ready() && model().live().mesh()->witnesses > 1000; }));
  look([](app::StressLook& look) {
    look.style = scene::CutStyle::crinkle;
    look.quantity = live::StressQuantity::stretchMin;
  });
  settle();
  EXPECT_FALSE(organ().visible()) << "whole tetrahedra stay";
  EXPECT_EQ(drawn().tissue()->cutTriangles(), 0);
  EXPECT_EQ(window().workspace().undo().names().size(), 1u) << "how one looks is no undo step";
  reopenWindow();
  EXPECT_EQ(model().look().style, scene::CutStyle::crinkle);
  EXPECT_EQ(model().look().quantity, live::StressQuantity::stretchMin);
  EXPECT_EQ(model().look().witnesses, 1500);
}

TEST_F(StressModeTest, ALogarithmicRangeIsThatOfLegendHistogramAndEveryColour) {
  enter();
  dragAHandle();
  const auto linear = find<app::Histogram>("stressHistogram")->bars();
  window().actions()["stress.logarithmic"]->trigger();
  waitForNumbers();
  const scene::ValueRange range = model().shown().range();
  EXPECT_TRUE(range.logarithmic);
  EXPECT_GT(range.low, 0);
  EXPECT_GE(range.high, model().shown().summary().percentile95);
  EXPECT_TRUE(organ().actor()->GetMapper()->GetLookupTable()->UsingLogScale());
  EXPECT_TRUE(drawn().tissue()->cut()->GetMapper()->GetLookupTable()->UsingLogScale());
  EXPECT_NE(find<app::Histogram>("stressHistogram")->bars(), linear);
  key(Qt::Key_M);
  EXPECT_NEAR(model().shown().range().low * model().shown().range().high, 1, 1e-12) << "of a ratio";
  look([](app::StressLook& look) { look.quantity = live::StressQuantity::folded; });
  EXPECT_FALSE(model().shown().range().logarithmic) << "what is or is not";
  look([](app::StressLook& look) { look.quantity = live::StressQuantity::rotationalStress; });
  window().actions()["stress.pin"]->trigger();
  window().actions()["stress.logarithmic"]->trigger();
  EXPECT_EQ(model().shown().range(), (scene::ValueRange{range.low, range.high})) << "it is kept";
  window().actions()["stress.logarithmic"]->trigger();
  reopenWindow();
  EXPECT_TRUE(model().look().logarithmic);
}

TEST_F(StressModeTest, AColourMapIsThatOfLegendHistogramAndTissueAndStays) {
  enter();
  dragAHandle();
  const auto firstColor = [this] {
    double color[4];
    drawn().tissue()->cut()->GetMapper()->GetLookupTable()->GetColor(-1, color);
    return Vec3(color[0], color[1], color[2]);
  };
  const auto choose = [this](int index) {
    auto* box = find<QComboBox>("stressColors");
    box->setCurrentIndex(index);
    Q_EMIT box->activated(index);
    waitForNumbers();
  };
  const Vec3 viridis = firstColor();
  choose(1);
  EXPECT_EQ(model().look().amountColors, "cividis");
  EXPECT_EQ(model().shown().colors().name, "cividis");
  EXPECT_GT((firstColor() - viridis).norm(), 0.2);
  double color[4];
  organ().actor()->GetMapper()->GetLookupTable()->GetColor(-1, color);
  EXPECT_EQ(Vec3(color[0], color[1], color[2]), firstColor()) << "surface and cut are of one map";
  key(Qt::Key_M);
  EXPECT_EQ(model().shown().colors().name, "diverging") << "ratios have their own";
  EXPECT_EQ(find<QComboBox>("stressColors")->currentIndex(), 4);
  choose(3);
  EXPECT_EQ(model().look().ratioColors, "grey");
  reopenWindow();
  EXPECT_EQ(model().look().amountColors, "cividis");
  EXPECT_EQ(model().look().ratioColors, "grey");
}

/// Probes and profiles of the ball.
class StressMarksInTheWindow : public StressModeTest {
protected:
  /// Pins the point of the mesh that is nearest to a place at rest.
  void pin(const Vec3& place) {
    Eigen::Index nearest = 0;
    (model().live().mesh()->points.rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    model().setProbe(static_cast<int>(nearest));
    window().actions()["stress.pinProbe"]->trigger();
    waitForNumbers();
  }
  QTreeWidget& list() { return *find<QTreeWidget>("stressMarks"); }
  QString cell(int row, int column) { return list().topLevelItem(row)->text(column); }
  const std::vector<document::StressProbe>& probes() { return document().stressMarks().probes; }
  QString read(int point) {
    return model().format(live::quantityAt(model().live().map(), model().look().quantity, point));
  }
};

TEST_F(StressMarksInTheWindow, AProbeFollowsTheTissueAndIsAStepToUndo) {
  enter();
  EXPECT_FALSE(window().actions()["stress.pinProbe"]->isEnabled()) << "nothing was clicked";
  EXPECT_FALSE(list().isVisible());
  pin({0, 10, 15});
  ASSERT_EQ(probes().size(), 1u);
  const int point = model().probe();
  EXPECT_EQ(probes()[0].rest, Vec3(model().live().mesh()->points.row(point).transpose()));
  ASSERT_EQ(list().topLevelItemCount(), 1);
  EXPECT_EQ(cell(0, 0), QStringLiteral("1"));
  const QString place = cell(0, 1);
  EXPECT_EQ(place, QString::fromStdString(presentation::formatPlace(probes()[0].rest)));
  dragAHandle();
  EXPECT_EQ(cell(0, 2), read(point)) << "the number of the point that was clicked";
  EXPECT_EQ(cell(0, 2), label("probe_rotational-stress")) << "and of the card";
  EXPECT_NE(cell(0, 1), place);
  const auto& items = drawn().stressMarks().items();
  ASSERT_EQ(items.size(), 1u);
  EXPECT_EQ(items[0].text, "1");
  EXPECT_LT((items[0].points[0] - model().live().points().row(point).transpose()).norm(), 1e-9);
  pin(probes()[0].rest);
  EXPECT_EQ(probes().size(), 1u) << "it is there already";
  EXPECT_FALSE(message().isEmpty());
  key(Qt::Key_Z, Qt::ControlModifier);
  waitForNumbers();
  EXPECT_EQ(cell(0, 1), place) << "undo takes the pose back";
  key(Qt::Key_Z, Qt::ControlModifier);
  waitForNumbers();
  EXPECT_TRUE(probes().empty());
  EXPECT_FALSE(list().isVisible());
  EXPECT_TRUE(drawn().stressMarks().items().empty());
}

TEST_F(StressMarksInTheWindow, NumbersAreOfTheFrameThatIsDrawn) {
  enter();
  pin({0, 10, 15});
  const int point = model().probe();
  Points pose = document().pose();
  QString before = label("stressMax");
  for (int frame = 0; frame < 8; ++frame) {
    pose(0, 0) += 3;
    ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
    handleEvents();
    const QString now = model().format(model().shown().summary().max);
    EXPECT_NE(now, before);
    EXPECT_EQ(label("stressMax"), now);
    EXPECT_EQ(label("probe_rotational-stress"), read(point));
    EXPECT_EQ(cell(0, 2), read(point));
    before = now;
  }
}

TEST_F(StressMarksInTheWindow, StayWithOtherWitnessPointsAndGoWithTheMode) {
  enter();
  pin({0, 10, 15});
  dragAHandle();
  const double before = drawn().readMarks().probes[0].reading.stressDegrees;
  look([](app::StressLook& look) { look.witnesses = 2000; });
  ASSERT_TRUE(
      waitUntil([this] { return model().shown().ready() && model().live().mesh()->witnesses > 1500; }));
  settle();
  ASSERT_EQ(drawn().readMarks().probes.size(), 1u);
  EXPECT_NEAR(drawn().readMarks().probes[0].reading.stressDegrees, before, 0.2 * before);
  key(Qt::Key_1);
  EXPECT_TRUE(drawn().stressMarks().items().empty());
}

TEST_F(StressMarksInTheWindow, AProfileIsDrawnBetweenTwoProbesAndFollowsThePose) {
  enter();
  pin({0, 20, 0});
  EXPECT_FALSE(find<QPushButton>("stressProfile")->isEnabled());
  pin({0, -20, 10});
  auto& chart = *find<app::ProfileChart>("profileChart");
  EXPECT_FALSE(chart.isVisible());
  QTest::mouseClick(find<QPushButton>("stressProfile"), Qt::LeftButton);
  waitForNumbers();
  ASSERT_EQ(document().stressMarks().lines.size(), 1u);
  EXPECT_TRUE(chart.isVisible());
  dragAHandle();
  ASSERT_EQ(chart.curves().size(), 1u) << "a ball has no gaps";
  const scene::PanelCurve& curve = chart.curves()[0];
  EXPECT_EQ(curve.name, "1-2");
  EXPECT_EQ(curve.x.size(), static_cast<std::size_t>(live::kProfilePoints));
  EXPECT_NEAR(curve.x.back(), (probes()[0].rest - probes()[1].rest).norm(), 1e-9);
  EXPECT_NEAR(curve.y.front(), drawn().readMarks().probes[0].reading.stressDegrees, 1e-9);
  EXPECT_NEAR(curve.y.back(), drawn().readMarks().probes[1].reading.stressDegrees, 1e-9);
  EXPECT_EQ(cell(2, 0), QStringLiteral("1-2"));
  EXPECT_EQ(cell(2, 2), model().format(*std::max_element(curve.y.begin(), curve.y.end())));
  EXPECT_TRUE(drawn().stressMarks().items()[0].path);
  key(Qt::Key_M);
  waitForNumbers();
  EXPECT_NEAR(chart.curves()[0].y.front(), drawn().readMarks().probes[0].reading.volumeRatio, 1e-9);
  list().topLevelItem(0)->setSelected(true);
  QTest::mouseClick(find<QPushButton>("stressRemoveMarks"), Qt::LeftButton);
  waitForNumbers();
  EXPECT_EQ(probes().size(), 1u);
  EXPECT_TRUE(document().stressMarks().lines.empty()) << "it goes with its end";
  EXPECT_FALSE(chart.isVisible());
  key(Qt::Key_Z, Qt::ControlModifier);
  waitForNumbers();
  EXPECT_TRUE(chart.isVisible());
}

TEST_F(StressMarksInTheWindow, AreWrittenAsTheCommandLineWritesThem) {
  enter();
  app::StressExport& exports = window().stress().exports();
  EXPECT_FALSE(window().actions()["stress.exportProbes"]->isEnabled());
  pin({0, 20, 0});
  pin({0, -20, 10});
  dragAHandle();
  EXPECT_TRUE(window().actions()["stress.exportProbes"]->isEnabled());
  EXPECT_FALSE(window().actions()["stress.exportProfiles"]->isEnabled()) << "there is no line";
  QTest::mouseClick(find<QPushButton>("stressProfile"), Qt::LeftButton);
  waitForNumbers();
  exports.exportProbes(path(QStringLiteral("p.csv")));
  settle();
  exports.exportProfiles(path(QStringLiteral("l.csv")));
  settle();
  // What viscera stress --probe and --profile call, on the same mesh and pose.
  const auto mesh = model().live().mesh();
  Points rest(2, 3);
  rest << probes()[0].rest.transpose(), probes()[1].rest.transpose();
  const auto readings = live::TissuePoints(mesh, rest, live::probeReach(*mesh))
                            .read(model().live().points(), model().live().map());
  const auto file = [this](const char* name) { return path(QLatin1String(name)).toStdString(); };
  live::writeStressProbes(file("c.csv"), {{"1", readings[0]}, {"2", readings[1]}});
  EXPECT_EQ(contentsOf(file("p.csv")), contentsOf(file("c.csv")));
  const std::string along = contentsOf(file("l.csv"));
  EXPECT_EQ(std::count(along.begin(), along.end(), '\n'), 1 + live::kProfilePoints);
  EXPECT_NE(along.find("\n1-2,0,"), std::string::npos);
}

TEST_F(StressMarksInTheWindow, AreInASession) {
  enter();
  pin({0, 20, 0});
  pin({0, -20, 10});
  QTest::mouseClick(find<QPushButton>("stressProfile"), Qt::LeftButton);
  settle();
  const document::StressMarks before = document().stressMarks();
  bool done = false;
  window().sessions().saveTo(path(QStringLiteral("s.viscera")), true, [&] { done = true; });
  ASSERT_TRUE(waitUntil([&] { return done; }));
  reopenWindow();
  window().files().open({path(QStringLiteral("s.viscera"))});
  ASSERT_TRUE(waitUntil([this] { return !document().organs().empty() && model().shown().ready(); }));
  settle();
  EXPECT_EQ(document().stressMarks(), before);
  EXPECT_EQ(list().topLevelItemCount(), 3);
}

/// Two views: the pose that was kept, and the one that goes on.
class TwoStressMaps : public StressModeTest {
protected:
  const presentation::Presenter& beside() { return window().play().comparison().picture().presenter(); }
  bool legend() { return view().view().legend().visible(); }
  bool legendBeside() { return window().play().comparison().view().view().legend().visible(); }
};

TEST_F(TwoStressMaps, OfTwoPosesHaveOneRangeAndOneLegendWhileThatIsWanted) {
  enter();
  dragAHandle();
  window().actions()["play.comparePose"]->trigger();
  ASSERT_TRUE(waitUntil([this] { return beside().stressValues().ready(); }));
  settle();
  const Values kept = *beside().stressValues().values();
  EXPECT_EQ(kept, *model().shown().values()) << "the pose that was kept";
  QStringList titles;
  for (const app::SideHeader* header : window().findChildren<app::SideHeader*>())
    for (const app::ElidedLabel* said : header->findChildren<app::ElidedLabel*>())
      titles << said->fullText();
  EXPECT_TRUE(titles.contains(QStringLiteral("Present pose"))) << titles.join('|').toStdString();
  EXPECT_TRUE(titles.contains(QStringLiteral("Kept pose"))) << titles.join('|').toStdString();
  key(Qt::Key_Z, Qt::ControlModifier);
  settle();
  EXPECT_LT(model().shown().summary().max, 1e-6) << "this one is at rest again";
  EXPECT_EQ(*beside().stressValues().values(), kept);
  EXPECT_EQ(model().shown().range(), beside().stressValues().range());
  EXPECT_EQ(model().shown().range().high, beside().stressValues().ownRange().high);
  EXPECT_TRUE(legend());
  EXPECT_FALSE(legendBeside()) << "it is said once";
  window().actions()["stress.sameRange"]->trigger();
  settle();
  EXPECT_LT(model().shown().range().high, beside().stressValues().range().high);
  EXPECT_TRUE(legend());
  EXPECT_TRUE(legendBeside());
  window().actions()["stress.sameRange"]->trigger();
  settle();
  EXPECT_EQ(model().shown().range(), beside().stressValues().range());
  key(Qt::Key_1);
  settle();
  EXPECT_FALSE(beside().stressValues().ready()) << "no map without the mode";
  key(Qt::Key_4);
  ASSERT_TRUE(waitUntil([this] { return beside().stressValues().ready(); }));
  window().play().comparison().end();
  settle();
  EXPECT_EQ(model().shown().range(), model().shown().ownRange());
}

} // namespace
} // namespace viscera::tests
