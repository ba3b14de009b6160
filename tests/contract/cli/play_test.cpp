#include <QColor>
#include <QImage>
#include <QString>

#include <cmath>
#include <limits>
#include <sstream>

#include "beating_labels.h"
#include "build_paths.h"
#include "cli_test.h"
#include "signs_picture.h"
#include "viscera/anatomy/part.h"
#include "viscera/document/circulation_commands.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/session_file.h"
#include "viscera/document/system_commands.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/circulating_heart.h"
#include "viscera/live/live_binding.h"
#include "viscera/live/motion_copy.h"
#include "viscera/live/motion_recipe.h"
#include "viscera/presentation/view_state.h"
#include "viscera/sequences/volume_record.h"
#include "viscera/workbench/workbench.h"

namespace viscera::app::cli {

class CliPlay : public CliTest {
protected:
  /// A table's rows as numbers, without its heading.
  static std::vector<std::vector<double>> rowsOf(const std::string& csv, std::string& heading) {
    std::istringstream lines(csv);
    std::getline(lines, heading);
    std::vector<std::vector<double>> rows;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream cells(line);
      rows.emplace_back();
      for (std::string cell; std::getline(cells, cell, ',');)
        rows.back().push_back(std::stod(cell));
    }
    return rows;
  }
};

TEST_F(CliPlay, TheHeartbeatEmptiesTheVentriclesAsMeasured) {
  const json beat = runJson({"play", "heartbeat", "--csv", path("v.csv"), "--cycles", "2"});
  for (const std::string key : {"frames", "cycles", "ejectionFraction", "maxRelativeOuterChange", "seconds"})
    EXPECT_TRUE(beat[key].is_number()) << key;
  for (const std::string surface : {"outer", "lv", "rv", "la", "ra"})
    for (const std::string key : {"minMl", "maxMl", "restMl"})
      EXPECT_TRUE(beat["volumes"][surface][key].is_number()) << surface << " " << key;
  EXPECT_EQ(beat["cycles"], 2);
  EXPECT_NEAR(beat["volumes"]["lv"]["maxMl"].get<double>(), 130.5, 0.5);
  EXPECT_NEAR(beat["volumes"]["lv"]["minMl"].get<double>(), 55.0, 0.5);
  EXPECT_NEAR(beat["volumes"]["rv"]["maxMl"].get<double>(), 138.0, 1.0);
  EXPECT_NEAR(beat["volumes"]["rv"]["minMl"].get<double>(), 62.5, 1.0);
  EXPECT_NEAR(beat["ejectionFraction"].get<double>(), 0.58, 0.005);
  EXPECT_LE(beat["maxRelativeOuterChange"].get<double>(), 0.12);

  std::string heading;
  const auto rows = rowsOf(contents(path("v.csv")), heading);
  EXPECT_EQ(heading, "time_s,outer_ml,lv_ml,rv_ml,la_ml,ra_ml");
  ASSERT_EQ(rows.size(), beat["frames"].get<std::size_t>());
  ASSERT_EQ(rows.size(), 40u); // Two beats of 0.8 s at 25 frames a second.
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 6u);
    EXPECT_NEAR(rows[i][0], static_cast<double>(i) / 25, 1e-6);
    EXPECT_NEAR(rows[i][2], rows[(i + 20) % 40][2], 1e-3) << "every beat is the same";
  }
}

TEST_F(CliPlay, MeasuresTheWholeBeatHoweverFewFramesAreDrawn) {
  const json often = runJson({"play", "heartbeat", "--organ", "sample:heart@low"});
  const json seldom = runJson({"play", "heartbeat", "--organ", "sample:heart@low", "--fps", "2"});
  EXPECT_EQ(seldom["frames"], 2);
  EXPECT_NEAR(seldom["ejectionFraction"].get<double>(), often["ejectionFraction"].get<double>(), 1e-3);
  EXPECT_NEAR(seldom["strokeVolumeMl"].get<double>(), often["strokeVolumeMl"].get<double>(), 0.1);
  EXPECT_NEAR(seldom["volumes"]["la"]["minMl"].get<double>(), often["volumes"]["la"]["minMl"].get<double>(),
              0.1);
}

TEST_F(CliPlay, RecordsAMovieAndFrames) {
  const json beat = runJson({"play", "heartbeat", "--organ", "sample:heart@low", "--fps", "10", "--size",
                             "320x200", "--movie", path("beat.ogv"), "--frames", path("frames.d")});
  EXPECT_EQ(beat["frames"], 8);
  EXPECT_EQ(contents(path("beat.ogv")).substr(0, 4), "OggS");
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path("frames.d"))) {
    ++pictures;
    EXPECT_EQ(contents(entry.path()).substr(1, 3), "PNG") << entry.path();
  }
  EXPECT_EQ(pictures, 8);
  EXPECT_EQ(files(), 2) << "nothing but the movie and the folder";
}

TEST_F(CliPlay, AFasterHeartHasShorterBeats) {
  const json fast =
      runJson({"play", "heartbeat", "--organ", "sample:heart@low", "--rate", "150", "--cycles", "3"});
  EXPECT_EQ(fast["frames"], 30);
  EXPECT_EQ(fast["ratePerMinute"], 150);
}

TEST_F(CliPlay, SaysHowTheHeartsWallMovesAndThatItsMuscleKeepsItsVolume) {
  const json beat = runJson({"play", "heartbeat", "--organ", "sample:heart@low"});
  const json& wall = beat["wallVolume"]; // Without the blood of all four cavities.
  EXPECT_GT(wall["minMl"].get<double>(), 200);
  EXPECT_LT(wall["minMl"], wall["maxMl"]);
  EXPECT_LT(wall["maxRelativeChange"].get<double>(), 0.05);
  const json& muscle = beat["leftVentricularMuscle"];
  EXPECT_LT(muscle["maxRelativeChange"].get<double>(), 0.06);
  EXPECT_GT(muscle["massG"].get<double>(), 105);
  EXPECT_LT(muscle["massG"].get<double>(), 130);
  for (const char* number : {"mapseMm", "tapseMm", "twistDegrees", "thickeningPercent"})
    EXPECT_GT(beat["wallMotion"][number].get<double>(), 0) << number;
}

TEST_F(CliPlay, AHeartWithItsChambersEjectsWhatIsAskedFor) {
  const std::string image =
      put("heart.seg.nrrd", tests::nrrdFile(tests::beatingLabels(0, Vec3(4, 4, 4)), "right-anterior-superior",
                                            tests::kHeartKeys));
  const json beat = runJson(
      {"play", "heartbeat", "--organ", image, "--ejection-fraction", "0.25", "--rate", "60", "--fps", "25"});
  EXPECT_NEAR(beat["ejectionFraction"].get<double>(), 0.25, 0.01);
  EXPECT_EQ(beat["frames"], 25);
  const json& lv = beat["volumes"]["LV"];
  const json& rv = beat["volumes"]["RV"];
  EXPECT_NEAR((lv["maxMl"].get<double>() - lv["minMl"].get<double>()) /
                  (rv["maxMl"].get<double>() - rv["minMl"].get<double>()),
              1, 0.05);
  runJson({"sample", "heart@low", "-o", path("outside.stl")});
  expectFailure({"play", "heartbeat", "--organ", path("outside.stl"), "--ejection-fraction", "0.4"}, kUsage,
                "Only a heart with its chambers");
  expectFailure({"play", "heartbeat", "--ejection-fraction", "0.4"}, kUsage,
                "Only a heart with its chambers");
}

TEST_F(CliPlay, FitsPeristalsisToAnotherStomachAndTakesItsLandmarksBack) {
  runJson({"sample", "stomach@low", "-o", path("patient.stl")});
  const json found = runJson({"play", "peristalsis", "--organ", path("patient.stl"), "--fps", "1",
                              "--write-landmarks", path("l.mrk.json")});
  EXPECT_NEAR(found["retargeted"]["scale"].get<double>(), 1, 0.15);
  EXPECT_LT(found["maxRelativeOuterChange"].get<double>(), 1e-6);
  EXPECT_GT(found["retargeted"]["handles"].get<int>(), 100);
  for (const json& landmark : found["retargeted"]["landmarks"])
    EXPECT_TRUE(landmark["computed"].get<bool>());
  const json again = runJson({"play", "peristalsis", "--organ", path("patient.stl"), "--fps", "1",
                              "--landmarks", path("l.mrk.json")});
  EXPECT_FALSE(again["retargeted"]["landmarks"][0]["computed"].get<bool>());
  EXPECT_EQ(again["retargeted"]["scale"], found["retargeted"]["scale"]);
}

/// What the refusal says to try is tried, and helps.
TEST_F(CliPlay, AnOrganInSeveralPiecesSaysHowToKeepTheLargest) {
  runJson({"sample", "stomach@low", "-o", path("stomach.obj")});
  std::string obj = contents(path("stomach.obj"));
  std::size_t vertices = obj.starts_with("v ") ? 1 : 0;
  for (std::size_t at = 0; (at = obj.find("\nv ", at)) != std::string::npos; ++at)
    ++vertices;
  for (const auto& corner : std::vector<std::array<double, 3>>{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}})
    obj += "v " + std::to_string(corner[0]) + " " + std::to_string(corner[1]) + " " +
           std::to_string(corner[2] + 900) + "\n";
  for (const auto& face : std::vector<std::array<std::size_t, 3>>{{1, 3, 2}, {1, 2, 4}, {2, 3, 4}, {1, 4, 3}})
    obj += "f " + std::to_string(vertices + face[0]) + " " + std::to_string(vertices + face[1]) + " " +
           std::to_string(vertices + face[2]) + "\n";
  put("pieces.obj", obj);
  const std::vector<std::string> play{"play", "peristalsis", "--fps", "1", "--organ"};
  const auto with = [&play](const std::string& organ) {
    std::vector<std::string> arguments = play;
    arguments.push_back(organ);
    return arguments;
  };
  expectFailure(with(path("pieces.obj")), kBadData, "in 2 pieces");
  expectFailure(with(path("pieces.obj")), kBadData, "viscera convert IN OUT --keep-largest");
  runJson({"convert", path("pieces.obj"), path("largest.obj"), "--keep-largest"});
  EXPECT_GT(runJson(with(path("largest.obj")))["retargeted"]["handles"].get<int>(), 100);
}

TEST_F(CliPlay, LandmarksThatAreWrongAreSaid) {
  runJson({"sample", "heart@low", "-o", path("patient.stl")});
  const std::vector<std::string> play{"play", "heartbeat", "--organ", path("patient.stl")};
  const auto with = [&play](std::vector<std::string> more) {
    more.insert(more.begin(), play.begin(), play.end());
    return more;
  };
  expectFailure(with({"--landmark", "apex=54,-31,-34"}), kBadData, "no base");
  expectFailure(with({"--landmark", "apex=54,-31,-34", "--landmark", "base=54,-31,-34"}), kBadData,
                "at one place");
  expectFailure(with({"--landmark", "apex=1,2"}), kUsage, "three numbers");
  expectFailure(with({"--landmarks", put("l.mrk.json", markups({{0, 0, 0}}))}), kBadData,
                "apex, base, right");
}

TEST_F(CliPlay, APrescribedVolumeIsMetInEveryFrameAndTheOtherSurfacesMoveOn) {
  const std::string curve = put("lv.csv", "time_s,LV_ml\n0,130\n0.4,70\n0.8,130\n");
  const std::vector<std::string> play{"play", "heartbeat", "--organ", "sample:heart@low", "--fps", "10"};
  const auto with = [&play](std::vector<std::string> more) {
    more.insert(more.begin(), play.begin(), play.end());
    return more;
  };
  const json beat = runJson(with({"--volume-curve", "lv=" + curve, "--csv", path("v.csv")}));
  EXPECT_EQ(beat["volumeCurve"], "lv=" + curve);
  EXPECT_NEAR(beat["volumes"]["lv"]["minMl"].get<double>(), 70, 1e-6);
  EXPECT_NEAR(beat["volumes"]["lv"]["maxMl"].get<double>(), 130, 1e-6);
  EXPECT_NEAR(beat["ejectionFraction"].get<double>(), 60.0 / 130, 1e-6);
  EXPECT_GT(beat["volumes"]["rv"]["maxMl"].get<double>(), beat["volumes"]["rv"]["minMl"].get<double>() + 40);
  std::string heading;
  const auto rows = rowsOf(contents(path("v.csv")), heading);
  ASSERT_EQ(rows.size(), 8u);
  EXPECT_NEAR(rows[4][2], 70, 1e-5);

  const double outer = beat["volumes"]["outer"]["restMl"].get<double>();
  const json kept = runJson(with({"--volume-curve", put("outer.csv", "0," + std::to_string(outer) + "\n")}));
  EXPECT_LT(kept["maxRelativeOuterChange"].get<double>(), 1e-6);
}

TEST_F(CliPlay, VolumeCurvesThatAreWrongAreSaid) {
  const auto refused = [this](const std::string& curve, int exitCode, const std::string& words) {
    expectFailure({"play", "heartbeat", "--organ", "sample:heart@low", "--volume-curve", curve}, exitCode,
                  words);
  };
  refused(path("none.csv"), kNoInput, "none.csv");
  refused(put("three.csv", "time_s,a_ml,b_ml\n0,1,2\n"), kBadData, "3 columns");
  refused(put("long.csv", "0,100\n7,80\n"), kBadData, "outside the cycle");
  refused(put("huge.csv", "0,90000\n"), kBadData, "cannot be reached at 0 %");
}

TEST_F(CliPlay, HandlesComeBackFromTheirFileInTheirGroups) {
  runJson({"play", "heartbeat", "--organ", "sample:heart@low", "--fps", "5", "--write-handles",
           path("h.mrk.json")});
  const json info = runJson({"info", path("h.mrk.json")});
  EXPECT_EQ(info["kind"], "handles");
  EXPECT_EQ(info["groups"].size(), 7u);
  runJson(
      {"play", "heartbeat", "--organ", "sample:heart@low", "--fps", "5", "--handles", path("h.mrk.json")});
}

TEST_F(CliPlay, NamesTheHandleThatIsNotAtItsPlace) {
  const std::vector<std::string> breathing{"play", "breathing", "--organ", "sample:liver@low", "--fps", "2"};
  auto arguments = breathing;
  arguments.insert(arguments.end(), {"--write-handles", path("own.mrk.json")});
  runJson(arguments);
  json moved = json::parse(contents(path("own.mrk.json")));
  json& handle = moved["markups"][0]["controlPoints"][2];
  handle["position"][0] = handle["position"][0].get<double>() + 5;
  arguments = breathing;
  arguments.insert(arguments.end(), {"--handles", put("moved.mrk.json", moved.dump())});
  const test::ProcessResult said = run(arguments);
  EXPECT_EQ(said.exitCode, kBadData);
  EXPECT_NE(said.err.find("handle " + handle["label"].get<std::string>() + ":"), std::string::npos)
      << said.err;
}

TEST_F(CliPlay, SaysFirstThatAMotionIsNotMadeForTheOrgan) {
  const json liver = runJson({"play", "heartbeat", "--organ", "sample:liver@low", "--fps", "2"});
  ASSERT_FALSE(liver["warnings"].empty());
  EXPECT_NE(liver["warnings"][0].get<std::string>().find("Heartbeat is made for another organ (Heart)"),
            std::string::npos)
      << liver["warnings"];
  const test::ProcessResult said =
      run({"play", "breathing", "--organ", "sample:kidney_left@low", "--fps", "2"});
  EXPECT_NE(said.err.find("Breathing is made for another organ (Liver) than this one (Left kidney)"),
            std::string::npos)
      << said.err;
  EXPECT_TRUE(
      runJson({"play", "breathing", "--organ", "sample:liver@low", "--fps", "2"})["warnings"].empty());
}

TEST_F(CliPlay, PlaysARecordedSequenceOnAnOrganWithinItsHandles) {
  json file{{"format", "viscera-sequence"}, {"version", 1}, {"periodSeconds", 2}, {"handles", json::array()}};
  const auto places = corners(60);
  for (std::size_t i = 0; i < places.size(); ++i)
    file["handles"].push_back({{"label", "H-" + std::to_string(i + 1)}, {"rest", places[i]}});
  file["keys"] = {{{"seconds", 0}, {"pose", json::object()}},
                  {{"seconds", 1}, {"pose", {{"H-1", {-90, -90, -90}}}}}};
  const std::string sequence = put("s.sequence.json", file.dump());
  const std::string cube = put("cube.off", cubeOff(20));
  const json played = runJson({"play", sequence, "--organ", cube, "--fps", "4"});
  EXPECT_EQ(played["frames"], 8);
  EXPECT_EQ(played["ratePerMinute"], 30);
  EXPECT_NEAR(played["volumes"]["outer"]["minMl"].get<double>(), 64, 1e-9);
  EXPECT_GT(played["volumes"]["outer"]["maxMl"].get<double>(), 65);
  expectFailure({"play", sequence}, kUsage, "--organ");
  expectFailure({"play", put("t.sequence.json", file.dump().substr(0, 100)), "--organ", cube}, kBadData,
                "t.sequence.json");
  expectFailure({"play", path("no.sequence.json"), "--organ", cube}, kNoInput, "no.sequence.json");
}

TEST_F(CliPlay, PutsAllFramesOnOneSheet) {
  runJson({"play", "heartbeat", "--organ", "sample:heart@low", "--fps", "5", "--size", "64x48", "--columns",
           "3", "--sheet", path("sheet.png")});
  const std::string png = contents(path("sheet.png"));
  ASSERT_EQ(png.substr(1, 3), "PNG");
  // Width and height stand big-endian behind the signature: four frames, three beside each other.
  EXPECT_EQ(static_cast<unsigned char>(png[19]), 192);
  EXPECT_EQ(static_cast<unsigned char>(png[23]), 96);
}

/// The right ventricle is violet behind its wall; in the tissue's colour nothing of the picture is.
TEST_F(CliPlay, DrawsTheBloodInTheHeartInItsOwnColours) {
  runJson({"play", "heartbeat", "--organ", "sample:heart@low", "--fps", "2", "--size", "160x120", "--sheet",
           path("sheet.png")});
  const QImage sheet(QString::fromStdString(path("sheet.png")));
  ASSERT_FALSE(sheet.isNull());
  int violet = 0;
  for (int y = 0; y < sheet.height(); ++y)
    for (int x = 0; x < sheet.width(); ++x) {
      const QColor color = sheet.pixelColor(x, y);
      violet += color.red() > color.green() + 30 && color.blue() > color.green() + 15;
    }
  EXPECT_GT(violet, sheet.width() * sheet.height() / 100);
}

TEST_F(CliPlay, OutputsThatCannotBeWrittenAreSaidFirst) {
  expectFailure({"play", "heartbeat", "--organ", "sample:heart@low", "--csv", path("no such folder/v.csv")},
                kCannotCreate, "v.csv");
  expectFailure({"play", "heartbeat", "--organ", "sample:heart@low", "--movie", path("no such folder/m.ogv")},
                kCannotCreate, "m.ogv");
  expectFailure({"play", "heartbeat", "--organ", "sample:heart@low", "--movie", path("m.avi")}, kUsage,
                ".ogv");
}

/// Sessions that `viscera play` takes whole.
class CliPlaySession : public CliPlay {
protected:
  /// The volumes of the session's organs over the cycle that the window computes, compared with the table.
  void expectTheCycleOfTheWindow(const document::DocumentState& state,
                                 const std::shared_ptr<const sequences::Sequence>& sequence,
                                 const std::vector<std::vector<double>>& rows) {
    const coordinates::Registry registry = coordinates::builtInRegistry();
    document::Document document;
    document::UndoStack undo(document);
    JobQueue jobs([](const std::function<void()>& work) { work(); });
    live::LiveBinding live(document, registry, jobs, {std::numeric_limits<double>::infinity(), {}});
    undo.reset(state);
    live::MotionRunner runner(document.state(), live);
    runner.setSequence(sequence);
    const live::PosedCycle cycle = live::posedCycle(runner, live.copy());
    ASSERT_GT(rows.size(), 3u);
    for (const std::vector<double>& row : rows) {
      live.showPose(cycle.poseAt(row[0] / cycle.periodSeconds));
      ASSERT_GE(row.size(), document.organs().size() + 1) << "chambers come again by their keys";
      for (std::size_t i = 0; i < document.organs().size(); ++i)
        EXPECT_NEAR(row[i + 1], live.volume(document.organs()[i]->id).nowMl, 1e-9) << "at " << row[0] << " s";
    }
  }
  void write(const std::string& name, const document::DocumentState& state,
             const presentation::ViewState& view) {
    document::SessionContents contents;
    contents.state = state;
    contents.view = presentation::toJson(view);
    contents.embedSurfaces = true;
    Progress progress;
    document::writeSession(path(name), contents, progress);
  }
};

TEST_F(CliPlaySession, KeepsItsLockedVolumesAsTheWindowDoes) {
  const std::string session = VISCERA_SOURCE_DIR "/tests/gui/sessions/play_recorded_locked.viscera";
  Progress progress;
  document::DocumentState state =
      document::readSession(session, sample_organs::standardLibrary(), progress).contents.state;
  ASSERT_TRUE(state.organs->front()->volumeLocked);
  const auto sequence = document::sequenceOf(*state.keySequence, *state.rig);
  const std::string rate = std::to_string(sequence->standardRatePerMinute());
  runJson({"play", session, "--rate", rate, "--csv", path("locked.csv")});
  std::string heading;
  const auto locked = rowsOf(contents(path("locked.csv")), heading);
  expectTheCycleOfTheWindow(state, sequence, locked);
  for (const std::vector<double>& row : locked)
    EXPECT_NEAR(row[1], locked[0][1], 1e-6) << "the lock holds";

  auto free = std::make_shared<document::Organ>(*state.organs->front());
  free->volumeLocked = false;
  auto organs = std::make_shared<document::OrganList>(*state.organs);
  organs->front() = free;
  state.organs = organs;
  write("free.viscera", state, {});
  runJson({"play", path("free.viscera"), "--rate", rate, "--csv", path("free.csv")});
  const auto unlocked = rowsOf(contents(path("free.csv")), heading);
  expectTheCycleOfTheWindow(state, sequence, unlocked);
  double largest = 0;
  for (const std::vector<double>& row : unlocked)
    largest = std::max(largest, std::abs(row[1] - unlocked[0][1]));
  EXPECT_GT(largest, 1) << "the lock had something to do";
}

TEST_F(CliPlaySession, PrintsTheBitsThatAWorkbenchPlays) {
  const std::string session = VISCERA_SOURCE_DIR "/tests/gui/sessions/play_recorded_locked.viscera";
  runJson({"play", session, "--csv", path("command.csv")});
  workbench::Workbench bench;
  bench.restore(session);
  sequences::VolumeRecord record(std::vector<std::string>{bench.state().organs->front()->name});
  for (const workbench::PlayedVolumes& instant : bench.play(25))
    record.add(instant.seconds, instant.milliliters);
  sequences::writeVolumeTable(path("bench.csv"), record, anatomy::chamberKeys(record.names()));
  EXPECT_GT(record.rows(), 20u);
  EXPECT_EQ(contents(path("command.csv")), contents(path("bench.csv")));
}

/// Puts the sample heart of low resolution with its handles and coordinates into an empty document.
void takeHeart(document::UndoStack& undo) {
  Progress progress;
  const live::SequenceSetup setup = live::setUpSequence(sample_organs::standardLibrary(), "heartbeat",
                                                        sample_organs::Resolution::low, progress);
  std::vector<document::NewOrgan> organs;
  for (const sample_organs::SampleSurface& surface : setup.organ.surfaces)
    organs.push_back({document::makeOrgan(surface.name, surface.mesh), -1});
  undo.perform(document::addOrgans(organs));
  undo.perform(document::replaceRig(setup.rig));
  undo.perform(document::setSystem(setup.system));
}

/// The view of a session in which that heart beats.
presentation::ViewState playingHeart(const document::Document& document) {
  presentation::ViewState view;
  view.motions = {
      {document.organs().front()->id, live::SampleMotion{"heartbeat", sample_organs::Resolution::low}}};
  view.playing = presentation::Playing{0, 0, 0, 1, true, true};
  return view;
}

TEST_F(CliPlaySession, FollowsItsCirculationWithParametersOfItsOwn) {
  Progress progress;
  const auto low = sample_organs::Resolution::low;
  document::Document document;
  document::UndoStack undo(document);
  takeHeart(undo);
  undo.perform(document::chooseScenario("rest"));
  undo.perform(document::setCirculationParameter("lvEes", 1.5));
  write("weak.viscera", document.state(), playingHeart(document));
  const json played = runJson({"play", path("weak.viscera"), "--csv", path("weak.csv")});
  const auto heart = live::circulatingHeart(sample_organs::standardLibrary(),
                                            document::nameOf(*document.state().circulation),
                                            document.state().circulation->parameters, low, progress);
  std::string heading;
  expectTheCycleOfTheWindow(document.state(), heart.sequence, rowsOf(contents(path("weak.csv")), heading));
  const json rest = runJson({"play", "heartbeat", "--organ", "sample:heart@low", "--scenario", "rest"});
  EXPECT_LT(played["ejectionFraction"].get<double>(), rest["ejectionFraction"].get<double>() - 0.05);
}

TEST_F(CliPlaySession, HasTheSignsOfItsInstantBelowItsPicture) {
  document::Document document;
  document::UndoStack undo(document);
  takeHeart(undo);
  presentation::ViewState view = playingHeart(document);
  for (const double fraction : {0.2, 0.7}) {
    view.playing->fraction = fraction;
    write("beat.viscera", document.state(), view);
    const json drawn = runJson({"render", path("beat.viscera"), "--view", "anterior", "--size", "640x480",
                                "-o", path("beat.png"), "--signs", "all"});
    EXPECT_EQ(drawn["signs"], json::array({"ecg", "valves", "sounds"}));
    EXPECT_NEAR(instantIn(imageOf(path("beat.png")), kWholeStrip), fraction, 0.005);
  }
  view.playing->shown = false;
  write("rest.viscera", document.state(), view);
  expectFailure({"render", path("rest.viscera"), "--view", "anterior", "-o", path("r.png"), "--signs", "ecg"},
                kUsage, "not saved at an instant");
}

TEST_F(CliPlaySession, MeetsTheVolumeThatItPrescribes) {
  document::Document document;
  document::UndoStack undo(document);
  takeHeart(undo);
  presentation::ViewState view = playingHeart(document);
  const document::OrganId left = document.organs()[1]->id;
  view.playing->prescribed = presentation::Prescribed{left, "lv.csv", {{0, 130}, {0.5, 70}}};
  write("kept.viscera", document.state(), view);
  runJson({"play", path("kept.viscera"), "--csv", path("kept.csv"), "--fps", "20"});
  std::string heading;
  const auto rows = rowsOf(contents(path("kept.csv")), heading);
  ASSERT_GE(rows.size(), 8u);
  EXPECT_NEAR(rows[0][2], 130, 1e-4) << heading;
  EXPECT_NEAR(rows[rows.size() / 2][2], 70, 1e-4) << heading;
  view.playing->prescribed->curve[1][1] = -1;
  write("odd.viscera", document.state(), view);
  expectFailure({"play", path("odd.viscera")}, kBadData, "not positive");
}

TEST_F(CliPlaySession, SaysWhatItDoesNotTake) {
  const std::string session = VISCERA_SOURCE_DIR "/tests/gui/sessions/play_recorded_locked.viscera";
  expectFailure({"play", session, "--organ", "sample:heart"}, kUsage, "--organ");
  expectFailure({"play", session, "--scenario", "rest"}, kUsage, "--scenario");
  expectFailure({"play", path("none.viscera")}, kNoInput, "none.viscera");
  write("empty.viscera", {}, {});
  expectFailure({"play", path("empty.viscera")}, kUsage, "It moves no organ");
}

} // namespace viscera::app::cli
