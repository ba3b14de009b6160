#pragma once

#include <QObject>

#include <vector>

#include "window/view/picture.h"
#include "window/workspace.h"

namespace viscera::app {

/// Colours the organs of a second view by how far each vertex lies from the same vertex in the first one, in
/// mm: where two systems of coordinates disagree. The colours reach from 0 to the greatest distance since it
/// was switched on, so that they mean the same in each frame.
class DifferenceMap final : public QObject {
  Q_OBJECT

public:
  /// The second document mirrors the first; all must live longer.
  DifferenceMap(Workspace& first, Workspace& second, Picture& picture, QObject* parent = nullptr);
  ~DifferenceMap() override;

  void setOn(bool on);
  bool on() const { return on_; }
  /// Resets the range of the colours; called when something else is compared.
  void restart();
  /// The greatest distance in the current frame, mm.
  double greatest() const { return greatest_; }

private:
  void followSoon();
  void follow();

  Workspace& first_;
  Workspace& second_;
  Picture& picture_;
  bool on_ = false;
  bool waiting_ = false;
  double greatest_ = 0;
  double reach_ = 0; ///< Upper end of the colour range, mm.
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
