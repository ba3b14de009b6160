#pragma once

#include <memory>
#include <vector>

#include "viscera/core/arrays.h"

class vtkRenderer;

namespace viscera::scene {

/// Small balls at places that somebody has chosen on an organ. They keep their size on the screen and are
/// seen through organs. Belongs to the thread that renders.
class LandmarkGlyphs {
public:
  struct Mark {
    Vec3 position = Vec3::Zero(); ///< mm
    Vec3 color = Vec3::Ones();    ///< Red green blue, 0 to 1.
  };

  LandmarkGlyphs();
  ~LandmarkGlyphs();
  LandmarkGlyphs(const LandmarkGlyphs&) = delete;
  LandmarkGlyphs& operator=(const LandmarkGlyphs&) = delete;

  /// Draws in `renderer` from now on. Null: nowhere.
  void setRenderer(vtkRenderer* renderer);
  void setMarks(std::vector<Mark> marks);
  const std::vector<Mark>& marks() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
