// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/capture_panel.h"

#include "ui/dialogs/several_writes_dialog.h"
#include "ui/measuring/capture_feed.h"
#include "ui/measuring/captured_plot.h"
#include "ui/measuring/plan_steps_model.h"
#include "ui/measuring/plan_text.h"
#include "ui/style/plain_label.h"
#include "ui/style/row_table.h"
#include "ui/style/tone_label.h"
#include "ui/tabs/next_step.h"
#include "ui/text/fine_scale.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSplitter>
#include <QTableView>

#include <cmath>

namespace axiscomp::ui {

namespace {

constexpr double digitsScale = 2.0; // three of them fit a window of 1280 pixels

/// As core reads it: with a decimal point. What has one already is not touched.
QString withDecimalPoint(QString text)
{
    const QString comma = QLocale().decimalPoint();
    return comma == QStringLiteral(".") || text.contains(u'.')
        ? text
        : text.replace(comma, QStringLiteral("."));
}

QString unitName(const std::string& unit)
{
    return QCoreApplication::translate("Unit", unit.c_str());
}

} // namespace

CapturePanel::CapturePanel(CaptureFeed& feed, QWidget* parent)
    : QWidget(parent)
    , m_feed(feed)
    , m_model(new PlanStepsModel(this))
    , m_title(new PlainLabel)
    , m_state(new NextStep(QStringLiteral("captureState")))
    , m_notes(wrappedLabel("captureNotes"))
    , m_typedRow(new QWidget)
    , m_typedLabel(new PlainLabel)
    , m_typed(new QLineEdit)
    , m_take(new QPushButton)
    , m_undo(new QPushButton)
    , m_pause(new QPushButton)
    , m_stop(new QPushButton)
    , m_steps(newRowTable("planSteps", *m_model))
    , m_plot(new CapturedPlot)
{
    setObjectName(QStringLiteral("capturePanel"));
    build();
    connect(m_take, &QPushButton::clicked, this, &CapturePanel::take);
    connect(m_typed, &QLineEdit::returnPressed, this, &CapturePanel::take);
    connect(m_typed, &QLineEdit::textChanged, this, &CapturePanel::showButtons);
    connect(m_undo, &QPushButton::clicked, &m_feed, &CaptureFeed::undo);
    connect(m_pause, &QPushButton::clicked, this, &CapturePanel::pauseOrResume);
    connect(m_stop, &QPushButton::clicked, &m_feed, &CaptureFeed::stop);
    connect(&m_feed, &CaptureFeed::changed, this, &CapturePanel::follow);
    m_typed->installEventFilter(this);
    retranslate();
}

void CapturePanel::build()
{
    m_title->setObjectName(QStringLiteral("captureTitle"));
    m_notes->setTone(Tone::Warning);
    auto* views = new QSplitter(Qt::Horizontal);
    views->setObjectName(QStringLiteral("captureViews"));
    views->setChildrenCollapsible(false);
    views->addWidget(m_steps);
    views->addWidget(m_plot);
    views->setStretchFactor(0, 1);
    views->setStretchFactor(1, 1);
    views->setSizes({500, 360});
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_title);
    layout->addWidget(buildDigits());
    layout->addWidget(m_state);
    m_typedRow->setLayout(buildTyped());
    layout->addWidget(m_typedRow);
    layout->addLayout(buildButtons());
    layout->addWidget(views, 1);
    layout->addWidget(m_notes);
}

QWidget* CapturePanel::buildDigits()
{
    static constexpr std::array names{"captureEncoder", "captureReference", "captureDifference"};
    auto* digits = new QWidget;
    auto* grid = new QGridLayout(digits);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(24);
    grid->setVerticalSpacing(0);
    for (int n = 0; n < DigitsCount; ++n) {
        const auto place = static_cast<std::size_t>(n);
        auto* name = new ToneLabel;
        name->setMuted();
        auto* number = new PlainLabel;
        number->setObjectName(QLatin1StringView(names.at(place)));
        QFont font = number->font();
        font.setPointSizeF(font.pointSizeF() * digitsScale);
        number->setFont(font);
        number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        name->setAlignment(Qt::AlignRight);
        name->setBuddy(number);
        // Its place stays where it is while digits come and go.
        number->setMinimumWidth(
            QFontMetrics(font).horizontalAdvance(QStringLiteral("-0000.000000 mm")));
        grid->addWidget(name, 0, n);
        grid->addWidget(number, 1, n);
        grid->setColumnStretch(n, 1);
        m_names.at(place) = name;
        m_digits.at(place) = number;
    }
    return digits;
}

QHBoxLayout* CapturePanel::buildTyped()
{
    m_typed->setObjectName(QStringLiteral("typedReference"));
    m_typed->setMaxLength(static_cast<int>(ReferenceLines::longestLine));
    m_typed->setMaximumWidth(
        m_typed->fontMetrics().horizontalAdvance(QStringLiteral("-00000.0000000 mm")) + 40);
    m_typedLabel->setBuddy(m_typed);
    m_take->setObjectName(QStringLiteral("takeButton"));
    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_typedLabel);
    row->addWidget(m_typed);
    row->addWidget(m_take);
    row->addStretch(1);
    return row;
}

QHBoxLayout* CapturePanel::buildButtons()
{
    m_undo->setObjectName(QStringLiteral("undoLastButton"));
    m_pause->setObjectName(QStringLiteral("pauseButton"));
    m_stop->setObjectName(QStringLiteral("stopButton"));
    auto* row = new QHBoxLayout;
    for (QPushButton* button : {m_undo, m_pause, m_stop})
        row->addWidget(button);
    row->addStretch(1);
    return row;
}

void CapturePanel::retranslate()
{
    m_names[Encoder]->setText(tr("Encoder"));
    m_names[Reference]->setText(tr("Reference"));
    m_names[Difference]->setText(tr("Reference - axis"));
    m_digits[Difference]->setToolTip(
        tr("The reference minus where the axis is: its encoder and what the drive adds"));
    m_steps->setAccessibleName(tr("Steps of the plan"));
    m_take->setText(tr("Ta&ke"));
    m_undo->setText(tr("Undo Las&t"));
    m_stop->setText(tr("Stop Capturin&g"));
    m_model->retranslate();
    m_plot->retranslate();
    follow();
}

void CapturePanel::follow()
{
    const CaptureView& view = m_feed.view();
    m_title->setText(view.phase == CaptureView::Phase::None
            ? QString()
            : tr("%1: values to %2").arg(view.axisLabel, QFileInfo(view.path).fileName()));
    m_title->setToolTip(view.path);
    m_typedRow->setVisible(view.isTyped);
    m_typedLabel->setText(tr("T&he instrument says [%1]").arg(unitName(view.unit)));
    m_typed->setAccessibleName(tr("What the instrument says, in %1").arg(unitName(view.unit)));
    showDigits();
    showSteps();
    followQuestion();
    showButtons();
    showNotes();
    const auto [tone, sentence] = state();
    m_state->say(tone, sentence);
}

void CapturePanel::showDigits()
{
    const CaptureView& view = m_feed.view();
    const bool isAngular = view.plan && view.plan->isAngular;
    const auto position = [&](double value) {
        return std::isfinite(value)
            ? qString(placeDigits(value, isAngular)).replace(u'.', QLocale().decimalPoint())
                + unitSuffix(isAngular ? "°" : "mm")
            : QStringLiteral("–");
    };
    QString difference = QStringLiteral("–");
    if (view.reading && std::isfinite(view.reading->difference())) {
        const std::optional<double> shown[] = {view.reading->difference()};
        difference = FineScale(fineUnit(shown, isAngular)).textWithUnit(*shown[0]);
    }
    const std::array texts{view.reading ? position(view.reading->encoder) : QStringLiteral("–"),
        view.reading ? position(view.reading->reference) : QStringLiteral("–"), difference};
    for (std::size_t n = 0; n < texts.size(); ++n) {
        m_digits.at(n)->setText(texts.at(n));
        m_digits.at(n)->setAccessibleName(m_names.at(n)->text() + u' ' + texts.at(n));
        // What is not read any more is not what is.
        m_digits.at(n)->setEnabled(
            view.phase == CaptureView::Phase::Running && !view.lost && !view.isWaiting);
    }
}

void CapturePanel::showSteps()
{
    const CaptureView& view = m_feed.view();
    const bool isSame = m_shownValues == view.values.size() && m_model->rowCount() > 0
        && m_model->dueRow() == static_cast<int>(view.values.size());
    if (isSame && view.phase == CaptureView::Phase::Running)
        return;
    m_shownValues = view.values.size();
    m_model->show(view.plan, view.values);
    if (const int due = m_model->dueRow(); due >= 0) {
        m_steps->setCurrentIndex(m_model->index(due, 0));
        revealDue();
    }
    if (view.plan)
        m_plot->show(*view.plan, view.values, m_model->unit());
    else
        m_plot->clear();
}

void CapturePanel::revealDue()
{
    if (const int due = m_model->dueRow(); due >= 0)
        m_steps->scrollTo(m_model->index(due, 0), QAbstractItemView::PositionAtCenter);
}

/// Rows that were chosen while there was no place for them yet are out of sight.
void CapturePanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    QMetaObject::invokeMethod(this, &CapturePanel::revealDue, Qt::QueuedConnection);
}

/// What is to be typed once more is typed, not confirmed; what was not understood is corrected.
void CapturePanel::followQuestion()
{
    const CaptureView& view = m_feed.view();
    if (view.isDoubted && !m_wasDoubted)
        m_typed->clear();
    if (view.isAsked && !m_wasAsked) {
        m_typed->clear();
        const QWidget* focus = focusWidget();
        if (isVisible() && (!window()->focusWidget() || (focus && isAncestorOf(focus))))
            m_typed->setFocus();
    }
    m_wasAsked = view.isAsked;
    m_wasDoubted = view.isDoubted;
}

QString CapturePanel::obstacle() const
{
    const CaptureView& view = m_feed.view();
    if (!m_feed.isActive())
        return tr("Nothing is being taken");
    if (view.lost)
        return tr("The drive does not answer");
    return {};
}

bool CapturePanel::canTake() const
{
    const CaptureView& view = m_feed.view();
    return view.phase == CaptureView::Phase::Running && view.isTyped && view.isAsked
        && !m_typed->text().trimmed().isEmpty();
}

void CapturePanel::showButtons()
{
    const CaptureView& view = m_feed.view();
    const bool isPaused = view.phase == CaptureView::Phase::Paused;
    m_pause->setText(isPaused ? tr("R&esume") : tr("Paus&e"));
    m_take->setEnabled(canTake());
    m_take->setToolTip(view.isAsked
            ? tr("Take what was typed for the step that is due (Enter or space bar)")
            : tr("A position is asked for as soon as the axis stands at the target that is due"));
    m_undo->setEnabled(m_feed.isActive() && !view.values.empty() && !view.lost);
    m_undo->setToolTip(!obstacle().isEmpty() ? obstacle()
            : view.values.empty()            ? tr("No value has been taken yet")
                                  : tr("Take the last value off the file; its step is due again"));
    m_pause->setEnabled(m_feed.isActive() && view.phase != CaptureView::Phase::Opening);
    m_pause->setToolTip(isPaused
            ? tr("Go on; the axis has to come to its target once more")
            : tr("Take nothing until Resume, such as while somebody works at the machine"));
    m_stop->setEnabled(m_feed.isActive());
    m_stop->setToolTip(tr("End here; what was taken stays in the file, and Capture goes on behind "
                          "it with the same plan"));
    for (QPushButton* button : {m_take, m_undo, m_pause, m_stop})
        button->setAccessibleDescription(button->toolTip());
}

void CapturePanel::showNotes()
{
    const CaptureView& view = m_feed.view();
    QStringList notes;
    if (view.isUnitAssumed)
        notes += tr("The drive does not say the unit of the axis: it is taken to be that of the "
                    "plan.");
    if (view.isClockBehind)
        notes += tr("The clock of this computer is behind the last value of the file: times go on "
                    "from there.");
    if (view.resolution && view.plan) {
        const std::optional<double> step[] = {view.resolution->step};
        notes += tr("The reference is a Single: at %1 its numbers are %2 apart.")
                     .arg(planPositionText(view.resolution->target, view.plan->isAngular),
                         FineScale(fineUnit(step, view.plan->isAngular)).textWithUnit(*step[0]));
    }
    const auto zero = view.plan && !view.values.empty()
        ? proposedZero(view.values.front(), *view.plan, view.scale)
        : std::nullopt;
    if (zero)
        notes += tr("The instrument is far from the axis, as if it said 0 at %1: if that is right, "
                    "begin a new file with this as the zero.")
                     .arg(planPositionText(*zero, view.plan->isAngular));
    m_notes->setText(notes.join(u'\n'));
    m_notes->setVisible(!notes.isEmpty());
}

QString CapturePanel::dueText() const
{
    const CaptureView& view = m_feed.view();
    if (!view.plan || view.isComplete())
        return {};
    const MeasuringStep& due = view.plan->steps[view.values.size()];
    const bool isAngular = view.plan->isAngular;
    const QString from = planPositionText(due.approach, isAngular);
    const QString target = planPositionText(due.target, isAngular);
    return due.direction == Approach::Up
        ? tr("Step %1 is due: %2, upwards from %3.").arg(due.step).arg(target, from)
        : tr("Step %1 is due: %2, downwards from %3.").arg(due.step).arg(target, from);
}

std::pair<Tone, QString> CapturePanel::runningState() const
{
    using Event = CaptureSession::Event;
    const CaptureView& view = m_feed.view();
    if (!view.reading)
        return {Tone::Information, dueText()};
    if (view.isAsked && !view.typedProblem.isEmpty())
        return {Tone::Warning, sentenceText(view.typedProblem)};
    switch (view.event) {
    case Event::Standing:
        return {Tone::Information,
            view.averaged > 0 ? tr("The axis stands at step %1: %2 of %3 readings.")
                                    .arg(view.values.size() + 1)
                                    .arg(view.averaged)
                                    .arg(view.readingsPerValue)
                              : tr("The axis stands; it is waited until it has come to rest.")};
    case Event::Refused:
        return {Tone::Warning, sentenceText(view.problem)};
    case Event::NoReference:
        if (view.isAsked)
            return {Tone::Information,
                tr("The axis stands at step %1: read the instrument, and type what it says.")
                    .arg(view.values.size() + 1)};
        return {Tone::Warning, sentenceText(view.problem)};
    default:
        return view.isTaken ? std::pair(Tone::Success, tr("Taken. %1").arg(dueText()))
                            : std::pair(Tone::Information, tr("The axis moves. %1").arg(dueText()));
    }
}

std::pair<Tone, QString> CapturePanel::endState() const
{
    const CaptureView& view = m_feed.view();
    const QString file = QFileInfo(view.path).fileName();
    const QString taken = view.plan
        ? tr("%1 of %2 values are in %3.")
              .arg(countText(view.values.size()), countText(view.plan->steps.size()), file)
        : QString();
    if (view.refusal)
        return {Tone::Error, errorText(*view.refusal) + u' ' + taken};
    if (!view.stopReason.isEmpty())
        return {Tone::Error, sentenceText(view.stopReason) + u' ' + taken};
    if (view.isComplete())
        return {Tone::Success,
            tr("Every step has its value: %1 values are in %2.")
                .arg(countText(view.values.size()), file)};
    return {Tone::Information,
        tr("Stopped. %1 Capture goes on behind them with the same plan and file.").arg(taken)};
}

std::pair<Tone, QString> CapturePanel::state() const
{
    const CaptureView& view = m_feed.view();
    switch (view.phase) {
    case CaptureView::Phase::None:
        return {Tone::Information, {}};
    case CaptureView::Phase::Opening:
        return {Tone::Information, tr("The drive is being read …")};
    case CaptureView::Phase::Ended:
        return endState();
    case CaptureView::Phase::Running:
    case CaptureView::Phase::Paused:
        break;
    }
    if (view.lost)
        return {Tone::Warning,
            tr("Nothing is taken: %1 It goes on when the drive answers again.")
                .arg(errorText(*view.lost))};
    if (view.isWaiting)
        return {Tone::Information,
            tr("Nothing is taken while the window does something else on this drive.")};
    if (view.phase == CaptureView::Phase::Paused)
        return {Tone::Information, tr("Paused: nothing is taken. %1").arg(dueText())};
    return runningState();
}

void CapturePanel::take()
{
    if (!canTake())
        return;
    m_feed.type(withDecimalPoint(m_typed->text().trimmed()));
    m_typed->selectAll();
}

void CapturePanel::pauseOrResume()
{
    if (m_feed.view().phase == CaptureView::Phase::Paused)
        m_feed.resume();
    else
        m_feed.pause();
}

/// No number has a blank at its end: the space bar takes it.
bool CapturePanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_typed && event->type() == QEvent::KeyPress
        && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
        take();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace axiscomp::ui
