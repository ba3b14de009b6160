#include <QAction>
#include <QCheckBox>
#include <QTest>

#include <array>

#include "play_fixture.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/live/heart_tissue.h"
#include "window/session/session_files.h"
#include "window/view/heart_opener.h"
#include "window/view/picture.h"

namespace viscera::tests {
namespace {

constexpr std::array kCavities = {"lv", "rv", "la", "ra"};

/// The window with the sample heart, on the page with the cut.
class OpenedHeart : public PlayMode {
protected:
  void SetUp() override {
    PlayMode::SetUp();
    key(Qt::Key_1);
    ASSERT_EQ(window().mode(), "explore");
  }

  void cut(bool on) {
    if (window().viewModel().state().cut.on != on)
      window().actions()["view.cut"]->trigger();
    settle();
  }
  const scene::OrganActor* tissue() { return window().picture().presenter().heartTissue(); }
  bool drawn(const std::string& surface) {
    for (const auto& organ : document().organs())
      if (organ->origin.surface == surface)
        return window().picture().actorOf(organ->id)->drawn();
    ADD_FAILURE() << "no surface " << surface;
    return false;
  }
  bool makesTissue() {
    for (const JobInfo& job : window().workspace().jobs().jobs())
      if (job.slot == app::HeartOpener::kSlot)
        return true;
    return false;
  }
  QCheckBox& blood() { return find<QCheckBox>("cutBlood"); }
};

TEST_F(OpenedHeart, IsItsTissueAndNothingIsMadeBefore) {
  EXPECT_EQ(window().picture().heartTissue(), nullptr) << "a heart that is whole costs nothing";
  EXPECT_TRUE(blood().isHidden());
  const document::DocumentState before = document().state();
  window().actions()["view.cut"]->trigger();
  EXPECT_TRUE(makesTissue()) << "by a worker, while the window goes on";
  EXPECT_EQ(tissue(), nullptr);
  EXPECT_TRUE(drawn("outer"));
  settle();
  ASSERT_NE(tissue(), nullptr) << message().toStdString();
  EXPECT_FALSE(drawn("outer"));
  for (const char* surface : kCavities)
    EXPECT_FALSE(drawn(surface)) << surface;
  EXPECT_TRUE(document().state() == before);

  cut(false);
  EXPECT_EQ(tissue(), nullptr);
  EXPECT_TRUE(drawn("outer") && drawn("lv"));
  window().actions()["view.cut"]->trigger();
  EXPECT_FALSE(makesTissue()) << "it is kept";
  EXPECT_NE(tissue(), nullptr);
}

TEST_F(OpenedHeart, IsFilledWithBlood) {
  cut(true);
  ASSERT_FALSE(blood().isHidden());
  EXPECT_FALSE(blood().isChecked()) << "one looks into empty chambers at first";
  blood().click();
  settle();
  EXPECT_NE(tissue(), nullptr);
  EXPECT_FALSE(drawn("outer"));
  EXPECT_TRUE(window().picture().presenter().heartBlood());
  blood().click();
  settle();
  EXPECT_FALSE(window().picture().presenter().heartBlood());
  EXPECT_FALSE(drawn("lv"));
}

TEST_F(OpenedHeart, MovesWithItsHandlesAndTheBeat) {
  cut(true);
  ASSERT_NE(tissue(), nullptr);
  const Points rest = tissue()->points();
  const auto heart = live::sampleHeartIn(document().state());
  ASSERT_TRUE(heart);
  const auto expectInPlace = [&] {
    Points wanted;
    window().picture().heartTissue()->at(*heart, window().workspace().live(), wanted);
    ASSERT_NE(tissue(), nullptr);
    EXPECT_EQ(tissue()->points(), wanted);
    EXPECT_GT((wanted - rest).cwiseAbs().maxCoeff(), 1);
  };
  key(Qt::Key_3); // Deform
  ASSERT_TRUE(window().workspace().perform(document::setPose(1.1 * document().rig().restPositions())));
  settle();
  expectInPlace();
  key(Qt::Key_5); // Play
  window().playback().seek(0.4);
  settle();
  expectInPlace();
}

TEST_F(OpenedHeart, ComesBackWithItsSession) {
  cut(true);
  blood().click();
  const QString file = path(QStringLiteral("open.viscera"));
  bool saved = false;
  window().sessions().saveTo(file, false, [&] { saved = true; });
  ASSERT_TRUE(waitUntil([&] { return saved; })) << message().toStdString();
  window().viewModel().change([](presentation::ViewState& state) { state.cut = {}; });
  open(file);
  EXPECT_TRUE(window().viewModel().state().cut.blood);
  EXPECT_EQ(document().organs().size(), 5u) << "the tissue is no organ";
  EXPECT_NE(tissue(), nullptr);
  EXPECT_TRUE(window().picture().presenter().heartBlood());
}

TEST_F(OpenedHeart, IsAsBeforeUnderStressAndWhileItIsHidden) {
  cut(true);
  ASSERT_NE(tissue(), nullptr);
  key(Qt::Key_4);
  settle();
  EXPECT_EQ(tissue(), nullptr) << "the map has a cut of its own";
  key(Qt::Key_1);
  settle();
  EXPECT_NE(tissue(), nullptr);
  const document::OrganId outer = document().organs().front()->id;
  document::OrganLook look = document().organ(outer)->look;
  look.visible = false;
  ASSERT_TRUE(window().workspace().perform(document::setOrganLook(outer, look)));
  settle();
  EXPECT_EQ(tissue(), nullptr);
  EXPECT_TRUE(drawn("lv")) << "what is left is cut as it was";
}

} // namespace
} // namespace viscera::tests
