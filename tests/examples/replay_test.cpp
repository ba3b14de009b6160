#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "run_process.h"
#include "temporary_folder.h"
#include "viscera/document/key_sequence.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/session_file.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/live_binding.h"
#include "viscera/live/player.h"
#include "viscera/live/volume_keeper.h"

namespace viscera::examples {
namespace {

const char* const kReplayed = VISCERA_SOURCE_DIR "/tests/gui/sessions/play_recorded_locked.viscera";

/// What the example prints: pairs of seconds and ml, and at last the volume after the drag.
struct Printed {
  std::vector<std::pair<double, double>> beat;
  double draggedMl = 0;
};

Printed replay(const std::filesystem::path& saved) {
  const test::ProcessResult ran =
      test::runProcess({VISCERA_BINARY_DIR "/bin/example_replay", kReplayed, saved.string()});
  EXPECT_EQ(ran.exitCode, 0) << ran.err;
  Printed printed;
  std::istringstream lines(ran.out);
  std::string line;
  while (std::getline(lines, line)) {
    const std::size_t space = line.find(' ');
    if (line.starts_with("ball"))
      printed.draggedMl = std::stod(line.substr(space));
    else
      printed.beat.emplace_back(std::stod(line), std::stod(line.substr(space)));
  }
  return printed;
}

/// The parts of the window that play and drag, without it.
struct Parts {
  document::Document document;
  document::UndoStack undo{document};
  coordinates::Registry registry = coordinates::builtInRegistry();
  JobQueue jobs{[](const std::function<void()>& work) { work(); }};
  live::LiveBinding live{document, registry, jobs, {std::numeric_limits<double>::infinity(), {}}};

  explicit Parts(const std::filesystem::path& session) {
    Progress progress;
    undo.reset(document::readSession(session, sample_organs::standardLibrary(), progress).contents.state);
  }
  double ml() { return live.volume(document.organs().front()->id).nowMl; }
};

} // namespace

TEST(DeveloperGuide, ItsReplayPrintsTheBitsOfTheWindow) {
  const tests::TemporaryFolder folder;
  const Printed printed = replay(folder.path() / "posed.viscera");
  Parts parts(kReplayed);
  live::Player player(parts.document.state(), parts.live, [] { return 0.0; });
  player.setSequence(document::sequenceOf(parts.document.keySequence(), parts.document.rig()),
                     parts.document.organs().front()->id);
  player.setRatePerMinute(30); // As it was saved.
  player.match();
  ASSERT_EQ(printed.beat.size(), 50u) << "two seconds";
  for (const std::size_t frame : {0u, 12u, 25u, 40u}) {
    player.seek(printed.beat[frame].first / player.periodSeconds());
    EXPECT_EQ(printed.beat[frame].second, parts.ml()) << frame;
  }
  player.stop();
  live::VolumeKeeper keeper(parts.document.state(), parts.live);
  const int row = parts.document.rig().indexOf("H-9");
  live::LockedMotion motion =
      keeper.begin({parts.document.rig().handles.at(static_cast<std::size_t>(row)).id});
  parts.undo.perform(document::setPose(motion.translate(Vec3(6, -4, 3))));
  EXPECT_EQ(printed.draggedMl, parts.ml());
  Parts saved(folder.path() / "posed.viscera");
  EXPECT_EQ(saved.document.pose(), parts.document.pose());
  EXPECT_EQ(saved.ml(), printed.draggedMl);
}

TEST(DeveloperGuide, ItsReplayPrintsTheSameBitsTwice) {
  const tests::TemporaryFolder folder;
  const Printed one = replay(folder.path() / "one.viscera"), two = replay(folder.path() / "two.viscera");
  EXPECT_EQ(one.beat, two.beat);
  EXPECT_EQ(one.draggedMl, two.draggedMl);
}

} // namespace viscera::examples
