#include "play_fixture.h"

#include <QAbstractButton>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSet>
#include <QSpinBox>
#include <QTest>

#include <cmath>
#include <optional>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "session_fixture.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/heart/heartbeat.h"
#include "viscera/presentation/presenter.h"
#include "window/compare/side_header.h"
#include "window/style/language.h"
#include "window/widgets/elided_label.h"
#include "window/work/binding_messages.h"

namespace viscera::tests {
namespace {

/// What the left ventricle is to hold then.
double leftMlOf(const heart::CavityHeartbeat& heart, double seconds, double ratePerMinute) {
  return heart.cycle().at(seconds, ratePerMinute).volumes.leftMl;
}

class TwoViews : public PlayMode {
protected:
  void compareRates() {
    key(Qt::Key_2, Qt::ControlModifier);
    ASSERT_TRUE(parts().comparison().on());
    ASSERT_TRUE(waitUntil([this] { return !second().live().busy() && second().jobs().idle(); }));
    settle();
  }
  app::Workspace& second() { return parts().comparison().workspace(); }
  Vec3 sight(app::ViewWidget& view) {
    return Vec3(view.view().renderer()->GetActiveCamera()->GetDirectionOfProjection());
  }
};

/// With views that have all the room of the window.
class TwoFullViews : public TwoViews {
protected:
  std::optional<QSize> viewSize() const override { return std::nullopt; }
  static Vec3 eye(app::ViewWidget& view) {
    return Vec3(view.view().renderer()->GetActiveCamera()->GetPosition());
  }
};

/// What Qt has warned of since the last `begin`.
class QtWarnings {
public:
  static void begin() {
    said().clear();
    before() =
        qInstallMessageHandler([](QtMsgType type, const QMessageLogContext& where, const QString& text) {
          if (type == QtWarningMsg)
            said() << text;
          else if (before())
            before()(type, where, text);
        });
  }
  static QStringList end() {
    qInstallMessageHandler(before());
    return said();
  }

private:
  static QStringList& said() {
    static QStringList list;
    return list;
  }
  static QtMessageHandler& before() {
    static QtMessageHandler handler = nullptr;
    return handler;
  }
};

TEST_F(TwoViews, AViewThatClosesUnderAHeldMouseLeavesNoGestureBehind) {
  constexpr int kLongerThanAHeldTap = 900;
  compareRates();
  QtWarnings::begin();
  app::ViewWidget& other = parts().comparison().view();
  QTest::mousePress(&other, Qt::LeftButton, Qt::NoModifier, QPoint(20, 20));
  parts().comparison().end();
  QTest::qWait(kLongerThanAHeldTap);
  EXPECT_EQ(QtWarnings::end(), QStringList());
}

TEST_F(TwoViews, TheSecondNamesNoSessionsAmongWhatItOpens) {
  QFile file(path(QStringLiteral("notes.qqq")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("some notes");
  file.close();
  parts().comparison().showFiles({file.fileName()});
  ASSERT_TRUE(waitUntil([this] { return message().contains(QStringLiteral("notes.qqq")); }));
  EXPECT_TRUE(message().contains(QStringLiteral(".stl"))) << message().toStdString();
  EXPECT_FALSE(message().contains(QStringLiteral(".viscera")));
}

TEST_F(TwoViews, AnOfferOfTheSecondEndsWithIt) {
  parts().comparison().showFiles({path(QStringLiteral("gone.stl"))});
  ASSERT_TRUE(waitUntil([this] { return message().contains(QStringLiteral("gone.stl")); }));
  ASSERT_TRUE(find<QPushButton>("offer").isVisible());
  parts().comparison().end();
  EXPECT_EQ(message(), QString()) << "its button would look for files for a view that is gone";
}

TEST_F(TwoViews, AnotherOrganStandsBesideTheFirstWithAVolumeOfItsOwn) {
  parts().comparison().showFiles({sphereFile(QStringLiteral("small_ball.stl"), 40)});
  ASSERT_TRUE(waitUntil([this] {
    return !second().document().organs().empty() && second().jobs().idle() && !second().live().busy();
  }));
  settle();
  EXPECT_EQ(document().organs().size(), 5u) << "the first document is as it was";
  EXPECT_EQ(window().workspace().undo().names().size(), 0u);
  const double expected = 4.0 / 3 * M_PI * 40 * 40 * 40 / 1000;
  EXPECT_NEAR(volumeIn(second(), second().document().organs().front()->name), expected, 0.02 * expected);
  const auto headers = window().findChildren<app::SideHeader*>();
  ASSERT_EQ(headers.size(), 2);
  EXPECT_TRUE(waitUntil([&] { return headers[1]->volumes().contains(QStringLiteral("Small ball")); }));
  QStringList titles; // Of names as people write them.
  for (const app::ElidedLabel* label : headers[1]->findChildren<app::ElidedLabel*>())
    titles << label->fullText();
  EXPECT_TRUE(titles.contains(QStringLiteral("Small ball"))) << titles.join('|').toStdString();
  key(Qt::Key_Space);
  playFor(0.2);
  EXPECT_TRUE(window().playback().player().playing()) << "one that does not move holds up nobody";
  auto* close = window().findChild<QAbstractButton*>(QStringLiteral("closeSecond"));
  ASSERT_NE(close, nullptr);
  QTest::mouseClick(close, Qt::LeftButton);
  EXPECT_TRUE(waitUntil([this] { return !parts().comparison().on(); }));
}

TEST_F(TwoViews, TwoSamplesMoveSideBySide) {
  parts().comparison().showSample(QStringLiteral("stomach"));
  ASSERT_TRUE(
      QTest::qWaitFor([this] { return parts().comparison().playback().sequence() != nullptr; }, 120000));
  ASSERT_TRUE(waitUntil([this] { return !second().live().busy() && second().jobs().idle(); }));
  window().playback().toStart();
  key(Qt::Key_Space);
  playFor(0.3);
  EXPECT_TRUE(parts().comparison().playback().player().playing());
  EXPECT_NEAR(parts().comparison().playback().player().playedSeconds(),
              window().playback().player().playedSeconds(), 1e-9);
  // Closing the window while two views play ends both in order.
}

TEST_F(TwoViews, BeatAtTwoRatesUnderOneTimelineAndChart) {
  const auto& monitor = window().volumes();
  const std::size_t alone = monitor.lines().size();
  compareRates();
  const auto* heart = dynamic_cast<const heart::CavityHeartbeat*>(window().playback().sequence());
  ASSERT_NE(heart, nullptr);
  EXPECT_EQ(parts().comparison().playback().player().ratePerMinute(), 150);
  window().playback().toStart();
  key(Qt::Key_Space);
  playFor(0.5);
  key(Qt::Key_Space);
  const double seconds = window().playback().player().secondsInCycle();
  EXPECT_NEAR(volumeOf("LV"), leftMlOf(*heart, seconds, 75), 0.5);
  EXPECT_NEAR(volumeIn(second(), "LV"), leftMlOf(*heart, seconds, 150), 0.5);
  EXPECT_GT(std::abs(volumeOf("LV") - volumeIn(second(), "LV")), 5) << "the same instant of two rates";
  const auto headers = window().findChildren<app::SideHeader*>();
  ASSERT_EQ(headers.size(), 2);
  ASSERT_TRUE(waitUntil([&] { return headers[0]->volumes() != headers[1]->volumes(); }));
  EXPECT_NE(headers[0]->phase(), headers[1]->phase());

  EXPECT_EQ(monitor.lines().size(), 2 * alone);
  key(Qt::Key_Space);
  playFor(1.0);
  const std::size_t left = 1;
  ASSERT_EQ(monitor.lines()[left].name, QStringLiteral("LV cavity"));
  ASSERT_TRUE(waitUntil([&] { return monitor.indices(left) && monitor.indices(left + alone); }));
  EXPECT_NEAR(monitor.indices(left + alone)->cardiacOutputLPerMinute /
                  monitor.indices(left)->cardiacOutputLPerMinute,
              2 * 70.5 / 75.5, 0.02)
      << "nearly the same stroke, twice as often";
  key(Qt::Key_1, Qt::ControlModifier);
  EXPECT_FALSE(parts().comparison().on());
  EXPECT_EQ(monitor.lines().size(), alone);
  EXPECT_TRUE(window().playback().player().playing());
  playFor(0.1);
}

TEST_F(TwoViews, TheSecondKeepsItsRateThroughAnUndoAcrossSequences) {
  compareRates();
  app::Playback& other = parts().comparison().playback();
  find<QSpinBox>("secondRate").setValue(120);
  ASSERT_EQ(other.player().ratePerMinute(), 120);
  loadSample(QStringLiteral("stomach"));
  ASSERT_TRUE(waitUntil([&] { return other.sequence() == window().playback().sequence(); }));
  window().workspace().undo().undo();
  settle();
  ASSERT_EQ(other.sequence(), window().playback().sequence());
  EXPECT_EQ(other.player().ratePerMinute(), 120);
  EXPECT_NE(window().playback().player().ratePerMinute(), 120);
}

TEST_F(TwoViews, AHeaderBeginsWithTheVolumeOfTheChosenOrgan) {
  compareRates();
  const auto begin = [this](int side) {
    settle();
    return window().findChildren<app::SideHeader*>()[side]->volumes().section(QLatin1Char(' '), 0, 1);
  };
  EXPECT_TRUE(begin(0).startsWith(QStringLiteral("LV"))) << begin(0).toStdString();
  for (const auto& organ : document().organs())
    if (organ->name == "RA")
      window().workspace().selection().setOrgan(organ->id);
  EXPECT_TRUE(begin(0).startsWith(QStringLiteral("RA"))) << begin(0).toStdString();
  EXPECT_TRUE(begin(1).startsWith(QStringLiteral("RA"))) << begin(1).toStdString();
}

TEST_F(TwoViews, ANewSessionAndAnotherOneBeginWithOneView) {
  const QString file = path(QStringLiteral("one_view.viscera"));
  bool saved = false;
  window().sessions().saveTo(file, false, [&] { saved = true; });
  ASSERT_TRUE(waitUntil([&] { return saved; })) << message().toStdString();
  compareRates();
  window().playback().play();
  window().sessions().open(file);
  ASSERT_TRUE(waitUntil([this] { return !parts().comparison().on(); })) << message().toStdString();
  compareRates();
  window().actions()["file.new"]->trigger();
  settle();
  EXPECT_TRUE(document().organs().empty());
  EXPECT_FALSE(parts().comparison().on()) << "nothing of the other session is left";
}

/// The volumes take what the title and the phase leave.
TEST_F(TwoViews, AHeaderWithoutRoomCutsItsVolumesFirst) {
  app::SideHeader header(1, nullptr);
  header.resize(420, header.height());
  header.setTitle(QStringLiteral("Heartbeat  75 / min"));
  header.setState(QStringLiteral("ejection"), QStringLiteral("LV cavity 112.4 ml   ").repeated(5));
  header.show();
  QTest::qWait(20);
  for (const auto* label : header.findChildren<app::ElidedLabel*>()) {
    if (label->objectName() != QStringLiteral("sideVolumes")) {
      EXPECT_EQ(label->text(), label->fullText()) << label->fullText().toStdString();
    }
  }
}

TEST_F(TwoViews, HeadersHaveOneShareForEveryPhaseSoThatTitlesStandStill) {
  compareRates();
  for (const app::SideHeader* header : window().findChildren<app::SideHeader*>()) {
    const auto* phase = header->findChild<app::ElidedLabel*>(QStringLiteral("muted"));
    ASSERT_NE(phase, nullptr);
    window().playback().seek(0.95);
    settle();
    const QRect share = phase->geometry();
    QSet<QString> seen;
    for (const double part : {0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7}) {
      window().playback().seek(part);
      handleEvents();
      seen.insert(phase->fullText());
      EXPECT_EQ(phase->geometry(), share) << phase->fullText().toStdString();
    }
    EXPECT_GT(seen.size(), 1);
  }
}

TEST_F(TwoViews, ATitleKeepsItsRoomBesideLongNamesOfPhases) {
  app::SideHeader header(1, nullptr);
  header.setTitle(QStringLiteral("Heartbeat  75 / min"));
  header.setPhases({QStringLiteral("rest"), QStringLiteral("a very long name of a phase").repeated(4)});
  header.resize(320, header.height());
  header.show();
  for (const char* phase : {"rest", "a very long name of a phase"}) {
    header.setState(QLatin1String(phase), QStringLiteral("LV cavity 112.4 ml"));
    QTest::qWait(20);
    for (const auto* label : header.findChildren<app::ElidedLabel*>())
      if (label->fullText().startsWith(QStringLiteral("Heartbeat"))) {
        EXPECT_EQ(label->text(), label->fullText()) << phase;
      }
  }
}

TEST_F(TwoViews, ShowTheInstantThatTheirReadoutsNameAlsoAfterAPauseAnUndoAndAnotherMode) {
  compareRates();
  const auto* heart = dynamic_cast<const heart::CavityHeartbeat*>(window().playback().sequence());
  ASSERT_NE(heart, nullptr);
  const auto expectTrue = [&](const char* when) {
    settle();
    const live::Player& a = window().playback().player();
    const live::Player& b = parts().comparison().playback().player();
    EXPECT_NEAR(volumeOf("LV"), leftMlOf(*heart, a.secondsInCycle(), a.ratePerMinute()), 0.5) << when;
    EXPECT_NEAR(volumeIn(second(), "LV"), leftMlOf(*heart, b.secondsInCycle(), b.ratePerMinute()), 0.5)
        << when;
  };
  key(Qt::Key_Space);
  playFor(0.3);
  now_ += 0.07;
  key(Qt::Key_Space);
  expectTrue("paused between two frames");
  key(Qt::Key_X);
  key(Qt::Key_Z, Qt::ControlModifier);
  expectTrue("after an undo");
  key(Qt::Key_3);
  key(Qt::Key_5);
  expectTrue("after another mode");
  key(Qt::Key_1, Qt::ControlModifier);
  compareRates();
  expectTrue("of a view that was opened while paused");
}

TEST_F(TwoViews, ShareTheInstantTheCamerasAndTheDocument) {
  compareRates();
  auto* rate = window().findChild<QSpinBox*>(QStringLiteral("secondRate"));
  ASSERT_NE(rate, nullptr);
  rate->setValue(50);
  window().playback().seek(0.5);
  EXPECT_NEAR(window().playback().player().secondsInCycle(), 0.4, 1e-9);
  EXPECT_NEAR(parts().comparison().playback().player().secondsInCycle(), 0.4, 1e-9);
  key(Qt::Key_Period);
  EXPECT_NEAR(parts().comparison().playback().player().secondsInCycle(), 0.44, 1e-9);
  EXPECT_FALSE(parts().comparison().playback().player().playing());

  app::ViewWidget& other = parts().comparison().view();
  EXPECT_LT((sight(view()) - sight(other)).norm(), 1e-12);
  const Vec3 before = sight(view());
  const QPoint corner(view().width() - 30, 60);
  drag(corner, corner - QPoint(120, -40));
  EXPECT_GT((sight(view()) - before).norm(), 0.1);
  EXPECT_LT((sight(view()) - sight(other)).norm(), 1e-9);
  key(Qt::Key_X);
  EXPECT_EQ(second().document().organs().front()->look.opacity, document().organs().front()->look.opacity);
  EXPECT_EQ(second().undo().names().size(), 0u) << "only the first document has steps";
}

TEST_F(TwoFullViews, OpenWithTheCameraThatIsThereWhichComesBackWhenOneCloses) {
  for (const double zoom : {1.0, 3.0}) {
    key(Qt::Key_F);
    view().view().renderer()->GetActiveCamera()->Dolly(zoom);
    view().scheduleRender();
    settle();
    const Vec3 before = eye(view());
    compareRates();
    if (zoom > 1) {
      EXPECT_LT((eye(view()) - before).norm(), 1e-9) << "a part of the organ was looked at";
    }
    EXPECT_LT((eye(view()) - eye(parts().comparison().view())).norm(), 1e-9);
    key(Qt::Key_1, Qt::ControlModifier);
    ASSERT_FALSE(parts().comparison().on());
    EXPECT_LT((eye(view()) - before).norm(), 1e-9) << zoom;
  }
}

TEST_F(TwoViews, AKeptPoseStaysWhileTheFirstViewGoesOn) {
  compareRates();
  parts().comparison().showKeptPose();
  ASSERT_TRUE(waitUntil([this] { return !second().live().busy() && second().jobs().idle(); }));
  settle();
  EXPECT_EQ(parts().comparison().playback().sequence(), nullptr) << "taken again after it was given up";
}

TEST_F(TwoViews, TheSecondOneNamesTheOrganUnderTheMouse) {
  compareRates();
  app::ViewWidget& beside = parts().comparison().view();
  auto* name = beside.findChild<QLabel*>(QStringLiteral("organUnderCursor"));
  ASSERT_NE(name, nullptr);
  const QPoint middle = beside.rect().center();
  QTest::mouseMove(&beside, middle + QPoint(3, 3));
  QTest::mouseMove(&beside, middle);
  ASSERT_TRUE(waitUntil([&] { return name->isVisible(); }));
  const double ratio = beside.devicePixelRatioF();
  const auto pick = beside.view().pick(ratio * middle.x(), ratio * (beside.height() - 1 - middle.y()));
  ASSERT_TRUE(pick);
  const auto organ = second().document().organ(parts().comparison().picture().organOf(pick->organ));
  ASSERT_TRUE(organ);
  EXPECT_EQ(name->text(), app::inWords(presentation::labelOf(*organ)));
  QTest::mouseMove(&beside, QPoint(4, 4));
  EXPECT_TRUE(waitUntil([&] { return !name->isVisible(); }));
}

TEST_F(TwoViews, ASecondViewThatGoesTakesItsOffersAlong) {
  auto bar = std::make_unique<app::MessageBar>();
  auto second = std::make_unique<app::Workspace>(coordinates::builtInRegistry());
  auto messages = std::make_unique<app::BindingMessages>(*second, bar.get());
  second->undo().perform(document::addOrgans({ball("Ball", 30, 3)}));
  second->undo().perform(
      document::addHandles({{Vec3(0, 0, 0)}, {Vec3(1, 0, 0)}, {Vec3(0, 1, 0)}, {Vec3(0, 0, 1)}}));
  ASSERT_TRUE(waitUntil([&] { return second->jobs().idle() && !bar->text().isEmpty(); }));
  messages.reset();
  EXPECT_EQ(bar->text(), QString());
}

} // namespace
} // namespace viscera::tests
