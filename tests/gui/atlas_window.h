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

#include "viscera/document/organ_commands.h"
#include "window/import/import_desk.h"
#include "window_test.h"

namespace viscera::tests {

/// A window in which a doctor works with an atlas of 95 labels (shared/organs/abdomen_seg.nrrd): each member
/// is one step, for a test that looks at what it does and for a benchmark that takes its time.
class AtlasWindow : public WindowTest {
public:
  static std::filesystem::path file() { return VISCERA_SHARED_ORGANS "/abdomen_seg.nrrd"; }

  void import() {
    window().files().open({QString::fromStdString(file().string())});
    waitUntil([this] { return window().imports().isOpen() || !document().organs().empty(); });
    if (window().imports().isOpen())
      window().imports().accept();
    waitUntil([this] { return !document().organs().empty(); });
    settle();
  }
  void find() {
    key(Qt::Key_F, Qt::ControlModifier);
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
  void isolate() { key(Qt::Key_I, Qt::ControlModifier); }
  void surround() {
    key(Qt::Key_2);
    window().actions()["handles.addEnclosing"]->trigger();
  }
  void lock() {
    key(Qt::Key_3);
    window().actions()["volume.lock"]->trigger();
  }
  /// From the press on a handle to its release.
  void deform() {
    const QPoint from = onScreen(handleInView(reachableHandle()));
    drag(from, from + QPoint(30, -20));
  }
  void showAll() { key(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier); }

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
    return list().findItems(QLatin1String(name), Qt::MatchExactly | Qt::MatchRecursive, kName).front();
  }

private:
  static constexpr int kName = 1; ///< Column of the list.
};

} // namespace viscera::tests
