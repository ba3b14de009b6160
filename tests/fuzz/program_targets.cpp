#include <sstream>

#include "cli/command_line.h"
#include "fuzz_target.h"
#include "viscera/plugin/plugin_loader.h"

/// The command line, up to where a command would begin its work, and files given as plugins.
namespace viscera::fuzz {
namespace {

/// Arguments are split at line breaks. `--help` comes last, so that what is asked for is parsed and checked,
/// but not done. One option would take it for the folder into which it writes, and has no turn; behind "--"
/// it would be a file.
void parseArguments(Bytes bytes) {
  std::vector<std::string> words = {"viscera"};
  std::istringstream lines(textOf(bytes));
  for (std::string line; std::getline(lines, line) && words.size() < 64;) {
    line.erase(std::find(line.begin(), line.end(), '\0'), line.end());
    if (line.starts_with("--write-manual"))
      return;
    if (line == "--")
      continue;
    words.push_back(line);
  }
  words.insert(words.end(), 3, "--help"); // An option before takes one or two for its values.
  std::vector<const char*> arguments;
  for (const std::string& word : words)
    arguments.push_back(word.c_str());
  std::ostringstream out, err;
  const int code = app::cli::runCommandLine(static_cast<int>(arguments.size()), arguments.data(), out, err,
                                            [](const app::WindowOptions&) { return 0; });
  require(code >= 0 && code < 256, "An exit code is a byte.");
  require(code == 0 || !err.str().empty(), "What is refused is refused with a reason.");
}

std::vector<std::string> argumentSeeds() {
  return {"info\nliver.vtk\n--json",
          "play\nheartbeat\n--rate\n90\n--csv\n-",
          "render\nliver.vtk\n--slice\naxial:120\n--size\n800x600",
          "deform\nliver.vtk\n--move\n3=1,2,3\n--lock\n--system\ns-celestial",
          "--window-size\n1600x1000\n--mode\nplay",
          "circulate\n--scenario\nrest\n--param\nrate=75"};
}

void loadAnyPlugin(Bytes bytes) {
  coordinates::Registry registry;
  const auto file = scratchFile("a.so", bytes);
  const std::vector<plugin::PluginReport> reports = plugin::loadPlugins({file}, registry);
  require(reports.size() == 1, "A file that is named is reported.");
  require(!reports[0].problem.empty(), "What is not a plugin has a problem.");
}

std::vector<std::string> pluginSeeds() {
  // The manifest alone: a whole library would be run, and be found to be one.
  return {"\177ELF\2\1\1", std::string("QTMETADATA !") + '\0' + "\x05\x0f\0" + R"({"id": "a", "name": "A"})"};
}

} // namespace

std::vector<Target> programTargets() {
  return {{"command_lines", parseArguments, argumentSeeds}, {"plugins", loadAnyPlugin, pluginSeeds}};
}

} // namespace viscera::fuzz
