#pragma once

#include <QString>

#include <functional>
#include <vector>

#include "window/work/workspace.h"

/// Changes how several organs look. Each change is one undo step; nothing happens where nothing would change.
namespace viscera::app {

/// Further changes with the same name and organs are merged into the step until `UndoStack::seal`.
void changeLooks(Workspace& workspace, const QString& name, const std::vector<document::OrganId>& organs,
                 const std::function<void(document::OrganLook&)>& change);

/// The ones whose names tell of which colour textbooks draw them, and which have another one: that of their
/// file.
std::vector<document::OrganId> withoutTextbookColors(const Workspace& workspace,
                                                     const std::vector<document::OrganId>& organs);

/// Gives those organs the colours of textbooks, in one undo step.
void giveTextbookColors(Workspace& workspace, const QString& name,
                        const std::vector<document::OrganId>& organs);

/// Shows the organs for which `visible` returns true, and hides all others.
void showWhere(Workspace& workspace, const QString& name,
               const std::function<bool(const document::Organ&)>& visible);

/// Shows these organs with their cavities, and hides all others.
void showOnly(Workspace& workspace, const std::vector<document::OrganId>& organs);

} // namespace viscera::app
