#include "window/key_sequence/fit_offer.h"

#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>

#include "viscera/live/sequence_setup.h"
#include "viscera/presentation/presenter.h"
#include "window/style/language.h"
#include "window/timeline/sample_loader.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/wrapped_label.h"

namespace viscera::app {
namespace {

/// The style sheet knows the button that stands out by its name.
void setPrimary(QPushButton* button, bool on) {
  button->setProperty("primary", on);
  button->style()->unpolish(button);
  button->style()->polish(button);
}

} // namespace

FitOffer::FitOffer(Workspace& workspace, QWidget* parent)
    : QFrame(parent), workspace_(workspace), question_(new WrappedLabel(this)), fit_(makeButton("offerFit")),
      sample_(makeButton("offerSample")) {
  setObjectName(QStringLiteral("badge"));
  auto* column = makeLayout<QVBoxLayout>(this, 6, {10, 8, 10, 10});
  column->addWidget(question_);
  column->addWidget(fit_);
  column->addWidget(sample_);
  sample_->setToolTip(tr("Replace all open organs; Undo brings them back"));
  connect(fit_, &QPushButton::clicked, this, [this] {
    hide();
    Q_EMIT fitChosen(sequence_);
  });
  connect(sample_, &QPushButton::clicked, this, [this] {
    hide();
    Q_EMIT sampleChosen(sequence_);
  });
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      hide();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] {
    if (workspace_.currentOrgan() != asked_)
      hide(); // It names another organ.
  }));
  hide();
}

QPushButton* FitOffer::makeButton(const char* name) {
  auto* button = new QPushButton(this);
  button->setObjectName(QLatin1String(name));
  return button;
}

void FitOffer::ask(const QString& sequence) {
  const auto organ = workspace_.currentOrgan();
  const auto& all = live::sampleSequences();
  const auto sample =
      std::find_if(all.begin(), all.end(), [&](const auto& one) { return text(one.id) == sequence; });
  if (!organ || sample == all.end())
    return;
  sequence_ = sequence;
  asked_ = organ;
  const QString name = inWords(presentation::labelOf(*organ)),
                kind = SampleLoader::nameInWords(text(sample->organ));
  const bool odd = live::matchesOrgan(*sample, organ->name) == live::SequenceMatch::no;
  question_->setText(odd ? tr("%1 is made for a %2, but the name %3 suggests another organ.")
                               .arg(inWords(sample->name), kind, name)
                         : tr("%1: fit it to %2?").arg(inWords(sample->name), name));
  fit_->setText(odd ? tr("Fit it anyway") : tr("Fit it to %1").arg(name));
  fit_->setEnabled(organ->closed());
  fit_->setToolTip(organ->closed() ? tr("Place the sequence's handles around the organ and play it")
                                   : tr("%1 is open; a sequence needs a closed surface").arg(name));
  sample_->setText(tr("Show the sample %1").arg(kind));
  setPrimary(fit_, !odd && organ->closed());
  setPrimary(sample_, odd || !organ->closed());
  show();
}

} // namespace viscera::app
