#include "svg_canvas.h"

#include "viscera/core/text.h"

namespace viscera::thesis {
namespace {

/// Part of a letter's height; the mean of common sans-serif faces, a little generous.
constexpr double kLetterWidth = 0.56;

std::string number(double value) {
  return fixed(value, 2);
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + escaped(value) + "\"";
}

std::string attribute(const char* name, double value) {
  return attribute(name, number(value));
}

std::string strokeOf(const Pen& pen) {
  return attribute("stroke", pen.color) + attribute("stroke-width", pen.width) +
         (pen.dashes.empty() ? "" : attribute("stroke-dasharray", pen.dashes)) +
         (pen.opacity < 1 ? attribute("stroke-opacity", pen.opacity) : "");
}

} // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text)
    switch (letter) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += letter;
    }
  return result;
}

double widthOf(const std::string& text, double size) {
  double letters = 0;
  for (const char letter : text)
    letters +=
        (static_cast<unsigned char>(letter) & 0xC0) != 0x80 ? 1 : 0; // Not a UTF-8 letter's later byte.
  return letters * size * kLetterWidth;
}

SvgCanvas::SvgCanvas(double width, double height) : width_(width), height_(height) {}

void SvgCanvas::line(Place from, Place to, const Pen& pen) {
  body_ += "<line" + attribute("x1", from.x) + attribute("y1", from.y) + attribute("x2", to.x) +
           attribute("y2", to.y) + strokeOf(pen) + "/>\n";
}

void SvgCanvas::polyline(const std::vector<Place>& places, const Pen& pen) {
  if (places.size() < 2)
    return;
  std::string points;
  for (const Place& place : places)
    points += (points.empty() ? "" : " ") + number(place.x) + "," + number(place.y);
  body_ += "<polyline fill=\"none\" stroke-linejoin=\"round\"" + strokeOf(pen) + attribute("points", points) +
           "/>\n";
}

void SvgCanvas::rectangle(Place corner, double width, double height, const std::string& fill,
                          double opacity) {
  body_ += "<rect" + attribute("x", corner.x) + attribute("y", corner.y) + attribute("width", width) +
           attribute("height", height) + attribute("fill", fill) +
           (opacity < 1 ? attribute("fill-opacity", opacity) : "") + "/>\n";
}

void SvgCanvas::circle(Place center, double radius, const std::string& fill, const std::string& stroke) {
  body_ += "<circle" + attribute("cx", center.x) + attribute("cy", center.y) + attribute("r", radius) +
           attribute("fill", fill) + (stroke.empty() ? "" : attribute("stroke", stroke)) + "/>\n";
}

void SvgCanvas::text(Place place, const std::string& text, double size, Anchor anchor,
                     const std::string& color, double turnDegrees) {
  const char* anchors[] = {"start", "middle", "end"};
  body_ += "<text" + attribute("x", place.x) + attribute("y", place.y) + attribute("font-size", size) +
           attribute("fill", color) +
           attribute("text-anchor", std::string(anchors[static_cast<int>(anchor)]));
  if (turnDegrees != 0)
    body_ += attribute("transform",
                       "rotate(" + number(turnDegrees) + " " + number(place.x) + " " + number(place.y) + ")");
  body_ += ">" + escaped(text) + "</text>\n";
}

std::string SvgCanvas::svg(const std::string& title) const {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 " + number(width_) + " " +
         number(height_) + "\"" + attribute("width", width_) + attribute("height", height_) +
         " font-family=\"'DejaVu Sans', 'Helvetica Neue', Arial, sans-serif\">\n<title>" + escaped(title) +
         "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" + body_ + "</svg>\n";
}

} // namespace viscera::thesis
