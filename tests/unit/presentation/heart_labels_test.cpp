#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRenderer.h>

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

/// The names in pictures of the sample heart, against what is drawn there.
namespace viscera::presentation {
namespace {

constexpr int kWide = 640, kHigh = 480, kInstants = 20;
constexpr double kNever = std::numeric_limits<double>::infinity();
/// The end of a line is that near to what it names, mm, and that far behind what is drawn there at most.
constexpr double kNear = 10;
/// A chamber is in sight where all of a square of that many pixels shows its wall ...
constexpr int kSquare = 33;
/// ... which is that near to its surface, mm, and away from its named parts by that much.
constexpr double kOnWall = 3, kOffParts = 10;

/// What is nearest at each pixel, of surfaces and of what a plane leaves of them.
class DepthPicture {
public:
  struct Pixel {
    double depth = kNever; ///< Along the direction of sight, mm.
    int surface = -1;      ///< The number of the one that is seen.
    bool inside = false;   ///< From inside.
  };

  explicit DepthPicture(vtkCamera* camera)
      : eye_(camera->GetPosition()), forward_(camera->GetDirectionOfProjection()),
        right_(forward_.cross(Vec3(camera->GetViewUp())).normalized()), up_(right_.cross(forward_)),
        scale_(kHigh / 2.0 / std::tan(camera->GetViewAngle() * EIGEN_PI / 360)) {}

  /// Where a place is: pixels, and its depth.
  Vec3 project(const Vec3& place) const {
    const Vec3 to = place - eye_;
    const double depth = to.dot(forward_);
    return {kWide / 2.0 + scale_ * to.dot(right_) / depth, kHigh / 2.0 + scale_ * to.dot(up_) / depth, depth};
  }
  Vec3 placeAt(double x, double y, double depth) const {
    return eye_ + depth * (forward_ + (x - kWide / 2.0) / scale_ * right_ + (y - kHigh / 2.0) / scale_ * up_);
  }
  Pixel at(double x, double y) const {
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const bool in = column >= 0 && row >= 0 && column < kWide && row < kHigh;
    return in ? pixels_[static_cast<std::size_t>(row * kWide + column)] : Pixel();
  }

  void add(const Points& points, const Triangles& triangles, int surface,
           const std::optional<scene::CutPlane>& plane) {
    for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
      std::array<Vec3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = project(points.row(triangles(t, static_cast<Eigen::Index>(k))).transpose());
      addTriangle(corners, surface, plane);
    }
  }

private:
  void addTriangle(const std::array<Vec3, 3>& at, int surface, const std::optional<scene::CutPlane>& plane) {
    const auto [left, right] = std::minmax({at[0].x(), at[1].x(), at[2].x()});
    const auto [low, high] = std::minmax({at[0].y(), at[1].y(), at[2].y()});
    const auto turn = [](const Vec3& a, const Vec3& b, double x, double y) {
      return (b.x() - a.x()) * (y - a.y()) - (x - a.x()) * (b.y() - a.y());
    };
    const double area = turn(at[0], at[1], at[2].x(), at[2].y());
    for (int row = std::max(0, static_cast<int>(low)); row <= std::min(kHigh - 1.0, high); ++row)
      for (int column = std::max(0, static_cast<int>(left)); column <= std::min(kWide - 1.0, right);
           ++column) {
        const double x = column + 0.5, y = row + 0.5;
        const double c = turn(at[0], at[1], x, y) / area, a = turn(at[1], at[2], x, y) / area;
        const double b = 1 - a - c, depth = 1 / (a / at[0].z() + b / at[1].z() + c / at[2].z());
        Pixel& pixel = pixels_[static_cast<std::size_t>(row * kWide + column)];
        if (!(a >= 0) || !(b >= 0) || !(c >= 0) || !(depth < pixel.depth))
          continue;
        if (!plane || (placeAt(x, y, depth) - plane->origin).dot(plane->normal) >= 0)
          pixel = {depth, surface, area < 0};
      }
  }

  Vec3 eye_, forward_, right_, up_;
  double scale_;
  std::vector<Pixel> pixels_ = std::vector<Pixel>(std::size_t(kWide * kHigh));
};

/// The beating sample heart in a picture of its own, with all names.
class NamedHeart {
public:
  NamedHeart() {
    undo_.perform(document::setSystem(setup_.system));
    undo_.perform(document::addOrgans(document::organsFrom(setup_.organ)));
    undo_.perform(document::replaceRig(setup_.rig));
    view_.labels = view_.partNames = true;
    parts_ = partsOf(document_.organs());
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
    stage_.view().renderer()->InvokeEvent(vtkCommand::StartEvent); // Names find their places.
    draw();
  }

  /// The same while the heart beats: names stay where they were as long as they are right.
  void beatTo(double fraction) {
    stage_.view().setMoving(true);
    show(fraction);
    stage_.view().setMoving(false);
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
      if (const std::string name = inOneLine(label.text); !isOn(name, label.targetX, label.targetY))
        wrong.push_back(name);
    return wrong;
  }
  /// The chambers that a cut leaves open in sight.
  std::set<std::string> chambersInSight() {
    std::set<std::string> seen;
    for (int i = 0; i < static_cast<int>(document_.organs().size()); ++i)
      if (isInSight(i))
        seen.insert(labelOf(*document_.organs()[static_cast<std::size_t>(i)]));
    return seen;
  }
  /// The valves of opened chambers that nothing hides.
  std::set<std::string> valvesInSight() {
    std::set<std::string> seen;
    for (const Part& part : parts_) {
      const std::string& name = nameOf(part, document_.organs());
      const Vec3 place = live_.sharedPoints(part.organ)->row(part.vertex).transpose();
      if (name.find("valve") != std::string::npos && isBehindPlane(place) && isClear(walls_->project(place)))
        seen.insert(name);
    }
    return seen;
  }

private:
  static std::string inOneLine(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  }

  /// The walls of a heart that is cut open, else the surfaces of the organs; and the chambers' surfaces.
  void draw() {
    vtkCamera* camera = stage_.view().renderer()->GetActiveCamera();
    walls_.emplace(camera);
    chambers_.emplace(camera);
    vessels_.emplace(camera);
    plane_.reset();
    if (view_.cut.on)
      plane_ = planeOf(view_.cut, document_.state());
    const scene::OrganActor* walls = stage_.presenter().heartTissue();
    if (walls)
      walls_->add(walls->points(), walls->mesh().triangles, 0, plane_);
    for (const auto& actor : stage_.view().organs())
      if (actor->role() == scene::SurfaceRole::picture && actor.get() != walls)
        vessels_->add(actor->points(), actor->mesh().triangles, 0, plane_);
    int number = 0;
    for (const auto& organ : document_.organs()) {
      DepthPicture& picture = walls ? *chambers_ : *walls_;
      if (!walls || organ->parent)
        picture.add(*live_.sharedPoints(organ->id), organ->mesh->triangles, number, plane_);
      ++number;
    }
  }

  /// Whether nothing is before a place of the picture, nor beside it.
  bool isClear(const Vec3& at) const {
    constexpr int kBeside = 8;
    for (int y = -kBeside; y <= kBeside; ++y)
      for (int x = -kBeside; x <= kBeside; ++x) {
        const DepthPicture::Pixel wall = walls_->at(at.x() + x, at.y() + y);
        if (isFace(wall) || wall.depth < at.z() || vessels_->at(at.x() + x, at.y() + y).depth < at.z())
          return false;
      }
    return true;
  }
  bool isFace(const DepthPicture::Pixel& wall) const { return plane_ && wall.inside; }
  bool isBehindPlane(const Vec3& place) const {
    return !plane_ || (place - plane_->origin).dot(plane_->normal) > 0;
  }
  /// Where the face of a cut is in the place of a pixel, else what is drawn there.
  double drawnDepth(double x, double y) const {
    const DepthPicture::Pixel wall = walls_->at(x, y);
    if (!isFace(wall))
      return wall.depth;
    const Vec3 eye = walls_->placeAt(x, y, 0), far = walls_->placeAt(x, y, 1);
    return (plane_->origin - eye).dot(plane_->normal) / (far - eye).dot(plane_->normal);
  }
  bool isSeen(const Vec3& place, double x, double y) const {
    const Vec3 at = walls_->project(place);
    return (walls_->placeAt(x, y, at.z()) - place).norm() < kNear && at.z() < drawnDepth(x, y) + kNear;
  }

  /// To a pixel.
  bool isOn(const std::string& name, double x, double y) {
    for (const int dx : {0, -1, 1})
      for (const int dy : {0, -1, 1})
        if (isOnAt(name, x + dx, y + dy))
          return true;
    return false;
  }
  bool isOnAt(const std::string& name, double x, double y) {
    if (name == "Interventricular septum")
      return isFace(walls_->at(x, y));
    if (name == "Interatrial septum") // Its fat is no wall, but is drawn beside the vessels.
      return isFace(walls_->at(x, y)) || isFace(vessels_->at(x, y));
    if (name == "Chordae tendineae")
      return !isFace(walls_->at(x, y));
    for (const Part& part : parts_)
      if (nameOf(part, document_.organs()) == name &&
          isSeen(live_.sharedPoints(part.organ)->row(part.vertex).transpose(), x, y))
        return true;
    for (const auto& organ : document_.organs())
      if (labelOf(*organ) == name)
        return isOnOrgan(*organ, x, y);
    return isOnVessel(name, x, y);
  }
  /// A chamber that is cut open is named on its wall, the heart's muscle also in the face of the cut.
  bool isOnOrgan(const document::Organ& organ, double x, double y) {
    const DepthPicture::Pixel wall = walls_->at(x, y);
    if (!stage_.presenter().heartTissue())
      return wall.surface >= 0 && document_.organs()[static_cast<std::size_t>(wall.surface)]->id == organ.id;
    if (!organ.parent)
      return wall.surface >= 0;
    const Points& points = *live_.sharedPoints(organ.id);
    const Vec3 at = walls_->placeAt(x, y, wall.depth);
    return wall.surface >= 0 && !isFace(wall) &&
           (points.rowwise() - at.transpose()).rowwise().norm().minCoeff() < kNear;
  }
  bool isOnVessel(const std::string& name, double x, double y) {
    if (!tissue_)
      return false;
    const live::HeartVessels& vessels = tissue_->vessels();
    Points lines;
    vessels.linesAt(tissue_->carriersAt(*live::sampleHeartIn(document_.state()), live_), lines);
    for (std::size_t i = 0; i < vessels.vessels().size(); ++i)
      for (Eigen::Index p = 0; vessels.vessels()[i].name == name && p < vessels.vessels()[i].axis.rows(); ++p)
        if (isSeen(lines.row(vessels.first(i) + p).transpose(), x, y))
          return true;
    return false;
  }

  bool isInSight(int chamber) const {
    std::vector<int> sides(kWide); // The sides of the squares that end above.
    for (int row = 0; row < kHigh; ++row) {
      int left = 0, corner = 0;
      for (int column = 0; column < kWide; ++column) {
        const auto i = static_cast<std::size_t>(column);
        const int above = sides[i];
        left = showsWall(chamber, column, row) ? 1 + std::min({left, corner, above}) : 0;
        corner = above;
        sides[i] = left;
        if (left >= kSquare)
          return true;
      }
    }
    return false;
  }
  bool showsWall(int chamber, int column, int row) const {
    const double x = column + 0.5, y = row + 0.5;
    const DepthPicture::Pixel wall = walls_->at(x, y), hollow = chambers_->at(x, y);
    if (hollow.surface != chamber || !hollow.inside || wall.surface < 0 || isFace(wall) ||
        std::abs(wall.depth - hollow.depth) > kOnWall)
      return false;
    const document::Organ& organ = *document_.organs()[static_cast<std::size_t>(chamber)];
    const Points& points = *live_.sharedPoints(organ.id);
    for (const Part& part : parts_)
      if (part.organ == organ.id &&
          (points.row(part.vertex).transpose() - walls_->placeAt(x, y, wall.depth)).norm() < kOffParts)
        return false;
    return true;
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
  std::vector<Part> parts_;
  std::optional<DepthPicture> walls_, chambers_, vessels_;
  std::optional<scene::CutPlane> plane_;
  Stage stage_{kWide, kHigh, scene::lightTheme()};
};

using Instants = std::map<std::string, std::vector<int>>;

/// The names that were drawn beside what they name, and those missing of what is in sight, each with its
/// instants.
Instants wrongInABeat(NamedHeart& heart) {
  Instants wrong;
  for (int instant = 0; instant < kInstants; ++instant) {
    heart.beatTo(static_cast<double>(instant) / kInstants);
    const std::set<std::string> names = heart.names();
    for (const std::string& name : heart.astray())
      wrong[name].push_back(instant);
    for (const auto& inSight : {heart.chambersInSight(), heart.valvesInSight()})
      for (const std::string& name : inSight)
        if (!names.contains(name))
          wrong["no " + name].push_back(instant);
  }
  return wrong;
}

class HeartLabelsFrom : public testing::TestWithParam<scene::StandardView> {};

TEST_P(HeartLabelsFrom, LieOnTheirPartsThroughoutTheBeat) {
  NamedHeart heart;
  heart.lookFrom(GetParam());
  EXPECT_THAT(wrongInABeat(heart), testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Six, HeartLabelsFrom,
                         testing::Values(scene::StandardView::anterior, scene::StandardView::posterior,
                                         scene::StandardView::left, scene::StandardView::right,
                                         scene::StandardView::superior, scene::StandardView::inferior),
                         [](const auto& side) { return scene::nameOf(side.param); });

/// A plane of resources/scripts/draw_heart_cuts.py, by its normal and its place along it.
struct HeartCut {
  const char* name;
  Vec3 normal;
  double offset;
};

class HeartLabelsInCut : public testing::TestWithParam<HeartCut> {};

TEST_P(HeartLabelsInCut, LieOnTheirPartsThroughoutTheBeat) {
  NamedHeart heart;
  heart.cut(GetParam().normal, GetParam().offset);
  heart.lookAtTheCut();
  EXPECT_THAT(wrongInABeat(heart), testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Nine, HeartLabelsInCut,
                         testing::Values(HeartCut{"FourChamber", Vec3(-0.2900, 0.3687, -0.8831), 0.2599},
                                         HeartCut{"TwoChamber", Vec3(-0.6618, -0.7449, 0.0850), -0.1092},
                                         HeartCut{"ThreeChamber", Vec3(-0.7691, -0.4429, -0.4608), 0.0602},
                                         HeartCut{"ShortAxisBase", Vec3(-0.6388, 0.5490, 0.5390), -0.1352},
                                         HeartCut{"ShortAxisPapillary", Vec3(-0.6388, 0.5490, 0.5390),
                                                  -0.4000},
                                         HeartCut{"ShortAxisApex", Vec3(-0.6388, 0.5490, 0.5390), -0.6025},
                                         HeartCut{"OutflowTracts", Vec3(0.7679, 0.4374, 0.4680), -0.0611},
                                         HeartCut{"SagittalCavae", Vec3(-1.0000, 0.0000, 0.0000), 0.3184},
                                         HeartCut{"RightOutflow", Vec3(-0.5239, -0.7976, 0.2990), 0.1622}),
                         [](const auto& cut) { return std::string(cut.param.name); });

/// At the beginning of the beat, with what a plane opens.
TEST(HeartLabels, NameWhatItOpens) {
  NamedHeart heart;
  heart.cut(Vec3(-0.2900, 0.3687, -0.8831), 0.2599);
  heart.lookAtTheCut();
  heart.show(0);
  EXPECT_THAT(heart.names(), testing::IsSupersetOf({"LV cavity", "RV cavity", "LA cavity", "RA cavity",
                                                    "Interventricular septum", "Interatrial septum"}));
  heart.cut(Vec3(-0.6388, 0.5490, 0.5390), -0.1352);
  heart.lookAtTheCut();
  heart.show(0);
  EXPECT_THAT(heart.names(), testing::IsSupersetOf({"LV cavity", "RV cavity", "Mitral valve", "Aortic valve",
                                                    "Tricuspid valve", "Interventricular septum"}));
}

/// The right atrium is seen from its side, and from a side where it is closed.
TEST(HeartLabels, NameWhatIsOnTheSeptumOfAnOpenRightAtriumOnly) {
  NamedHeart heart;
  heart.cut(Vec3(0.8, 0.6, 0), -0.2808);
  heart.lookAtTheCut();
  heart.show(0);
  EXPECT_THAT(heart.names(), testing::IsSupersetOf({"Oval fossa", "Opening of the coronary sinus"}));
  EXPECT_THAT(heart.astray(), testing::IsEmpty());
  heart.cut(Vec3(-0.6618, -0.7449, 0.0850), -0.1092);
  heart.lookAtTheCut();
  heart.show(0);
  for (const char* name : {"Oval fossa", "Opening of the coronary sinus", "Terminal crest"})
    EXPECT_THAT(heart.names(), testing::Not(testing::Contains(name)));
}

} // namespace
} // namespace viscera::presentation
