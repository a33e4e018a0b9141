// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/judging/corrections_dialog.h"

#include "core/io/local_file.h"
#include "core/metrology/record/calibration_record.h"
#include "ui/async/background_job.h"
#include "ui/style/plain_label.h"
#include "ui/style/tone_label.h"
#include "ui/text/free_key.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>

namespace axiscomp::ui {

namespace {

Result<DeadPathCorrection> deadPathFromFile(const QString& path)
{
    const QFileInfo info(path);
    AXISCOMP_TRY(
        const auto bytes, loadFile(info.filesystemAbsoluteFilePath(), maximumDeadPathSize));
    return deadPathFromText(asText(bytes), info.fileName().toStdString());
}

} // namespace

CorrectionsDialog::CorrectionsDialog(
    const Measurement& measurement, const CorrectionsBefore& corrections, QWidget* parent)
    : QDialog(parent)
    , m_deadPath(corrections.deadPath)
    , m_temperature(new QGroupBox)
    , m_steel(new QPushButton)
    , m_isConfirmed(new QCheckBox)
    , m_deadPathBox(new QGroupBox)
    , m_deadPathText(new PlainLabel)
    , m_openDeadPath(new QPushButton)
    , m_removeDeadPath(new QPushButton)
    , m_problem(new ToneLabel)
    , m_accept(new QPushButton)
    , m_reject(new QPushButton)
{
    setObjectName(QStringLiteral("correctionsDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_probe.header = measurement.header;
    m_probe.isAngular = measurement.isAngular;
    build();
    show(corrections);
    connect(m_steel, &QPushButton::clicked, this, [this] {
        m_numbers[Expansion]->setText(numberText(steelExpansionPerKelvin / expansionUnit));
    });
    connect(m_openDeadPath, &QPushButton::clicked, this, &CorrectionsDialog::deadPathRequested);
    connect(m_removeDeadPath, &QPushButton::clicked, this, [this] {
        m_deadPath.reset();
        showDeadPath();
        m_openDeadPath->setFocus();
    });
    connect(m_accept, &QPushButton::clicked, this, &CorrectionsDialog::finish);
    connect(m_reject, &QPushButton::clicked, this, &QDialog::reject);
    retranslate();
}

void CorrectionsDialog::build()
{
    m_temperature->setObjectName(QStringLiteral("temperatureCorrection"));
    m_temperature->setCheckable(true);
    auto* form = new QFormLayout(m_temperature);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    constexpr std::array names{"materialTemperature", "materialExpansion", "referenceTemperature",
        "referenceExpansion", "datumField"};
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        m_labels[i] = new PlainLabel;
        m_numbers[i] = new QLineEdit;
        m_numbers[i]->setObjectName(QLatin1StringView(names[i]));
        m_labels[i]->setBuddy(m_numbers[i]);
        if (i != Expansion) {
            form->addRow(m_labels[i], m_numbers[i]);
            continue;
        }
        auto* row = new QHBoxLayout;
        row->addWidget(m_numbers[i], 1);
        row->addWidget(m_steel);
        form->addRow(m_labels[i], row);
    }
    m_steel->setObjectName(QStringLiteral("steelExpansion"));
    m_steel->setAutoDefault(false);
    m_isConfirmed->setObjectName(QStringLiteral("notCorrected"));
    form->addRow(m_isConfirmed);
    m_problem->setObjectName(QStringLiteral("correctionProblem"));
    m_problem->setTone(Tone::Error);
    m_problem->setWordWrap(true);
    m_accept->setObjectName(QStringLiteral("acceptCorrections"));
    m_accept->setDefault(true);
    m_reject->setObjectName(QStringLiteral("rejectCorrections"));
    m_reject->setAutoDefault(false);
    auto* buttons = new QDialogButtonBox;
    buttons->addButton(m_accept, QDialogButtonBox::AcceptRole);
    buttons->addButton(m_reject, QDialogButtonBox::RejectRole);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addWidget(m_temperature);
    layout->addWidget(buildDeadPath());
    layout->addWidget(m_problem);
    layout->addStretch(1);
    layout->addWidget(buttons);
    m_problem->hide();
    resize(560, sizeHint().height());
}

QWidget* CorrectionsDialog::buildDeadPath()
{
    m_deadPathText->setObjectName(QStringLiteral("deadPathText"));
    m_deadPathText->setWordWrap(true);
    m_openDeadPath->setObjectName(QStringLiteral("openDeadPath"));
    m_openDeadPath->setAutoDefault(false);
    m_removeDeadPath->setObjectName(QStringLiteral("removeDeadPath"));
    m_removeDeadPath->setAutoDefault(false);
    auto* row = new QHBoxLayout(m_deadPathBox);
    row->addWidget(m_deadPathText, 1);
    row->addWidget(m_openDeadPath);
    row->addWidget(m_removeDeadPath);
    return m_deadPathBox;
}

/// What the file says is proposed; it is not a correction before the box is checked.
void CorrectionsDialog::show(const CorrectionsBefore& corrections)
{
    const auto& temperature = corrections.temperature;
    m_temperature->setChecked(temperature.has_value());
    const auto put = [this](Number number, const std::optional<double>& value) {
        m_numbers.at(number)->setText(value ? numberText(*value) : QString());
    };
    const auto coefficient = [](const std::optional<double>& perKelvin) {
        return perKelvin ? std::optional(*perKelvin / expansionUnit) : std::nullopt;
    };
    const TemperatureCorrection shown = temperature.value_or(TemperatureCorrection{});
    put(Material, temperature ? shown.materialCelsius : m_probe.header.materialTemperature);
    put(Expansion, coefficient(temperature ? shown.expansionPerKelvin : m_probe.header.expansion));
    put(Reference, shown.referenceCelsius);
    put(ReferenceExpansion, coefficient(shown.referenceExpansionPerKelvin));
    put(Datum, shown.datum);
    m_isConfirmed->setChecked(shown.isConfirmed);
    showDeadPath();
}

void CorrectionsDialog::showDeadPath()
{
    m_deadPathText->setText(m_deadPath
            ? tr("%1 mm; runs with their air: %2")
                  .arg(numberText(m_deadPath->lengthMm), countText(m_deadPath->duringRun.size()))
            : tr("not corrected for"));
    m_removeDeadPath->setEnabled(m_deadPath.has_value());
}

void CorrectionsDialog::readDeadPath(const QString& path)
{
    whenDone(inBackground<Result<DeadPathCorrection>>([path] { return deadPathFromFile(path); }),
        this, [this](const Result<DeadPathCorrection>& read) { takeDeadPath(read); });
}

void CorrectionsDialog::takeDeadPath(const Result<DeadPathCorrection>& read)
{
    if (!read)
        return say(errorText(read.error()));
    m_deadPath = *read;
    say({});
    showDeadPath();
}

std::optional<double> CorrectionsDialog::numberOf(Number number, bool& isWrong) const
{
    const QString text = m_numbers.at(number)->text().trimmed();
    if (text.isEmpty())
        return std::nullopt;
    bool isNumber = false;
    QLocale locale;
    locale.setNumberOptions(QLocale::RejectGroupSeparator);
    const double value = locale.toDouble(text, &isNumber);
    isWrong = isWrong || !isNumber;
    return value;
}

QString CorrectionsDialog::readInto(CorrectionsBefore& corrections) const
{
    corrections.deadPath = m_deadPath;
    if (!m_temperature->isChecked())
        return {};
    bool isWrong = false;
    const auto material = numberOf(Material, isWrong);
    const auto expansion = numberOf(Expansion, isWrong);
    const auto reference = numberOf(Reference, isWrong);
    const auto referenceExpansion = numberOf(ReferenceExpansion, isWrong);
    const auto datum = numberOf(Datum, isWrong);
    if (isWrong || !material || !expansion || !reference || !referenceExpansion)
        return tr("Enter temperatures and coefficients as numbers; only the position that does not "
                  "move may be left empty.");
    corrections.temperature = TemperatureCorrection{*material, *expansion * expansionUnit,
        *reference, *referenceExpansion * expansionUnit, datum, m_isConfirmed->isChecked()};
    if (m_probe.header.corrected == MeasurementHeader::Corrected::NotSaid
        && !m_isConfirmed->isChecked())
        return tr("The file does not say whether its values are at 20 °C already. Only values that "
                  "are not may be corrected.");
    return {};
}

/// What can be said without the values is said here; the rest where the measurement is judged.
void CorrectionsDialog::finish()
{
    CorrectionsBefore corrections;
    if (const QString problem = readInto(corrections); !problem.isEmpty())
        return say(problem);
    if (const auto possible = corrected(m_probe, corrections); !possible)
        return say(errorText(possible.error()));
    Q_EMIT chosen(corrections);
    accept();
}

void CorrectionsDialog::say(const QString& problem)
{
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
}

void CorrectionsDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void CorrectionsDialog::retranslate()
{
    setWindowTitle(tr("Corrections Before Judging"));
    m_temperature->setTitle(tr("&Bring the values to 20 °C"));
    const QString unit = QStringLiteral("µm/(m·K)");
    const std::array labels{tr("&Temperature of the scale [°C]"),
        tr("&Expansion of the scale [%1]").arg(unit), tr("Temperature of the &reference [°C]"),
        tr("E&xpansion of the reference [%1]").arg(unit), tr("&Position that does not move [mm]")};
    const std::array purposes{tr("Of the material that the axis is measured by"),
        tr("Of the same material; steel has about 11.5"), tr("Of the measuring instrument"),
        tr("0 for a laser that is compensated for its wavelength"), tr("Empty: the first target")};
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        m_labels[i]->setText(labels.at(i));
        m_numbers[i]->setAccessibleName(withoutKey(labels.at(i)));
        m_numbers[i]->setToolTip(purposes.at(i));
        m_numbers[i]->setAccessibleDescription(purposes.at(i));
    }
    m_numbers[Datum]->setPlaceholderText(tr("the first target"));
    m_steel->setText(tr("&Steel"));
    m_steel->setToolTip(tr("Enter the coefficient of steel, 11.5 µm/(m·K)"));
    m_isConfirmed->setText(tr("The instrument has &not corrected the values itself"));
    m_isConfirmed->setToolTip(tr("Needed where the file does not say it"));
    m_deadPathBox->setTitle(tr("Dead path of the interferometer"));
    m_openDeadPath->setText(tr("&Open…"));
    m_openDeadPath->setToolTip(tr("A JSON file with its length and the air of each run"));
    m_removeDeadPath->setText(tr("Re&move"));
    m_removeDeadPath->setToolTip(tr("Do not correct for the dead path"));
    m_accept->setText(tr("&Correct"));
    m_accept->setToolTip(tr("Judge the values with these corrections"));
    m_reject->setText(tr("Cance&l"));
    m_reject->setToolTip(tr("Leave the corrections as they are (Esc)"));
    for (QWidget* button : {static_cast<QWidget*>(m_steel), static_cast<QWidget*>(m_isConfirmed),
             static_cast<QWidget*>(m_openDeadPath), static_cast<QWidget*>(m_removeDeadPath),
             static_cast<QWidget*>(m_accept), static_cast<QWidget*>(m_reject)})
        button->setAccessibleDescription(button->toolTip());
    showDeadPath();
}

} // namespace axiscomp::ui
