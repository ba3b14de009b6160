#include "cli/shell_completion.h"

#include <algorithm>
#include <sstream>

#include <CLI/CLI.hpp>

namespace viscera::app::cli {
namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : between) + word;
  return text;
}

std::vector<std::string> splitAtCommas(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');)
    words.push_back(word);
  return words;
}

/// The completions for the value of an option.
struct OptionValues {
  std::vector<std::string> words;
  bool files = false;
};

/// Closed lists stand in the type as CLI11 writes it: "TEXT:{dark,light}".
OptionValues valuesOf(const CLI::Option& option, const ValueWords& words) {
  const std::string type = option.get_type_name();
  if (const std::size_t open = type.find('{'), close = type.find('}');
      open != std::string::npos && close != std::string::npos)
    return {splitAtCommas(type.substr(open + 1, close - open - 1)), false};
  OptionValues values;
  const std::string name = option.get_positional() ? option.get_name(true, false) : type;
  if (const auto known = words.find(name); known != words.end())
    values.words = known->second;
  constexpr const char* kFiles[] = {"FILE", "FOLDER", "PATH", "ORGAN", "LABELMAP", "SCAN", "SESSION"};
  values.files = option.get_positional() || std::any_of(std::begin(kFiles), std::end(kFiles),
                                                        [&](const char* file) { return type == file; });
  return values;
}

bool takesValue(const CLI::Option& option) {
  return option.get_type_size() != 0;
}

/// "--output", "-o"
std::vector<std::string> spellings(const CLI::Option& option) {
  std::vector<std::string> result;
  for (const std::string& name : option.get_lnames())
    result.push_back("--" + name);
  for (const std::string& name : option.get_snames())
    result.push_back("-" + name);
  return result;
}

std::vector<std::string> allSpellings(const CLI::App& app) {
  std::vector<std::string> result;
  for (const CLI::Option* option : shownOptions(app, false))
    for (const std::string& name : spellings(*option))
      result.push_back(name);
  return result;
}

/// The lines of `case "$command $previous" in` with the completions after an option and without one.
std::string bashCases(const CLI::App& app, const std::string& command, const ValueWords& words) {
  std::string text;
  const auto add = [&](const std::string& pattern, const OptionValues& values) {
    text += "    " + pattern + ") words='" + joined(values.words, " ") +
            "'; files=" + (values.files ? "1" : "") + " ;;\n";
  };
  for (const CLI::Option* option : shownOptions(app, false)) {
    if (!takesValue(*option))
      continue;
    std::vector<std::string> patterns;
    for (const std::string& name : spellings(*option))
      patterns.push_back("'" + command + " " + name + "'");
    add(joined(patterns, "|"), valuesOf(*option, words));
  }
  OptionValues rest{allSpellings(app), false};
  for (const CLI::Option* positional : shownOptions(app, true)) {
    const OptionValues values = valuesOf(*positional, words);
    rest.words.insert(rest.words.end(), values.words.begin(), values.words.end());
    rest.files = rest.files || values.files;
  }
  if (!app.get_parent())
    for (const CLI::App* each : commandsOf(app))
      rest.words.push_back(each->get_name());
  add("'" + command + " '*", rest);
  return text;
}

/// Writes for the inside of '[...]' and ':...:' of zsh's _arguments, between single quotes.
std::string zshText(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\')
      result += '\\';
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return result;
}

std::string zshAction(const OptionValues& values) {
  std::vector<std::string> words;
  for (const std::string& word : values.words)
    words.push_back(zshText(word));
  const std::string list = "(" + joined(words, " ") + ")";
  if (values.files)
    return words.empty() ? "_files" : "{_alternative \"files:file:_files\" \"words:name:" + list + "\"}";
  return words.empty() ? " " : list;
}

std::string zshArguments(const CLI::App& app, const ValueWords& words, const std::string& indent) {
  std::string text = indent + "_arguments -s";
  const auto add = [&](const std::string& specification) {
    text += " \\\n" + indent + "  '" + specification + "'";
  };
  for (const CLI::Option* option : shownOptions(app, false))
    for (const std::string& name : spellings(*option)) {
      std::string specification = "*" + name + "[" + zshText(option->get_description()) + "]";
      if (takesValue(*option))
        specification += ":" + zshText(option->get_type_name()) + ":" + zshAction(valuesOf(*option, words));
      add(specification);
    }
  if (!app.get_parent()) {
    add("1: :_viscera_first");
    add("*:file:_files");
    return text + "\n";
  }
  for (const CLI::Option* positional : shownOptions(app, true))
    add("*:" + zshText(positional->get_name(true, false)) + ":" + zshAction(valuesOf(*positional, words)));
  return text + "\n";
}

} // namespace

std::vector<const CLI::Option*> shownOptions(const CLI::App& app, bool positionals) {
  std::vector<const CLI::Option*> options;
  for (const CLI::Option* option : app.get_options(nullptr))
    if (!option->get_group().empty() && option->get_positional() == positionals)
      options.push_back(option);
  return options;
}

std::vector<const CLI::App*> commandsOf(const CLI::App& program) {
  std::vector<const CLI::App*> commands;
  for (const CLI::App* command : program.get_subcommands(nullptr))
    commands.push_back(command);
  return commands;
}

std::string bashCompletion(const CLI::App& program, const ValueWords& words) {
  std::vector<std::string> names;
  for (const CLI::App* command : commandsOf(program))
    names.push_back(command->get_name());
  std::string text = "# Completion of viscera in bash, made from the options that viscera --help prints.\n"
                     "_viscera() {\n"
                     "  local cur prev command= words= files= each\n"
                     "  local -a said=(\"${COMP_WORDS[@]}\")\n"
                     "  local at=$COMP_CWORD\n"
                     "  cur=${said[at]}; prev=${said[at-1]}\n"
                     "  if declare -F _get_comp_words_by_ref >/dev/null; then\n"
                     "    _get_comp_words_by_ref -n : cur prev # sample:heart is one word\n"
                     "  fi\n"
                     "  for each in \"${said[@]:1:at-1}\"; do\n"
                     "    case $each in\n      " +
                     joined(names, "|") +
                     ") command=$each; break ;;\n"
                     "    esac\n"
                     "  done\n"
                     "  case \"$command $prev\" in\n";
  text += bashCases(program, "", words);
  for (const CLI::App* command : commandsOf(program))
    text += bashCases(*command, command->get_name(), words);
  return text + "  esac\n"
                "  COMPREPLY=($(compgen -W \"$words\" -- \"$cur\"))\n"
                "  if [ -n \"$files\" ]; then\n"
                "    compopt -o filenames 2>/dev/null\n"
                "    mapfile -t -O \"${#COMPREPLY[@]}\" COMPREPLY < <(compgen -f -- \"$cur\")\n"
                "  fi\n"
                "  if declare -F __ltrim_colon_completions >/dev/null; then\n"
                "    __ltrim_colon_completions \"$cur\"\n"
                "  fi\n"
                "}\n"
                "complete -F _viscera viscera\n";
}

std::string zshCompletion(const CLI::App& program, const ValueWords& words) {
  std::string text = "#compdef viscera\n"
                     "# Completion of viscera in zsh, made from the options that viscera --help prints.\n"
                     "_viscera_first() {\n"
                     "  local -a commands=(\n";
  for (const CLI::App* command : commandsOf(program))
    text += "    '" + command->get_name() + ":" + zshText(command->get_description()) + "'\n";
  text += "  )\n"
          "  _alternative 'commands:command:{_describe command commands}' 'files:file:_files'\n"
          "}\n"
          "_viscera() {\n"
          "  local at\n"
          "  for ((at = 2; at < CURRENT; ++at)); do\n"
          "    case $words[at] in\n";
  for (const CLI::App* command : commandsOf(program))
    text += "      " + command->get_name() + ")\n        shift $((at - 1)) words; ((CURRENT -= at - 1))\n" +
            zshArguments(*command, words, "        ") + "        return ;;\n";
  return text + "    esac\n  done\n" + zshArguments(program, words, "  ") +
         "}\n"
         "_viscera \"$@\"\n";
}

} // namespace viscera::app::cli
