#include "window_test.h"

#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "atlas_window.h"
#include "screen_check.h"
#include "session_fixture.h"
#include "viscera/document/organ_commands.h"
#include "window/panels/organ_panel.h"

namespace viscera::tests {
namespace {

constexpr int kName = 1;

/// Sixteen balls with the names of organs, four in a row, as wide apart as they are large.
class ManyOrgans : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    std::vector<document::NewOrgan> organs;
    for (const char* name : {"liver", "stomach", "colon", "duodenum", "aorta", "left renal artery",
                             "right renal artery", "portal vein", "kidney_left", "kidney_right", "spleen",
                             "Lumbar1", "Lumbar2", "rib_left_1", "gluteus maximus", "label 699"}) {
      const auto at = static_cast<double>(organs.size());
      organs.push_back(ball(name, 30, 3, Vec3(120 * std::fmod(at, 4), 0, 120 * std::floor(at / 4))));
    }
    ASSERT_TRUE(window().workspace().perform(document::addOrgans(std::move(organs))));
    settle();
    key(Qt::Key_F);
    settle();
  }
  QTreeWidget& list() { return *window().findChild<QTreeWidget*>(QStringLiteral("organList")); }
  QLineEdit& search() { return *window().findChild<QLineEdit*>(QStringLiteral("organSearch")); }
  QTreeWidgetItem* row(const QString& name) {
    const auto found = list().findItems(name, Qt::MatchExactly | Qt::MatchRecursive, kName);
    EXPECT_EQ(found.size(), 1) << name.toStdString();
    return found.front();
  }
  const document::Organ& organ(const std::string& name) {
    for (const auto& one : document().organs())
      if (one->name == name)
        return *one;
    throw std::runtime_error(name);
  }
  std::vector<std::string> seen() {
    std::vector<std::string> names;
    for (const auto& one : document().organs())
      if (one->look.visible)
        names.push_back(one->name);
    return names;
  }
  QPoint placeOf(const std::string& name) {
    const Points& points = organ(name).mesh->points;
    return onScreen(points.colwise().mean().transpose());
  }
  std::size_t steps() { return window().workspace().undo().names().size(); }
};

TEST_F(ManyOrgans, StandUnderTheSystemsOfTheBodyUntilTheyAreFewAgain) {
  ASSERT_NE(row(QStringLiteral("colon"))->parent(), nullptr);
  EXPECT_EQ(row(QStringLiteral("colon"))->parent()->text(kName), QStringLiteral("Digestive system (4)"));
  EXPECT_EQ(row(QStringLiteral("aorta"))->parent()->text(kName), QStringLiteral("Arteries (3)"));
  EXPECT_EQ(row(QStringLiteral("label 699"))->parent()->text(kName), QStringLiteral("Other (1)"));
  EXPECT_TRUE(search().isVisible());
  ASSERT_TRUE(window().workspace().perform(document::renameOrgan(organ("colon").id, "vena cava")));
  EXPECT_EQ(row(QStringLiteral("vena cava"))->parent()->text(kName), QStringLiteral("Veins (2)"));
  ASSERT_TRUE(window().workspace().perform(document::removeOrgans(
      {organ("liver").id, organ("stomach").id, organ("aorta").id, organ("spleen").id})));
  EXPECT_EQ(row(QStringLiteral("vena cava"))->parent(), nullptr);
  EXPECT_FALSE(search().isVisible());
}

TEST_F(ManyOrgans, AreFoundByAPartOfTheirName) {
  key(Qt::Key_F, Qt::ControlModifier);
  QTest::keyClicks(&search(), QStringLiteral("RENAL"));
  EXPECT_FALSE(row(QStringLiteral("left renal artery"))->isHidden());
  EXPECT_TRUE(row(QStringLiteral("aorta"))->isHidden());
  EXPECT_FALSE(row(QStringLiteral("left renal artery"))->parent()->isHidden());
  EXPECT_TRUE(row(QStringLiteral("liver"))->parent()->isHidden());
  search().clear();
  EXPECT_FALSE(row(QStringLiteral("liver"))->isHidden());
}

TEST_F(ManyOrgans, ThatAreChosenAreShownAloneHiddenAndShownAgainInOneStepEach) {
  const auto all = seen();
  list().clearSelection();
  row(QStringLiteral("spleen"))->setSelected(true);
  row(QStringLiteral("liver"))->setSelected(true);
  const std::size_t before = steps();
  key(Qt::Key_I, Qt::ControlModifier);
  EXPECT_EQ(seen(), (std::vector<std::string>{"liver", "spleen"}));
  EXPECT_EQ(steps(), before + 1);
  key(Qt::Key_H, Qt::ControlModifier);
  EXPECT_TRUE(seen().empty());
  key(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(seen(), all);
  for (int step = 0; step < 3; ++step)
    key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(seen(), all);
}

/// Beside each name is its square; numbers come back as soon as the panel has room for both.
TEST_F(ManyOrgans, HaveTheirWholeNamesAndNumbersWhereThereIsRoom) {
  constexpr int kVolume = 2;
  constexpr int kSquare = 24;
  ASSERT_TRUE(window().workspace().perform(
      document::renameOrgan(organ("left renal artery").id, "inferior mesenteric artery")));
  settle();
  for (const auto& one : document().organs()) {
    QTreeWidgetItem* item = row(QString::fromStdString(one->name));
    const QModelIndex place =
        list().model()->index(item->parent()->indexOfChild(item), kName,
                              list().model()->index(list().indexOfTopLevelItem(item->parent()), 0));
    EXPECT_GE(list().visualRect(place).width(),
              kSquare + list().fontMetrics().horizontalAdvance(item->text(kName)))
        << one->name;
  }
  EXPECT_TRUE(list().isColumnHidden(kVolume));
  auto* dock = window().findChild<QDockWidget*>(QStringLiteral("organs"));
  window().resizeDocks({dock}, {460}, Qt::Horizontal);
  settle();
  EXPECT_FALSE(list().isColumnHidden(kVolume));
}

TEST_F(ManyOrgans, OfASystemAreHiddenByItsEye) {
  QTreeWidgetItem* arteries = row(QStringLiteral("aorta"))->parent();
  list().scrollToItem(arteries);
  const QRect eye = list().visualRect(list().model()->index(list().indexOfTopLevelItem(arteries), 0));
  QTest::mouseClick(list().viewport(), Qt::LeftButton, Qt::NoModifier, eye.center());
  EXPECT_FALSE(organ("aorta").look.visible);
  EXPECT_FALSE(organ("right renal artery").look.visible);
  EXPECT_TRUE(organ("liver").look.visible);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(seen().size(), 16u);
}

TEST_F(ManyOrgans, ChoosingASystemChoosesItsOrgans) {
  list().clearSelection();
  row(QStringLiteral("aorta"))->parent()->setSelected(true); // The whole system.
  auto* panel = window().findChild<app::OrganPanel*>();
  ASSERT_NE(panel, nullptr);
  EXPECT_EQ(panel->chosen().size(), 3u);
}

TEST_F(ManyOrgans, ADoubleClickInTheViewShowsOneAloneAndAnotherOneAll) {
  const QPoint place = placeOf("spleen");
  QTest::mouseDClick(&view(), Qt::LeftButton, Qt::NoModifier, place);
  settle();
  EXPECT_EQ(seen(), (std::vector<std::string>{"spleen"}));
  QTest::mouseDClick(&view(), Qt::LeftButton, Qt::NoModifier, place);
  settle();
  EXPECT_EQ(seen().size(), 16u);
}

TEST_F(ManyOrgans, TheNameOfTheOrganUnderTheMouseIsShownAndLeavesWithIt) {
  auto* name = window().findChild<QLabel*>(QStringLiteral("organUnderCursor"));
  ASSERT_NE(name, nullptr);
  QTest::mouseMove(&view(), placeOf("kidney_left") + QPoint(3, 3));
  QTest::mouseMove(&view(), placeOf("kidney_left"));
  ASSERT_TRUE(waitUntil([&] { return name->isVisible(); }));
  EXPECT_EQ(name->text(), QStringLiteral("kidney_left"));
  QTest::mouseMove(&view(), QPoint(4, 4));
  EXPECT_TRUE(waitUntil([&] { return !name->isVisible(); }));
}

class Atlas : public AtlasWindow {};

TEST_F(Atlas, IsSearchedIsolatedDeformedUnderALockAndShownWholeAgain) {
  if (!std::filesystem::exists(file()))
    GTEST_SKIP() << "shared/organs/abdomen_seg.nrrd is absent";
  import();
  ASSERT_EQ(document().organs().size(), 95u) << message().toStdString();
  EXPECT_GT(seenArriving(), 0u) << "they come one after the other";
  EXPECT_EQ(visible(), 95);
  find();
  settle();
  EXPECT_FALSE(row("liver")->isHidden());
  EXPECT_TRUE(row("spleen")->isHidden());
  choose();
  isolate();
  settle();
  EXPECT_EQ(visible(), 3);
  surround();
  settle();
  ASSERT_GE(document().rig().handles.size(), 8u);
  lock();
  settle();
  const document::OrganId liver = organ("liver").id;
  ASSERT_TRUE(organ("liver").volumeLocked);
  const double rest = window().workspace().live().volume(liver).nowMl;
  const QPoint by(30, -20);
  grab();
  move(by);
  settle();
  release(by);
  settle();
  EXPECT_NE(document().pose(), document().rig().restPositions());
  EXPECT_NEAR(window().workspace().live().volume(liver).nowMl, rest, 1e-6 * rest);
  showAll();
  settle();
  EXPECT_EQ(visible(), 95);
  key(Qt::Key_1);
  window().resize(1600, 1000);
  settle();
  expectScreen(window().grab().toImage(), "atlas");
  EXPECT_EQ(message(), QString());
}

TEST_F(ManyOrgans, FocusShowsWhatWasHidden) {
  window().workspace().selection().setOrgan(organ("Lumbar1").id);
  key(Qt::Key_H, Qt::ControlModifier);
  ASSERT_FALSE(organ("Lumbar1").look.visible);
  key(Qt::Key_F);
  EXPECT_TRUE(organ("Lumbar1").look.visible);
}

TEST_F(ManyOrgans, SearchLooksAtTheNamesThatAreShownAndGoesWithItsField) {
  window().workspace().perform(document::renameOrgan(organ("liver").id, "LV cavity"));
  settle();
  search().setText(QStringLiteral("cavit"));
  int shown = 0;
  for (QTreeWidgetItemIterator it(&list()); *it; ++it)
    if (!(*it)->isHidden() && (*it)->childCount() == 0)
      ++shown;
  EXPECT_EQ(shown, 1);
  std::vector<document::OrganId> gone;
  for (const auto& one : document().organs())
    if (one->name != "spleen")
      gone.push_back(one->id);
  ASSERT_TRUE(window().workspace().perform(document::removeOrgans(gone)));
  settle();
  EXPECT_FALSE(search().isVisible());
  EXPECT_FALSE(row(QStringLiteral("spleen"))->isHidden()) << "by a field that nobody sees";
}

} // namespace
} // namespace viscera::tests
