#include "heart_labels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace viscera::motion {
namespace {

/// A chamber and the words that its label has.
struct Chamber {
  const char* name;
  std::string_view kind, side;
};
constexpr std::array<Chamber, 4> kChambers = {{{"LV", "ventricle", "left"},
                                               {"RV", "ventricle", "right"},
                                               {"LA", "atrium", "left"},
                                               {"RA", "atrium", "right"}}};

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool has(const std::string& text, std::string_view word) {
  return text.find(word) != std::string::npos;
}

/// Whether the label is of the heart's muscle. Walls are named after the chamber that they are around.
bool isMuscle(const std::string& name) {
  return has(name, "myocard") || has(name, "muscle");
}

} // namespace

std::vector<LabelledSurface> heartSurfaces(const medical_io::LabelMap& map) {
  LabelledSurface heart{"heart", {}};
  std::vector<LabelledSurface> cavities;
  bool muscle = false, ventricle = false;
  for (const medical_io::Segment& segment : map.segments)
    if (segment.named && isMuscle(lowered(segment.name))) {
      heart.labels.push_back(segment.name);
      muscle = true;
    }
  for (const Chamber& chamber : kChambers) {
    LabelledSurface cavity{chamber.name, {}};
    for (const medical_io::Segment& segment : map.segments)
      if (const std::string name = lowered(segment.name);
          segment.named && !isMuscle(name) && has(name, chamber.kind) && has(name, chamber.side))
        cavity.labels.push_back(segment.name);
    if (cavity.labels.size() > 1)
      return {};
    if (cavity.labels.empty())
      continue;
    ventricle = ventricle || chamber.kind == "ventricle";
    heart.labels.push_back(cavity.labels.front());
    cavities.push_back(std::move(cavity));
  }
  if (!muscle || !ventricle)
    return {};
  cavities.insert(cavities.begin(), std::move(heart));
  return cavities;
}

} // namespace viscera::motion
