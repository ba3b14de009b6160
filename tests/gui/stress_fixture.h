#pragma once

#include <QLabel>
#include <QTest>
#include <QTimer>

#include <functional>

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkPlaneCollection.h>

#include "viscera/document/rig_commands.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/stress/stress_mode.h"
#include "window_test.h"

namespace viscera::tests {

/// A window with a ball, in which the mode Stress can be entered.
class StressModeTest : public WindowTest {
protected:
  static constexpr int kFewWitnesses = 600;

  /// Drags and probes by pixels.
  std::optional<QSize> viewSize() const override { return std::nullopt; }

  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    EXPECT_FALSE(model().look().cut) << "the organ is whole until the reader cuts it";
    look([](app::StressLook& look) {
      look.witnesses = kFewWitnesses;
      look.cut = true;
    });
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
          handles->PickHandle(qRound(ratio * place.x()), qRound(ratio * (view().height() - 1 - place.y()))) ==
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
  /// Pushes a handle towards the middle of the others until some of the tissue is folded, not all of it.
  void fold() {
    const Points rest = document().rig().restPositions();
    const Eigen::RowVector3d inward = (rest.colwise().mean() - rest.row(0)).normalized();
    for (double mm = 40; mm < 4000 && model().live().statistics().folded == 0; mm *= 1.3) {
      Points pose = rest;
      pose.row(0) += mm * inward;
      ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
      settle();
    }
    ASSERT_GT(model().live().statistics().folded, 0);
    ASSERT_LT(model().live().statistics().folded, model().live().mesh()->witnesses);
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

} // namespace viscera::tests
