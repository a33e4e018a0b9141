// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measuring/capture_dialog.h"

#include "core/io/local_file.h"
#include "core/metrology/measuring_plan.h"
#include "ui/controller/wizard_controller.h"
#include "ui/dialogs/several_writes_dialog.h"
#include "ui/fields/number_box.h"
#include "ui/fields/source_combo.h"
#include "ui/measuring/capture_feed.h"
#include "ui/measuring/plan_text.h"
#include "ui/session/axis_list.h"
#include "ui/style/busy_mark.h"
#include "ui/style/plain_label.h"
#include "ui/style/tone_label.h"
#include "ui/text/free_key.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>

#include <array>

namespace axiscomp::ui {

namespace {

constexpr std::array instrumentUnits{"nm", "um", "mm", "m", "inch", "deg", "arcsec", "mrad", "rad"};
constexpr int longestPattern = 4096;

Result<std::shared_ptr<const MeasuringPlan>> planOfFile(const QString& path)
{
    AXISCOMP_TRY(
        const auto bytes, loadFile(QFileInfo(path).filesystemAbsoluteFilePath(), mostPlanBytes));
    AXISCOMP_TRY(
        auto plan, readMeasuringPlan(asText(bytes), QFileInfo(path).fileName().toStdString()));
    return std::make_shared<const MeasuringPlan>(std::move(plan));
}

void describeField(QWidget& field, const QString& name, const QString& description)
{
    field.setAccessibleName(name);
    field.setToolTip(description);
    field.setAccessibleDescription(description);
}

} // namespace

CaptureDialog::CaptureDialog(WizardController& controller, CaptureFeed& feed,
    const CaptureChoices& choices, FilePicker picker, QString folder, bool hasSerial,
    QWidget* parent)
    : QDialog(parent)
    , m_controller(controller)
    , m_feed(feed)
    , m_picker(std::move(picker))
    , m_folder(std::move(folder))
    , m_planJob([this](const ReadPlan& plan) {
        m_isReadingPlan = false;
        m_plan = plan;
        showState();
    })
    , m_form(new QFormLayout)
    , m_axis(new PlainLabel)
    , m_planField(new QLineEdit)
    , m_choosePlan(new QPushButton)
    , m_kind(new QComboBox)
    , m_register(new SourceCombo)
    , m_port(new QLineEdit)
    , m_request(new QLineEdit)
    , m_pattern(new QLineEdit)
    , m_unit(new QComboBox)
    , m_zero(new NumberBox)
    , m_invert(new QCheckBox)
    , m_window(new NumberBox)
    , m_dwell(new NumberBox)
    , m_average(new QSpinBox)
    , m_values(new QLineEdit)
    , m_chooseValues(new QPushButton)
    , m_reason(wrappedLabel("captureReason"))
    , m_busy(new BusyMark)
    , m_begin(new QPushButton)
    , m_cancel(new QPushButton)
{
    setObjectName(QStringLiteral("captureDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build(hasSerial);
    retranslate();
    show(choices);
    follow();
    showKind();
}

CaptureDialog::~CaptureDialog() = default;

void CaptureDialog::build(bool hasSerial)
{
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    for (const Kind each : {Kind::Register, Kind::Serial, Kind::Typed})
        if (each != Kind::Serial || hasSerial)
            m_kind->addItem(QString(), static_cast<int>(each));
    m_unit->addItem(QString(), QString());
    for (const char* unit : instrumentUnits)
        m_unit->addItem(QLatin1StringView(unit), QLatin1StringView(unit));
    m_zero->setDecimals(6);
    m_zero->setRange(-largestPlanPosition, largestPlanPosition);
    m_window->setDecimals(6);
    m_window->setRange(CaptureRules::smallestWindow, CaptureRules::largestWindow);
    m_window->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    using Seconds = std::chrono::duration<double>;
    m_dwell->setRange(
        Seconds(CaptureRules::shortestDwell).count(), Seconds(CaptureRules::longestDwell).count());
    m_dwell->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    m_average->setRange(1, CaptureRules::mostReadings);
    for (QLineEdit* field : {m_port, m_request, m_pattern})
        field->setMaxLength(longestPattern);
    m_port->setPlaceholderText(QStringLiteral("serial:/dev/ttyUSB1?baud=9600"));
    for (QLineEdit* field : {m_planField, m_values})
        field->setReadOnly(true);
    m_choosePlan->setObjectName(QStringLiteral("choosePlanButton"));
    m_chooseValues->setObjectName(QStringLiteral("chooseValuesButton"));
    addRow(m_axis, "captureAxis");
    addRow(m_planField, "planField", withButton(m_planField, m_choosePlan));
    addRow(m_kind, "referenceKindField");
    addRow(m_register, "referenceRegisterField");
    addRow(m_port, "instrumentPortField");
    addRow(m_request, "instrumentRequestField");
    addRow(m_pattern, "instrumentPatternField");
    addRow(m_unit, "referenceUnitField");
    addRow(m_zero, "zeroField");
    m_invert->setObjectName(QStringLiteral("invertReferenceField"));
    m_form->addRow(QString(), m_invert);
    addRow(m_window, "windowField");
    addRow(m_dwell, "captureDwellField");
    addRow(m_average, "averageField");
    addRow(m_values, "valuesField", withButton(m_values, m_chooseValues));
    m_begin->setObjectName(QStringLiteral("beginCaptureButton"));
    m_begin->setDefault(true);
    m_cancel->setObjectName(QStringLiteral("cancelCaptureButton"));
    for (QPushButton* button : {m_choosePlan, m_chooseValues, m_cancel})
        button->setAutoDefault(false);
    auto* state = new QHBoxLayout;
    m_reason->setMinimumHeight(2 * m_reason->fontMetrics().lineSpacing());
    m_reason->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    state->addWidget(m_reason, 1);
    state->addWidget(m_busy, 0, Qt::AlignTop);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_begin);
    buttons->addWidget(m_cancel);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addLayout(m_form, 1);
    layout->addLayout(state);
    layout->addLayout(buttons);
    resize(640, 520);
}

/// row: what the field stands in, if not alone.
void CaptureDialog::addRow(QWidget* field, const char* name, QWidget* row)
{
    auto* label = new PlainLabel;
    label->setBuddy(field);
    field->setObjectName(QLatin1StringView(name));
    m_form->addRow(label, row ? row : field);
}

QWidget* CaptureDialog::withButton(QLineEdit* field, QPushButton* button)
{
    auto* both = new QWidget;
    auto* layout = new QHBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(field, 1);
    layout->addWidget(button);
    return both;
}

void CaptureDialog::show(const CaptureChoices& choices)
{
    m_planPath = choices.planPath;
    // Under the name of a file stands what the file says, which may be another plan by now.
    if (!m_planPath.isEmpty())
        readPlan(m_planPath);
    else if (choices.plan)
        m_plan = ReadPlan(choices.plan);
    m_kind->setCurrentIndex(
        std::max(0, m_kind->findData(static_cast<int>(choices.reference.kind))));
    offerSources();
    if (choices.reference.kind == Kind::Register)
        m_register->showValue(qString(choices.reference.source));
    m_port->setText(qString(choices.serial.endpoint));
    m_request->setText(qString(choices.serial.request));
    m_pattern->setText(qString(choices.serial.pattern));
    m_unit->setCurrentIndex(std::max(0, m_unit->findData(qString(choices.reference.scale.unit))));
    m_invert->setChecked(choices.reference.scale.isInverted);
    m_zero->setValue(choices.reference.scale.zeroAt);
    m_window->setValue(choices.rules.window);
    m_dwell->setValue(std::chrono::duration<double>(choices.rules.dwell).count());
    m_average->setValue(choices.rules.readings);
    m_values->setText(choices.valuesPath);
}

void CaptureDialog::follow()
{
    connect(m_choosePlan, &QPushButton::clicked, this, &CaptureDialog::askForPlan);
    connect(m_chooseValues, &QPushButton::clicked, this, &CaptureDialog::askForValues);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &CaptureDialog::showKind);
    connect(m_register, &SourceCombo::chosen, this, [this](const QString& text) {
        m_register->showValue(text.trimmed());
        showState();
    });
    connect(m_register, &SourceCombo::edited, this, &CaptureDialog::showState);
    for (QLineEdit* field : {m_port, m_request, m_pattern})
        connect(field, &QLineEdit::textChanged, this, &CaptureDialog::showState);
    for (const NumberBox* box : {m_zero, m_window, m_dwell})
        connect(box, &NumberBox::problemChanged, this, &CaptureDialog::showState);
    connect(m_begin, &QPushButton::clicked, this, &CaptureDialog::begin);
    connect(m_cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(&m_feed, &CaptureFeed::begun, this, [this] {
        if (!m_isBeginning)
            return;
        m_isBeginning = false;
        Q_EMIT begun(choices());
        accept();
    });
    connect(&m_feed, &CaptureFeed::refused, this, [this](const Error& error) {
        if (!m_isBeginning)
            return;
        m_isBeginning = false;
        m_refusal = error;
        showState();
    });
    for (const auto changed :
        {&WizardController::currentAxisChanged, &WizardController::axesChanged,
            &WizardController::busyChanged, &WizardController::drivesChanged})
        connect(&m_controller, changed, this, &CaptureDialog::showState);
}

void CaptureDialog::reject()
{
    if (m_isBeginning) {
        m_isBeginning = false;
        m_feed.stop();
    }
    QDialog::reject();
}

void CaptureDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void CaptureDialog::retranslate()
{
    setWindowTitle(tr("Capture Values"));
    for (int n = 0; n < m_kind->count(); ++n) {
        const auto each = static_cast<Kind>(m_kind->itemData(n).toInt());
        m_kind->setItemText(n,
            each == Kind::Register     ? tr("a register of the drive")
                : each == Kind::Serial ? tr("an instrument on a serial port")
                                       : tr("typed by hand"));
    }
    m_choosePlan->setText(tr("&Choose…"));
    m_chooseValues->setText(tr("C&hoose…"));
    m_begin->setText(tr("&Begin"));
    m_cancel->setText(tr("Cance&l"));
    m_cancel->setToolTip(tr("Take nothing and go back (Esc)"));
    m_cancel->setAccessibleDescription(m_cancel->toolTip());
    nameFields();
    showState();
}

void CaptureDialog::nameRow(QWidget* field, const QString& name, const QString& description)
{
    QWidget* label = m_form->labelForField(field);
    // One that has a button beside it.
    if (!label)
        label = m_form->labelForField(field->parentWidget());
    if (auto* text = qobject_cast<QLabel*>(label))
        text->setText(name);
    describeField(*field, withoutKey(name), description);
}

void CaptureDialog::nameFields()
{
    nameRow(m_axis, tr("Axis"), tr("The current one; something else moves it"));
    nameRow(m_planField, tr("Pla&n"), tr("As New Program saves it"));
    nameRow(m_kind, tr("&Reference"), tr("Where it comes from"));
    nameRow(m_register, tr("Re&gister"),
        tr("Which says where the axis really is: chosen from the list, or a path, URI or address"));
    nameRow(m_port, tr("&Port"), tr("Of the instrument, with its speed"));
    nameRow(m_request, tr("Re&quest"),
        tr("Sent before each reading, with \\r and \\n for line ends; empty: the instrument sends "
           "by itself"));
    nameRow(m_pattern, tr("Pa&ttern"),
        tr("Regular expression for the number in a line; empty: the first number of the line"));
    nameRow(m_unit, tr("&Unit"), tr("Of the numbers of the instrument"));
    nameRow(m_zero, tr("&Zero at"), tr("Position of the axis where the instrument says 0"));
    nameRow(m_window, tr("&Window"),
        tr("The axis stands while its encoder stays within this, and readings may differ by as "
           "much"));
    nameRow(
        m_dwell, tr("&Dwell"), tr("So long the axis must have stood before its value is taken"));
    nameRow(m_average, tr("&Average of"), tr("Readings that make a value"));
    nameRow(
        m_values, tr("&Values"), tr("File of the values; one that is there goes on where it ends"));
    m_invert->setText(tr("The instrument counts the &other way"));
    describeField(*m_invert, withoutKey(m_invert->text()),
        tr("For an instrument that counts down while the axis moves up"));
    describeField(*m_choosePlan, tr("Choose the plan"), m_planField->toolTip());
    describeField(*m_chooseValues, tr("Choose the file of the values"), m_values->toolTip());
    m_dwell->setSuffix(QStringLiteral(" s"));
    m_average->setSuffix(tr(" readings"));
}

void CaptureDialog::offerSources()
{
    const auto& status = m_controller.status();
    std::vector<AxisEntry> axes;
    for (const AxisEntry& entry : m_controller.axes())
        if (m_controller.isCurrentDrive(entry))
            axes.push_back(entry);
    std::vector<SourceChoice> sources;
    for (const DimSource& source : m_controller.sourceShortlist())
        if (status)
            sources.push_back({QString::fromStdString(sourceUri(status->drive.name, source.path)),
                registerName(source.path, axes)});
    m_register->setChoices(std::move(sources));
}

void CaptureDialog::readPlan(const QString& path)
{
    m_planPath = path;
    m_plan.reset();
    m_isReadingPlan = true;
    m_planJob.start([path](const std::stop_token&) { return planOfFile(path); });
    showState();
}

void CaptureDialog::askForPlan()
{
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::OpenPlan;
    question.title = tr("Choose Plan");
    question.filter = tr("Plans (*.csv);;All files (*)");
    question.start = m_folder;
    m_picker(*this, question, [this](const QString& path) {
        if (path.isEmpty())
            return;
        m_folder = QFileInfo(path).absolutePath();
        readPlan(path);
    });
}

void CaptureDialog::askForValues()
{
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::SaveValues;
    question.title = tr("File of the Values");
    question.filter = tr("Runs (*.csv)");
    const QString name = m_plan && *m_plan ? qString((**m_plan)->axis) : QStringLiteral("X");
    question.start = m_values->text().isEmpty() ? QDir(m_folder).filePath(
                         QStringLiteral("runs-%1.csv").arg(QString(name).replace(u'/', u'-')))
                                                : m_values->text();
    m_picker(*this, question, [this](const QString& path) {
        if (path.isEmpty())
            return;
        m_folder = QFileInfo(path).absolutePath();
        m_values->setText(QFileInfo(path).absoluteFilePath());
        showState();
    });
}

CaptureDialog::Kind CaptureDialog::kind() const
{
    return static_cast<Kind>(m_kind->currentData().toInt());
}

void CaptureDialog::showKind()
{
    const Kind chosen = kind();
    m_form->setRowVisible(m_register, chosen == Kind::Register);
    for (QLineEdit* field : {m_port, m_request, m_pattern})
        m_form->setRowVisible(field, chosen == Kind::Serial);
    const QString usual = chosen == Kind::Register ? tr("that of the axis")
        : chosen == Kind::Serial                   ? tr("as the instrument says")
                                                   : tr("that of the plan");
    m_unit->setItemText(0, usual);
    showState();
}

CaptureChoices CaptureDialog::choices() const
{
    CaptureChoices choices;
    choices.planPath = m_planPath;
    if (m_plan && *m_plan)
        choices.plan = **m_plan;
    choices.reference.kind = kind();
    choices.serial = {m_port->text().trimmed().toStdString(), m_request->text().toStdString(),
        m_pattern->text().toStdString()};
    if (kind() == Kind::Register)
        choices.reference.source = m_register->currentText().trimmed().toStdString();
    else if (kind() == Kind::Serial) {
        choices.reference.source = choices.serial.endpoint;
        choices.reference.pattern = choices.serial.pattern;
    }
    choices.reference.scale = {
        m_unit->currentData().toString().toStdString(), m_invert->isChecked(), m_zero->value()};
    choices.valuesPath = m_values->text();
    choices.rules.window = m_window->value();
    choices.rules.dwell = std::chrono::round<std::chrono::nanoseconds>(
        std::chrono::duration<double>(m_dwell->value()));
    choices.rules.readings = m_average->value();
    return choices;
}

/// Of a number that is not the one that was typed; empty: there is none.
QString CaptureDialog::typedProblem() const
{
    for (const NumberBox* box : {m_zero, m_window, m_dwell})
        if (const QString problem = box->problem(); !problem.isEmpty())
            return problem;
    return {};
}

/// Empty: it can begin.
QString CaptureDialog::obstacle() const
{
    if (const QString problem = typedProblem(); !problem.isEmpty())
        return problem;
    if (m_controller.currentAxis() < 0 || !m_controller.isConnected())
        return tr("The drive does not answer.");
    if (m_controller.busy().isBusy)
        return tr("Wait until the drive is free.");
    if (m_isReadingPlan)
        return tr("The plan is being read …");
    if (!m_plan)
        return tr("Choose a plan; New Program makes one.");
    if (!*m_plan)
        return errorText(m_plan->error());
    if (kind() == Kind::Register && m_register->currentText().trimmed().isEmpty())
        return tr("Choose the register of the reference.");
    if (kind() == Kind::Serial && m_port->text().trimmed().isEmpty())
        return tr("Name the port of the instrument, such as serial:/dev/ttyUSB1?baud=9600.");
    if (m_values->text().isEmpty())
        return tr("Choose the file of the values.");
    return {};
}

QString CaptureDialog::planText() const
{
    if (!m_plan || !*m_plan)
        return m_planPath.isEmpty() ? QString() : QFileInfo(m_planPath).fileName();
    const QString summary = planSummaryText(***m_plan);
    return m_planPath.isEmpty()
        ? tr("the plan just made (%1)").arg(summary)
        : QStringLiteral("%1 (%2)").arg(QFileInfo(m_planPath).fileName(), summary);
}

void CaptureDialog::showState()
{
    const int current = m_controller.currentAxis();
    m_axis->setText(
        current < 0 ? QString() : m_controller.axes().at(static_cast<std::size_t>(current)).label);
    m_planField->setText(planText());
    const bool isAngular = m_plan && *m_plan && (**m_plan)->isAngular;
    const QString unit = unitSuffix(isAngular ? "°" : "mm");
    // Setting it puts the number in place of what is being typed.
    for (NumberBox* box : {m_zero, m_window})
        if (box->suffix() != unit)
            box->setSuffix(unit);
    const QString why = obstacle();
    const bool isWrong = (m_plan && !*m_plan) || !typedProblem().isEmpty();
    m_busy->setBusy(m_isBeginning || m_isReadingPlan);
    m_begin->setEnabled(why.isEmpty() && !m_isBeginning);
    if (m_isBeginning) {
        m_reason->setTone(std::nullopt);
        m_reason->setText(tr("The drive is being read …"));
    } else if (m_refusal && why.isEmpty()) {
        m_reason->setTone(Tone::Error);
        m_reason->setText(errorText(*m_refusal));
    } else {
        m_reason->setTone(isWrong ? std::optional(Tone::Error) : std::nullopt);
        m_reason->setText(!why.isEmpty()
                ? why
                : tr("Values are taken while the control of the machine, or a person, moves the "
                     "axis. This program never moves it."));
    }
    m_begin->setToolTip(
        m_begin->isEnabled() ? tr("Read axis and instrument, and take values") : m_reason->text());
    m_begin->setAccessibleDescription(m_begin->toolTip());
}

void CaptureDialog::begin()
{
    if (!obstacle().isEmpty() || m_isBeginning || m_feed.isActive())
        return;
    const CaptureChoices chosen = choices();
    CaptureRequest request;
    request.plan = *chosen.plan;
    request.file = QFileInfo(chosen.valuesPath).filesystemAbsoluteFilePath();
    request.reference = chosen.reference;
    request.rules = chosen.rules;
    m_refusal.reset();
    m_isBeginning = true;
    const AxisEntry& entry =
        m_controller.axes().at(static_cast<std::size_t>(m_controller.currentAxis()));
    m_feed.begin(entry.axis.index, entry.label, std::move(request), chosen.serial);
    showState();
}

} // namespace axiscomp::ui
