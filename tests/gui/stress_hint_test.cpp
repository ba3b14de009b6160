#include "stress_fixture.h"

#include <QLabel>

#include <vtkActor.h>
#include <vtkProperty.h>

#include "shapes.h"
#include "viscera/document/organ_commands.h"

namespace viscera::tests {
namespace {

TEST_F(StressModeTest, AtRestAHintSaysWhatToDoAndNoHistogramIsDrawn) {
  enter();
  const auto* hint = find<QLabel>("stressHint");
  ASSERT_NE(hint, nullptr);
  EXPECT_TRUE(hint->isVisible());
  EXPECT_TRUE(hint->text().contains(QStringLiteral("drag a handle"))) << hint->text().toStdString();
  EXPECT_EQ(model().shown().legendRange(), (scene::ValueRange{0, 0}));
  const auto* squeezed = find<QLabel>("stressSqueezed");
  EXPECT_FALSE(squeezed->isVisible()) << squeezed->text().toStdString();
  Points pose = document().pose();
  pose.row(9) *= 1.3;
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  ASSERT_TRUE(waitUntil([&] { return model().shown().deformed() && !hint->isVisible(); }));
  EXPECT_GT(model().shown().legendRange().high, 0);
  // What the colours mean is read without a pointer on them.
  EXPECT_TRUE(find<QLabel>("stressMeaning")->isVisible());
  EXPECT_TRUE(label("stressMeaning").contains(QStringLiteral("angle")))
      << label("stressMeaning").toStdString();
  pose.row(9) *= 4; // No living tissue changes its volume so much, on whatever map.
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  EXPECT_TRUE(waitUntil([&] { return squeezed->isVisible(); }));
  EXPECT_TRUE(squeezed->text().contains(QStringLiteral(" % of its volume")))
      << squeezed->text().toStdString();
}

/// The eyes of their rows are open.
TEST_F(StressModeTest, OtherOrgansStayAsGlassAroundTheMapAndOneWithoutHandlesSaysSo) {
  document::NewOrgan far;
  far.organ = document::makeOrgan("spleen", sphere(3, 30, Vec3(400, 0, 0)));
  ASSERT_TRUE(window().workspace().perform(document::addOrgans({far})));
  ASSERT_TRUE(window().workspace().perform(document::addEnclosingHandles()));
  const document::OrganId ball = document().organs().front()->id, spleen = document().organs().back()->id;
  window().workspace().selection().setOrgan(ball);
  enter();
  const auto other = drawn().actorOf(spleen);
  ASSERT_NE(other, nullptr);
  EXPECT_TRUE(other->visible());
  EXPECT_LE(other->actor()->GetProperty()->GetOpacity(), 0.25) << "the map is seen through it";
  key(Qt::Key_1);
  EXPECT_EQ(other->actor()->GetProperty()->GetOpacity(), 1);
  window().workspace().selection().setOrgan(spleen);
  enter();
  const auto* hint = find<QLabel>("stressHint");
  EXPECT_TRUE(waitUntil([&] { return hint->text().contains(QStringLiteral("No handle is near Spleen")); }))
      << hint->text().toStdString();
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
