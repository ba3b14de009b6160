#include "window_test.h"

#include <QAction>
#include <QApplication>
#include <QInputDialog>
#include <QLabel>
#include <QRegularExpression>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>
#include <QWheelEvent>

#include <filesystem>
#include <fstream>

#include "dicom_slices.h"
#include "phantom_scan.h"
#include "viscera/document/measured_values.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/scan_item.h"
#include "viscera/scene/vtkVisceraHandleSetWidget.h"
#include "window/organs/explore_mode.h"
#include "window/slices/scan_actions.h"
#include "window/slices/slice_panes.h"
#include "window/style/language.h"
#include "window/view/picture.h"

namespace viscera::tests {
namespace {

/// A ball of 60 mm radius with its handles, and a scan in which that ball is brighter than what is around it.
class SlicesTest : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    window().workspace().perform(document::openScan(document::scanItem(
        phantomScan({66, 66, 66}, Vec3(3, 3, 3), Vec3(-97.5, -97.5, -97.5), ballValue(Vec3::Zero(), 60)),
        {})));
    window().scans().opened();
    settle();
  }

  app::SliceWidget& slice(int direction) { return window().slices().widget(direction); }
  const presentation::ScanLook& look() { return window().viewModel().state().scan; }
  Vec3 focus() { return presentation::focusOf(window().workspace().state(), look()); }
  const geometry::PlaneCut& contour(int direction) {
    return *window().slices().presenter().cut(direction, document().organs().front()->id);
  }
  QPoint placeIn(int direction, const Vec3& point) {
    return slice(direction).placeOf(window().slices().presenter().frame(direction).pixelOf(point)).toPoint();
  }
  void dragIn(int direction, Qt::MouseButton button, const QPoint& from, const QPoint& to,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    constexpr int kSteps = 6;
    const auto send = [&](QEvent::Type type, const QPoint& at, Qt::MouseButton which, Qt::MouseButtons down) {
      QMouseEvent event(type, at, slice(direction).mapToGlobal(at), which, down, modifiers);
      QCoreApplication::sendEvent(&slice(direction), &event);
    };
    send(QEvent::MouseButtonPress, from, button, button);
    for (int step = 1; step <= kSteps; ++step)
      send(QEvent::MouseMove, from + (to - from) * step / kSteps, Qt::NoButton, button);
    send(QEvent::MouseButtonRelease, to, button, Qt::NoButton);
    settle();
  }
  /// The handle that is nearest to the axial plane through the middle, which the slices then go through.
  int handleInSlice() {
    Eigen::Index row = 0;
    document().pose().col(2).cwiseAbs().minCoeff(&row);
    cutThrough(document().pose().row(row).transpose());
    return static_cast<int>(row);
  }
  void cutThrough(const Vec3& place) {
    window().viewModel().change([&](presentation::ViewState& view) { view.scan.focus = place; });
    settle();
  }
  void turnWheel(int direction, int steps, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const QPoint at = slice(direction).rect().center();
    QWheelEvent event(at, slice(direction).mapToGlobal(at), {}, QPoint(0, 120 * steps), Qt::NoButton,
                      modifiers, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&slice(direction), &event);
    settle();
  }
};

TEST_F(SlicesTest, AScanThatIsOpenedComesInFourViewsAndKeysChooseAnother) {
  EXPECT_EQ(look().layout, "four");
  for (int direction = 0; direction < 3; ++direction)
    EXPECT_TRUE(slice(direction).isVisible());
  EXPECT_TRUE(view().isVisible());
  key(Qt::Key_F8);
  EXPECT_TRUE(slice(1).isVisible());
  EXPECT_FALSE(slice(0).isVisible() || slice(2).isVisible() || view().isVisible());
  EXPECT_GT(slice(1).height(), 0.9 * window().viewArea().height()) << "one slice alone has all the room";
  key(Qt::Key_F6, Qt::ShiftModifier);
  EXPECT_TRUE(view().isVisible());
  EXPECT_FALSE(slice(0).isVisible() || slice(1).isVisible() || slice(2).isVisible());
}

TEST_F(SlicesTest, TheWheelTurnsTheSlicesTowardsHeadAndFront) {
  const Vec3 before = focus();
  turnWheel(0, 2);
  EXPECT_LT((focus() - before - Vec3(0, 0, 6)).norm(), 1e-9);
  turnWheel(1, 1);
  EXPECT_LT((focus() - before - Vec3(0, -3, 6)).norm(), 1e-9);
  EXPECT_LT(contour(0).points.rowwise().norm().maxCoeff(), 61);
  EXPECT_NEAR(contour(0).points.col(2).minCoeff(), 6, 1e-9) << "the contour is the new slice's";
}

TEST_F(SlicesTest, ACrosshairIsOnePlaceInAllSlices) {
  const QPoint at = placeIn(0, Vec3(30, -24, 0)); // Far from the lines of the crosshair.
  QTest::mouseClick(&slice(0), Qt::LeftButton, Qt::NoModifier, at);
  settle();
  const double pixel = window().slices().presenter().frame(0).right.norm();
  EXPECT_LT((focus() - Vec3(30, -24, 0)).norm(), 2 * pixel);
  EXPECT_NEAR(window().slices().presenter().frame(2).corner.x(), focus().x(), 1e-9);
  EXPECT_NEAR(window().slices().presenter().frame(1).corner.y(), focus().y(), 1e-9);
  // A drag that begins on it takes it along.
  dragIn(2, Qt::LeftButton, placeIn(2, focus()), placeIn(2, focus() + Vec3(0, 9, 21)));
  EXPECT_LT((focus() - Vec3(30, -15, 21)).norm(), 5 * pixel);
}

TEST_F(SlicesTest, ADragChangesLevelAndWidthAndAPresetSetsThem) {
  const QPoint away = placeIn(0, Vec3(40, 40, 0));
  dragIn(0, Qt::LeftButton, away, away + QPoint(60, 0));
  EXPECT_GT(look().width, 410);
  EXPECT_NEAR(look().level, 40, 1e-9);
  dragIn(0, Qt::LeftButton, away, away + QPoint(0, -60));
  EXPECT_GT(look().level, 60);
  window().actions()["scan.lung"]->trigger();
  EXPECT_EQ(look().level, -600);
  EXPECT_EQ(look().width, 1500);
  EXPECT_TRUE(window().actions()["scan.lung"]->isChecked());
  window().actions()["scan.automatic"]->trigger();
  EXPECT_EQ(look().width, 0);
}

TEST_F(SlicesTest, PanAndZoomKeepWhatIsUnderTheMouse) {
  const Vec3 grabbed(20, 30, 0);
  const QPoint from = placeIn(0, grabbed), to = from + QPoint(36, -24);
  dragIn(0, Qt::MiddleButton, from, to);
  EXPECT_LT((placeIn(0, grabbed) - to).manhattanLength(), 10) << "but for the way before a drag is one";
  const QPoint middle = slice(0).rect().center();
  const double before = window().slices().presenter().frame(0).right.norm();
  const Vec3 there =
      window().slices().presenter().frame(0).at(slice(0).pixelAt(middle).x(), slice(0).pixelAt(middle).y());
  turnWheel(0, 3, Qt::ControlModifier);
  EXPECT_LT(window().slices().presenter().frame(0).right.norm(), 0.8 * before);
  EXPECT_LT((placeIn(0, there) - middle).manhattanLength(), 3);
}

TEST_F(SlicesTest, SaysWhatIsUnderTheCursor) {
  const Vec3 inside(12, -30, 0), outside(80, 80, 0);
  const auto hover = [&](const Vec3& place) {
    QMouseEvent event(QEvent::MouseMove, placeIn(0, place), slice(0).mapToGlobal(placeIn(0, place)),
                      Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&slice(0), &event);
    return slice(0).reading();
  };
  const QString in = hover(inside), out = hover(outside);
  EXPECT_TRUE(in.contains(QStringLiteral("100 HU"))) << in.toStdString();
  EXPECT_TRUE(in.contains(QStringLiteral("Ball"))) << in.toStdString();
  EXPECT_TRUE(in.contains(QStringLiteral("A 30")) || in.contains(QStringLiteral("A 29"))) << in.toStdString();
  EXPECT_TRUE(out.contains(QStringLiteral("-50 HU"))) << out.toStdString();
  EXPECT_FALSE(out.contains(QStringLiteral("Ball"))) << out.toStdString();
  EXPECT_TRUE(in.contains(QRegularExpression(QStringLiteral(R"(L \d+\.\d, A \d+\.\d, [SI] \d+\.\d mm)"))))
      << in.toStdString();
  const app::InstalledLanguage german(QStringLiteral("de"));
  const QString deutsch = hover(inside);
  EXPECT_TRUE(deutsch.contains(QRegularExpression(QStringLiteral(R"(L \d+,\d; A \d+,\d; [SI] \d+,\d mm)"))))
      << deutsch.toStdString();
}

TEST_F(SlicesTest, ContoursFollowAHandleWhileItIsDragged) {
  key(Qt::Key_3); // Deform
  const double before = contour(1).points.col(2).maxCoeff();
  EXPECT_NEAR(before, 60, 0.5);
  Points higher = document().rig().restPositions();
  higher.col(2).array() += 40;
  std::vector<document::HandleId> all;
  for (const document::Handle& handle : document().rig().handles)
    all.push_back(handle.id);
  document::UndoStack::Step step(window().workspace().undo(), "Drag");
  window().workspace().perform(document::moveHandles(all, higher));
  QTest::qWait(50); // The drag goes on.
  EXPECT_NEAR(contour(1).points.col(2).maxCoeff(), before + 40, 0.1);
  step.finish();
  window().actions()["edit.undo"]->trigger();
  settle();
  EXPECT_NEAR(contour(1).points.col(2).maxCoeff(), before, 1e-6);
}

TEST_F(SlicesTest, AHandleIsDraggedInTheSliceAsInTheView) {
  key(Qt::Key_3); // Deform
  const int row = handleInSlice();
  const Vec3 rest = document().pose().row(row).transpose();
  const auto steps = window().workspace().undo().position();
  const double before = contour(0).lengthMm;
  const Vec3 wanted(0.8 * rest.x(), 0.7 * rest.y() + 3, rest.z());
  dragIn(0, Qt::LeftButton, placeIn(0, rest), placeIn(0, wanted));
  const double pixel = window().slices().presenter().frame(0).right.norm();
  EXPECT_LT((document().pose().row(row).transpose() - wanted).norm(), 2 * pixel);
  EXPECT_EQ(document().pose()(row, 2), rest.z()) << "it stays in the slice's plane";
  EXPECT_EQ(window().workspace().undo().position(), steps + 1);
  EXPECT_GT(std::abs(contour(0).lengthMm - before), 0.01) << "the contour has followed";
  window().actions()["edit.undo"]->trigger();
  settle();
  EXPECT_TRUE(document::atRest(window().workspace().state()));
  EXPECT_FALSE(window().viewArea().view()->view().handleWidget()->IsDragging());
}

TEST_F(SlicesTest, ADragInASliceKeepsALockedVolumeAndEscapePutsTheHandleBack) {
  key(Qt::Key_3);
  window().actions()["volume.lock"]->trigger();
  ASSERT_TRUE(document().organs().front()->volumeLocked);
  const int row = handleInSlice();
  const Vec3 rest = document().pose().row(row).transpose();
  // Along the organ's surface, where the volume leaves a way, and some way into it.
  const Vec3 wanted(0.8 * rest.x() - 0.4 * rest.y(), 0.8 * rest.y() + 0.4 * rest.x(), rest.z());
  dragIn(0, Qt::LeftButton, placeIn(0, rest), placeIn(0, wanted));
  const live::OrganVolume volume = window().workspace().live().volume(document().organs().front()->id);
  EXPECT_FALSE(document::atRest(window().workspace().state()));
  EXPECT_LT(std::abs(volume.relativeChange()), 1e-9);
  EXPECT_EQ(document().pose()(row, 2), rest.z()) << "it stays in the slice's plane under the lock, too";
  EXPECT_GT((document().pose().row(row).transpose() - rest).norm(), 5);
  const document::DocumentState dragged = window().workspace().state();
  cutThrough(document().pose().row(row).transpose());
  const QPoint from = placeIn(0, document().pose().row(row).transpose());
  const auto send = [&](QEvent::Type type, const QPoint& at, Qt::MouseButton which, Qt::MouseButtons down) {
    QMouseEvent event(type, at, slice(0).mapToGlobal(at), which, down, Qt::NoModifier);
    QCoreApplication::sendEvent(&slice(0), &event);
  };
  send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
  send(QEvent::MouseMove, from + QPoint(40, 10), Qt::NoButton, Qt::LeftButton);
  EXPECT_NE(window().workspace().state(), dragged);
  key(Qt::Key_Escape);
  EXPECT_EQ(window().workspace().state(), dragged);
  send(QEvent::MouseMove, from + QPoint(60, 10), Qt::NoButton, Qt::LeftButton);
  send(QEvent::MouseButtonRelease, from + QPoint(60, 10), Qt::LeftButton, Qt::NoButton);
  settle();
  EXPECT_EQ(window().workspace().state(), dragged) << "the hand was empty";
}

TEST_F(SlicesTest, DistancesRectanglesAndSpheresAreMeasuredByDragging) {
  key(Qt::Key_D);
  dragIn(0, Qt::LeftButton, placeIn(0, Vec3(-30, -20, 0)), placeIn(0, Vec3(30, -20, 0)));
  ASSERT_EQ(document().measurements().size(), 1u);
  const double pixel = window().slices().presenter().frame(0).right.norm();
  EXPECT_NEAR(document::measuredValue(
                  {document().measurements()[0].points[0].rest, document().measurements()[0].points[1].rest}),
              60, 3 * pixel);
  EXPECT_EQ(look().width, 0) << "the drag was not one of level and width";
  key(Qt::Key_A, Qt::ShiftModifier);
  for (const Vec3& corner : {Vec3(-12, 6, 0), Vec3(12, 27, 0)}) // By two clicks.
    dragIn(0, Qt::LeftButton, placeIn(0, corner), placeIn(0, corner));
  key(Qt::Key_B, Qt::ShiftModifier);
  dragIn(2, Qt::LeftButton, placeIn(2, Vec3(0, 0, 0)), placeIn(2, Vec3(0, 0, 90)));
  ASSERT_EQ(document().measurements().size(), 3u);
  auto* list = window().findChild<QTreeWidget*>(QStringLiteral("measureList"));
  EXPECT_EQ(list->topLevelItem(1)->text(1), QStringLiteral("100.0 HU"));
  EXPECT_EQ(list->topLevelItem(1)->text(2), QStringLiteral("\u00b1 0.0"));
  EXPECT_GT(list->topLevelItem(2)->text(2).mid(2).toDouble(), 60) << "half ball, half ground";
  key(Qt::Key_Escape);
  // A point is dragged; the rectangle stays flat, and the list follows.
  const auto steps = window().workspace().undo().position();
  const Vec3 corner = document().measurements()[1].points[1].rest;
  dragIn(0, Qt::LeftButton, placeIn(0, corner), placeIn(0, Vec3(85, 85, 0)));
  EXPECT_GT(document().measurements()[1].points[1].rest.x(), 80);
  EXPECT_EQ(window().workspace().undo().position(), steps + 1);
  EXPECT_LT(list->topLevelItem(1)->text(1).section(QLatin1Char(' '), 0, 0).toDouble(), 95);
  for (int i = 0; i < 4; ++i)
    window().actions()["edit.undo"]->trigger();
  settle();
  EXPECT_TRUE(document().measurements().empty());
  window().actions()["edit.redo"]->trigger();
  EXPECT_EQ(document().measurements().size(), 1u);
}

TEST_F(SlicesTest, RegionsAskForAScanAndForSlices) {
  key(Qt::Key_F6, Qt::ShiftModifier);
  key(Qt::Key_B, Qt::ShiftModifier);
  EXPECT_EQ(look().layout, "four") << "a sphere is measured on slices";
  window().actions()["scan.close"]->trigger();
  settle();
  EXPECT_FALSE(window().explore().measuring());
  EXPECT_FALSE(window().actions()["measure.sphere"]->isEnabled());
  EXPECT_TRUE(window().actions()["measure.distance"]->isEnabled());
}

TEST_F(SlicesTest, ThePageOfExploreKeepsWhatIsOddAboutTheScan) {
  medical_io::Scan scan = phantomScan({40, 40, 40}, Vec3(3, 3, 3), Vec3(900, 900, 900), slope);
  scan.findings.push_back({medical_io::ScanFinding::Kind::tilt, "The gantry is tilted by 12 degrees"});
  window().workspace().perform(document::openScan(document::scanItem(std::move(scan), {})));
  window().scans().opened();
  settle();
  EXPECT_TRUE(message().contains(QStringLiteral("tilted by 12 degrees"))) << message().toStdString();
  EXPECT_TRUE(message().contains(QStringLiteral("lies outside of the scan"))) << message().toStdString();
  auto* remarks = window().findChild<QLabel*>(QStringLiteral("scanRemarks"));
  EXPECT_TRUE(remarks->text().contains(QStringLiteral("tilted by 12 degrees")));
  EXPECT_TRUE(remarks->text().contains(QStringLiteral("outside of the scan")));
  window().actions()["scan.close"]->trigger();
  EXPECT_TRUE(remarks->text().isEmpty());
}

/// No page of dashes and no empty quarter greet whoever opens a scan.
TEST_F(WindowTest, AScanAloneShowsItsSlicesInSpaceAndOnlyItsOwnSections) {
  const auto section = [this](const char* label) {
    return find<QLabel>(label).parentWidget()->isVisibleTo(&window());
  };
  ASSERT_TRUE(document().organs().empty());
  window().workspace().perform(document::openScan(
      document::scanItem(phantomScan({40, 40, 40}, Vec3(3, 3, 3), Vec3(0, 0, 0), slope), {})));
  window().scans().opened();
  window().setMode("explore");
  settle();
  EXPECT_TRUE(window().viewModel().state().scan.standing);
  EXPECT_FALSE(section("exploreOrgan"));
  EXPECT_TRUE(section("scanRemarks"));
  open(sphereFile());
  EXPECT_TRUE(section("exploreOrgan"));
  window().actions()["scan.close"]->trigger();
  settle();
  EXPECT_FALSE(section("scanRemarks"));
}

/// Chooses the line that begins so in the next dialog that asks; says what it offered.
struct Chooser {
  explicit Chooser(QString beginning) : wanted(std::move(beginning)) {
    QObject::connect(&timer, &QTimer::timeout, [this] {
      auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
      if (!dialog)
        return;
      timer.stop();
      offered = dialog->comboBoxItems();
      for (const QString& line : offered)
        if (line.contains(wanted))
          dialog->setTextValue(line);
      dialog->accept();
    });
    timer.start(20);
  }
  QString wanted;
  QStringList offered;
  QTimer timer;
};

TEST_F(SlicesTest, UnevenSlicesAreChosenBeforeAnyIsShown) {
  LabelImage image = orientedPhantomGrid(0, {0, 1, 2});
  fillPhantom(image);
  const std::filesystem::path folder = path(QStringLiteral("head")).toStdString();
  std::filesystem::create_directory(folder);
  for (int k = 0; k < image.size[2]; ++k) {
    DicomElements elements = dicomSlice(image, k);
    elements[0x00200032] = "DS" + decimals(Vec3(-21, -36, -36 + (k < 9 ? 4 * k : 32 + 7 * (k - 8))));
    std::ofstream(folder / std::to_string(k), std::ios::binary) << dicomBytes(elements);
  }
  Chooser all(QStringLiteral("resampled"));
  window().scans().open(QString::fromStdString(folder.string()));
  settle();
  ASSERT_EQ(all.offered.size(), 3) << "each even part, and all";
  EXPECT_TRUE(all.offered[0].contains(QStringLiteral("slices 1 to 9 of 17"))) << all.offered[0].toStdString();
  ASSERT_TRUE(document().state().scan);
  EXPECT_GT(document().state().scan->scan->size[2], 17);
  Chooser part(QStringLiteral("slices 1 to 9"));
  window().scans().open(QString::fromStdString(folder.string()));
  settle();
  EXPECT_EQ(document().state().scan->scan->size[2], 9);
  EXPECT_TRUE(message().contains(QStringLiteral("9 of 17 slices were read"))) << message().toStdString();
}

TEST_F(SlicesTest, SeveralSeriesAndPhasesAreListedToChooseFromAndWhatIsOddIsSaid) {
  LabelImage image = orientedPhantomGrid(0, {0, 1, 2});
  fillPhantom(image);
  const std::filesystem::path folder = path(QStringLiteral("series")).toStdString();
  std::filesystem::create_directory(folder);
  const auto put = [&](const std::string& name, const DicomElements& elements) {
    std::ofstream(folder / name, std::ios::binary) << dicomBytes(elements);
  };
  for (int k = 0; k < image.size[2]; ++k) {
    if (k != 11)
      put("a" + std::to_string(100 + k), dicomSlice(image, k, "1.2.3.4"));
    for (int phase = 0; phase < 2 && k < 8; ++phase) {
      DicomElements elements = dicomSlice(image, k, "1.2.3.5");
      elements[0x0008103E] = "LOHeart";
      elements[0x00080018] = "UI1.2.3.5." + std::to_string(100 * phase + k);
      elements[0x00200100] = "IS" + std::to_string(phase + 1);
      put("b" + std::to_string(1000 * phase + k), elements);
    }
  }
  const auto opened = [&](const char* description) {
    return waitUntil([&] { return document().state().scan->scan->description == description; });
  };
  {
    Chooser chooser(QStringLiteral("slices 1 to 11 of"));
    window().files().open({QString::fromStdString(folder.string())});
    ASSERT_TRUE(opened("Abdomen 5.0"));
    ASSERT_EQ(chooser.offered.size(), 4) << chooser.offered.join(QLatin1Char('\n')).toStdString();
    EXPECT_TRUE(chooser.offered.filter(QStringLiteral("CT")).filter(QStringLiteral("21 x 23 x")).size() == 4);
    EXPECT_EQ(chooser.offered.filter(QStringLiteral("2 phases")).size(), 1);
    settle();
    EXPECT_TRUE(message().contains(QStringLiteral("is missing"))) << message().toStdString();
  }
  Chooser chooser(QStringLiteral("2 phases"));
  window().scans().open(QString::fromStdString((folder / "b3").string()));
  ASSERT_TRUE(opened("Heart"));
  ASSERT_TRUE(document().state().scan->time);
  EXPECT_EQ(document().state().scan->time->fractions, (std::vector<double>{0, 0.5}));
  settle();
  window().actions()["play.forward"]->trigger();
  settle();
  EXPECT_TRUE(window().slices().presenter().picture(0).title.ends_with("phase 2 of 2"))
      << window().slices().presenter().picture(0).title;
}

TEST_F(SlicesTest, AScanIsOneStepThatCanBeUndone) {
  ASSERT_TRUE(document().state().scan);
  window().actions()["scan.close"]->trigger();
  EXPECT_FALSE(document().state().scan);
  window().actions()["edit.undo"]->trigger();
  EXPECT_TRUE(document().state().scan);
  window().actions()["edit.undo"]->trigger();
  EXPECT_FALSE(document().state().scan);
  EXPECT_EQ(document().organs().size(), 1u);
}

TEST_F(SlicesTest, WithoutScanAndOrgansThe3DViewIsAloneUntilTheyReturn) {
  key(Qt::Key_F8);
  ASSERT_FALSE(view().isVisible());
  window().actions()["edit.undo"]->trigger();
  EXPECT_TRUE(slice(1).isVisible()) << "the organ is still there to be cut";
  window().actions()["edit.undo"]->trigger();
  ASSERT_TRUE(document().organs().empty());
  EXPECT_TRUE(view().isVisible());
  EXPECT_FALSE(slice(0).isVisible() || slice(1).isVisible() || slice(2).isVisible());
  window().actions()["edit.redo"]->trigger();
  EXPECT_TRUE(slice(1).isVisible());
  EXPECT_FALSE(view().isVisible());
}

TEST_F(SlicesTest, MovingASliceDrawsNo3DViewUnlessSlicesStandInIt) {
  int pictures = 0;
  const auto counting =
      QObject::connect(&window().picture(), &app::Picture::changed, [&pictures] { ++pictures; });
  turnWheel(0, 1);
  EXPECT_EQ(pictures, 0);
  window().actions()["scan.standing"]->trigger();
  settle();
  EXPECT_EQ(pictures, 1);
  turnWheel(0, 1);
  EXPECT_EQ(pictures, 2);
  QObject::disconnect(counting);
}

} // namespace
} // namespace viscera::tests
