#include "window_test.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "shapes.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/medical_io/surface_file.h"
#include "window/compare/compared_system.h"
#include "window/compare/comparison.h"
#include "window/compare/difference_map.h"
#include "window/key_sequence/fit_box.h"
#include "window/play/play_mode.h"
#include "window/session/session_files.h"
#include "window/widgets/page.h"

namespace viscera::tests {
namespace {

/// What no other test does in this order.
class OddOrders : public WindowTest {
protected:
  void press(const char* name) {
    find<QAbstractButton>(name).click();
    settle();
  }
  bool playing() {
    return waitUntil([this] { return window().playback().player().playing(); });
  }
  app::Comparison& comparison() { return window().play().comparison(); }
  void undo(int steps = 1) {
    while (steps-- > 0)
      key(Qt::Key_Z, Qt::ControlModifier);
    settle();
  }
};

TEST_F(OddOrders, ARenameDuringARenameEndsTheFirstWithWhatWasTyped) {
  open(sphereFile());
  auto& list = find<QTreeWidget>("organList");
  const auto editor = [&list] { return list.viewport()->findChild<QLineEdit*>(); };
  window().actions()["organ.rename"]->trigger();
  ASSERT_NE(editor(), nullptr);
  editor()->setText(QStringLiteral("liver"));
  window().actions()["organ.rename"]->trigger();
  settle();
  EXPECT_EQ(document().organs().front()->name, "liver");
  ASSERT_NE(editor(), nullptr) << "the second is open";
  EXPECT_EQ(editor()->text(), QStringLiteral("Liver"));
  editor()->setText(QStringLiteral("spleen"));
  QTest::keyClick(editor(), Qt::Key_Return);
  settle();
  EXPECT_EQ(document().organs().front()->name, "spleen");
  EXPECT_EQ(window().workspace().undo().names().size(), 3u);
}

// All that observes the document has to be there still (the window's monkey, seed 657).
TEST_F(OddOrders, AWindowThatEndsDuringADragEndsTheDragFirst) {
  for (const char* mode : {"handles", "deform"}) {
    SCOPED_TRACE(mode);
    reopenWindow();
    open(sphereFile());
    window().setMode(mode);
    settle();
    const QPoint from = onScreen(handleInView(reachableHandle()));
    QTest::mouseMove(&view(), from);
    QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
    QTest::mouseMove(&view(), from + QPoint(9, 5));
    handleEvents();
    ASSERT_TRUE(window().workspace().undo().stepOpen());
    const QPointer<QObject> modes(&window().modes());
    std::vector<bool> modesThere;
    const auto watched = window().workspace().onChange(
        [&](const document::Change&) { modesThere.push_back(!modes.isNull()); });
    endWindow();
    EXPECT_EQ(modesThere, std::vector<bool>{true}) << "when the drag ended";
  }
}

TEST_F(OddOrders, TheMapOfDifferencesComesAndGoesWithItsViewAndItsOrgans) {
  open(sphereFile());
  key(Qt::Key_3);
  key(Qt::Key_3, Qt::ControlModifier);
  settle();
  press("differences");
  document::HandleId first = document().rig().handles.front().id;
  window().workspace().perform(
      document::moveHandles({first}, Points(document().rig().restPositions().row(0) * 1.3)));
  settle();
  EXPECT_GT(comparison().differences()->greatest(), 0);
  key(Qt::Key_2, Qt::ControlModifier); // Two rates.
  settle();
  EXPECT_EQ(comparison().differences(), nullptr);
  key(Qt::Key_3, Qt::ControlModifier);
  settle();
  press("differences");
  comparison().comparedSystem()->choose("mean-value");
  settle();
  window().workspace().perform(document::removeHandles({first}));
  settle();
  comparison().comparedSystem()->choose("wire-approach");
  settle();
  undo(2);
  key(Qt::Key_Delete);
  settle();
  open(sphereFile(QStringLiteral("another.stl"), 40));
  settle();
  key(Qt::Key_1, Qt::ControlModifier);
  settle();
  undo(3);
  key(Qt::Key_3, Qt::ControlModifier);
  settle();
  press("differences");
  key(Qt::Key_N, Qt::ControlModifier);
  settle();
  EXPECT_TRUE(document().organs().empty());
}

TEST_F(OddOrders, LandmarksLeaveWithTheirOrganAndComeBackForNoOther) {
  open(sphereFile(QStringLiteral("heart.stl"), 50));
  key(Qt::Key_5);
  for (app::CollapsibleSection* fold : window().findChildren<app::CollapsibleSection*>())
    fold->setOpen(true);
  settle();
  EXPECT_EQ(find<QComboBox>("fitSequence").currentData(), QStringLiteral("heartbeat"));
  press("landmark_apex");
  click(QPoint(view().width() / 2, view().height() / 2));
  const auto& fit = find<app::FitBox>("fitBox");
  EXPECT_EQ(fit.glyphs().items().size(), 1u);
  open(sphereFile(QStringLiteral("stomach.stl"), 45));
  settle();
  window().workspace().selection().setOrgan(document().organs().back()->id);
  settle();
  EXPECT_TRUE(fit.glyphs().items().empty());
  EXPECT_EQ(find<QComboBox>("fitSequence").currentData(), QStringLiteral("peristalsis"));
  window().workspace().selection().setOrgan(document().organs().front()->id);
  press("landmark_apex");
  click(QPoint(view().width() / 2, view().height() / 2));
  window().workspace().perform(document::removeOrgans({document().organs().front()->id}));
  settle();
  EXPECT_TRUE(fit.glyphs().items().empty());
  undo(2);
  settle();
  EXPECT_EQ(message(), QString());
}

TEST_F(OddOrders, LandmarksDoNotOutliveADocumentWhoseOrganHadTheSameNumber) {
  medical_io::writeSurface(path(QStringLiteral("small.stl")).toStdString(), sphere(1, 40));
  open(path(QStringLiteral("small.stl")));
  ASSERT_FALSE(document().organs().empty()) << message().toStdString();
  EXPECT_EQ(document().rig().handles.size(), 8u) << "there is room for no more than its box";
  const QString file = path(QStringLiteral("small.viscera"));
  bool saved = false;
  window().sessions().saveTo(file, true, [&] { saved = true; });
  ASSERT_TRUE(waitUntil([&] { return saved; }));
  const document::OrganId id = document().organs().front()->id;
  reopenWindow(); // Numbers begin anew.
  open(sphereFile(QStringLiteral("heart.stl"), 50));
  ASSERT_FALSE(document().organs().empty()) << message().toStdString();
  ASSERT_EQ(document().organs().front()->id, id);
  key(Qt::Key_5);
  for (app::CollapsibleSection* fold : window().findChildren<app::CollapsibleSection*>())
    fold->setOpen(true);
  settle();
  press("landmark_apex");
  click(QPoint(view().width() / 2, view().height() / 2));
  const auto& fit = find<app::FitBox>("fitBox");
  ASSERT_EQ(fit.glyphs().items().size(), 1u);
  window().workspace().undo().markSaved();
  window().files().open({file});
  ASSERT_TRUE(waitUntil(
      [this] { return !document().organs().empty() && document().organs().front()->name == "small"; }));
  settle();
  EXPECT_EQ(document().organs().front()->id, id);
  EXPECT_TRUE(fit.glyphs().items().empty());
  EXPECT_EQ(fit.landmarks().find("apex"), nullptr);
}

TEST_F(OddOrders, ASessionWithAFittedOrganOpensWhileASampleIsCompared) {
  open(sphereFile(QStringLiteral("liver.stl"), 70));
  key(Qt::Key_5);
  chooseSequence("breathing");
  press("offerFit");
  ASSERT_TRUE(playing());
  const QString file = path(QStringLiteral("fit.viscera"));
  bool saved = false;
  window().sessions().saveTo(file, true, [&] { saved = true; });
  ASSERT_TRUE(waitUntil([&] { return saved; }));
  window().samples().load(QStringLiteral("stomach"), true);
  ASSERT_TRUE(waitUntil([this] { return document().organs().front()->name != "liver"; }));
  key(Qt::Key_2, Qt::ControlModifier);
  settle();
  window().files().open({file});
  ASSERT_TRUE(waitUntil([this] {
    return !document().organs().empty() && document().organs().front()->name == "liver" &&
           window().playback().sequence();
  }));
  settle();
  EXPECT_EQ(find<QListWidget>("sequenceList").currentItem()->data(Qt::UserRole), QStringLiteral("breathing"));
  now_ += 0.2;
  window().playback().advance();
  settle();
}

} // namespace
} // namespace viscera::tests
