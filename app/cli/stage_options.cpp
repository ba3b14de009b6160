#include "cli/stage_options.h"

#include <charconv>
#include <system_error>

#include <CLI/CLI.hpp>

#include "viscera/core/error.h"

namespace viscera::app::cli {
namespace {
constexpr int kSmallest = 16;
constexpr int kLargest = 16384; ///< The largest size that all OpenGL drivers can draw.
} // namespace

PictureSize pictureSize(const std::string& text) {
  PictureSize size;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  const bool cross = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = cross ? std::from_chars(width.ptr + 1, end, size.height) : width;
  if (!cross || height.ec != std::errc() || height.ptr != end)
    throw UsageError("It is not a size in pixels", text, "for instance 1600x1000");
  for (int side : {size.width, size.height})
    if (side < kSmallest || side > kLargest)
      throw UsageError("It is out of range", text,
                       "each side from " + std::to_string(kSmallest) + " to " + std::to_string(kLargest));
  return size;
}

void addStageOptions(CLI::App& options, StageOptions& stage, std::string& size) {
  options.add_option("--size", size, "Size of the picture in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  options
      .add_option("--view", stage.view, "From where: anterior, posterior, left, right, superior, inferior")
      ->type_name("NAME")
      ->capture_default_str();
  options.add_option("--theme", stage.theme, "Colours around the organs")
      ->check(CLI::IsMember({"dark", "light"}))
      ->capture_default_str();
}

scene::Theme themeOf(const StageOptions& options) {
  return options.theme == "light" ? scene::lightTheme() : scene::darkTheme();
}

presentation::Stage stageFor(const StageOptions& options, Threads threads) {
  return {options.size.width, options.size.height, themeOf(options), threads};
}

} // namespace viscera::app::cli
