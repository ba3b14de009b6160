#include "viscera/live/live_binding.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "bound_organ.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/validate.h"

namespace viscera::live {
namespace {

constexpr int kRevisionBits = 40; ///< Number of bits that count the moves of one organ.

/// The expected cost of binding before it was measured, s per (vertex x handle).
constexpr double kExpectedBindingSeconds = 30e-9;

using State = BindingStatus::State;

/// The owner of the pose that is shown.
enum class Shown { document, rest, given };

} // namespace

struct LiveBinding::Impl : BoundOrgans {
  Impl(document::Document& documentIn, const coordinates::Registry& registryIn, JobQueue& jobsIn,
       Options optionsIn)
      : document(documentIn), registry(registryIn), jobs(jobsIn), options(optionsIn) {
    threads = options.threads;
  }

  document::Document& document;
  const coordinates::Registry& registry;
  JobQueue& jobs;
  Options options;
  std::map<std::string, double> secondsOfSystem; ///< Measured, per (vertex x handle).
  std::int64_t lastTicket = 0;
  std::uint64_t made = 0; ///< Organs so far: no two of them share a revision.
  Shown shown = Shown::document;
  Signal<const LiveEvent&> events;
  Signal<> derived; ///< From `shownPose`.
  Subscription subscription;
  /// Results that arrive after the end see that it is gone.
  std::shared_ptr<Impl*> self = std::make_shared<Impl*>(this);

  void onChange(const document::Change& change);
  void matchOrgans();
  void matchTarget();
  void matchPose();
  void bindWaiting();
  double expectedSeconds(const BoundOrgan& organ) const;
  void bindNow(BoundOrgan& organ);
  void bindLater(BoundOrgan& organ);
  void arrived(document::OrganId id, std::int64_t ticket, JobResult<BindingResult> result);
  void take(BoundOrgan& organ, BindingResult result, std::shared_ptr<const BindingTarget> of);
  void show();
  void tellShown(bool otherPose);
  void tell(bool otherPose = false);
};

void LiveBinding::Impl::onChange(const document::Change& change) {
  if (change.organs())
    matchOrgans();
  if (change.rig() && shown == Shown::given)
    shown = Shown::document;
  if (change.rig() || change.system())
    matchTarget();
  const std::shared_ptr<const Points> before = shownPose;
  matchPose();
  bindWaiting();
  poseAll(change.interactive);
  tellShown(!samePose(*before, *shownPose));
}

/// Organs of the document come and go; one whose surface or mobility is another one counts as new.
void LiveBinding::Impl::matchOrgans() {
  for (auto item = organs.begin(); item != organs.end();) {
    const auto present = document.organ(item->first);
    if (present && present->mesh == item->second.organ->mesh &&
        present->mobility == item->second.organ->mobility) {
      item->second.organ = present;
      ++item;
    } else {
      jobs.cancelSlot(item->second.slot());
      item = organs.erase(item);
    }
  }
  for (const auto& organ : document.organs()) {
    const auto [item, isNew] = organs.try_emplace(organ->id, organ);
    item->second.pending.organ = organ->id;
    if (isNew) {
      item->second.pending.replaced = item->second.pending.status = true;
      item->second.revision = ++made << kRevisionBits;
    }
  }
}

void LiveBinding::Impl::matchTarget() {
  auto wanted = std::make_shared<const BindingTarget>(makeTarget(document.state(), registry));
  if (!target || !sameBinding(*target, *wanted))
    target = std::move(wanted);
}

void LiveBinding::Impl::matchPose() {
  if (shown == Shown::document)
    shownPose = document.state().pose;
  else if (shown == Shown::rest)
    shownPose = std::shared_ptr<const Points>(target, &target->handles.positions);
}

/// Binds every organ for which the target has not been tried: all at once when that takes no longer than a
/// frame.
void LiveBinding::Impl::bindWaiting() {
  std::vector<BoundOrgan*> waiting;
  double expected = 0;
  const auto failure = statusWithoutBinding(*target);
  for (auto& [id, organ] : organs) {
    if (organ.attempted == target)
      continue;
    const bool underWay = organ.status.state == State::binding;
    organ.attempted = target;
    const bool known = organ.boundTo && sameBinding(*organ.boundTo, *target);
    if (underWay && !known && !failure && worthWaitingFor(*organ.underWay, *target))
      continue;
    if (underWay)
      jobs.cancelSlot(organ.slot());
    if (known) {
      organ.boundTo = target; // Back to where it was, by undo perhaps, before another binding was there.
      organ.setState(State::bound);
    } else if (failure) {
      organ.fail(*failure);
    } else {
      waiting.push_back(&organ);
      expected += expectedSeconds(organ);
    }
  }
  const bool now = options.frameSeconds > 0 && expected <= options.frameSeconds;
  for (BoundOrgan* organ : waiting)
    now ? bindNow(*organ) : bindLater(*organ);
}

double LiveBinding::Impl::expectedSeconds(const BoundOrgan& organ) const {
  if (target->system->traits().needsTetrahedra)
    return std::numeric_limits<double>::infinity(); // Seconds, whatever the size: never while a frame waits.
  const auto measured = secondsOfSystem.find(target->system->id());
  const double each = measured == secondsOfSystem.end() ? kExpectedBindingSeconds : measured->second;
  return each * static_cast<double>(organ.organ->mesh->points.rows()) *
         static_cast<double>(target->ids.size());
}

void LiveBinding::Impl::bindNow(BoundOrgan& organ) {
  Progress ignored;
  take(organ, bindToTarget(*organ.organ, *target, options.threads, ignored), target);
}

void LiveBinding::Impl::bindLater(BoundOrgan& organ) {
  organ.setState(State::binding);
  organ.ticket = ++lastTicket;
  organ.underWay = target;
  const auto work = [item = organ.organ, wanted = target, with = threads](Progress& progress) {
    return bindToTarget(*item, *wanted, with, progress);
  };
  const auto done = [weak = std::weak_ptr<Impl*>(self), id = organ.organ->id,
                     ticket = organ.ticket](JobResult<BindingResult> result) {
    if (const auto alive = weak.lock())
      (*alive)->arrived(id, ticket, std::move(result));
  };
  jobs.submit<BindingResult>(phrase("Binding %1", named(organ.organ->name)), organ.slot(), work, done);
}

/// Takes a result from the queue, which may be for an organ or a target that has been replaced: each job has
/// its ticket.
void LiveBinding::Impl::arrived(document::OrganId id, std::int64_t ticket, JobResult<BindingResult> result) {
  const auto found = organs.find(id);
  if (found == organs.end() || found->second.ticket != ticket || found->second.status.state != State::binding)
    return;
  BoundOrgan& organ = found->second;
  const auto of = std::exchange(organ.underWay, nullptr);
  const bool last = of == organ.attempted;
  if (result.cancelled()) {
    organ.setState(State::stale);
  } else {
    if (result.error && last)
      organ.fail({State::failed, result.error->explanation()});
    if (result.value && (last || result.value->deformer)) // Errors of outdated bindings are not reported.
      take(organ, std::move(*result.value), of);
    if (!last) {
      organ.attempted.reset();
      organ.setState(State::bound); // Nothing is under way any more.
      bindWaiting();
    }
  }
  poseOne(organ);
  tell();
}

void LiveBinding::Impl::take(BoundOrgan& organ, BindingResult result,
                             std::shared_ptr<const BindingTarget> of) {
  organ.take(std::move(result), std::move(of));
  const auto sizes =
      static_cast<double>(organ.organ->mesh->points.rows()) * static_cast<double>(target->ids.size());
  if (organ.deformer && sizes > 0)
    secondsOfSystem[target->system->id()] = organ.status.report.seconds / sizes;
}

/// Notifies the observers after all updates: an observer may read any organ, or show another pose.
void LiveBinding::Impl::tell(bool otherPose) {
  std::vector<LiveEvent> news;
  for (auto& [id, organ] : organs) {
    const LiveEvent event = std::exchange(organ.pending, {id});
    if (event.moved || event.replaced || event.status)
      news.push_back(event);
  }
  const auto moved = [](const LiveEvent& event) { return event.moved; };
  if (otherPose && std::none_of(news.begin(), news.end(), moved))
    news.push_back({{}, true});
  for (std::size_t i = 0; i + 1 < news.size(); ++i)
    news[i].more = true;
  FirstException exception;
  for (const LiveEvent& event : news)
    exception.watch([&] { document.announce(events.emission(event)); });
  exception.rethrow();
}

/// The same, after what is derived from the shown pose, when that is another one.
void LiveBinding::Impl::tellShown(bool otherPose) {
  FirstException exception;
  if (otherPose)
    exception.watch([this] { derived.emit(); });
  exception.watch([&] { tell(otherPose); });
  exception.rethrow();
}

void LiveBinding::Impl::show() {
  matchPose();
  poseAll(false);
  tellShown(true);
}

LiveBinding::LiveBinding(document::Document& document, const coordinates::Registry& registry, JobQueue& jobs,
                         Options options)
    : impl_(std::make_unique<Impl>(document, registry, jobs, options)) {
  impl_->matchTarget();
  impl_->matchOrgans();
  impl_->matchPose();
  impl_->bindWaiting();
  impl_->poseAll(false);
  impl_->tell(); // Without observers yet, so that later events only report changes.
  impl_->subscription =
      document.onDerive([this](const document::Change& change) { impl_->onChange(change); });
}

LiveBinding::LiveBinding(document::Document& document, const coordinates::Registry& registry, JobQueue& jobs)
    : LiveBinding(document, registry, jobs, Options{}) {}

LiveBinding::~LiveBinding() {
  for (const auto& [id, organ] : impl_->organs)
    if (organ.status.state == State::binding)
      impl_->jobs.cancelSlot(organ.slot());
}

void LiveBinding::showDocumentPose() {
  impl_->shown = Shown::document;
  impl_->show();
}

void LiveBinding::showRest() {
  impl_->shown = Shown::rest;
  impl_->show();
}

void LiveBinding::showPose(const Points& pose) {
  impl_->setShownPose(pose);
  impl_->shown = Shown::given;
  impl_->show();
}

const Points& LiveBinding::shownPose() const {
  return *impl_->shownPose;
}

std::shared_ptr<const Points> LiveBinding::sharedPose() const {
  return impl_->shownPose;
}

const Points& LiveBinding::points(document::OrganId organ) const {
  return impl_->require(organ).points();
}

std::shared_ptr<const Points> LiveBinding::sharedPoints(document::OrganId organ) const {
  return impl_->require(organ).sharedPoints();
}

std::uint64_t LiveBinding::revision(document::OrganId organ) const {
  return impl_->require(organ).revision;
}

deformation::Deformer* LiveBinding::deformer(document::OrganId organ) {
  return impl_->require(organ).deformer.get();
}

BindingStatus LiveBinding::status(document::OrganId organ) const {
  return impl_->require(organ).status;
}

OrganVolume LiveBinding::volume(document::OrganId organ) {
  return impl_->volume(organ);
}

std::uint64_t LiveBinding::measurings() const {
  return impl_->measurings;
}

Values LiveBinding::influence(document::OrganId organ, document::HandleId handle) const {
  return impl_->require(organ).influence(handle);
}

Values LiveBinding::weightsAt(document::OrganId organ, Eigen::Index vertex) const {
  return impl_->require(organ).weightsAt(vertex, impl_->document.rig().handles);
}

const deformation::Deformer* LiveBinding::bound(document::OrganId organ) const {
  return impl_->require(organ).bound();
}

PosedCopy LiveBinding::copy() const {
  return PosedCopy(impl_->copy());
}

void LiveBinding::rebind() {
  for (auto& [id, organ] : impl_->organs)
    if (organ.status.state == State::stale)
      organ.attempted.reset();
  impl_->bindWaiting();
  impl_->poseAll(false);
  impl_->tell();
}

bool LiveBinding::busy() const {
  return std::any_of(impl_->organs.begin(), impl_->organs.end(),
                     [](const auto& item) { return item.second.status.state == State::binding; });
}

Subscription LiveBinding::onEvent(std::function<void(const LiveEvent&)> observer) {
  return impl_->events.connect(std::move(observer));
}

Subscription LiveBinding::onDerive(std::function<void()> bringUpToDate) {
  return impl_->derived.connect(std::move(bringUpToDate));
}

} // namespace viscera::live
