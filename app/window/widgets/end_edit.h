#pragma once

class QTreeWidget;

namespace viscera::app {

/// Ends the edit of a cell, if one is under way, with what was typed. For commands that begin another edit:
/// Qt would refuse it with a warning. May change the list's rows, as the end of any edit.
void endEdit(QTreeWidget& list);

} // namespace viscera::app
