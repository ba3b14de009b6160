// How many organs are named, charted and given handles.
#include <QAction>
#include <QLabel>
#include <QTest>
#include <QTreeWidgetItemIterator>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "many_organs.h"
#include "window/timeline/volume_monitor.h"
#include "window/timeline/volume_panel.h"

namespace viscera::tests {
namespace {

/// Names that read "small_bowel" are for files.
TEST_F(ManyOrgans, AreNamedAsPeopleWriteThem) {
  for (QTreeWidgetItemIterator each(&list()); *each; ++each) {
    const QString name = (*each)->text(kName);
    EXPECT_FALSE(name.contains(QLatin1Char('_')) || name[0].isLower()) << name.toStdString();
  }
  window().workspace().selection().setOrgan(organ("kidney_left").id);
  settle();
  EXPECT_TRUE(find<QLabel>("statusVolume").text().startsWith(QStringLiteral("Left kidney")))
      << find<QLabel>("statusVolume").text().toStdString();
  EXPECT_EQ(organ("kidney_left").name, "kidney_left") << "its own name stays";
}

TEST_F(ManyOrgans, AreCountedInTheStatusBarUntilOneIsChosen) {
  window().workspace().selection().setOrgan({});
  settle();
  EXPECT_EQ(find<QLabel>("statusVolume").text(), QStringLiteral("16 organs"));
}

TEST_F(ManyOrgans, ShowTheNormalRangeOfTheChosenOne) {
  for (const char* chosen : {"liver", "spleen", "liver"}) {
    window().workspace().selection().setOrgan(organ(chosen).id);
    settle();
    const QString range = window().findChild<app::VolumePanel*>()->normalsText();
    EXPECT_TRUE(range.contains(QString::fromLatin1(chosen), Qt::CaseInsensitive)) << range.toStdString();
  }
}

TEST_F(ManyOrgans, HaveCurvesOfTheChosenAndTheLargestWhereTheyAreVisible) {
  const auto charted = [this] {
    std::vector<document::OrganId> ids;
    for (const auto& line : window().volumes().lines())
      ids.push_back(line.organ);
    return ids;
  };
  const auto has = [&](const char* name) {
    const auto ids = charted();
    return std::count(ids.begin(), ids.end(), organ(name).id) == 1;
  };
  for (const char* chosen : {"label 699", "gluteus maximus"}) {
    window().workspace().selection().setOrgan(organ(chosen).id);
    EXPECT_EQ(charted().size(), app::VolumeMonitor::kMostLines);
    EXPECT_TRUE(has(chosen)) << chosen;
    EXPECT_EQ(window().volumes().unlisted(), 8);
  }
  choose({QStringLiteral("gluteus maximus")});
  key(Qt::Key_H, Qt::ControlModifier);
  EXPECT_FALSE(has("gluteus maximus")) << "it is hidden";
  EXPECT_EQ(charted().size(), app::VolumeMonitor::kMostLines);
}

TEST_F(ManyOrgans, GetHandlesAroundAllOfThemUnlessOneIsChosen) {
  const auto nearest = [this](const Vec3& handle) {
    const document::Organ* best = nullptr;
    double least = 1e300;
    for (const auto& one : document().organs())
      if (const double gap = (one->mesh->points.rowwise() - handle.transpose()).rowwise().norm().minCoeff();
          gap < least) {
        least = gap;
        best = one.get();
      }
    return best->name;
  };
  const auto around = [&] {
    std::map<std::string, int> counts;
    const auto& handles = document().rig().handles;
    for (std::size_t i = 8; i < handles.size(); ++i) // The box comes first.
      ++counts[nearest(handles[i].rest)];
    return counts;
  };
  window().workspace().selection().clear();
  key(Qt::Key_2);
  window().actions()["handles.place"]->trigger();
  settle();
  EXPECT_EQ(around().size(), 16U) << "all are of one size";
  window().workspace().selection().setOrgan(organ("spleen").id);
  window().actions()["handles.place"]->trigger();
  settle();
  EXPECT_EQ(around(), (std::map<std::string, int>{{"spleen", 22}}));
}

} // namespace
} // namespace viscera::tests
