#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/document/document.h"
#include "viscera/live/live_binding.h"
#include "viscera/plugin/registry.h"

namespace viscera::live {

/// Everything about a binding but the organ: what all organs of a document are to be bound to.
struct BindingTarget {
  std::shared_ptr<const coordinates::CoordinateSystem> system; ///< Null when there is none of that id.
  std::string problem;                                         ///< Why there is none.
  coordinates::ParameterValues parameters;
  coordinates::HandleSet handles;
  std::vector<document::HandleId> ids; ///< Of the rows of `handles.positions`.
};

BindingTarget makeTarget(const document::DocumentState& state, const plugin::Registry& registry);

/// Whether a binding to one is as good as a binding to the other. Groups and cages count only where the
/// system looks at them.
bool sameBinding(const BindingTarget& a, const BindingTarget& b);

/// Whether it is the rig's own cage that binding works with.
bool usesGivenCage(const BindingTarget& target);

/// Whether a binding to `underWay` is worth waiting for when `wanted` has taken its place: the same handles,
/// elsewhere perhaps, in the same system and cage. A drag or a slider would else give up one binding after
/// the other.
bool worthWaitingFor(const BindingTarget& underWay, const BindingTarget& wanted);

/// The status of every organ when nothing can be bound to this target; none when it is worth trying.
std::optional<BindingStatus> statusWithoutBinding(const BindingTarget& target);

} // namespace viscera::live
