#include "window_test.h"

#include <algorithm>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "build_paths.h"
#include "temporary_folder.h"
#include "viscera/document/autosave.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "window/export/export_actions.h"
#include "window/import/file_actions.h"
#include "window/lecture/slides.h"
#include "window/session/session_files.h"
#include "window/stress/stress_mode.h"
#include "window/widgets/new_file.h"

namespace viscera::tests {
namespace {

using Answer = app::SessionFiles::Answer;

class SessionTest : public WindowTest {
protected:
  app::SessionFiles& sessions() { return window().sessions(); }
  /// Whether the message has such a button.
  bool offered(const QString& what) {
    const auto buttons = window().viewArea().messages()->findChildren<QAbstractButton*>();
    return std::any_of(buttons.begin(), buttons.end(),
                       [&](const QAbstractButton* button) { return button->text() == what; });
  }
  document::UndoStack& undo() { return window().workspace().undo(); }

  void save(const QString& file, bool embed = false) {
    bool done = false;
    sessions().saveTo(file, embed, [&] { done = true; });
    ASSERT_TRUE(waitUntil([&] { return done; })) << message().toStdString();
  }

  /// A posed ball in Deform mode, seen from above on the left.
  void work() {
    open(sphereFile());
    Points pose = document().pose();
    pose(0, 0) += 7.1;
    ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
    ASSERT_TRUE(window().workspace().perform(document::recordKey(0.5)));
    window().setMode("deform");
    view().view().lookFrom(scene::StandardView::left);
    camera()->Azimuth(21);
    camera()->Dolly(1.3);
    settle();
  }

  vtkCamera* camera() { return view().view().renderer()->GetActiveCamera(); }

  /// The answer to "Save changes?", and how often it was asked.
  void answer(Answer answer) {
    sessions().setQuestion([this, answer](const QString&) {
      ++asked_;
      return answer;
    });
  }

  int asked_ = 0;
};

TEST_F(SessionTest, SavedAndOpenedInAnotherWindowIsTheSameDocumentModeAndCamera) {
  work();
  window().actions()["view.ghost"]->setChecked(true);
  key(Qt::Key_M); // The sagittal mirror.
  window().workspace().selection().setHandles({document().rig().handles[3].id});
  save(path(QStringLiteral("work.viscera")));
  const document::DocumentState state = document().state();
  double position[3], up[3];
  camera()->GetPosition(position);
  camera()->GetViewUp(up);
  EXPECT_FALSE(window().isWindowModified());
  EXPECT_TRUE(window().windowTitle().startsWith(QStringLiteral("work.viscera")));

  reopenWindow();
  open(path(QStringLiteral("work.viscera")));
  EXPECT_TRUE(document::identical(document().state(), state));
  EXPECT_EQ(window().mode(), "deform");
  EXPECT_TRUE(window().actions()["view.ghost"]->isChecked());
  EXPECT_TRUE(view().view().mirrorPlane().visible());
  EXPECT_EQ(window().workspace().selection().currentHandle(), document().rig().handles[3].id);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(camera()->GetPosition()[k], position[k]) << k;
    EXPECT_EQ(camera()->GetViewUp()[k], up[k]) << k;
  }
  EXPECT_FALSE(window().isWindowModified());
  EXPECT_EQ(window().workspace().live().shownPose(), document().pose());
}

/// Its legend comes when the stress is there, after the first frames.
TEST_F(SessionTest, OpenedInStressHasTheCameraThatItHad) {
  const auto hasLegend = [this] { return view().view().legend().visible(); };
  open(sphereFile());
  window().setMode("stress");
  ASSERT_TRUE(waitUntil(hasLegend));
  settle();
  view().view().lookFrom(scene::StandardView::anterior);
  camera()->Dolly(1.12); // The ball is in the view, and partly behind the legend.
  view().scheduleRender();
  settle();
  const Vec3 eye(camera()->GetPosition());
  save(path(QStringLiteral("stress.viscera")));
  reopenWindow();
  open(path(QStringLiteral("stress.viscera")));
  ASSERT_TRUE(waitUntil(hasLegend));
  settle();
  EXPECT_EQ(Vec3(camera()->GetPosition()), eye);
}

class SessionWithAProbe : public SessionTest {
protected:
  static constexpr int kPoint = 12;

  app::StressModel& model() { return window().stress().model(); }
  QString file() const { return path(QStringLiteral("probe.viscera")); }

  /// Saves two balls in a mode, with a probe in the second.
  void saveIn(const std::string& mode) {
    open(sphereFile());
    open(sphereFile(QStringLiteral("second.stl"), 40));
    window().workspace().selection().setOrgan(document().organs()[1]->id);
    model().change([](app::StressLook& look) { look.witnesses = 600; });
    enter();
    model().setProbe(kPoint);
    window().setMode(mode);
    save(file());
  }
  void enter() {
    window().setMode("stress");
    ASSERT_TRUE(waitUntil([this] { return model().shown().ready(); })) << message().toStdString();
    settle();
  }
};

TEST_F(SessionWithAProbe, ShowsItAgainAndOnlyWhereItWas) {
  saveIn("stress");
  for (int again = 0; again < 2; ++again) { // The second time it replaces the same session.
    if (again == 0)
      reopenWindow();
    open(file());
    enter();
    EXPECT_EQ(model().probe(), kPoint);
    EXPECT_TRUE(find<QWidget>("probePlace").isVisible());
  }
  model().change([](app::StressLook& look) { look.witnesses = 800; });
  ASSERT_TRUE(waitUntil([this] { return model().probe() < 0; })) << "it was a point of the other mesh";
}

TEST_F(SessionWithAProbe, ThatOpensInAnotherModeShowsItThereWhenStressIsEntered) {
  saveIn("explore");
  reopenWindow();
  open(file());
  EXPECT_EQ(model().probe(), kPoint);
  enter();
  EXPECT_EQ(model().probe(), kPoint);
}

TEST_F(SessionWithAProbe, ForgetsItWhenAnotherOrganIsChosenFirst) {
  saveIn("explore");
  reopenWindow();
  open(file());
  window().workspace().selection().setOrgan(document().organs()[0]->id);
  enter();
  EXPECT_EQ(model().probe(), -1);
}

TEST_F(SessionTest, SavedTwiceWithoutAChangeIsTheSameFile) {
  work();
  save(path(QStringLiteral("a.viscera")), true);
  open(path(QStringLiteral("a.viscera")));
  save(path(QStringLiteral("b.viscera")), true);
  EXPECT_EQ(contentsOf(path(QStringLiteral("a.viscera")).toStdString()),
            contentsOf(path(QStringLiteral("b.viscera")).toStdString()));
}

TEST_F(SessionTest, CtrlSSavesToTheSessionsFileAgain) {
  work();
  save(path(QStringLiteral("work.viscera")));
  ASSERT_TRUE(window().workspace().perform(document::resetPose()));
  EXPECT_TRUE(window().isWindowModified());
  key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([this] { return !window().isWindowModified(); }));
  undo().undo();
  EXPECT_TRUE(window().isWindowModified());
  undo().redo();
  EXPECT_FALSE(window().isWindowModified()) << "undo led back to what was saved";
}

TEST_F(SessionTest, CancelKeepsTheWindowAndTheWork) {
  work();
  answer(Answer::cancel);
  const document::DocumentState state = document().state();
  EXPECT_FALSE(window().close());
  open(path(QStringLiteral("other.viscera")));
  sessions().begin();
  EXPECT_EQ(asked_, 3);
  EXPECT_TRUE(document().state() == state);
  EXPECT_TRUE(window().isVisible());
}

TEST_F(SessionTest, SaveBeforeClosingSavesAndCloses) {
  work();
  save(path(QStringLiteral("work.viscera")));
  ASSERT_TRUE(window().workspace().perform(document::resetPose()));
  const document::DocumentState state = document().state();
  answer(Answer::save);
  window().close();
  ASSERT_TRUE(waitUntil([this] { return !window().isVisible(); }));
  EXPECT_EQ(asked_, 1);
  reopenWindow();
  open(path(QStringLiteral("work.viscera")));
  EXPECT_TRUE(document::identical(document().state(), state));
}

TEST_F(SessionTest, NothingIsAskedWhenNothingIsLost) {
  answer(Answer::cancel);
  EXPECT_TRUE(window().close());
  EXPECT_EQ(asked_, 0);
}

TEST_F(SessionTest, ASaveThatFailsSaysSoAndTheWorkStaysUnsaved) {
  work();
  bool done = false;
  sessions().saveTo(path(QStringLiteral("nowhere/work.viscera")), false, [&] { done = true; });
  ASSERT_TRUE(waitUntil([this] { return message().contains(QStringLiteral("work.viscera")); }));
  EXPECT_FALSE(done);
  EXPECT_TRUE(window().isWindowModified());
}

TEST_F(SessionTest, ADamagedSessionSaysOneThingAndLeavesTheDocument) {
  work();
  answer(Answer::discard);
  const document::DocumentState state = document().state();
  QFile file(path(QStringLiteral("bad.viscera")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"format\": \"viscera-session\", \"version\": 1, ");
  file.close();
  open(file.fileName());
  EXPECT_TRUE(message().contains(QStringLiteral("bad.viscera"))) << message().toStdString();
  EXPECT_TRUE(document().state() == state);
}

TEST_F(SessionTest, WhereAllFilesAreMissingTheyAreNamedAndLookedForInAFolder) {
  work();
  save(path(QStringLiteral("work.viscera")));
  ASSERT_TRUE(QDir().mkpath(path(QStringLiteral("away/deeper"))));
  ASSERT_TRUE(QFile::rename(path(QStringLiteral("ball.stl")), path(QStringLiteral("away/deeper/ball.stl"))));
  reopenWindow();
  open(path(QStringLiteral("work.viscera")));
  EXPECT_TRUE(document().organs().empty());
  EXPECT_TRUE(message().contains(path(QStringLiteral("ball.stl")))) << message().toStdString();
  EXPECT_TRUE(offered(QStringLiteral("Look for files...")));
  sessions().open(path(QStringLiteral("work.viscera")), path(QStringLiteral("away/deeper")));
  ASSERT_TRUE(waitUntil([this] { return document().organs().size() == 1; })) << message().toStdString();
  EXPECT_EQ(document().organs().front()->name, "ball");
}

TEST_F(SessionTest, AScanThatIsNotThereIsLookedForToo) {
  document::SessionContents contents = sessions().contents();
  contents.missingScan = {{"name", "CT"}, {"relative", "ct.nii"}, {"absolute", "/nowhere/ct.nii"}};
  Progress quiet;
  document::writeSession(path(QStringLiteral("work.viscera")).toStdString(), contents, quiet);
  open(path(QStringLiteral("work.viscera")));
  EXPECT_TRUE(message().contains(QStringLiteral("ct.nii"))) << message().toStdString();
  EXPECT_TRUE(offered(QStringLiteral("Look for files...")));
}

TEST_F(SessionTest, FilesThatAreNotThereAreAllNamed) {
  const QString first = path(QStringLiteral("gone.stl")), second = path(QStringLiteral("lost.vtp"));
  window().files().open({first, second});
  ASSERT_TRUE(waitUntil([&] { return message().contains(first); })) << message().toStdString();
  EXPECT_TRUE(message().contains(second)) << message().toStdString();
  EXPECT_TRUE(offered(QStringLiteral("Look for files...")));
}

TEST_F(SessionTest, AVanishedOrganIsNamedAndTheRestOpens) {
  work();
  save(path(QStringLiteral("work.viscera")));
  QFile::remove(path(QStringLiteral("ball.stl")));
  reopenWindow();
  open(path(QStringLiteral("work.viscera")));
  EXPECT_TRUE(message().contains(QStringLiteral("ball.stl"))) << message().toStdString();
  EXPECT_TRUE(document().organs().empty());
  EXPECT_EQ(document().rig().handles.size(), 30u);
}

TEST_F(SessionTest, ASessionIsAmongTheRecentFiles) {
  work();
  save(path(QStringLiteral("work.viscera")));
  bool listed = false;
  for (const QAction* action : window().findChildren<QAction*>())
    listed = listed || action->text() == QStringLiteral("work.viscera");
  EXPECT_TRUE(listed);
}

TEST_F(SessionTest, ASampleAtItsInstantComesBackPlayingThere) {
  window().samples().load(QStringLiteral("heart"), false);
  ASSERT_TRUE(waitUntil([this] { return window().playback().sequence() != nullptr; }));
  settle();
  EXPECT_FALSE(window().isWindowModified()) << "a sample by itself is no work";
  window().setMode("play");
  window().playback().setRate(90);
  window().playback().seek(1.0 / 3);
  const Points pose = window().workspace().live().shownPose();
  save(path(QStringLiteral("beat.viscera")));
  reopenWindow();
  open(path(QStringLiteral("beat.viscera")));
  ASSERT_TRUE(waitUntil([this] { return window().playback().showing(); }));
  EXPECT_EQ(window().playback().player().ratePerMinute(), 90);
  EXPECT_EQ(window().workspace().live().shownPose(), pose);
  EXPECT_EQ(document().organs().front()->origin.sample, "heart@medium");
}

TEST_F(SessionTest, AnInstantBehindAnotherPoseComesBackThere) {
  window().samples().load(QStringLiteral("heart"), false);
  ASSERT_TRUE(waitUntil([this] { return window().playback().sequence() != nullptr; }));
  settle();
  window().setMode("play");
  window().playback().seek(0.4);
  const Points pose = window().workspace().live().shownPose();
  window().setMode("deform");
  ASSERT_NE(window().workspace().live().shownPose(), pose);
  save(path(QStringLiteral("beat.viscera")));
  reopenWindow();
  open(path(QStringLiteral("beat.viscera")));
  ASSERT_TRUE(waitUntil([this] { return window().playback().sequence() != nullptr; }));
  settle();
  EXPECT_EQ(window().mode(), "deform");
  EXPECT_FALSE(window().playback().showing());
  EXPECT_EQ(window().playback().player().fraction(), 0.4);
  window().setMode("play");
  EXPECT_EQ(window().workspace().live().shownPose(), pose);
}

TEST_F(SessionTest, ASessionOfAnOlderMotionShowsTheOneOfTodayAndSaysSo) {
  open(QStringLiteral(VISCERA_SOURCE_DIR "/tests/gui/sessions/play_peristalsis_light.viscera"));
  ASSERT_TRUE(waitUntil([this] { return window().playback().showing(); })) << message().toStdString();
  EXPECT_NEAR(window().playback().player().fraction(), 0.6, 1e-9);
  EXPECT_TRUE(message().contains(QStringLiteral("differently"))) << message().toStdString();
}

TEST_F(SessionTest, UnsavedWorkIsOfferedAfterACrashAndComesBackUnsaved) {
  const auto folder = std::filesystem::path(path(QStringLiteral("state")).toStdString());
  work();
  const document::DocumentState state = document().state();
  {
    // Another program that worked on this and was killed: its lock is gone, its file is not.
    ManualEventLoop box;
    document::Autosave killed(folder, box.post(), [] { return 0.0; });
    document::SessionContents contents = sessions().contents();
    contents.recovers = path(QStringLiteral("work.viscera")).toStdString();
    bool written = false;
    killed.write(contents, [&](const auto& error) {
      EXPECT_EQ(error, nullptr);
      written = true;
    });
    box.runUntil([&] { return written; });
  }
  reopenWindow();
  sessions().startAutosave(folder);
  sessions().offerRecovery();
  EXPECT_TRUE(message().contains(QStringLiteral("without saving"))) << message().toStdString();
  EXPECT_TRUE(window().actions()["file.recover"]->isEnabled());
  QMetaObject::invokeMethod(window().viewArea().messages()->findChild<QWidget*>(QStringLiteral("offer")),
                            "click");
  settle();
  EXPECT_TRUE(document::identical(document().state(), state));
  EXPECT_TRUE(window().isWindowModified());
  EXPECT_EQ(sessions().name(), QStringLiteral("work.viscera"));
  EXPECT_FALSE(std::filesystem::is_empty(folder)) << "until it is saved it is kept";
  save(path(QStringLiteral("work.viscera")));
  EXPECT_TRUE(waitUntil([&] { return std::filesystem::is_empty(folder); }));
}

TEST_F(SessionTest, WorkIsKeptWhileItIsDoneAndGoneAfterACleanEnd) {
  const auto folder = std::filesystem::path(path(QStringLiteral("state")).toStdString());
  sessions().startAutosave(folder, 0.1);
  work();
  const auto kept = [&] {
    if (std::filesystem::exists(folder))
      for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".viscera" && !entry.path().filename().string().starts_with('.'))
          return true;
    return false;
  };
  EXPECT_TRUE(waitUntil(kept));
  EXPECT_TRUE(document::findRecoveries(folder).empty()) << "this program is still running";
  answer(Answer::discard);
  EXPECT_TRUE(window().close());
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(SessionTest, TheListOfStepsGoesToAnyOfThem) {
  work();
  const auto names = undo().names();
  ASSERT_GE(names.size(), 3u);
  QMenu* history = nullptr;
  for (QMenu* menu : window().findChildren<QMenu*>())
    if (menu->title() == QStringLiteral("&Steps"))
      history = menu;
  ASSERT_NE(history, nullptr);
  Q_EMIT history->aboutToShow();
  ASSERT_EQ(history->actions().size(), static_cast<int>(names.size()) + 1);
  EXPECT_EQ(history->actions().front()->text().toStdString(), names.back().english());
  EXPECT_TRUE(history->actions().front()->isChecked());
  history->actions().back()->trigger();
  EXPECT_EQ(undo().position(), 0u);
  EXPECT_TRUE(document().organs().empty());
  Q_EMIT history->aboutToShow();
  history->actions().front()->trigger();
  EXPECT_EQ(undo().position(), names.size());
}

TEST_F(SessionTest, NoneIsOpenedBesideAnotherOrgan) {
  work();
  save(path(QStringLiteral("work.viscera")));
  window().files().open({path(QStringLiteral("work.viscera")), path(QStringLiteral("ball.stl"))});
  settle();
  EXPECT_TRUE(message().contains(QStringLiteral("work.viscera"))) << message().toStdString();
  EXPECT_EQ(document().organs().size(), 2u) << "the ball that was there, and the one that was opened";
}

TEST_F(SessionTest, ASaveThatEndsAfterTheSessionIsNoFileOfTheNextOne) {
  work();
  answer(Answer::discard);
  bool followed = false;
  sessions().saveTo(path(QStringLiteral("first.viscera")), false, [&] { followed = true; });
  sessions().begin();
  ASSERT_TRUE(waitUntil([this] { return message().contains(QStringLiteral("first.viscera")); }));
  EXPECT_FALSE(followed);
  EXPECT_EQ(sessions().file(), QString()) << "the next save would write over the other patient's";
  EXPECT_TRUE(QFile::exists(path(QStringLiteral("first.viscera"))));
}

TEST_F(SessionTest, WorkThatWasDoneWhileAnotherSessionWasReadIsAskedAbout) {
  work();
  save(path(QStringLiteral("work.viscera")));
  answer(Answer::cancel);
  sessions().open(path(QStringLiteral("work.viscera")));
  EXPECT_EQ(asked_, 0) << "nothing is lost yet";
  ASSERT_TRUE(window().workspace().perform(document::resetPose()));
  const document::DocumentState state = document().state();
  ASSERT_TRUE(waitUntil([this] { return asked_ == 1; }));
  settle();
  EXPECT_TRUE(document().state() == state);
}

TEST_F(SessionTest, SlidesAreWorkThatIsSavedAndBelongToTheirSession) {
  work();
  save(path(QStringLiteral("work.viscera")));
  ASSERT_FALSE(window().isWindowModified());
  window().slides().add();
  EXPECT_TRUE(window().isWindowModified());
  save(path(QStringLiteral("work.viscera")));
  EXPECT_FALSE(window().isWindowModified());
  window().slides().rename(0, QStringLiteral("From the left"));
  EXPECT_TRUE(window().isWindowModified());
  window().viewModel().change([](presentation::ViewState& state) { state.cut.on = true; });
  answer(Answer::discard);
  sessions().begin();
  EXPECT_TRUE(window().slides().all().empty());
  EXPECT_FALSE(window().viewModel().state().cut.on);
  EXPECT_FALSE(window().isWindowModified());
  open(path(QStringLiteral("work.viscera")));
  EXPECT_EQ(window().slides().all().size(), 1u);
  EXPECT_FALSE(window().isWindowModified());
}

TEST_F(SessionTest, OffersOfTheDocumentBeforeAreGone) {
  window().workspace().say({app::Message::Severity::warning, QStringLiteral("Of before"), {}, 0});
  sessions().begin();
  EXPECT_EQ(message(), QString());
}

TEST_F(SessionTest, AnExportThatIsNotDoneIsAskedAboutBeforeTheWindowCloses) {
  work();
  answer(Answer::discard);
  QStringList named;
  bool leave = false;
  window().setUnwrittenQuestion([&](const QStringList& names) {
    named = names;
    return leave;
  });
  window().exports().exportOrgans(path(QStringLiteral("all.glb")));
  window().exports().exportTable(path(QStringLiteral("table.csv")));
  EXPECT_FALSE(window().close());
  EXPECT_EQ(named.size(), 2) << "one export does not take the place of another";
  ASSERT_TRUE(waitUntil([this] { return window().workspace().writing().isEmpty(); }));
  EXPECT_TRUE(QFile::exists(path(QStringLiteral("all.glb"))));
  EXPECT_TRUE(QFile::exists(path(QStringLiteral("table.csv"))));
  EXPECT_TRUE(window().close());
}

/// Answers the question that comes next with this button.
void answerNext(QMessageBox::StandardButton button) {
  QTimer::singleShot(0, [button] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    box->button(button)->click();
  });
}

TEST_F(SessionTest, AFileThatGetsItsEndingReplacesNoneUnasked) {
  const QStringList endings{QStringLiteral(".viscera"), QStringLiteral(".other")};
  EXPECT_EQ(app::asNewFile(&window(), {}, endings), QString());
  EXPECT_EQ(app::asNewFile(&window(), QStringLiteral("/a.other"), endings), QStringLiteral("/a.other"));
  const QString chosen = path(QStringLiteral("work"));
  EXPECT_EQ(app::asNewFile(&window(), chosen, endings), chosen + QStringLiteral(".viscera"));
  QFile file(chosen + QStringLiteral(".viscera"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.close();
  answerNext(QMessageBox::No);
  EXPECT_EQ(app::asNewFile(&window(), chosen, endings), QString());
  answerNext(QMessageBox::Yes);
  EXPECT_EQ(app::asNewFile(&window(), chosen, endings), file.fileName());
}

} // namespace
} // namespace viscera::tests
