#pragma once

#include "window/stress/cut_controller.h"
#include "window/style/theme.h"
#include "window/widgets/page.h"
#include "window/work/actions.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;

namespace viscera::app {

class Histogram;
class MarksBox;
class ValueSlider;

/// The property page of the mode Stress: choice of the map, statistics and histogram, pinned probes, witness
/// points, and the cut.
class StressPage final : public Page {
  Q_OBJECT

public:
  StressPage(Workspace& workspace, Playback& playback, StressModel& model, CutController& cut,
             const Actions& actions, QWidget* parent = nullptr);

  void setTheme(const Theme& theme);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void makeMap(const Actions& actions);
  void makeMaterial();
  void makeNumbers(const Actions& actions);
  void makeWitnesses();
  void makeInside(const Actions& actions);
  void makeExport(const Actions& actions);
  void makeMarks(const Actions& actions);
  /// A list of choices for a part of the look; `change` is called with the index of the chosen one.
  QComboBox* addChoice(const char* id, const QString& name, const QStringList& items,
                       std::function<void(StressLook&, int)> change);
  QWidget* makePose();
  QWidget* makeDirections();
  QWidget* makeWitnessCount();
  void syncLook();
  void syncMaterial();
  void syncStatus();
  void syncPose();
  void syncNumbers();
  /// What to do where the map shows nothing; empty where it shows something.
  QString hintText() const;
  void syncThreshold();

  Workspace& workspace_;
  Playback& playback_;
  StressModel& model_;
  CutController& cut_;
  QPushButton* ownPose_ = nullptr;
  QPushButton* played_ = nullptr;
  QComboBox* quantity_ = nullptr;
  QComboBox* material_ = nullptr;
  ValueSlider* young_ = nullptr;   ///< Of a material of the user's own.
  ValueSlider* poisson_ = nullptr; ///< Of any stated material.
  QLabel* source_ = nullptr;       ///< Where the stiffness is from, or that a material has to be chosen.
  QComboBox* colors_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* hint_ = nullptr;
  QLabel* caution_ = nullptr;
  QLabel* meaning_ = nullptr;  ///< What the displayed quantity says.
  QLabel* squeezed_ = nullptr; ///< That volumes change more than those of tissue.
  QLabel* min_ = nullptr;
  QLabel* mean_ = nullptr;
  QLabel* percentile_ = nullptr;
  QLabel* max_ = nullptr;
  QLabel* folded_ = nullptr;
  QLabel* peakTime_ = nullptr; ///< Time of the maximum in the cycle; hidden without a cycle.
  QPushButton* toPeak_ = nullptr;
  Histogram* histogram_ = nullptr;
  MarksBox* marks_ = nullptr;
  QSlider* countSlider_ = nullptr;
  QSpinBox* countField_ = nullptr;
  QLabel* origin_ = nullptr;
  QLabel* points_ = nullptr;
  QLabel* derivatives_ = nullptr;
  QLabel* remarks_ = nullptr;
  QPushButton* retry_ = nullptr;
  QComboBox* style_ = nullptr;
  ValueSlider* offset_ = nullptr;
  QWidget* directions_ = nullptr;
  QComboBox* side_ = nullptr;
  ValueSlider* limit_ = nullptr;
  QComboBox* glyphs_ = nullptr;
  double instant_ = 0; ///< The instant of the cycle when the user switched to the document's pose; the
                       ///< sequence is shown there again.
};

} // namespace viscera::app
