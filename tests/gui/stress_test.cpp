#include "window_test.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <QTimer>

#include <cmath>
#include <numbers>

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkPlaneCollection.h>

#include "sway.h"
#include "viscera/live/stress_quantity.h"
#include "viscera/presentation/stress_values.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/modes/stress_mode.h"
#include "window/stress/histogram.h"

namespace viscera::tests {
namespace {

constexpr int kWitnesses = 600;

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

class StressModeTest : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    look([](app::StressLook& look) { look.witnesses = kWitnesses; });
  }

  app::StressModel& model() { return window().stress().model(); }
  const presentation::Presenter& drawn() { return window().picture().presenter(); }
  app::CutController& cut() { return window().stress().cut(); }
  scene::CutPlane cutPlane() { return drawn().cutPlane()->GetPlane(); }
  scene::OrganActor& organ() { return *view().view().organs().front(); }
  bool clipped() {
    auto* planes = organ().actor()->GetMapper()->GetClippingPlanes();
    return planes && planes->GetNumberOfItems() > 0;
  }
  void look(const std::function<void(app::StressLook&)>& change) {
    app::StressLook look = model().look();
    change(look);
    model().setLook(look);
  }
  void enter() {
    key(Qt::Key_4);
    ASSERT_EQ(window().mode(), "stress");
    ASSERT_TRUE(waitUntil([this] { return model().shown().ready() && drawn().tissue(); }));
    settle();
  }
  template <class Widget>
  Widget* find(const char* name) {
    return window().findChild<Widget*>(QLatin1String(name));
  }
  QString label(const char* name) { return find<QLabel>(name)->text(); }
  /// Where a handle is that the mouse meets in the middle, not one that the cut half hides; null: nowhere.
  QPoint freeHandle() {
    auto* handles = view().view().handles();
    for (int handle = 0; handle < handles->GetNumberOfHandles(); ++handle) {
      const QPoint place = onScreen(handles->GetPosition(handle));
      const double ratio = view().devicePixelRatioF();
      if (view().rect().adjusted(80, 80, -80, -80).contains(place) &&
          handles->Pick(qRound(ratio * place.x()), qRound(ratio * (view().height() - 1 - place.y()))) ==
              handle)
        return place;
    }
    return {};
  }
  /// Drags a handle to the side.
  void dragAHandle() {
    const QPoint from = freeHandle();
    ASSERT_FALSE(from.isNull());
    drag(from, from + QPoint(70, -30));
    waitForNumbers();
  }
  /// Numbers to be read come ten times a second.
  void waitForNumbers() {
    bool told = false;
    QTimer timer;
    timer.setSingleShot(true);
    QObject::connect(&timer, &QTimer::timeout, [&] { told = true; });
    timer.start(200);
    waitUntil([&] { return told; });
  }
};

TEST_F(StressModeTest, KeyFourShowsTheMapAndLeavingPutsTheLooksBack) {
  enter();
  EXPECT_TRUE(view().view().legend().visible());
  EXPECT_TRUE(organ().scalarsShown());
  EXPECT_TRUE(clipped());
  EXPECT_TRUE(drawn().tissue()->visible());
  EXPECT_GT(drawn().tissue()->cutTriangles(), 10);
  EXPECT_NEAR(model().live().mesh()->witnesses, kWitnesses, 0.3 * kWitnesses);
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
  EXPECT_TRUE(label("probePosition").contains(QStringLiteral(" mm"))) << label("probePosition").toStdString();
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

TEST_F(StressModeTest, EveryMapHasItsLegendAndNumbers) {
  enter();
  dragAHandle();
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

TEST_F(StressModeTest, APlayingSequenceMovesTheMapAndIsRecorded) {
  enter();
  const auto sway =
      std::make_shared<Sway>(document().rig().restPositions(), std::vector<Swing>{{0, Vec3(30, 0, 0)}});
  window().playback().setSequence(sway, document().organs().front()->id);
  settle();
  key(Qt::Key_Space);
  EXPECT_EQ(window().mode(), "stress");
  for (int frame = 0; frame < 12; ++frame) {
    now_ += 0.02;
    window().playback().advance();
  }
  EXPECT_GT(model().shown().summary().max, 0.5);
  EXPECT_GE(model().record().samples().size(), 10u);
  EXPECT_NEAR(model().record().samples().back().statistics.max,
              model().shown().summary().max * std::numbers::pi / 180, 1e-9);
  key(Qt::Key_Space);
  // The peak over the cycle is at least the map of every instant.
  const Values now = *model().shown().values();
  window().actions()["stress.peak"]->trigger();
  ASSERT_TRUE(waitUntil([this] { return model().peakShown(); }));
  const Eigen::Index witnesses = model().live().mesh()->witnesses;
  EXPECT_GE((*model().shown().values() - now).minCoeff(), -0.2);
  EXPECT_GT(model().shown().summary().max, now.head(witnesses).maxCoeff() - 0.2);
  // Back to the own pose, which is at rest.
  window().actions()["stress.peak"]->trigger();
  QTest::mouseClick(find<QPushButton>("stressOwnPose"), Qt::LeftButton);
  settle();
  EXPECT_LT(model().shown().summary().max, 1e-6);
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

TEST_F(StressModeTest, ACancelledTaskSaysSoAndGoesOnWhenAsked) {
  key(Qt::Key_1);
  window().setMode("stress");
  window().workspace().jobs().cancelAll();
  ASSERT_TRUE(
      waitUntil([this] { return model().live().status().state == live::StressStatus::State::cancelled; }));
  EXPECT_TRUE(find<QLabel>("stressState")->isVisible());
  EXPECT_TRUE(organ().visible());
  model().live().retry();
  ASSERT_TRUE(waitUntil([this] { return model().shown().ready(); }));
  EXPECT_FALSE(find<QLabel>("stressState")->isVisible());
}

} // namespace
} // namespace viscera::tests
