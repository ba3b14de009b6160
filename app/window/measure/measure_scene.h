#pragma once

#include <QObject>

#include <vector>

#include "viscera/scene/measurement_glyphs.h"
#include "window/measure/measure_tool.h"

namespace viscera::app {

/// A measured value for a user: "83.4 mm", "57.3 degrees" with the sign for them.
QString formatMeasured(document::MeasurementKind kind, double value);

/// What a measurement says of the organs as they are shown now.
document::MeasuredValues measuredNow(Workspace& workspace, const document::Measurement& measurement);

/// What is drawn of the measurements of a document, in their order.
std::vector<scene::MeasurementGlyphs::Item> measurementItems(const document::DocumentState& state,
                                                             const document::PointsOf& pointsOf);

/// Keeps the measurements of a view as the document, the organs' motion and the tool have them.
class MeasureScene final : public QObject {
  Q_OBJECT

public:
  /// All have to live longer.
  MeasureScene(Workspace& workspace, const MeasureTool& tool, scene::MeasurementGlyphs& glyphs,
               QObject* parent = nullptr);

  void setShown(bool shown);
  void setTheme(const scene::Theme& theme);

Q_SIGNALS:
  /// Something looks different: render when convenient.
  void changed();

private:
  void sync();
  bool highlighted(std::size_t index) const;

  Workspace& workspace_;
  const MeasureTool& tool_;
  scene::MeasurementGlyphs& glyphs_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
