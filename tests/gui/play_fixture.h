#pragma once

#include <QComboBox>
#include <QFile>
#include <QTest>

#include <string>

#include "window/play/curve_box.h"
#include "window/play/play_mode.h"
#include "window_test.h"

namespace viscera::tests {

/// The window as it starts, in Play mode: the sample heart with its motion.
class PlayMode : public WindowTest {
protected:
  bool coarseSamples() const override { return true; }
  void SetUp() override {
    WindowTest::SetUp();
    loadSample(QStringLiteral("heart"));
    key(Qt::Key_5);
    ASSERT_EQ(window().mode(), "play");
  }
  void loadSample(const QString& name) {
    const auto before = document().organs().empty() ? document::OrganId{} : document().organs().front()->id;
    window().samples().load(name, false);
    const auto there = [&] {
      return !document().organs().empty() && document().organs().front()->id != before &&
             window().playback().sequence() != nullptr;
    };
    ASSERT_TRUE(QTest::qWaitFor(there, 120000)) << message().toStdString();
    settle();
  }
  static double volumeIn(app::Workspace& workspace, const std::string& name) {
    for (const auto& organ : workspace.document().organs())
      if (organ->name == name)
        return workspace.live().volume(organ->id).nowMl;
    ADD_FAILURE() << "no organ " << name;
    return 0;
  }
  double volumeOf(const char* name) { return volumeIn(window().workspace(), name); }
  /// Lets the test's clock run and the window play as long.
  void playFor(double seconds) {
    for (double end = now_ + seconds; now_ < end;) {
      now_ += 1.0 / 30;
      window().playback().advance();
      QTest::qWait(1);
    }
  }
  /// Prescribes 130 ml for the left ventricle at the beginning of the cycle and 75 ml in its middle, which is
  /// shown. Returns the file with the curve.
  QString prescribeLeftVentricle() {
    QFile file(path(QStringLiteral("lv.csv")));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("fraction,ml\n0,130\n0.5,75\n");
    file.close();
    auto& organ = find<QComboBox>("curveOrgan");
    organ.setCurrentIndex(organ.findText(QStringLiteral("LV cavity")));
    window().findChild<app::CurveBox*>()->load(file.fileName());
    window().playback().seek(0.5);
    EXPECT_NEAR(volumeOf("LV"), 75, 1e-6) << message().toStdString();
    return file.fileName();
  }
  app::PlayMode& parts() { return window().play(); }
};

} // namespace viscera::tests
