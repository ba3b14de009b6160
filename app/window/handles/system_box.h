#pragma once

#include <QWidget>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "window/work/workspace.h"

class QLabel;
class QVBoxLayout;

namespace viscera::app {

class SystemCombo;

/// The controls that choose the coordinate system: a list of the systems, a line about the chosen one, badges
/// for what it can do, and its parameters, made from the system's description of itself. If the handles limit
/// a parameter, its slider ends there.
class SystemBox final : public QWidget {
  Q_OBJECT

public:
  explicit SystemBox(Workspace& workspace, QWidget* parent = nullptr);

private:
  void sync();
  void rebuildBadges(const coordinates::Traits& traits);
  void rebuildParameters();
  QWidget* editorFor(const coordinates::Parameter& parameter);
  QWidget* sliderFor(const coordinates::Parameter& parameter, const QString& name);

  Workspace& workspace_;
  SystemCombo* combo_;
  QLabel* summary_;
  QWidget* badges_;
  QWidget* parameterBox_ = nullptr;
  QVBoxLayout* column_;
  std::string shownSystem_;
  std::map<std::string, double> upperBounds_;  ///< Limits of parameters that depend on the handles.
  std::vector<std::function<void()>> readers_; ///< Functions that update the editors.
  Subscription subscription_;
};

} // namespace viscera::app
