#pragma once

#include <string>

#include <vtkNew.h>
#include <vtkPlot.h>
#include <vtkTextProperty.h>

#include "viscera/core/arrays.h"
#include "viscera/scene/color_map.h"

namespace viscera::scene {

/// A horizontal band across a chart: what is normal. (vtkPlotArea draws nothing for two points.)
class NormalBand : public vtkPlot {
public:
  static NormalBand* New();
  vtkTypeMacro(NormalBand, vtkPlot)

      /// Where it is, in the units of the axes.
      void setExtent(ValueRange x, ValueRange y);
  /// Written at its left end, when it is high enough for it. `size` in points.
  void setLabel(const std::string& label, int size);
  void setLabelColor(const Vec3& color);
  bool Paint(vtkContext2D* painter) override;
  void GetBounds(double bounds[4]) override;

private:
  ValueRange x_;
  ValueRange y_;
  std::string label_;
  vtkNew<vtkTextProperty> text_;
};

} // namespace viscera::scene
