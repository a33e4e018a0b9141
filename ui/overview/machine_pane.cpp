// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/overview/machine_pane.h"

#include "core/text/utf8.h"
#include "ui/controller/machine_controller.h"
#include "ui/data/problem_model.h"
#include "ui/overview/drift_text.h"
#include "ui/style/busy_mark.h"
#include "ui/style/tone_label.h"
#include "ui/style/warning_list.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QHeaderView>
#include <QPushButton>
#include <QTreeView>

#include <algorithm>
#include <array>

namespace axiscomp::ui {

MachinePane::MachinePane(MachineController& machine, QWidget* parent)
    : QWidget(parent)
    , m_machine(machine)
    , m_summary(new ToneLabel)
    , m_busy(new BusyMark)
    , m_planAgain(new QPushButton)
    , m_apply(new QPushButton)
    , m_close(new QPushButton)
    , m_warnings(new WarningList)
    , m_problemModel(new ProblemModel(this))
    , m_problems(new QTreeView)
{
    setObjectName(QStringLiteral("machinePane"));
    build();
    connect(m_planAgain, &QPushButton::clicked, &machine, &MachineController::planAgain);
    connect(m_apply, &QPushButton::clicked, this, &MachinePane::applyRequested);
    connect(m_close, &QPushButton::clicked, &machine, &MachineController::close);
    connect(&machine, &MachineController::fileChanged, this, &MachinePane::refresh);
    connect(&machine, &MachineController::fileChanged, this, &MachinePane::showProblems);
    connect(&machine, &MachineController::driftChanged, this, &MachinePane::refresh);
    retranslate();
    showProblems();
}

void MachinePane::build()
{
    m_summary->setObjectName(QStringLiteral("machineSummary"));
    m_summary->setWordWrap(true);
    m_planAgain->setObjectName(QStringLiteral("planAgain"));
    m_apply->setObjectName(QStringLiteral("applyMachine"));
    m_close->setObjectName(QStringLiteral("closeMachine"));
    for (QPushButton* button : {m_planAgain, m_apply, m_close})
        button->setAutoDefault(false);
    m_warnings->setObjectName(QStringLiteral("machineWarnings"));
    m_problems->setObjectName(QStringLiteral("machineProblems"));
    m_problems->setModel(m_problemModel);
    m_problems->setRootIsDecorated(false);
    m_problems->setAlternatingRowColors(true);
    m_problems->setWordWrap(true);
    m_problems->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_problems->header()->setStretchLastSection(true);
    constexpr int lines = 7;
    m_problems->setMaximumHeight(lines * (m_problems->fontMetrics().height() + 8));
    auto* head = new QHBoxLayout;
    head->addWidget(m_summary, 1);
    head->addWidget(m_busy);
    head->addWidget(m_planAgain);
    head->addWidget(m_apply);
    head->addWidget(m_close);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(head);
    layout->addWidget(m_problems);
    layout->addWidget(m_warnings);
}

void MachinePane::retranslate()
{
    m_planAgain->setText(tr("&Plan Again"));
    m_planAgain->setToolTip(
        tr("Reads the machine file and its tables again and compares all drives with them"));
    m_planAgain->setAccessibleDescription(m_planAgain->toolTip());
    m_apply->setText(tr("&Apply…"));
    m_apply->setToolTip(tr("Show what would be written to all drives, before anything is written"));
    m_apply->setAccessibleDescription(m_apply->toolTip());
    m_close->setText(tr("Close Machine &File"));
    m_close->setToolTip(tr("The drives stay connected; nothing is changed"));
    m_close->setAccessibleDescription(m_close->toolTip());
    m_problems->setAccessibleName(tr("Problems of the machine file"));
    m_problemModel->retranslate();
    refresh();
}

void MachinePane::refresh()
{
    const bool isOpen = !m_machine.path().isEmpty();
    const auto& file = m_machine.file();
    m_summary->setText(isOpen ? summary() : QString());
    m_summary->setTone(file && file->refusal && !m_machine.isReading() ? std::optional(Tone::Error)
                                                                       : std::nullopt);
    m_busy->setBusy(m_machine.isReading() || m_machine.isAsking());
    m_apply->setEnabled(file && !file->refusal);
    m_planAgain->setEnabled(!m_machine.isReading() && !m_machine.isAsking());
    if (const QStringList now = warnings(); now != m_warnings->warnings())
        m_warnings->setWarnings(now);
    setVisible(isOpen);
}

void MachinePane::showProblems()
{
    const auto& file = m_machine.file();
    m_problemModel->setProblems(file ? file->reading.diagnostics : std::vector<Diagnostic>());
    m_problems->setVisible(m_problemModel->rowCount() > 0);
}

QString MachinePane::summary() const
{
    const QString path = m_machine.path();
    const QString fileName = QFileInfo(path).fileName();
    const auto& file = m_machine.file();
    if (!file)
        return tr("Reading %1 …").arg(fileName);
    if (file->refusal)
        return errorText(*file->refusal);
    using State = AxisDrift::State;
    struct Count {
        State state;
        QString words;
        std::size_t count = 0;
    };
    std::array counts{Count{State::AsFile, tr("as the file says: %1", "number of axes")},
        Count{State::Differs, tr("differ: %1", "number of axes")},
        Count{State::Problem, tr("cannot be compared: %1", "number of axes")},
        Count{State::Unreachable, tr("not reachable: %1", "number of axes")},
        Count{State::NotConnected, tr("not among the connections: %1", "number of axes")},
        Count{State::Waiting, tr("not compared yet: %1", "number of axes")}};
    for (const MachineDriveState& drive : m_machine.drives())
        for (std::size_t axis = 0; axis < drive.wanted.axes.size(); ++axis) {
            const State state = MachineController::driftOf(drive, axis).state;
            ++std::ranges::find(counts, state, &Count::state)->count;
        }
    QStringList parts;
    for (const Count& count : counts)
        if (count.count > 0)
            parts += count.words.arg(countText(count.count));
    const QString name = qString(shownText(file->reading.machine->name));
    const QString title =
        name.isEmpty() ? fileName : tr("%1 (%2)", "file and machine").arg(fileName, name);
    const QString said =
        tr("%1: axes %2.", "machine file and numbers of axes").arg(title, listText(parts));
    const QDateTime looked = m_machine.oldestLook();
    return looked.isValid() ? said + u' ' + tr("Compared at %1.").arg(momentText(looked)) : said;
}

/// What no row of the list stands for.
QStringList MachinePane::warnings() const
{
    QStringList warnings;
    for (const MachineDriveState& drive : m_machine.drives()) {
        const auto warn = [&](std::optional<std::size_t> axis, const QString& what) {
            warnings += tr("%1: %2", "drive or axis, and what is wrong")
                            .arg(machinePlaceText(drive, axis), what);
        };
        if (!drive.isConnected)
            warn({}, tr("This drive is not among the connections any more."));
        if (!drive.look)
            continue;
        if (drive.look->problem)
            warn({}, errorText(*drive.look->problem));
        for (const PlanProblem& problem : drive.look->problems(true)) {
            const bool hasRow = problem.axis && drive.look->plan->axes[*problem.axis].axis >= 0;
            if (!hasRow && !drive.look->problem)
                warn(problem.axis, errorText(problem.error));
        }
    }
    return warnings;
}

} // namespace axiscomp::ui
