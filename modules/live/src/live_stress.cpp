#include "viscera/live/live_stress.h"

#include <chrono>
#include <exception>
#include <utility>

#include "bound_organ.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/deformation/witness_mesh.h"

namespace viscera::live {
namespace {

using StressState = StressStatus::State;

constexpr const char* kSampleSlot = "stress/sample";
constexpr const char* kBindSlot = "stress/bind";
constexpr const char* kCycleSlot = "stress/cycle";
/// The expected cost of deriving before it was measured, s per (point x handle).
constexpr double kExpectedStressSeconds = 150e-9;
/// The part of a binding's progress that the derivatives take; the rest is for moving the points.
constexpr double kGradientsPart = 0.8;

/// An organ filled with witnesses, and how its surface follows their numbers.
struct SampledOrgan {
  WitnessSample sample;
  std::shared_ptr<const deformation::WitnessInterpolation> onSurface;
};

/// Witnesses hung on the handles.
struct BoundWitnesses {
  std::shared_ptr<const deformation::WitnessGradients> gradients;
  std::shared_ptr<const coordinates::Binding> positions;
  double seconds = 0;
};

BoundWitnesses bindTo(const BindingTarget& target, const Points& points, Threads threads,
                      Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  BoundWitnesses bound;
  const auto options = deformation::withTetgen({target.parameters, threads});
  runPart(progress, 0, kGradientsPart, [&](Progress& part) {
    bound.gradients = deformation::bindWitnesses(*target.system, target.handles, points, options, part);
  });
  runPart(progress, kGradientsPart, 1, [&](Progress& part) {
    bound.positions = target.system->bind(target.handles, points, options, part);
  });
  bound.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return bound;
}

} // namespace

struct LiveStress::Impl {
  Impl(document::Document& documentIn, const coordinates::Registry& registryIn, LiveBinding& liveIn,
       JobQueue& jobsIn, Options optionsIn)
      : document(documentIn), registry(registryIn), live(liveIn), jobs(jobsIn),
        options(std::move(optionsIn)) {}

  document::Document& document;
  const coordinates::Registry& registry;
  LiveBinding& live;
  JobQueue& jobs;
  Options options;

  document::OrganId organ;
  std::shared_ptr<const geometry::TriangleMesh> surface; ///< That was sampled or is being sampled.
  std::vector<std::shared_ptr<const geometry::TriangleMesh>> cavities; ///< Left out of it.
  int sampledWanted = 0;
  bool sampleMissing = false; ///< Sampling failed or was cancelled: only `retry` and another surface go on.
  std::shared_ptr<const deformation::WitnessMesh> mesh;
  std::shared_ptr<const deformation::WitnessInterpolation>
      onSurface;                               ///< From `mesh` to the organ's vertices.
  std::shared_ptr<const BindingTarget> target; ///< The target of the present binding or of the one under way.
  BoundWitnesses bound;
  bool boundToTarget = false;
  std::shared_ptr<const document::Rig> rigSeen; ///< With which `target` was last found right.
  std::shared_ptr<const document::SystemChoice> systemSeen;
  double secondsEach = kExpectedStressSeconds;

  StressStatus status;
  std::shared_ptr<Points> points = std::make_shared<Points>(0, 3);
  std::shared_ptr<deformation::StressMap> map = std::make_shared<deformation::StressMap>();
  std::shared_ptr<const Points> evaluated; ///< The pose that points and map are in; null: none.
  std::uint64_t revision = 0;              ///< Another number whenever points and map are others.
  deformation::StressStatistics statistics;
  std::shared_ptr<const CycleStress> cycle;
  bool findingCycle = false;
  Text cycleMessage;
  StressEvent pending;
  Signal<const StressEvent&> events;
  std::int64_t ticket = 0;
  std::int64_t cycleTicket = 0; ///< Another number when the cycle that is being computed is no longer wanted.
  std::vector<Subscription> subscriptions;
  std::shared_ptr<Impl*> self = std::make_shared<Impl*>(this);

  void setState(StressState state, Text message = {});
  std::vector<std::shared_ptr<const geometry::TriangleMesh>> cavitiesOf(document::OrganId parent) const;
  void refresh();
  void sampleLater();
  void sampled(JobResult<SampledOrgan> result);
  bool staysStiff();
  void refreshBinding();
  void bindLater();
  void takeBound(BoundWitnesses result);
  void dropMesh();
  void dropBinding();
  void dropCycle();
  void cycleArrived(JobResult<CycleStress> result);
  void evaluate();
  void tell();
  template <class Value>
  bool failedOrCancelled(const JobResult<Value>& result);
  /// A function for a job's end that is called only while this lives and nothing newer was asked for.
  template <class Value>
  std::function<void(JobResult<Value>)> ending(void (Impl::*end)(JobResult<Value>));
  void boundArrived(JobResult<BoundWitnesses> result);
};

void LiveStress::Impl::setState(StressState state, Text message) {
  status.state = state;
  status.message = std::move(message);
  pending.status = true;
}

template <class Value>
std::function<void(JobResult<Value>)> LiveStress::Impl::ending(void (Impl::*end)(JobResult<Value>)) {
  return [weak = std::weak_ptr<Impl*>(self), mine = ++ticket, end](JobResult<Value> result) {
    const auto alive = weak.lock();
    if (!alive || (*alive)->ticket != mine)
      return;
    ((*alive)->*end)(std::move(result));
    (*alive)->tell();
  };
}

template <class Value>
bool LiveStress::Impl::failedOrCancelled(const JobResult<Value>& result) {
  if (result.value)
    return false;
  if (result.error)
    setState(StressState::failed, result.error->explanation());
  else
    setState(StressState::cancelled);
  return true;
}

/// Closed surfaces of the document inside this organ: what they hold is no tissue.
std::vector<std::shared_ptr<const geometry::TriangleMesh>>
LiveStress::Impl::cavitiesOf(document::OrganId parent) const {
  std::vector<std::shared_ptr<const geometry::TriangleMesh>> hollow;
  for (const auto& item : document.organs())
    if (item->parent == parent && item->closed())
      hollow.push_back(item->mesh);
  return hollow;
}

/// Updates mesh and binding to the document, as far as that is possible now.
void LiveStress::Impl::refresh() {
  const auto item = organ ? document.organ(organ) : nullptr;
  if (!item) {
    ++ticket; // Results of running jobs are ignored.
    for (const char* slot : {kSampleSlot, kBindSlot, kCycleSlot})
      jobs.cancelSlot(slot);
    if (status.state == StressState::sampling || sampleMissing)
      surface.reset();
    if (status.state == StressState::binding)
      target.reset();
    if (status.state != StressState::off)
      setState(StressState::off);
    return;
  }
  if (surface != item->mesh || sampledWanted != options.witnesses.wanted || cavities != cavitiesOf(organ))
    sampleLater();
  else if (!sampleMissing && status.state != StressState::sampling && status.state != StressState::cancelled)
    refreshBinding();
}

void LiveStress::Impl::sampleLater() {
  const auto item = document.organ(organ);
  const auto hollow = cavitiesOf(organ);
  if (surface != item->mesh || cavities != hollow)
    dropMesh();
  surface = item->mesh;
  cavities = hollow;
  sampledWanted = options.witnesses.wanted;
  sampleMissing = false;
  jobs.cancelSlot(kBindSlot);
  setState(StressState::sampling);
  const auto work = [mesh = item->mesh, hollow, wanted = options.witnesses](Progress& progress) {
    WitnessSample sample = withoutCavities(sampleWitnesses(*mesh, wanted, progress), hollow, wanted);
    auto toSurface =
        std::make_shared<const deformation::WitnessInterpolation>(*sample.mesh, mesh->points, wanted.threads);
    return SampledOrgan{std::move(sample), std::move(toSurface)};
  };
  jobs.submit<SampledOrgan>(phrase("Witness points of %1", named(item->name)), kSampleSlot, work,
                            ending<SampledOrgan>(&Impl::sampled));
}

void LiveStress::Impl::sampled(JobResult<SampledOrgan> result) {
  sampleMissing = failedOrCancelled(result);
  if (sampleMissing)
    return;
  dropMesh();
  const WitnessSample& sample = result.value->sample;
  mesh = sample.mesh;
  onSurface = result.value->onSurface;
  status.origin = sample.origin;
  status.remarks = sample.remarks;
  pending.sampled = true;
  refreshBinding();
}

/// Whether the organ does not bend, so that its tissue has no stress: says so, and forgets the binding.
bool LiveStress::Impl::staysStiff() {
  if (document.organ(organ)->mobility == document::Mobility::bends)
    return false;
  if (target || status.state != StressState::failed) {
    ++ticket;
    jobs.cancelSlot(kBindSlot);
    dropCycle();
    dropBinding();
    target.reset();
    boundToTarget = false;
    setState(StressState::failed,
             "This organ does not bend, so its tissue has no stress; let it bend as soft tissue");
  }
  return true;
}

/// Binds the mesh when the handles or the system are others than those it is bound to.
void LiveStress::Impl::refreshBinding() {
  if (!mesh || staysStiff())
    return;
  auto wanted = std::make_shared<const BindingTarget>(makeTarget(document.state(), registry));
  rigSeen = document.state().rig;
  systemSeen = document.state().system;
  if (target && sameBinding(*target, *wanted)) {
    if (status.state == StressState::binding || (status.state == StressState::failed && !boundToTarget))
      return;
    if (boundToTarget) {
      if (status.state != StressState::ready)
        setState(StressState::ready);
      return evaluate();
    }
  }
  target = std::move(wanted);
  boundToTarget = false;
  jobs.cancelSlot(kBindSlot);
  dropCycle();
  if (const auto failure = statusWithoutBinding(*target)) {
    ++ticket;
    dropBinding();
    return setState(StressState::failed,
                    failure->message.empty() ? Text("An organ needs handles around it") : failure->message);
  }
  const double expected =
      secondsEach * static_cast<double>(mesh->points.rows()) * static_cast<double>(target->ids.size());
  if (expected > options.frameSeconds || target->system->traits().needsTetrahedra)
    return bindLater();
  ++ticket;
  try {
    Progress ignored;
    takeBound(bindTo(*target, mesh->points, options.threads, ignored));
  } catch (const std::exception& error) {
    dropBinding();
    setState(StressState::failed, explanationOf(error));
  }
}

void LiveStress::Impl::bindLater() {
  setState(StressState::binding);
  const auto work = [wanted = target, witnesses = mesh, threads = options.threads](Progress& progress) {
    return bindTo(*wanted, witnesses->points, threads, progress);
  };
  jobs.submit<BoundWitnesses>("Stress at the witness points", kBindSlot, work,
                              ending<BoundWitnesses>(&Impl::boundArrived));
}

void LiveStress::Impl::boundArrived(JobResult<BoundWitnesses> result) {
  if (failedOrCancelled(result))
    return dropBinding();
  takeBound(std::move(*result.value));
}

void LiveStress::Impl::takeBound(BoundWitnesses result) {
  bound = std::move(result);
  boundToTarget = true;
  evaluated.reset();
  secondsEach =
      bound.seconds / (static_cast<double>(mesh->points.rows()) * static_cast<double>(target->ids.size()));
  status.closedForm = bound.gradients->closedForm();
  status.outside = static_cast<int>(bound.positions->report().failures.size());
  setState(StressState::ready);
  evaluate();
}

void LiveStress::Impl::dropCycle() {
  jobs.cancelSlot(kCycleSlot);
  ++cycleTicket;
  if (cycle || !cycleMessage.empty())
    pending.cycle = true;
  cycle.reset();
  findingCycle = false;
  cycleMessage = {};
}

void LiveStress::Impl::cycleArrived(JobResult<CycleStress> result) {
  findingCycle = false;
  if (result.value)
    cycle = std::make_shared<const CycleStress>(std::move(*result.value));
  else if (result.error)
    cycleMessage = result.error->explanation();
  pending.cycle = !result.cancelled();
}

void LiveStress::Impl::dropBinding() {
  bound = {};
  boundToTarget = false;
  evaluated.reset();
  // New objects, because the old ones may still be referenced.
  points = std::make_shared<Points>(0, 3);
  map = std::make_shared<deformation::StressMap>();
  ++revision;
  statistics = {};
  pending.moved = true;
  dropCycle();
}

void LiveStress::Impl::dropMesh() {
  if (mesh)
    pending.sampled = true;
  mesh.reset();
  onSurface.reset();
  target.reset();
  dropBinding();
}

/// The map in the pose that is shown; nothing while the document has other handles than the binding, and
/// where it is that map already: organs that come or look otherwise are changes, too.
void LiveStress::Impl::evaluate() {
  if (!organ || !boundToTarget || rigSeen != document.state().rig || systemSeen != document.state().system)
    return;
  const std::shared_ptr<const Points> shown = live.sharedPose();
  const Points& pose = *shown;
  if (pose.rows() != bound.gradients->handles() || (evaluated && samePose(*evaluated, pose)))
    return;
  bound.gradients->evaluate(pose, *map, options.threads);
  bound.positions->deform(pose, *points, options.threads);
  for (const int point : bound.positions->report().failures)
    points->row(point) = mesh->points.row(point);
  statistics = deformation::statisticsOf(*map, mesh->witnesses);
  evaluated = shown;
  ++revision;
  pending.moved = true;
}

void LiveStress::Impl::tell() {
  const StressEvent event = std::exchange(pending, {});
  if (event.status || event.sampled || event.moved || event.cycle)
    document.announce(events.emission(event));
}

LiveStress::LiveStress(document::Document& document, const coordinates::Registry& registry, LiveBinding& live,
                       JobQueue& jobs, Options options)
    : impl_(std::make_unique<Impl>(document, registry, live, jobs, std::move(options))) {
  impl_->subscriptions.push_back(document.onDerive([this](const document::Change& change) {
    if (!impl_->organ || (!change.organs() && !change.rig() && !change.system()))
      return;
    impl_->refresh();
    impl_->tell();
  }));
  // Not when the organ moves: where it cannot be bound it does not, and its witnesses inside the hull do.
  impl_->subscriptions.push_back(live.onDerive([this] {
    impl_->evaluate();
    impl_->tell();
  }));
}

LiveStress::LiveStress(document::Document& document, const coordinates::Registry& registry, LiveBinding& live,
                       JobQueue& jobs)
    : LiveStress(document, registry, live, jobs, Options{}) {}

LiveStress::~LiveStress() {
  for (const char* slot : {kSampleSlot, kBindSlot, kCycleSlot})
    impl_->jobs.cancelSlot(slot);
}

void LiveStress::follow(document::OrganId organ) {
  if (organ == impl_->organ)
    return;
  impl_->organ = organ;
  impl_->refresh();
  impl_->tell();
}

document::OrganId LiveStress::organ() const {
  return impl_->organ;
}

void LiveStress::setWanted(int witnesses) {
  if (witnesses < WitnessOptions::kFewest || witnesses > WitnessOptions::kMost)
    throw UsageError(phrase("The number of witness points must be from %1 to %2", WitnessOptions::kFewest,
                            WitnessOptions::kMost));
  if (witnesses == impl_->options.witnesses.wanted)
    return;
  impl_->options.witnesses.wanted = witnesses;
  impl_->refresh();
  impl_->tell();
}

int LiveStress::wanted() const {
  return impl_->options.witnesses.wanted;
}

void LiveStress::retry() {
  Impl& impl = *impl_;
  if (impl.status.state != StressState::cancelled && impl.status.state != StressState::failed)
    return;
  if (impl.sampleMissing)
    impl.surface.reset();
  impl.target.reset();
  impl.status.state = StressState::off;
  impl.refresh();
  impl.tell();
}

const StressStatus& LiveStress::status() const {
  return impl_->status;
}
std::shared_ptr<const deformation::WitnessMesh> LiveStress::mesh() const {
  return impl_->mesh;
}
const Points& LiveStress::points() const {
  return *impl_->points;
}
const deformation::StressMap& LiveStress::map() const {
  return *impl_->map;
}
const deformation::StressStatistics& LiveStress::statistics() const {
  return impl_->statistics;
}

deformation::PrincipalStretches LiveStress::stretchesAt(Eigen::Index point) const {
  if (!impl_->bound.gradients || impl_->live.shownPose().rows() != impl_->bound.gradients->handles())
    return {};
  return deformation::principalStretches(
      impl_->bound.gradients->deformationGradient(point, impl_->live.shownPose()));
}

std::shared_ptr<const deformation::WitnessGradients> LiveStress::gradients() const {
  return impl_->bound.gradients;
}

void LiveStress::findCycle(PosedCycle cycle, CycleParts parts) {
  Impl& impl = *impl_;
  if (impl.status.state != StressState::ready)
    throw UsageError("There is no stress map yet", {}, "wait until the witness points are computed");
  const auto work = [cycle = std::move(cycle), parts, gradients = impl.bound.gradients,
                     witnesses = impl.mesh->witnesses, threads = impl.options.threads](Progress& progress) {
    return stressOverCycle(*gradients, witnesses, cycle, kCycleInstants, parts, threads, progress);
  };
  const auto done = [weak = std::weak_ptr<Impl*>(impl.self),
                     mine = ++impl.cycleTicket](JobResult<CycleStress> result) {
    const auto alive = weak.lock();
    if (!alive || (*alive)->cycleTicket != mine)
      return;
    (*alive)->cycleArrived(std::move(result));
    (*alive)->tell();
  };
  impl.findingCycle = true;
  impl.cycleMessage = {};
  impl.jobs.submit<CycleStress>("Stress over the cycle", kCycleSlot, work, done);
}

void LiveStress::dropCycle() {
  impl_->dropCycle();
  impl_->tell();
}

std::shared_ptr<const CycleStress> LiveStress::cycle() const {
  return impl_->cycle;
}
bool LiveStress::findingCycle() const {
  return impl_->findingCycle;
}
const Text& LiveStress::cycleMessage() const {
  return impl_->cycleMessage;
}

StressFrame LiveStress::frame() const {
  const Impl& impl = *impl_;
  StressFrame frame{impl.organ, impl.mesh, impl.onSurface, nullptr, nullptr, impl.cycle, {}, impl.revision};
  if (impl.organ && impl.points->rows() > 0) {
    frame.points = impl.points;
    frame.map = impl.map;
    frame.stretchesAt = [this](Eigen::Index point) { return stretchesAt(point); };
  }
  return frame;
}

StressCopy LiveStress::copy() const {
  if (!impl_->organ || !impl_->boundToTarget)
    return {};
  return {frame(), impl_->bound.gradients, impl_->bound.positions};
}

Subscription LiveStress::onEvent(std::function<void(const StressEvent&)> observer) {
  return impl_->events.connect(std::move(observer));
}

} // namespace viscera::live
