#pragma once

#include <vtkPlot.h>

#include "viscera/scene/color_map.h"

namespace viscera::scene {

/// A horizontal band across a chart: what is normal. (vtkPlotArea draws nothing for two points.)
class NormalBand : public vtkPlot {
public:
  static NormalBand* New();
  vtkTypeMacro(NormalBand, vtkPlot)

      /// Where it is, in the units of the axes.
      void setExtent(ValueRange x, ValueRange y);
  bool Paint(vtkContext2D* painter) override;
  void GetBounds(double bounds[4]) override;

private:
  ValueRange x_;
  ValueRange y_;
};

} // namespace viscera::scene
