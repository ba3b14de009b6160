#include "viscera/presentation/opened_heart.h"

#include <array>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sequence_scene.h"
#include "session_fixture.h"
#include "viscera/document/open_files.h"
#include "viscera/geometry/carried_points.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/geometry/signed_distance.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/winding_number.h"
#include "viscera/heart/heart_chords.h"
#include "viscera/presentation/presenter.h"

namespace viscera::presentation {
namespace {

/// A document with the sample heart, its handles and its beat, and a picture of it.
class OpenedHeartTest : public testing::Test {
protected:
  OpenedHeartTest() {
    undo_.perform(document::setSystem(setup_.system));
    undo_.perform(document::addOrgans(document::organsFrom(setup_.organ)));
    undo_.perform(document::replaceRig(setup_.rig));
    cut_.cut = {true, Vec3::UnitY(), 0};
  }

  const document::DocumentState& state() const { return document_.state(); }
  document::OrganId idOf(const std::string& surface) const {
    for (const auto& organ : document_.organs())
      if (organ->origin.surface == surface)
        return organ->id;
    return {};
  }
  live::LiveBinding& organs() { return live_; }

  std::shared_ptr<const live::HeartTissue> tissue() {
    return heartTissueFor(state(), cut_, tests::cachedLibrary(), progress_);
  }
  void draw(const ViewState& view, std::shared_ptr<const live::HeartTissue> tissue) {
    Scene scene{state(), live_, view, registry_};
    scene.heartTissue = std::move(tissue);
    presenter_.update(scene);
  }
  void beatTo(double fraction) {
    Points pose;
    setup_.sequence->poseAt(fraction * 60 / 75, 75, pose);
    live_.showPose(pose);
  }
  bool drawn(const std::string& surface) { return presenter_.actorOf(idOf(surface))->drawn(); }
  void change(const std::string& surface, const std::function<void(document::OrganLook&)>& edit) {
    document::OrganLook look = state().organ(idOf(surface))->look;
    edit(look);
    undo_.perform(document::setOrganLook(idOf(surface), look));
  }

  Progress progress_;
  live::SequenceSetup setup_ =
      live::setUpSequence(tests::cachedLibrary(), "heartbeat", sample_organs::Resolution::medium, progress_);
  document::Document document_;
  document::UndoStack undo_{document_};
  coordinates::Registry registry_ = coordinates::builtInRegistry();
  ManualEventLoop box_;
  JobQueue jobs_{box_.post()};
  live::LiveBinding live_{document_, registry_, jobs_, {std::numeric_limits<double>::infinity(), {}}};
  ViewState cut_;
  scene::OrganView view_;
  Presenter presenter_{view_};
};

using OpenedHeartOfView = OpenedHeartTest;
using TissueOfAHeart = OpenedHeartTest;
using PictureOfAnOpenedHeart = OpenedHeartTest;

constexpr std::array kCavities = {"lv", "rv", "la", "ra"};

TEST_F(OpenedHeartOfView, IsTheOneThatThePlaneMeets) {
  const auto opened = openedHeart(state(), cut_);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->heart.outer->id, idOf("outer"));
  EXPECT_EQ(opened->heart.cavities.size(), kCavities.size());
  EXPECT_FALSE(opened->blood);
  cut_.cut.blood = true;
  EXPECT_TRUE(openedHeart(state(), cut_)->blood);
}

TEST_F(OpenedHeartOfView, IsNoneWhileItIsWholeOrHiddenOrUnderAMap) {
  EXPECT_FALSE(openedHeart(state(), ViewState()));
  ViewState beside = cut_, stress = cut_, slide = cut_;
  beside.cut.offset = 0.95;
  EXPECT_FALSE(openedHeart(state(), beside)) << "the plane misses it";
  stress.shown.stress = true;
  EXPECT_FALSE(openedHeart(state(), stress));
  slide.organsSeen[idOf("outer")] = {false, 1};
  EXPECT_FALSE(openedHeart(state(), slide));
  change("outer", [](document::OrganLook& look) { look.visible = false; });
  EXPECT_FALSE(openedHeart(state(), cut_));
  EXPECT_EQ(heartTissueFor(state(), cut_, tests::cachedLibrary(), progress_), nullptr);
}

TEST_F(OpenedHeartOfView, IsNoneOfOtherOrgans) {
  undo_.perform(document::removeAllOrgans());
  undo_.perform(document::addOrgans({tests::ball("heart")}));
  EXPECT_FALSE(openedHeart(state(), cut_));
}

TEST_F(TissueOfAHeart, GoesAlongWithItsSurfacesInTheBeat) {
  const auto made = tissue();
  const auto heart = live::sampleHeartIn(state());
  ASSERT_TRUE(made && heart);
  EXPECT_TRUE(made->isOf(*heart));
  std::map<std::array<double, 3>, Eigen::Index> outer;
  const Points& rest = heart->outer->mesh->points;
  for (Eigen::Index i = 0; i < rest.rows(); ++i)
    outer[{rest(i, 0), rest(i, 1), rest(i, 2)}] = i;
  for (const double fraction : {0.1, 0.45, 0.7}) {
    beatTo(fraction);
    Points now;
    made->at(*heart, organs(), now);
    const Points& at = *organs().sharedPoints(idOf("outer"));
    Eigen::Index shared = 0;
    for (Eigen::Index i = 0; i < now.rows(); ++i) {
      const auto& p = made->mesh()->points;
      const auto found = outer.find({p(i, 0), p(i, 1), p(i, 2)});
      if (found == outer.end())
        continue;
      ++shared;
      ASSERT_EQ(now.row(i), at.row(found->second)) << fraction;
    }
    EXPECT_GT(shared, 0.8 * static_cast<double>(rest.rows()));
    EXPECT_EQ(geometry::countSelfIntersections({now, made->mesh()->triangles, {}}, progress_), 0) << fraction;
  }
}

/// What the coordinates would do with its own vertices, within a twentieth of what the heart moves.
TEST_F(TissueOfAHeart, IsWhereTheHandlesWouldMoveIt) {
  const auto made = tissue();
  ASSERT_TRUE(made);
  tests::SequenceScene scene([&](Progress&) { return setup_; });
  scene.add({"tissue", made->mesh(), Vec3::Ones(), {}});
  for (const double fraction : {0.1, 0.45, 0.7}) {
    beatTo(fraction);
    scene.show(fraction * 60 / 75, 75);
    const Points bound = scene.posed("tissue").points;
    Points now;
    made->at(*live::sampleHeartIn(state()), organs(), now);
    const Values off = (now - bound).rowwise().norm();
    const double moved = (bound - made->mesh()->points).rowwise().norm().maxCoeff();
    EXPECT_LT(off.mean(), 0.1) << fraction;
    EXPECT_LT(off.maxCoeff(), std::max(0.6, 0.1 * moved)) << fraction;
  }
}

/// Both ends hold on while the valves open and shut, and what is between them is in the blood.
TEST_F(TissueOfAHeart, HoldsTheSailsByChords) {
  const auto made = tissue();
  ASSERT_TRUE(made);
  const heart::HeartChords chords(made->mesh()->points);
  ASSERT_EQ(chords.size(), 34u);
  const heart::ValveRings rings = heart::sampleHeartRings();
  const auto ventricle = [](const heart::Chord& chord) {
    return chord.valve == heart::HeartValve::mitral ? "lv" : "rv";
  };
  int within = 0, points = 0;
  for (const double fraction : {0.05, 0.3, 0.7}) {
    beatTo(fraction);
    Points walls;
    made->at(*live::sampleHeartIn(state()), organs(), walls);
    const geometry::WindingNumber muscle(geometry::TriangleMesh{walls, made->mesh()->triangles, {}});
    for (std::size_t i = 0; i < chords.size(); ++i) {
      const heart::Chord& chord = chords.chord(i);
      EXPECT_LT((made->mesh()->points.row(chords.vertex(i)).transpose() - chord.muscle).norm(), 3.0) << i;
      const document::OrganId cavity = idOf(ventricle(chord));
      const heart::ValveRing ring = heart::CarriedRing(rings[static_cast<std::size_t>(chord.valve)],
                                                       state().organ(cavity)->mesh->points)
                                        .at(*organs().sharedPoints(cavity));
      for (const double areaMm2 : {0.0, 150.0, 450.0}) {
        const heart::Leaflets leaflets = heart::leafletsOf(ring, heart::formOf(chord.valve), areaMm2);
        const Points line = chords.at(i, leaflets, ring, walls);
        const Eigen::Index last = line.rows() - 1;
        EXPECT_LT((line.row(0) - walls.row(chords.vertex(i))).norm(), 0.5) << i;
        EXPECT_LT((leaflets.points.rowwise() - line.row(last)).rowwise().norm().minCoeff(), 0.5) << i;
        for (Eigen::Index p = 1; p < last; ++p, ++points)
          within += muscle.inside(line.row(p).transpose()) ? 1 : 0;
      }
    }
  }
  EXPECT_LT(within, 0.03 * points);
}

/// Within 3 mm of the epicardium, which is the surface without them; in the septum, in the muscle. Where the
/// coronary sinus opens it is a little deeper: through the wall.
TEST_F(TissueOfAHeart, HasTheCoronaryVesselsOnItsOutside) {
  const auto made = tissue();
  ASSERT_TRUE(made);
  const auto& vessels = made->vessels().vessels();
  std::set<std::string> names;
  for (const auto& vessel : vessels)
    names.insert(vessel.name);
  EXPECT_EQ(names.count(""), 0u);
  for (const char* name :
       {"Left main coronary artery", "Left anterior descending artery", "Diagonal branch", "Septal branches",
        "Circumflex artery", "Left marginal branch", "Right coronary artery", "Posterior descending artery",
        "Great cardiac vein", "Coronary sinus"})
    EXPECT_EQ(names.count(name), 1u) << name;
  const sample_organs::ImplicitSurface epicardium = sample_organs::implicitSurface(
      tests::cachedLibrary(), "heart", "heart_and_fat", sample_organs::Resolution::medium);
  const geometry::WindingNumber muscle(*made->mesh());
  for (const geometry::NamedVessel& vessel : vessels)
    for (Eigen::Index p = 0; p < vessel.axis.rows(); ++p) {
      const Vec3 at = vessel.axis.row(p).transpose();
      if (vessel.name == "Septal branches") {
        ASSERT_TRUE(muscle.inside(at)) << "point " << p;
      } else if (vessel.inWall) {
        ASSERT_GT(epicardium(at), -5) << vessel.name << ", point " << p;
        ASSERT_LT(epicardium(at), 1) << vessel.name << ", point " << p;
      } else {
        const bool sinks = p < 5 || p + 5 >= vessel.axis.rows(); // Into the aorta's wall or the muscle.
        ASSERT_LT(std::abs(epicardium(at)), sinks ? 5 : 3) << vessel.name << ", point " << p;
      }
    }
}

/// What a plane meets of the fold between the atria is full, at rest and in the beat: each place there is in
/// the wall or in the fat, which stays in the walls around it and out of the blood.
TEST_F(TissueOfAHeart, IsFilledBetweenTheAtria) {
  const auto made = tissue();
  ASSERT_TRUE(made && made->septum());
  const geometry::TriangleMesh& septum = *made->septum();
  EXPECT_TRUE(geometry::checkSurface(septum).closed());
  EXPECT_LT(septum.triangles.rows(), 5000);
  constexpr double kFourChamber[] = {-0.2851, 0.3734, -0.8828};
  const Vec3 normal(kFourChamber[0], kFourChamber[1], kFourChamber[2]), origin(-7.25, 27.62, 11.3);
  const Vec3 aside(0.7947, 0.6070, 0), up(-0.5358, 0.7015, 0.4698);
  // A corner of the gap, from the crux to where the atria meet, at rest in the four-chamber plane, mm.
  const std::vector<Vec3> places = {origin - 22.5 * aside + 10 * up, origin - 18 * aside + 12 * up,
                                    origin - 13 * aside + 9.5 * up, origin - 21 * aside + 17 * up};
  const auto heart = live::sampleHeartIn(state());
  const geometry::CarriedPoints followed(pointsOf(places), made->carriersAt(*heart, organs()));
  for (const double fraction : {0.0, 0.2, 0.42, 0.7}) {
    if (fraction > 0)
      beatTo(fraction);
    const Points carriers = made->carriersAt(*heart, organs());
    Points walls, fat, now;
    made->at(carriers, walls);
    made->septumAt(carriers, fat);
    followed.at(carriers, now);
    const geometry::WindingNumber muscle(geometry::TriangleMesh{walls, made->mesh()->triangles, {}});
    const geometry::WindingNumber filled(geometry::TriangleMesh{fat, septum.triangles, {}});
    for (const auto& place : now.rowwise())
      EXPECT_TRUE(filled.inside(place.transpose()) || muscle.inside(place.transpose()))
          << place << " at " << fraction;
    EXPECT_EQ(geometry::countSelfIntersections({fat, septum.triangles, {}}, progress_), 0) << fraction;
    int inBlood = 0;
    for (std::size_t side = 0; side < made->blood().size(); ++side) {
      Points lumen;
      made->blood()[side]->at(walls, lumen);
      const geometry::WindingNumber blood(
          geometry::TriangleMesh{lumen, made->blood()[side]->mesh()->triangles, {}});
      for (Eigen::Index v = 0; v < fat.rows(); v += 5)
        inBlood += blood.inside(fat.row(v).transpose()) ? 1 : 0;
    }
    EXPECT_EQ(inBlood, 0) << fraction;
  }
}

/// It goes through the right atrium's wall, and ends flush inside between the cava and the tricuspid valve.
TEST_F(TissueOfAHeart, HasTheMouthOfTheCoronarySinus) {
  const auto made = tissue();
  ASSERT_TRUE(made);
  const auto& vessels = made->vessels().vessels();
  const auto mouth = std::find_if(vessels.begin(), vessels.end(), [](const auto& vessel) {
    return vessel.name == "Coronary sinus" && vessel.inWall;
  });
  ASSERT_NE(mouth, vessels.end());
  const geometry::WindingNumber blood(*made->blood()[1]->mesh());
  const Points& axis = mouth->axis;
  const Vec3 end = axis.row(axis.rows() - 1).transpose();
  EXPECT_TRUE(blood.inside(end)) << "its end is seen from the atrium";
  EXPECT_FALSE(blood.inside(axis.row(0).transpose()));
  Eigen::Index within = 0;
  for (Eigen::Index p = 0; p < axis.rows(); ++p)
    within += blood.inside(axis.row(p).transpose()) ? 1 : 0;
  EXPECT_LT((axis.row(axis.rows() - within) - axis.row(axis.rows() - 1)).norm(), 1.5)
      << "flush with the wall";
  // The sinus itself comes to where this begins.
  const auto sinus = std::find_if(vessels.begin(), vessels.end(), [](const auto& vessel) {
    return vessel.name == "Coronary sinus" && !vessel.inWall;
  });
  ASSERT_NE(sinus, vessels.end());
  EXPECT_LT((sinus->axis.rowwise() - axis.row(0)).rowwise().norm().minCoeff(), 2);
  const Vec3 cava(-48, 17, -12), valve(-37.5, -7.2, 6.3);
  EXPECT_LT((end - cava).norm() + (end - valve).norm(), 1.5 * (cava - valve).norm()) << "between both";
}

/// They keep their distance to the surface of the heart that beats.
TEST_F(TissueOfAHeart, CarriesItsCoronaryVessels) {
  const auto made = tissue();
  ASSERT_TRUE(made);
  const auto outer = state().organ(idOf("outer"))->mesh;
  const auto distances = [&] {
    Points lines;
    made->vessels().linesAt(made->carriersAt(*live::sampleHeartIn(state()), organs()), lines);
    const geometry::SignedDistance off(std::make_shared<const geometry::TriangleMesh>(
        geometry::TriangleMesh{*organs().sharedPoints(idOf("outer")), outer->triangles, {}}));
    Values all(lines.rows());
    for (Eigen::Index p = 0; p < lines.rows(); ++p)
      all[p] = off(lines.row(p).transpose());
    return all;
  };
  beatTo(0.05);
  const Values first = distances();
  for (const double fraction : {0.3, 0.7}) {
    beatTo(fraction);
    const Values now = distances();
    for (Eigen::Index p = 0; p < now.size(); ++p)
      if (first[p] > -5) { // Deeper is the septum, whose depth changes with its thickness.
        ASSERT_NEAR(now[p], first[p], 2) << "point " << p << " at " << fraction;
      }
  }
}

TEST_F(TissueOfAHeart, HasBloodFromItsVeinsToItsArteries) {
  const auto made = tissue();
  ASSERT_TRUE(made);
  const auto& blood = made->blood();
  ASSERT_TRUE(blood[0] && blood[1]);
  EXPECT_EQ(blood[0]->ends(), 8u) << "four pulmonary veins, the aorta and its three branches";
  EXPECT_EQ(blood[1]->ends(), 4u) << "two venae cavae, two pulmonary arteries";
  const std::vector<Vec3> places[] = {
      {{-22, 4, 58},
       {-10, 27, 105},
       {14, 53, 88},
       {15, 57.5, 69},
       {-27, 13, 119},
       {-8, 25, 120},
       {7, 38, 119},
       {20, 62.4, 46.4},
       {20, 66.6, 16.8},
       {-53, 61.1, 44.9},
       {-53, 64.3, 14.6},
       {-14, 47, 28},
       {10, 6, 5}},
      {{12, -6, 61}, {30, 25, 73}, {-44, 40, 64}, {-48, 16, 76}, {-47, 19, -26}, {-50, 12, 16}}};
  for (std::size_t side = 0; side < blood.size(); ++side) {
    const geometry::TriangleMesh& mesh = *blood[side]->mesh();
    EXPECT_TRUE(geometry::checkSurface(mesh).closed());
    const geometry::WindingNumber own(mesh), other(*blood[1 - side]->mesh());
    for (const Vec3& place : places[side]) {
      EXPECT_TRUE(own.inside(place)) << place.transpose();
      EXPECT_FALSE(other.inside(place)) << place.transpose();
    }
    // Nothing of it is outside, at rest and in the beat.
    for (const double fraction : {0.0, 0.4}) {
      beatTo(fraction);
      const Points carriers = made->carriersAt(*live::sampleHeartIn(state()), organs());
      Points walls, now;
      made->at(carriers, walls);
      blood[side]->at(walls, now);
      const geometry::SignedDistance off(std::make_shared<const geometry::TriangleMesh>(
          geometry::TriangleMesh{walls, made->mesh()->triangles, {}}));
      for (Eigen::Index v = 0; v < now.rows(); v += 7)
        ASSERT_LT(-off(now.row(v).transpose()), 1.0) << side << ", vertex " << v << " is in a wall";
    }
  }
}

TEST_F(TissueOfAHeart, IsNoneOfAHeartOfAnotherShape) {
  live::SampleHeartOrgans heart = *live::sampleHeartIn(state());
  auto larger = std::make_shared<document::Organ>(*heart.outer);
  larger->mesh = std::make_shared<const geometry::TriangleMesh>(geometry::scaled(*heart.outer->mesh, 1.01));
  heart.outer = larger;
  EXPECT_EQ(live::makeHeartTissue(heart, tests::cachedLibrary(), progress_), nullptr)
      << "as in a session of another version";
}

TEST_F(PictureOfAnOpenedHeart, IsTheTissueInPlaceOfTheSurfaces) {
  const document::DocumentState before = state();
  const auto made = tissue();
  draw(ViewState(), made);
  const std::size_t whole = view_.organs().size();
  EXPECT_EQ(presenter_.heartTissue(), nullptr) << "uncut, nothing is new";
  for (const char* surface : {"outer", "lv", "rv", "la", "ra"})
    EXPECT_TRUE(drawn(surface));

  draw(cut_, made);
  const scene::OrganActor* actor = presenter_.heartTissue();
  ASSERT_NE(actor, nullptr);
  EXPECT_EQ(&actor->mesh(), made->mesh().get());
  EXPECT_TRUE(actor->drawn() && actor->isCut());
  EXPECT_EQ(actor->opacity(), 1);
  for (const char* surface : {"outer", "lv", "rv", "la", "ra"}) {
    EXPECT_FALSE(drawn(surface)) << surface;
    EXPECT_TRUE(presenter_.actorOf(idOf(surface))->met()) << "clicks and names are as before";
  }

  draw(ViewState(), made);
  EXPECT_EQ(presenter_.heartTissue(), nullptr);
  EXPECT_EQ(view_.organs().size(), whole);
  EXPECT_TRUE(drawn("outer") && drawn("la"));
  EXPECT_TRUE(state() == before);
}

TEST_F(PictureOfAnOpenedHeart, IsFullOfBloodWhereThatIsWanted) {
  const auto made = tissue();
  draw(cut_, made);
  EXPECT_FALSE(presenter_.heartBlood());
  const std::size_t empty = view_.organs().size();
  cut_.cut.blood = true;
  draw(cut_, made);
  EXPECT_TRUE(presenter_.heartBlood());
  EXPECT_EQ(view_.organs().size(), empty + 2) << "that of the left and of the right side";
  EXPECT_FALSE(drawn("outer"));
  for (const char* surface : kCavities)
    EXPECT_FALSE(drawn(surface)) << surface << " is in the blood";
  change("lv", [](document::OrganLook& look) { look.visible = false; });
  draw(cut_, made);
  EXPECT_EQ(view_.organs().size(), empty + 1) << "a ventricle that is hidden has none";
  cut_.cut.blood = false;
  draw(cut_, made);
  EXPECT_FALSE(presenter_.heartBlood());
}

TEST_F(PictureOfAnOpenedHeart, HasChordsWhileItIsCut) {
  const auto made = tissue();
  draw(ViewState(), made);
  EXPECT_EQ(presenter_.valves().chords(), 0);
  draw(cut_, nullptr);
  EXPECT_EQ(presenter_.valves().chords(), 0) << "their muscles are not there yet";
  cut_.cut = {true, -Vec3::UnitZ(), -0.4};
  draw(cut_, made);
  EXPECT_EQ(presenter_.valves().chords(), 34) << "only the aortic arch is cut";
  cut_.cut = {true, Vec3::UnitY(), 0};
  draw(cut_, made);
  EXPECT_LT(presenter_.valves().chords(), 34) << "those of muscles that are cut away are not drawn";
  EXPECT_GT(presenter_.valves().chords(), 0);
  draw(ViewState(), made);
  EXPECT_EQ(presenter_.valves().chords(), 0);
}

TEST_F(PictureOfAnOpenedHeart, MovesWithTheBeat) {
  const auto made = tissue();
  for (const double fraction : {0.0, 0.4, 0.0}) {
    beatTo(fraction);
    draw(cut_, made);
    Points wanted;
    made->at(*live::sampleHeartIn(state()), organs(), wanted);
    ASSERT_NE(presenter_.heartTissue(), nullptr);
    EXPECT_EQ(presenter_.heartTissue()->points(), wanted) << fraction;
  }
}

TEST_F(PictureOfAnOpenedHeart, IsAsBeforeUntilTheTissueIsThere) {
  draw(cut_, nullptr);
  EXPECT_EQ(presenter_.heartTissue(), nullptr);
  EXPECT_TRUE(drawn("outer") && drawn("lv"));
  draw(cut_, tissue());
  EXPECT_NE(presenter_.heartTissue(), nullptr);
  undo_.perform(document::removeAllOrgans());
  draw(cut_, nullptr);
  EXPECT_EQ(presenter_.heartTissue(), nullptr);
  EXPECT_TRUE(view_.organs().empty());
}

/// Numbers are known on the organs' own vertices alone.
TEST_F(PictureOfAnOpenedHeart, GivesWayToNumbersOnTheOrgans) {
  ViewState influence = cut_;
  influence.influence = true;
  influence.selection.handles = {state().rig->handles.front().id};
  const auto made = tissue();
  draw(influence, made);
  EXPECT_EQ(presenter_.heartTissue(), nullptr);
  EXPECT_TRUE(drawn("outer"));
  draw(cut_, made);
  EXPECT_NE(presenter_.heartTissue(), nullptr);
}

TEST_F(PictureOfAnOpenedHeart, IsMetOnItsOwnSurfaces) {
  draw(cut_, tissue());
  std::vector<scene::OrganActor*> all;
  for (const auto& organ : view_.organs())
    all.push_back(organ.get());
  int met = 0;
  for (double x = -40; x <= 40; x += 8)
    for (double z = -20; z <= 60; z += 8)
      if (const auto pick = scene::pickSurface({Vec3(x, -400, z), Vec3::UnitY()}, all)) {
        ++met;
        EXPECT_TRUE(presenter_.organOf(pick->organ));
      }
  EXPECT_GT(met, 20);
}

TEST(OrganCutJson, BloodComesBackAndOlderSessionsHaveNone) {
  ViewState view;
  view.cut = {true, Vec3::UnitX(), 0.25, true};
  EXPECT_EQ(viewFromJson(toJson(view)).cut, view.cut);
  EXPECT_FALSE(viewFromJson({{"format", 3}, {"cut", {{"on", true}, {"offset", 0.5}}}}).cut.blood);
}

} // namespace
} // namespace viscera::presentation
