#pragma once

#include <string>
#include <vector>

namespace viscera::thesis {

/// A place on a picture, in its units, y downward.
struct Place {
  double x = 0;
  double y = 0;
};

/// Colour, width, dashes and opacity of a line.
struct Pen {
  std::string color = "#222222";
  double width = 1;
  std::string dashes; ///< As SVG has them: "5 3"; empty: none.
  double opacity = 1;
};

enum class Anchor { start, middle, end };

/// A vector picture that is written as one self-contained SVG file. Numbers have a point and two digits
/// whatever the locale.
class SvgCanvas {
public:
  SvgCanvas(double width, double height);

  void line(Place from, Place to, const Pen& pen);
  void polyline(const std::vector<Place>& places, const Pen& pen);
  void rectangle(Place corner, double width, double height, const std::string& fill, double opacity = 1);
  void circle(Place center, double radius, const std::string& fill, const std::string& stroke = {});
  void text(Place place, const std::string& text, double size = 11, Anchor anchor = Anchor::start,
            const std::string& color = "#222222", double turnDegrees = 0);

  /// The whole file; `title` is the text for screen readers.
  std::string svg(const std::string& title) const;

  double width() const { return width_; }
  double height() const { return height_; }

private:
  double width_;
  double height_;
  std::string body_;
};

/// `text` with what HTML and SVG mean otherwise written as entities.
std::string escaped(const std::string& text);

/// About how wide the text is at that size, in the canvas's units.
double widthOf(const std::string& text, double size);

} // namespace viscera::thesis
