#pragma once

#include <QLineEdit>
#include <QTest>
#include <QTreeWidget>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "session_fixture.h"
#include "viscera/document/organ_commands.h"
#include "viscera/presentation/presenter.h"
#include "window_test.h"

namespace viscera::tests {

/// Sixteen balls with the names of organs, four in a row, as wide apart as they are large.
class ManyOrgans : public WindowTest {
protected:
  static constexpr int kName = 1; ///< Column of the list.

  void SetUp() override {
    WindowTest::SetUp();
    std::vector<document::NewOrgan> organs;
    for (const char* name : {"liver", "stomach", "colon", "duodenum", "aorta", "left renal artery",
                             "right renal artery", "portal vein", "kidney_left", "kidney_right", "spleen",
                             "Lumbar1", "Lumbar2", "rib_left_1", "gluteus maximus", "label 699"}) {
      const auto at = static_cast<double>(organs.size());
      organs.push_back(ball(name, 30, 3, Vec3(120 * std::fmod(at, 4), 0, 120 * std::floor(at / 4))));
    }
    ASSERT_TRUE(window().workspace().perform(document::addOrgans(std::move(organs))));
    settle();
    key(Qt::Key_F);
    settle();
  }
  QTreeWidget& list() { return *window().findChild<QTreeWidget*>(QStringLiteral("organList")); }
  QLineEdit& search() { return *window().findChild<QLineEdit*>(QStringLiteral("organSearch")); }
  /// By the organ's own name, in the words of the list.
  QTreeWidgetItem* row(const QString& name) {
    QString shown = name;
    for (const auto& one : document().organs())
      if (one->name == name.toStdString())
        shown = QString::fromStdString(presentation::labelOf(*one));
    const auto found = list().findItems(shown, Qt::MatchExactly | Qt::MatchRecursive, kName);
    EXPECT_EQ(found.size(), 1) << name.toStdString();
    return found.front();
  }
  const document::Organ& organ(const std::string& name) {
    for (const auto& one : document().organs())
      if (one->name == name)
        return *one;
    throw std::runtime_error(name);
  }
  std::vector<std::string> seen() {
    std::vector<std::string> names;
    for (const auto& one : document().organs())
      if (one->look.visible)
        names.push_back(one->name);
    return names;
  }
  QPoint placeOf(const std::string& name) {
    const Points& points = organ(name).mesh->points;
    return onScreen(points.colwise().mean().transpose());
  }
  /// Where the name of a row begins, in the list.
  QRect nameOf(QTreeWidgetItem* item) {
    list().scrollToItem(item);
    QModelIndex index;
    std::vector<int> rows;
    for (QTreeWidgetItem* each = item; each; each = each->parent())
      rows.insert(rows.begin(),
                  each->parent() ? each->parent()->indexOfChild(each) : list().indexOfTopLevelItem(each));
    for (std::size_t depth = 0; depth < rows.size(); ++depth)
      index = list().model()->index(rows[depth], depth + 1 == rows.size() ? kName : 0, index);
    return list().visualRect(index);
  }
  void choose(const std::vector<QString>& names) {
    list().clearSelection();
    for (const QString& name : names)
      row(name)->setSelected(true);
  }
  std::size_t steps() { return window().workspace().undo().names().size(); }
};

} // namespace viscera::tests
