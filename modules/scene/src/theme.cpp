#include "viscera/scene/theme.h"

namespace viscera::scene {
namespace {

Vec3 fromHex(unsigned rgb) {
  return Vec3(double(rgb >> 16 & 255), double(rgb >> 8 & 255), double(rgb & 255)) / 255.0;
}

} // namespace

Theme darkTheme() {
  Theme theme;
  theme.backgroundTop = fromHex(0x39434b);
  theme.backgroundBottom = fromHex(0x171b1f);
  theme.panel = fromHex(0x262c31);
  theme.text = fromHex(0xe6e8ea);
  theme.muted = fromHex(0x8b98a3);
  theme.accent = fromHex(0x4fb3bf);
  theme.rim = fromHex(0xffffff);
  theme.dark = true;
  return theme;
}

Theme lightTheme() {
  Theme theme;
  theme.backgroundTop = fromHex(0xfbfcfd);
  theme.backgroundBottom = fromHex(0xccd6de);
  theme.panel = fromHex(0xffffff);
  theme.text = fromHex(0x22272b);
  theme.muted = fromHex(0x6b7781);
  theme.accent = fromHex(0x00798c);
  theme.rim = fromHex(0x005a69);
  theme.dark = false;
  return theme;
}

} // namespace viscera::scene
