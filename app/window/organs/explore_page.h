#pragma once

#include "viscera/medical_io/scan_over_time.h"
#include "window/widgets/page.h"
#include "window/work/actions.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// The property page of the mode Explore: standard views, appearance, measurements, and facts about the
/// selected organ and the scan.
class ExplorePage final : public Page {
  Q_OBJECT

public:
  /// `cut`, `measurements` and `parts` are put into the page.
  ExplorePage(Workspace& workspace, const Actions& actions, QWidget* cut, QWidget* measurements,
              QWidget* parts, QWidget* parent = nullptr);

private:
  QWidget* makeViews(const Actions& actions);
  void sync();
  void syncScan();
  static QString phasesLineOf(const medical_io::ScanOverTime& time);
  void syncStudy();
  void syncSections();

  Workspace& workspace_;
  QWidget* cutSection_ = nullptr;
  QWidget* partsSection_ = nullptr;
  QWidget* organSection_ = nullptr;
  QWidget* scanSection_ = nullptr;
  QWidget* studySection_ = nullptr;
  QLabel* name_ = nullptr;
  QLabel* volume_ = nullptr;
  QLabel* size_ = nullptr;
  QLabel* triangles_ = nullptr;
  QLabel* surface_ = nullptr;
  QLabel* file_ = nullptr;
  QLabel* warnings_ = nullptr;
  QLabel* scanName_ = nullptr;
  QLabel* scanVoxels_ = nullptr;
  QLabel* scanSpacing_ = nullptr;
  QLabel* scanFile_ = nullptr;
  QLabel* scanRemarks_ = nullptr;
  QLabel* studyName_ = nullptr;
  QLabel* studyDate_ = nullptr;
  QLabel* studySeries_ = nullptr;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
