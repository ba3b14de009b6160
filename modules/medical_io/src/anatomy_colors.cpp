#include "anatomy_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "file_bytes.h"

namespace viscera::medical_io {
namespace {

struct Anatomy {
  std::string_view word; ///< That a name contains.
  std::array<int, 3> color;
};

/// The first that fits counts, so vessels of an organ come before the organ.
constexpr std::array<Anatomy, 34> kAnatomy = {
    {{"artery", {216, 101, 79}},     {"aorta", {224, 97, 76}},        {"vein", {0, 151, 206}},
     {"vena_cava", {0, 151, 206}},   {"tumo", {144, 238, 144}},       {"lesion", {144, 238, 144}},
     {"cyst", {205, 205, 100}},      {"liver", {221, 130, 101}},      {"spleen", {157, 108, 162}},
     {"kidney", {185, 102, 83}},     {"heart", {206, 110, 84}},       {"atrium", {206, 110, 84}},
     {"ventricle", {206, 110, 84}},  {"myocard", {186, 77, 64}},      {"stomach", {216, 132, 105}},
     {"pancreas", {249, 180, 111}},  {"gallbladder", {139, 150, 98}}, {"bladder", {222, 154, 132}},
     {"duodenum", {255, 253, 229}},  {"bowel", {205, 167, 142}},      {"colon", {204, 168, 143}},
     {"esophagus", {211, 171, 143}}, {"adrenal", {244, 186, 150}},    {"lung", {197, 165, 145}},
     {"trachea", {182, 228, 255}},   {"brain", {250, 250, 225}},      {"thyroid", {62, 162, 114}},
     {"prostate", {230, 158, 140}},  {"muscle", {192, 104, 88}},      {"gluteus", {192, 104, 88}},
     {"rib", {241, 214, 145}},       {"vertebra", {241, 214, 145}},   {"bone", {241, 214, 145}},
     {"skin", {177, 122, 101}}}};

/// Turning by the golden angle keeps the hues of any number of labels apart.
constexpr double kGoldenTurn = 0.61803398874989485;
constexpr double kSaturation = 0.45, kBrightness = 0.85;

Vec3 colorOfHue(double turn) {
  Vec3 color;
  for (int i = 0; i < 3; ++i) {
    const double away = std::abs(std::fmod(6 * turn + 2.0 * i, 6.0) - 3) - 1;
    color[i] = kBrightness * (1 - kSaturation * (1 - std::clamp(away, 0.0, 1.0)));
  }
  return color;
}

} // namespace

Vec3 anatomyColor(std::string_view name, std::int64_t label) {
  std::string text = lowered(name);
  std::replace(text.begin(), text.end(), ' ', '_');
  for (const Anatomy& anatomy : kAnatomy)
    if (text.find(anatomy.word) != text.npos)
      return Vec3(anatomy.color[0], anatomy.color[1], anatomy.color[2]) / 255;
  const double turns = static_cast<double>(label) * kGoldenTurn;
  return colorOfHue(turns - std::floor(turns));
}

} // namespace viscera::medical_io
