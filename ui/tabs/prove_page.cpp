// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/prove_page.h"

#include "core/text/crc_text.h"
#include "ui/record/comparison_figures_model.h"
#include "ui/record/record_model.h"
#include "ui/record/residual_model.h"
#include "ui/style/row_table.h"
#include "ui/style/symbols.h"
#include "ui/style/tone_label.h"
#include "ui/tabs/file_views.h"
#include "ui/tabs/measurement_files.h"
#include "ui/tabs/next_step.h"
#include "ui/tabs/residual_plot.h"
#include "ui/tabs/tab_columns.h"
#include "ui/text/fine_scale.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QHeaderView>
#include <QPushButton>
#include <QSplitter>
#include <QTableView>

#include <algorithm>

namespace axiscomp::ui {

namespace {

/// "A 12.00 µm (tolerance 10.00 µm)", of all verdicts with this result.
QString figuresWith(const ComparisonState& state, VerdictResult result)
{
    QStringList figures;
    for (const Verdict& verdict : state.comparison->verdicts) {
        if (verdict.result != result)
            continue;
        const QString name = qString(figureName(verdict.tolerance.figure));
        const auto shown = comparedTexts(verdict, state.isAngular);
        figures += verdict.value
            ? ProvePage::tr("%1 %2 (tolerance %3)").arg(name, shown.value, shown.limit)
            : ProvePage::tr("%1 not defined (tolerance %2)").arg(name, shown.limit);
    }
    return listText(figures);
}

bool has(const Comparison& comparison, VerdictResult result)
{
    return std::ranges::find(comparison.verdicts, result, &Verdict::result)
        != comparison.verdicts.end();
}

bool isUncertaintyStated(const Comparison& comparison)
{
    return std::ranges::all_of(comparison.verdicts,
        [](const Verdict& verdict) { return verdict.uncertainty.has_value(); });
}

/// What the verdict is, without what to do next.
std::pair<Tone, QString> verdictSentence(const ComparisonState& state)
{
    const Comparison& comparison = *state.comparison;
    if (has(comparison, VerdictResult::Failed))
        return {Tone::Error,
            ProvePage::tr("Not within the tolerances: %1.")
                .arg(figuresWith(state, VerdictResult::Failed))};
    if (has(comparison, VerdictResult::NotDefined))
        return {Tone::Warning,
            ProvePage::tr("Not judged by: %1.").arg(figuresWith(state, VerdictResult::NotDefined))};
    if (has(comparison, VerdictResult::Undecided))
        return {Tone::Warning,
            ProvePage::tr("Undecided, since the uncertainty is too large: %1.")
                .arg(figuresWith(state, VerdictResult::Undecided))};
    if (comparison.isAsPredicted == false && !comparison.isNoBetter)
        return {Tone::Warning, ProvePage::tr("The machine is not as good as was predicted.")};
    if (!comparison.hints.empty())
        return {Tone::Warning, ProvePage::tr("The machine is no better than before.")};
    if (state.isCorrectedOtherwise)
        return {Tone::Warning,
            ProvePage::tr("The two are corrected differently for temperature or dead path, so that "
                          "they cannot be compared.")};
    if (comparison.verdicts.empty() && comparison.lesserRange)
        return {Tone::Warning,
            ProvePage::tr("The second measurement covers only part of the first one's travel.")};
    if (comparison.verdicts.empty())
        return {comparison.isAsPredicted ? Tone::Success : Tone::Information,
            ProvePage::tr("No tolerance is given, so there is no verdict.")};
    return {comparison.warnings.empty() ? Tone::Success : Tone::Warning,
        isUncertaintyStated(comparison)
            ? ProvePage::tr("Within the tolerances.")
            : ProvePage::tr("Within the tolerances (uncertainty not stated).")};
}

/// Whether the machine became as good as was promised, with the limit.
std::pair<Tone, QString> promiseSentence(const ComparisonState& state)
{
    const Comparison& comparison = *state.comparison;
    if (!comparison.heldOut)
        return {Tone::Information,
            ProvePage::tr(
                "Nothing was predicted between the targets: before and after are compared alone.")};
    const QString figure = qString(figureSymbol(comparison.promised));
    if (!comparison.largestAsPredicted)
        return {Tone::Warning,
            ProvePage::tr("Whether it is as predicted is open, since %1 is not defined after.")
                .arg(figure)};
    const double after = *comparison.after[comparison.promised].value;
    if (comparison.isNoBetter) {
        const QString words = comparison.isAsPredicted
            ? ProvePage::tr("Not as predicted, since the machine is no better than before: %3 is "
                            "%1 after and was %2 before.")
            : ProvePage::tr("Whether it is as predicted is open, since %3 is smaller than before "
                            "by no more than what cannot be told: %3 is %1 after and was %2 "
                            "before.");
        const auto [found, limit] =
            comparedTexts(after, *comparison.before[comparison.promised].value, state.isAngular);
        return {Tone::Warning, words.arg(found, limit, figure)};
    }
    const QString words = !comparison.isAsPredicted
        ? (comparison.lesserRange
                ? ProvePage::tr("Whether it is as predicted is open, since less of the axis was "
                                "measured: %3 is %1 after, and up to %2 is as predicted.")
                : ProvePage::tr("Whether it is as predicted is open, since the targets are farther "
                                "apart than before: %3 is %1 after, and up to %2 is as predicted."))
        : *comparison.isAsPredicted
        ? ProvePage::tr("As predicted: %3 is %1 after, and up to %2 is as predicted (1.2 times %3 "
                        "held out, and what cannot be told).")
        : ProvePage::tr("Not as predicted: %3 is %1 after, and up to %2 is as predicted (1.2 times "
                        "%3 held out, and what cannot be told).");
    const bool isGood = comparison.isAsPredicted == true && !state.isCorrectedOtherwise;
    const auto [found, limit] =
        comparedTexts(after, *comparison.largestAsPredicted, state.isAngular);
    return {isGood ? Tone::Success : Tone::Warning, words.arg(found, limit, figure)};
}

} // namespace

ProvePage::ProvePage(RecordModel& record, RecordModel& after, QWidget* parent)
    : QWidget(parent)
    , m_record(record)
    , m_after(after)
    , m_comparison(record, after)
    , m_figuresModel(new ComparisonFiguresModel(m_comparison, this))
    , m_residualModel(new ResidualModel(m_comparison, this))
    , m_files(new MeasurementFiles(after, QStringLiteral("after")))
    , m_stated(new QCheckBox)
    , m_keep(new QPushButton)
    , m_nextStep(new NextStep(QStringLiteral("proveHint")))
    , m_views(new FileViews(QStringLiteral("after")))
    , m_comparisonView(nullptr)
    , m_warnings(new ToneLabel)
    , m_promise(new NextStep(QStringLiteral("provePromise")))
    , m_hints(new ToneLabel)
    , m_figures(table("proveFigures", m_figuresModel))
    , m_plot(new ResidualPlot)
    , m_residual(table("proveResidual", m_residualModel))
{
    setObjectName(QStringLiteral("provePage"));
    build();
    connectParts();
    retranslate();
}

QTableView* ProvePage::table(const char* name, QAbstractItemModel* model) const
{
    QTableView* view = newRowTable(name, *model);
    view->horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return view;
}

void ProvePage::build()
{
    m_comparisonView = buildComparison();
    m_views->setObjectName(QStringLiteral("proveTabs"));
    m_views->insertTab(0, m_comparisonView, QString());
    m_views->insertTab(1, m_residual, QString());
    m_views->setCurrentIndex(0);
    fillWithColumns(*this, QStringLiteral("proveColumns"), buildLeft(), m_views);
}

QWidget* ProvePage::buildLeft()
{
    constexpr int gap = 12;
    m_stated->setObjectName(QStringLiteral("tableStated"));
    m_keep->setObjectName(QStringLiteral("keepAfter"));
    m_keep->setIcon(symbolIcon(Symbol::Add));
    auto* left = new QWidget;
    auto* layout = new QVBoxLayout(left);
    layout->setContentsMargins(0, 0, gap, 0);
    layout->addWidget(m_files, 1);
    layout->addWidget(m_stated);
    layout->addWidget(m_keep);
    layout->addWidget(m_nextStep);
    return left;
}

QWidget* ProvePage::buildComparison()
{
    m_warnings->setObjectName(QStringLiteral("proveWarnings"));
    m_hints->setObjectName(QStringLiteral("proveHints"));
    for (ToneLabel* label : {m_warnings, m_hints}) {
        label->setWordWrap(true);
        label->setTone(Tone::Warning);
    }
    // All of it is seen; the rest of the height is the plot's.
    const int rows = static_cast<int>(iso230FigureCount);
    const int height = m_figures->verticalHeader()->defaultSectionSize();
    m_figures->setMaximumHeight((rows + 2) * height);
    m_figures->setMinimumHeight(4 * height);
    auto* parts = new QSplitter(Qt::Vertical);
    parts->setObjectName(QStringLiteral("proveRows"));
    parts->setChildrenCollapsible(false);
    parts->addWidget(m_figures);
    parts->addWidget(m_plot);
    parts->setStretchFactor(0, 0);
    parts->setStretchFactor(1, 1);
    parts->setSizes({(rows + 2) * height, height});
    auto* view = new QWidget;
    auto* layout = new QVBoxLayout(view);
    layout->addWidget(m_warnings);
    layout->addWidget(m_promise);
    layout->addWidget(m_hints);
    layout->addWidget(parts, 1);
    return view;
}

void ProvePage::connectParts()
{
    connect(m_files, &MeasurementFiles::addRequested, this, &ProvePage::addRequested);
    connect(m_views, &FileViews::mappingChosen, m_files, &MeasurementFiles::mapColumns);
    connect(m_files, &MeasurementFiles::currentChanged, this,
        [this] { m_views->show(m_files->currentFile(), m_files->currentReading()); });
    connect(m_stated, &QCheckBox::clicked, this, [this](bool isStated) {
        // Of the table that the box names, whichever is in use by now.
        m_after.setStatedTable(isStated ? m_comparison.state().tableCrc : std::nullopt);
    });
    connect(m_keep, &QPushButton::clicked, &m_comparison, &ComparisonModel::keep);
    connect(&m_comparison, &ComparisonModel::changed, this, &ProvePage::follow);
    for (const RecordModel* model : {&m_record, &m_after})
        connect(model, &RecordModel::changed, this, &ProvePage::follow);
}

void ProvePage::retranslate()
{
    m_files->setTitle(tr("Second measurement"), tr("Files of the second measurement"));
    m_keep->setText(tr("Kee&p in the Record"));
    m_keep->setToolTip(
        tr("The second measurement, what it says of the prediction, and the verdict"));
    m_keep->setAccessibleDescription(m_keep->toolTip());
    m_stated->setToolTip(tr("For a file that does not say which table was active"));
    m_stated->setAccessibleDescription(m_stated->toolTip());
    m_views->setTabText(m_views->indexOf(m_comparisonView), tr("Before and after"));
    m_views->setTabText(m_views->indexOf(m_residual), tr("What is left"));
    m_figures->setAccessibleName(tr("Figures before, predicted, held out and after"));
    m_residual->setAccessibleName(tr("What is left at the targets"));
    m_files->retranslate();
    m_views->retranslate();
    m_figuresModel->retranslate();
    m_residualModel->retranslate();
    m_plot->retranslate();
    follow();
}

void ProvePage::setUnsaved(bool isUnsaved)
{
    m_isUnsaved = isUnsaved;
    sayNextStep();
}

bool ProvePage::isStated() const
{
    const auto& crc = m_comparison.state().tableCrc;
    return crc && m_after.record().statedTable == crc;
}

void ProvePage::follow()
{
    const ComparisonState& state = m_comparison.state();
    const bool isThere = state.comparison != nullptr;
    m_stated->setVisible(state.needsStatement);
    m_stated->setChecked(isStated());
    if (state.tableCrc)
        m_stated->setText(tr("The tabl&e %1 was active").arg(qString(crcText(*state.tableCrc))));
    m_keep->setEnabled(m_comparison.mayKeep());
    m_views->setTabVisible(m_views->indexOf(m_residual), isThere);
    m_plot->show(state);
    sayWarnings();
    sayPromise();
    sayNextStep();
    Q_EMIT standingChanged();
}

/// What the figures are, before anybody reads them.
void ProvePage::sayWarnings()
{
    const auto& comparison = m_comparison.state().comparison;
    m_warnings->setVisible(comparison && !comparison->warnings.empty());
    QStringList sentences;
    if (comparison)
        for (const JudgeWarning& warning : comparison->warnings)
            sentences += sentenceText(warning.text);
    m_warnings->setText(sentences.join(u' '));
}

void ProvePage::sayPromise()
{
    const auto& comparison = m_comparison.state().comparison;
    m_promise->setVisible(comparison != nullptr);
    m_hints->setVisible(comparison && !comparison->hints.empty());
    if (!comparison)
        return;
    QStringList hints;
    for (const ComparisonHint& hint : comparison->hints)
        hints += sentenceText(hint.text);
    m_hints->setText(tr("What to look at: %1").arg(hints.join(u' ')));
    const auto [tone, sentence] = promiseSentence(m_comparison.state());
    m_promise->say(tone, sentence);
}

std::pair<Tone, QString> ProvePage::missing() const
{
    const auto& calibration = m_record.record().calibration;
    if (!calibration)
        return {Tone::Information,
            tr("No table of this record is in use: a second measurement is compared with that of "
               "Measure alone. Open a record with a table to prove that one.")};
    if (!calibration->write)
        return {Tone::Information,
            tr("Write the table and activate it, measure again, and add the files of that "
               "measurement here.")};
    return {Tone::Information,
        tr("Measure again with the table active, and add the files of that measurement here.")};
}

std::pair<Tone, QString> ProvePage::result() const
{
    const ComparisonState& state = m_comparison.state();
    auto [tone, sentence] = verdictSentence(state);
    if (state.isKept)
        sentence += u' '
            + (m_isUnsaved
                    ? tr("The measurement is in the record: save that, and write the report.")
                    : tr("The measurement is in the record, and that is saved: write the report."));
    else if (m_comparison.mayKeep())
        sentence += u' ' + tr("Keep it in the record.");
    return {tone, sentence};
}

std::pair<Tone, QString> ProvePage::nextStep() const
{
    const RecordState& after = m_after.state();
    const ComparisonState& state = m_comparison.state();
    const auto refused = std::ranges::find_if(
        after.files, [](const ReadMeasurement& file) { return file.refusal.has_value(); });
    if (m_after.record().files.empty())
        return missing();
    if (m_after.isEvaluating() && !m_after.isMeasurementShown())
        return {Tone::Information, tr("The files are being read …")};
    if (refused != after.files.end())
        return {Tone::Error, errorText(*refused->refusal)};
    if (after.refusal)
        return {Tone::Error, errorText(*after.refusal)};
    if (state.needsStatement && !isStated())
        return {Tone::Warning,
            tr("The second measurement does not say which table was active. If it was the table "
               "%1, say so above; otherwise measure again with it.")
                .arg(qString(crcText(*state.tableCrc)))};
    if (state.refusal)
        return {Tone::Error, errorText(*state.refusal)};
    if (!state.comparison)
        return {Tone::Information,
            m_comparison.isComparing()
                ? tr("The measurements are being compared …")
                : tr("There is no measurement to compare it with: add that one in Measure.")};
    return result();
}

void ProvePage::sayNextStep()
{
    const auto [tone, sentence] = nextStep();
    m_nextStep->say(tone, sentence);
}

ProvePage::Standing ProvePage::standing() const
{
    const Tone tone = nextStep().first;
    if (tone == Tone::Error || tone == Tone::Warning)
        return Standing::Warning;
    return m_comparison.state().comparison && !m_after.record().files.empty() ? Standing::Ready
                                                                              : Standing::Empty;
}

} // namespace axiscomp::ui
