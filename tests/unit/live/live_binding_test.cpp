#include "viscera/live/live_binding.h"

#include <atomic>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <new>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "session_fixture.h"
#include "viscera/core/error.h"

namespace viscera::live {
namespace {

using ::testing::HasSubstr;
using State = BindingStatus::State;
using tests::ball;
using tests::row;

/// S-Celestial coordinates that wait for the test before they begin, or for being cancelled.
class PatientSystem final : public coordinates::CoordinateSystem {
public:
  explicit PatientSystem(std::shared_ptr<const coordinates::CoordinateSystem> inner)
      : inner_(std::move(inner)) {}
  std::string id() const override { return "patient"; }
  std::string name() const override { return "Patient"; }
  std::string summary() const override { return {}; }
  coordinates::Traits traits() const override { return inner_->traits(); }
  std::vector<coordinates::Parameter> parameters() const override { return inner_->parameters(); }
  std::unique_ptr<coordinates::Binding> bind(const coordinates::HandleSet& handles, const Points& points,
                                             const coordinates::BindOptions& options,
                                             Progress& progress) const override {
    ++begun;
    while (!open) {
      progress.throwIfCancelled();
      std::this_thread::yield();
    }
    return inner_->bind(handles, points, options, progress);
  }

  mutable std::atomic<int> begun{0};
  std::atomic<bool> open{false};

private:
  std::shared_ptr<const coordinates::CoordinateSystem> inner_;
};

constexpr double kAtOnce = std::numeric_limits<double>::infinity();

/// A document with a ball, and everything that keeps it bound.
struct Live : tests::Session {
  coordinates::Registry registry = coordinates::builtInRegistry();
  std::shared_ptr<PatientSystem> patient = std::make_shared<PatientSystem>(registry.find("s-celestial"));
  ManualEventLoop box;
  JobQueue jobs{box.post()};
  LiveBinding live;

  explicit Live(double frameSeconds = kAtOnce)
      : live(document, (registry.add(patient, "test"), registry), jobs, {frameSeconds, {2}}) {
    settle();
  }
  void settle() {
    box.runUntil([this] { return !live.busy(); });
  }
  document::UndoStack::Step drag(document::HandleId handle, const Vec3& from, const Vec3& step, int moves) {
    document::UndoStack::Step open(undo, "Drag");
    for (int i = 1; i <= moves; ++i) {
      const Vec3 to = from + i * step;
      undo.perform(document::moveHandles({handle}, row(to.x(), to.y(), to.z())));
    }
    return open;
  }
  Points points(std::size_t place = 0) { return live.points(organ(place)); }
};

/// Needs more memory than there is.
class HungrySystem final : public coordinates::CoordinateSystem {
public:
  std::string id() const override { return "hungry"; }
  std::string name() const override { return "Hungry"; }
  std::string summary() const override { return {}; }
  coordinates::Traits traits() const override { return {}; }
  std::vector<coordinates::Parameter> parameters() const override { return {}; }
  std::unique_ptr<coordinates::Binding> bind(const coordinates::HandleSet&, const Points&,
                                             const coordinates::BindOptions&, Progress&) const override {
    throw std::bad_alloc();
  }
};

TEST(LiveBinding, SaysThatMemoryIsShortInPlainWordsAtOnceAndLater) {
  for (const double frameSeconds : {kAtOnce, 0.0}) {
    Live l(frameSeconds);
    l.registry.add(std::make_shared<HungrySystem>(), "test");
    l.undo.perform(document::setSystem({"hungry", {}}));
    l.settle();
    const BindingStatus status = l.live.status(l.organ());
    EXPECT_EQ(status.state, State::failed);
    EXPECT_THAT(status.message.english(), HasSubstr("not enough memory")) << frameSeconds;
  }
}

TEST(LiveBinding, BindsAnOrganAndReportsIt) {
  Live l;
  const BindingStatus status = l.live.status(l.organ());
  EXPECT_EQ(status.state, State::bound);
  EXPECT_LT(status.report.identityError, 1e-9 * 120);
  EXPECT_TRUE(status.message.empty());
  EXPECT_EQ(l.points(), l.document.organs()[0]->mesh->points);
  const OrganVolume volume = l.live.volume(l.organ());
  EXPECT_TRUE(volume.closed);
  EXPECT_NEAR(volume.changeMl(), 0, 1e-9);
  EXPECT_NEAR(volume.restMl, 113, 3) << "a ball of 30 mm";
}

TEST(LiveBinding, FollowsThePoseOfTheDocument) {
  Live l;
  std::vector<LiveEvent> events;
  const Subscription subscription = l.live.onEvent([&](const LiveEvent& event) { events.push_back(event); });
  l.undo.perform(document::moveHandles({l.handle(8)}, row(0, 0, 60)));
  ASSERT_EQ(events.size(), 1u);
  EXPECT_TRUE(events[0].moved);
  EXPECT_FALSE(events[0].replaced) << "the picture would have to be built again for every move";
  EXPECT_GT(l.points().col(2).maxCoeff(), 31);
  EXPECT_GT(l.live.volume(l.organ()).changeMl(), 0.1);
  l.undo.undo();
  EXPECT_EQ(l.points(), l.document.organs()[0]->mesh->points) << "back at rest, exactly";
}

TEST(LiveBinding, SharesThePoseOfTheDocumentWithItsOrgansAndItsReaders) {
  Live l;
  auto wanted = std::make_shared<Points>(l.document.pose());
  wanted->row(3).array() += 4;
  const std::shared_ptr<const Points> pose = wanted;
  document::UndoStack::Step drag(l.undo, "Drag");
  l.undo.perform(document::setPose(pose));
  EXPECT_EQ(l.document.state().pose, pose) << "taken, not copied";
  EXPECT_EQ(l.live.sharedPose(), pose);
  EXPECT_EQ(&l.live.deformer(l.document.organs()[0]->id)->pose(), pose.get()) << "moved by its column";
  drag.finish();
  EXPECT_EQ(&l.live.deformer(l.document.organs()[0]->id)->pose(), pose.get()) << "posed in full";
  const Points kept = *pose;
  l.undo.undo();
  EXPECT_EQ(*pose, kept) << "a pose that was shown does not change";
}

TEST(LiveBinding, SaysOfOrgansThatMoveTogetherWhichNewsIsTheLast) {
  Live l;
  l.undo.perform(document::addOrgans(
      {tests::ball("Second", 9, 2, {12, 0, 0}), tests::ball("Third", 9, 2, {-12, 0, 0})}));
  std::vector<bool> more;
  const Subscription subscription =
      l.live.onEvent([&](const LiveEvent& event) { more.push_back(event.more); });
  l.undo.perform(document::moveHandles({l.handle(8)}, row(0, 0, 60)));
  EXPECT_EQ(more, (std::vector<bool>{true, true, false}));
}

TEST(LiveBinding, TellsWhenEveryObserverOfTheDocumentMayKnowOfTheChangeAndIsItselfUpToDateThen) {
  tests::Session s;
  coordinates::Registry registry = coordinates::builtInRegistry();
  JobQueue jobs{[](std::function<void()> work) { work(); }};
  std::unique_ptr<LiveBinding> live;
  std::vector<std::string> heard;
  Eigen::Index early = 0;
  const Subscription before = s.document.onChange([&](const document::Change&) {
    heard.push_back("document");
    early = live->shownPose().rows();
  });
  live = std::make_unique<LiveBinding>(s.document, registry, jobs, LiveBinding::Options{kAtOnce, {}});
  const Subscription event = live->onEvent([&](const LiveEvent&) { heard.push_back("live"); });
  const Subscription after =
      s.document.onChange([&](const document::Change&) { heard.push_back("document"); });
  s.undo.perform(document::addHandles({{Vec3(-40, 1, 2)}}));
  EXPECT_EQ(early, 11) << "whoever was connected before the live binding saw the old pose";
  EXPECT_EQ(heard, (std::vector<std::string>{"document", "document", "live"}));
}

TEST(LiveBinding, LeavesTheMemoryToWhoeverLooksAtIt) {
  Live l;
  const std::shared_ptr<const Points> looked = l.live.sharedPoints(l.organ());
  const std::uint64_t revision = l.live.revision(l.organ());
  const Points were = *looked;
  l.undo.perform(document::addHandles({{Vec3(-40, 1, 2)}})); // Binds anew: another array.
  EXPECT_EQ(*looked, were);
  EXPECT_NE(l.live.sharedPoints(l.organ()), looked);
  EXPECT_NE(l.live.revision(l.organ()), revision);
}

TEST(LiveBinding, RefusesPosesWithoutVolumes) {
  Live l;
  Points far = l.document.pose();
  far(0, 0) = 1e308;
  EXPECT_THROW(l.live.showPose(far), DataError);
  EXPECT_THROW(l.undo.perform(document::setPose(far)), DataError);
  EXPECT_TRUE(std::isfinite(l.live.volume(l.organ()).nowMl));
}

TEST(LiveBinding, GivesBitwiseTheSameVerticesWhenADragIsReplayed) {
  Live a, b;
  std::vector<document::UndoStack::Step> drags;
  for (Live* l : {&a, &b}) {
    drags.push_back(l->drag(l->handle(8), Vec3(0, 0, 40), Vec3(0.11, -0.07, 0.13), 100));
    l->undo.perform(document::moveHandles({l->handle(9)}, row(39, 4, 2)));
  }
  EXPECT_EQ(a.points(), b.points()) << "in the middle of the drag";
  for (document::UndoStack::Step& drag : drags)
    drag.finish();
  EXPECT_EQ(a.points(), b.points());
}

TEST(LiveBinding, EndsADragWhereItsEndAloneWouldBe) {
  Live dragged, jumped;
  dragged.drag(dragged.handle(8), Vec3(0, 0, 40), Vec3(0.11, -0.07, 0.13), 100).finish();
  const Points end = dragged.document.pose();
  jumped.undo.perform(document::moveHandles({jumped.handle(8)}, end.row(8)));
  EXPECT_EQ(dragged.points(), jumped.points()) << "the way there left rounding behind";
}

TEST(LiveBinding, ComesBackExactlyWhenADragIsCancelled) {
  Live l;
  l.undo.perform(document::moveHandles({l.handle(9)}, row(45, 3, -1)));
  const Points before = l.points();
  auto drag = l.drag(l.handle(8), Vec3(0, 0, 40), Vec3(0.3, 0.1, 0.2), 100);
  EXPECT_NE(l.points(), before);
  drag.cancel();
  EXPECT_EQ(l.points(), before);
}

TEST(LiveBinding, BindsAnewWhileAHandleMovesAtRest) {
  Live l;
  document::UndoStack::Step step(l.undo, "Move at rest");
  for (int i = 0; i < 5; ++i) {
    l.undo.perform(document::moveRestHandles({l.handle(8)}, row(0, i, 42)));
    EXPECT_EQ(l.live.status(l.organ()).state, State::bound);
    EXPECT_EQ(l.live.deformer(l.organ())->restHandles().row(8), row(0, i, 42));
  }
  step.finish();
  EXPECT_EQ(l.points(), l.document.organs()[0]->mesh->points);
  l.undo.perform(document::addHandles({{Vec3(-40, 1, 2)}}));
  EXPECT_EQ(l.live.deformer(l.organ())->restHandles().rows(), 11);
  l.undo.perform(document::removeHandles({l.handle(9)}));
  EXPECT_EQ(l.live.deformer(l.organ())->restHandles().rows(), 10);
}

TEST(LiveBinding, DoesNotBindAnewForWhatABindingDoesNotDependOn) {
  Live l;
  const auto* deformer = l.live.deformer(l.organ());
  document::HandleEdit edit;
  edit.label = "Apex";
  edit.locked = true;
  l.undo.perform(document::editHandles({l.handle(8)}, edit));
  l.undo.perform(document::addGroup("A", {1, 0, 0}, {l.handle(8)}));
  document::OrganLook look;
  look.opacity = 0.5;
  l.undo.perform(document::setOrganLook(l.organ(), look));
  EXPECT_EQ(l.live.deformer(l.organ()), deformer);
}

TEST(LiveBinding, BindsAnewForAnotherSystemAndItsParameters) {
  Live l;
  l.undo.perform(document::moveHandles({l.handle(8)}, row(0, 0, 60)));
  const Points plain = l.points();
  l.undo.perform(document::setParameter("locality", 2));
  const Points local = l.points();
  EXPECT_NE(local, plain);
  l.undo.perform(document::setSystem({"t-celestial", {}}));
  EXPECT_NE(l.points(), plain);
  l.undo.undo();
  EXPECT_EQ(l.points(), local);
  l.undo.undo();
  EXPECT_EQ(l.points(), plain);
}

TEST(LiveBinding, SaysHowManyVerticesLieOutsideAndShowsTheOrganAtRest) {
  Live l;
  l.undo.perform(document::addOrgans({ball("Out", 20, 2, Vec3(60, 0, 0))}));
  l.undo.perform(document::moveHandles({l.handle(8)}, row(0, 0, 60)));
  const document::DocumentState document = l.document.state();
  const BindingStatus status = l.live.status(l.organ(1));
  EXPECT_EQ(status.state, State::failed);
  const Points& rest = l.document.organs()[1]->mesh->points;
  const int outside = static_cast<int>((rest.col(0).array() > 60).count());
  EXPECT_GT(outside, 0);
  EXPECT_EQ(status.outsideHull, outside);
  EXPECT_THAT(status.message.english(), HasSubstr(std::to_string(outside)));
  EXPECT_EQ(l.points(1), rest);
  EXPECT_EQ(l.live.deformer(l.organ(1)), nullptr);
  EXPECT_EQ(l.live.status(l.organ(0)).state, State::bound) << "the other organ has nothing to do with it";
  EXPECT_EQ(l.document.state(), document);

  l.undo.perform(document::addEnclosingHandles());
  EXPECT_EQ(l.live.status(l.organ(1)).state, State::bound);
  EXPECT_NE(l.points(1), rest);
  l.undo.undo();
  EXPECT_EQ(l.live.status(l.organ(1)).state, State::failed);
}

TEST(LiveBinding, SaysWhatIsMissingWithTooFewOrFlatHandlesAndUnknownSystems) {
  Live l;
  l.undo.perform(document::removeHandles(
      {l.handle(0), l.handle(1), l.handle(2), l.handle(3), l.handle(4), l.handle(5), l.handle(6)}));
  EXPECT_EQ(l.live.status(l.organ()).state, State::unbound);
  EXPECT_THAT(l.live.status(l.organ()).message.english(), HasSubstr("add 1 more"));
  EXPECT_EQ(l.points(), l.document.organs()[0]->mesh->points);
  Points flat(6, 3);
  for (int i = 0; i < 6; ++i)
    flat.row(i) << 100 * std::cos(i), 100 * std::sin(i), 0;
  l.undo.perform(document::replaceRig(document::rigAt(flat)));
  EXPECT_EQ(l.live.status(l.organ()).state, State::failed);
  EXPECT_FALSE(l.live.status(l.organ()).message.empty());
  l.undo.undo();
  l.undo.undo();
  EXPECT_EQ(l.live.status(l.organ()).state, State::bound);
  l.undo.perform(document::setSystem({"no-such-system", {}}));
  EXPECT_EQ(l.live.status(l.organ()).state, State::failed);
  EXPECT_THAT(l.live.status(l.organ()).message.english(), HasSubstr("s-celestial"));
  l.undo.undo();
  l.undo.perform(document::setParameter("locality", -5));
  EXPECT_EQ(l.live.status(l.organ()).state, State::failed);
  EXPECT_THAT(l.live.status(l.organ()).message.english(), HasSubstr("locality"));
}

TEST(LiveBinding, KeepsTheOldBindingInUseWhileAWorkerBinds) {
  Live l(0);
  ASSERT_EQ(l.live.status(l.organ()).state, State::bound);
  const document::HandleId moving = l.handle(8);
  l.undo.perform(document::moveHandles({moving}, row(0, 0, 60)));
  const Points before = l.points();
  l.undo.perform(document::setSystem({"patient", {}}));
  EXPECT_EQ(l.live.status(l.organ()).state, State::binding);
  EXPECT_TRUE(l.live.busy());
  EXPECT_EQ(l.points(), before);
  ASSERT_EQ(l.jobs.jobs().size(), 1u);
  EXPECT_EQ(l.jobs.jobs()[0].name.english(), "Binding Ball");

  // The handles are others by now, and still the old binding follows those that it knows.
  l.undo.perform(document::removeHandles({l.handle(9)}));
  EXPECT_EQ(l.points(), [&] {
    Points shown = before;
    return shown;
  }()) << "a handle at rest that is gone changes nothing";
  l.undo.perform(document::moveHandles({moving}, row(0, 0, 50)));
  EXPECT_NE(l.points(), before);
  l.patient->open = true;
  l.settle();
  EXPECT_EQ(l.live.status(l.organ()).state, State::bound);
  EXPECT_EQ(l.live.deformer(l.organ())->restHandles().rows(), 9);
  EXPECT_EQ(l.live.deformer(l.organ())->pose(), l.document.pose());
}

TEST(LiveBinding, ADragThatIsFasterThanBindingShowsTheBindingUnderWayAndThenTheLast) {
  Live l(0);
  l.undo.perform(document::setSystem({"patient", {}}));
  for (int i = 1; i <= 10; ++i)
    l.undo.perform(document::moveRestHandles({l.handle(8)}, row(i, 0, 42)));
  EXPECT_EQ(l.jobs.jobs().size(), 1u) << "one binding is under way, and no other waits";
  std::vector<double> bound;
  const Subscription subscription = l.live.onEvent([&](const LiveEvent& event) {
    if (event.replaced)
      bound.push_back(l.live.deformer(l.organ())->restHandles()(8, 0));
  });
  l.patient->open = true;
  l.settle();
  EXPECT_EQ(bound, (std::vector<double>{0, 10})) << "neither starved nor bound to every step";
  EXPECT_EQ(l.patient->begun, 2);
  EXPECT_EQ(l.live.status(l.organ()).state, State::bound);
  EXPECT_EQ(l.points(), l.document.organs()[0]->mesh->points);
}

TEST(LiveBinding, ABindingUnderWayIsGivenUpForOtherHandlesOrAnotherSystem) {
  Live l(0);
  l.undo.perform(document::setSystem({"patient", {}}));
  l.undo.perform(document::removeHandles({l.handle(9)}));
  l.patient->open = true;
  l.settle();
  EXPECT_EQ(l.live.deformer(l.organ())->restHandles().rows(), 9);
  l.patient->open = false;
  l.undo.perform(document::moveRestHandles({l.handle(8)}, row(0, 1, 42)));
  l.undo.perform(document::setSystem({"s-celestial", {}}));
  l.settle();
  EXPECT_EQ(l.live.status(l.organ()).state, State::bound) << "without waiting for the patient system";
}

TEST(LiveBinding, LeavesTheDocumentAndTheOldBindingWhenBindingIsCancelled) {
  Live l(0);
  l.undo.perform(document::moveHandles({l.handle(8)}, row(0, 0, 60)));
  const Points before = l.points();
  l.undo.perform(document::setSystem({"patient", {}}));
  const document::DocumentState document = l.document.state();
  l.jobs.cancel(l.jobs.jobs().at(0).id);
  l.settle();
  EXPECT_EQ(l.live.status(l.organ()).state, State::stale);
  EXPECT_EQ(l.document.state(), document);
  EXPECT_EQ(l.points(), before);
  l.patient->open = true;
  l.live.rebind();
  l.settle();
  EXPECT_EQ(l.live.status(l.organ()).state, State::bound);
}

TEST(LiveBinding, NeedsNoNewBindingWhenAnUndoGoesBackToTheOneInUse) {
  Live l(0);
  const auto* deformer = l.live.deformer(l.organ());
  l.undo.perform(document::setSystem({"patient", {}}));
  EXPECT_TRUE(l.live.busy());
  l.undo.undo();
  EXPECT_FALSE(l.live.busy());
  EXPECT_EQ(l.live.deformer(l.organ()), deformer);
  l.box.runUntil([&l] { return l.jobs.idle(); });
  l.box.run();
  EXPECT_EQ(l.live.status(l.organ()).state, State::bound);
}

TEST(LiveBinding, ForgetsAnOrganThatIsRemovedWhileItIsBound) {
  Live l(0);
  l.undo.perform(document::setSystem({"patient", {}}));
  const document::OrganId gone = l.organ();
  l.undo.perform(document::removeOrgans({gone}));
  EXPECT_FALSE(l.live.busy());
  EXPECT_THROW(l.live.points(gone), UsageError);
  l.patient->open = true;
  l.undo.undo();
  l.settle();
  EXPECT_EQ(l.live.status(gone).state, State::bound);
}

TEST(LiveBinding, MayEndWhileAWorkerBinds) {
  Live s(kAtOnce);
  ManualEventLoop box;
  JobQueue jobs(box.post());
  {
    s.undo.perform(document::setSystem({"s-celestial", {}}));
    LiveBinding other(s.document, s.registry, jobs, {0, {1}});
    EXPECT_TRUE(other.busy());
  }
  box.runUntil([&jobs] { return jobs.idle(); });
  box.run();
}

TEST(LiveBinding, ShowsRestOrAGivenPoseWithoutTouchingTheDocument) {
  Live l;
  l.undo.perform(document::moveHandles({l.handle(8)}, row(0, 0, 60)));
  const Points posed = l.points();
  const document::DocumentState document = l.document.state();
  l.live.showRest();
  EXPECT_EQ(l.points(), l.document.organs()[0]->mesh->points);
  Points swing = l.document.rig().restPositions();
  swing(9, 0) += 7;
  l.live.showPose(swing);
  EXPECT_NE(l.points(), posed);
  EXPECT_EQ(l.live.shownPose(), swing);
  EXPECT_THROW(l.live.showPose(swing.topRows(9)), DataError);
  swing(3, 1) = std::nan("");
  EXPECT_THROW(l.live.showPose(swing), DataError);
  l.live.showDocumentPose();
  EXPECT_EQ(l.points(), posed);
  EXPECT_EQ(l.document.state(), document);
  EXPECT_EQ(l.undo.names().size(), 1u) << "looking is not a step";
}

TEST(LiveBinding, MovesARigidOrganAsAWholeAndLeavesAFixedOneInPlace) {
  tests::Session s;
  s.undo.perform(document::addOrgans({tests::ball("Left femur", 20, 2, Vec3(8, 0, 0))}));
  const document::OrganId bone = s.organ(1);
  EXPECT_EQ(s.document.organ(bone)->mobility, document::Mobility::rigid) << "a bone, by its name";
  EXPECT_EQ(s.document.organ(s.organ())->mobility, document::Mobility::bends);
  const coordinates::Registry registry = coordinates::builtInRegistry();
  ManualEventLoop box;
  JobQueue jobs{box.post()};
  LiveBinding live(s.document, registry, jobs, {std::numeric_limits<double>::infinity(), {}});
  const Points rest = s.document.organ(bone)->mesh->points;
  s.undo.perform(document::moveHandles({s.handle(9)}, tests::row(70, 30, -20)));
  const auto keepsItsShape = [&] {
    const Points& now = live.points(bone);
    double worst = 0;
    for (Eigen::Index i = 1; i < rest.rows(); ++i)
      worst =
          std::max(worst, std::abs((now.row(i) - now.row(0)).norm() - (rest.row(i) - rest.row(0)).norm()));
    return worst < 1e-9;
  };
  EXPECT_TRUE(keepsItsShape());
  EXPECT_GT((live.points(bone) - rest).norm(), 1);
  EXPECT_LE(std::abs(live.volume(bone).relativeChange()), 1e-9);
  EXPECT_GT(std::abs(live.volume(s.organ()).relativeChange()), 1e-4) << "the soft one bends";
  s.undo.perform(document::setMobility({bone}, document::Mobility::bends));
  EXPECT_FALSE(keepsItsShape());
  s.undo.perform(document::setMobility({bone}, document::Mobility::fixed));
  EXPECT_EQ(live.points(bone), rest);
  s.undo.undo();
  s.undo.undo();
  EXPECT_TRUE(keepsItsShape()) << "undo makes it rigid again";
  EXPECT_GT((live.points(bone) - rest).norm(), 1);
}

TEST(LiveBinding, TellsTheInfluenceOfAHandle) {
  Live l;
  const Values influence = l.live.influence(l.organ(), l.handle(8));
  const Points& rest = l.document.organs()[0]->mesh->points;
  ASSERT_EQ(influence.size(), rest.rows());
  Eigen::Index most = 0;
  influence.maxCoeff(&most);
  EXPECT_NEAR(rest(most, 2), 30, 1e-9) << "the vertex next to the handle";
  const Values weights = l.live.weightsAt(l.organ(), 7);
  ASSERT_EQ(weights.size(), static_cast<Eigen::Index>(l.document.rig().handles.size()));
  for (std::size_t row = 0; row < l.document.rig().handles.size(); ++row)
    EXPECT_EQ(weights[static_cast<Eigen::Index>(row)], l.live.influence(l.organ(), l.handle(row))[7]) << row;
  EXPECT_EQ(l.live.weightsAt(l.organ(), rest.rows()).size(), 0) << "no such vertex";
  EXPECT_EQ(l.live.influence(l.organ(), document::HandleId{999}).size(), 0);
}

TEST(LiveBinding, GivesAnOpenSurfaceNoVolume) {
  Live l;
  geometry::TriangleMesh open = viscera::tests::sphere(2, 20);
  open.triangles.conservativeResize(open.triangles.rows() - 1, 3);
  l.undo.perform(document::addOrgans({{document::makeOrgan("Open", open), -1}}));
  l.undo.perform(document::moveHandles({l.handle(8)}, row(0, 0, 60)));
  const OrganVolume volume = l.live.volume(l.organ(1));
  EXPECT_FALSE(volume.closed);
  EXPECT_EQ(volume.changeMl(), 0);
}

TEST(LiveBinding, BindsAtOnceOnlyWhatFitsIntoAFrame) {
  Live l(1e-9);
  l.undo.perform(document::moveRestHandles({l.handle(8)}, row(0, 0, 45)));
  EXPECT_TRUE(l.live.busy());
  l.settle();
  EXPECT_EQ(l.live.status(l.organ()).state, State::bound);
}

TEST(LiveBinding, PosesAndMeasuresAllOrgansAsEachByItselfWithAnyNumberOfThreads) {
  for (const int threads : {1, 2, 3}) {
    tests::Session s;
    s.undo.perform(
        document::addOrgans({tests::ball("Second", 9, 4, {12, 0, 0}), tests::ball("Third", 7, 2)}));
    coordinates::Registry registry = coordinates::builtInRegistry();
    ManualEventLoop box;
    JobQueue jobs{box.post()};
    LiveBinding live(s.document, registry, jobs, {kAtOnce, {threads}});
    std::vector<document::OrganId> all;
    std::vector<deformation::Deformer> alone;
    for (const std::size_t place : {0, 1, 2}) {
      all.push_back(s.organ(place));
      alone.push_back(*live.deformer(all.back()));
    }
    const auto expectSame = [&](const char* when) {
      const std::uint64_t before = live.measurings();
      for (std::size_t k = 0; k < all.size(); ++k) {
        const OrganVolume volume = live.volume(all[k]);
        EXPECT_EQ(live.points(all[k]), alone[k].points()) << when << ", threads " << threads;
        EXPECT_EQ(volume.nowMl, alone[k].volumeMm3() / kMm3PerMl) << when;
        EXPECT_EQ(volume.restMl, s.document.organs()[k]->restVolumeMm3 / kMm3PerMl);
        EXPECT_TRUE(volume.closed);
      }
      EXPECT_EQ(live.measurings(), before + 1) << "all organs together, " << when;
    };
    Points pose = s.document.pose();
    pose.row(9) += Eigen::RowVector3d(5, -3, 8);
    pose.row(2) += Eigen::RowVector3d(-7, 1, 2);
    live.showPose(pose);
    for (deformation::Deformer& organ : alone)
      organ.setPose(pose);
    expectSame("posed");
    live.showDocumentPose();
    for (deformation::Deformer& organ : alone)
      organ.reset();
    document::UndoStack::Step step(s.undo, "Drag");
    pose = s.document.pose();
    for (int i = 0; i < 3; ++i) {
      pose.row(8) += Eigen::RowVector3d(1, 2, 0.3);
      s.undo.perform(document::setPose(pose));
      for (deformation::Deformer& organ : alone)
        organ.moveHandle(8, pose.row(8).transpose());
    }
    expectSame("dragged");
    step.finish();
  }
}

} // namespace
} // namespace viscera::live
