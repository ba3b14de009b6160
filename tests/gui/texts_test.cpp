// Texts that come from files are of any length, and names in files are not written for people to read.
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTest>

#include "cut_texts.h"
#include "shapes.h"
#include "viscera/document/organ_commands.h"
#include "viscera/medical_io/surface_file.h"
#include "window/import/import_controller.h"
#include "window/style/language.h"
#include "window/view/cut_sight.h"
#include "window/widgets/elided_check.h"
#include "window/widgets/page.h"
#include "window/widgets/wrapped_label.h"
#include "window_test.h"

namespace viscera::tests {
namespace {

/// As scanners, archives and people name files.
const char* const kLongWords[] = {
    "a_patient_of_the_clinic_whose_name_has_no_spaces_and_seventy_letters_liver",
    "1.2.840.113619.2.55.3.2831178355.678.1442390243.105.20231114.123456.liver",
    "Donaudampfschifffahrtselektrizitaetenhauptbetriebswerkbauunterbeamten-liver"};

TEST(WrappedLabel, BreaksAWordThatIsWiderThanItself) {
  for (const char* word : kLongWords) {
    QWidget panel;
    app::WrappedLabel label(QStringLiteral("The file %1 is damaged.").arg(QLatin1String(word)), &panel);
    QLabel plain(label.text());
    plain.setWordWrap(true);
    constexpr int kNarrow = 180;
    ASSERT_GT(plain.minimumSizeHint().width(), kNarrow) << "the word is long enough for this test";
    EXPECT_LT(label.minimumSizeHint().width(), kNarrow);
    label.resize(kNarrow, label.heightForWidth(kNarrow));
    EXPECT_GE(label.height(), 3 * label.fontMetrics().height());
    const QImage drawn = label.grab().toImage();
    int right = 0;
    for (int y = 0; y < drawn.height(); ++y)
      for (int x = 0; x < drawn.width(); ++x)
        if (drawn.pixel(x, y) != drawn.pixel(0, 0))
          right = std::max(right, x);
    EXPECT_GT(right, kNarrow / 2) << "it is drawn";
    EXPECT_EQ(label.text(), QStringLiteral("The file %1 is damaged.").arg(QLatin1String(word)))
        << "what is copied is the name";
  }
}

TEST(WrappedLabel, IsAPlainLabelWhereItsWordsFit) {
  const QString words = QStringLiteral("A few short words that stand in some lines");
  app::WrappedLabel label(words);
  QLabel plain(words);
  plain.setWordWrap(true);
  for (const int width : {120, 200, 400})
    EXPECT_EQ(label.heightForWidth(width), plain.heightForWidth(width)) << width;
}

TEST(ElidedCheck, ShortensAndKeepsItsWholeTextInTheTip) {
  const QString name = QLatin1String(kLongWords[0]);
  app::ElidedCheck check(name, QStringLiteral("Take it"));
  check.resize(160, check.sizeHint().height());
  check.show();
  EXPECT_LE(check.minimumSizeHint().width(), 160);
  EXPECT_NE(check.shownText(), check.text());
  EXPECT_TRUE(check.toolTip().startsWith(check.text()) && check.toolTip().endsWith(QLatin1String("Take it")));
  check.resize(2 * check.sizeHint().width(), check.height());
  EXPECT_EQ(check.shownText(), check.text());
  EXPECT_EQ(check.toolTip(), QStringLiteral("Take it"));
}

TEST(ScrolledPages, ThatAreWiderThanTheirPanelAreFound) {
  QWidget window;
  auto* area = new QScrollArea(&window);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* page = new QLabel(QStringLiteral("one long line without a break"));
  area->setWidget(page);
  area->setWidgetResizable(true);
  area->resize(300, 200);
  for (const int wide : {600, 10}) {
    page->setMinimumWidth(wide);
    window.show();
    QTest::qWait(0);
    CutTexts cut;
    collectPages(window, "page", cut);
    EXPECT_EQ(cut.size(), wide > 300 ? 1U : 0U) << wide;
  }
}

class LongNames : public WindowTest, public ::testing::WithParamInterface<const char*> {
protected:
  std::optional<QSize> viewSize() const override { return std::nullopt; }
  app::InstalledLanguage language_{QLatin1String(GetParam())};

  /// A small open liver in a file of that name.
  QString fileOf(const char* word) {
    geometry::TriangleMesh small = sphere(3, 0.07);
    small.triangles = small.triangles.bottomRows(small.triangles.rows() - 20).eval();
    const QString file = path(QLatin1String(word) + QStringLiteral(".stl"));
    medical_io::writeSurface(file.toStdString(), small);
    return file;
  }
  void look(const std::string& where, CutTexts& cut) {
    for (auto* section : window().findChildren<app::CollapsibleSection*>())
      section->setOpen(true);
    settle();
    // Pages lay themselves out between the view's frames; what stays cut off counts.
    CutTexts stays;
    const auto nothingStays = [&] {
      handleEvents();
      stays.clear();
      collectAll(window(), where, stays);
      return stays.empty();
    };
    (void)QTest::qWaitFor(nothingStays, 10'000);
    cut.merge(stays);
  }
};

/// Every page is scrolled through, because texts below the edge of a panel count as well.
TEST_P(LongNames, CutNothingOffInTheImportAndOnEveryPage) {
  CutTexts cut;
  for (const QSize& size : {QSize(1280, 800), QSize(1440, 900)}) {
    window().resize(size);
    const std::string at = ' ' + std::to_string(size.width());
    for (const char* word : kLongWords) {
      open(fileOf(word));
      ASSERT_TRUE(window().imports().isOpen());
      look("import" + at, cut);
      window().imports().accept();
      ASSERT_TRUE(waitUntil([this] { return !document().organs().empty() && !window().imports().isOpen(); }));
    }
    for (const auto& mode : window().modes().all()) {
      window().setMode(mode->description().id);
      look(mode->description().id + at, cut);
    }
  }
  for (const std::string& text : cut)
    ADD_FAILURE() << text;
}

INSTANTIATE_TEST_SUITE_P(Windows, LongNames, ::testing::Values("en", "de", "es", "fr", "ca"),
                         [](const auto& language) { return std::string(language.param); });

/// The same file again, and another file of the same name and place.
TEST_F(WindowTest, ASecondFileAtTheSamePlaceIsSaid) {
  const QString file = sphereFile(QStringLiteral("liver.stl"));
  const auto take = [this](const QString& name) {
    const std::size_t before = document().organs().size();
    window().viewArea().messages()->dismiss();
    window().files().open({name});
    ASSERT_TRUE(
        waitUntil([&] { return window().imports().isOpen() || document().organs().size() > before; }));
    window().imports().accept();
    settle();
    ASSERT_EQ(document().organs().size(), before + 1);
  };
  take(file);
  EXPECT_FALSE(message().contains(QStringLiteral("lies exactly"))) << message().toStdString();
  take(file);
  EXPECT_TRUE(message().contains(QStringLiteral("lies exactly"))) << message().toStdString();
  const QString far = path(QStringLiteral("far.stl"));
  medical_io::writeSurface(far.toStdString(), sphere(3, 20, Vec3(300, 0, 0)));
  take(far);
  EXPECT_FALSE(message().contains(QStringLiteral("lies exactly"))) << message().toStdString();
}

TEST(CutSight, TurnsTowardsAFaceThatIsSeenEdgeOnOrFromBehindAndElseStays) {
  for (const Vec3& normal : {Vec3(0, 0, -1), Vec3(0, 1, 0), Vec3(-1, 0, 0)})
    for (const Vec3& sight : {Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0.6, 0, 0.8)}) {
      const Vec3 seen = app::sightOfCut(sight, normal);
      EXPECT_NEAR(seen.norm(), 1, 1e-12);
      EXPECT_GE(seen.dot(normal), 0.5 - 1e-12) << sight.transpose() << " at " << normal.transpose();
      if (sight.dot(normal) >= 0.5) {
        EXPECT_EQ(seen, sight);
      }
    }
}

} // namespace
} // namespace viscera::tests
