#include "window_test.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>

#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "viscera/sequences/keyframes.h"
#include "window/import/import_controller.h"
#include "window/key_sequence/fit_box.h"
#include "window/key_sequence/key_box.h"
#include "window/play/play_mode.h"
#include "window/widgets/page.h"

#include "beating_labels.h"
#include "session_fixture.h"
#include "shapes.h"

namespace viscera::tests {
namespace {

/// A ball with handles that a user has opened, in Play mode with all parts of the page open.
class OwnMotion : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    key(Qt::Key_5);
    for (app::CollapsibleSection* fold : window().findChildren<app::CollapsibleSection*>())
      fold->setOpen(true);
    settle();
  }
  void press(const char* name) {
    QTest::mouseClick(&find<QAbstractButton>(name), Qt::LeftButton);
    settle();
  }
  /// Moves all handles, as Deform mode does.
  void pose(double factor) {
    std::vector<document::HandleId> all;
    for (const document::Handle& handle : document().rig().handles)
      all.push_back(handle.id);
    ASSERT_TRUE(
        window().workspace().perform(document::moveHandles(all, factor * document().rig().restPositions())));
    settle();
  }
  const document::KeySequence& keySequence() { return document().keySequence(); }
  double volume() { return window().workspace().live().volume(document().organs().front()->id).nowMl; }
};

TEST_F(OwnMotion, KeysOfPosesBecomeASequenceThatPlays) {
  const double rest = volume();
  key(Qt::Key_K, Qt::ControlModifier);
  pose(1.2);
  key(Qt::Key_K, Qt::ControlModifier);
  ASSERT_EQ(keySequence().keys.size(), 2u);
  EXPECT_EQ(keySequence().keys[1].seconds, 0.5);
  EXPECT_EQ(find<QTableWidget>("keyTable").rowCount(), 2);
  ASSERT_NE(window().playback().sequence(), nullptr);
  press("playKeys");
  EXPECT_TRUE(window().playback().player().playing());
  now_ += 0.5;
  window().playback().advance();
  EXPECT_NEAR(volume() / rest, 1.2 * 1.2 * 1.2, 1e-6) << "at its key's time the pose is that key's";
  window().playback().pause();
  window().playback().seek(0);
  EXPECT_NEAR(volume() / rest, 1, 1e-6);
}

TEST_F(OwnMotion, TheChartOfDragsFollowsPosesThatComeAndGoBesideIt) {
  const sequences::VolumeRecord& drags = window().volumes().drags();
  const auto last = [&] { return drags.milliliters(drags.rows() - 1, 0); };
  key(Qt::Key_3);
  pose(1.1);
  const std::size_t rows = drags.rows();
  ASSERT_EQ(rows, 2u);
  key(Qt::Key_5);
  key(Qt::Key_K, Qt::ControlModifier);
  ASSERT_NE(window().playback().sequence(), nullptr);
  pose(1.2); // The motion is not played yet: this pose is seen.
  EXPECT_EQ(drags.rows(), rows + 1);
  EXPECT_NEAR(last(), volume(), 1e-9);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(drags.rows(), rows + 2);
  EXPECT_NEAR(last(), volume(), 1e-9) << "undo is in the chart";
  const double before = last();
  pose(1.2);
  key(Qt::Key_K, Qt::ControlModifier);
  press("playKeys");
  ASSERT_TRUE(window().playback().showing());
  pose(0.9);
  EXPECT_EQ(drags.rows(), rows + 3) << "what is seen is the sequence";
  key(Qt::Key_3);
  EXPECT_EQ(drags.rows(), rows + 4) << "and now it is the pose";
  EXPECT_NEAR(last(), volume(), 1e-9);
  EXPECT_LT(last(), 0.8 * before);
}

TEST_F(OwnMotion, StandsAmongTheSequencesWithoutHidingOthers) {
  key(Qt::Key_K, Qt::ControlModifier);
  pose(1.2);
  key(Qt::Key_K, Qt::ControlModifier);
  auto& list = find<QListWidget>("sequenceList");
  ASSERT_EQ(list.count(), 4);
  for (int row = 0; row < list.count(); ++row)
    EXPECT_TRUE(list.viewport()->rect().contains(list.visualItemRect(list.item(row)).center()))
        << list.item(row)->text().toStdString();
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  settle();
  ASSERT_EQ(list.count(), 3);
  EXPECT_LT(list.height(), 2 * list.gridSize().height());
}

TEST_F(OwnMotion, EveryChangeOfAKeyIsOneStepThatUndoTakesBack) {
  key(Qt::Key_K, Qt::ControlModifier);
  pose(1.1);
  key(Qt::Key_K, Qt::ControlModifier);
  auto& table = find<QTableWidget>("keyTable");
  table.item(1, 0)->setText(QStringLiteral("0.8"));
  settle();
  EXPECT_EQ(keySequence().keys[1].seconds, 0.8);
  auto* easing = qobject_cast<QComboBox*>(table.cellWidget(0, 1));
  ASSERT_NE(easing, nullptr);
  easing->setCurrentIndex(1);
  Q_EMIT easing->activated(1);
  settle();
  EXPECT_EQ(keySequence().keys[0].easing, sequences::Easing::linear);
  table.selectRow(1);
  press("removeKey");
  EXPECT_EQ(keySequence().keys.size(), 1u);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(keySequence().keys.size(), 2u);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(keySequence().keys[0].easing, sequences::Easing::smooth);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(keySequence().keys[1].seconds, 0.5);
  table.item(1, 0)->setText(QStringLiteral("never"));
  settle();
  EXPECT_EQ(keySequence().keys[1].seconds, 0.5) << "what is not a time changes nothing";
}

TEST_F(OwnMotion, TheViewTellsOfAKeyOnlyWhileItIsThere) {
  const auto& badge = find<QLabel>("viewBadge");
  window().viewArea().messages()->dismiss();
  // Without waiting, since it fades by itself.
  QTest::keyClick(&window(), Qt::Key_K, Qt::ControlModifier);
  EXPECT_EQ(badge.text(), QStringLiteral("Key at 0.00 s"));
  EXPECT_FALSE(badge.isHidden());
  window().workspace().undo().undo();
  EXPECT_TRUE(badge.isHidden()) << "the key is gone";
  QTest::keyClick(&window(), Qt::Key_K, Qt::ControlModifier);
  EXPECT_FALSE(badge.isHidden());
  ASSERT_TRUE(window().workspace().perform(document::moveKey(keySequence().keys.front().id, 0.2)));
  EXPECT_TRUE(badge.isHidden()) << "it is at another time";
}

TEST_F(OwnMotion, AKeysPoseComesBackForChangingAndTheFileHoldsItAll) {
  key(Qt::Key_K, Qt::ControlModifier);
  pose(1.2);
  key(Qt::Key_K, Qt::ControlModifier);
  auto& table = find<QTableWidget>("keyTable");
  table.selectRow(0);
  press("takeKey");
  EXPECT_TRUE(document::atRest(document().state()));
  pose(0.9);
  table.selectRow(0);
  press("replaceKey");
  const document::KeySequence saved = keySequence();
  const QString file = path(QStringLiteral("mine.sequence.json"));
  window().play().keySequence().save(file);
  ASSERT_TRUE(QFile::exists(file)) << message().toStdString();
  for (int steps = 0; steps < 2; ++steps) {
    table.selectRow(0);
    press("removeKey");
  }
  EXPECT_TRUE(keySequence().keys.empty());
  EXPECT_EQ(window().playback().sequence(), nullptr);
  window().play().keySequence().open(file);
  settle();
  ASSERT_EQ(keySequence().keys.size(), 2u) << message().toStdString();
  EXPECT_EQ(keySequence().keys[0].displacements, saved.keys[0].displacements);
  EXPECT_NE(window().playback().sequence(), nullptr);
}

TEST_F(OwnMotion, APatientsOrganBreathesAndLandmarksAreClickedInTheView) {
  auto& sequence = find<QComboBox>("fitSequence");
  sequence.setCurrentIndex(0);
  Q_EMIT sequence.activated(0);
  press("landmark_apex");
  EXPECT_TRUE(view().hasClickHandler());
  click(QPoint(view().width() / 2, view().height() / 2));
  EXPECT_FALSE(view().hasClickHandler()) << "a double click shows one organ alone again";
  const auto& fit = find<app::FitBox>("fitBox");
  ASSERT_NE(fit.landmarks().find("apex"), nullptr);
  EXPECT_NEAR(fit.landmarks().find("apex")->position.norm(), 60, 1.5) << "the click is on the ball";
  ASSERT_EQ(fit.glyphs().items().size(), 1u);
  EXPECT_EQ(fit.glyphs().items()[0].text, "Apex");
  const Vec3 apex = fit.landmarks().find("apex")->position;
  pose(1.5);
  EXPECT_LT((fit.glyphs().items()[0].points[0] - 1.5 * apex).norm(), 2) << "it follows the organ";
  EXPECT_EQ(fit.landmarks().find("apex")->position, apex) << "and is a place of the organ at rest";
  key(Qt::Key_4);
  EXPECT_TRUE(fit.glyphs().items().empty()) << "it leaves with the mode";
  key(Qt::Key_5);
  EXPECT_EQ(fit.glyphs().items().size(), 1u);
  key(Qt::Key_Z, Qt::ControlModifier);
  const int breathing = sequence.findText(QStringLiteral("Breathing"));
  ASSERT_GE(breathing, 0);
  sequence.setCurrentIndex(breathing);
  Q_EMIT sequence.activated(breathing);
  const std::size_t steps = window().workspace().undo().position();
  press("fitButton");
  ASSERT_TRUE(waitUntil([this] { return window().playback().player().playing(); }))
      << message().toStdString();
  EXPECT_EQ(window().workspace().undo().position(), steps + 1) << "the fit is one step";
  settle();
  const double rest = volume();
  window().playback().seek(0.5);
  EXPECT_NEAR(volume(), rest, 1e-6 * rest) << "breathing keeps the volume";
  const Points& points = window().workspace().live().points(document().organs().front()->id);
  EXPECT_LT(boundsOf(points).center().z(), -5) << "and moves the organ down";
}

/// Labels of a heart come in as one organ with cavities, which the textbook's beat moves, too.
TEST_F(OwnMotion, AHeartBeatsWithItsChambersByTheEjectionFractionThatIsAskedFor) {
  key(Qt::Key_N, Qt::ControlModifier);
  const auto& ejection = find<QDoubleSpinBox>("fitEjection");
  EXPECT_FALSE(ejection.isVisible()) << "there is no heart";
  QFile file(path(QStringLiteral("heart.seg.nrrd")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  const std::string labels = nrrdFile(beatingLabels(0, Vec3(4, 4, 4)), "right-anterior-superior", kHeartKeys);
  file.write(labels.data(), static_cast<qint64>(labels.size()));
  file.close();
  open(file.fileName());
  window().imports().accept(); // Nobody has so small a heart.
  settle();
  key(Qt::Key_5);
  ASSERT_EQ(document().organs().size(), 3u) << message().toStdString();
  const auto heart = document().organs()[0], left = document().organs()[1];
  EXPECT_EQ(heart->name, "Heart");
  EXPECT_EQ(left->parent, heart->id);
  window().workspace().selection().setOrgan(left->id);
  settle();
  EXPECT_EQ(find<QComboBox>("fitSequence").currentData(), QStringLiteral("heartbeat"));
  ASSERT_TRUE(ejection.isVisible()) << "a chamber is of its heart";
  find<QDoubleSpinBox>("fitEjection").setValue(30);
  const std::size_t steps = window().workspace().undo().position();
  press("fitButton");
  ASSERT_TRUE(waitUntil([this] { return window().playback().player().playing(); }))
      << message().toStdString();
  settle();
  EXPECT_EQ(window().workspace().undo().position(), steps + 1) << "the fit is one step";
  EXPECT_EQ(document().organs()[0], heart) << "no organ is replaced";
  ASSERT_FALSE(keySequence().keys.empty()) << "saved and edited as any key sequence";
  const auto leftMl = [&] { return window().workspace().live().volume(left->id).nowMl; };
  window().playback().seek(0);
  const double full = leftMl();
  double least = full;
  for (const document::SequenceKey& key : keySequence().keys) {
    window().playback().seek(key.seconds / keySequence().periodSeconds);
    least = std::min(least, leftMl());
  }
  EXPECT_NEAR(1 - least / full, 0.30, 0.02);
  key(Qt::Key_Z, Qt::ControlModifier);
  settle();
  EXPECT_TRUE(keySequence().keys.empty());
  EXPECT_EQ(document().organs().size(), 3u);
}

class SequencesThatFit : public OwnMotion {
protected:
  QString firstOffered() { return find<QListWidget>("sequenceList").item(0)->data(Qt::UserRole).toString(); }
  bool standsOut(const char* button) { return find<QAbstractButton>(button).property("primary").toBool(); }
};

TEST_F(SequencesThatFit, APatientsOrganIsAskedForAndNotReplaced) {
  key(Qt::Key_N, Qt::ControlModifier);
  open(sphereFile(QStringLiteral("liver.stl"), 70));
  key(Qt::Key_5);
  EXPECT_EQ(firstOffered(), QStringLiteral("breathing"));
  EXPECT_EQ(find<QComboBox>("fitSequence").currentData(), QStringLiteral("breathing"));
  const document::OrganId liver = document().organs().front()->id;
  EXPECT_FALSE(find<QTableWidget>("cycleTable").isVisible()) << "there is no cycle yet";
  chooseSequence("breathing");
  EXPECT_TRUE(find<QAbstractButton>("offerFit").isVisible());
  EXPECT_TRUE(standsOut("offerFit"));
  ASSERT_NE(document().organ(liver), nullptr) << "nothing happens before the answer";
  press("offerFit");
  ASSERT_TRUE(waitUntil([this] { return window().playback().player().playing(); }))
      << message().toStdString();
  ASSERT_NE(document().organ(liver), nullptr);
  EXPECT_EQ(document().organs().size(), 1u);
  EXPECT_FALSE(find<QAbstractButton>("offerFit").isVisible());
  chooseSequence("breathing");
  EXPECT_FALSE(find<QAbstractButton>("offerFit").isVisible()) << "it has that motion";
  EXPECT_FALSE(find<QLabel>("ejectionFraction").isVisible()) << "a liver ejects nothing";
  EXPECT_FALSE(find<QLabel>("cardiacOutput").isVisible());
  EXPECT_TRUE(find<QTableWidget>("cycleTable").isVisible());
}

/// More handles around the others would not be those of the motion any more.
TEST_F(SequencesThatFit, AnOrganBeyondTheHandlesOfAMotionIsSaidToStayWithoutARemedyThatStopsIt) {
  key(Qt::Key_N, Qt::ControlModifier);
  open(sphereFile(QStringLiteral("liver.stl"), 70));
  const document::OrganId liver = document().organs().front()->id;
  ASSERT_TRUE(window().workspace().perform(document::addOrgans({ball("spleen", 40, 2, Vec3(400, 0, 0))})));
  key(Qt::Key_5);
  window().workspace().selection().setOrgan(liver);
  chooseSequence("breathing");
  press("offerFit");
  ASSERT_TRUE(waitUntil([this] { return message().contains(QStringLiteral("stays at rest")); }))
      << message().toStdString();
  EXPECT_TRUE(message().contains(QStringLiteral("Spleen"))) << message().toStdString();
  EXPECT_FALSE(message().contains(QStringLiteral("Liver"))) << message().toStdString();
  for (const auto* button : window().viewArea().messages()->findChildren<QPushButton*>())
    EXPECT_NE(button->text(), QStringLiteral("Add enclosing handles"));
  EXPECT_TRUE(find<QLabel>("statusBinding").text().contains(QStringLiteral("Spleen not bound")));
}

TEST_F(SequencesThatFit, AStomachIsToldThatItHasNoHeartbeat) {
  key(Qt::Key_N, Qt::ControlModifier);
  open(sphereFile(QStringLiteral("stomach.stl"), 60));
  key(Qt::Key_5);
  EXPECT_EQ(firstOffered(), QStringLiteral("peristalsis"));
  chooseSequence("heartbeat");
  EXPECT_TRUE(standsOut("offerSample"));
  EXPECT_FALSE(standsOut("offerFit"));
  ASSERT_EQ(document().organs().size(), 1u);
  EXPECT_EQ(document().organs().front()->name, "stomach");
  open(sphereFile(QStringLiteral("liver.stl"), 60));
  chooseSequence("peristalsis");
  EXPECT_TRUE(find<QAbstractButton>("offerFit").isVisible());
  window().workspace().selection().setOrgan(document().organs().back()->id);
  window().workspace().selection().setOrgan(document().organs().front()->id);
  EXPECT_FALSE(find<QAbstractButton>("offerFit").isVisible()) << "it asked about another organ";
}

TEST_F(OwnMotion, UndoToARigOfMoreHandlesWhilePlayingLeavesTheWindowWhole) {
  auto& undo = window().workspace().undo();
  const std::size_t steps = undo.position();
  const std::size_t handles = document().rig().handles.size();
  undo.perform(document::removeHandles({document().rig().handles.back().id}));
  key(Qt::Key_K, Qt::ControlModifier);
  pose(1.2);
  key(Qt::Key_K, Qt::ControlModifier);
  window().playback().play();
  window().playback().seek(0.3);
  ASSERT_TRUE(window().playback().showing());
  EXPECT_NO_THROW(undo.goTo(steps));
  settle();
  ASSERT_EQ(document().rig().handles.size(), handles);
  EXPECT_EQ(view().view().handles()->GetNumberOfHandles(), static_cast<int>(handles));
  EXPECT_EQ(window().workspace().live().shownPose(), document().pose());
  EXPECT_FALSE(window().playback().showing());
}

} // namespace
} // namespace viscera::tests
