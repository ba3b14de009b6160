#include "viscera/document/system_commands.h"

#include <memory>
#include <utility>

namespace viscera::document {
namespace {

DocumentState withSystem(DocumentState state, SystemChoice choice) {
  state.system = std::make_shared<const SystemChoice>(std::move(choice));
  return state;
}

} // namespace

Command setSystem(SystemChoice choice) {
  return {"Coordinates " + choice.id,
          [choice = std::move(choice)](const DocumentState& state, IdSource&) {
            return withSystem(state, choice);
          },
          {}};
}

Command setParameter(std::string name, double value) {
  return {"Set " + name,
          [name, value](const DocumentState& state, IdSource&) {
            SystemChoice choice = *state.system;
            choice.parameters.set(name, value);
            return withSystem(state, std::move(choice));
          },
          "parameter/" + name};
}

} // namespace viscera::document
