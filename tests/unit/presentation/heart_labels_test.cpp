#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sequence_scene.h"
#include "viscera/core/job_queue.h"
#include "viscera/document/open_files.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/live_binding.h"
#include "viscera/presentation/opened_heart.h"
#include "viscera/presentation/resection.h"
#include "viscera/presentation/stage.h"
#include "viscera/scene/surface_pick.h"

/// The names in pictures of the sample heart, against what is drawn there.
namespace viscera::presentation {
namespace {

constexpr int kWide = 640, kHigh = 480;
/// Every second of the twenty that were looked at: a picture takes 0.2 s without a graphics card.
constexpr int kInstants = 10;
constexpr double kNever = std::numeric_limits<double>::infinity();
/// The end of a line is that near to what it names, mm, and that far behind what is drawn there at most.
constexpr double kNear = 10;

/// What is drawn at a place of the picture.
struct Met {
  double distance = kNever; ///< From the eye, mm.
  bool face = false;        ///< The face of the cut, in the heart's walls.
};

/// The beating sample heart in a picture of its own, with all names.
class NamedHeart {
public:
  NamedHeart() {
    undo_.perform(document::setSystem(setup_.system));
    undo_.perform(document::addOrgans(document::organsFrom(setup_.organ)));
    undo_.perform(document::replaceRig(setup_.rig));
    view_.labels = view_.partNames = true;
  }

  void cut(const Vec3& normal, double offset, bool blood = false) {
    view_.cut = {true, normal.normalized(), offset, blood};
  }
  void lookFrom(scene::StandardView side) {
    show(0);
    stage_.compose(side, 0.3);
  }
  /// Along the cut, with all of the heart in the picture.
  void lookAtTheCut() {
    lookFrom(scene::StandardView::anterior);
    Camera camera = cameraOf(stage_.view());
    const double distance = (camera.position - camera.focus).norm();
    camera.position = camera.focus - distance * view_.cut.normal;
    camera.up = std::abs(view_.cut.normal.z()) < 0.9 ? Vec3::UnitZ() : Vec3(-Vec3::UnitY());
    presentation::lookFrom(camera, stage_.view());
  }
  void show(double fraction) {
    constexpr double kRate = 75;
    Points pose;
    setup_.sequence->poseAt(fraction * 60 / kRate, kRate, pose);
    live_.showPose(pose);
    if (view_.cut.on && !tissue_)
      tissue_ = heartTissueFor(document_.state(), view_, tests::cachedLibrary(), progress_);
    Scene scene{document_.state(), live_, view_, registry_};
    scene.heartTissue = tissue_;
    stage_.presenter().update(scene);
    stage_.picture();
  }

  std::set<std::string> names() {
    std::set<std::string> all;
    for (const auto& label : stage_.presenter().labels().drawn())
      all.insert(inOneLine(label.text));
    return all;
  }
  /// Names whose line ends beside what they name, or where something hides that.
  std::vector<std::string> astray() {
    std::vector<std::string> wrong;
    for (const auto& label : stage_.presenter().labels().drawn())
      if (const std::string name = inOneLine(label.text);
          !isOn(name, scene::rayThrough(stage_.view().renderer(), label.targetX, label.targetY)))
        wrong.push_back(name);
    return wrong;
  }

private:
  static std::string inOneLine(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  }

  /// The walls of a heart that is cut open, else the surfaces of the organs.
  Met drawnAt(const scene::Ray& ray) {
    const scene::OrganActor* walls = stage_.presenter().heartTissue();
    if (!walls) {
      const auto pick = pickAt(ray);
      return pick ? Met{pick->distance} : Met();
    }
    const scene::CutPlane plane = planeOf(view_.cut, document_.state());
    const double begin = (plane.origin - ray.origin).dot(plane.normal) / ray.direction.dot(plane.normal);
    Met met;
    bool leaves = false;
    const Points& points = walls->points();
    const Triangles& triangles = walls->mesh().triangles;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
      const Vec3 a = points.row(triangles(t, 0)).transpose();
      const Vec3 ab = points.row(triangles(t, 1)).transpose() - a;
      const Vec3 ac = points.row(triangles(t, 2)).transpose() - a;
      const Vec3 normal = ab.cross(ac), cross = ray.direction.cross(ray.origin - a);
      const double along = ray.direction.dot(normal);
      const double u = ac.dot(cross) / along, v = -ab.dot(cross) / along;
      const double distance = (a - ray.origin).dot(normal) / along;
      if (!(u >= 0) || !(v >= 0) || u + v > 1 || distance < begin || distance >= met.distance)
        continue;
      met.distance = distance;
      leaves = along > 0;
    }
    return leaves ? Met{begin, true} : met;
  }
  std::optional<scene::SurfacePick> pickAt(const scene::Ray& ray) {
    std::vector<scene::OrganActor*> all;
    for (const auto& organ : stage_.view().organs())
      all.push_back(organ.get());
    return scene::pickSurface(ray, all);
  }

  bool isSeen(const Vec3& place, const scene::Ray& ray) {
    const double along = (place - ray.origin).dot(ray.direction);
    return (ray.origin + along * ray.direction - place).norm() < kNear &&
           along < drawnAt(ray).distance + kNear;
  }
  bool isOn(const std::string& name, const scene::Ray& ray) {
    if (name == "Septum")
      return drawnAt(ray).face;
    if (name == "Chordae tendineae")
      return !drawnAt(ray).face;
    for (const Part& part : partsOf(document_.organs()))
      if (nameOf(part, document_.organs()) == name)
        return isSeen(live_.sharedPoints(part.organ)->row(part.vertex).transpose(), ray);
    for (const auto& organ : document_.organs())
      if (labelOf(*organ) == name)
        return isOnOrgan(*organ, ray);
    return isOnVessel(name, ray);
  }
  /// A chamber that is cut open is named on its wall, the heart's muscle also in the face of the cut.
  bool isOnOrgan(const document::Organ& organ, const scene::Ray& ray) {
    const Met met = drawnAt(ray);
    if (!stage_.presenter().heartTissue()) {
      const auto pick = pickAt(ray);
      return pick && stage_.presenter().organOf(pick->organ) == organ.id;
    }
    if (!organ.parent)
      return std::isfinite(met.distance);
    const Vec3 at = ray.origin + met.distance * ray.direction;
    const Points& points = *live_.sharedPoints(organ.id);
    return !met.face && (points.rowwise() - at.transpose()).rowwise().norm().minCoeff() < kNear;
  }
  bool isOnVessel(const std::string& name, const scene::Ray& ray) {
    if (!tissue_)
      return false;
    const live::HeartVessels& vessels = tissue_->vessels();
    Points lines;
    vessels.linesAt(tissue_->carriersAt(*live::sampleHeartIn(document_.state()), live_), lines);
    for (std::size_t i = 0; i < vessels.vessels().size(); ++i)
      for (Eigen::Index p = 0; vessels.vessels()[i].name == name && p < vessels.vessels()[i].axis.rows(); ++p)
        if (isSeen(lines.row(vessels.first(i) + p).transpose(), ray))
          return true;
    return false;
  }

  Progress progress_;
  live::SequenceSetup setup_ =
      live::setUpSequence(tests::cachedLibrary(), "heartbeat", sample_organs::Resolution::low, progress_);
  document::Document document_;
  document::UndoStack undo_{document_};
  coordinates::Registry registry_ = coordinates::builtInRegistry();
  JobQueue jobs_{[](const std::function<void()>& work) { work(); }};
  live::LiveBinding live_{document_, registry_, jobs_, {kNever, {}}};
  ViewState view_;
  std::shared_ptr<const live::HeartTissue> tissue_;
  Stage stage_{kWide, kHigh, scene::lightTheme()};
};

void expectNamesOnTheirParts(NamedHeart& heart) {
  for (int instant = 0; instant < kInstants; ++instant) {
    heart.show(static_cast<double>(instant) / kInstants);
    EXPECT_THAT(heart.astray(), testing::IsEmpty()) << "at instant " << instant;
    EXPECT_GT(heart.names().size(), 1u) << "there is more than one name in the picture";
  }
}

TEST(HeartLabels, LieOnTheirPartsThroughoutTheBeatFromTheFront) {
  NamedHeart heart;
  heart.lookFrom(scene::StandardView::anterior);
  expectNamesOnTheirParts(heart);
}

/// A plane of resources/scripts/draw_heart_cuts.py, by its normal and its place along it, and names of what
/// it opens.
struct HeartCut {
  const char* name;
  Vec3 normal;
  double offset;
  std::vector<std::string> opened;
};

const HeartCut kFourChamber = {"FourChamber",
                               Vec3(-0.2900, 0.3687, -0.8831),
                               0.2599,
                               {"LV cavity", "RV cavity", "LA cavity", "RA cavity", "Septum"}};
const HeartCut kTwoChamber = {"TwoChamber",
                              Vec3(-0.6618, -0.7449, 0.0850),
                              -0.1092,
                              {"LV cavity", "LA cavity", "Mitral valve", "Aortic valve"}};
const HeartCut kThreeChamber = {
    "ThreeChamber", Vec3(-0.7691, -0.4429, -0.4608), 0.0602, {"LV cavity", "LA cavity", "Septum"}};
const HeartCut kShortAxisBase = {
    "ShortAxisBase",
    Vec3(-0.6388, 0.5490, 0.5390),
    -0.1352,
    {"LV cavity", "RV cavity", "Mitral valve", "Aortic valve", "Tricuspid valve", "Septum"}};

std::string nameOfCut(const testing::TestParamInfo<HeartCut>& cut) {
  return cut.param.name;
}

class HeartLabelsInCut : public testing::TestWithParam<HeartCut> {};

TEST_P(HeartLabelsInCut, NameWhatItOpens) {
  NamedHeart heart;
  heart.cut(GetParam().normal, GetParam().offset);
  heart.lookAtTheCut();
  heart.show(0);
  EXPECT_THAT(heart.names(), testing::IsSupersetOf(GetParam().opened));
}

INSTANTIATE_TEST_SUITE_P(Four, HeartLabelsInCut,
                         testing::Values(kFourChamber, kTwoChamber, kThreeChamber, kShortAxisBase),
                         nameOfCut);

class HeartLabelsInBeatingCut : public testing::TestWithParam<HeartCut> {};

TEST_P(HeartLabelsInBeatingCut, LieOnTheirPartsThroughoutTheBeat) {
  NamedHeart heart;
  heart.cut(GetParam().normal, GetParam().offset);
  heart.lookAtTheCut();
  expectNamesOnTheirParts(heart);
}

INSTANTIATE_TEST_SUITE_P(Two, HeartLabelsInBeatingCut, testing::Values(kTwoChamber, kThreeChamber),
                         nameOfCut);

} // namespace
} // namespace viscera::presentation
