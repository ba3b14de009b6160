#include "cli/manual.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>
#include <utility>

#include <CLI/CLI.hpp>

#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"

namespace viscera::app::cli {
namespace {

constexpr std::pair<const char*, const char*> kExitCodes[] = {
    {"0", "The command did what was asked."},
    {"64", "The command line is wrong: an unknown option, a value that is not allowed."},
    {"65", "A file holds what cannot be used."},
    {"66", "A file is missing or cannot be read."},
    {"69", "Something that the command needs is not installed."},
    {"70", "An internal error. Please report it."},
    {"73", "A file cannot be written."},
    {"77", "An archive refuses the user name or the password."},
    {"130", "Ctrl+C ended the command. Nothing half-written is left."},
};

constexpr std::pair<const char*, const char*> kEnvironment[] = {
    {"VISCERA_ARCHIVE_PASSWORD", "The password of the archive that viscera archive speaks with."},
    {"VISCERA_PLUGIN_PATH", "Folders or files with plugins, separated by colons."},
    {"VISCERA_SAMPLE_ORGANS", "The folder with the definitions of the sample organs."},
    {"VISCERA_TETGEN_WORKER", "The program that fills organs with tetrahedra."},
    {"VISCERA_VECTOR_BITS",
     "The widest vectors that inner loops may use: 128, 256 or 512 bits; else the processor's widest."},
    {"XDG_CONFIG_HOME, XDG_STATE_HOME, XDG_CACHE_HOME",
     "Below them, in a folder viscera: settings and archives, recovery files, generated surfaces and fetched "
     "series."},
};

/// Text as roff prints it: a hyphen that can be copied, no line that begins with a request.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if (c == '\n')
      result += "\n.br\n";
    else
      result += c;
  }
  if (!result.empty() && (result.front() == '.' || result.front() == '\''))
    result.insert(0, "\\&");
  return result;
}

std::string bold(const std::string& text) {
  return "\\fB" + roff(text) + "\\fR";
}

std::string entry(const std::string& term, const std::string& text) {
  return ".TP\n" + term + "\n" + roff(text) + "\n";
}

std::string section(const std::string& title) {
  return ".SH " + title + "\n";
}

/// "viscera", "viscera bind", as `between` joins them.
std::string fullName(const CLI::App& app, const std::string& between) {
  return app.get_parent() ? fullName(*app.get_parent(), between) + between + app.get_name() : app.get_name();
}

/// "Compute an organ's coordinates" as it follows the name: small, without a full stop.
std::string asNameLine(std::string text) {
  if (const std::size_t end = text.find(". "); end != std::string::npos)
    text.resize(end);
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])))
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

std::string optionEntry(const CLI::App& app, const CLI::Option& option, bool positional) {
  const CLI::Formatter formatter;
  std::string names = formatter.make_option_name(&option, positional);
  const auto* shown = dynamic_cast<const CLI::Formatter*>(app.get_formatter().get());
  const std::string type = (shown ? *shown : formatter).make_option_opts(&option);
  for (std::size_t comma = names.find(','); comma != std::string::npos; comma = names.find(',', comma + 2))
    names.insert(comma + 1, " ");
  return entry(bold(names) + roff(type), option.get_description());
}

std::string synopsis(const CLI::App& app) {
  std::string text = section("SYNOPSIS") + ".B " + roff(fullName(app, " ")) + "\n[\\fIOPTIONS\\fR]";
  const CLI::Formatter formatter;
  for (const CLI::Option* positional : shownOptions(app, true))
    text += " \\fI" + roff(formatter.make_option_usage(positional)) + "\\fR";
  text += "\n";
  if (!commandsOf(app).empty())
    text += ".br\n.B " + roff(app.get_name()) + "\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR] ...\n";
  return text;
}

std::string options(const CLI::App& app) {
  std::string text;
  const auto positionals = shownOptions(app, true);
  if (!positionals.empty())
    text += section("ARGUMENTS");
  for (const CLI::Option* positional : positionals)
    text += optionEntry(app, *positional, true);
  text += section("OPTIONS");
  for (const CLI::Option* option : shownOptions(app, false))
    text += optionEntry(app, *option, false);
  return text;
}

std::string seeAlso(const CLI::App& app) {
  std::string text = section("SEE ALSO");
  if (const CLI::App* parent = app.get_parent())
    return text + ".BR " + roff(fullName(*parent, "-")) + " (1)\n";
  std::string before;
  for (const CLI::App* command : commandsOf(app)) {
    text += before + ".BR " + roff(fullName(*command, "-")) + " (1)";
    before = ",\n";
  }
  return text + "\n";
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (error)
    throw CannotCreateError("The folder cannot be made: " + error.message(), file.parent_path().string());
  writeAtomically(file, [&](std::ostream& stream) { stream << text; });
}

} // namespace

std::string manualPage(const CLI::App& app) {
  const std::string name = fullName(app, "-");
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(), [](unsigned char c) { return std::toupper(c); });
  std::string text = ".\\\" Made from the options that viscera --help prints.\n.TH \"" + roff(title) +
                     "\" 1 \"\" \"viscera " VISCERA_VERSION "\" \"User commands\"\n";
  text += section("NAME") + roff(name) + " \\- " + roff(asNameLine(app.get_description())) + "\n";
  text += synopsis(app);
  text += section("DESCRIPTION") + roff(app.get_description()) + (app.get_parent() ? ".\n" : "\n");
  text += options(app);
  if (const auto commands = commandsOf(app); !commands.empty()) {
    text += section("COMMANDS");
    for (const CLI::App* command : commands)
      text += entry(bold(command->get_name()), command->get_description());
    text += section("ENVIRONMENT");
    for (const auto& [variable, meaning] : kEnvironment)
      text += entry(bold(variable), meaning);
  }
  text += section("EXIT STATUS");
  for (const auto& [code, meaning] : kExitCodes)
    text += entry(code, meaning);
  return text + seeAlso(app);
}

void writeManual(const CLI::App& program, const ValueWords& words, const std::string& folder) {
  const std::filesystem::path root(folder);
  const auto page = [&](const CLI::App& app) {
    write(root / "man1" / (fullName(app, "-") + ".1"), manualPage(app));
  };
  page(program);
  for (const CLI::App* command : commandsOf(program))
    page(*command);
  write(root / "bash/viscera", bashCompletion(program, words));
  write(root / "zsh/_viscera", zshCompletion(program, words));
}

} // namespace viscera::app::cli
