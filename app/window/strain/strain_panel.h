#pragma once

#include <QLabel>
#include <QPointer>
#include <QStringList>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>
#include <QWidget>

#include <memory>
#include <optional>

#include "viscera/presentation/view_state.h"
#include "viscera/scene/bulls_eye.h"
#include "viscera/scene/curve_panels.h"
#include "window/strain/strain_model.h"
#include "window/style/theme.h"
#include "window/timeline/chart_cursor.h"

class QComboBox;

namespace viscera::app {

class Actions;
class AxisPicker;
class Picture;
class ViewModel;
class ViewWidget;

/// A panel with the strain of the heart's wall: the bull's eye of its 17 segments, curves over the cycle with
/// the bands of healthy adults, and the peaks in words. The mouse over a segment names it and shows its
/// curve, a click chooses it. While a handle is dragged the bull's eye is that of the pose. With a second
/// view both bull's eyes and their difference stand side by side. The user chooses the phase that strain is
/// measured from, and sets the axes of the heart. It is drawn anew when a reading or the choice changes; a
/// cursor follows every frame.
class StrainPanel final : public QWidget {
  Q_OBJECT

public:
  /// What the panel shows and works with; all have to live longer.
  struct Parts {
    StrainModel& model;
    Playback& playback;
    ViewModel& view;
    const Picture& picture; ///< Of the organs, on which axes are clicked.
    ViewWidget& widget;     ///< That shows them.
  };

  StrainPanel(const Parts& parts, const Actions& actions, QWidget* parent = nullptr);
  ~StrainPanel() override;

  /// Shows a second view's strain beside the first one's; null: ends that. It has to live until then.
  void setSecond(StrainModel* second);
  void setTheme(const Theme& theme);
  QSize sizeHint() const override { return {900, 320}; }

  /// Whether the user wants it in the place of the volumes.
  bool wanted() const;
  /// The bull's eyes as they are drawn.
  const std::vector<scene::BullsEyeFigure>& figures() const { return figures_; }
  const scene::CurvePanel& curves() const { return curves_; }
  /// Sets the axes of the heart by clicks.
  const AxisPicker& axes() const { return *axes_; }
  /// What is said below them about a lack or a limit.
  QString remarks() const { return remarks_->text(); }

Q_SIGNALS:
  void wantedChanged();

protected:
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QWidget* makeChoices(const Actions& actions);
  void followView();
  void rebuildSoon();
  void rebuild();
  void followFrame();
  void draw();
  void makeRoom(scene::CurvePanel& curves) const;
  void placeInstant();
  void hover(std::optional<int> segment);
  std::optional<int> segmentAt(const QPointF& place) const;
  std::optional<scene::BullsEyeFigure> figureOf(const StrainModel& model) const;
  void syncReferences();
  QString numbersText() const;
  QStringList furtherNumbers() const;
  QString segmentText() const;
  QString remarksText() const;

  StrainModel& model_;
  QPointer<StrainModel> second_;
  Playback& playback_;
  ViewModel& view_;
  std::unique_ptr<scene::BullsEyes> eyes_;
  std::unique_ptr<scene::CurvePanels> panels_;
  QVTKOpenGLNativeWidget* eyesWidget_;
  QVTKOpenGLNativeWidget* chart_;
  ChartCursor* cursor_;
  QComboBox* direction_;
  QComboBox* moment_;
  QComboBox* reference_;
  AxisPicker* axes_;
  QLabel* numbers_;
  QLabel* segment_;
  QLabel* remarks_;
  std::vector<scene::BullsEyeFigure> figures_;
  scene::CurvePanel curves_; ///< The panel that is drawn.
  std::optional<int> hovered_;
  std::optional<presentation::StrainLook> look_; ///< As it was followed last.
  std::size_t phase_ = 0;                        ///< Of the drawn bull's eye of an instant.
  QTimer soon_; ///< Ends when the picture of the organs is drawn: the charts take as long as that.
};

/// A segment's number and name in the language of the window: "8 mid anteroseptal".
QString nameOfSegment(int number);

} // namespace viscera::app
