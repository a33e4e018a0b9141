// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/state_field.h"

#include "ui/controller/wizard_controller.h"
#include "ui/style/accessible_role.h"
#include "ui/style/plain_label.h"
#include "ui/text/state_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QPainter>

#include <algorithm>

namespace axiscomp::ui {

namespace {

/// Whether the drive holds the value of an end, since a source is beyond the table.
bool isOutsideTable(const AxisStatus& status)
{
    return status.table && status.setup.dimensionality == status.table->grid.dimensions()
        && !isWithin(status.table->grid, status.sourceValues);
}

QString liveText(const AxisStatus& status)
{
    QStringList indices;
    for (int n = 0; n < status.setup.dimensionality; ++n)
        indices += QLocale().toString(status.indices.at(static_cast<std::size_t>(n)), 'f', 2);
    const QString text = StateField::tr("Output %1 · Index %2")
                             .arg(smallValueText(status.output, status.axis.unit),
                                 indices.join(QStringLiteral(" / ")));
    return isOutsideTable(status)
        ? text + QStringLiteral(" · ") + StateField::tr("outside the table: end value held")
        : text;
}

} // namespace

StateField::StateField(WizardController& controller, QWidget* parent)
    : QWidget(parent)
    , m_controller(controller)
    , m_state(new PlainLabel)
    , m_live(new PlainLabel)
    , m_detail(new PlainLabel)
{
    setObjectName(QStringLiteral("stateField"));
    setAccessibleRole(*this, QAccessible::StatusBar);
    m_state->setObjectName(QStringLiteral("compensationState"));
    m_live->setObjectName(QStringLiteral("liveValues"));
    m_detail->setObjectName(QStringLiteral("stateDetail"));
    for (QLabel* label : {m_live, m_detail})
        label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* texts = new QVBoxLayout;
    texts->setContentsMargins(0, 0, 0, 0);
    texts->setSpacing(0);
    texts->addWidget(m_live);
    texts->addWidget(m_detail);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 3, 12, 3);
    layout->setSpacing(16);
    layout->addWidget(m_state);
    layout->addLayout(texts);
    connect(&controller, &WizardController::liveChanged, this, &StateField::takeLive);
    connect(&controller, &WizardController::statusChanged, this, &StateField::takeLive);
    connect(&controller, &WizardController::drivesChanged, this, &StateField::display);
    connect(&controller, &WizardController::currentAxisChanged, this, &StateField::takeAxis);
    connect(&controller, &WizardController::selectedTableChanged, this, &StateField::display);
    showFont();
    retranslate();
}

void StateField::retranslate()
{
    m_state->setToolTip(tr("The state of the compensation of this axis"));
    m_live->setToolTip(tr("Live values of the drive: the compensation output and the table index"));
    display();
}

void StateField::takeAxis()
{
    m_known.reset();
    display();
}

void StateField::takeLive()
{
    if (const auto& status = m_controller.status(); status && m_controller.isConnected()) {
        m_read = QDateTime::currentDateTime();
        if (m_known != status->axis.state) {
            m_wasSeenToBegin = m_known.has_value();
            m_known = status->axis.state;
            m_since = m_read;
        }
    }
    display();
}

QString StateField::sinceText() const
{
    return m_wasSeenToBegin ? axiscomp::ui::sinceText(m_since)
                            : tr("since before %1").arg(clockText(m_since));
}

QString StateField::tableText() const
{
    const AxisStatus& status = *m_controller.status();
    if (!status.table)
        return noTableText();
    const auto table = m_controller.driveTable();
    const QString name = table && !table->name.empty() ? QString::fromStdString(table->name)
                                                       : QString::fromStdString(status.setup.slot);
    return tableWithCrc(name, status.table->crc);
}

/// Never "proved" before something was seen that a wrong table would have shown.
QString StateField::proofText() const
{
    const auto& proof = m_controller.movingProof();
    if (!proof)
        return {};
    if (proof->failure())
        return tr("contradicts its table");
    if (!proof->hasContent())
        return tr("not proved yet");
    return tr("proved over %1 of the table").arg(percentageText(proof->part().share()));
}

QString StateField::detailText() const
{
    QStringList parts{sinceText(), tableText(), proofText()};
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

void StateField::display()
{
    const auto& status = m_controller.status();
    const bool isLive = status && m_controller.isConnected();
    setVisible(m_controller.currentAxis() >= 0);
    m_tone = isLive ? stateTone(status->axis.state) : Tone::Error;
    m_state->setText(isLive ? stateWord(status->axis) : notConnectedWord());
    m_live->setVisible(status.has_value());
    m_detail->setVisible(status.has_value());
    if (status) {
        m_live->setText(liveText(*status));
        m_detail->setText(isLive ? detailText() : asReadText(m_read));
    }
    announceName(*this, tr("Compensation: %1", "state").arg(m_state->text()));
    if (const QString detail = status ? m_detail->text() : QString();
        detail != accessibleDescription())
        setAccessibleDescription(detail);
    QPalette texts = palette();
    if (!isLive)
        texts.setColor(QPalette::WindowText, mutedTextColor(palette()));
    m_live->setPalette(texts);
    m_detail->setPalette(texts);
    update();
}

void StateField::showFont()
{
    QFont large = font();
    large.setBold(true);
    large.setPointSizeF(font().pointSizeF() * 1.8);
    m_state->setFont(large);
    QFont small = font();
    small.setPointSizeF(font().pointSizeF() * 0.9);
    m_detail->setFont(small);
}

void StateField::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event)
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(frameColor(m_tone, palette()), 1.0));
    painter.setBrush(fillColor(m_tone, palette()));
    constexpr double radius = 4.0;
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), radius, radius);
}

void StateField::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::FontChange)
        showFont();
    else if (event->type() == QEvent::PaletteChange)
        display();
    QWidget::changeEvent(event);
}

} // namespace axiscomp::ui
