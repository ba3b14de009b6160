#include "window_test.h"

#include <QAction>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkRenderer.h>

#include "build_paths.h"
#include "run_process.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/document/open_files.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/stress_mark_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/live/motion_recipe.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/plugin/plugin_loader.h"
#include "viscera/scene/picture.h"
#include "window/session/session_files.h"
#include "window_probe.h"

namespace viscera::tests {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 900, kHeight = 600;

constexpr const char* kPlugin = VISCERA_BINARY_DIR "/lib/viscera/plugins/localised_scc_plugin.so";

void nothingMore(app::MainWindow&) {}

void changeLook(app::MainWindow& window, const std::function<void(app::StressLook&)>& change) {
  app::StressModel& model = window.stress().model();
  app::StressLook look = model.look();
  change(look);
  model.setLook(look);
}

/// A session of format 1, and what is done in the window before it is looked at: what that format does not
/// keep.
struct Case {
  const char* name;
  void (*arrange)(app::MainWindow&) = nothingMore;
  const char* theme = "dark";
  const char* file = nullptr; ///< The session, where several cases begin with one.
};

void PrintTo(const Case& one, std::ostream* stream) {
  *stream << one.name;
}

/// Only what is above 12 degrees.
void hideBelowALimit(app::MainWindow& window) {
  changeLook(window, [](app::StressLook& look) {
    look.threshold = true;
    look.limit = 12;
    look.below = false;
  });
}

/// Only what is below 0.9, in the colours of the range that there was before the last step was taken back.
void pinTheRangeAndHideAboveALimit(app::MainWindow& window) {
  changeLook(window, [](app::StressLook& look) { look.pinned = true; });
  document::UndoStack& undo = window.workspace().undo();
  Points less = window.workspace().document().rig().restPositions();
  less += 0.5 * (window.workspace().document().pose() - less);
  undo.perform(document::setPose(less));
  changeLook(window, [](app::StressLook& look) {
    look.threshold = true;
    look.limit = 0.9;
    look.below = true;
  });
}

/// Two probes with a line between them, in colours that go by factors.
void pinProbesOnALogarithmicRange(app::MainWindow& window) {
  changeLook(window, [](app::StressLook& look) { look.logarithmic = true; });
  app::StressModel& model = window.stress().model();
  const Points& points = model.live().mesh()->points;
  for (const Eigen::Index axis : {0, 2}) {
    Eigen::Index most = 0;
    points.topRows(model.live().mesh()->witnesses).col(axis).maxCoeff(&most);
    model.setProbe(static_cast<int>(most));
    model.pinProbe();
  }
  const auto& probes = window.workspace().document().stressMarks().probes;
  ASSERT_EQ(probes.size(), 2u);
  window.workspace().perform(document::addStressLine(probes[0].id, probes[1].id));
}

void showThePeak(app::MainWindow& window) {
  window.stress().model().setPeakShown(true);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return window.stress().model().peakShown() && atPeace(window); }, 120000));
}

/// A window of 900 x 600 pixels, whose picture is compared with others of the same document.
class PictureTest : public WindowTest {
protected:
  coordinates::Registry registry() const override {
    coordinates::Registry systems = coordinates::builtInRegistry();
    plugin::loadPlugins({kPlugin}, systems);
    return systems;
  }

  /// Opens a session as a user does and waits until all that it shows is there.
  void openAndWait(const QString& file) {
    window().setTheme(app::themeFromName(QString::fromStdString(theme_)));
    setViewSize(window(), kWidth, kHeight);
    window().files().open({file});
    ASSERT_TRUE(waitUntil([&] { return !document().organs().empty(); })) << message().toStdString();
    waitForPeace();
  }

  /// Work may lead to other work: it is over when it was over for a while.
  void waitForPeace() {
    int quiet = 0;
    EXPECT_TRUE(waitUntil([&] { return (quiet = atPeace(window()) ? quiet + 1 : 0) > 12; }));
  }

  void save(const QString& file) {
    bool done = false;
    window().sessions().saveTo(file, true, [&] { done = true; });
    ASSERT_TRUE(waitUntil([&] { return done; })) << message().toStdString();
  }

  vtkSmartPointer<vtkImageData> rendered(const QString& session) {
    const std::string png = path(QStringLiteral("rendered.png")).toStdString();
    test::ProcessOptions options;
    options.environment = {{"DISPLAY", {}}, {"WAYLAND_DISPLAY", {}}, {"QT_QPA_PLATFORM", {}}};
    const auto size = std::to_string(kWidth) + "x" + std::to_string(kHeight);
    const auto result = test::runProcess(
        {VISCERA_PROGRAM, "render", session.toStdString(), "-o", png, "--size", size, "--theme", theme_},
        options);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.err, "") << "the command left something out";
    return result.exitCode == 0 ? scene::readPng(png) : nullptr;
  }

  /// Expects that two pictures are the same; else leaves both, and where they differ, for whoever looks.
  void expectSame(vtkImageData* window, vtkImageData* other, const std::string& what) {
    ASSERT_NE(other, nullptr);
    const fs::path folder = fs::path(VISCERA_BINARY_DIR) / "pictures" / "one_picture";
    const auto file = [&](const std::string& of) { return folder / (name_ + "_" + of + ".png"); };
    for (const std::string& of : {std::string("window"), what, what + "_difference"})
      fs::remove(file(of));
    const double differing = scene::comparePictures(window, other, kSameColor).differing;
    EXPECT_LE(differing, kMostDiffering)
        << 100 * differing << " % of the pixels differ: compare " << file("window") << " with " << file(what)
        << ", see " << file(what + "_difference");
    if (differing <= kMostDiffering && !std::getenv("VISCERA_KEEP_PICTURES"))
      return;
    fs::create_directories(folder);
    scene::writePng(file("window"), window);
    scene::writePng(file(what), other);
    scene::writePng(file(what + "_difference"), differenceOf(window, other));
  }

  /// White where two pictures of one size differ more than they may, else the first one, dark.
  static vtkSmartPointer<vtkImageData> differenceOf(vtkImageData* a, vtkImageData* b) {
    auto picture = vtkSmartPointer<vtkImageData>::New();
    picture->DeepCopy(a);
    if (!std::equal(a->GetDimensions(), a->GetDimensions() + 2, b->GetDimensions()))
      return picture;
    auto* out = static_cast<unsigned char*>(picture->GetScalarPointer());
    const auto* other = static_cast<const unsigned char*>(b->GetScalarPointer());
    for (vtkIdType pixel = 0; pixel < a->GetNumberOfPoints(); ++pixel) {
      bool differs = false;
      for (vtkIdType i = 3 * pixel; i < 3 * pixel + 3; ++i)
        differs = differs || std::abs(out[i] - other[i]) > kSameColor;
      for (vtkIdType i = 3 * pixel; i < 3 * pixel + 3; ++i)
        out[i] = differs ? 255 : static_cast<unsigned char>(out[i] / 4);
    }
    return picture;
  }

  /// The window's picture is the command's of `session` (none: of what is saved now), and the one of a window
  /// that opens what is saved.
  void expectOnePicture(const QString& session) {
    const auto picture = grab(window());
    ASSERT_EQ(picture->GetDimensions()[0], kWidth);
    ASSERT_EQ(picture->GetDimensions()[1], kHeight);
    const QString saved = path(QStringLiteral("saved.viscera"));
    save(saved);
    expectSame(picture, rendered(session.isEmpty() ? saved : session), "command");
    reopenWindow();
    openAndWait(saved);
    expectSame(picture, grab(window()), "opened");
  }

  std::string name_; ///< Of pictures that differ.
  std::string theme_ = "dark";
};

class OnePicture : public PictureTest, public testing::WithParamInterface<Case> {
  void SetUp() override {
    name_ = GetParam().name;
    theme_ = GetParam().theme;
    PictureTest::SetUp();
  }
};

TEST_P(OnePicture, OfWindowAndCommandIsOneAndComesBackFromAFile) {
  const QString fixture = QStringLiteral(VISCERA_SOURCE_DIR "/tests/gui/sessions/%1.viscera")
                              .arg(GetParam().file ? GetParam().file : GetParam().name);
  ASSERT_NE(contentsOf(fixture.toStdString()).find("\"version\": 1,"), std::string::npos);
  openAndWait(fixture);
  if (HasFatalFailure())
    return;
  EXPECT_EQ(message(), QString()) << "a session that opens as it was has nothing to say";
  GetParam().arrange(window());
  waitForPeace();
  expectOnePicture(GetParam().arrange == nothingMore ? fixture : QString());
}

constexpr Case kCases[] = {
    {"explore_see_through_labels"},
    {"explore_hidden_organ_measured_parallel"},
    {"explore_handles_shown_posed"},
    {"handles_influence"},
    {"handles_regions_zones"},
    {"handles_cage_ghost"},
    {"handles_hidden_locked"},
    {"deform_ghost_compensating"},
    {"deform_influence_translucent"},
    {"stress_rotational_smooth_handles"},
    {"stress_volume_crinkle"},
    {"stress_stretch_max_limit", hideBelowALimit},
    {"stress_stretch_min_pinned_crosses", pinTheRangeAndHideAboveALimit},
    {"stress_rotational_ellipsoids"},
    {"stress_probes_logarithmic", pinProbesOnALogarithmicRange, "light", "stress_rotational_smooth_handles"},
    {"stress_peak_recorded", showThePeak},
    {"play_recorded_locked"},
};

INSTANTIATE_TEST_SUITE_P(Sessions, OnePicture, testing::ValuesIn(kCases),
                         [](const auto& of) { return std::string(of.param.name); });

/// An instant of a sequence that the program brings. What it looks like is not kept in a file: it becomes
/// another one whenever a motion is improved.
class OnePictureOfAMotion : public PictureTest {
protected:
  /// A sample organ with its motion, at low resolution.
  void playSample(const std::string& sequence) {
    window().setTheme(app::themeFromName(QString::fromStdString(theme_)));
    setViewSize(window(), kWidth, kHeight);
    Progress progress;
    auto setup = live::setUpSequence(sample_organs::standardLibrary(), sequence,
                                     sample_organs::Resolution::low, progress);
    auto organs = document::organsFrom(setup.organ);
    document::UndoStack& undo = window().workspace().undo();
    undo.perform(document::combined("Sample", {document::setSystem(setup.system), document::addOrgans(organs),
                                               document::replaceRig(setup.rig)}));
    window().workspace().selection().setOrgan(document().organs().front()->id);
    window().playback().setSequence(setup.sequence, document().organs().front()->id,
                                    live::SampleMotion{sequence, sample_organs::Resolution::low});
    waitForPeace();
  }

  void toggle(const char* action, bool on) { window().actions()[action]->setChecked(on); }

  void lookFromTheFront() {
    view().view().lookFrom(scene::StandardView::anterior);
    vtkCamera* camera = view().view().renderer()->GetActiveCamera();
    camera->Azimuth(20);
    camera->Elevation(12);
    camera->OrthogonalizeViewUp();
    view().view().renderer()->ResetCameraClippingRange();
    waitForPeace();
  }
};

TEST_F(OnePictureOfAMotion, AHeartThatStandsInItsBeatIsSeenThrough) {
  name_ = "heart";
  playSample("heartbeat");
  document::OrganLook look = document().organs().front()->look;
  look.opacity = 0.3;
  window().workspace().perform(document::setOrganLook(document().organs().front()->id, look));
  window().setMode("play");
  toggle("view.labels", true);
  window().playback().setRate(90);
  window().playback().seek(0.33);
  lookFromTheFront();
  expectOnePicture({});
}

TEST_F(OnePictureOfAMotion, AStomachInItsWavesHasItsGhostAndItsHandles) {
  name_ = "stomach";
  theme_ = "light";
  playSample("peristalsis");
  window().setMode("play");
  window().playback().seek(0.6);
  toggle("view.ghost", true);
  toggle("view.handles", true);
  lookFromTheFront();
  expectOnePicture({});
}

TEST_F(OnePictureOfAMotion, AHeartThatFoldsIsSeenAmongOtherOrgans) {
  name_ = "folded_heart";
  playSample("heartbeat");
  changeLook(window(), [](app::StressLook& look) {
    look.witnesses = 600;
    look.quantity = live::StressQuantity::folded;
    look.others = true;
    look.normal = Vec3(0, 1, 0);
  });
  // One that is no cavity: it stays where the others do.
  const Vec3 corner = boundsOf(document().organs().front()->mesh->points).high;
  const document::OrganId heart = document().organs().front()->id;
  window().workspace().perform(document::addOrgans(
      {{document::makeOrgan("Stone", std::make_shared<const geometry::TriangleMesh>(sphere(2, 12, corner))),
        -1}}));
  window().workspace().selection().setOrgan(heart);
  window().playback().seek(0.33);
  window().setMode("stress");
  lookFromTheFront();
  expectOnePicture({});
}

} // namespace
} // namespace viscera::tests
