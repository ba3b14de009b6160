#pragma once

#include <QWidget>

#include <map>
#include <string>

#include "viscera/motion/retarget.h"
#include "viscera/scene/landmark_glyphs.h"
#include "window/timeline/playback.h"
#include "window/view/view_widget.h"
#include "window/workspace.h"

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace viscera::app {

/// Fits a sequence to the organ that is there: a patient's heart beats, a patient's stomach moves its waves.
/// Landmarks are clicked in the view, or found by the shape of the organ.
class FitBox final : public QWidget {
  Q_OBJECT

public:
  FitBox(Workspace& workspace, Playback& playback, ViewWidget& view, QWidget* parent = nullptr);
  ~FitBox() override;

  const motion::Landmarks& landmarks() const { return landmarks_; }

protected:
  void hideEvent(QHideEvent* event) override;

private:
  struct Row {
    QToolButton* pick = nullptr;
    QLabel* place = nullptr;
  };

  std::string sequenceId() const;
  void rebuildRows();
  void pick(const std::string& role);
  void onClick(const QPointF& place);
  void setLandmark(const std::string& role, const Vec3& position);
  void syncRows();
  void syncTarget();
  void fit();
  void take(const motion::RetargetedSequence& fitted, document::OrganId organ, const std::string& sequence,
            const motion::Landmarks& given);

  Workspace& workspace_;
  Playback& playback_;
  ViewWidget& view_;
  QComboBox* sequence_;
  QLabel* target_;
  QWidget* rowsBox_ = nullptr;
  std::map<std::string, Row> rows_;
  QPushButton* fit_;
  motion::Landmarks landmarks_;
  std::string picking_; ///< The role for which a click is waited; empty: none.
  scene::LandmarkGlyphs glyphs_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
