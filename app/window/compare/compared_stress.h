#pragma once

#include <QObject>

#include <vector>

#include "window/stress/stress_cycle.h"
#include "window/timeline/playback.h"
#include "window/view/picture.h"
#include "window/view/view_model.h"
#include "window/workspace.h"

namespace viscera::app {

/// The stress map of the second view of a comparison: it is there while the first view has one, of the organ
/// that is compared, with the same look. While the look wants it both have one range of colours, which the
/// first view's legend says.
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
