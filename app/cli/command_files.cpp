#include "cli/command_files.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <ostream>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "cli/overwritten_inputs.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/file_kind.h"

namespace viscera::app::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kStreamPollMs = 100; ///< How soon Ctrl+C ends the wait for a stream.

bool isOneOf(const std::string& value, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), value) != names.end();
}

bool isStandardInput(const std::string& value) {
  return isOneOf(value, {"-", "/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"});
}

bool isStandardOutput(const std::string& value) {
  return isOneOf(value, {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"});
}

/// Whether the value names what can be read only once, from its beginning to its end: a pipe, as the shell's
/// `<(...)` makes it. A device, which may have no end, is none.
bool isStream(const std::string& value) {
  if (isStandardInput(value) || value.starts_with("/dev/fd/") || value.starts_with("/proc/self/fd/"))
    return true;
  std::error_code unreachable;
  const fs::file_status status = fs::status(value, unreachable);
  return fs::is_fifo(status) || fs::is_socket(status);
}

/// Whether the values of an option may be files: others are left alone, whatever they look like.
bool takesFiles(const CLI::Option& option) {
  return option.get_positional() ||
         isOneOf(option.get_type_name(), {"FILE", "ORGAN", "FOLDER", "DIR", "PATH", "SCAN"});
}

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

std::string inWordsOr(const std::vector<std::string>& endings) {
  std::string text;
  for (std::size_t i = 0; i < endings.size(); ++i)
    text += (i == 0 ? "" : i + 1 == endings.size() ? " or " : ", ") + endings[i];
  return text;
}

bool isGiven(const CLI::App& options, const std::string& name) {
  const CLI::Option* option = options.get_option_no_throw(name);
  return option && option->count() > 0;
}

/// Sets the option to other values, as if they had been on the command line.
void setValues(CLI::Option& option, const std::vector<std::string>& values) {
  if (values == option.results())
    return;
  option.clear();
  option.add_result(values);
  option.run_callback();
}

/// The open file of a stream, closed at the end unless it is the program's standard input.
class OpenStream {
public:
  explicit OpenStream(const std::string& value)
      : name_(value),
        file_(isStandardInput(value) ? STDIN_FILENO : ::open(value.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~OpenStream() {
    if (file_ > STDIN_FILENO)
      ::close(file_);
  }
  OpenStream(const OpenStream&) = delete;
  OpenStream& operator=(const OpenStream&) = delete;

  void copyTo(std::ostream& out, Progress& progress) const {
    std::array<char, 65536> buffer;
    for (;;) {
      progress.throwIfCancelled();
      pollfd source{file_, POLLIN, 0};
      if (file_ >= 0 && ::poll(&source, 1, kStreamPollMs) == 0)
        continue;
      const ssize_t count = ::read(file_, buffer.data(), buffer.size());
      if (count == 0)
        return;
      if (count < 0 && errno == EINTR)
        continue;
      if (count < 0)
        throw NoInputError("It cannot be read: " + std::generic_category().message(errno), name_,
                           "write into the pipe, or name a file");
      out.write(buffer.data(), count);
    }
  }

private:
  std::string name_;
  int file_;
};

/// Gives the file the ending that its bytes promise, unless its name has one.
fs::path withUsualEnding(const fs::path& file) {
  if (file.has_extension())
    return file;
  fs::path named = file;
  try {
    named += medical_io::usualEnding(file);
  } catch (const Error&) {
    return file; // Empty: its reader says so.
  }
  fs::rename(file, named);
  return named;
}

} // namespace

void requireEnding(const OutputOption& output, const std::string& value) {
  std::error_code unreachable;
  const fs::file_status status = fs::status(value, unreachable);
  const bool isDevice = fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
  const std::string name = lowerCase(fs::path(value).filename().string());
  if (output.endings.empty() || isDevice ||
      std::any_of(output.endings.begin(), output.endings.end(),
                  [&](const std::string& ending) { return name.ends_with(ending); }))
    return;
  const std::string ending = fs::path(name).extension().string();
  throw UsageError(ending.empty() ? "It has no ending that says a format"
                                  : output.name + " does not write " + ending + " files",
                   value, "let its name end in " + inWordsOr(output.endings));
}

CommandFiles::CommandFiles(CLI::App& options, const std::vector<OutputOption>& outputs,
                           const FileRules& rules, Progress& progress) {
  std::vector<std::string> written, named;
  std::vector<const CLI::Option*> outputOptions;
  for (const OutputOption& output : outputs) {
    CLI::Option* option = options.get_option_no_throw(output.name);
    if (!option || option->count() == 0 ||
        (output.last && (option->count() < 2 || isGiven(options, "--output"))))
      continue;
    outputOptions.push_back(option);
    std::vector<std::string> values = option->results();
    for (std::size_t i = 0; i < values.size(); ++i)
      if (output.last && i + 1 < values.size()) {
        named.push_back(values[i] = inputFor(values[i], progress));
      } else {
        values[i] = outputFor(output, values[i], rules.json);
        requireEnding(output, values[i]);
        written.push_back(values[i]);
      }
    setValues(*option, values);
  }
  for (CLI::Option* option : options.get_options()) {
    const bool isOutput =
        std::find(outputOptions.begin(), outputOptions.end(), option) != outputOptions.end();
    if (isOutput || option->count() == 0 || !takesFiles(*option))
      continue;
    std::vector<std::string> values = option->results();
    for (std::string& value : values)
      value = inputFor(value, progress);
    named.insert(named.end(), values.begin(), values.end());
    setValues(*option, values);
  }
  requireDifferent(written);
  if (!rules.force)
    requireNoInput(written, named);
}

CommandFiles::~CommandFiles() {
  std::error_code ignored;
  if (!folder_.empty())
    fs::remove_all(folder_, ignored);
}

void CommandFiles::sendOutput(std::ostream& out) const {
  std::ifstream file(streamed_, std::ios::binary);
  if (file.peek() != std::ifstream::traits_type::eof())
    out << file.rdbuf();
  out.flush();
  if (!out)
    throw CannotCreateError("It cannot be written", "standard output");
}

std::string CommandFiles::told(std::string text) const {
  for (const auto& [temporary, name] : told_)
    for (std::size_t at = text.find(temporary); at != std::string::npos; at = text.find(temporary, at))
      text.replace(at, temporary.size(), name);
  return text;
}

fs::path CommandFiles::temporaryFile(const std::string& name, const std::string& told) {
  if (folder_.empty()) {
    std::string pattern = (fs::temp_directory_path() / "viscera-XXXXXX").string();
    if (!::mkdtemp(pattern.data()))
      throw CannotCreateError("It cannot be made: " + std::generic_category().message(errno), pattern,
                              "free some room there, or name another folder by TMPDIR");
    folder_ = pattern;
  }
  fs::path file = folder_ / name;
  for (int number = 2; fs::exists(file); ++number)
    file = folder_ / (std::to_string(number) + name);
  told_[file.string()] = told;
  return file;
}

std::string CommandFiles::outputFor(const OutputOption& output, const std::string& value, bool json) {
  if (!isStandardOutput(value) || (!output.stream && value != "-"))
    return value;
  if (!output.stream)
    throw UsageError("It cannot be written to standard output", output.name + " " + value,
                     "name a file: what standard output takes are tables, handles and motions");
  if (json || streamsOutput())
    throw UsageError("Standard output is taken by " + std::string(json ? "--json" : "another output"),
                     output.name + " " + value, "name a file for one of them");
  streamed_ = temporaryFile("stdout" + output.endings.front(), value);
  return streamed_.string();
}

std::string CommandFiles::inputFor(const std::string& value, Progress& progress) {
  if (isStream(value))
    return copyOf(value, progress);
  if (value.starts_with("-/")) // A label of a label map.
    return copyOf("-", progress) + value.substr(1);
  const std::size_t equals = value.find('='); // "lv=-"
  if (equals != std::string::npos && isStream(value.substr(equals + 1)))
    return value.substr(0, equals + 1) + copyOf(value.substr(equals + 1), progress);
  return value;
}

std::string CommandFiles::copyOf(const std::string& stream, Progress& progress) {
  const std::string key = isStandardInput(stream) ? "-" : stream;
  if (const auto known = read_.find(key); known != read_.end())
    return known->second;
  const bool isNumbered = stream.starts_with("/dev/fd/") || stream.starts_with("/proc/self/fd/");
  const std::string name = isStandardInput(stream) ? "stdin"
                           : isNumbered            ? "stream"
                                                   : fs::path(stream).filename().string();
  const fs::path file = temporaryFile(name, stream);
  {
    std::ofstream copy(file, std::ios::binary);
    OpenStream(stream).copyTo(copy, progress);
    copy.close();
    if (!copy)
      throw CannotCreateError("The stream does not fit there", folder_.string(),
                              "free some room, or name another folder by TMPDIR");
  }
  const fs::path complete = withUsualEnding(file);
  told_.erase(file.string());
  told_[complete.string()] = stream;
  return read_[key] = complete.string();
}

} // namespace viscera::app::cli
