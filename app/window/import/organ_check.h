#pragma once

#include <QFrame>

#include <string>

#include "viscera/document/import_draft.h"

class QLayout;
class QMenu;
class QVBoxLayout;

namespace viscera::app {

class RepairValueBox;

/// The text of the button for a repair (an id of `medical_io::surfaceRepairs`): "Fill holes".
QString repairName(const std::string& id);

/// The tooltip of that button: what the repair does, as a sentence.
QString repairTip(const std::string& id);

/// The heading above findings of one subject: "Facing".
QString subjectName(medical_io::FindingSubject subject);

/// One finding as a line: an icon of its severity, a sentence, and buttons for the repairs that would help.
class FindingLine final : public QWidget {
  Q_OBJECT

public:
  /// Ends, with `asks`, the buttons of repairs that ask for a value first with three dots.
  explicit FindingLine(const medical_io::Finding& finding, QWidget* parent = nullptr, bool asks = false);

Q_SIGNALS:
  void repairRequested(const QString& id);
};

/// One organ in the import panel: a check box, its size and volume, its findings and the repairs done.
class OrganCheck final : public QFrame {
  Q_OBJECT

public:
  /// The facts that are shown about an organ.
  struct Detail {
    bool file = false;  ///< Its file's name.
    bool size = true;   ///< A doubt about its size; false where the panel shows it for all organs together.
    bool brief = false; ///< For an organ without findings to check: the name and the size only.
  };

  OrganCheck(const document::DraftOrgan& organ, const Detail& detail, QWidget* parent = nullptr);

  /// The name as people write it; the tooltip has that of the file.
  static QString shownName(const document::DraftOrgan& organ);

Q_SIGNALS:
  void includedChanged(bool included);
  void repairRequested(const QString& id);
  /// The value of a repair is being chosen: the view shows what would be removed; empty: no more.
  void previewRequested(const QString& id);
  void revertRequested();

protected:
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  QLayout* makeHeading(const document::DraftOrgan& organ, bool withFile);
  QLayout* makeFoot(const document::DraftOrgan& organ);
  void addRepairs(QMenu& menu);
  /// Asks for the value of a repair that needs one, below the findings.
  void request(const QString& id);
  void ask(const std::string& repair);
  /// Lists all good findings in one line.
  QWidget* makeGoodLine(const document::DraftOrgan& organ);

  document::DraftOrgan organ_; ///< Of which a value is asked; its surfaces are shared.
  QVBoxLayout* column_;
  RepairValueBox* box_ = nullptr; ///< Null: no value is asked for.
};

} // namespace viscera::app
