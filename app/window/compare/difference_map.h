#pragma once

#include <QObject>

#include <optional>
#include <vector>

#include "window/view/picture.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Colours the organs of a second view by how far each vertex lies from the same vertex in the first one, in
/// mm: where two systems of coordinates disagree, or two poses. While a stress map is on, it shows by how
/// much its quantity in the first view exceeds that in the second. The colours reach to the greatest
/// difference since it was switched on, so that they mean the same in each frame.
class DifferenceMap final : public QObject {
  Q_OBJECT

public:
  /// The second document mirrors the first; all must live longer.
  DifferenceMap(Workspace& first, Workspace& second, const ViewModel& view, Picture& picture,
                QObject* parent = nullptr);
  ~DifferenceMap() override;

  void setOn(bool on);
  bool on() const { return on_; }
  /// Resets the range of the colours; called when something else is compared.
  void restart();
  /// The greatest difference in the current frame, mm or in the unit of the stress map's quantity.
  double greatest() const { return greatest_; }

private:
  void followSoon();
  void follow();
  presentation::SurfaceMap distances();
  std::optional<presentation::SurfaceMap> stressDifference();

  Workspace& first_;
  Workspace& second_;
  const ViewModel& view_;
  Picture& picture_;
  bool on_ = false;
  bool waiting_ = false;
  double greatest_ = 0;
  double reach_ = 0;                           ///< Upper end of the colour range.
  std::optional<live::StressMeasure> measure_; ///< Of the map that is shown; none: distances.
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
