#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/document/document.h"

namespace viscera::document {

/// A change of the document, as a value: it makes a new state from a state, without side effects. Undo
/// restores the previous state, so it is exact whatever the command does.
///
/// `apply` throws an `Error` when the change is not possible; the document is then as it was. It need not
/// check whether the state can be saved: `UndoStack::perform` does (validate.h). Commands are made by the
/// functions in organ_commands.h, rig_commands.h, group_commands.h, system_commands.h,
/// key_sequence_commands.h, measurement_commands.h, circulation_commands.h, axes_commands.h, scan_item.h and
/// open_files.h.
struct Command {
  Text name; ///< "Move handle H-3", shown in the menu.
  std::function<DocumentState(const DocumentState& state, IdSource& ids)> apply;
  /// Not empty: a command that follows one with the same key joins its undo step (a slider that moves).
  std::string mergeKey = {};
};

/// One command that does all of `commands` in order, or none.
inline Command combined(Text name, std::vector<Command> commands) {
  return {std::move(name), [commands = std::move(commands)](DocumentState state, IdSource& ids) {
            for (const Command& command : commands)
              state = command.apply(state, ids);
            return state;
          }};
}

} // namespace viscera::document
