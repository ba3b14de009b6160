#include "play_fixture.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QImage>
#include <QPixmap>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>

#include <functional>
#include <limits>
#include <vector>

#include "cli/session_input.h"
#include "viscera/circulation/curves.h"
#include "viscera/circulation/scenario.h"
#include "viscera/document/circulation_commands.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/heart/cardiac_times.h"
#include "viscera/heart/course_heartbeat.h"
#include "window/circulation/circulation_panel.h"
#include "window/circulation/numbers_table.h"
#include "window/session/session_files.h"
#include "window/style/language.h"
#include "window/timeline/volume_panel.h"

namespace viscera::tests {
namespace {

using circulation::Compartment;

/// The sample heart in Play mode, whatever moves it.
class PlayedCirculation : public PlayMode {
protected:
  const app::CirculationModel& model() { return parts().circulation(); }
  const heart::CourseHeartbeat* course() {
    return dynamic_cast<const heart::CourseHeartbeat*>(window().playback().sequence());
  }
  void press(const QString& name) {
    auto* button = window().findChild<QAbstractButton*>(name);
    ASSERT_NE(button, nullptr) << name.toStdString();
    button->click();
  }
  /// Whether the heart follows what the document has chosen.
  bool follows() {
    return model().settled() && model().present() && course() &&
           model().present()->parameters == document().circulation().parameters &&
           std::abs(course()->standardRatePerMinute() - model().present()->parameters.rate) < 1e-9;
  }
  bool settled() {
    return waitUntil([this] { return follows(); });
  }
  /// The sample of a solved beat at a part of the beat that is played.
  static std::size_t sampleAt(const app::CirculationModel::Shown& shown, double fraction) {
    const std::size_t count = shown.beat.time.size() - 1;
    return (circulation::firstDrawn(shown.parameters, shown.beat, heart::kBeforeAtria) +
            static_cast<std::size_t>(std::lround(fraction * static_cast<double>(count)))) %
           count;
  }
  /// That curves, marks and the heart that is drawn are of one circulation, or that there is none.
  void expectOne(const char* when) {
    const auto* present = model().present();
    ASSERT_EQ(present == nullptr, course() == nullptr) << when;
    if (!present)
      return;
    EXPECT_EQ(course()->name().english(), "Heartbeat: " + present->name.english()) << when;
    EXPECT_NEAR(course()->standardRatePerMinute(), present->parameters.rate, 1e-9) << when;
    const live::Player& player = window().playback().player();
    if (!player.showing() || !player.runner().obstacle().empty())
      return;
    const circulation::Beat& beat = present->beat;
    const std::size_t sample = sampleAt(*present, player.fraction());
    EXPECT_NEAR(volumeOf("LV"), beat.volumeOf(Compartment::lv)[sample], 4) << when;
  }
  /// Plays on until that is so.
  void playUntil(const char* when, const std::function<bool()>& done) {
    EXPECT_TRUE(waitUntil([&] {
      now_ += 0.02;
      window().playback().advance();
      expectOne(when);
      return HasFailure() || done();
    })) << when;
  }
  void choose(const char* scenario) {
    press(QStringLiteral("scenario.%1").arg(QLatin1String(scenario)));
    ASSERT_TRUE(settled()) << message().toStdString();
  }
  /// How far the cavities are from the circulation's volumes at a place of the beat, ml.
  double off(double fraction) {
    window().playback().seek(fraction);
    settle();
    const circulation::Beat& beat = model().present()->beat;
    const std::size_t sample = sampleAt(*model().present(), fraction);
    return std::max(std::abs(volumeOf("LV") - beat.volumeOf(Compartment::lv)[sample]),
                    std::abs(volumeOf("RV") - beat.volumeOf(Compartment::rv)[sample]));
  }
  QString cell(int row, int column) {
    return window().findChild<QTableWidget*>(QStringLiteral("circulationNumbers"))->item(row, column)->text();
  }
};

/// Beside the textbook's beat, too, and drawn as buttons.
TEST_F(PlayedCirculation, ScenariosAreButtonsThatAreAlwaysThere) {
  ASSERT_FALSE(model().on());
  for (const circulation::Scenario& scenario : circulation::scenarios()) {
    const auto* button = window().findChild<QAbstractButton*>(
        QStringLiteral("scenario.%1").arg(QString::fromStdString(scenario.id)));
    ASSERT_NE(button, nullptr) << scenario.id;
    EXPECT_TRUE(button->isVisibleTo(window().findChild<QWidget*>(QStringLiteral("circulationBox"))))
        << scenario.id;
    EXPECT_TRUE(button->property("raised").toBool()) << scenario.id;
    EXPECT_FALSE(button->isChecked()) << scenario.id;
  }
}

TEST_F(PlayedCirculation, AClickOnAScenarioLetsTheHeartFollowItAndUndoGivesTheTextbookBack) {
  const sequences::Sequence* textbook = window().playback().sequence();
  choose("exercise");
  EXPECT_TRUE(window().playback().player().playing());
  EXPECT_NEAR(window().playback().player().ratePerMinute(), 150, 1e-9);
  const auto& rate = find<QSpinBox>("rate");
  EXPECT_FALSE(rate.isEnabled());
  EXPECT_TRUE(rate.toolTip().contains(QStringLiteral("circulation"))) << rate.toolTip().toStdString();
  window().playback().pause();
  for (const double fraction : {0.1, 0.35, 0.8})
    EXPECT_LT(off(fraction), 1) << fraction;
  EXPECT_EQ(window().workspace().undo().undoName().english(), "Circulation: Exercise");
  window().workspace().undo().undo();
  EXPECT_TRUE(waitUntil([&] { return window().playback().sequence() == textbook; }));
  EXPECT_EQ(model().present(), nullptr);
  EXPECT_TRUE(rate.isEnabled());
  window().workspace().undo().redo();
  EXPECT_TRUE(settled());
}

TEST_F(PlayedCirculation, AControlMovesTheHeartWhichGoesOnFromItsInstant) {
  choose("rest");
  window().playback().pause();
  window().playback().seek(0.3);
  auto* slider =
      window().findChild<QWidget*>(QStringLiteral("circulation.stressedVolume"))->findChild<QSlider*>();
  ASSERT_NE(slider, nullptr);
  const double before = model().present()->indices.of(Compartment::lv).edvMl;
  for (int step = 0; step < 10; ++step)
    slider->setValue(slider->value() - 3);
  ASSERT_TRUE(settled());
  EXPECT_LT(model().present()->indices.of(Compartment::lv).edvMl, before - 15) << "less preload";
  EXPECT_NEAR(window().playback().player().fraction(), 0.3, 1e-9);
  EXPECT_TRUE(window().playback().showing());
  EXPECT_LT(off(0.3), 1);
}

TEST_F(PlayedCirculation, CurvesAndHeartAreOfOneCirculationHoweverQuicklyChoicesFollowEachOther) {
  window().playback().play();
  const auto take = [this](const char* scenario) {
    ASSERT_TRUE(window().workspace().perform(document::chooseScenario(scenario)));
  };
  take("rest");
  playUntil("the first circulation", [this] { return follows(); });
  for (const char* scenario : {"exercise", "haemorrhage", "hypertension", "heart-failure-reduced-ef"})
    take(scenario);
  playUntil("four choices", [this] { return follows(); });
  document::UndoStack& stack = window().workspace().undo();
  for (int step = 0; step < 3; ++step) {
    stack.undo();
    playUntil("between undos", [passes = 0]() mutable { return ++passes > 3; });
  }
  playUntil("three undos", [this] { return follows(); });
  for (int step = 0; step < 2; ++step) {
    stack.undo();
    playUntil("between undos", [passes = 0]() mutable { return ++passes > 3; });
  }
  playUntil("five undos", [this] { return !model().present() && !course() && model().settled(); });
  for (int step = 0; step < 5; ++step)
    stack.redo();
  playUntil("five redos", [this] { return follows(); });
}

TEST_F(PlayedCirculation, MarksStandInTheCurvesOnlyWhileTheirBeatIsPlayed) {
  choose("rest");
  const auto* panel = window().findChild<app::CirculationPanel*>();
  const auto* cursor = panel->findChild<app::ChartCursor*>();
  ASSERT_NE(cursor, nullptr);
  window().playback().pause();
  window().playback().seek(0.2);
  ASSERT_TRUE(waitUntil([&] { return !cursor->marks().rings.empty(); }));
  for (const double seconds : {0.0, 0.8}) {
    Points pose = document().pose();
    pose.row(0) += Vec3(4, 0, 0).transpose();
    ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
    ASSERT_TRUE(window().workspace().perform(document::recordKey(seconds)));
  }
  settle();
  window().playback().choose(parts().keySequence().sequence());
  window().playback().seek(0.4);
  EXPECT_TRUE(panel->isVisible());
  EXPECT_TRUE(cursor->marks().rings.empty()) << "the key sequence has other instants";
}

TEST_F(PlayedCirculation, NeitherSourceIsMarkedWhileARecordedMotionIsPlayed) {
  auto& textbook = find<QAbstractButton>("textbookBeat");
  auto& circulation = find<QAbstractButton>("circulationBeat");
  EXPECT_TRUE(textbook.isChecked());
  for (const double seconds : {0.0, 0.8}) {
    Points pose = document().pose();
    pose.row(0) += Vec3(4, 0, 0).transpose();
    ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
    ASSERT_TRUE(window().workspace().perform(document::recordKey(seconds)));
  }
  settle();
  window().playback().choose(parts().keySequence().sequence());
  ASSERT_EQ(window().playback().sequence()->id(), "keyframes");
  EXPECT_FALSE(textbook.isChecked() || circulation.isChecked());
  textbook.click();
  EXPECT_EQ(window().playback().sequence()->id(), "heartbeat") << "a click chooses that beat";
  EXPECT_TRUE(textbook.isChecked());
  EXPECT_FALSE(circulation.isChecked());
  window().playback().choose(parts().keySequence().sequence());
  EXPECT_FALSE(textbook.isChecked() || circulation.isChecked());
  circulation.click();
  ASSERT_TRUE(settled()) << message().toStdString();
  EXPECT_TRUE(circulation.isChecked());
  EXPECT_FALSE(textbook.isChecked());
}

TEST_F(PlayedCirculation, NoSourceIsMarkedOfADocumentWithoutAHeart) {
  auto& textbook = find<QAbstractButton>("textbookBeat");
  ASSERT_TRUE(textbook.isChecked());
  std::vector<document::OrganId> all;
  for (const auto& organ : document().organs())
    all.push_back(organ->id);
  ASSERT_TRUE(window().workspace().perform(document::removeOrgans(all)));
  settle();
  EXPECT_FALSE(textbook.isChecked() || find<QAbstractButton>("circulationBeat").isChecked());
  window().workspace().undo().undo();
  settle();
  EXPECT_TRUE(textbook.isChecked());
}

TEST_F(PlayedCirculation, TheHeartFollowsAControlWithTheCurvesAndIsFoundAnewWhenItRests) {
  choose("rest");
  window().playback().pause();
  window().playback().seek(0.3);
  settle();
  auto* slider =
      window().findChild<QWidget*>(QStringLiteral("circulation.stressedVolume"))->findChild<QSlider*>();
  const sequences::Sequence* resting = course();
  const auto* solved = model().present();
  slider->setValue(slider->value() - 3);
  ASSERT_TRUE(waitUntil([&] { return model().present() != solved; }));
  const sequences::Sequence* atOnce = course();
  EXPECT_NE(atOnce, resting) << "curves and heart are told together";
  EXPECT_FALSE(model().settled());
  EXPECT_LT(off(0.3), 1);
  ASSERT_TRUE(settled());
  EXPECT_NE(course(), atOnce);
  EXPECT_LT(off(0.3), 1);
}

TEST(NumbersOfTheCirculation, OfOneVesselHaveDifferentNamesInLittleRoom) {
  const app::InstalledLanguage french(QStringLiteral("fr"));
  app::NumbersTable table;
  table.resize(400, 800);
  table.show();
  QApplication::processEvents();
  const int room = table.fontMetrics().horizontalAdvance(QStringLiteral("Aorte (mmHg)"));
  table.resize(table.width() - (table.columnWidth(0) - room), table.height());
  QApplication::processEvents();
  std::vector<QImage> drawn;
  for (const QTableWidgetItem* item : table.findItems(QStringLiteral("Aorte, "), Qt::MatchStartsWith))
    drawn.push_back(table.viewport()->grab(table.visualItemRect(item)).toImage());
  ASSERT_EQ(drawn.size(), 3u);
  EXPECT_NE(drawn[0], drawn[1]);
  EXPECT_NE(drawn[1], drawn[2]);
  EXPECT_NE(drawn[2], drawn[0]);
}

TEST_F(PlayedCirculation, WhatWasKeptStandsBesideWhatFollows) {
  choose("rest");
  const QString resting = cell(0, 1);
  window().actions()["play.keepBefore"]->trigger();
  choose("heart-failure-reduced-ef");
  ASSERT_TRUE(waitUntil([this] { return model().kept() != nullptr; }));
  EXPECT_EQ(cell(0, 2), resting);
  EXPECT_LT(cell(0, 1).toDouble(), resting.toDouble() - 20) << "the ejection fraction of a failing heart";
  EXPECT_EQ(model().kept()->name.english(), "Rest");
  window().actions()["play.forgetBefore"]->trigger();
  EXPECT_TRUE(waitUntil([this] { return model().kept() == nullptr; }));
}

TEST_F(PlayedCirculation, TheHeartOfBeforeBeatsInTheSecondViewAtItsOwnRate) {
  choose("rest");
  window().actions()["play.keepBefore"]->trigger();
  choose("exercise");
  ASSERT_TRUE(waitUntil([this] { return model().keptBeat() != nullptr; }));
  window().actions()["play.compare"]->trigger();
  settle();
  app::Playback& second = parts().comparison().playback();
  EXPECT_EQ(second.sequence(), model().keptBeat().get());
  EXPECT_NEAR(second.player().ratePerMinute(), 72, 1e-9);
  window().playback().pause();
  window().playback().seek(0);
  settle();
  EXPECT_NEAR(volumeIn(parts().comparison().workspace(), "LV"),
              model().kept()->beat.volumeOf(Compartment::lv)[sampleAt(*model().kept(), 0)], 1);
  choose("haemorrhage");
  EXPECT_EQ(second.sequence(), model().keptBeat().get()) << "what was before stays";
}

TEST_F(PlayedCirculation, ItsCurvesStandBelowTheViewUnlessVolumesAreWanted) {
  auto* curves = window().findChild<app::CirculationPanel*>();
  auto* volumes = window().findChild<app::VolumePanel*>();
  EXPECT_FALSE(curves->isVisible()) << "the textbook's beat has no pressures";
  choose("rest");
  EXPECT_TRUE(curves->isVisible());
  key(Qt::Key_P);
  EXPECT_TRUE(volumes->isVisible());
  EXPECT_FALSE(curves->isVisible());
  key(Qt::Key_P);
  key(Qt::Key_1);
  EXPECT_FALSE(curves->isVisible()) << "another mode";
}

TEST_F(PlayedCirculation, WhatCannotRepeatItselfIsSaidAndTheHeartStaysAsItWas) {
  choose("tamponade");
  const sequences::Sequence* followed = window().playback().sequence();
  ASSERT_TRUE(window().workspace().perform(document::setCirculationParameter("pericardialFluid", 600)));
  ASSERT_TRUE(waitUntil([this] { return !model().failureReason().isEmpty() && model().settled(); }));
  EXPECT_EQ(window().playback().sequence(), followed);
  window().workspace().undo().undo();
  EXPECT_TRUE(waitUntil([this] { return model().failureReason().isEmpty(); }));
}

TEST_F(PlayedCirculation, ASessionComesBackWithTheHeartThatFollows) {
  choose("hypertension");
  window().playback().pause();
  window().playback().seek(0.25);
  const double volume = volumeOf("LV");
  const QString file = path(QStringLiteral("lesson.viscera"));
  bool saved = false;
  window().sessions().saveTo(file, false, [&] { saved = true; });
  ASSERT_TRUE(waitUntil([&] { return saved; })) << message().toStdString();
  reopenWindow();
  open(file);
  ASSERT_TRUE(settled()) << message().toStdString();
  EXPECT_EQ(document().circulation().scenario, "hypertension");
  EXPECT_NEAR(window().playback().player().fraction(), 0.25, 1e-6);
  EXPECT_TRUE(waitUntil([&] { return std::abs(volumeOf("LV") - volume) < 0.1; }));
  EXPECT_FALSE(window().isWindowModified());
}

/// The sample heart's surfaces with a motion that is nobody's recipe stand for a patient's.
TEST_F(PlayedCirculation, OfAPatientsHeartHasItsVentricleAndLeavesItItsMotion) {
  auto* button = window().findChild<QAbstractButton*>(QStringLiteral("patientCirculation"));
  ASSERT_NE(button, nullptr);
  EXPECT_TRUE(button->isHidden()) << "the sample heart follows a circulation itself";
  const auto own = window().playback().motion();
  window().playback().forget(own.sequence.get());
  window().playback().setSequence(own.sequence, own.organ);
  ASSERT_TRUE(waitUntil([&] { return !button->isHidden(); })) << message().toStdString();
  button->click();
  ASSERT_TRUE(waitUntil([this] { return model().settled() && model().present(); }))
      << message().toStdString();
  const circulation::ChamberIndices& lv = model().present()->indices.of(Compartment::lv);
  EXPECT_NEAR(lv.edvMl, 130.5, 1);
  EXPECT_NEAR(lv.ef, 0.579, 0.005);
  EXPECT_EQ(window().playback().sequence(), own.sequence.get());
  EXPECT_EQ(window().workspace().undo().undoName().english(), "Circulation of this heart");
  EXPECT_EQ(model().present()->name.english(), "Fitted circulation");
  EXPECT_FALSE(window().findChild<QAbstractButton*>(QStringLiteral("scenario.rest"))->isChecked());
}

TEST_F(PlayedCirculation, TheCommandsMoveTheHeartOfASavedSessionAsTheWindowDoes) {
  choose("exercise");
  const presentation::ViewState view = presentation::viewFromJson(window().sessions().contents().view);
  const coordinates::Registry systems = coordinates::builtInRegistry();
  const sample_organs::SampleLibrary library = sample_organs::standardLibrary();
  Progress progress;
  app::cli::CommandContext context{progress, {}, library, systems};
  const auto sequence = app::cli::sequenceOf(document().state(), view, context);
  ASSERT_TRUE(sequence);
  const double rate = course()->standardRatePerMinute();
  EXPECT_NEAR(sequence->standardRatePerMinute(), rate, 1e-9);
  Points shown, commanded;
  course()->poseAt(0.3 * 60 / rate, rate, shown);
  sequence->poseAt(0.3 * 60 / rate, rate, commanded);
  EXPECT_LT((shown - commanded).rowwise().norm().maxCoeff(), 1e-3);
}

TEST_F(PlayedCirculation, NormalRangesHaveTheNumbersOfTheLanguage) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  EXPECT_EQ(app::normalText({1.5, 8, {}}, 1), QStringLiteral("1.5\u20138.0"));
  EXPECT_EQ(app::normalText({60, kNone, {}}, 0), QStringLiteral("from 60"));
  EXPECT_EQ(app::normalText({-kNone, 5, {}}, 0), QStringLiteral("up to 5"));
}

} // namespace
} // namespace viscera::tests
