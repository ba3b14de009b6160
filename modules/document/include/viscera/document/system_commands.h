#pragma once

#include <string>

#include "viscera/document/command.h"

/// Commands that choose the coordinates. The document does not know which systems there are: what a system
/// does not accept is for whoever has the registry to refuse beforehand, and `LiveBinding` says it of every
/// organ.
namespace viscera::document {

/// Chooses the coordinates and all of their parameters.
Command setSystem(SystemChoice choice);

/// Sets one parameter of the present system. Values of one parameter that follow each other join one step
/// until `UndoStack::seal` (a slider).
Command setParameter(std::string name, double value);

} // namespace viscera::document
