#pragma once

#include <QWidget>

#include <vector>

#include "window/workspace.h"

class QComboBox;
class QLabel;
class QVBoxLayout;

namespace viscera::app {

/// The choice of the coordinates: a list of the systems there are, a line about the chosen one, badges for
/// what it can do, and its parameters, made from what the system says of itself.
class SystemBox final : public QWidget {
  Q_OBJECT

public:
  explicit SystemBox(Workspace& workspace, QWidget* parent = nullptr);

private:
  void sync();
  void rebuildBadges(const coordinates::Traits& traits);
  void rebuildParameters();
  QWidget* editorFor(const coordinates::Parameter& parameter);

  Workspace& workspace_;
  QComboBox* combo_;
  QLabel* summary_;
  QWidget* badges_;
  QWidget* parameterBox_ = nullptr;
  QVBoxLayout* column_;
  std::string shownSystem_;
  std::vector<std::function<void()>> readers_; ///< Bring the editors up to date.
  session::Subscription subscription_;
};

} // namespace viscera::app
