#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/scene/label_layout.h"
#include "viscera/scene/theme.h"

namespace viscera::scene {

class OrganView;

/// Draws distances and angles in a view: marks at their points, lines between them, an arc for an angle, and
/// a label each. Lines and marks keep their width on the screen; what an organ hides of them is seen through
/// it, fainter. Labels are in front of everything and do not lie over each other. Belongs to the thread that
/// renders; the view has to live longer.
class MeasurementGlyphs {
public:
  /// What is to be drawn: of one point only its mark, of two a line, of three an angle at the middle one;
  /// any number of a path.
  struct Item {
    std::vector<Vec3> points; ///< mm
    std::string text;         ///< UTF-8; none: no label.
    bool highlighted = false; ///< In the theme's accent.
    bool path = false;        ///< Only a line through all points: no marks, no arc, nothing for the mouse.
  };

  /// A label as it was drawn last, in device pixels from the lower left corner.
  struct Drawn {
    std::string text;
    ScreenBox box;
  };

  /// A point of an item.
  struct Mark {
    std::size_t item = 0;
    std::size_t point = 0;
    friend bool operator==(const Mark&, const Mark&) = default;
  };

  explicit MeasurementGlyphs(OrganView& view);
  ~MeasurementGlyphs();
  MeasurementGlyphs(const MeasurementGlyphs&) = delete;
  MeasurementGlyphs& operator=(const MeasurementGlyphs&) = delete;

  void setItems(std::vector<Item> items);
  const std::vector<Item>& items() const;
  void setTheme(const Theme& theme);
  void setShown(bool shown);
  bool shown() const;

  /// The mark nearest to a display position (device pixels from the lower left corner), when one is within
  /// reach of a mouse. Also one that an organ hides. None while not shown.
  std::optional<Mark> markAt(double x, double y) const;

  /// The labels in the frame that was drawn last.
  std::vector<Drawn> drawn() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
