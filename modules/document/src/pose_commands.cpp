#include "viscera/document/pose_commands.h"

#include <utility>

#include "viscera/document/edit.h"

namespace viscera::document {
namespace {

DocumentState withPose(DocumentState state, Points pose) {
  state.pose = std::make_shared<const Points>(std::move(pose));
  return state;
}

} // namespace

Command moveHandles(std::vector<HandleId> handles, Points positions) {
  const std::string name = edit::counted("Move", handles.size(), "handle");
  return {name,
          [handles = std::move(handles), positions = std::move(positions)](const DocumentState& state,
                                                                           IdSource&) {
            edit::requireMatch(positions, handles);
            Points pose = *state.pose;
            for (const auto& [row, item] : edit::freeRows(*state.rig, handles))
              pose.row(row) = positions.row(item);
            return withPose(state, std::move(pose));
          },
          {}};
}

Command setPose(Points pose, std::string name) {
  return {std::move(name),
          [pose = std::move(pose)](const DocumentState& state, IdSource&) {
            if (pose.rows() != state.pose->rows())
              throw DataError("The pose has " + std::to_string(pose.rows()) + " handles, the document " +
                                  std::to_string(state.pose->rows()),
                              {}, "use a pose of the same handles");
            return withPose(state, pose);
          },
          {}};
}

Command resetPose() {
  return {"Reset pose",
          [](const DocumentState& state, IdSource&) { return withPose(state, state.rig->restPositions()); },
          {}};
}

} // namespace viscera::document
