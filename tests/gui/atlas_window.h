#pragma once

#include <QAction>
#include <QLineEdit>
#include <QTest>
#include <QTreeWidget>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "build_paths.h"
#include "viscera/document/organ_commands.h"
#include "viscera/presentation/presenter.h"
#include "window/import/import_controller.h"
#include "window_test.h"

namespace viscera::tests {

/// A window in which a doctor works with an atlas of 95 labels (shared/organs/abdomen_seg.nrrd): each member
/// is one step, for a test that looks at what it does and for a benchmark that takes its time. Only the
/// import waits for the work that a step starts; use `settle` after the others.
class AtlasWindow : public WindowTest {
public:
  /// The usual size of the view, because a benchmark measures it.
  std::optional<QSize> viewSize() const override { return std::nullopt; }

  static std::filesystem::path file() { return VISCERA_SHARED_ORGANS "/abdomen_seg.nrrd"; }

  void import() {
    window().files().open({QString::fromStdString(file().string())});
    waitUntil([this] {
      const bool read = window().imports().isOpen() || !document().organs().empty();
      if (!read)
        mostSeen_ = std::max(mostSeen_, view().view().organs().size());
      return read;
    });
    if (window().imports().isOpen())
      window().imports().accept();
    waitUntil([this] { return !document().organs().empty(); });
    settle();
  }
  /// Organs that were in the view before all of them were read.
  std::size_t seenArriving() const { return mostSeen_; }
  void find() {
    press(Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(&search(), QStringLiteral("liver"));
  }
  void choose() {
    search().clear();
    list().clearSelection();
    for (const char* name : {"liver", "gallbladder", "portal vein and superior mesenteric vein"})
      row(name)->setSelected(true);
    list().setCurrentItem(row("liver"), kName, QItemSelectionModel::NoUpdate);
    window().workspace().selection().setOrgan(organ("liver").id);
  }
  void isolate() { press(Qt::Key_I, Qt::ControlModifier); }
  void surround() {
    press(Qt::Key_2);
    window().actions()["handles.addEnclosing"]->trigger();
  }
  void lock() {
    press(Qt::Key_3);
    window().actions()["volume.lock"]->trigger();
  }
  void grab() {
    grabbed_ = onScreen(handleInView(reachableHandle()));
    QTest::mouseMove(&view(), grabbed_);
    QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, grabbed_);
  }
  void move(const QPoint& by) { QTest::mouseMove(&view(), grabbed_ + by); }
  void release(const QPoint& by) {
    QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, grabbed_ + by);
  }
  void showAll() { press(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier); }

  const document::Organ& organ(const std::string& name) {
    const auto& organs = document().organs();
    return **std::find_if(organs.begin(), organs.end(), [&](const auto& one) { return one->name == name; });
  }
  int visible() {
    const auto& organs = document().organs();
    return static_cast<int>(
        std::count_if(organs.begin(), organs.end(), [](const auto& one) { return one->look.visible; }));
  }
  QTreeWidget& list() { return *window().findChild<QTreeWidget*>(QStringLiteral("organList")); }
  QLineEdit& search() { return *window().findChild<QLineEdit*>(QStringLiteral("organSearch")); }
  QTreeWidgetItem* row(const char* name) {
    const QString shown = QString::fromStdString(presentation::labelOf(organ(name)));
    return list().findItems(shown, Qt::MatchExactly | Qt::MatchRecursive, kName).front();
  }

private:
  static constexpr int kName = 1; ///< Column of the list.

  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&window(), key, modifiers);
  }

  QPoint grabbed_;
  std::size_t mostSeen_ = 0;
};

} // namespace viscera::tests
