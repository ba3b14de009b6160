#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include <map>

#include "shapes.h"
#include "viscera/document/system_commands.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/compare/compared_system.h"
#include "window/compare/comparison.h"
#include "window/compare/difference_map.h"
#include "window/play/play_mode.h"
#include "window/style/language.h"
#include "window/view/picture.h"
#include "window/widgets/system_combo.h"
#include "window_test.h"

namespace viscera::tests {
namespace {

/// A sphere in Deform mode beside itself, tied to the same handles by other coordinates.
class TwoSystems : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    key(Qt::Key_3);
    key(Qt::Key_3, Qt::ControlModifier);
    ASSERT_NE(comparison().comparedSystem(), nullptr);
    ASSERT_TRUE(bound());
    organ_ = document().organs().front()->id;
  }
  app::Comparison& comparison() { return window().play().comparison(); }
  app::Workspace& second() { return comparison().workspace(); }
  bool bound() {
    return waitUntil([this] { return !second().live().busy() && second().jobs().idle(); });
  }
  const Points& points(app::Workspace& workspace) { return workspace.live().points(organ_); }

  document::OrganId organ_;
};

TEST_F(TwoSystems, FollowTheSameDragInTheirOwnWay) {
  EXPECT_EQ(document().system().id, "s-celestial");
  EXPECT_EQ(second().document().system().id, "t-celestial");
  const int handle = reachableHandle();
  ASSERT_GE(handle, 0);
  const QPoint from = onScreen(handleInView(handle));
  drag(from, from + QPoint(70, 20));
  ASSERT_TRUE(bound());
  EXPECT_EQ(second().document().pose(), document().pose());
  EXPECT_GT((points(second()) - document().organs().front()->mesh->points).rowwise().norm().maxCoeff(), 1);
  EXPECT_GT((points(second()) - points(window().workspace())).rowwise().norm().maxCoeff(), 0.1)
      << "two systems, two shapes";
  EXPECT_EQ(comparison().view().view().handles()->GetPositions(), view().view().handles()->GetPositions());
  EXPECT_TRUE(second().undo().names().empty()) << "only the first document has steps";
}

TEST_F(TwoSystems, ShowTheirHandlesInTheSameModes) {
  const auto shown = [](app::ViewWidget& view) { return view.view().handles()->GetHandleShown(0) != 0; };
  for (const Qt::Key mode : {Qt::Key_3, Qt::Key_1, Qt::Key_2, Qt::Key_5}) {
    key(mode);
    settle();
    EXPECT_EQ(shown(view()), mode == Qt::Key_3 || mode == Qt::Key_2);
    EXPECT_EQ(shown(comparison().view()), shown(view())) << mode;
  }
}

TEST_F(TwoSystems, ShowTheWholeOrganInHalfTheWidthAndHaveNothingToComplainOf) {
  settle();
  const Bounds box = boundsOf(document().organs().front()->mesh->points);
  for (const double x : {box.low.x(), box.high.x()}) {
    const QPoint place = onScreen({x, box.center().y(), box.center().z()});
    EXPECT_TRUE(view().rect().contains(place)) << place.x() << ' ' << place.y();
  }
  EXPECT_EQ(message(), QString());
  EXPECT_EQ(second().selection().organ(), window().workspace().selection().organ());
}

TEST_F(TwoSystems, AnotherSystemIsChosenFromTheListAndShowsItsInfluence) {
  const document::HandleId handle = document().rig().handles.front().id;
  window().workspace().selection().setHandles({handle});
  EXPECT_EQ(second().selection().currentHandle(), handle);
  const Values first = window().workspace().live().influence(organ_, handle);
  const Values others = second().live().influence(organ_, handle);
  ASSERT_EQ(first.size(), others.size());
  EXPECT_GT((first - others).cwiseAbs().maxCoeff(), 1e-4);

  auto* list = window().findChild<QComboBox*>(QStringLiteral("secondSystem"));
  ASSERT_NE(list, nullptr);
  const int row = list->findData(QStringLiteral("s-celestial"));
  list->setCurrentIndex(row);
  Q_EMIT list->activated(row);
  ASSERT_TRUE(bound());
  EXPECT_EQ(second().document().system().id, "s-celestial");
  EXPECT_EQ(second().live().influence(organ_, handle), first) << "the same system in both now";
}

TEST_F(TwoSystems, StandUnderHeadingsThatCannotBeChosen) {
  const coordinates::Registry& registry = window().workspace().registry();
  app::SystemCombo list(registry);
  EXPECT_EQ(list.itemText(0), QStringLiteral("Recommended"));
  QString heading;
  std::map<std::string, QString> under;
  for (int row = 0; row < list.count(); ++row) {
    const std::string id = list.systemAt(row);
    const bool choosable = (list.model()->flags(list.model()->index(row, 0)) & Qt::ItemIsSelectable) != 0;
    EXPECT_EQ(choosable, !id.empty()) << row;
    if (id.empty())
      heading = list.itemText(row);
    else
      EXPECT_TRUE(under.insert({id, heading}).second) << id;
  }
  EXPECT_EQ(under.size(), registry.list().size());
  EXPECT_EQ(under["s-celestial"], QStringLiteral("Recommended"));
  EXPECT_EQ(under["mean-value"], QStringLiteral("With a cage"));
  EXPECT_EQ(under["bounded-biharmonic"], QStringLiteral("With tetrahedra"));
  EXPECT_EQ(under["wire-approach"], QStringLiteral("Attempts of the thesis"));
}

TEST_F(TwoSystems, TheDistanceBetweenThemColoursTheSecondView) {
  const int handle = reachableHandle();
  ASSERT_GE(handle, 0);
  const QPoint from = onScreen(handleInView(handle));
  drag(from, from + QPoint(70, 20));
  ASSERT_TRUE(bound());
  auto* button = window().findChild<QToolButton*>(QStringLiteral("differences"));
  ASSERT_NE(button, nullptr);
  const auto colored = [this] { return comparison().picture().actorOf(organ_)->scalarsShown(); };
  EXPECT_FALSE(colored());
  button->click();
  settle();
  const auto distance = [this] {
    return (points(second()) - points(window().workspace())).rowwise().norm().maxCoeff();
  };
  EXPECT_GT(distance(), 0.1);
  EXPECT_DOUBLE_EQ(comparison().differences()->greatest(), distance());
  EXPECT_TRUE(colored());
  key(Qt::Key_Z, Qt::ControlModifier);
  settle();
  EXPECT_LT(comparison().differences()->greatest(), 1e-6) << "at rest both are the organ itself";
  button->click();
  settle();
  EXPECT_FALSE(colored());
}

TEST_F(TwoSystems, HaveTheirErrorsInOneTableBesideTheDifferences) {
  auto* button = window().findChild<QToolButton*>(QStringLiteral("systemErrors"));
  ASSERT_NE(button, nullptr);
  ASSERT_EQ(button->menu()->actions().size(), 1);
  const auto cell = [&](int column, const char* row) {
    const auto* label =
        button->findChild<QLabel*>(QStringLiteral("errors/%1/%2").arg(column).arg(QLatin1String(row)));
    return label ? label->text() : QStringLiteral("no such cell");
  };
  const auto expectReportIn = [&](int column, app::Workspace& workspace) {
    const live::BindingStatus status = workspace.live().status(organ_);
    ASSERT_EQ(status.state, live::BindingStatus::State::bound);
    const coordinates::BindingReport& report = status.report;
    EXPECT_EQ(cell(column, "title"),
              app::inWords(workspace.registry().find(workspace.document().system().id)->name()));
    EXPECT_EQ(cell(column, "0"), app::formatDigits(report.identityError, 2) + QStringLiteral(" mm"));
    EXPECT_EQ(cell(column, "1"), app::formatDigits(report.unityError, 2));
    EXPECT_EQ(cell(column, "2"), app::formatDigits(report.minWeight, 2));
    EXPECT_EQ(cell(column, "3"), QString::number(report.failures.size()));
    EXPECT_EQ(cell(column, "4"), app::formatNumber(1000 * report.seconds, 1) + QStringLiteral(" ms"));
  };
  expectReportIn(0, window().workspace());
  expectReportIn(1, second());
  comparison().comparedSystem()->choose("mean-value");
  ASSERT_TRUE(bound());
  settle();
  expectReportIn(0, window().workspace());
  expectReportIn(1, second());
  EXPECT_NE(cell(0, "title"), cell(1, "title"));
  key(Qt::Key_2, Qt::ControlModifier); // Two rates: there is nothing to compare of one system.
  EXPECT_EQ(window().findChild<QToolButton*>(QStringLiteral("systemErrors")), nullptr);
}

TEST_F(TwoSystems, HaveTheSameCageAndWhatDoesNotFitItIsMendedInTheFirst) {
  auto cage = std::make_shared<geometry::TriangleMesh>(box(180, 180, 180));
  cage->points.array() -= 90;
  ASSERT_TRUE(window().workspace().perform(document::takeCage({"box.off", cage})));
  comparison().comparedSystem()->choose("green");
  ASSERT_TRUE(bound());
  EXPECT_EQ(second().document().rig().cage, document().rig().cage);
  EXPECT_EQ(second().live().status(organ_).state, live::BindingStatus::State::bound);
  auto dented = std::make_shared<geometry::TriangleMesh>(*cage);
  dented->points.row(7).setConstant(10);
  ASSERT_TRUE(window().workspace().perform(document::takeCage({"dented.off", dented})));
  ASSERT_TRUE(bound());
  EXPECT_EQ(second().live().status(organ_).state, live::BindingStatus::State::failed);
  for (auto* button : window().viewArea().messages()->findChildren<QPushButton*>())
    if (button->text() == QLatin1String("Use the hull as the cage"))
      button->click();
  EXPECT_TRUE(document().rig().cage.empty());
  EXPECT_EQ(second().document().rig(), document().rig());
}

TEST_F(TwoSystems, TheFirstViewsSystemStaysItsOwnAndOneViewIsLeft) {
  key(Qt::Key_2, Qt::ControlModifier);
  EXPECT_EQ(comparison().comparedSystem(), nullptr) << "two rates now";
  EXPECT_EQ(second().document().system().id, document().system().id);
  key(Qt::Key_3, Qt::ControlModifier);
  ASSERT_NE(comparison().comparedSystem(), nullptr);
  key(Qt::Key_1, Qt::ControlModifier);
  EXPECT_FALSE(comparison().on());
  EXPECT_EQ(document().system().id, "s-celestial");
}

} // namespace
} // namespace viscera::tests
