#pragma once

#include <map>
#include <string>
#include <vector>

#include <vtkChartXY.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkVector.h>

#include "viscera/scene/color_map.h"
#include "viscera/scene/theme.h"

namespace viscera::scene {

/// A chart that writes each curve's name beside its right end, in the curve's colour, instead of a legend,
/// and captions where no curve passes.
class LabelledChart : public vtkChartXY {
public:
  static LabelledChart* New();
  vtkTypeMacro(LabelledChart, vtkChartXY)

      /// A curve as it is drawn: its two columns are x and y.
      struct Line {
    std::string name;
    Vec3 color = Vec3::Zero();
    bool dashed = false;
    bool dots = false;
    bool rightAxis = false;
    vtkSmartPointer<vtkTable> table;
  };
  /// What is written between two values of an axis.
  struct Caption {
    std::string text;
    ValueRange range;
    bool rightAxis = false;
  };

  /// Sets the curves for the following frames; a line with fewer than two numbers gets no name.
  void setLines(std::vector<Line> lines) { lines_ = std::move(lines); }
  void setCaptions(std::vector<Caption> captions) { captions_ = std::move(captions); }
  /// `fontSize` in points; `ratio` device pixels in a logical one.
  void setLook(const Theme& theme, int fontSize, double ratio);

  /// A curve's colour, so that letters of it can be read on a panel.
  static Vec3 letters(const Vec3& color, const Theme& theme);

  bool Paint(vtkContext2D* painter) override;

protected:
  int GetLegendBorder(vtkContext2D* painter, int axisPosition) override;

private:
  /// A box in pixels of the window.
  struct Box {
    double left = 0, bottom = 0, right = 0, top = 0;
    bool overlaps(const Box& other) const;
  };
  struct Label {
    const Line* line = nullptr;
    double end = 0;   ///< Height of the curve's last point, pixels.
    double place = 0; ///< Of the label's middle.
  };
  using Curve = std::vector<vtkVector2d>;

  double pixelOf(double value, int axis);
  Curve inPixels(const Line& line);
  vtkVector2d sizeOf(vtkContext2D* painter, const std::string& text) const;
  std::string cut(vtkContext2D* painter, const std::string& text, double most) const;
  double mostText();
  void spread(std::vector<Label>& labels, double height) const;
  void drawLabels(vtkContext2D* painter);
  void drawSample(vtkContext2D* painter, const Label& label, double left);
  void drawCaptions(vtkContext2D* painter);
  bool place(const Caption& caption, const vtkVector2d& size, const std::vector<Box>& taken, Box& box);

  std::vector<Line> lines_;
  std::vector<Caption> captions_;
  std::vector<Curve> curves_;      ///< Of the lines, in this frame.
  std::map<std::string, Box> was_; ///< Last places of captions, which are kept as long as possible.
  Theme theme_ = lightTheme();
  double ratio_ = 1;
  vtkNew<vtkTextProperty> text_;
};

} // namespace viscera::scene
