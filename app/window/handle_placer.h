#pragma once

#include <QObject>

#include <optional>

#include "viscera/deformation/place_handles.h"
#include "window/workspace.h"

namespace viscera::app {

/// Places handles around the organs automatically, with a live preview while the user chooses their number.
class HandlePlacer final : public QObject {
  Q_OBJECT

public:
  explicit HandlePlacer(Workspace& workspace, QObject* parent = nullptr);

  const deformation::Placement& placement() const { return placement_; }
  /// The smallest and the largest number of handles that can be chosen.
  int fewest() const { return deformation::fewestHandles(placement_.enclosing); }
  int most() const { return 200; }

  /// Sets the number of handles and places them anew; all changes until `finish` are one undo step.
  void setCount(int count);
  void setEnclosing(bool enclosing);
  void finish();
  /// Places the chosen number of handles.
  void place();
  /// The command that places around an organ with the present choice, the enclosing ones around all organs of
  /// the document: every one of them can be bound. May throw `DataError`.
  document::Command command(const document::Organ& organ) const;
  /// The same for an organ that is being added to `organs`: where its surface has no room for as many
  /// handles, the corners of a box around it, so that no organ is refused for its handles.
  document::Command commandOrBox(const document::Organ& organ, const document::OrganList& organs) const;

Q_SIGNALS:
  void placementChanged();

private:
  document::Command command(const document::Organ& organ, const document::OrganList& organs) const;
  Points around(const document::Organ& organ, const document::OrganList& organs) const;

  deformation::Placement placement_;
  Workspace& workspace_;
  std::optional<document::UndoStack::Step> choosing_; ///< From the first choice to `finish`.
};

} // namespace viscera::app
