#pragma once

#include <QObject>

#include <vector>

#include "window/stress/stress_cycle.h"
#include "window/timeline/playback.h"
#include "window/view/picture.h"
#include "window/view/view_model.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Shows the stress map of the compared organ in the second view while the first view shows one, with the
/// same look. When the look asks for it, both maps share one range of colours, and the first view's legend
/// shows that.
class ComparedStress final : public QObject {
  Q_OBJECT

public:
  /// One of the two views.
  struct Side {
    Workspace& workspace;
    Playback& playback;
    Picture& picture;
  };

  /// All have to live longer.
  ComparedStress(const Side& first, const Side& second, ViewModel& view, QObject* parent = nullptr);
  ~ComparedStress() override;

private:
  void follow();
  void shareRange();

  Side first_;
  Side second_;
  ViewModel& view_;
  StressCycle cycle_; ///< Of the second view.
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
