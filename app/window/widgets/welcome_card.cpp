#include "window/widgets/welcome_card.h"

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>

#include "window/style/icon.h"
#include "window/widgets/flow_layout.h"

namespace viscera::app {

WelcomeCard::WelcomeCard(QMenu* samples, QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("welcomeCard"));
  auto* row = new FlowLayout(this, 8);
  row->setContentsMargins(16, 8, 8, 8);
  auto* title = new QLabel(tr("Welcome"), this);
  QFont font = title->font();
  font.setBold(true);
  title->setFont(font);
  row->addWidget(title);
  const auto addButton = [&](const QString& label, const QString& tip) {
    auto* button = new QPushButton(label, this);
    button->setToolTip(tip);
    row->addWidget(button);
    return button;
  };
  auto* open = addButton(tr("Open a patient..."), tr("Choose organ surfaces of a patient (Ctrl+O)"));
  auto* sample = addButton(tr("Sample organs"), tr("Organs that come with the program"));
  auto* tour = addButton(tr("Two-minute tour"), tr("What there is in this window, step by step"));
  title->setMinimumHeight(open->sizeHint().height());
  title->setContentsMargins(0, 0, 4, 0);
  sample->setMenu(samples);
  sample->setObjectName(QStringLiteral("menuButton"));
  auto* closeButton = new QToolButton(this);
  closeButton->setIcon(icon("close"));
  closeButton->setIconSize(QSize(14, 14));
  closeButton->setToolTip(tr("Close this card (Help > Welcome shows it again)"));
  closeButton->setAccessibleName(tr("Close this card"));
  closeButton->setMinimumHeight(open->sizeHint().height());
  row->addWidget(closeButton);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  connect(open, &QPushButton::clicked, this, &WelcomeCard::openRequested);
  connect(tour, &QPushButton::clicked, this, &WelcomeCard::tourRequested);
  connect(closeButton, &QToolButton::clicked, this, [this] {
    hide();
    Q_EMIT closed();
  });
}

} // namespace viscera::app
