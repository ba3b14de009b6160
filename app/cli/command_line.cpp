#include "cli/command_line.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

#include <CLI/CLI.hpp>

#include "available_systems.h"
#include "cli/command.h"
#include "cli/command_files.h"
#include "cli/commands/all_commands.h"
#include "cli/failure.h"
#include "cli/interrupt.h"
#include "cli/manual.h"
#include "cli/misspelt.h"
#include "cli/number_bounds.h"
#include "cli/shell_completion.h"
#include "cli/stage_options.h"
#include "cli/version_text.h"
#include "viscera/core/error.h"
#include "viscera/core/text.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::app::cli {
namespace {

constexpr int kUsage = 64;
constexpr int kMostThreads = 1024;

/// A progress bar in one line of the terminal, which is redrawn; draws nothing if the stream is not a
/// terminal. For one thread at a time, as `Progress` calls its listener.
class ProgressBar {
  static constexpr int kWidth = 30;
  static constexpr auto kClearLine = "\r\x1b[K";

public:
  /// Draws on `stream` if that is a `terminal`.
  ProgressBar(std::ostream& stream, bool terminal) : stream_(stream), terminal_(terminal) {}
  /// Removes the line.
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `fraction` in [0, 1] of `step`.
  void show(double fraction, const Text& step) {
    if (!terminal_)
      return;
    const int full = static_cast<int>(std::lround(fraction * kWidth));
    stream_ << kClearLine << '[' << std::string(full, '#') << std::string(kWidth - full, '.') << "] "
            << static_cast<int>(std::floor(fraction * 100)) << " % " << step << std::flush;
    shown_ = true;
  }

  /// Removes the line, so that something else can be printed.
  void clear() {
    if (shown_)
      stream_ << kClearLine << std::flush;
    shown_ = false;
  }

private:
  std::ostream& stream_;
  bool terminal_;
  bool shown_ = false;
};

/// The options of every subcommand.
struct CommonOptions {
  bool json = false;
  bool force = false;
  int threads = 0;
  std::vector<std::string> pluginPath;

  void addTo(CLI::App& options) {
    options.add_flag("--json", json, "Print one JSON object instead of text, also of an error");
    options.add_flag("--force", force, "Let an output overwrite an input");
    options.add_option("--threads", threads, "Threads to use; 0: all of the machine")
        ->type_name("N")
        ->check(wholeBetween(0, kMostThreads));
    options.add_option("--plugin-path", pluginPath, "Folder or file with plugins; may be repeated")
        ->type_name("PATH")
        ->expected(1)
        ->take_all();
  }
};

/// Adds the options of the window.
void addWindowOptions(CLI::App& app, WindowOptions& window, std::string& size) {
  app.add_option("FILE", window.files,
                 "Sessions, organs, label maps and handles to open in the window, or one sample:NAME");
  app.add_option("--theme", window.theme, "Colours of the window")->check(CLI::IsMember({"dark", "light"}));
  app.add_option("--language", window.language, "Language of the window")
      ->check(CLI::IsMember({"en", "ca", "de", "es", "fr"}));
  app.add_option("--mode", window.mode, "Mode in which the window starts")
      ->check(CLI::IsMember({"explore", "handles", "deform", "stress", "play"}));
  app.add_option("--window-size", size, "Size of the window in pixels")->type_name("WxH");
  app.add_option("--screenshot", window.screenshot, "Save a picture of the window as PNG and end")
      ->type_name("FILE");
  app.add_option("--plugin-path", window.pluginPath, "Folder or file with plugins; may be repeated")
      ->type_name("PATH")
      ->expected(1)
      ->take_all();
  app.add_flag("--fresh-settings", window.freshSettings, "Neither read nor write the user's settings");
}

/// Calls `work` and turns whatever it throws into a line and an exit code, with `json` into an object, too.
/// `told` puts the names that the user gave into the texts.
int guarded(std::ostream& out, std::ostream& err, bool json, const std::function<int()>& work,
            const std::function<std::string(std::string)>& told = nullptr) {
  try {
    return work();
  } catch (const std::exception& error) {
    return printFailure(failureOf(error, told), json, out, err);
  } catch (...) {
    return printFailure({"internal error of unknown kind", {}, {}, "internal error of unknown kind"}, json,
                        out, err);
  }
}

/// Prints the result: an output that goes to standard output leaves no room there for the text.
void print(std::ostream& out, std::ostream& err, const Outcome& outcome, const CommandFiles& files,
           bool json) {
  if (files.streamsOutput()) {
    files.sendOutput(out);
    err << files.told(withoutControls(outcome.text)); // Names in it come from files.
    return;
  }
  const std::string text =
      json ? outcome.json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n'
           : withoutControls(outcome.text);
  out << files.told(text) << std::flush;
  if (!out)
    throw CannotCreateError("It cannot be written", "standard output");
}

void warn(std::ostream& err, const std::vector<Text>& warnings, const CommandFiles* files = nullptr) {
  for (const Text& warning : warnings) {
    const std::string line = oneLine(warning.english());
    err << "viscera: warning: " << (files ? files->told(line) : line) << '\n';
  }
}

int runCommand(Command& command, CLI::App& options, const CommonOptions& common, std::ostream& out,
               std::ostream& err) {
  std::optional<CommandFiles> files;
  const auto told = [&files](std::string text) { return files ? files->told(std::move(text)) : text; };
  const auto work = [&] {
    ProgressBar bar(err, ::isatty(STDERR_FILENO) == 1); // Removed before an error is printed.
    Progress progress([&](double fraction, const Text& step) { bar.show(fraction, step); });
    const Interrupt interrupt(progress);
    files.emplace(options, command.outputs(), FileRules{common.json, common.force}, progress);
    const sample_organs::SampleLibrary samples = sample_organs::standardLibrary();
    const AvailableSystems systems = availableSystems(common.pluginPath);
    warn(err, systems.problems);
    CommandContext context{progress, Threads{common.threads}, samples, systems.registry};
    const Outcome outcome = command.run(context);
    bar.clear();
    warn(err, outcome.warnings, &*files);
    print(out, err, outcome, *files, common.json);
    return 0;
  };
  return guarded(out, err, common.json, work, told);
}

void readSize(const std::string& text, WindowOptions& window) {
  if (text.empty())
    return;
  const PictureSize size = pictureSize(text);
  window.width = size.width;
  window.height = size.height;
}

/// `viscera sample:stomach` shows that sample organ instead of the heart.
void takeSample(WindowOptions& window, const sample_organs::SampleLibrary& samples) {
  static const std::string kSample = "sample:";
  for (const std::string& file : window.files) {
    if (file.rfind(kSample, 0) != 0)
      continue;
    if (window.files.size() > 1)
      throw UsageError("A sample organ cannot be opened together with other files", file,
                       "open the files in the window with File > Open");
    window.sample = file.substr(kSample.size());
    const std::vector<std::string> names = sample_organs::sampleNames(samples);
    if (std::find(names.begin(), names.end(), window.sample) == names.end())
      throw UsageError("It is not a sample organ that the window opens", file,
                       "viscera sample --list shows them");
    window.files.clear();
    return;
  }
}

/// Lists missing files on the terminal; the window lists them too, and can open others. If no file exists,
/// throws for a word that looks like a mistyped command, and if a picture of the window was to show a file.
void requireFiles(const WindowOptions& window, std::ostream& err) {
  const auto isThere = [](const std::string& file) {
    std::error_code unreachable;
    return std::filesystem::exists(file, unreachable);
  };
  const bool some = std::any_of(window.files.begin(), window.files.end(), isThere);
  for (const std::string& file : window.files) {
    if (isThere(file))
      continue;
    if (!some && !std::filesystem::path(file).has_extension() && file.find('/') == std::string::npos)
      throw UsageError("It is neither a command nor a file", file, "viscera --help lists the commands");
    const NoInputError missing("there is no such file", file, "check the path");
    if (!some && !window.screenshot.empty())
      throw missing;
    err << "viscera: " << oneLine(missing.what()) << std::endl;
  }
}

/// The formats that are read, for the end of the help.
std::string formatsText() {
  using medical_io::FileKind;
  std::string text = "Files that are read (* and written):\n";
  for (const auto& [kind, title] : {std::pair(FileKind::surface, "Organs"),
                                    {FileKind::labelMap, "Label maps and scans"},
                                    {FileKind::handles, "Handles"},
                                    {FileKind::sequence, "Sequences"},
                                    {FileKind::session, "Sessions"}}) {
    text += std::string(title) + ":";
    for (const medical_io::FileFormat& format : medical_io::fileFormats()) {
      if (format.kind != kind)
        continue;
      text += ' ' + format.name + (format.written ? "*" : "") + " (";
      for (const std::string& ending : format.endings)
        text += (&ending == &format.endings.front() ? "" : " ") + ending;
      text += ')';
    }
    text += '\n';
  }
  return text;
}

/// What shells offer for the values of options, beside files.
ValueWords valueWords() {
  ValueWords words{{"SEQUENCE", {"heartbeat", "peristalsis", "breathing"}}};
  for (const std::string& name : sample_organs::sampleNames(sample_organs::standardLibrary()))
    words["ORGAN"].push_back("sample:" + name);
  const coordinates::Registry systems = coordinates::builtInRegistry();
  for (const auto& entry : systems.list())
    words["ID"].push_back(entry.system->id());
  return words;
}

/// The subcommand that was chosen, or the program itself.
const CLI::App& chosenOf(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : *chosen.front();
}

/// The option that was probably meant by the first one that there is not: "--handles"; empty for none.
std::string meantOption(const CLI::App& app, int argc, const char* const* argv) {
  std::vector<std::string> names;
  for (const CLI::Option* option : chosenOf(app).get_options())
    for (const std::string& name : option->get_lnames())
      names.push_back("--" + name);
  for (int i = 1; i < argc; ++i) {
    const std::string word = std::string(argv[i]).substr(0, std::string_view(argv[i]).find('='));
    if (word.starts_with("--") && word.size() > 2 &&
        std::find(names.begin(), names.end(), word) == names.end())
      return meantBy(word, names);
  }
  return {};
}

/// What is wrong with the options, as CLI11 says it, with what to try.
Failure usageFailure(const CLI::ParseError& error, const CLI::App& app, int argc, const char* const* argv) {
  const bool isProgram = &chosenOf(app) == &app;
  const std::string name = isProgram ? "viscera" : "viscera " + chosenOf(app).get_name();
  const std::string meant =
      dynamic_cast<const CLI::ExtrasError*>(&error) ? meantOption(app, argc, argv) : std::string();
  const std::string advice =
      (meant.empty() ? "" : "did you mean '" + meant + "'? ") + "try '" + name + " --help'";
  return {error.what(), name, advice, error.what() + (" (" + advice + ")"), kUsage};
}

/// Whether the first word is meant for a command and is none.
std::optional<UnknownCommand> unknownCommand(const CLI::App& app, int argc, const char* const* argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  std::vector<std::string> names;
  for (const CLI::App* command : commandsOf(app))
    names.push_back(command->get_name());
  std::error_code unreachable;
  if (word.empty() || word.front() == '-' || word.find_first_of("/.:") != std::string::npos ||
      std::find(names.begin(), names.end(), word) != names.end() ||
      std::filesystem::exists(word, unreachable))
    return std::nullopt;
  return UnknownCommand{word, meantBy(word, names)};
}

/// Whether to create the options of this command: only for those that may be on the command line, since there
/// are some two hundred options in all.
bool optionsAreNeeded(const Command& command, int argc, const char* const* argv) {
  return std::any_of(argv + std::min(argc, 1), argv + argc, [&command](std::string_view word) {
    return word == command.name() || word.starts_with("--write-manual");
  });
}

} // namespace

int runCommandLine(int argc, const char* const* argv, std::ostream& out, std::ostream& err,
                   const OpenWindow& openWindow) {
  CLI::App app("Organs deformed by handles, without a cage. Without a command the window opens.", "viscera");
  app.set_version_flag("--version", versionText);
  app.require_subcommand(0, 1);
  app.footer(formatsText);
  WindowOptions window;
  std::string windowSize;
  addWindowOptions(app, window, windowSize);
  std::string manual; // For packaging, therefore hidden from --help.
  app.add_option("--write-manual", manual)->group("");
  CommonOptions common;
  std::vector<std::unique_ptr<Command>> commands;
  Command* chosen = nullptr;
  for (const auto make :
       {infoCommand,      systemsCommand, sampleCommand,   convertCommand,    handlesCommand,
        bindCommand,      deformCommand,  stressCommand,   elasticityCommand, playCommand,
        circulateCommand, trackCommand,   strainCommand,   lessonCommand,     segmentCommand,
        probeCommand,     warpCommand,    measureCommand,  phantomCommand,    renderCommand,
        reportCommand,    dicomCommand,   commandsCommand, propertiesCommand, reproduceCommand,
        referenceCommand, archiveCommand}) {
    const auto& command = commands.emplace_back(make());
    CLI::App* options = app.add_subcommand(command->name(), command->summary());
    if (optionsAreNeeded(*command, argc, argv)) {
      command->addOptions(*options);
      common.addTo(*options);
    }
    options->callback([&chosen, it = command.get()] { chosen = it; });
  }
  const bool json = std::any_of(argv + std::min(argc, 1), argv + argc,
                                [](std::string_view word) { return word == "--json"; });
  if (const auto unknown = unknownCommand(app, argc, argv))
    return printFailure({unknown->problem(), unknown->word, unknown->advice(), unknown->line(), kUsage}, json,
                        out, err);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    out << app.help() << std::flush;
    return 0;
  } catch (const CLI::CallForVersion& version) {
    out << version.what() << std::endl;
    return 0;
  } catch (const CLI::ParseError& error) {
    return printFailure(usageFailure(error, app, argc, argv), json, out, err);
  }
  if (chosen)
    return runCommand(*chosen, *app.get_subcommands().front(), common, out, err);
  return guarded(out, err, false, [&] {
    if (!manual.empty()) {
      writeManual(app, valueWords(), manual);
      return 0;
    }
    readSize(windowSize, window);
    if (!window.screenshot.empty())
      requireEnding(pictureOutput("--screenshot"), window.screenshot);
    takeSample(window, sample_organs::standardLibrary());
    requireFiles(window, err);
    return openWindow(window);
  });
}

} // namespace viscera::app::cli
