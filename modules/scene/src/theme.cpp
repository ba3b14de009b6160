#include "viscera/scene/theme.h"

namespace viscera::scene {
namespace {

Vec3 fromHex(unsigned rgb) {
  return Vec3(double(rgb >> 16 & 255), double(rgb >> 8 & 255), double(rgb & 255)) / 255.0;
}

} // namespace

Theme darkTheme() {
  return {.backgroundTop = fromHex(0x39434b),
          .backgroundBottom = fromHex(0x171b1f),
          .panel = fromHex(0x262c31),
          .text = fromHex(0xe6e8ea),
          .muted = fromHex(0x8b98a3),
          .accent = fromHex(0x4fb3bf),
          .rim = fromHex(0xffffff),
          .dark = true};
}

Theme lightTheme() {
  return {.backgroundTop = fromHex(0xfbfcfd),
          .backgroundBottom = fromHex(0xccd6de),
          .panel = fromHex(0xffffff),
          .text = fromHex(0x22272b),
          .muted = fromHex(0x6b7781),
          .accent = fromHex(0x00798c),
          .rim = fromHex(0x005a69),
          .dark = false};
}

Theme lectureTheme(bool dark) {
  Theme theme = dark ? darkTheme() : lightTheme();
  theme.backgroundTop = theme.backgroundBottom = theme.panel = dark ? Vec3::Zero() : Vec3::Ones();
  theme.text = dark ? Vec3::Ones() : Vec3::Zero();
  theme.muted = fromHex(dark ? 0xc4ccd2 : 0x3c454c);
  theme.accent = fromHex(dark ? 0x7be3ef : 0x005a69);
  theme.typeScale = kLectureTypeScale;
  return theme;
}

} // namespace viscera::scene
