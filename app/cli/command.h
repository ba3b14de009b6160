#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/output_option.h"
#include "viscera/coordinates/registry.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/sample_organs/sample_organ.h"

namespace CLI {
class App;
}

namespace viscera::app::cli {

/// The result of a command, as text for the terminal and as JSON for `--json`; the program prints one of
/// them.
struct Outcome {
  nlohmann::ordered_json json; ///< One object; its keys are those of docs/user_guide.md.
  std::string text;            ///< Lines for a reader, each with its line break.
  std::vector<Text> warnings;  ///< What to be careful about, a sentence each; they go to stderr.
};

/// Sample organs, coordinate systems, output and progress, which every command gets. Lives as long as the
/// command runs.
struct CommandContext {
  Progress& progress;                          ///< Cancelled by Ctrl+C.
  Threads threads;                             ///< The number of threads that the user has chosen.
  const sample_organs::SampleLibrary& samples; ///< Where `sample:heart` comes from.
  const coordinates::Registry& systems;        ///< The coordinate systems that `--system` names.
};

/// A subcommand of the program: `viscera <name>`.
class Command {
public:
  virtual ~Command() = default;

  virtual std::string name() const = 0;
  virtual std::string summary() const = 0; ///< One line for `viscera --help`.

  /// Adds its options and arguments, tied to its own members. Called once, before `run`.
  virtual void addOptions(CLI::App& options) = 0;

  /// The command's options and arguments for what it writes.
  virtual std::vector<OutputOption> outputs() const { return {}; }

  /// Runs the command. Throws `Error`; leaves no half-written file.
  virtual Outcome run(CommandContext& context) = 0;
};

} // namespace viscera::app::cli
