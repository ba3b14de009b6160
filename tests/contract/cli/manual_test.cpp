#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "build_paths.h"
#include "cli_test.h"

namespace viscera::app::cli {
namespace {

/// Every match of the expression's first group.
std::set<std::string> allOf(const std::string& text, const std::string& expression) {
  const std::regex pattern(expression);
  std::set<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
    found.insert((*it)[1]);
  return found;
}

std::set<std::string> linesOf(const std::string& text) {
  std::set<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.insert(line);
  return lines;
}

/// Our program and libraries, as they were built.
std::vector<std::string> builtFiles() {
  std::vector<std::string> files{VISCERA_PROGRAM};
  for (const auto& entry : std::filesystem::directory_iterator(VISCERA_BINARY_DIR "/lib"))
    if (!entry.is_symlink() && entry.path().filename().string().starts_with("libviscera_"))
      files.push_back(entry.path().string());
  return files;
}

/// The name in `--version` of the library in this file; empty for those of the system: C and C++, the
/// driver's interface, sanitisers.
std::string nameOfLibrary(const std::string& file) {
  static const std::pair<const char*, const char*> names[] = {
      {"lib(viscera|vtkViscera).*", ""},
      {R"((lib(c|m|dl|pthread|gcc_s|stdc\+\+|EGL|OpenGL|[a-z]+san)\.so|ld-linux).*)", ""},
      {"libvtk.*", "VTK"},
      {"libQt5.*", "Qt"},
      {"lib(dcm|cmr|oflog|ofstd).*", "DCMTK"},
      {"libopenjp2.*", "OpenJPEG"},
      {"libqhull.*", "Qhull"},
      {R"(libz\..*)", "zlib"},
      {"libbz2.*", "bzip2"},
      {"liblz4.*", "LZ4"},
      {"liblzma.*", "XZ"},
      {"libexpat.*", "Expat"},
      {"lib(crypto|ssl).*", "OpenSSL"},
      {"libcurl.*", "curl"},
      {"libfontconfig.*", "Fontconfig"},
      {"libGLEW.*", "GLEW"},
      {"lib[gi]?omp.*", "OpenMP"}};
  for (const auto& [pattern, name] : names)
    if (std::regex_match(file, std::regex(pattern)))
      return name;
  return file;
}

class Manual : public CliTest {
protected:
  void SetUp() override {
    CliTest::SetUp();
    ASSERT_EQ(run({"--write-manual", path("m")}).exitCode, kOk);
    help_ = run({"--help"}).out;
    commands_ = allOf(help_.substr(help_.find("Subcommands:")), R"(\n  ([a-z]+) )");
    ASSERT_GE(commands_.size(), 20u) << help_;
  }

  /// What bash offers where the last of these words is being typed.
  std::set<std::string> offered(const std::string& words) const {
    const test::ProcessResult result = test::runProcess(
        {"/bin/bash", "--norc", "-c",
         "source '" + path("m/bash/viscera") + "'; COMP_WORDS=(viscera " + words +
             "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _viscera; printf '%s\\n' \"${COMPREPLY[@]}\""},
        options_);
    EXPECT_EQ(result.exitCode, kOk) << result.err;
    EXPECT_EQ(result.err, "");
    return linesOf(result.out);
  }

  std::string help_;
  std::set<std::string> commands_;
};

} // namespace

TEST_F(Manual, HasAPageForEachCommandWithEveryOptionThatItsHelpPrints) {
  const std::string first = contents(path("m/man1/viscera.1"));
  for (const std::string& command : commands_) {
    const std::string page = contents(path("m/man1/viscera-" + command + ".1"));
    const std::string help = run({command, "--help"}).out;
    const std::set<std::string> options = allOf(help, R"(\n  (?:-[a-z],)?(--[a-z-]+))");
    EXPECT_GE(options.size(), 4u) << help;
    for (const std::string& option : options)
      EXPECT_NE(page.find(std::regex_replace(option, std::regex("-"), "\\-")), std::string::npos)
          << command << " " << option;
    EXPECT_NE(first.find("\\fB" + command + "\\fR"), std::string::npos) << command;
  }
  EXPECT_EQ(first.find("write\\-manual"), std::string::npos);
}

TEST_F(Manual, IsRoffWithoutWarnings) {
  if (!std::filesystem::exists("/usr/bin/groff"))
    GTEST_SKIP() << "groff is not installed";
  std::vector<std::string> groff{"/usr/bin/groff", "-man", "-ww", "-z", path("m/man1/viscera.1")};
  for (const std::string& command : commands_)
    groff.push_back(path("m/man1/viscera-" + command + ".1"));
  const test::ProcessResult result = test::runProcess(groff, options_);
  EXPECT_EQ(result.exitCode, kOk);
  EXPECT_EQ(result.err, "");
}

TEST_F(Manual, BashCompletesCommandsOptionsAndValues) {
  for (const std::string& command : commands_)
    EXPECT_EQ(offered(command.substr(0, command.size() - 1)).count(command), 1u) << command;
  EXPECT_EQ(offered("play --th"), (std::set<std::string>{"--theme", "--threads"}));
  EXPECT_EQ(offered("play --theme ''"), (std::set<std::string>{"dark", "light"}));
  EXPECT_EQ(offered("bind --system mean"), (std::set<std::string>{"mean-value"}));
  EXPECT_EQ(offered("play hea"), (std::set<std::string>{"heartbeat"}));
  const std::string file = put("one.stl", "");
  EXPECT_EQ(offered("info '" + path("one") + "'"), (std::set<std::string>{file}));
  EXPECT_EQ(offered("bind --handles '" + path("one") + "'"), (std::set<std::string>{file}));
}

TEST_F(Manual, CompletionOfZshHasEveryCommandAndIsRead) {
  const std::string script = contents(path("m/zsh/_viscera"));
  for (const std::string& command : commands_)
    EXPECT_NE(script.find("      " + command + ")\n"), std::string::npos) << command;
  if (!std::filesystem::exists("/usr/bin/zsh"))
    GTEST_SKIP() << "zsh is not installed";
  const test::ProcessResult result =
      test::runProcess({"/usr/bin/zsh", "-n", path("m/zsh/_viscera")}, options_);
  EXPECT_EQ(result.exitCode, kOk);
  EXPECT_EQ(result.err, "");
}

TEST_F(Manual, VersionNamesWhatWasLinked) {
  const std::string said = run({"--version"}).out;
  for (const std::string library : {"VTK", "Qt", "Eigen", "DCMTK", "OpenJPEG", "Qhull", "Boost", "zlib",
                                    "bzip2", "Fontconfig", "GLEW", "OpenMP", "TetGen"})
    EXPECT_TRUE(std::regex_search(said, std::regex("\n  " + library + R"( [0-9]+\.[0-9])")))
        << library << "\n"
        << said;
}

TEST_F(Manual, VersionNamesEveryLibraryThatOursNeed) {
  if (!std::filesystem::exists("/usr/bin/readelf"))
    GTEST_SKIP() << "readelf, of the package binutils, is not installed";
  const std::string said = run({"--version"}).out;
  std::set<std::string> needed;
  for (const std::string& file : builtFiles())
    for (const std::string& library :
         allOf(test::runProcess({"/usr/bin/readelf", "-d", file}, options_).out, R"(\(NEEDED\).*\[(.*)\])"))
      needed.insert(nameOfLibrary(library));
  EXPECT_GT(needed.size(), 5u);
  for (const std::string& name : needed)
    if (!name.empty()) {
      EXPECT_NE(said.find("\n  " + name + " "), std::string::npos) << name << "\n" << said;
    }
}

} // namespace viscera::app::cli
