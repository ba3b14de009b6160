#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report_scene.h"
#include "temporary_folder.h"
#include "viscera/document/circulation_commands.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/stress_mark_commands.h"
#include "viscera/live/motion_recipe.h"
#include "viscera/report/session_script.h"

namespace viscera::tests {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kHostileName =
    "x'; touch owned #\ntouch owned\nEND_OF_FILE\n`touch owned` $(touch owned)";

/// Runs a script in a folder in which `viscera` does nothing, and returns what the shell did.
int runInShell(const TemporaryFolder& folder, const std::string& script) {
  const std::filesystem::path program = folder.put("viscera", "#!/bin/sh\nexit 0\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  folder.put("script.sh", script);
  const std::string place = folder.path().string();
  return std::system(("cd '" + place + "' && PATH='" + place + "':\"$PATH\" sh ./script.sh").c_str());
}

TEST(SessionScript, PosesEachOrganByItsHandlesAndParameters) {
  ReportedSession session({"Liver left", "Liver_left"});
  session.undo.perform(document::setSystem({"s-celestial", {}}));
  session.undo.perform(document::setParameter("softness", 0.1));
  session.pose();
  const auto script = report::sessionScript({session.document.state(), {}, "/tmp/a b/case.viscera"});
  ASSERT_EQ(script.commands.size(), 3u);
  EXPECT_EQ(script.commands[0], "viscera deform '/tmp/a b/case.viscera/Liver left' --handles "
                                "handles.mrk.json --pose pose.mrk.json --system "
                                "s-celestial --param softness=0.1 -o Liver_left.vtp");
  EXPECT_THAT(script.commands[1], HasSubstr("case.viscera/Liver_left'"));
  EXPECT_THAT(script.commands[1], HasSubstr("-o Liver_left-2.vtp"));
  EXPECT_EQ(script.commands[2], "viscera render '/tmp/a b/case.viscera' -o picture.png");
  EXPECT_THAT(script.text, HasSubstr("{\"id\":\"1\",\"label\":\"H-10\",\"position\":[70.0,3.0,-1.0]"));
}

TEST(SessionScript, TakesNoNameForACommand) {
  ReportedSession session({kHostileName});
  session.undo.perform(document::editHandles({session.handle(0)}, {kHostileName, kHostileName, {}, {}, {}}));
  session.undo.perform(document::addGroup(kHostileName, {1, 0, 0}, {session.handle(0), session.handle(1)}));
  session.undo.perform(document::addMeasurement({{}, {}}, kHostileName));
  session.record();
  presentation::ViewState view;
  view.shown.stress = true;
  view.motions = {{session.organ(), live::SampleMotion{kHostileName, sample_organs::Resolution::low}}};
  const TemporaryFolder folder;
  for (const int motion : {-1, 0}) {
    view.playing = presentation::Playing{motion, 0.3, 30, 1, true, false};
    const auto script = report::sessionScript({session.document.state(), view, "/tmp/it's.viscera"});
    EXPECT_EQ(runInShell(folder, script.text), 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "owned")) << script.text;
    EXPECT_TRUE(std::filesystem::exists(folder / "handles.mrk.json"));
    EXPECT_THAT(script.commands[0],
                StartsWith("viscera deform '/tmp/it'\\''s.viscera/x'\\''; touch owned #\n"));
  }
}

TEST(SessionScript, HasTheProbesAndProfilesOfTheOrganUnderStress) {
  ReportedSession session;
  session.undo.perform(document::addStressProbe(session.organ(), {-1.5, 2, 3}));
  session.undo.perform(document::addStressProbe(session.organ(), {4, 5, 6}));
  const auto& probes = session.document.stressMarks().probes;
  session.undo.perform(document::addStressLine(probes[1].id, probes[0].id));
  presentation::ViewState view;
  view.shown.stress = true;
  const auto script = report::sessionScript({session.document.state(), view, "/tmp/a.viscera"});
  EXPECT_THAT(script.text, HasSubstr("--probe -1.5,2,3 --probe 4,5,6 --profile 4,5,6:-1.5,2,3"));
}

TEST(SessionScript, PlaysTheSessionItselfWhereOnlyThatKeepsALockOrACage) {
  for (const bool locked : {true, false}) {
    ReportedSession session;
    session.record();
    if (locked)
      session.undo.perform(document::setVolumeLocked(session.organ(), true));
    else
      session.undo.perform(document::takeCage({"cube.off", cubeCage()}));
    presentation::ViewState view;
    view.playing = presentation::Playing{-1, 0.3, 30, 1, true, false};
    const auto script = report::sessionScript({session.document.state(), view, "/tmp/a.viscera"});
    EXPECT_THAT(script.commands,
                testing::Contains("viscera play /tmp/a.viscera --rate 30.0 --csv recorded.csv"));
    EXPECT_THAT(script.text, HasSubstr(locked ? "# The volume of Ball is kept while it plays: the session"
                                              : "# The organs hang on a cage: the session"));
    EXPECT_THAT(script.text, testing::Not(HasSubstr("does not")));
    const auto unsaved = report::sessionScript({session.document.state(), view, {}});
    EXPECT_THAT(unsaved.text, HasSubstr("which viscera play takes from a session only"));
    EXPECT_THAT(unsaved.text, testing::Not(HasSubstr("viscera play /")));
  }
}

TEST(SessionScript, PlaysTheSessionItselfForACirculationWithParametersOfItsOwn) {
  ReportedSession session;
  session.undo.perform(document::chooseScenario("exercise"));
  presentation::ViewState view;
  view.motions = {{session.organ(), live::SampleMotion{"heartbeat", sample_organs::Resolution::low}}};
  view.playing = presentation::Playing{0, 0.3, 130, 1, true, false};
  const auto plain = report::sessionScript({session.document.state(), view, "/tmp/a.viscera"});
  EXPECT_THAT(plain.text, HasSubstr("viscera play heartbeat --scenario exercise --csv heartbeat.csv"));
  session.undo.perform(document::setCirculationParameter("lvEes", 1.5));
  const auto changed = report::sessionScript({session.document.state(), view, "/tmp/a.viscera"});
  EXPECT_THAT(changed.commands, testing::Contains("viscera play /tmp/a.viscera --csv heartbeat.csv"));
  EXPECT_THAT(changed.text, testing::Not(HasSubstr("--scenario")));
}

TEST(SessionScript, SaysWhatNoCommandCanDo) {
  ReportedSession session;
  session.undo.perform(document::addMeasurement({{}, {}}, "Long axis"));
  const auto script = report::sessionScript({session.document.state(), {}, {}});
  EXPECT_TRUE(script.commands.empty()) << "the ball is in no file and the session is not saved";
  EXPECT_THAT(script.text, HasSubstr("# Its surface is in no file: save the session"));
  EXPECT_THAT(script.text, HasSubstr("#   Long axis (distance)"));
}

} // namespace
} // namespace viscera::tests
