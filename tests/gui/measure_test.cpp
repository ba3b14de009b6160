#include "window_test.h"

#include <QAction>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include <cmath>
#include <fstream>
#include <sstream>

#include "session_fixture.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "window/export/export_actions.h"
#include "window/organs/explore_mode.h"

namespace viscera::tests {
namespace {

constexpr double kRadius = 60; ///< Of the ball, mm.
/// A pixel is about 0.25 mm here, and the ball has facets.
constexpr double kClickTolerance = 1; ///< mm

/// Distances and angles, clicked on the front of a ball: the reader looks along +y.
class MeasureTest : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile(QStringLiteral("ball.stl"), kRadius));
  }

  static Vec3 onFront(double x, double z) { return {x, -std::sqrt(kRadius * kRadius - x * x - z * z), z}; }
  void clickAt(const Vec3& place) { click(onScreen(place)); }
  void measureDistance() {
    key(Qt::Key_D);
    clickAt(a_);
    clickAt(b_);
    key(Qt::Key_Escape);
  }

  const document::MeasurementList& measurements() { return document().measurements(); }
  QTreeWidget& list() { return *window().findChild<QTreeWidget*>(QStringLiteral("measureList")); }
  double listed(int row, int column) {
    QString text = list().topLevelItem(row)->text(column);
    return text.remove(QStringLiteral(" mm")).remove(QChar(0xb0)).toDouble();
  }
  std::string label() {
    const auto drawn = window().picture().presenter().measurements().drawn();
    return drawn.empty() ? std::string() : drawn[0].text;
  }

  const Vec3 a_ = onFront(-30, 10);
  const Vec3 b_ = onFront(25, -15);
};

TEST_F(MeasureTest, TwoClicksAreADistanceInTheListTheViewAndTheFile) {
  key(Qt::Key_D);
  EXPECT_TRUE(window().explore().measuring());
  clickAt(a_);
  EXPECT_TRUE(measurements().empty()) << "nothing is in the document before it is complete";
  clickAt(b_);
  ASSERT_EQ(measurements().size(), 1u);
  const double expected = (b_ - a_).norm();
  EXPECT_NEAR(listed(0, 1), expected, kClickTolerance);
  EXPECT_NEAR(listed(0, 2), expected, kClickTolerance);
  EXPECT_EQ(label(), "Distance 1: " + list().topLevelItem(0)->text(1).toStdString());
  EXPECT_EQ(window().workspace().undo().undoName().english(), "Measure distance");
  EXPECT_TRUE(window().explore().measuring()) << "the next one can be measured at once";

  window().exports().exportMeasurements(path(QStringLiteral("m.csv")));
  settle();
  std::ifstream file(path(QStringLiteral("m.csv")).toStdString());
  std::string line, field;
  std::getline(file, line);
  EXPECT_EQ(line.substr(0, 41), "name,kind,value_at_rest,value_now,unit,or");
  std::getline(file, line);
  std::istringstream fields(line);
  std::vector<std::string> row;
  while (std::getline(fields, field, ','))
    row.push_back(field);
  ASSERT_GE(row.size(), 19u);
  EXPECT_EQ(row[0], "Distance 1");
  EXPECT_NEAR(std::stod(row[3]), expected, kClickTolerance);
  EXPECT_EQ(row[4], "mm");
  EXPECT_EQ(row[5], "ball");
  EXPECT_NEAR(std::stod(row[6]), a_.x(), kClickTolerance);
  EXPECT_NEAR(std::stod(row[18]), b_.z(), kClickTolerance);
}

/// Qt takes the second press for a double click, which shows one organ alone where nobody measures.
TEST_F(MeasureTest, TwoQuickClicksAreTwoPointsAndHideNoOrgan) {
  ASSERT_TRUE(window().workspace().perform(document::addOrgans({ball("other", 10, 2, Vec3(0, 0, 75))})));
  settle();
  key(Qt::Key_D);
  const QPoint place = onScreen(a_);
  clickTwice(place, place + QPoint(4, 0));
  EXPECT_EQ(measurements().size(), 1u);
  for (const auto& organ : document().organs())
    EXPECT_TRUE(organ->look.visible) << organ->name;
  clickTwice(place, place);
  EXPECT_EQ(measurements().size(), 1u) << "no distance of a point to itself";
  key(Qt::Key_Escape);
  key(Qt::Key_Escape);
  clickTwice(onScreen(b_), onScreen(b_));
  EXPECT_FALSE(document().organs().back()->look.visible) << "the double click is one again";
}

TEST_F(MeasureTest, ThreeClicksAreTheAngleAtTheSecond) {
  const Vec3 c = onFront(10, 35);
  key(Qt::Key_A);
  for (const Vec3& place : {a_, b_, c})
    clickAt(place);
  ASSERT_EQ(measurements().size(), 1u);
  const Vec3 u = (a_ - b_).normalized(), v = (c - b_).normalized();
  EXPECT_NEAR(listed(0, 1), std::acos(u.dot(v)) * 180 / M_PI, 1.5);
  EXPECT_EQ(label(), "Angle 1: " + list().topLevelItem(0)->text(1).toStdString());
}

TEST_F(MeasureTest, TheValueFollowsThePoseAndTheOneAtRestStays) {
  measureDistance();
  const double rest = listed(0, 2);
  ASSERT_TRUE(window().workspace().perform(document::setPose(1.5 * document().pose())));
  ASSERT_TRUE(waitUntil([&] { return std::abs(listed(0, 1) - 1.5 * rest) < 0.2; }))
      << listed(0, 1) << " mm now, " << rest << " mm at rest";
  EXPECT_DOUBLE_EQ(listed(0, 2), rest);
  EXPECT_EQ(label(), "Distance 1: " + list().topLevelItem(0)->text(1).toStdString());
}

TEST_F(MeasureTest, EscapeTakesBackPointsThenEndsAndClicksSelectAgain) {
  window().workspace().selection().clear();
  key(Qt::Key_D);
  clickAt(a_);
  EXPECT_FALSE(window().workspace().selection().organ()) << "the click was meant for the measurement";
  key(Qt::Key_Escape);
  EXPECT_TRUE(window().explore().measuring());
  for (const auto& item : window().picture().presenter().measurements().items())
    EXPECT_EQ(item.points.size(), 1u) << "what is left is the place under the mouse";
  key(Qt::Key_Escape);
  EXPECT_FALSE(window().explore().measuring());
  EXPECT_FALSE(window().actions()["measure.distance"]->isChecked());
  clickAt(b_);
  EXPECT_TRUE(window().workspace().selection().organ());
  EXPECT_TRUE(measurements().empty());
}

TEST_F(MeasureTest, ADragTurnsTheViewAndSetsNoPointAndAClickBesideTheOrganNone) {
  key(Qt::Key_D);
  drag(view().rect().center(), view().rect().center() + QPoint(60, 0));
  click(QPoint(5, view().height() / 2));
  QTest::mouseMove(&view(), QPoint(5, 5));
  settle();
  EXPECT_TRUE(window().picture().presenter().measurements().items().empty());
}

TEST_F(MeasureTest, TheNextPointIsShownUnderTheMouseWithTheDistanceToIt) {
  key(Qt::Key_D);
  clickAt(a_);
  QTest::mouseMove(&view(), onScreen(b_));
  settle();
  const auto& items = window().picture().presenter().measurements().items();
  ASSERT_EQ(items.size(), 1u);
  EXPECT_LT((items[0].points.at(1) - b_).norm(), kClickTolerance);
  EXPECT_NEAR(QString::fromStdString(items[0].text).remove(QStringLiteral(" mm")).toDouble(),
              (b_ - a_).norm(), kClickTolerance);
  EXPECT_TRUE(measurements().empty());
}

TEST_F(MeasureTest, APointIsDraggedAlongTheOrganInOneStep) {
  measureDistance();
  const auto steps = window().workspace().undo().position();
  const Vec3 elsewhere = onFront(5, 30);
  drag(onScreen(b_), onScreen(elsewhere));
  EXPECT_LT((measurements()[0].points[1].rest - elsewhere).norm(), kClickTolerance);
  EXPECT_LT((measurements()[0].points[0].rest - a_).norm(), kClickTolerance);
  EXPECT_EQ(window().workspace().undo().position(), steps + 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_LT((measurements()[0].points[1].rest - b_).norm(), kClickTolerance);
}

TEST_F(MeasureTest, EscapeDuringADragPutsThePointBack) {
  measureDistance();
  const document::DocumentState before = window().workspace().state();
  QTest::mouseMove(&view(), onScreen(b_));
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, onScreen(b_));
  QTest::mouseMove(&view(), onScreen(onFront(5, 30)));
  QTest::qWait(50);
  EXPECT_NE(window().workspace().state(), before);
  key(Qt::Key_Escape);
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, onScreen(onFront(5, 30)));
  settle();
  EXPECT_EQ(window().workspace().state(), before);
}

TEST_F(MeasureTest, NamesAreEditedInTheListAndTheChosenOneIsRemoved) {
  measureDistance();
  list().topLevelItem(0)->setText(0, QStringLiteral("Width"));
  settle();
  EXPECT_EQ(measurements()[0].name, "Width");
  list().topLevelItem(0)->setText(0, QStringLiteral(" "));
  settle();
  EXPECT_EQ(list().topLevelItem(0)->text(0), QStringLiteral("Width")) << "an empty name is refused";
  list().topLevelItem(0)->setSelected(true);
  settle();
  EXPECT_TRUE(window().picture().presenter().measurements().items().at(0).highlighted);
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Delete);
  settle();
  EXPECT_TRUE(measurements().empty());
  EXPECT_FALSE(list().isVisible());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(measurements().size(), 1u);
}

TEST_F(MeasureTest, EndsInAnotherModeAndBeginsInExplore) {
  key(Qt::Key_D);
  key(Qt::Key_3);
  EXPECT_FALSE(window().explore().measuring());
  key(Qt::Key_A);
  EXPECT_EQ(window().mode(), "explore");
  EXPECT_TRUE(window().explore().measuring());
  ASSERT_TRUE(window().workspace().perform(document::removeAllOrgans()));
  settle();
  EXPECT_FALSE(window().explore().measuring()) << "there is nothing to measure";
  EXPECT_FALSE(window().actions()["measure.angle"]->isEnabled());
}

TEST_F(MeasureTest, ExportingNothingSaysSo) {
  window().actions()["export.measurements"]->trigger();
  EXPECT_TRUE(message().contains(QStringLiteral("Nothing is measured"))) << message().toStdString();
}

} // namespace
} // namespace viscera::tests
