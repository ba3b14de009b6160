#include "cli/stage_options.h"

#include <CLI/CLI.hpp>

namespace viscera::app::cli {

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

presentation::Stage stageFor(const StageOptions& options, Threads threads) {
  return {options.size.width, options.size.height,
          options.theme == "light" ? scene::lightTheme() : scene::darkTheme(), threads};
}

} // namespace viscera::app::cli
