#include "cli_test.h"

#include <algorithm>

#include <unistd.h>

#include "build_paths.h"

namespace viscera::app::cli {

void CliTest::SetUp() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "." + info->name();
  std::replace(name.begin(), name.end(), '/', '.');
  folder_ =
      std::filesystem::temp_directory_path() / ("viscera cli " + name + " " + std::to_string(::getpid()));
  std::filesystem::create_directories(folder_);
  options_.environment = {{"DISPLAY", {}}, {"WAYLAND_DISPLAY", {}}, {"QT_QPA_PLATFORM", {}}};
  if (!std::getenv("XDG_CACHE_HOME"))
    options_.environment["XDG_CACHE_HOME"] = VISCERA_BINARY_DIR "/test_home/cache";
}

test::ProcessResult CliTest::run(std::vector<std::string> arguments) const {
  arguments.insert(arguments.begin(), VISCERA_PROGRAM);
  return test::runProcess(arguments, options_);
}

} // namespace viscera::app::cli
