#pragma once

#include <QWidget>

#include <vector>

#include "window/group_layout.h"
#include "window/workspace.h"

class QComboBox;
class QLabel;
class QVBoxLayout;

namespace viscera::app {

/// The choice of the coordinates: a list of the systems there are, a line about the chosen one, badges for
/// what it can do, and its parameters, made from what the system says of itself. A slider ends where the
/// handles bound its parameter.
class SystemBox final : public QWidget {
  Q_OBJECT

public:
  SystemBox(Workspace& workspace, GroupLayout& layout, QWidget* parent = nullptr);

private:
  void sync();
  void rebuildBadges(const coordinates::Traits& traits);
  void rebuildParameters();
  QWidget* editorFor(const coordinates::Parameter& parameter);
  QWidget* sliderFor(const coordinates::Parameter& parameter, const QString& name);

  Workspace& workspace_;
  GroupLayout& layout_;
  QComboBox* combo_;
  QLabel* summary_;
  QWidget* badges_;
  QWidget* parameterBox_ = nullptr;
  QVBoxLayout* column_;
  std::string shownSystem_;
  std::vector<std::function<void()>> readers_; ///< Bring the editors up to date.
  Subscription subscription_;
};

} // namespace viscera::app
