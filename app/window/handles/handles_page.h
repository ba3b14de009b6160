#pragma once

#include "window/widgets/page.h"
#include "window/work/actions.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// The property page of the mode Handles: the coordinates and their parameters, the cage of those that need
/// one, the groups, how well the organ is bound, and the place of the current handle.
class HandlesPage final : public Page {
  Q_OBJECT

public:
  HandlesPage(Workspace& workspace, const Actions& actions, QWidget* parent = nullptr);

private:
  void sync();
  void syncCage();

  Workspace& workspace_;
  QLabel* cage_ = nullptr;
  std::vector<QWidget*> cageButtons_;
  QLabel* organ_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* time_ = nullptr;
  QLabel* identity_ = nullptr;
  QLabel* smallest_ = nullptr;
  QLabel* message_ = nullptr;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
