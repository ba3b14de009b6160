#include "viscera/document/command.h"

#include <utility>

namespace viscera::document {

Command combined(std::string name, std::vector<Command> commands) {
  return {std::move(name),
          [commands = std::move(commands)](const DocumentState& state, IdSource& ids) {
            DocumentState now = state;
            for (const Command& command : commands)
              now = command.apply(now, ids);
            return now;
          },
          {}};
}

} // namespace viscera::document
