#include "window_test.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "build_paths.h"
#include "run_process.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/document/autosave.h"
#include "viscera/document/rig_commands.h"
#include "viscera/medical_io/surface_file.h"
#include "window/run_window.h"
#include "window/session/exit_handler.h"
#include "window/session/session_files.h"

namespace viscera::tests {
namespace {

constexpr const char* kFolderVariable = "VISCERA_TEST_RECOVERY_FOLDER";
constexpr const char* kServerVariable = "VISCERA_TEST_X_SERVER";
constexpr double kMovedMm = 7.1;

/// A virtual display of this test's own, which it may end.
class OwnDisplay {
public:
  OwnDisplay() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
      return;
    server_ = ::fork();
    if (server_ == 0) {
      const int nowhere = ::open("/dev/null", O_RDWR);
      ::dup2(nowhere, STDIN_FILENO);
      ::dup2(ends[1], STDOUT_FILENO);
      ::dup2(nowhere, STDERR_FILENO);
      ::execlp("Xvfb", "Xvfb", "-displayfd", "1", "-screen", "0", "1280x1024x24", "-nolisten", "tcp",
               static_cast<char*>(nullptr));
      ::_exit(127);
    }
    ::close(ends[1]);
    std::array<char, 32> text{};
    for (ssize_t count;
         number_.find('\n') == std::string::npos && (count = ::read(ends[0], text.data(), text.size())) > 0;)
      number_.append(text.data(), static_cast<std::size_t>(count));
    ::close(ends[0]);
  }
  ~OwnDisplay() {
    if (server_ <= 0)
      return;
    ::kill(server_, SIGKILL);
    ::waitpid(server_, nullptr, 0);
  }
  OwnDisplay(const OwnDisplay&) = delete;
  OwnDisplay& operator=(const OwnDisplay&) = delete;

  bool runs() const { return number_.find('\n') != std::string::npos; }
  std::string name() const { return ":" + number_.substr(0, number_.find('\n')); }
  pid_t server() const { return server_; }

private:
  pid_t server_ = -1;
  std::string number_;
};

class DisplayGone : public WindowTest {
protected:
  app::SessionFiles& sessions() { return window().sessions(); }
};

/// Not a test: the program whose display goes, which the test below runs as another process. It ends its own
/// display once it has work that is not saved, so that nobody has to guess when that is.
TEST_F(DisplayGone, DISABLED_TheProgramThatLosesIt) {
  const char* const folder = std::getenv(kFolderVariable);
  const char* const server = std::getenv(kServerVariable);
  ASSERT_TRUE(folder && server);
  sessions().startAutosave(folder); // Its first file would come in a minute.
  const app::ExitHandler unasked([this] { app::keepWithoutDisplay(sessions()); });
  open(sphereFile());
  Points pose = document().pose();
  pose(0, 0) += kMovedMm;
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  ::kill(static_cast<pid_t>(std::atol(server)), SIGKILL);
  waitUntil([] { return false; });
  FAIL() << "the program lives without its display";
}

TEST_F(DisplayGone, EndsWithASentenceAndKeepsTheWork) {
  const QString folder = path(QStringLiteral("recovery"));
  test::ProcessResult result;
  {
    const OwnDisplay display;
    if (!display.runs())
      GTEST_SKIP() << "there is no Xvfb";
    test::ProcessOptions options;
    options.environment = {{"DISPLAY", display.name()},
                           {"CTEST_RESOURCE_GROUP_0_DISPLAYS", std::nullopt},
                           {"WAYLAND_DISPLAY", std::nullopt},
                           {"XAUTHORITY", std::nullopt},
                           {kFolderVariable, folder.toStdString()},
                           {kServerVariable, std::to_string(display.server())}};
    result = test::runProcess({std::filesystem::read_symlink("/proc/self/exe").string(),
                               "--gtest_also_run_disabled_tests",
                               "--gtest_filter=DisplayGone.DISABLED_TheProgramThatLosesIt"},
                              options);
  }
  EXPECT_EQ(result.exitCode, app::ExitHandler::kExitCode) << result.out << result.err;
  EXPECT_NE(result.err.find("viscera: the display has gone; unsaved work is kept"), std::string::npos)
      << result.err;
  sessions().startAutosave(folder.toStdString());
  sessions().recover();
  ASSERT_TRUE(waitUntil([this] { return document().organs().size() == 1; })) << message().toStdString();
  settle();
  const Points moved = document().pose() - document().rig().restPositions();
  EXPECT_NEAR(moved(0, 0), kMovedMm, 1e-9);
  EXPECT_TRUE(sessions().modified()) << "it is saved nowhere yet";
}

/// Below a file no folder can be made, not even by the administrator.
TEST(UnwritablePlaces, OfCacheSettingsAndStateStopNoWindow) {
  const TemporaryFolder folder;
  test::ProcessOptions options;
  for (const char* variable : {"XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"})
    options.environment[variable] = "/dev/null/nowhere";
  options.environment["MESA_SHADER_CACHE_DISABLE"] = "1"; // Mesa has a message of its own.
  const std::filesystem::path picture = folder / "window.png";
  const test::ProcessResult result =
      test::runProcess({VISCERA_PROGRAM, "--screenshot", picture, "sample:liver"}, options);
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_GT(std::filesystem::file_size(picture), 50000u);
}

/// The terminal names what is missing, and the window shows the rest.
TEST(MissingFiles, AmongOthersStopNoWindow) {
  const TemporaryFolder folder;
  const std::filesystem::path good = folder / "good.stl", picture = folder / "window.png";
  medical_io::writeSurface(good, sphere(3, 60));
  const test::ProcessResult result = test::runProcess(
      {VISCERA_PROGRAM, "--screenshot", picture, folder / "first.stl", good, folder / "last.ply"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  for (const char* missing : {"first.stl: There is no such file", "last.ply: There is no such file"})
    EXPECT_NE(result.err.find(missing), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find("good.stl"), std::string::npos) << result.err;
  EXPECT_GT(std::filesystem::file_size(picture), 50000u);
}

} // namespace
} // namespace viscera::tests
