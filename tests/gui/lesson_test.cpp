#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QTableWidget>

#include <gmock/gmock.h>

#include "play_fixture.h"
#include "viscera/document/organ_commands.h"
#include "window/export/lesson_dialog.h"
#include "window/export/lesson_export.h"
#include "window/lecture/slides.h"

namespace viscera::tests {
namespace {

QString readPage(const QString& file) {
  QFile stream(file);
  return stream.open(QIODevice::ReadOnly) ? QString::fromUtf8(stream.readAll()) : QString();
}

} // namespace

class LessonOfTheHeart : public PlayMode {
protected:
  bool coarseSamples() const override { return false; } // Pages are as large as those that users make.
};

TEST_F(LessonOfTheHeart, ShowsEveryTextAndTakesItBackChanged) {
  const app::LessonExport& lessons = window().lessons();
  lesson::LessonPlan plan = lessons.plan();
  EXPECT_EQ(plan.surfaces.size(), 5u);
  EXPECT_EQ(plan.rate, 75);
  EXPECT_TRUE(plan.eye) << "the reader begins where the window looks from";
  EXPECT_GT(plan.surfaces[0].labels.size(), 6u) << "the sample heart's parts have names";
  app::LessonDialog dialog(plan);
  auto* table = dialog.findChild<QTableWidget*>(QStringLiteral("lessonTexts"));
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(static_cast<std::size_t>(table->rowCount()) + 2, lesson::textsOf(plan).size());
  EXPECT_TRUE(dialog.wantsPage());
  dialog.findChild<QLineEdit*>(QStringLiteral("lessonTitle"))->setText(QStringLiteral("Ward 7"));
  ASSERT_EQ(table->item(0, 1)->text(), QStringLiteral("Heart"));
  table->item(0, 1)->setText(QStringLiteral("Cor"));
  const lesson::LessonPlan changed = dialog.plan();
  EXPECT_EQ(changed.title, "Ward 7");
  EXPECT_EQ(changed.surfaces[0].title, "Cor");
}

TEST_F(LessonOfTheHeart, HasTheSlidesThatTheWindowKeeps) {
  const app::LessonExport& lessons = window().lessons();
  EXPECT_GE(lessons.plan().slides.size(), 4u) << "without own ones those of the sample heart";
  window().playback().pause();
  window().playback().seek(0.25);
  for (const char* caption : {"Full", "Empty"}) {
    window().actions()["slides.add"]->trigger();
    window().slides().rename(window().slides().current(), QString::fromLatin1(caption));
    window().playback().seek(0.5);
  }
  const lesson::LessonPlan plan = lessons.plan();
  ASSERT_EQ(plan.slides.size(), 2u);
  EXPECT_EQ(plan.slides[0].title, "Full");
  EXPECT_NEAR(plan.slides[0].fraction.value(), 0.25, 1e-9);
  EXPECT_EQ(plan.slides[1].title, "Empty");
  EXPECT_NEAR(plan.slides[1].fraction.value(), 0.5, 1e-9);
  EXPECT_TRUE(plan.slides[0].eye);
  app::LessonDialog dialog(plan);
  EXPECT_FALSE(dialog.findChild<QTableWidget*>(QStringLiteral("lessonTexts"))
                   ->findItems(QStringLiteral("Full"), Qt::MatchExactly)
                   .isEmpty());
  auto* language = dialog.findChild<QComboBox*>(QStringLiteral("lessonLanguage"));
  EXPECT_EQ(dialog.plan().language, "") << "that of the window";
  language->setCurrentText(QStringLiteral("Deutsch"));
  EXPECT_EQ(dialog.plan().language, "de");
}

TEST_F(LessonOfTheHeart, IsWrittenWithItsMotionWhileTheWindowGoesOn) {
  const QString file = path(QStringLiteral("heart.html"));
  lesson::LessonPlan plan = window().lessons().plan();
  plan.rates = {60, 75};
  plan.placedHandles = 4;
  window().lessons().write(plan, file);
  settle();
  ASSERT_TRUE(QFileInfo::exists(file)) << message().toStdString();
  EXPECT_THAT(message().toStdString(), testing::HasSubstr("differs by at most"));
  const QString page = readPage(file);
  EXPECT_TRUE(page.contains(QStringLiteral("\"rates\":[60.0,75.0]")));
  EXPECT_TRUE(page.contains(QStringLiteral("Left ventricle")));
  EXPECT_FALSE(page.left(page.indexOf(QStringLiteral("id=\"arrays\""))).contains(QStringLiteral("/tmp")));
}

class Lesson : public WindowTest {};

TEST_F(Lesson, OfAFileHasNoHiddenOrganAndNoFilesName) {
  open(sphereFile(QStringLiteral("Meier_Hans.stl")));
  open(sphereFile(QStringLiteral("liver_of_Hans.stl"), 70)); // 1.4 l, as a liver has.
  const auto secret = document().organs().front();
  document::OrganLook look = secret->look;
  look.visible = false;
  ASSERT_TRUE(window().workspace().perform(document::setOrganLook(secret->id, look)));
  const lesson::LessonPlan plan = window().lessons().plan();
  ASSERT_EQ(plan.surfaces.size(), 1u);
  EXPECT_EQ(plan.surfaces[0].title, "Liver");
  const QString file = path(QStringLiteral("out.glb"));
  window().lessons().write(plan, file);
  settle();
  QFile stream(file);
  ASSERT_TRUE(stream.open(QIODevice::ReadOnly)) << message().toStdString();
  const QByteArray bytes = stream.readAll();
  EXPECT_TRUE(bytes.startsWith("glTF"));
  EXPECT_FALSE(bytes.contains("Hans"));
}

TEST_F(Lesson, IsOfferedInTheFileMenuOnceThereIsAnOrgan) {
  EXPECT_FALSE(window().actions()["export.lesson"]->isEnabled());
  open(sphereFile());
  EXPECT_TRUE(window().actions()["export.lesson"]->isEnabled());
}

} // namespace viscera::tests
