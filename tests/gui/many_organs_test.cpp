#include "window_test.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include <algorithm>

#include "atlas_window.h"
#include "many_organs.h"
#include "screen_check.h"
#include "viscera/anatomy/part.h"
#include "viscera/document/organ_commands.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/organs/organ_panel.h"
#include "window/view/picture.h"
#include "window/widgets/value_slider.h"

namespace viscera::tests {
namespace {

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

TEST_F(ManyOrgans, DeleteTakesTheChosenRowsAndNotTheHandlesBehindThem) {
  ASSERT_TRUE(window().workspace().perform(document::addEnclosingHandles()));
  key(Qt::Key_2);
  settle();
  window().workspace().selection().setHandles({document().rig().handles.front().id});
  list().setFocus();
  list().setCurrentItem(row(QStringLiteral("spleen")));
  const std::size_t organs = document().organs().size(), handles = document().rig().handles.size();
  QTest::keyClick(&list(), Qt::Key_Delete);
  settle();
  EXPECT_EQ(document().organs().size(), organs - 1);
  EXPECT_THROW(organ("spleen"), std::runtime_error) << "it is still there";
  EXPECT_EQ(document().rig().handles.size(), handles);
}

TEST_F(ManyOrgans, ThatAreRemovedAreCountedInANoteThatOffersToUndo) {
  ASSERT_TRUE(window().workspace().perform(document::addEnclosingHandles()));
  settle();
  list().setFocus();
  choose({QStringLiteral("spleen"), QStringLiteral("liver"), QStringLiteral("aorta")});
  QTest::keyClick(&list(), Qt::Key_Delete);
  EXPECT_EQ(message(), QStringLiteral("3 organs removed"));
  window().workspace().perform(document::renameOrgan(organ("colon").id, "bowel"));
  EXPECT_EQ(message(), QString()) << "Undo would take back the new name";
  list().selectAll();
  QTest::keyClick(&list(), Qt::Key_Delete);
  EXPECT_TRUE(document().organs().empty());
  EXPECT_EQ(message(), QStringLiteral("13 organs and all handles removed"));
  auto* undo = window().viewArea().messages()->findChild<QPushButton*>(QStringLiteral("offer"));
  ASSERT_NE(undo, nullptr);
  undo->click();
  settle();
  EXPECT_EQ(document().organs().size(), 13u);
  EXPECT_FALSE(document().rig().handles.empty());
}

TEST_F(ManyOrgans, ThatMoveTogetherComeIntoThePictureTogether) {
  ASSERT_TRUE(window().workspace().perform(document::addEnclosingHandles()));
  key(Qt::Key_3);
  int pictures = 0;
  const auto counting =
      QObject::connect(&window().picture(), &app::Picture::changed, [&pictures] { ++pictures; });
  Points pose = document().pose();
  pose.row(0) *= 1.1;
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  handleEvents();
  QObject::disconnect(counting);
  EXPECT_EQ(pictures, 1) << "not once for each of sixteen organs";
}

TEST_F(ManyOrgans, AreDescribedOnlyWhereOneIsSelected) {
  const auto& name = find<QLabel>("exploreOrgan");
  document::Selection& selection = window().workspace().selection();
  selection.clear();
  EXPECT_EQ(name.text(), QStringLiteral("none selected"));
  EXPECT_TRUE(find<QLabel>("exploreRemarks").text().contains(QStringLiteral("Select an organ")));
  selection.setOrgan(organ("spleen").id);
  EXPECT_EQ(name.text(), QStringLiteral("Spleen"));
  EXPECT_TRUE(find<QLabel>("exploreRemarks").isHidden());
  selection.clear();
  key(Qt::Key_2);
  EXPECT_EQ(find<QLabel>("boundOrgan").text(), QStringLiteral("Liver")) << "whose binding it tells of";
  std::vector<document::OrganId> others;
  for (const auto& one : document().organs())
    if (one->name != "spleen")
      others.push_back(one->id);
  ASSERT_TRUE(window().workspace().perform(document::removeOrgans(others)));
  EXPECT_EQ(name.text(), QStringLiteral("Spleen")) << "no other can be meant";
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

TEST_F(ManyOrgans, ThatComeDuringASearchAreFoundByIt) {
  search().setText(QStringLiteral("renal"));
  ASSERT_TRUE(window().workspace().perform(document::addOrgans({ball("left renal vein", 30, 3)})));
  settle();
  EXPECT_FALSE(row(QStringLiteral("left renal vein"))->isHidden());
  EXPECT_FALSE(row(QStringLiteral("left renal artery"))->isHidden());
  EXPECT_TRUE(row(QStringLiteral("liver"))->isHidden());
}

TEST_F(ManyOrgans, ASearchIsLedOnByKeys) {
  for (const auto next : {Qt::Key_Return, Qt::Key_Down}) {
    list().setCurrentItem(row(QStringLiteral("liver")));
    key(Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(&search(), QStringLiteral("renal"));
    EXPECT_EQ(row(QStringLiteral("aorta"))->parent()->text(kName), QStringLiteral("Arteries (2 of 3)"));
    QTest::keyClick(&search(), next);
    EXPECT_EQ(window().workspace().selection().organ(), organ("left renal artery").id);
    EXPECT_TRUE(list().hasFocus());
    search().setFocus();
    QTest::keyClick(&search(), Qt::Key_Escape);
    EXPECT_EQ(search().text(), QString());
    EXPECT_EQ(row(QStringLiteral("aorta"))->parent()->text(kName), QStringLiteral("Arteries (3)"));
  }
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
  EXPECT_EQ(name->text(), QStringLiteral("Left kidney"));
  QTest::mouseMove(&view(), QPoint(4, 4));
  EXPECT_TRUE(waitUntil([&] { return !name->isVisible(); }));
}

/// What was under the mouse is hidden by a key: no name stands over nothing.
TEST_F(ManyOrgans, TheNameUnderTheMouseLeavesWithTheOrganAndStaysOfWhatIsThere) {
  auto& name = find<QLabel>("organUnderCursor");
  QTest::mouseMove(&view(), placeOf("kidney_left") + QPoint(3, 3));
  QTest::mouseMove(&view(), placeOf("kidney_left"));
  ASSERT_TRUE(waitUntil([&] { return name.isVisible(); }));
  window().workspace().selection().setOrgan(organ("kidney_left").id);
  key(Qt::Key_H, Qt::ControlModifier);
  QTest::qWait(300); // Longer than the mouse has to rest.
  EXPECT_FALSE(name.isVisible()) << "over " << name.text().toStdString();
  key(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(waitUntil([&] { return name.isVisible(); })) << "it is there again, and so is the mouse";
  window().workspace().perform(document::renameOrgan(organ("kidney_left").id, "renal"));
  EXPECT_TRUE(waitUntil([&] { return name.isVisible() && name.text() == QLatin1String("Renal"); }));
  window().setMode("handles");
  EXPECT_FALSE(name.isVisible()) << "another mode may show it elsewhere";
}

TEST_F(ManyOrgans, TheHandlesOfTheOrganUnderTheMouseStandOut) {
  std::vector<document::NewHandle> handlesBeside;
  for (const auto& organ : document().organs())
    handlesBeside.push_back({boundsOf(organ->mesh->points).low - Vec3(2, 2, 2)});
  ASSERT_TRUE(window().workspace().perform(document::addHandles(std::move(handlesBeside))));
  key(Qt::Key_3);
  settle();
  auto* handles = window().picture().view().handles();
  ASSERT_GT(handles->GetNumberOfHandles(), 0);
  const auto inBackground = [handles] {
    int count = 0;
    for (int row = 0; row < handles->GetNumberOfHandles(); ++row)
      count += handles->GetHandleInBackground(row) ? 1 : 0;
    return count;
  };
  EXPECT_EQ(inBackground(), 0);
  QTest::mouseMove(&view(), placeOf("kidney_left") + QPoint(3, 3));
  QTest::mouseMove(&view(), placeOf("kidney_left"));
  EXPECT_TRUE(waitUntil([&] { return inBackground() == 15; }));
  QTest::mouseMove(&view(), QPoint(4, 4));
  EXPECT_TRUE(waitUntil([&] { return inBackground() == 0; }));
}

/// Ctrl+A chooses the rows of the systems, too, in which there are others that the search hides.
TEST_F(ManyOrgans, ThatTheSearchHidesAreLeftAlone) {
  search().setText(QStringLiteral("artery"));
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_A, Qt::ControlModifier);
  const auto& panel = *window().findChild<app::OrganPanel*>();
  EXPECT_EQ(panel.chosen(),
            (std::vector<document::OrganId>{organ("left renal artery").id, organ("right renal artery").id}));
  key(Qt::Key_H, Qt::ControlModifier);
  EXPECT_TRUE(organ("aorta").look.visible);
  EXPECT_FALSE(organ("left renal artery").look.visible);
  window().actions()["organ.remove"]->trigger();
  settle();
  EXPECT_EQ(document().organs().size(), 14u);
  EXPECT_NO_THROW(organ("aorta"));
}

TEST_F(ManyOrgans, TheSquareOfACavityIsClickedWhereItIs) {
  document::NewOrgan cavity = ball("hollow", 10, 2);
  cavity.organ.parent = organ("kidney_left").id;
  ASSERT_TRUE(window().workspace().perform(document::addOrgans({cavity})));
  settle();
  constexpr int kInSquare = 20; // Near its right edge.
  for (const char* name : {"kidney_left", "hollow"}) {
    const QRect place = nameOf(row(QString::fromLatin1(name)));
    const QPoint square(place.left() + kInSquare, place.center().y());
    QTest::mouseMove(list().viewport(), square);
    QTest::mouseClick(list().viewport(), Qt::LeftButton, Qt::NoModifier, square);
    QWidget* palette = QApplication::activePopupWidget();
    EXPECT_NE(palette, nullptr) << name;
    if (palette)
      palette->close();
  }
  const QRect place = nameOf(row(QStringLiteral("hollow")));
  const QPoint before(place.left() - 4, place.center().y());
  QTest::mouseMove(list().viewport(), before);
  QTest::mouseClick(list().viewport(), Qt::LeftButton, Qt::NoModifier, before);
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr) << "no square is there";
}

TEST_F(ManyOrgans, ThatAreChosenGetOneColourInOneStep) {
  choose({QStringLiteral("spleen"), QStringLiteral("liver")});
  const std::size_t before = steps();
  const Vec3 aorta = organ("aorta").look.color, spleen = organ("spleen").look.color,
             liver = organ("liver").look.color;
  find<QAction>("organColor").trigger();
  QWidget* palette = QApplication::activePopupWidget();
  ASSERT_NE(palette, nullptr);
  palette->findChildren<QToolButton*>().back()->click();
  settle();
  EXPECT_NE(organ("spleen").look.color, spleen);
  EXPECT_EQ(organ("spleen").look.color, organ("liver").look.color);
  EXPECT_EQ(organ("aorta").look.color, aorta);
  EXPECT_EQ(steps(), before + 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(organ("spleen").look.color, spleen);
  EXPECT_EQ(organ("liver").look.color, liver);
}

TEST_F(ManyOrgans, ThatAreChosenGetOneOpacityInOneStep) {
  choose({QStringLiteral("spleen"), QStringLiteral("liver")});
  const std::size_t before = steps();
  auto& opacity = find<app::ValueSlider>("opacity");
  auto& slider = *opacity.findChild<QSlider*>();
  const double old = organ("aorta").look.opacity;
  slider.setSliderDown(true);
  for (const int percent : {80, 60, 35})
    slider.setValue(percent);
  slider.setSliderDown(false);
  settle();
  EXPECT_DOUBLE_EQ(organ("spleen").look.opacity, 0.35);
  EXPECT_DOUBLE_EQ(organ("liver").look.opacity, 0.35);
  EXPECT_DOUBLE_EQ(organ("aorta").look.opacity, old);
  EXPECT_EQ(steps(), before + 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_DOUBLE_EQ(organ("spleen").look.opacity, old);
  EXPECT_DOUBLE_EQ(organ("liver").look.opacity, old);
}

TEST_F(ManyOrgans, ThatAreChosenAreLockedAndUnlockedInOneStepEach) {
  choose({QStringLiteral("spleen"), QStringLiteral("liver")});
  const std::size_t before = steps();
  QAction& lock = *window().actions()["volume.lock"];
  lock.trigger();
  EXPECT_TRUE(organ("spleen").volumeLocked);
  EXPECT_TRUE(organ("liver").volumeLocked);
  EXPECT_FALSE(organ("aorta").volumeLocked);
  EXPECT_EQ(steps(), before + 1);
  EXPECT_TRUE(lock.isChecked());
  row(QStringLiteral("aorta"))->setSelected(true);
  EXPECT_FALSE(lock.isChecked()) << "not all of them";
  lock.trigger();
  EXPECT_TRUE(organ("aorta").volumeLocked);
  lock.trigger();
  EXPECT_FALSE(organ("spleen").volumeLocked);
  EXPECT_FALSE(organ("aorta").volumeLocked);
}

/// Tables of label maps often have colours by number.
TEST_F(ManyOrgans, ThatAreChosenGetTheColoursOfTextbooksInOneStep) {
  choose({QStringLiteral("spleen"), QStringLiteral("liver"), QStringLiteral("label 699")});
  document::OrganLook green = organ("liver").look;
  const Vec3 unknown = organ("label 699").look.color;
  green.color = Vec3(0, 1, 0);
  ASSERT_TRUE(window().workspace().perform(document::setOrganLook(organ("liver").id, green)));
  const std::size_t done = steps();
  find<QAction>("organTextbookColors").trigger();
  EXPECT_EQ(organ("liver").look.color, *anatomy::colorNamed("liver"));
  EXPECT_EQ(organ("spleen").look.color, *anatomy::colorNamed("spleen"));
  EXPECT_EQ(organ("label 699").look.color, unknown);
  EXPECT_EQ(steps(), done + 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(organ("liver").look.color, green.color);
}

TEST_F(ManyOrgans, TheMenuInTheViewHasWhatTheListHas) {
  QTest::mouseClick(&view(), Qt::RightButton, Qt::NoModifier, placeOf("spleen"));
  auto& menu = find<QMenu>("organMenu");
  ASSERT_TRUE(menu.isVisible());
  EXPECT_EQ(window().workspace().selection().organ(), organ("spleen").id);
  for (QAction* action :
       {&find<QAction>("organColor"), window().actions()["volume.lock"], window().actions()["organ.remove"]})
    EXPECT_TRUE(menu.actions().contains(action) && action->isVisible() && action->isEnabled())
        << action->text().toStdString();
  EXPECT_FALSE(find<QAction>("organOwnColors").isVisible()) << "its file had none";
  menu.close();
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

TEST_F(ManyOrgans, FocusOnOneThatAnotherHidesOffersToShowItAlone) {
  const Vec3 middle = organ("spleen").mesh->points.colwise().mean().transpose();
  document::NewOrgan wall = ball("wall", 45, 3, middle);
  wall.organ.look.opacity = 0.5;
  ASSERT_TRUE(window().workspace().perform(document::addOrgans({wall})));
  window().workspace().selection().setOrgan(organ("spleen").id);
  key(Qt::Key_F);
  EXPECT_EQ(message(), QString()) << "it is seen through the other one";
  document::OrganLook look = organ("wall").look;
  look.opacity = 1;
  ASSERT_TRUE(window().workspace().perform(document::setOrganLook(organ("wall").id, look)));
  key(Qt::Key_F);
  EXPECT_EQ(message(), QStringLiteral("Spleen is hidden behind Wall."));
  auto* offer = window().viewArea().messages()->findChild<QPushButton*>(QStringLiteral("offer"));
  ASSERT_NE(offer, nullptr);
  offer->click();
  settle();
  EXPECT_EQ(seen(), (std::vector<std::string>{"spleen"}));
  key(Qt::Key_F);
  EXPECT_EQ(message(), QString());
}

TEST_F(ManyOrgans, AreNamedWhereTheyAreSeenAndNotThroughAnOpaqueOne) {
  const auto named = [this](const std::string& name) {
    settle();
    const auto drawn = window().picture().presenter().labels().drawn();
    return std::any_of(drawn.begin(), drawn.end(), [&](const auto& label) { return label.text == name; });
  };
  std::vector<document::OrganId> others;
  for (const auto& one : document().organs())
    if (one->name != "spleen" && one->name != "liver")
      others.push_back(one->id);
  ASSERT_TRUE(window().workspace().perform(document::removeOrgans(others)));
  const Vec3 middle = organ("spleen").mesh->points.colwise().mean().transpose();
  document::NewOrgan wall = ball("wall", 45, 5, middle);
  ASSERT_TRUE(window().workspace().perform(document::addOrgans({wall})));
  key(Qt::Key_N);
  EXPECT_TRUE(named("Wall"));
  EXPECT_TRUE(named("Liver"));
  EXPECT_FALSE(named("Spleen")) << "a line would end on the wall";
  document::OrganLook look = organ("wall").look;
  look.opacity = 0.4;
  ASSERT_TRUE(window().workspace().perform(document::setOrganLook(organ("wall").id, look)));
  EXPECT_TRUE(named("Spleen"));
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
