#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QFrame>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>
#include <QVTKOpenGLNativeWidget.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <map>
#include <thread>
#include <utility>
#include <vector>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkRenderer.h>

#include "play_fixture.h"
#include "shapes.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/presentation/presenter.h"
#include "window/export/export_actions.h"
#include "window/import/import_controller.h"
#include "window/session/session_files.h"
#include "window/stress/stress_mode.h"
#include "window/style/icon.h"
#include "window/timeline/volume_panel.h"
#include "window_probe.h"

/// Small faults that trying the window as its users do has brought to light.
namespace viscera::tests {
namespace {

using SmallFaults = PlayMode;
using SmallFaultsOfAFile = WindowTest;

TEST_F(SmallFaults, UndoOnAnUntouchedStartLeavesTheSample) {
  EXPECT_FALSE(window().workspace().undo().canUndo());
  EXPECT_TRUE(window().workspace().undo().isClean());
  EXPECT_FALSE(window().isWindowModified());
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_FALSE(document().organs().empty());
  EXPECT_TRUE(window().playback().sequence());
  loadSample(QStringLiteral("liver"));
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_FALSE(document().organs().empty());
  EXPECT_EQ(document().organs().front()->name, "Heart") << "another sample is a step";
  EXPECT_FALSE(window().isWindowModified()) << "both samples are as they came";
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().organs().front()->name, "Liver");
  EXPECT_FALSE(window().isWindowModified());
}

TEST_F(SmallFaultsOfAFile, ASampleThatArrivesInDeformLeavesTheMode) {
  key(Qt::Key_3);
  window().samples().load(QStringLiteral("heart"), true);
  ASSERT_TRUE(waitUntil([this] { return window().playback().sequence() != nullptr; }));
  settle();
  EXPECT_EQ(window().mode(), "deform");
  EXPECT_FALSE(window().playback().player().playing());
}

TEST_F(SmallFaults, StressMarksWhosePoseItsMapIsOf) {
  window().stress().model().change([](app::StressLook& look) { look.witnesses = 200; });
  auto& own = find<QPushButton>("stressOwnPose");
  auto& played = find<QPushButton>("stressPlayed");
  key(Qt::Key_Space);
  playFor(0.2);
  key(Qt::Key_3); // While it plays.
  key(Qt::Key_4);
  ASSERT_TRUE(window().playback().showing());
  EXPECT_TRUE(played.isChecked() && !own.isChecked()) << "an instant of the sequence is shown";
  const double instant = window().playback().player().fraction();
  own.click();
  settle();
  EXPECT_TRUE(own.isChecked() && !played.isChecked());
  EXPECT_FALSE(window().playback().showing());
  EXPECT_EQ(window().playback().player().fraction(), 0) << "nothing follows the timeline";
  played.click();
  settle();
  EXPECT_NEAR(window().playback().player().fraction(), instant, 1e-12) << "back to where it was";
}

TEST_F(SmallFaults, StressShowsThePoseThatWasMadeJustBefore) {
  window().stress().model().change([](app::StressLook& look) { look.witnesses = 200; });
  window().playback().seek(0.4);
  settle();
  key(Qt::Key_3);
  document::Command pose = document::setPose(1.02 * document().rig().restPositions());
  window().workspace().perform(pose);
  key(Qt::Key_4);
  EXPECT_FALSE(window().playback().showing());
  EXPECT_EQ(window().workspace().live().shownPose(), document().pose());
  key(Qt::Key_5);
  window().playback().seek(0.2);
  key(Qt::Key_4);
  EXPECT_TRUE(window().playback().showing()) << "the sequence was asked for since";
}

TEST_F(SmallFaultsOfAFile, AModeKeyDuringADragSaysThatTheDragIsTakenBack) {
  open(sphereFile());
  key(Qt::Key_3);
  const QPoint at = onScreen(handleInView(reachableHandle()));
  QTest::mouseMove(&view(), at);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, at);
  QTest::mouseMove(&view(), at + QPoint(20, 10));
  QTest::qWait(50);
  key(Qt::Key_1);
  EXPECT_TRUE(document::atRest(window().workspace().state()));
  EXPECT_TRUE(message().contains(QStringLiteral("cancelled the drag"))) << message().toStdString();
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, at);
}

TEST_F(SmallFaultsOfAFile, KeysOfTheHandlesLeaveThoseThatAreNotSeen) {
  open(sphereFile());
  const std::size_t handles = document().rig().handles.size();
  key(Qt::Key_1);
  key(Qt::Key_A, Qt::ControlModifier);
  key(Qt::Key_Delete);
  EXPECT_EQ(document().rig().handles.size(), handles);
  key(Qt::Key_2);
  find<QTreeWidget>("organList").setFocus();
  key(Qt::Key_A, Qt::ControlModifier);
  EXPECT_TRUE(window().workspace().selection().handles().empty()) << "the list has the focus";
  view().setFocus();
  key(Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(window().workspace().selection().handles().size(), handles);
}

/// Three balls side by side whose files paint them.
class PaintedOrgans : public WindowTest {
protected:
  using Paint = std::array<std::uint8_t, 3>;

  void SetUp() override {
    WindowTest::SetUp();
    QStringList files;
    for (std::size_t i = 0; i < paints_.size(); ++i) {
      const auto place = static_cast<double>(i);
      geometry::TriangleMesh mesh = sphere(3, 20 + 4 * place); // Or their curves lay over each other.
      mesh.points.col(0).array() += 60 * place;
      mesh.colors.resize(mesh.points.rows(), 3);
      for (int part = 0; part < 3; ++part)
        mesh.colors.col(part).setConstant(paints_[i][static_cast<std::size_t>(part)]);
      files << path(QStringLiteral("painted%1.ply").arg(i));
      medical_io::writeSurface(files.back().toStdString(), mesh);
    }
    window().files().open(files);
    settle();
    if (window().imports().isOpen())
      window().imports().accept();
    settle();
    ASSERT_EQ(document().organs().size(), paints_.size());
  }
  /// Of an icon of one colour.
  static void expectPaint(const QIcon& icon, const Paint& paint, const char* where) {
    const QImage square = icon.pixmap(16, 16).toImage();
    const QColor middle = square.pixelColor(square.width() / 2, square.height() / 2);
    EXPECT_NEAR(middle.red(), paint[0], 2) << where;
    EXPECT_NEAR(middle.green(), paint[1], 2) << where;
    EXPECT_NEAR(middle.blue(), paint[2], 2) << where;
  }
  /// Letters and smooth lines are mixed with the ground.
  static int pixelsOf(const QImage& image, const Paint& paint) {
    constexpr int kAlike = 30;
    int found = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QRgb pixel = image.pixel(x, y);
        found += std::abs(qRed(pixel) - paint[0]) < kAlike && std::abs(qGreen(pixel) - paint[1]) < kAlike &&
                 std::abs(qBlue(pixel) - paint[2]) < kAlike;
      }
    return found;
  }

  const std::vector<Paint> paints_ = {{200, 60, 60}, {60, 160, 70}, {70, 90, 190}};
};

TEST_F(PaintedOrgans, HaveTheirColoursInTheList) {
  const auto& list = find<QTreeWidget>("organList");
  ASSERT_EQ(list.topLevelItemCount(), 3);
  for (int row = 0; row < 3; ++row)
    expectPaint(list.topLevelItem(row)->icon(1), paints_[static_cast<std::size_t>(row)], "list");
}

TEST_F(PaintedOrgans, HaveTheirColoursInTheTilesAndTheCurvesOfTheChart) {
  auto& panel = *window().findChild<app::VolumePanel*>();
  const auto tiles = panel.findChildren<QToolButton*>(QStringLiteral("tileName"));
  ASSERT_EQ(tiles.size(), 3);
  for (int tile = 0; tile < 3; ++tile)
    expectPaint(tiles[tile]->icon(), paints_[static_cast<std::size_t>(tile)], "tile");
  ASSERT_TRUE(window().workspace().perform(document::addEnclosingHandles()));
  settle();
  key(Qt::Key_3);
  for (const double factor : {1.1, 1.2, 1.05}) {
    window().workspace().perform(document::setPose(factor * document().rig().restPositions()));
    settle();
  }
  auto& chart = *panel.findChild<QVTKOpenGLNativeWidget*>();
  ASSERT_TRUE(waitUntil([&] { return chart.isVisible(); })) << "drags have a chart";
  const auto drawn = [&] {
    const QImage picture = chart.grab().toImage();
    return std::all_of(paints_.begin(), paints_.end(),
                       [&](const Paint& paint) { return pixelsOf(picture, paint) > 8; });
  };
  EXPECT_TRUE(waitUntil(drawn)) << "a curve has another colour than its organ";
}

/// Alone at the left it would look as if one were missing.
TEST_F(PaintedOrgans, TheLastTileOfAnOddNumberHasTheWholeRow) {
  ASSERT_TRUE(window().workspace().perform(document::addEnclosingHandles()));
  key(Qt::Key_3);
  window().workspace().perform(document::setPose(1.1 * document().rig().restPositions()));
  settle();
  auto& panel = *window().findChild<app::VolumePanel*>();
  const auto values = panel.findChildren<QLabel*>(QStringLiteral("tileValue"));
  ASSERT_EQ(values.size(), 3);
  ASSERT_TRUE(waitUntil([&] { return values[2]->isVisible(); })) << "tiles stand beside the chart of drags";
  const auto boxOf = [&](int tile) { return values[tile]->parentWidget()->geometry(); };
  EXPECT_EQ(boxOf(0).top(), boxOf(1).top());
  EXPECT_GT(boxOf(2).top(), boxOf(0).bottom());
  EXPECT_EQ(boxOf(2).left(), boxOf(0).left());
  EXPECT_EQ(boxOf(2).right(), boxOf(1).right());
  const auto* detail = values[2]->parentWidget()->findChild<QLabel*>(QStringLiteral("muted"));
  EXPECT_NEAR(detail->geometry().center().y(), values[2]->geometry().center().y(), 1) << "beside the value";
  EXPECT_EQ(detail->x(), boxOf(1).left() - boxOf(0).left()) << "in the second column";
}

/// Tables of label maps have pure colours, on which light and shade are lost.
TEST_F(SmallFaultsOfAFile, PureColoursAreSoftenedInTheViewAndTheListAndStayInTheDocument) {
  open(sphereFile());
  document::OrganLook look = document().organs().front()->look;
  look.color = Vec3(0, 1, 0);
  window().workspace().perform(document::setOrganLook(document().organs().front()->id, look));
  settle();
  EXPECT_EQ(document().organs().front()->look.color, Vec3(0, 1, 0));
  const Vec3 drawn = view().view().organs().front()->color();
  EXPECT_LT(drawn.y() - drawn.x(), 0.71);
  EXPECT_GT(drawn.y() - drawn.x(), 0.69) << "still green";
  const QImage square = find<QTreeWidget>("organList").topLevelItem(0)->icon(1).pixmap(16, 16).toImage();
  EXPECT_NEAR(square.pixelColor(square.width() / 2, square.height() / 2).greenF(), drawn.y(), 0.01);
  look.color = Vec3(0.84, 0.16, 0.14);
  window().workspace().perform(document::setOrganLook(document().organs().front()->id, look));
  settle();
  EXPECT_LT((view().view().organs().front()->color() - look.color).norm(), 1e-9) << "blood stays";
}

/// So `viscera segment` writes what a label map numbers: the table's pure cyan was drawn flat.
TEST_F(SmallFaultsOfAFile, ASurfaceThatIsPaintedInAPureColourIsDrawnAsTheOthers) {
  const auto paintedAs = [this](const QString& name) {
    geometry::TriangleMesh mesh = sphere(3, 60);
    mesh.points.col(0).array() -= 30; // A liver lies on the right.
    mesh.colors = Colors::Zero(mesh.points.rows(), 3);
    mesh.colors.rightCols(2).setConstant(255);
    medical_io::writeSurface(path(name).toStdString(), mesh);
    window().files().open({path(name)});
    EXPECT_TRUE(waitUntil([this] { return !document().organs().empty() || window().imports().isOpen(); }));
    window().imports().accept(); // Nothing happens where nothing is asked.
    settle();
    const auto organs = view().view().organs();
    EXPECT_FALSE(organs.empty()) << message().toStdString();
    EXPECT_FALSE(organs.empty() || organs.back()->actor()->GetMapper()->GetScalarVisibility())
        << "the vertices' colours are not tempered";
    return organs.empty() ? Vec3(0, 0, 0) : organs.back()->color();
  };
  const Vec3 lump = paintedAs(QStringLiteral("lump.vtp"));
  EXPECT_LT((lump - presentation::shownColor({0, 1, 1})).norm(), 1e-9) << "still cyan";
  window().sessions().begin();
  const Vec3 liver = paintedAs(QStringLiteral("liver.vtp"));
  EXPECT_GT(liver.x(), liver.z()) << "no tissue is cyan";
  EXPECT_EQ(liver, presentation::shownColor(document().organs().front()->look.color));
}

TEST_F(SmallFaultsOfAFile, WhatIsSaidOfAnOrganThatCannotBeBoundGoesWithIt) {
  open(sphereFile());
  const QString file = path(QStringLiteral("far.stl"));
  medical_io::writeSurface(file.toStdString(), sphere(3, 20, Vec3(300, 0, 0)));
  window().files().open({file});
  ASSERT_TRUE(waitUntil([this] { return document().organs().size() == 2 || window().imports().isOpen(); }));
  window().imports().accept(); // Nothing happens where nothing is asked.
  settle();
  ASSERT_TRUE(message().contains(QStringLiteral("outside the handles"))) << message().toStdString();
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_EQ(document().organs().size(), 1u);
  EXPECT_EQ(message().toStdString(), "");
}

TEST_F(SmallFaultsOfAFile, TheLastOrganTakesItsHandlesWithIt) {
  open(sphereFile());
  const std::size_t handles = document().rig().handles.size();
  window().actions()["organ.remove"]->trigger();
  settle();
  EXPECT_TRUE(document().organs().empty());
  EXPECT_TRUE(document().rig().handles.empty());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().organs().size(), 1u);
  EXPECT_EQ(document().rig().handles.size(), handles) << "one step";
}

TEST_F(SmallFaultsOfAFile, TheWelcomeLeavesWithTheFirstChangeOfTheMode) {
  const auto shown = [this] { // The tour and the list of keys are such cards, too.
    const auto cards = window().findChildren<QFrame*>(QStringLiteral("welcomeCard"));
    return std::any_of(cards.begin(), cards.end(), [](const QFrame* card) { return card->isVisible(); });
  };
  window().showWelcome(true);
  ASSERT_TRUE(shown());
  key(Qt::Key_2);
  EXPECT_FALSE(shown());
}

TEST_F(SmallFaultsOfAFile, ViewsHaveKeysWithoutAKeypad) {
  open(sphereFile());
  key(Qt::Key_3, Qt::AltModifier);
  const Vec3 forward(view().view().renderer()->GetActiveCamera()->GetDirectionOfProjection());
  EXPECT_LT((forward - Vec3(-1, 0, 0)).norm(), 1e-9) << "from the patient's left";
}

TEST_F(SmallFaultsOfAFile, DeformSaysWhichOrganItsNumbersAreOf) {
  open(sphereFile());
  key(Qt::Key_3);
  EXPECT_EQ(find<QLabel>("deformOrgan").text(), QStringLiteral("Ball"));
}

TEST_F(SmallFaultsOfAFile, ATargetVolumeOfALockedOrganIsReachedAndKeptFromThereOn) {
  open(sphereFile());
  key(Qt::Key_3);
  key(Qt::Key_K);
  const document::OrganId organ = document().organs().front()->id;
  const double target = 1.05 * window().workspace().live().volume(organ).restMl;
  find<QDoubleSpinBox>("targetVolume").setValue(target);
  find<QPushButton>("applyVolume").click();
  settle();
  const double now = window().workspace().live().volume(organ).nowMl;
  EXPECT_NEAR(now, target, 0.1);
  EXPECT_TRUE(message().contains(QStringLiteral("lock"))) << message().toStdString();
  const QPoint at = onScreen(handleInView(reachableHandle()));
  drag(at, at + QPoint(15, 10));
  EXPECT_NEAR(window().workspace().live().volume(organ).nowMl, now, 1e-6 * now);
}

/// While the mouse holds a handle, and after: whoever reads one of the two numbers may look at the other.
TEST_F(SmallFaultsOfAFile, ListAndStatusBarSayOneVolumeDuringAMirroredDrag) {
  open(sphereFile());
  key(Qt::Key_3);
  key(Qt::Key_M);
  auto& status = find<QLabel>("statusVolume");
  const auto* row = find<QTreeWidget>("organList").topLevelItem(0);
  constexpr int kVolume = 2;
  const auto agree = [&] { return status.text().contains(row->text(kVolume)); };
  const QPoint at = onScreen(handleInView(reachableHandle()));
  QTest::mouseMove(&view(), at);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, at);
  for (int step = 1; step <= 12; ++step) {
    QTest::mouseMove(&view(), at + QPoint(6 * step, 4 * step));
    QApplication::processEvents();
    EXPECT_TRUE(agree()) << status.text().toStdString() << " beside " << row->text(kVolume).toStdString();
  }
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, at + QPoint(72, 48));
  QApplication::processEvents();
  const double now = window().workspace().live().volume(document().organs().front()->id).nowMl;
  EXPECT_EQ(row->text(kVolume), app::formatMilliliters(now));
  EXPECT_TRUE(agree()) << status.text().toStdString();
}

TEST_F(SmallFaults, OrgansThatWereWrittenAsOneGlbComeBackApart) {
  const document::OrganList before = document().organs();
  const QString file = path(QStringLiteral("all.glb"));
  window().playback().stop();
  window().exports().exportOrgans(file);
  settle();
  open(file);
  ASSERT_TRUE(waitUntil([this] { return window().imports().isOpen() || !window().playback().sequence(); }));
  if (window().imports().isOpen())
    window().imports().accept();
  settle();
  const document::OrganList& back = document().organs();
  ASSERT_EQ(back.size(), before.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_EQ(back[i]->name, before[i]->name);
    EXPECT_EQ(back[i]->look.color, before[i]->look.color);
    EXPECT_EQ(back[i]->look.opacity, before[i]->look.opacity);
    EXPECT_NEAR(back[i]->restVolumeMm3, before[i]->restVolumeMm3, 1e-4 * before[i]->restVolumeMm3);
    EXPECT_EQ(back[i]->parent ? document().organ(back[i]->parent)->name : std::string(),
              before[i]->parent ? before.front()->name : std::string());
  }
}

/// On a software renderer it is off until somebody asks; what is seen through and what means numbers is as
/// without.
TEST_F(SmallFaults, FoldsAreShadedWhereThatIsAskedForAndNothingIsSeenThrough) {
  QAction* shade = window().actions()["view.shading"];
  ASSERT_FALSE(shade->isChecked());
  setViewSize(window(), 500, 400);
  const auto differing = [](vtkImageData* a, vtkImageData* b) {
    const auto* first = static_cast<const unsigned char*>(a->GetScalarPointer());
    const auto* second = static_cast<const unsigned char*>(b->GetScalarPointer());
    const vtkIdType count = a->GetNumberOfPoints() * a->GetNumberOfScalarComponents();
    vtkIdType pixels = 0;
    for (vtkIdType i = 0; i < count; ++i)
      pixels += std::abs(first[i] - second[i]) > 12;
    return static_cast<double>(pixels) / static_cast<double>(count);
  };
  const auto see = [&](bool shaded) {
    shade->setChecked(shaded);
    settle();
    return grab(window());
  };
  const auto glass = see(false);
  EXPECT_EQ(differing(glass, see(true)), 0) << "one sees through the wall";
  shade->setChecked(false);
  key(Qt::Key_X);
  const auto plain = see(false);
  EXPECT_GT(differing(plain, see(true)), 0.02);
  EXPECT_EQ(differing(plain, see(false)), 0) << "and back";
  reopenWindow();
  EXPECT_FALSE(window().actions()["view.shading"]->isChecked());
  window().actions()["view.shading"]->setChecked(true);
  reopenWindow();
  EXPECT_TRUE(window().actions()["view.shading"]->isChecked()) << "the settings keep it";
}

/// Peeling takes the time of several frames, on a processor: it waits until nothing moves.
TEST_F(SmallFaults, TheTranslucentHeartIsPeeledAtRestAloneNotWhileItBeatsOrIsDragged) {
  if (!scene::rendersInSoftware(viewOf(window()).window()))
    GTEST_SKIP() << "a graphics processor peels every frame";
  enum class Peeled { none, some, all };
  const auto peeled = [this] {
    int walls = 0, layers = 0;
    for (const auto& organ : viewOf(window()).organs())
      if (organ->visible() && organ->opacity() < 1) {
        ++walls;
        layers += organ->actor()->GetForceOpaque() ? 0 : 1;
      }
    EXPECT_GT(walls, 0) << "nothing is translucent";
    return layers == 0 ? Peeled::none : layers == walls ? Peeled::all : Peeled::some;
  };
  window().playback().pause();
  settle();
  EXPECT_EQ(peeled(), Peeled::all) << "paused";
  key(Qt::Key_Space);
  ASSERT_TRUE(window().playback().player().playing());
  playFor(0.2);
  EXPECT_TRUE(waitUntil([&] { return peeled() == Peeled::none; })) << "it beats";
  key(Qt::Key_Space);
  EXPECT_TRUE(waitUntil([&] { return peeled() == Peeled::all; })) << "it stands still";
  key(Qt::Key_3);
  const QPoint at = onScreen(handleInView(reachableHandle()));
  QTest::mouseMove(&view(), at);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, at);
  QTest::mouseMove(&view(), at + QPoint(8, 5));
  EXPECT_TRUE(waitUntil([&] { return peeled() == Peeled::none; })) << "it is dragged";
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, at + QPoint(8, 5));
  settle();
  EXPECT_EQ(peeled(), Peeled::all) << "it was let go";
}

/// Alt+O, R: with two entries of one letter Qt only marks the first and leaves the menu open.
TEST_F(SmallFaults, EveryLetterOfAMenuMeansOneEntry) {
  for (QMenu* menu : window().menuBar()->findChildren<QMenu*>()) {
    std::map<QChar, QString> known;
    for (const QAction* action : menu->actions()) {
      const int mark = action->text().indexOf(QLatin1Char('&'));
      if (mark < 0 || !action->isVisible() || mark + 1 >= action->text().size())
        continue;
      const QString before = std::exchange(known[action->text()[mark + 1].toLower()], action->text());
      EXPECT_TRUE(before.isEmpty()) << menu->title().toStdString() << ": " << before.toStdString() << " and "
                                    << action->text().toStdString();
    }
  }
}

/// Qt draws a tick only where an entry has no icon.
TEST_F(SmallFaults, AMenuTicksWhatIsOn) {
  QMenu menu(&window());
  QAction* action = menu.addAction(app::icon("ghost"), QStringLiteral("Ghost"));
  action->setCheckable(true);
  menu.resize(menu.sizeHint());
  constexpr int kIconWidth = 28;
  const QRect entry = menu.actionGeometry(action);
  const QRect place(entry.topLeft(), QSize(kIconWidth, entry.height()));
  const QImage off = menu.grab(place).toImage();
  action->setChecked(true);
  const QImage on = menu.grab(place).toImage();
  int changed = 0;
  for (int y = 0; y < off.height(); ++y)
    for (int x = 0; x < off.width(); ++x)
      changed += off.pixel(x, y) != on.pixel(x, y);
  EXPECT_GT(changed, 60) << "a tick is seen";
}

TEST_F(SmallFaults, ALongTaskIsCutInTheMiddleAndWholeInItsTip) {
  const QString name =
      QStringLiteral("Reading ") + QString(200, QLatin1Char('m')) + QStringLiteral(".nii.gz");
  const auto& step = find<QLabel>("jobStep");
  bool ended = false;
  window().workspace().jobs().submit<int>(
      name.toStdString(), {},
      [](Progress& progress) {
        while (!progress.cancelled())
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return 0;
      },
      [&](const JobResult<int>&) { ended = true; });
  ASSERT_TRUE(waitUntil([&] { return step.isVisible(); }));
  EXPECT_LT(step.text().size(), name.size());
  EXPECT_TRUE(step.text().startsWith(QLatin1String("Reading"))) << step.text().toStdString();
  EXPECT_TRUE(step.text().contains(QChar(0x2026)) && step.text().endsWith(QLatin1String(".nii.gz")));
  EXPECT_GE(step.width(), step.fontMetrics().horizontalAdvance(step.text())) << "no letter is cut off";
  EXPECT_EQ(step.toolTip(), name);
  find<QToolButton>("cancelJob").click();
  EXPECT_TRUE(waitUntil([&] { return ended && !step.isVisible(); }));
}

TEST_F(SmallFaults, AChartOfNothingFoldsAway) {
  window().stress().model().change([](app::StressLook& look) { look.witnesses = 200; });
  auto& chart = find<QWidget>("volumes");
  EXPECT_TRUE(chart.isVisible());
  window().playback().seek(0.3);
  key(Qt::Key_4);
  EXPECT_TRUE(chart.isVisible()) << "the sequence's stress";
  find<QPushButton>("stressOwnPose").click();
  settle();
  EXPECT_TRUE(chart.isVisible()) << "a drag along the timeline must not move the timeline";
  open(sphereFile());
  key(Qt::Key_5);
  ASSERT_FALSE(window().playback().sequence());
  EXPECT_FALSE(chart.isVisible()) << "nothing can move";
}

TEST_F(SmallFaults, TheCardOfALectureLeavesTheCubeAndTheScaleBarFree) {
  key(Qt::Key_F5);
  const auto& card = find<QFrame>("lectureCard");
  ASSERT_TRUE(card.isVisible());
  const QRect there(view().mapFromGlobal(card.mapToGlobal(QPoint(0, 0))), card.size());
  const QRect cube(0, view().height() - 96, 96, 96);
  const QRect scale(view().width() / 2 - 90, view().height() - 45, 180, 30);
  EXPECT_FALSE(there.intersects(cube));
  EXPECT_FALSE(there.intersects(scale));
  key(Qt::Key_Escape);
}

} // namespace
} // namespace viscera::tests
