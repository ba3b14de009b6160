#include "viscera/live/live_bend.h"

#include <optional>
#include <string>
#include <utility>

#include "bound_organ.h"
#include "viscera/core/error.h"

namespace viscera::live {

using deformation::InverseMap;

struct LiveBend::Impl {
  document::Document& document;
  LiveBinding& live;
  const plugin::Registry& registry;
  JobQueue& jobs;
  Signal<> changed = {};
  Subscription subscription = {};
  bool wanted = false;
  bool binding = false;
  std::uint64_t jobsBegun = 0;
  std::optional<BindingTarget> target = {}; ///< Of `map`, or of what is being bound.
  std::shared_ptr<InverseMap> map = nullptr;
  Points pose = Points(0, 3); ///< That `map` is in.
  std::uint64_t revision = 0;
  std::string problem = {};

  bool posed() const {
    const Points rest = document.rig().restPositions();
    const Points& shown = live.shownPose();
    return shown.rows() == rest.rows() && rest.rows() > 0 && shown != rest;
  }
  void follow();
  void take(const JobResult<std::shared_ptr<InverseMap>>& result);
};

/// Binds anew when that is wanted and what there is belongs to other handles. At rest nothing is bound: the
/// grid is made as fine as the first pose asks for.
void LiveBend::Impl::follow() {
  if (!wanted || !posed())
    return;
  BindingTarget now = makeTarget(document.state(), registry);
  if (target && sameBinding(*target, now))
    return;
  if (binding && target && worthWaitingFor(*target, now))
    return;
  map.reset();
  ++revision;
  problem.clear();
  target = now;
  if (!now.system) {
    problem = now.problem;
    return;
  }
  binding = true;
  jobs.submit<std::shared_ptr<InverseMap>>(
      "Bending the scan", "bend",
      [now, first = live.shownPose()](Progress& progress) {
        return std::make_shared<InverseMap>(*now.system, now.handles, first,
                                            coordinates::BindOptions{now.parameters, {}},
                                            deformation::InverseMapOptions(), progress);
      },
      [this, job = ++jobsBegun](const JobResult<std::shared_ptr<InverseMap>>& result) {
        if (job == jobsBegun) // Else another one has taken its place.
          take(result);
      });
}

void LiveBend::Impl::take(const JobResult<std::shared_ptr<InverseMap>>& result) {
  binding = false;
  if (result.cancelled()) { // Somebody gave it up; the next change tries again.
    target.reset();
    return;
  }
  map = result.value ? *result.value : nullptr;
  if (result.error)
    problem = result.error->what();
  pose.resize(0, 3);
  ++revision;
  follow(); // What was wanted meanwhile.
  changed.emit();
}

LiveBend::LiveBend(document::Document& document, LiveBinding& live, const plugin::Registry& registry,
                   JobQueue& jobs)
    : impl_(new Impl{document, live, registry, jobs}) {
  impl_->subscription = live.onDerive([this] { impl_->follow(); });
}

LiveBend::~LiveBend() = default;

void LiveBend::setWanted(bool wanted) {
  if (std::exchange(impl_->wanted, wanted) != wanted)
    impl_->follow();
}

const InverseMap* LiveBend::map() {
  Impl& p = *impl_;
  p.follow();
  if (!p.wanted || !p.map || !p.posed())
    return nullptr;
  const Points& shown = p.live.shownPose();
  if (p.pose.rows() != shown.rows() || p.pose != shown) {
    p.map->setPose(shown);
    p.pose = shown;
    ++p.revision;
  }
  return p.map.get();
}

std::uint64_t LiveBend::revision() const {
  return impl_->revision;
}

const std::string& LiveBend::problem() const {
  return impl_->problem;
}

Subscription LiveBend::onChange(std::function<void()> observer) {
  return impl_->changed.connect(std::move(observer));
}

} // namespace viscera::live
