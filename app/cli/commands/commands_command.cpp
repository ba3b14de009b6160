#include "cli/commands/all_commands.h"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "viscera/core/error.h"
#include "viscera/document/session_file.h"
#include "viscera/report/session_script.h"

namespace viscera::app::cli {
namespace {

/// `viscera commands SESSION`: prints the session as a script of commands.
class CommandsCommand final : public Command {
public:
  std::string name() const override { return "commands"; }
  std::string summary() const override {
    return "Print a session as a script of viscera commands that gives the same result";
  }

  void addOptions(CLI::App& options) override {
    options.add_option("SESSION", file_, "A session (.viscera)")->required();
  }

  Outcome run(CommandContext& context) override {
    if (!document::isSessionFile(file_))
      throw UsageError("It is not a session", file_,
                       "name a .viscera file; the window saves one by File > Save");
    const document::OpenedSession opened = document::readSession(file_, context.samples, context.progress);
    const report::SessionScript script = report::sessionScript(
        {opened.contents.state,
         presentation::viewFromJson(opened.contents.view, *opened.contents.state.circulation), file_});
    Outcome outcome;
    outcome.json = {{"session", file_}, {"script", script.text}, {"commands", script.commands}};
    outcome.text = script.text;
    outcome.warnings = opened.warnings;
    return outcome;
  }

private:
  std::string file_;
};

} // namespace

std::unique_ptr<Command> commandsCommand() {
  return std::make_unique<CommandsCommand>();
}

} // namespace viscera::app::cli
