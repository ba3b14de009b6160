#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/output_option.h"
#include "viscera/core/progress.h"

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace viscera::app::cli {

/// What the options of every command say about its files.
struct FileRules {
  bool json = false;  ///< Standard output is for one JSON object.
  bool force = false; ///< An output may overwrite an input.
};

/// Throws `UsageError`, with the endings, unless the file's name has one of them. A device takes whatever is
/// written.
void requireEnding(const OutputOption& output, const std::string& value);

/// The files that a command names, between parsing its options and running it. Standard input and other pipes
/// become temporary files, since readers go to and fro in a file and know it by its ending; so does standard
/// output. An output has one of its formats' endings, and overwrites no input. For one thread.
class CommandFiles {
public:
  /// Changes the values of the parsed `options` where they name a stream. Reads streams to their end. Throws
  /// `UsageError` for an output without one of its endings, for two outputs at one place, for an output that
  /// is an input (by any name: a link, `./`, a file of a folder or a session that is read), unless
  /// `rules.force`, and for standard output where it is taken; `NoInputError` for a stream that cannot be
  /// read, `Cancelled`.
  CommandFiles(CLI::App& options, const std::vector<OutputOption>& outputs, const FileRules& rules,
               Progress& progress);
  /// Removes the temporary files.
  ~CommandFiles();
  CommandFiles(const CommandFiles&) = delete;
  CommandFiles& operator=(const CommandFiles&) = delete;

  /// Whether an output is to go to standard output, so that nothing else may be printed there.
  bool streamsOutput() const { return !streamed_.empty(); }
  /// Copies that output to `out`. Throws `CannotCreateError`.
  void sendOutput(std::ostream& out) const;

  /// A text of the command with the names that the user gave in the place of temporary ones.
  std::string told(std::string text) const;

private:
  std::filesystem::path temporaryFile(const std::string& name, const std::string& told);
  /// The temporary file that stands for an output; the value itself when it is no stream.
  std::string outputFor(const OutputOption& output, const std::string& value, bool json);
  /// The same for a value that may name an input.
  std::string inputFor(const std::string& value, Progress& progress);
  std::string copyOf(const std::string& stream, Progress& progress);

  std::filesystem::path folder_;            ///< Made when the first temporary file is.
  std::filesystem::path streamed_;          ///< What becomes standard output.
  std::map<std::string, std::string> told_; ///< The user's names by the temporary ones.
  std::map<std::string, std::string> read_; ///< The temporary files by the streams that they were read from.
};

} // namespace viscera::app::cli
