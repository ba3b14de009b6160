#pragma once

#include <QObject>

#include <optional>

#include "viscera/deformation/place_handles.h"
#include "window/work/workspace.h"

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
  /// Places the chosen number of handles around the chosen organ, or around all visible organs where none is
  /// chosen.
  void place();
  /// The command that places with the present choice around all organs of a document, each whole organ by the
  /// size of its surface. May throw `DataError`.
  document::Command command(const document::OrganList& organs) const;
  /// The same for organs that are being added: where their surfaces have no room for as many handles, the
  /// corners of a box around them, so that no organ is refused for its handles.
  document::Command commandOrBox(const document::OrganList& organs) const;

Q_SIGNALS:
  void placementChanged();

private:
  document::OrganList chosen() const;
  /// Around `chosen`; the box encloses all `organs`, so that every one of them can be bound.
  document::Command command(const document::OrganList& chosen, const document::OrganList& organs) const;

  deformation::Placement placement_;
  Workspace& workspace_;
  std::optional<document::UndoStack::Step> choosing_; ///< From the first choice to `finish`.
};

} // namespace viscera::app
