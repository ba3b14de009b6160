#pragma once

#include <QWidget>

#include <map>
#include <string>

#include "viscera/document/measurement.h"
#include "viscera/live/retarget.h"
#include "viscera/live/textbook_motion.h"
#include "viscera/scene/measurement_glyphs.h"
#include "window/timeline/playback.h"
#include "window/view/picture.h"
#include "window/view/view_widget.h"
#include "window/work/workspace.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace viscera::app {

/// The controls that fit a sequence to the current organ, so that a patient's heart beats or a patient's
/// stomach moves its waves. The sequence that suits the organ is chosen. Landmarks are clicked in the view,
/// or found by the shape of the organ; while the box is visible, the view shows them with their names, and
/// they follow the organ. A heart with chambers gets a key sequence that moves these too, with the
/// ejection fraction that the user has set.
class FitBox final : public QWidget {
  Q_OBJECT

public:
  FitBox(Workspace& workspace, Playback& playback, Picture& picture, ViewWidget& view,
         QWidget* parent = nullptr);
  ~FitBox() override;

  /// The landmarks of the current organ, mm, at rest.
  const live::Landmarks& landmarks() const { return landmarks_; }
  /// The glyphs that show the landmarks in the view.
  const scene::MeasurementGlyphs& glyphs() const { return glyphs_; }
  /// Fits the sequence of that id to the current organ, and plays it.
  void fit(const QString& sequence);

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  struct Row {
    QToolButton* pick = nullptr;
    QLabel* place = nullptr;
  };
  /// A landmark in the view. A landmark inside the organ moves with the nearest point of the surface.
  struct Mark {
    std::string name;
    Vec3 rest = Vec3::Zero();
    document::MeasuredPoint surface;
    bool computed = false;
  };

  std::string sequenceId() const;
  void rebuildRows();
  void pick(const std::string& role);
  void onClick(const QPointF& place);
  void setLandmark(const std::string& role, const Vec3& position);
  void syncRows();
  bool isMarked(const document::Organ& organ) const;
  void syncMarks();
  void syncGlyphs();
  /// The organ to which the sequence is fitted: the current one, or the heart around it if that is a chamber.
  std::shared_ptr<const document::Organ> target() const;
  /// The same organ if it is a heart with chambers that move too; else null.
  std::shared_ptr<const document::Organ> hollowHeart() const;
  void syncTarget();
  void chooseMatchingSequence(const document::Organ& organ);
  void fitChosen();
  void fitHeart(const document::Organ& heart, const live::Landmarks& given);
  void takeHeart(const live::PatientMotion& found, const document::Organ& heart);
  void take(const live::RetargetedSequence& fitted, document::OrganId organ, const std::string& sequence,
            const live::Landmarks& given);

  Workspace& workspace_;
  Playback& playback_;
  Picture& picture_;
  ViewWidget& view_;
  QComboBox* sequence_;
  QLabel* target_;
  QWidget* rowsBox_ = nullptr;
  std::map<std::string, Row> rows_;
  QWidget* ejectionBox_;
  QDoubleSpinBox* ejection_;
  QPushButton* fit_;
  live::Landmarks landmarks_;
  std::shared_ptr<const document::Organ> organ_; ///< The organ that the landmarks belong to; null without
                                                 ///< organs.
  std::vector<Mark> marks_;
  std::string picking_; ///< The role of the landmark that the next click sets; empty: none.
  scene::MeasurementGlyphs glyphs_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
