#pragma once

#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

/// Makes completion scripts for bash and zsh.
namespace viscera::app::cli {

/// The words that a shell offers as completions, by the type of an option's value: {"ID", {"s-celestial",
/// ...}}.
using ValueWords = std::map<std::string, std::vector<std::string>>;

/// The options of `app`, without its positionals, or the positionals alone, in the order of `--help`. Options
/// that `--help` hides are left out.
std::vector<const CLI::Option*> shownOptions(const CLI::App& app, bool positionals);

/// The subcommands of `program` in the order of `--help`.
std::vector<const CLI::App*> commandsOf(const CLI::App& program);

/// A completion script of bash for the program and its subcommands, from the options that `--help` prints. A
/// value is completed by the words that its option allows ("{dark,light}"), by `words` of its type, and by
/// names of files.
std::string bashCompletion(const CLI::App& program, const ValueWords& words);

/// The same for zsh, with the descriptions beside commands and options.
std::string zshCompletion(const CLI::App& program, const ValueWords& words);

} // namespace viscera::app::cli
