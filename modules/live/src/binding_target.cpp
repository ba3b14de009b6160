#include "binding_target.h"

#include <algorithm>

#include "viscera/core/error.h"

namespace viscera::live {
namespace {

/// Fewer handles span no volume.
constexpr std::size_t kFewestHandles = 4;

bool sameGroups(const coordinates::HandleSet& a, const coordinates::HandleSet& b) {
  return std::equal(a.groups.begin(), a.groups.end(), b.groups.begin(), b.groups.end(),
                    [](const coordinates::HandleGroup& x, const coordinates::HandleGroup& y) {
                      return x.name == y.name && x.handles == y.handles;
                    });
}

bool sameCage(const coordinates::HandleSet& a, const coordinates::HandleSet& b) {
  return a.cage.rows() == b.cage.rows() && a.cage == b.cage;
}

bool needsCage(const BindingTarget& target) {
  return target.system && target.system->traits().needsCage;
}

} // namespace

bool usesGivenCage(const BindingTarget& target) {
  return needsCage(target) && target.handles.cage.rows() > 0;
}

BindingTarget makeTarget(const document::DocumentState& state, const plugin::Registry& registry) {
  BindingTarget target;
  target.parameters = state.system->parameters;
  target.handles = document::handleSet(*state.rig);
  for (const document::Handle& handle : state.rig->handles)
    target.ids.push_back(handle.id);
  try {
    target.system = registry.find(state.system->id);
    target.parameters.requireWithin(target.system->parameters());
  } catch (const Error& error) {
    target.system.reset();
    target.problem = error.what();
  }
  return target;
}

bool sameBinding(const BindingTarget& a, const BindingTarget& b) {
  const bool groupsMatter =
      (a.system && a.system->traits().usesGroups) || (b.system && b.system->traits().usesGroups);
  return a.system == b.system && a.problem == b.problem && a.ids == b.ids &&
         a.handles.positions == b.handles.positions && a.parameters.all() == b.parameters.all() &&
         (!groupsMatter || sameGroups(a.handles, b.handles)) &&
         (!(needsCage(a) || needsCage(b)) || sameCage(a.handles, b.handles));
}

bool worthWaitingFor(const BindingTarget& underWay, const BindingTarget& wanted) {
  return underWay.system == wanted.system && underWay.ids == wanted.ids &&
         (!needsCage(wanted) || sameCage(underWay.handles, wanted.handles));
}

std::optional<BindingStatus> statusWithoutBinding(const BindingTarget& target) {
  using State = BindingStatus::State;
  const std::size_t count = target.ids.size();
  if (count == 0)
    return BindingStatus{State::unbound};
  if (count < kFewestHandles)
    return BindingStatus{State::unbound, "An organ needs at least four handles around it: add " +
                                             std::to_string(kFewestHandles - count) + " more"};
  if (!target.system)
    return BindingStatus{State::failed, target.problem};
  return std::nullopt;
}

} // namespace viscera::live
