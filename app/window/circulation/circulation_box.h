#pragma once

#include <QWidget>

#include <map>
#include <string>
#include <vector>

#include "viscera/circulation/parameters.h"
#include "window/circulation/circulation_model.h"
#include "window/work/actions.h"

class QAbstractButton;
class QLabel;
class QVBoxLayout;

namespace viscera::app {

class ValueSlider;

/// The controls that choose how the heart beats: by the textbook's beat or by a computed circulation, with
/// scenarios, parameters with their normal ranges, and a circulation that is kept to compare with.
class CirculationBox final : public QWidget {
  Q_OBJECT

public:
  CirculationBox(Workspace& workspace, Playback& playback, CirculationModel& model, const Actions& actions,
                 QWidget* parent = nullptr);

Q_SIGNALS:
  /// The user wants to see the heart in a scenario, or in the present one.
  void scenarioChosen(const QString& id);
  /// The user wants the sample heart's own beat in the place of another motion of it.
  void heartChosen();

private:
  void makeChoice();
  QWidget* makeScenarios();
  QWidget* makeComparison(const Actions& actions);
  QWidget* makeControls();
  QWidget* makeGroup(const std::vector<const char*>& names);
  ValueSlider* makeControl(const circulation::ParameterInfo& info, const QString& name);
  void markSource(bool drives);
  void sync();
  /// Whether the sample heart is there, and a motion is chosen that is none of the two: recorded or measured.
  bool movedOtherwise() const;

  Workspace& workspace_;
  Playback& playback_;
  CirculationModel& model_;
  QAbstractButton* textbook_ = nullptr;
  QAbstractButton* circulation_ = nullptr;
  QWidget* details_ = nullptr; ///< The controls that only apply to a circulation.
  std::map<std::string, QAbstractButton*> scenarios_;
  std::map<std::string, ValueSlider*> controls_;
  QLabel* summary_ = nullptr;
  QLabel* kept_ = nullptr;
  QLabel* failure_ = nullptr;
  QLabel* standing_ = nullptr;
  Subscription subscription_;
};

} // namespace viscera::app
