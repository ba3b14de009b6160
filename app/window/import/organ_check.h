#pragma once

#include <QFrame>

#include <string>

#include "viscera/document/import_draft.h"

class QLayout;

namespace viscera::app {

/// What a button for a repair (an id of `medical_io::surfaceRepairs`) says: "Fill holes".
QString repairName(const std::string& id);

/// What it does, as a sentence for its tooltip.
QString repairTip(const std::string& id);

/// A finding as a line: a light, a sentence, and buttons for what would help.
class FindingLine final : public QWidget {
  Q_OBJECT

public:
  explicit FindingLine(const medical_io::Finding& finding, QWidget* parent = nullptr);

Q_SIGNALS:
  void repairRequested(const QString& id);
};

/// One organ in the import panel: whether it comes, its measures, what was found, what was done.
class OrganCheck final : public QFrame {
  Q_OBJECT

public:
  /// `severalFiles`: whether its file's name has to be told.
  OrganCheck(const document::DraftOrgan& organ, bool severalFiles, QWidget* parent = nullptr);

Q_SIGNALS:
  void includedChanged(bool included);
  void repairRequested(const QString& id);
  void revertRequested();

private:
  QLayout* makeHeading(const document::DraftOrgan& organ, bool severalFiles);
  QLayout* makeFoot(const document::DraftOrgan& organ);
  /// All that is as it should be, in one line.
  QWidget* makeGoodLine(const document::DraftOrgan& organ);
};

} // namespace viscera::app
