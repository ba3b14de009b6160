#include "window/import/organ_check.h"

#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPushButton>

#include <map>

#include "viscera/anatomy/part.h"
#include "viscera/medical_io/plausible_size.h"
#include "viscera/medical_io/surface_repairs.h"
#include "window/import/repair_value_box.h"
#include "window/style/language.h"
#include "window/widgets/elided_check.h"
#include "window/widgets/flow_layout.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/wrapped_label.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

constexpr int kSeverityWidth = 18;
constexpr int kButtonSpacing = 4;

/// A shape beside the colour, for colour-blind users.
QLabel* severityLabel(medical_io::FindingSeverity severity, QWidget* parent) {
  struct Look {
    const char* name;
    const char* sign;
  };
  static const Look kLooks[] = {{"good", "\u2713"}, {"note", "i"}, {"doubt", "!"}, {"fault", "\u2715"}};
  const Look& look = kLooks[static_cast<std::size_t>(severity)];
  auto* label = new QLabel(QString::fromUtf8(look.sign), parent);
  label->setProperty("light", QLatin1String(look.name));
  label->setFixedSize(kSeverityWidth, kSeverityWidth);
  label->setAlignment(Qt::AlignCenter);
  return label;
}

QLabel* wrapped(const QString& text, QWidget* parent) {
  auto* label = new WrappedLabel(text, parent);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QString measures(const document::DraftOrgan& organ) {
  const Vec3& size = organ.assessment.sizeMm;
  const auto number = [](double value) { return formatDigits(value, 3); };
  const QString box =
      OrganCheck::tr("%1 x %2 x %3 mm").arg(number(size.x()), number(size.y()), number(size.z()));
  if (!organ.assessment.report.closed())
    return OrganCheck::tr("%1, open").arg(box);
  return OrganCheck::tr("%1, %2").arg(box, formatMilliliters(organ.assessment.volumeMl));
}

QString repairText(const char* text) {
  return QCoreApplication::translate("viscera::app::Repairs", text);
}

/// Whether a click asks for a value. A surface is made anew at the usual resolution at one click; a finer one
/// is asked for by the menu.
bool asksFirst(const std::string& repair) {
  return repair == "remove-fragments" || repair == "scale";
}

} // namespace

QString repairName(const std::string& id) {
  static const std::map<std::string, const char*> kNames = {
      {"orient", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Turn triangles outward")},
      {"fill-holes", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Fill holes")},
      {"remove-fragments", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Remove small fragments")},
      {"keep-largest", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Keep the largest piece")},
      {"scale", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Scale")},
      {"remesh", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Remesh")},
      {"mirror", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Mirror left and right")},
      {"ras-to-lps", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Convert from RAS to LPS")},
      {"y-up", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Convert from Y up to LPS")},
      {"y-up-ras", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Convert from Y up and RAS to LPS")},
      {"flip-y", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Mirror front and back")},
      {"flip-z", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Mirror head and feet")},
      {"flip-yz", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Turn head and feet, front and back")},
      {"flip-xz", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Turn head and feet, right and left")},
      {"flip-xyz", QT_TRANSLATE_NOOP("viscera::app::Repairs", "Mirror all three directions")}};
  const auto known = kNames.find(id);
  if (known != kNames.end())
    return repairText(known->second);
  const auto value = id.find('=');
  if (value != std::string::npos) {
    const bool scales = id.starts_with("scale");
    const QString stated = text(id.substr(value + 1)), number = QLocale().toString(stated.toDouble(), 'g', 6);
    return QStringLiteral("%1: %2").arg(repairName(id.substr(0, value)),
                                        id.starts_with("remesh") ? number + QStringLiteral(" mm")
                                        : scales                 ? QStringLiteral("\u00d7 ") + number
                                                                 : stated);
  }
  for (const medical_io::LengthUnit& unit : medical_io::lengthUnits())
    if (id == "unit-" + std::string(unit.id))
      return repairText(QT_TRANSLATE_NOOP("viscera::app::Repairs", "Coordinates are in %1"))
          .arg(inWords(std::string(unit.name)));
  return text(id);
}

QString repairTip(const std::string& id) {
  return asSentence(medical_io::surfaceRepair(id == "scale" ? "scale=1" : id).does);
}

QString subjectName(medical_io::FindingSubject subject) {
  using medical_io::FindingSubject;
  static const std::map<FindingSubject, const char*> kNames = {
      {FindingSubject::axes, QT_TRANSLATE_NOOP("viscera::app::Findings", "Side of the body")},
      {FindingSubject::size, QT_TRANSLATE_NOOP("viscera::app::Findings", "Size")},
      {FindingSubject::holes, QT_TRANSLATE_NOOP("viscera::app::Findings", "Open surface")},
      {FindingSubject::edges,
       QT_TRANSLATE_NOOP("viscera::app::Findings", "Edges of more than two triangles")},
      {FindingSubject::facing, QT_TRANSLATE_NOOP("viscera::app::Findings", "Triangles that face inward")},
      {FindingSubject::pieces, QT_TRANSLATE_NOOP("viscera::app::Findings", "Separate pieces")},
      {FindingSubject::crossings, QT_TRANSLATE_NOOP("viscera::app::Findings", "Crossing triangles")},
      {FindingSubject::arrangement, QT_TRANSLATE_NOOP("viscera::app::Findings", "Positions of the organs")},
      {FindingSubject::detail, QT_TRANSLATE_NOOP("viscera::app::Findings", "Lost details")}};
  return QCoreApplication::translate("viscera::app::Findings", kNames.at(subject));
}

FindingLine::FindingLine(const medical_io::Finding& finding, QWidget* parent, bool asks) : QWidget(parent) {
  auto* row = makeLayout<QHBoxLayout>(this, 8);
  row->addWidget(severityLabel(finding.severity, this), 0, Qt::AlignTop);
  auto* column = new QVBoxLayout;
  column->setSpacing(4);
  row->addLayout(column, 1);
  column->addWidget(wrapped(asSentence(finding.text), this));
  if (finding.repairs.empty())
    return;
  auto* buttons = new QWidget(this);
  auto* flow = new FlowLayout(buttons, kButtonSpacing);
  flow->setContentsMargins(0, 0, 0, 0);
  for (const std::string& id : finding.repairs) {
    auto* button = new QPushButton(
        asks && asksFirst(id) ? repairName(id) + QStringLiteral("...") : repairName(id), buttons);
    button->setObjectName(QStringLiteral("repair"));
    button->setProperty("repair", text(id));
    button->setToolTip(repairTip(id));
    flow->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, id] { Q_EMIT repairRequested(text(id)); });
  }
  column->addWidget(buttons);
}

OrganCheck::OrganCheck(const document::DraftOrgan& organ, const Detail& detail, QWidget* parent)
    : QFrame(parent), organ_(organ), column_(nullptr) {
  setObjectName(QStringLiteral("organCheck"));
  const bool brief =
      detail.brief && !organ.assessment.questionable() && organ.repairs.empty() && !organ.refusal;
  column_ = makeLayout<QVBoxLayout>(this, 6, {12, brief ? 4 : 8, 12, brief ? 4 : 8});
  auto* column = column_;
  column->addLayout(makeHeading(organ, detail.file));
  if (!organ.included || brief)
    return;
  for (auto severity : {medical_io::FindingSeverity::fault, medical_io::FindingSeverity::doubt,
                        medical_io::FindingSeverity::note})
    for (const medical_io::Finding& finding : organ.assessment.findings)
      if (finding.severity == severity &&
          (detail.size || finding.subject != medical_io::FindingSubject::size)) {
        auto* line = new FindingLine(finding, this, true);
        connect(line, &FindingLine::repairRequested, this, &OrganCheck::request);
        column->addWidget(line);
      }
  column->addWidget(makeGoodLine(organ));
  column->addLayout(makeFoot(organ));
}

QString OrganCheck::shownName(const document::DraftOrgan& organ) {
  return inWords(anatomy::readableName(organ.name));
}

QLayout* OrganCheck::makeHeading(const document::DraftOrgan& organ, bool withFile) {
  auto* column = new QVBoxLayout;
  column->setSpacing(0);
  const QString shown = shownName(organ), own = text(organ.name);
  auto* name = new ElidedCheck(
      shown, tr("Import this organ") + (shown == own ? QString() : QLatin1Char('\n') + own), this);
  name->setObjectName(QStringLiteral("included"));
  name->setChecked(organ.included);
  embolden(name);
  connect(name, &QCheckBox::toggled, this, &OrganCheck::includedChanged);
  column->addWidget(name);
  QString facts = measures(organ);
  if (withFile)
    facts = tr("%1 \u00b7 %2").arg(text(organ.file), facts);
  auto* size = wrapped(facts, this);
  size->setObjectName(QStringLiteral("muted"));
  column->addWidget(size);
  return column;
}

QWidget* OrganCheck::makeGoodLine(const document::DraftOrgan& organ) {
  QStringList good;
  for (const medical_io::Finding& finding : organ.assessment.findings)
    if (finding.severity == medical_io::FindingSeverity::good)
      good.push_back(asSentence(finding.text));
  auto* line = new QWidget(this);
  auto* row = makeLayout<QHBoxLayout>(line, 8);
  row->addWidget(severityLabel(medical_io::FindingSeverity::good, line));
  auto* label = new QLabel(tr("%n checks passed", nullptr, static_cast<int>(good.size())), line);
  label->setObjectName(QStringLiteral("muted"));
  label->setToolTip(good.join(QLatin1Char('\n')));
  row->addWidget(label, 1);
  line->setVisible(!good.isEmpty());
  return line;
}

/// When it is opened: ninety cards need no ninety full menus.
void OrganCheck::addRepairs(QMenu& menu) {
  if (!menu.isEmpty())
    return;
  menu.setToolTipsVisible(true);
  for (const medical_io::SurfaceRepair& repair : medical_io::surfaceRepairs()) {
    QAction* action = repair.value
                          ? menu.addAction(repairName(repair.id) + QStringLiteral("..."), this,
                                           [this, id = repair.id] { ask(id); })
                          : menu.addAction(repairName(repair.id), this,
                                           [this, id = text(repair.id)] { Q_EMIT repairRequested(id); });
    action->setToolTip(repairTip(repair.id));
  }
}

void OrganCheck::request(const QString& id) {
  if (asksFirst(id.toStdString()))
    return ask(id.toStdString());
  Q_EMIT repairRequested(id);
}

void OrganCheck::ask(const std::string& repair) {
  delete box_;
  box_ = new RepairValueBox(organ_, repair, this);
  column_->addWidget(box_);
  connect(box_, &RepairValueBox::chosen, this, &OrganCheck::repairRequested);
  connect(box_, &RepairValueBox::changed, this, &OrganCheck::previewRequested);
  connect(box_, &RepairValueBox::closed, this, [this] {
    box_->hide();
    box_->deleteLater();
    box_ = nullptr;
    Q_EMIT previewRequested({});
  });
  Q_EMIT previewRequested(box_->id());
}

void OrganCheck::contextMenuEvent(QContextMenuEvent* event) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  addRepairs(*menu);
  menu->popup(event->globalPos());
}

QLayout* OrganCheck::makeFoot(const document::DraftOrgan& organ) {
  auto* column = new QVBoxLayout;
  column->setSpacing(2);
  QStringList done;
  for (const std::string& id : organ.repairs)
    done.push_back(repairName(id));
  if (!done.isEmpty()) {
    auto* label = wrapped(tr("Done: %1").arg(done.join(QStringLiteral(", "))), this);
    label->setObjectName(QStringLiteral("muted"));
    column->addWidget(label);
  }
  if (organ.refusal) {
    auto* label =
        wrapped(sentenceOf(DataError(organ.refusal->problem(), {}, organ.refusal->tryThis())), this);
    label->setObjectName(QStringLiteral("refusal"));
    column->addWidget(label);
  }
  if (organ.change) {
    auto* label = wrapped(asSentence(inWords(*organ.change)), this);
    label->setObjectName(QStringLiteral("surfaceChange"));
    column->addWidget(label);
  }
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  auto* more = new QPushButton(tr("More repairs"), this);
  more->setObjectName(QStringLiteral("menuButton"));
  auto* menu = new QMenu(more);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { addRepairs(*menu); });
  more->setMenu(menu);
  row->addWidget(more);
  if (!done.isEmpty()) {
    auto* back = new QPushButton(tr("As in the file"), this);
    back->setObjectName(QStringLiteral("revert"));
    back->setToolTip(tr("Undo the repairs of this organ"));
    connect(back, &QPushButton::clicked, this, &OrganCheck::revertRequested);
    row->addWidget(back);
  }
  row->addStretch(1);
  column->addLayout(row);
  return column;
}

} // namespace viscera::app
