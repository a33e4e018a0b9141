// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measuring/plan_dialog.h"

#include "core/io/local_file.h"
#include "core/text/token_scanner.h"
#include "ui/dialogs/several_writes_dialog.h"
#include "ui/fields/number_box.h"
#include "ui/measuring/plan_targets_model.h"
#include "ui/measuring/plan_text.h"
#include "ui/style/tone_label.h"
#include "ui/text/free_key.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableView>

#include <limits>

namespace axiscomp::ui {

namespace {

constexpr int positionDecimals = 3;
constexpr int countPage = 0;
constexpr int spacingPage = 1;

NumberBox* positionBox(double lowest)
{
    auto* box = new NumberBox;
    box->setDecimals(positionDecimals);
    box->setRange(lowest, largestPlanPosition);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    return box;
}

} // namespace

PlanDialog::PlanDialog(const MeasuredAxis& axis, FilePicker picker, QString folder, QWidget* parent)
    : QDialog(parent)
    , m_picker(std::move(picker))
    , m_folder(std::move(folder))
    , m_travel(axis.travel)
    , m_axisName(qString(axis.name))
    , m_isAxisAngular(axis.isAngular)
    , m_job([this](const Planned& plan) { take(plan); })
    , m_form(new QFormLayout)
    , m_axis(new QLineEdit)
    , m_unit(new QComboBox)
    , m_from(positionBox(-largestPlanPosition))
    , m_to(positionBox(-largestPlanPosition))
    , m_byLabel(new ToneLabel)
    , m_by(new QComboBox)
    , m_targets(new QStackedWidget)
    , m_count(new QSpinBox)
    , m_spacing(positionBox(0.0))
    , m_period(positionBox(0.0))
    , m_cycles(new QSpinBox)
    , m_overrun(positionBox(0.0))
    , m_feed(positionBox(0.0))
    , m_dwell(positionBox(0.0))
    , m_seed(new QSpinBox)
    , m_model(new PlanTargetsModel(this))
    , m_preview(new QTableView)
    , m_summary(wrappedLabel("planSummary"))
    , m_reason(wrappedLabel("planReason"))
    , m_dialectLabel(new ToneLabel)
    , m_dialect(new QComboBox)
    , m_savePlan(new QPushButton)
    , m_saveProgram(new QPushButton)
    , m_close(new QPushButton)
{
    setObjectName(QStringLiteral("planDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    propose(axis);
    follow();
    retranslate();
    compute();
}

PlanDialog::~PlanDialog() = default;

void PlanDialog::build()
{
    auto* columns = new QHBoxLayout;
    columns->setSpacing(16);
    columns->addWidget(buildFields());
    columns->addWidget(buildPreview(), 1);
    m_reason->setMinimumHeight(2 * m_reason->fontMetrics().lineSpacing());
    m_reason->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_dialect->setObjectName(QStringLiteral("dialectField"));
    m_dialectLabel->setBuddy(m_dialect);
    for (int n = 0; n < static_cast<int>(gcodeDialectNames().size()); ++n)
        m_dialect->addItem(QString());
    m_savePlan->setObjectName(QStringLiteral("savePlanButton"));
    m_savePlan->setDefault(true);
    m_saveProgram->setObjectName(QStringLiteral("saveProgramButton"));
    m_saveProgram->setAutoDefault(false);
    m_close->setObjectName(QStringLiteral("closePlanButton"));
    m_close->setAutoDefault(false);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_dialectLabel);
    buttons->addWidget(m_dialect);
    buttons->addWidget(m_saveProgram);
    buttons->addStretch(1);
    buttons->addWidget(m_savePlan);
    buttons->addWidget(m_close);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addLayout(columns, 1);
    layout->addWidget(m_reason);
    layout->addLayout(buttons);
    resize(820, 560);
}

QWidget* PlanDialog::buildFields()
{
    constexpr int mostCycles = 1000;
    m_unit->addItems({QStringLiteral("mm"), QStringLiteral("°")});
    m_cycles->setRange(0, mostCycles);
    m_seed->setRange(0, std::numeric_limits<int>::max());
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->setContentsMargins(0, 0, 0, 0);
    addField(AxisField, m_axis, "planAxisField");
    addField(UnitField, m_unit, "planUnitField");
    addField(FromField, m_from, "fromField");
    addField(ToField, m_to, "toField");
    addField(TargetsField, buildTargets(), "targetsField");
    addField(PeriodField, m_period, "periodField");
    addField(CyclesField, m_cycles, "cyclesField");
    addField(OverrunField, m_overrun, "overrunField");
    addField(FeedField, m_feed, "feedField");
    addField(DwellField, m_dwell, "dwellField");
    addField(SeedField, m_seed, "seedField");
    m_labels[TargetsField]->setBuddy(m_count);
    auto* fields = new QWidget;
    fields->setLayout(m_form);
    return fields;
}

QWidget* PlanDialog::buildTargets()
{
    m_by->setObjectName(QStringLiteral("targetsByField"));
    m_by->addItems({QString(), QString()});
    constexpr int mostTargets = 1'000'000; // too many is said, not prevented
    m_count->setObjectName(QStringLiteral("countField"));
    m_count->setRange(0, mostTargets);
    m_spacing->setObjectName(QStringLiteral("spacingField"));
    m_targets->addWidget(m_count);
    m_targets->addWidget(m_spacing);
    m_targets->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_byLabel->setBuddy(m_by);
    m_form->addRow(m_byLabel, m_by);
    return m_targets;
}

QWidget* PlanDialog::buildPreview()
{
    m_preview->setObjectName(QStringLiteral("planPreview"));
    m_preview->setModel(m_model);
    m_preview->setAlternatingRowColors(true);
    m_preview->setTabKeyNavigation(false);
    m_preview->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_preview->setSelectionMode(QAbstractItemView::SingleSelection);
    m_preview->verticalHeader()->hide();
    m_preview->verticalHeader()->setDefaultSectionSize(m_preview->fontMetrics().height() + 6);
    m_preview->horizontalHeader()->setHighlightSections(false);
    m_preview->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    auto* preview = new QWidget;
    auto* layout = new QVBoxLayout(preview);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_preview, 1);
    layout->addWidget(m_summary);
    return preview;
}

void PlanDialog::addField(Field field, QWidget* editor, const char* name)
{
    editor->setObjectName(QLatin1StringView(name));
    auto* label = new ToneLabel;
    label->setBuddy(editor);
    m_form->addRow(label, editor);
    m_labels.at(field) = label;
    m_editors.at(field) = editor;
}

void PlanDialog::propose(const MeasuredAxis& axis)
{
    const MeasuringPlanRequest usual;
    constexpr double usualEnd = 100.0;
    constexpr int usualCount = 21;
    m_axis->setText(axis.name.empty() ? qString(usual.axis) : qString(axis.name));
    m_unit->setCurrentIndex(axis.isAngular ? 1 : 0);
    const auto ends = axis.travel ? proposedEnds(*axis.travel) : std::nullopt;
    m_from->setValue(ends ? ends->from : 0.0);
    m_to->setValue(ends ? ends->to : usualEnd);
    m_count->setValue(usualCount);
    m_spacing->setValue((m_to->value() - m_from->value()) / (usualCount - 1));
    m_cycles->setValue(usual.cycles);
    m_feed->setValue(usual.feedPerMinute);
    m_dwell->setValue(usual.dwellSeconds);
    m_seed->setValue(static_cast<int>(usual.seed));
}

void PlanDialog::follow()
{
    connect(m_axis, &QLineEdit::textChanged, this, &PlanDialog::compute);
    connect(m_unit, &QComboBox::currentIndexChanged, this, &PlanDialog::showUnits);
    connect(m_by, &QComboBox::currentIndexChanged, this, [this](int page) {
        m_targets->setCurrentIndex(page);
        m_labels[TargetsField]->setBuddy(m_targets->currentWidget());
        compute();
    });
    for (NumberBox* box : {m_from, m_to, m_spacing, m_period, m_overrun, m_feed, m_dwell}) {
        connect(box, &QDoubleSpinBox::valueChanged, this, &PlanDialog::compute);
        connect(box, &NumberBox::problemChanged, this, &PlanDialog::showState);
    }
    for (QSpinBox* box : {m_count, m_cycles, m_seed})
        connect(box, &QSpinBox::valueChanged, this, &PlanDialog::compute);
    connect(m_dialect, &QComboBox::currentIndexChanged, this, &PlanDialog::showState);
    connect(m_savePlan, &QPushButton::clicked, this, [this] { askAndSave(false); });
    connect(m_saveProgram, &QPushButton::clicked, this, [this] { askAndSave(true); });
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
}

void PlanDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void PlanDialog::retranslate()
{
    setWindowTitle(tr("New Program"));
    m_by->setItemText(countPage, tr("Number"));
    m_by->setItemText(spacingPage, tr("Mean spacing"));
    m_dialect->setItemText(static_cast<int>(GcodeDialect::LinuxCnc), QStringLiteral("LinuxCNC"));
    m_dialect->setItemText(static_cast<int>(GcodeDialect::Fanuc), QStringLiteral("Fanuc"));
    m_dialect->setItemText(static_cast<int>(GcodeDialect::Siemens), QStringLiteral("Siemens"));
    nameFields();
    m_dialectLabel->setText(tr("Cont&rol"));
    m_dialect->setAccessibleName(withoutKey(m_dialectLabel->text()));
    m_dialect->setToolTip(tr("The control of the machine, which plays the program"));
    m_dialect->setAccessibleDescription(m_dialect->toolTip());
    m_saveProgram->setText(tr("Save Pro&gram…"));
    m_savePlan->setText(tr("Save &Plan…"));
    m_close->setText(tr("Clo&se"));
    m_close->setToolTip(tr("What was not saved is lost (Esc)"));
    m_close->setAccessibleDescription(m_close->toolTip());
    m_preview->setAccessibleName(tr("Targets"));
    m_model->retranslate();
    showUnits();
}

void PlanDialog::nameFields()
{
    const auto name = [this](Field field, const QString& label, const QString& description) {
        m_labels.at(field)->setText(label);
        QWidget& editor = *m_editors.at(field);
        editor.setAccessibleName(withoutKey(label));
        editor.setToolTip(description);
        editor.setAccessibleDescription(description);
    };
    name(AxisField, tr("A&xis"), tr("As the drive or the control names it"));
    name(UnitField, tr("&Unit"), tr("Of all positions of the plan"));
    name(FromField, tr("&First target"), tr("Measured in every run"));
    name(ToField, tr("&Last target"), tr("Measured in every run; above the first"));
    name(TargetsField, tr("&Targets"), tr("How many, or how far apart in the mean"));
    name(PeriodField, tr("&Known period"),
        tr("Of the axis's error, such as the lead of its screw: targets are spread over it"));
    name(CyclesField, tr("&Cycles"), tr("Runs in each direction; the standard wants five"));
    name(OverrunField, tr("&Overrun"),
        tr("How far the axis moves in the direction of a run before its first target"));
    name(FeedField, tr("F&eed"), tr("Of the moves in the program"));
    name(DwellField, tr("D&well"), tr("How long the axis stands at each target, to be measured"));
    name(SeedField, tr("Ran&dom seed"),
        tr("Another number gives other targets, the same number the same"));
    m_byLabel->setText(tr("Given b&y"));
    m_by->setAccessibleName(withoutKey(m_byLabel->text()));
    m_by->setToolTip(tr("Whether targets are counted, or their distance is given"));
    m_by->setAccessibleDescription(m_by->toolTip());
    for (QWidget* box : {static_cast<QWidget*>(m_count), static_cast<QWidget*>(m_spacing)}) {
        box->setToolTip(m_editors[TargetsField]->toolTip());
        box->setAccessibleDescription(box->toolTip());
    }
    m_count->setAccessibleName(tr("Number of targets"));
    m_spacing->setAccessibleName(tr("Mean spacing of targets"));
    m_period->setSpecialValueText(tr("none known"));
    m_overrun->setSpecialValueText(tr("by the range"));
}

void PlanDialog::showUnits()
{
    const bool isAngular = m_unit->currentIndex() == 1;
    const QString unit = isAngular ? QStringLiteral(" °") : QStringLiteral(" mm");
    for (NumberBox* box : {m_from, m_to, m_spacing, m_period, m_overrun})
        box->setSuffix(unit);
    m_feed->setSuffix(unit + QStringLiteral("/min"));
    m_dwell->setSuffix(QStringLiteral(" s"));
    compute();
}

MeasuringPlanRequest PlanDialog::request() const
{
    MeasuringPlanRequest request;
    request.axis = m_axis->text().trimmed().toStdString();
    request.isAngular = m_unit->currentIndex() == 1;
    request.from = m_from->value();
    request.to = m_to->value();
    if (m_by->currentIndex() == countPage)
        request.count = m_count->value();
    else
        request.spacing = m_spacing->value();
    if (m_period->value() > 0.0)
        request.period = m_period->value();
    request.cycles = m_cycles->value();
    request.seed = static_cast<std::uint64_t>(m_seed->value());
    if (m_overrun->value() > 0.0)
        request.overrun = m_overrun->value();
    request.feedPerMinute = m_feed->value();
    request.dwellSeconds = m_dwell->value();
    return request;
}

void PlanDialog::compute()
{
    const MeasuringPlanRequest wanted = request();
    m_fault = measuringPlanFault(wanted);
    m_plan.reset();
    m_outcome.clear();
    m_hasFailed = false;
    m_job.cancel();
    if (m_fault)
        m_model->setPlan(nullptr);
    else
        m_job.start([wanted](const std::stop_token&) -> Planned {
            AXISCOMP_TRY(auto plan, makeMeasuringPlan(wanted));
            return std::make_shared<const MeasuringPlan>(std::move(plan));
        });
    showState();
}

void PlanDialog::take(const Planned& plan)
{
    m_plan = plan ? *plan : nullptr;
    if (!plan) {
        m_outcome = errorText(plan.error());
        m_hasFailed = true;
    }
    m_model->setPlan(m_plan);
    showState();
}

QString PlanDialog::nameOf(Field field) const
{
    return withoutKey(m_labels.at(field)->text());
}

const NumberBox* PlanDialog::refusedBox() const
{
    for (const NumberBox* box : {m_from, m_to, m_spacing, m_period, m_overrun, m_feed, m_dwell}) {
        const bool isAsked = box != m_spacing || m_by->currentIndex() == spacingPage;
        if (isAsked && !box->problem().isEmpty())
            return box;
    }
    return nullptr;
}

QString PlanDialog::summary() const
{
    if (!m_plan)
        return {};
    const PlanTravel travel = planTravel(*m_plan);
    return tr("%1. The axis moves from %2 to %3: check that this way is free.")
        .arg(planSummaryText(*m_plan), planPositionText(travel.lowest),
            planPositionText(travel.highest, m_plan->isAngular));
}

void PlanDialog::showState()
{
    static constexpr std::array fields{AxisField, FromField, ToField, TargetsField, PeriodField,
        CyclesField, OverrunField, FeedField, DwellField};
    const auto faulty = [this] { return fields.at(static_cast<std::size_t>(m_fault->field)); };
    const NumberBox* const refused = refusedBox();
    const auto isWrong = [&](int field) {
        const QWidget* editor =
            field == TargetsField ? m_spacing : m_editors.at(static_cast<std::size_t>(field));
        return refused ? editor == refused : m_fault && faulty() == field;
    };
    for (int field = 0; field < FieldCount; ++field)
        m_labels.at(static_cast<std::size_t>(field))
            ->setTone(isWrong(field) ? std::optional(Tone::Error) : std::nullopt);
    const bool isOfAxis = m_plan && m_plan->isAngular == m_isAxisAngular
        && sameLetters(m_plan->axis, m_axisName.toStdString());
    const Text travel = isOfAxis ? travelProblem(*m_plan, m_travel) : Text();
    if (refused) {
        m_reason->setTone(Tone::Error);
        m_reason->setText(refused->problem());
    } else if (m_fault) {
        m_reason->setTone(Tone::Error);
        m_reason->setText(tr("%1: %2").arg(nameOf(faulty()), sentenceText(m_fault->reason)));
    } else if (!m_outcome.isEmpty()) {
        m_reason->setTone(m_hasFailed ? Tone::Error : Tone::Success);
        m_reason->setText(m_outcome);
    } else if (!travel.isEmpty()) {
        m_reason->setTone(Tone::Warning);
        m_reason->setText(sentenceText(travel));
    } else {
        m_reason->setTone(std::nullopt);
        m_reason->setText(tr("This program never moves an axis: the control of the machine plays "
                             "the program, or a person moves from target to target."));
    }
    m_summary->setText(summary());
    const bool maySave = m_plan && !refused;
    m_savePlan->setEnabled(maySave);
    m_saveProgram->setEnabled(maySave);
    m_savePlan->setToolTip(
        maySave ? tr("For Capture, which takes the values by it") : m_reason->text());
    m_saveProgram->setToolTip(
        maySave ? tr("G-code for the control of the machine") : m_reason->text());
    for (QPushButton* button : {m_savePlan, m_saveProgram})
        button->setAccessibleDescription(button->toolTip());
}

void PlanDialog::askAndSave(bool isProgram)
{
    if (!m_plan)
        return;
    const auto dialect = static_cast<GcodeDialect>(m_dialect->currentIndex());
    FileQuestion question;
    question.purpose =
        isProgram ? FileQuestion::Purpose::SaveProgram : FileQuestion::Purpose::SavePlan;
    question.title = isProgram ? tr("Save Program") : tr("Save Plan");
    const QString extension = isProgram ? qString(gcodeExtension(dialect)) : QStringLiteral(".csv");
    question.filter = isProgram ? tr("Programs (*%1);;All files (*)").arg(extension)
                                : tr("Plans (*.csv);;All files (*)");
    question.start = QDir(m_folder).filePath(
        QStringLiteral("plan-%1%2")
            .arg(QString(qString(m_plan->axis)).replace(u'/', u'-'), extension));
    m_picker(*this, question, [this, isProgram](const QString& path) {
        if (!path.isEmpty())
            save(path, isProgram);
    });
}

/// What was planned when it was asked for: the dialog is modal to the question.
void PlanDialog::save(const QString& path, bool isProgram)
{
    if (!m_plan)
        return;
    const auto dialect = static_cast<GcodeDialect>(m_dialect->currentIndex());
    m_folder = QFileInfo(path).absolutePath();
    const auto saved =
        inBackground<Result<void>>([plan = m_plan, path, isProgram, dialect]() -> Result<void> {
            const std::filesystem::path file = QFileInfo(path).filesystemAbsoluteFilePath();
            if (!isProgram && isProgramFile(file))
                return fail(ErrorCode::FileNotWritable,
                    {{"file", file.filename().string()},
                        {"reason",
                            AXISCOMP_TEXT("Error",
                                "its name is one of a program for a control, and a plan in it "
                                "would mislead the control; choose a name that ends in .csv")}});
            std::string text = measuringPlanCsv(*plan);
            if (isProgram) {
                AXISCOMP_TRY(text, gcodeProgram(*plan, dialect));
            }
            return saveFile(file, asBytes(text));
        });
    whenDone(saved, this, [this, path, isProgram, plan = m_plan](const Result<void>& result) {
        m_hasFailed = !result;
        m_outcome =
            result ? tr("Saved as %1.").arg(QFileInfo(path).fileName()) : errorText(result.error());
        showState();
        if (result)
            Q_EMIT this->saved(path, plan, isProgram);
    });
}

} // namespace axiscomp::ui
