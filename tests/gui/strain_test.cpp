#include "play_fixture.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "viscera/document/rig_commands.h"
#include "viscera/presentation/strain_figure.h"
#include "viscera/presentation/view_state.h"
#include "viscera/scene/picture.h"
#include "viscera/strain/aha_segments.h"
#include "window/compare/comparison.h"
#include "window/movie/movie_plan.h"
#include "window/strain/axis_picker.h"
#include "window/strain/strain_panel.h"
#include "window_probe.h"

/// The strain of the heart's wall: below the view, on the organ, and of two views.
namespace viscera::tests {
namespace {

/// ms: the panel lets the organs be drawn first.
constexpr int kDrawnMs = 80;
/// A quarter of what users have: what is drawn is compared with what was measured, however finely.
constexpr int kWitnesses = 10'000;

class PlayedStrain : public PlayMode {
protected:
  void SetUp() override {
    PlayMode::SetUp();
    model().setWitnesses(kWitnesses);
    window().actions()["play.strain"]->trigger();
    ASSERT_TRUE(waitUntil([this] { return model().cycle() != nullptr; }))
        << model().failureReason().toStdString();
    drawn();
  }
  app::StrainModel& model() { return parts().strain(); }
  app::StrainPanel& panel() { return *window().findChild<app::StrainPanel*>(); }
  /// Waits until the panel has drawn what is measured.
  void drawn() {
    QTest::qWait(kDrawnMs);
    ASSERT_TRUE(waitUntil([this] { return !model().busy(); }));
    QTest::qWait(kDrawnMs);
  }
  int chosen() { return window().viewModel().state().strain.segment; }
  void showSegmentsAtHalfABeat() {
    window().actions()["play.strainOnOrgan"]->trigger();
    window().viewModel().change([](presentation::ViewState& state) {
      state.strain.moment = live::StrainMoment::instant;
      state.heartSigns = {false, false, false, false, false}; // Nothing stands below the picture.
    });
    window().playback().seek(0.5);
  }
  /// Records one beat in eight pictures and returns the fifth; null when that fails.
  vtkSmartPointer<vtkImageData> frameOfHalfABeat(int width) {
    app::MoviePlan plan;
    plan.format = app::MovieFormat::pictures;
    plan.file = path(QStringLiteral("beat"));
    plan.size = {width, 480};
    plan.framesPerSecond = 10;
    plan.caption = false;
    if (!parts().record(plan) || !waitUntil([this] { return !parts().recorder().running(); }))
      return nullptr;
    const QStringList frames = QDir(plan.file).entryList(QDir::Files, QDir::Name);
    EXPECT_EQ(frames.size(), 8);
    return frames.size() == 8 ? scene::readPng((plan.file + QLatin1Char('/') + frames[4]).toStdString())
                              : nullptr;
  }
  void onEyes(QEvent::Type type, const QPointF& place) {
    auto& eyes = find<QVTKOpenGLNativeWidget>("strainEyes");
    const bool moves = type == QEvent::MouseMove;
    QMouseEvent event(type, place, moves ? Qt::NoButton : Qt::LeftButton,
                      moves ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&eyes, &event);
  }
  void expectTheBeat() {
    EXPECT_TRUE(panel().isVisible());
    ASSERT_EQ(panel().figures().size(), 1U);
    const auto eye = presentation::strainBullsEye(*model().cycle(), live::StrainDirection::longitudinal,
                                                  live::StrainMoment::peak);
    ASSERT_EQ(panel().figures()[0].sectors.size(), eye.sectors.size());
    for (std::size_t i = 0; i < eye.sectors.size(); ++i)
      EXPECT_EQ(panel().figures()[0].sectors[i].value, eye.sectors[i].value) << i;
    EXPECT_EQ(panel().curves().bands.size(), 3U) << "GLS, GCS, GRS";
    const QString gls =
        QStringLiteral("GLS %1 %").arg(100 * model().cycle()->strain.gls->peak.value, 0, 'f', 1);
    EXPECT_TRUE(find<QLabel>("strainNumbers").text().contains(gls)) << gls.toStdString();
    EXPECT_FALSE(find<QVTKOpenGLNativeWidget>("strainEyes").toolTip().isEmpty()) << "the definition";
  }

  void expectSegmentsUnderTheMouse() {
    const std::size_t curves = panel().curves().curves.size();
    const auto& eyes = find<QVTKOpenGLNativeWidget>("strainEyes");
    QPointF place(0, 0.5 * eyes.height()); // From the left the septum comes first.
    while (chosen() == 0 && place.x() < eyes.width()) {
      place.rx() += 4;
      onEyes(QEvent::MouseButtonPress, place);
    }
    const int segment = chosen();
    ASSERT_GE(segment, 1);
    EXPECT_TRUE(strain::segments()[static_cast<std::size_t>(segment - 1)].septal) << segment;
    onEyes(QEvent::MouseButtonPress, place);
    EXPECT_EQ(chosen(), 0) << "a second click chooses none";
    onEyes(QEvent::MouseMove, place);
    EXPECT_TRUE(waitUntil([&] { return panel().curves().curves.size() == curves + 1; }));
    EXPECT_TRUE(find<QLabel>("strainSegment").text().startsWith(QString::number(segment)));
    QEvent leaves(QEvent::Leave);
    QCoreApplication::sendEvent(&find<QVTKOpenGLNativeWidget>("strainEyes"), &leaves);
    EXPECT_TRUE(waitUntil([&] { return panel().curves().curves.size() == curves; }));
  }

  void expectSegmentsOnTheOrgan() {
    window().actions()["play.strainOnOrgan"]->trigger();
    settle();
    const document::OrganId left = organ("LV");
    const auto coloured = [this](document::OrganId id) {
      const auto actor = window().picture().actorOf(id);
      return actor && actor->scalarsShown();
    };
    EXPECT_TRUE(coloured(left));
    EXPECT_FALSE(coloured(organ("RV")));
    EXPECT_LT(window().picture().actorOf(organ("RV"))->opacity(), 0.2) << "else it hides the left one";
    window().setMode("explore"); // It has no switch for them.
    settle();
    EXPECT_FALSE(coloured(left));
    window().setMode("play");
    settle();
    EXPECT_TRUE(coloured(left));
    const std::vector<int>* segments = model().segmentsOn(left);
    ASSERT_NE(segments, nullptr);
    const auto seventh = std::find(segments->begin(), segments->end(), 7);
    ASSERT_NE(seventh, segments->end());
    const Eigen::Index row = seventh - segments->begin();
    const app::ClickedPlace place{left, window().workspace().live().points(left).row(row).transpose(),
                                  Vec3::UnitZ()};
    parts().click(&place);
    EXPECT_EQ(chosen(), 7);
    EXPECT_TRUE(waitUntil([this] { return panel().figures()[0].selected == 6; })) << "both ways";
    window().actions()["play.strainOnOrgan"]->trigger();
    settle();
    EXPECT_FALSE(coloured(left));
  }

  void expectThePoseOfADrag() {
    key(Qt::Key_3);
    settle();
    Points moved(1, 3);
    moved.row(0) = 0.8 * document().pose().row(0);
    window().workspace().perform(document::moveHandles({document().rig().handles.front().id}, moved));
    ASSERT_TRUE(waitUntil([this] { return model().pose() != nullptr; })) << message().toStdString();
    drawn();
    const auto eye = presentation::strainBullsEye(*model().pose(), live::StrainDirection::longitudinal,
                                                  live::StrainMoment::instant, 1);
    ASSERT_EQ(panel().figures().size(), 1U);
    EXPECT_EQ(panel().figures()[0].sectors[0].value, eye.sectors[0].value);
    EXPECT_FALSE(panel().remarks().isEmpty()) << "what it shows is said";
    window().workspace().undo().undo();
    EXPECT_TRUE(waitUntil([this] { return model().pose() == nullptr; }));
  }

  void expectNumbersAsTheCommandPrints() {
    const strain::HeartStrain& strain = model().cycle()->strain;
    const QString numbers = find<QLabel>("strainNumbers").text();
    for (const double value :
         {100 * strain.rightFreeWall->peak.value, *live::largestTurn(strain.twistDegrees),
          *live::largestTurn(strain.torsionDegreesPerCm)})
      EXPECT_TRUE(numbers.contains(QString::number(std::abs(value), 'f', std::abs(value) < 3 ? 2 : 1)))
          << value << " in " << numbers.toStdString();
    window().viewModel().change([](presentation::ViewState& state) { state.strain.segment = 7; });
    const auto wall = live::wallThickness(*model().cycle(), 7);
    ASSERT_TRUE(wall);
    const auto& segment = find<QLabel>("strainSegment");
    const QString thickness = QString::number(wall->millimeters, 'f', 1) + QStringLiteral(" mm");
    EXPECT_TRUE(waitUntil([&] { return segment.text().contains(thickness); }))
        << segment.text().toStdString();
    auto& direction = find<QComboBox>("strainDirection");
    direction.setCurrentIndex(3);
    Q_EMIT direction.activated(3);
    EXPECT_TRUE(waitUntil([&] {
      return std::abs(panel().figures()[0].sectors[6].value.value() - wall->thickeningPercent) < 1e-9;
    }));
    window().viewModel().change([](presentation::ViewState& state) {
      state.strain.direction = live::StrainDirection::longitudinal;
      state.strain.segment = 0;
    });
  }

  void expectTheChosenReference() {
    const std::size_t found = model().cycle()->strain.reference;
    auto& reference = find<QComboBox>("strainReference");
    ASSERT_EQ(reference.count(), static_cast<int>(model().cycle()->strain.seconds.size()) + 1);
    const std::size_t wanted = found == 9 ? 8 : 9;
    reference.setCurrentIndex(static_cast<int>(wanted) + 1);
    Q_EMIT reference.activated(static_cast<int>(wanted) + 1);
    ASSERT_TRUE(waitUntil([&] { return model().cycle() && model().cycle()->strain.reference == wanted; }));
    EXPECT_NEAR(model().cycle()->strain.gcs->curve[wanted], 0, 1e-12);
    EXPECT_EQ(presentation::viewFromJson(presentation::toJson(window().viewModel().state())).strain.reference,
              static_cast<int>(wanted) + 1)
        << "a session keeps it";
    window().viewModel().change([](presentation::ViewState& state) { state.strain.reference = 0; });
    ASSERT_TRUE(waitUntil([&] { return model().cycle() && model().cycle()->strain.reference == found; }));
    drawn();
    EXPECT_EQ(reference.currentIndex(), 0);
  }

  void expectAxesThatAreClicked() {
    const Vec3 found = model().cycle()->strain.axes.towardsInsertion();
    find<QAction>("strainInsertion").trigger();
    EXPECT_TRUE(panel().axes().picking());
    EXPECT_TRUE(view().hasClickHandler());
    const app::StrainModel::Reading before = model().cycle();
    click(QPoint(view().width() / 2, view().height() / 2));
    EXPECT_FALSE(panel().axes().picking());
    const presentation::StrainLook look = window().viewModel().state().strain;
    ASSERT_TRUE(look.insertion);
    EXPECT_EQ(look.axesOf, organ("LV"));
    ASSERT_TRUE(waitUntil([&] { return model().cycle() && model().cycle() != before; }))
        << model().failureReason().toStdString();
    EXPECT_NEAR(std::remainder(model().cycle()->strain.axes.angleOf(*look.insertion), 2 * std::numbers::pi),
                0, 1e-6);
    EXPECT_EQ(panel().axes().glyphs().items().size(), 1U);
    find<QAction>("strainByShape").trigger();
    EXPECT_FALSE(window().viewModel().state().strain.insertion);
    ASSERT_TRUE(waitUntil([&] {
      return model().cycle() && (model().cycle()->strain.axes.towardsInsertion() - found).norm() < 1e-9;
    }));
    EXPECT_TRUE(panel().axes().glyphs().items().empty());
    drawn();
  }

  document::OrganId organ(const char* name) {
    for (const auto& each : document().organs())
      if (each->name == name)
        return each->id;
    return {};
  }
};

/// One test, because the strain of a beat takes seconds.
TEST_F(PlayedStrain, IsDrawnAndFollowsMouseOrganAndPose) {
  expectTheBeat();
  expectNumbersAsTheCommandPrints();
  expectTheChosenReference();
  expectSegmentsUnderTheMouse();
  expectSegmentsOnTheOrgan();
  expectThePoseOfADrag();
}

TEST_F(PlayedStrain, IsMeasuredAlongAxesThatAreClicked) {
  expectAxesThatAreClicked();
}

/// As the window shows them at the same instant.
TEST_F(PlayedStrain, OnTheOrganIsInMovies) {
  setViewSize(window(), 640, 480);
  showSegmentsAtHalfABeat();
  ASSERT_TRUE(waitUntil([this] { return atPeace(window()); }));
  const auto frame = frameOfHalfABeat(640);
  ASSERT_TRUE(frame);
  EXPECT_LE(scene::comparePictures(grab(window()), frame, 8).differing, 0.005) << "half a beat";
}

/// What is drawn at the right edge of the upper part of a picture that begins at column `x` of a movie's
/// frame, where the legend of a map is; `left`: at its left edge, where nothing is.
vtkSmartPointer<vtkImageData> edgeOf(vtkImageData* frame, int x, bool left) {
  const int* size = frame->GetDimensions();
  const int width = size[0] / 8, height = size[1] / 2, bytes = frame->GetNumberOfScalarComponents();
  const int begin = left ? x : x + size[0] / 2 - width;
  auto edge = vtkSmartPointer<vtkImageData>::New();
  edge->SetDimensions(width, height, 1);
  edge->AllocateScalars(VTK_UNSIGNED_CHAR, bytes);
  for (int y = 0; y < height; ++y)
    std::copy_n(static_cast<unsigned char*>(frame->GetScalarPointer(begin, size[1] - height + y, 0)),
                bytes * width, static_cast<unsigned char*>(edge->GetScalarPointer(0, y, 0)));
  return edge;
}

/// The same heart at another rate: its segments have colours in the window, and a legend in its half of a
/// movie.
TEST_F(PlayedStrain, OnTheOrganIsInBothViewsAndBothHalvesOfMovies) {
  app::Comparison& comparison = parts().comparison();
  comparison.showSameOrgan();
  showSegmentsAtHalfABeat();
  const auto colouredInSecond = [&] {
    for (const auto& each : comparison.workspace().document().organs())
      if (const auto actor = comparison.picture().actorOf(each->id); each->name == "LV" && actor)
        return actor->scalarsShown();
    return false;
  };
  ASSERT_TRUE(waitUntil(colouredInSecond));
  ASSERT_TRUE(waitUntil([this] { return atPeace(window()); }));
  const auto frame = frameOfHalfABeat(1280);
  ASSERT_TRUE(frame);
  const int half = frame->GetDimensions()[0] / 2;
  EXPECT_LE(scene::comparePictures(edgeOf(frame, 0, false), edgeOf(frame, half, false), 8).differing, 0.005);
  EXPECT_GT(scene::comparePictures(edgeOf(frame, half, false), edgeOf(frame, half, true), 8).differing, 0.02);
  window().actions()["play.strainOnOrgan"]->trigger();
  settle();
  EXPECT_FALSE(colouredInSecond());
}

TEST_F(PlayedStrain, OfTwoViewsShowsBothAndTheirDifference) {
  parts().comparison().showSameOrgan();
  ASSERT_TRUE(waitUntil([this] { return panel().figures().size() == 3; }));
  const auto& eyes = panel().figures();
  for (std::size_t i = 0; i < eyes[0].sectors.size(); ++i)
    if (eyes[2].sectors[i].value) {
      EXPECT_NEAR(*eyes[2].sectors[i].value, *eyes[0].sectors[i].value - *eyes[1].sectors[i].value, 1e-9);
    }
  parts().comparison().end();
  EXPECT_TRUE(waitUntil([this] { return panel().figures().size() == 1; }));
}

TEST_F(WindowTest, StrainNeedsALeftVentricle) {
  open(sphereFile());
  EXPECT_FALSE(window().actions()["play.strain"]->isEnabled());
  EXPECT_EQ(window().play().strain().cycle(), nullptr);
}

} // namespace
} // namespace viscera::tests
