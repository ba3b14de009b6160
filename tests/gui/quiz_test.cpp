#include "play_fixture.h"

#include <QAction>
#include <QLabel>

#include <algorithm>
#include <cmath>

#include "session_fixture.h"
#include "shapes.h"
#include "viscera/document/organ_commands.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/presentation/presenter.h"
#include "window/import/import_controller.h"
#include "window/organs/explore_mode.h"
#include "window_probe.h"

namespace viscera::tests {
namespace {

/// The sample heart in Explore, seen from the front.
class Parts : public PlayMode {
protected:
  bool coarseSamples() const override { return false; } // Clicks find narrow vessels.
  void SetUp() override {
    PlayMode::SetUp();
    window().setMode("explore");
    window().actions()["view.anterior"]->trigger();
    settle();
  }
  std::vector<std::string> named() {
    std::vector<std::string> names;
    for (const auto& label : window().picture().presenter().labels().drawn())
      names.push_back(label.text);
    return names;
  }
  scene::OrganLabels::Drawn drawn(const std::string& part) {
    for (const auto& label : window().picture().presenter().labels().drawn())
      if (label.text == part)
        return label;
    ADD_FAILURE() << part << " has no name in the picture";
    return {};
  }
  bool isNamed(const std::string& part) {
    const auto names = named();
    return std::find(names.begin(), names.end(), part) != names.end();
  }
  QString label(const char* name) { return window().findChild<QLabel*>(QString::fromLatin1(name))->text(); }
  /// Where a part of the heart is on the screen.
  QPoint placeOf(const std::string& name) {
    const auto& heart = *document().organs().front();
    for (const presentation::Part& part : presentation::partsOf(document().organs()))
      if (presentation::nameOf(part, document().organs()) == name)
        return onScreen(window().workspace().live().points(heart.id).row(part.vertex).transpose());
    ADD_FAILURE() << "no part " << name;
    return {};
  }
};

TEST_F(Parts, AreNamedWhereTheyCanBeSeen) {
  EXPECT_TRUE(named().empty());
  key(Qt::Key_N, Qt::ShiftModifier);
  EXPECT_TRUE(isNamed("Apex"));
  EXPECT_TRUE(isNamed("Right atrium"));
  EXPECT_FALSE(isNamed("Left atrium")) << "it is behind the heart";
  window().actions()["view.posterior"]->trigger();
  settle();
  EXPECT_TRUE(isNamed("Left atrium"));
  EXPECT_FALSE(isNamed("Left anterior descending artery"));
  key(Qt::Key_N, Qt::ShiftModifier);
  EXPECT_TRUE(named().empty());
}

TEST_F(Parts, HaveNamesThatStandStillWithLinesThatFollowTheBeat) {
  window().setMode("play");
  key(Qt::Key_N, Qt::ShiftModifier);
  window().playback().play();
  playFor(0.3); // Once a motion has begun, every name has the place that it keeps.
  window().playback().seek(0);
  settle();
  const scene::OrganLabels::Drawn before = drawn("Apex");
  window().playback().seek(0.7); // Late in systole.
  settle();
  const scene::OrganLabels::Drawn after = drawn("Apex");
  EXPECT_EQ(after.box.left, before.box.left);
  EXPECT_EQ(after.box.bottom, before.box.bottom);
  const QPoint apex = placeOf("Apex");
  const double ratio = view().devicePixelRatioF();
  EXPECT_NEAR(after.targetX / ratio, apex.x(), 2);
  EXPECT_NEAR(view().height() - 1 - after.targetY / ratio, apex.y(), 2);
  EXPECT_GT(std::hypot(after.targetX - before.targetX, after.targetY - before.targetY), 1);
}

TEST_F(Parts, AreHiddenWithTheirOrgan) {
  key(Qt::Key_N, Qt::ShiftModifier);
  ASSERT_TRUE(isNamed("Apex"));
  document::OrganLook look = document().organs().front()->look;
  look.visible = false;
  window().workspace().perform(document::setOrganLook(document().organs().front()->id, look));
  settle();
  EXPECT_TRUE(named().empty());
}

TEST_F(Parts, AQuizHidesTheNamesAndAClickAnswers) {
  key(Qt::Key_N, Qt::ShiftModifier);
  key(Qt::Key_Q, Qt::ShiftModifier);
  EXPECT_TRUE(named().empty()) << "that would be too easy";
  const presentation::PartQuiz& quiz = *window().explore().quiz().quiz();
  EXPECT_TRUE(label("quizQuestion").startsWith(QStringLiteral("Click: ")));
  // The first that is asked for and can be seen from the front.
  const std::string asked = presentation::nameOf(*quiz.asked(), document().organs());
  const std::string other = asked == "Apex" ? "Right atrium" : "Apex";
  click(placeOf(other));
  EXPECT_EQ(quiz.mistakes(), 1);
  EXPECT_TRUE(label("quizResult").contains(QString::fromStdString(other)))
      << label("quizResult").toStdString();
  EXPECT_TRUE(named().empty());
  while (presentation::nameOf(*quiz.asked(), document().organs()) != other)
    click(placeOf(other));
  click(placeOf(other));
  EXPECT_TRUE(isNamed(other)) << "what was found keeps its name";
  key(Qt::Key_Escape);
  EXPECT_EQ(window().explore().quiz().quiz(), nullptr);
  EXPECT_GT(named().size(), 3U) << "the names are back";
}

TEST_F(Parts, QuestionAndScoreStandOnTheView) {
  key(Qt::Key_Q, Qt::ShiftModifier);
  auto& prompt = find<QWidget>("quizPrompt");
  EXPECT_TRUE(prompt.isVisible());
  EXPECT_EQ(prompt.parentWidget(), &view());
  EXPECT_TRUE(prompt.isAncestorOf(window().findChild<QLabel*>(QStringLiteral("quizQuestion"))));
  EXPECT_EQ(label("quizScore"), QString());
  const presentation::PartQuiz& quiz = *window().explore().quiz().quiz();
  const std::string asked = presentation::nameOf(*quiz.asked(), document().organs());
  click(placeOf(asked == "Apex" ? "Right atrium" : "Apex"));
  EXPECT_EQ(label("quizScore"), QStringLiteral("0 right, 1 wrong"));
  key(Qt::Key_Escape);
  EXPECT_FALSE(prompt.isVisible());
}

/// Valves lie in the wall: a click cannot reach them, so the phases of the beat ask for them.
TEST_F(Parts, AQuizAsksForPartsThatAClickReachesAndThenForTheValveThatIsOpen) {
  key(Qt::Key_Q, Qt::ShiftModifier);
  // As clicks on the parts would answer, from whatever side they are seen.
  auto& tool = const_cast<app::QuizTool&>(window().explore().quiz());
  while (const presentation::Part* part = tool.quiz()->asked()) {
    EXPECT_TRUE(tool.choices().isEmpty());
    EXPECT_EQ(part->organ, document().organs().front()->id) << "not of a cavity in it";
    const app::ClickedPlace place{
        part->organ, window().workspace().live().points(part->organ).row(part->vertex).transpose()};
    ASSERT_TRUE(tool.click(&place));
  }
  const int parts = static_cast<int>(tool.quiz()->all().size());
  EXPECT_EQ(label("quizScore"), QStringLiteral("%1 right, 0 wrong").arg(parts));
  int asked = 0;
  for (; !tool.choices().isEmpty() && asked < 10; ++asked) {
    const QString question = label("quizQuestion");
    const int open = question.contains(QStringLiteral("ejection"))     ? 1
                     : question.contains(QStringLiteral("Isovolumic")) ? 2
                                                                       : 0;
    tool.choose(open);
  }
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(label("quizScore"), QStringLiteral("%1 right, 0 wrong").arg(parts + asked));
  EXPECT_TRUE(label("quizQuestion").startsWith(QStringLiteral("All "))) << "it is over";
}

TEST_F(Parts, TwoQuickAnswersAreTwoAndHideNothing) {
  ASSERT_TRUE(window().workspace().perform(document::addOrgans({ball("other", 5, 2, Vec3(0, 0, 150))})));
  settle();
  key(Qt::Key_Q, Qt::ShiftModifier);
  ASSERT_TRUE(window().explore().quiz().active());
  const presentation::PartQuiz& quiz = *window().explore().quiz().quiz();
  const std::string asked = presentation::nameOf(*quiz.asked(), document().organs());
  const QPoint wrong = placeOf(asked == "Apex" ? "Right atrium" : "Apex");
  clickTwice(wrong, wrong);
  EXPECT_EQ(quiz.mistakes(), 2);
  EXPECT_TRUE(document().organs().back()->look.visible);
}

TEST_F(Parts, ASurfaceThatIsStillCheckedIsNoAnswer) {
  key(Qt::Key_Q, Qt::ShiftModifier);
  geometry::TriangleMesh insideOut =
      sphere(3, 80, boundsOf(document().organs().front()->mesh->points).center());
  insideOut.triangles.col(1).swap(insideOut.triangles.col(2));
  const QString file = path(QStringLiteral("ball.stl"));
  medical_io::writeSurface(file.toStdString(), insideOut);
  open(file);
  ASSERT_TRUE(window().imports().isOpen());
  ASSERT_TRUE(window().explore().quiz().active());
  click(view().rect().center());
  EXPECT_EQ(window().explore().quiz().quiz()->mistakes(), 0);
  EXPECT_EQ(label("quizResult"), QString());
}

TEST_F(Parts, AnotherOrganEndsTheQuiz) {
  key(Qt::Key_Q, Qt::ShiftModifier);
  ASSERT_TRUE(window().explore().quiz().active());
  open(sphereFile());
  EXPECT_FALSE(window().explore().quiz().active());
  EXPECT_FALSE(window().actions()["quiz.start"]->isChecked());
}

} // namespace
} // namespace viscera::tests
