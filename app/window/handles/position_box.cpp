#include "window/handles/position_box.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

#include "viscera/document/rig_commands.h"
#include "window/style/language.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/wrapped_label.h"

namespace viscera::app {
namespace {
constexpr double kFarthest = 10000;
constexpr double kFarthestMove = 1000;
/// mm; a handle that is nearer to the typed position counts as being there.
constexpr double kAsTyped = 0.005;

/// A place along an axis of the patient, written with the letter of its side: "R 110.08 mm" lies 110.08 mm to
/// the right. Its value is positive towards the second letter. A number may be typed with a letter or a sign.
class SideField final : public QDoubleSpinBox {
public:
  SideField(QChar negative, QChar positive, QWidget* parent)
      : QDoubleSpinBox(parent), negative_(negative), positive_(positive) {}

  QString textFromValue(double value) const override {
    const QString size = QDoubleSpinBox::textFromValue(std::abs(value));
    const bool zero = QDoubleSpinBox::valueFromText(size) == 0;
    return zero ? size : (value < 0 ? negative_ : positive_) + QStringLiteral(" ") + size;
  }
  double valueFromText(const QString& text) const override {
    const QChar side = sideIn(text);
    const double value = QDoubleSpinBox::valueFromText(withoutSide(text));
    return side == negative_ ? -value : value;
  }
  QValidator::State validate(QString& text, int& cursor) const override {
    QString number = withoutSide(text);
    int place = std::min(cursor, static_cast<int>(number.size()));
    return QDoubleSpinBox::validate(number, place);
  }

private:
  /// The letter that the text begins with, or none.
  QChar sideIn(const QString& text) const {
    const QString said = text.trimmed().toUpper();
    const bool any = said.startsWith(negative_) || said.startsWith(positive_);
    return any ? said[0] : QChar();
  }
  QString withoutSide(const QString& text) const {
    if (sideIn(text).isNull())
      return text;
    int first = 0;
    while (text[first].isSpace())
      ++first;
    return text.mid(first + 1); // With the space before the unit, by which the box knows it.
  }

  QChar negative_, positive_;
};

/// The letters of the sides, as in the corners of slices.
constexpr std::array<std::array<char, 2>, 3> kSides = {{{'R', 'L'}, {'A', 'P'}, {'I', 'S'}}};

/// A line of a name and a field in mm for each axis.
std::array<QDoubleSpinBox*, 3> addFields(QGridLayout* grid, const std::array<QString, 3>& names,
                                         double farthest, bool sided) {
  std::array<QDoubleSpinBox*, 3> fields{};
  for (int axis = 0; axis < 3; ++axis) {
    auto* label = new QLabel(names[axis], grid->parentWidget());
    label->setObjectName(QStringLiteral("muted"));
    const auto [negative, positive] = kSides[static_cast<std::size_t>(axis)];
    auto* field = fields[axis] =
        sided ? new SideField(QLatin1Char(negative), QLatin1Char(positive), grid->parentWidget())
              : new QDoubleSpinBox(grid->parentWidget());
    field->setRange(-farthest, farthest);
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setDecimals(2);
    field->setSuffix(PositionBox::tr(" mm"));
    field->setAlignment(Qt::AlignRight);
    field->setAccessibleName(names[axis]);
    label->setBuddy(field);
    grid->addWidget(label, axis, 0);
    grid->addWidget(field, axis, 1);
  }
  grid->setColumnStretch(1, 1);
  return fields;
}

} // namespace

PositionBox::PositionBox(Workspace& workspace, Of what, QWidget* parent, PoseEditor* poses)
    : QWidget(parent), workspace_(workspace), what_(what), poses_(poses), title_(new WrappedLabel(this)),
      fieldBox_(new QWidget(this)) {
  auto* column = makeLayout<QVBoxLayout>(this, 6);
  column->addWidget(title_);
  heading_ = makeRemark(tr("Place in the patient"), this);
  column->addWidget(heading_);
  column->addWidget(fieldBox_);
  auto* grid = makeLayout<QGridLayout>(fieldBox_, 4);
  const std::array<QString, 3> names = {tr("Right or left"), tr("Front or back"), tr("Foot or head")};
  fields_ = addFields(grid, names, kFarthest, true);
  for (QDoubleSpinBox* field : fields_) {
    field->setKeyboardTracking(false);
    connect(field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &PositionBox::commit);
  }
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.rig() || change.pose())
      sync();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { sync(); }));
  sync();
}

Vec3 PositionBox::present(int row) const {
  const document::Document& document = workspace_.document();
  return what_ == Of::rest ? document.rig().handles[row].rest : Vec3(document.pose().row(row).transpose());
}

void PositionBox::sync() {
  const document::Rig& rig = workspace_.document().rig();
  const int row = rig.indexOf(workspace_.selection().currentHandle());
  fieldBox_->setVisible(row >= 0);
  heading_->setVisible(row >= 0);
  if (row < 0) {
    title_->setText(tr("No handle is selected. Click one in the view or in the list."));
    title_->setObjectName(QStringLiteral("muted"));
    return;
  }
  const document::Handle& handle = rig.handles[row];
  const double moved = (workspace_.document().pose().row(row).transpose() - handle.rest).norm();
  QString line = tr("Handle %1").arg(inWords(handle.label));
  if (what_ == Of::pose)
    line += tr(", %1 mm from rest").arg(formatNumber(moved, 1));
  if (handle.locked)
    line += tr(", locked");
  title_->setText(line);
  const Vec3 place = present(row);
  for (int axis = 0; axis < 3; ++axis) {
    const QSignalBlocker quiet(fields_[axis]);
    fields_[axis]->setValue(place[axis]);
    fields_[axis]->setEnabled(!handle.locked);
  }
}

void PositionBox::commit() {
  const document::HandleId id = workspace_.selection().currentHandle();
  const int row = workspace_.document().rig().indexOf(id);
  if (row < 0)
    return;
  // A number that was not typed keeps its digits beyond those shown.
  Vec3 place = present(row);
  for (int axis = 0; axis < 3; ++axis) {
    const double shown = QString::number(place[axis], 'f', fields_[axis]->decimals()).toDouble();
    if (fields_[axis]->value() != shown)
      place[axis] = fields_[axis]->value();
  }
  if (what_ == Of::pose && poses_) {
    poses_->moveBy({id}, place - present(row));
    return sync(); // The place may be another one than was typed: as near as the locked volumes allow.
  }
  Points positions = place.transpose();
  if (!workspace_.perform(what_ == Of::rest ? document::moveRestHandles({id}, positions)
                                            : document::moveHandles({id}, positions)))
    sync();
}

DisplacementBox::DisplacementBox(Workspace& workspace, PoseEditor& poses, QWidget* parent)
    : QWidget(parent), workspace_(workspace), poses_(poses), apply_(new QPushButton(tr("Apply"), this)),
      result_(makeRemark({}, this)) {
  setObjectName(QStringLiteral("displacementBox"));
  auto* column = makeLayout<QVBoxLayout>(this, 4);
  column->addWidget(makeRemark(tr("Move by"), this));
  auto* box = new QWidget(this);
  column->addWidget(box);
  auto* grid = makeLayout<QGridLayout>(box, 4);
  const std::array<QString, 3> names = {tr("Right to left"), tr("Front to back"), tr("Foot to head")};
  const std::array<QString, 3> tips = {tr("Towards the patient's left; negative: right (R/L)"),
                                       tr("Towards the patient's back; negative: front (A/P)"),
                                       tr("Towards the patient's head; negative: feet (S/I)")};
  fields_ = addFields(grid, names, kFarthestMove, false);
  for (int axis = 0; axis < 3; ++axis) {
    fields_[axis]->setToolTip(tips[axis]);
    grid->itemAtPosition(axis, 0)->widget()->setToolTip(tips[axis]);
    connect(fields_[axis], QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            &DisplacementBox::sync);
  }
  apply_->setObjectName(QStringLiteral("applyDisplacement"));
  apply_->setToolTip(tr("Move the selected handles once by this distance; locked volumes are kept"));
  grid->addWidget(apply_, 3, 1);
  result_->hide();
  grid->addWidget(result_, 4, 0, 1, 2);
  connect(apply_, &QPushButton::clicked, this, &DisplacementBox::apply);
  subscription_ = workspace.selection().onChange([this] {
    result_->hide();
    sync();
  });
  sync();
}

void DisplacementBox::sync() {
  bool any = false;
  for (const QDoubleSpinBox* field : fields_)
    any = any || field->value() != 0;
  apply_->setEnabled(any && !workspace_.selection().handles().empty());
}

void DisplacementBox::apply() {
  const Vec3 by(fields_[0]->value(), fields_[1]->value(), fields_[2]->value());
  const auto moved = poses_.moveBy(workspace_.selection().handles(), by);
  if (!moved)
    return;
  const bool asTyped = (*moved - by).norm() < kAsTyped;
  result_->setText(tr("Moved by %1 of %2 mm: the locked volume allows no more in this direction.")
                       .arg(formatNumber(moved->norm(), 2))
                       .arg(formatNumber(by.norm(), 2)));
  result_->setVisible(!asTyped);
}

} // namespace viscera::app
