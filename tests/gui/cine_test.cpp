#include "window_test.h"

#include <QAction>
#include <QCoreApplication>
#include <QLabel>
#include <QWheelEvent>

#include <filesystem>
#include <fstream>

#include "cine_pictures.h"
#include "viscera/document/study_item.h"
#include "window/import/file_actions.h"
#include "window/slices/slice_panes.h"
#include "window/timeline/phase_scrubber.h"
#include "window/view/view_model.h"

namespace viscera::tests {
namespace {

/// A folder with two slices of the short axis, and planes with four and with two chambers.
class CineWindowTest : public WindowTest {
protected:
  QString study() const {
    const std::filesystem::path folder = path(QStringLiteral("heart")).toStdString();
    std::filesystem::create_directory(folder);
    for (CinePicture picture : {shortAxisPicture(3, 0, 860), shortAxisPicture(4, 17.7, 829),
                                longAxisPicture(6, 122, 876), longAxisPicture(8, 3, 975)})
      for (picture.phase = 0; picture.phase < picture.phases; ++picture.phase)
        std::ofstream(folder / cineFileName(picture), std::ios::binary) << dicomBytes(cineElements(picture));
    return QString::fromStdString(folder.string());
  }
  const presentation::CineLook& look() { return window().viewModel().state().scan.cine; }
  std::string titleOf(int pane) {
    settle();
    return window().slices().cine().presenter().picture(pane).title;
  }
};

TEST_F(CineWindowTest, AFolderOpensAsOnePatientInItsOwnPlanesAndPlaysInTheTimeline) {
  window().files().open({study()});
  ASSERT_TRUE(waitUntil([this] { return document().state().study != nullptr; })) << message().toStdString();
  EXPECT_FALSE(document().state().scan);
  settle();
  ASSERT_TRUE(window().slices().widget(0).isVisible());
  EXPECT_EQ(titleOf(0), "short axis 2 of 2  phase 1 of 12");
  EXPECT_EQ(titleOf(1), "4-chamber  phase 1 of 12");
  EXPECT_EQ(titleOf(2), "2-chamber  phase 1 of 12");
  const QString series = find<QLabel>("studySeries").text();
  EXPECT_TRUE(series.contains(QStringLiteral("8 long: 2-chamber, 12 phases in 975 ms")))
      << series.toStdString();

  app::SliceWidget& slice = window().slices().widget(0);
  const QPoint at = slice.rect().center();
  QWheelEvent wheel(at, slice.mapToGlobal(at), {}, QPoint(0, -120), Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&slice, &wheel);
  EXPECT_EQ(titleOf(0), "short axis 1 of 2  phase 1 of 12");

  auto* scrubber = window().findChild<app::PhaseScrubber*>();
  ASSERT_TRUE(scrubber && scrubber->isVisible()) << "the timeline is the study's";
  Q_EMIT scrubber->scrubbed(0.5);
  EXPECT_DOUBLE_EQ(look().fraction, 0.5);
  EXPECT_EQ(titleOf(2), "2-chamber  phase 7 of 12");
  window().actions()["play.forward"]->trigger();
  EXPECT_NEAR(look().fraction, 7 / 12.0, 1e-3);

  window().actions()["edit.undo"]->trigger();
  EXPECT_FALSE(document().state().study);
  EXPECT_FALSE(scrubber->isEnabled());
}

} // namespace
} // namespace viscera::tests
