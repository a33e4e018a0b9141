// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/record_model.h"

#include "core/metrology/fit/fit_fields.h"
#include "ui/text/value_text.h"

#include <QFileInfo>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

namespace axiscomp::ui {

namespace {

/// Whether both can name the same value.
bool overlap(const Exclusion& a, const Exclusion& b)
{
    const auto agree = [](const auto& one, const auto& other) {
        return !one || !other || *one == *other;
    };
    return agree(a.direction, b.direction) && agree(a.target, b.target) && agree(a.run, b.run);
}

/// The values of a measurement that an exclusion leaves out, but for those of `used`.
void addOthers(const Measurement& measurement, const Exclusion& exclusion,
    const std::vector<Exclusion>& used, std::vector<Exclusion>& left)
{
    for (const RunValue& value : measurement.values) {
        if (!covers(exclusion, value))
            continue;
        const bool isUsed =
            std::ranges::any_of(used, [&](const Exclusion& one) { return covers(one, value); });
        if (!isUsed)
            left.push_back({value.direction, value.target + 1, value.run});
    }
}

/// The files that are added next are those of another measurement.
void forgetTheMeasurement(Record& record)
{
    record.swapsDirections = false;
    record.fit.onto = FitChoices::Onto::Nothing;
    record.fit.ontoTable.reset();
    record.fit.ontoFile.clear();
}

/// Of other files it would be about other values, and nobody would see it.
void forgetWhatIsOfTheFiles(Record& record)
{
    record.exclusions.clear();
    record.corrections = {};
    record.statedTable.reset();
    record.fit.measuredWith = FitChoices::MeasuredWith::NotSaid;
    record.fit.measuredWithFile.clear();
    if (record.files.empty())
        forgetTheMeasurement(record);
}

/// The air of each run, with directions exchanged.
void swapDirections(DeadPathCorrection& deadPath)
{
    std::map<std::pair<Approach, int>, AirState> swapped;
    for (const auto& [run, air] : deadPath.duringRun)
        swapped[{run.first == Approach::Up ? Approach::Down : Approach::Up, run.second}] = air;
    deadPath.duringRun = std::move(swapped);
}

/// Whether both have the same measurement, judged in the same way.
bool isJudgedAlike(const Record& a, const Record& b)
{
    Record other = b;
    other.fit = a.fit;
    other.calibration = a.calibration;
    return a == other;
}

bool hasFile(const Record& record, const MeasurementFile& file)
{
    return std::ranges::find(record.files, file) != record.files.end();
}

/// Whether something is said of one of these files that is of its content.
bool speaksOf(const Record& record, const QStringList& paths)
{
    const bool hasOne = std::ranges::any_of(
        record.files, [&](const MeasurementFile& file) { return paths.contains(file.path); });
    if (!hasOne)
        return false;
    Record without = record;
    forgetWhatIsOfTheFiles(without);
    return without != record;
}

QString namesOf(const QStringList& paths)
{
    const QString name = QFileInfo(paths.front()).fileName();
    return paths.size() == 1 ? name : name + QStringLiteral(", …");
}

} // namespace

class RecordModel::Step final : public QUndoCommand {
public:
    Step(RecordModel& model, Record after, StepKind stepKind, QString stepSubject)
        : kind(stepKind)
        , subject(std::move(stepSubject))
        , m_model(model)
        , m_before(model.record())
        , m_after(std::move(after))
    {
    }

    void undo() override { m_model.apply(m_before); }
    void redo() override { m_model.apply(m_after); }
    [[nodiscard]] std::array<const Record*, 2> records() const { return {&m_before, &m_after}; }
    [[nodiscard]] bool isOf(const RecordModel& model) const { return &m_model == &model; }
    void note(const Noting& noted) const
    {
        for (Record* record : {&m_before, &m_after})
            if (record->calibration)
                record->calibration = noted(record->calibration);
    }

    const StepKind kind;
    const QString subject;

private:
    RecordModel& m_model;
    // What has happened since is noted in all steps.
    mutable Record m_before;
    mutable Record m_after;
};

RecordModel::RecordModel(QObject* parent)
    : QObject(parent)
    , m_steps(m_ownSteps)
    , m_job([this](const RecordState& state) { take(state); })
    , m_fitJob([this](const std::shared_ptr<const FitOutcome>& outcome) { takeFit(outcome); })
{
    m_steps.setUndoLimit(mostSteps);
    connect(&m_steps, &QUndoStack::indexChanged, this, &RecordModel::historyChanged);
}

RecordModel::RecordModel(HistoryOf other, QObject* parent)
    : QObject(parent)
    , m_steps(other.record.m_steps)
    , m_job([this](const RecordState& state) { take(state); })
    , m_fitJob([this](const std::shared_ptr<const FitOutcome>& outcome) { takeFit(outcome); })
{
    connect(&m_steps, &QUndoStack::indexChanged, this, &RecordModel::historyChanged);
}

RecordModel::~RecordModel()
{
    m_steps.disconnect(this); // it clears itself when it goes
}

void RecordModel::change(Record next, StepKind kind, const QString& subject)
{
    if (next != m_record)
        m_steps.push(new Step(*this, std::move(next), kind, subject));
}

void RecordModel::open(const Record& record)
{
    m_ownSteps.clear();
    m_seen.clear();
    Q_EMIT opened();
    apply(record);
}

void RecordModel::apply(const Record& record)
{
    const bool isJudged = isJudgedAlike(m_record, record);
    const bool isFitted = isJudged && m_record.fit == record.fit;
    m_record = record;
    m_state.record.fit = record.fit;
    m_state.record.calibration = record.calibration;
    if (!isJudged)
        evaluate();
    else if (!isFitted)
        fit();
    Q_EMIT changed();
}

void RecordModel::evaluate()
{
    m_isEvaluating = true;
    m_fitJob.cancel(); // of a measurement that is not wanted any more
    m_isFitting = false;
    std::vector<ReadMeasurement> known = m_state.files;
    known.insert(known.end(), m_seen.begin(), m_seen.end());
    m_job.start([record = m_record, known = std::move(known)](
                    const std::stop_token& stop) { return evaluated(record, known, stop); });
    Q_EMIT stateChanged();
}

void RecordModel::take(const RecordState& state)
{
    RecordState before = std::exchange(m_state, state);
    m_state.record.fit = m_record.fit;
    m_state.record.calibration = m_record.calibration;
    m_state.fit = before.fit;
    keepWhatStepsBringBack(std::move(before.files));
    letGo(std::move(before));
    m_isEvaluating = false;
    forgetWhatHasChanged();
    if (m_isEvaluating)
        return; // nobody is to see or save other values left out than those that were
    fit();
    Q_EMIT stateChanged();
}

/// before: the files of the state before.
void RecordModel::keepWhatStepsBringBack(std::vector<ReadMeasurement> before)
{
    std::ranges::move(m_seen, std::back_inserter(before));
    m_seen.clear();
    for (ReadMeasurement& read : before) {
        const auto isIt = [&](const ReadMeasurement& one) { return one.file == read.file; };
        const bool isThere =
            std::ranges::any_of(m_state.files, isIt) || std::ranges::any_of(m_seen, isIt);
        if (!isThere && isInSteps([&](const Record& record) { return hasFile(record, read.file); }))
            m_seen.push_back(std::move(read));
    }
    letGo(std::move(before));
}

bool RecordModel::isInSteps(const std::function<bool(const Record&)>& is) const
{
    for (int n = 0; n < m_steps.count(); ++n) {
        const auto& step = *static_cast<const Step*>(m_steps.command(n));
        if (step.isOf(*this) && std::ranges::any_of(step.records(), [&](const Record* record) {
                return is(*record);
            }))
            return true;
    }
    return false;
}

void RecordModel::forgetWhatHasChanged()
{
    const QStringList files = std::exchange(m_state.changedFiles, {});
    if (files.isEmpty())
        return;
    Record next = m_record;
    forgetWhatIsOfTheFiles(next);
    if (next == m_record) {
        // Undone or done again it would be about other values, and nobody would see it.
        if (isInSteps([&](const Record& record) { return speaksOf(record, files); }))
            m_steps.clear();
        return;
    }
    change(std::move(next), StepKind::FileChanged, namesOf(files));
    Q_EMIT filesChanged(namesOf(files));
}

/// Of the measurement that is there; of one that is being read when it has been.
void RecordModel::fit()
{
    if (m_isEvaluating)
        return;
    m_fitJob.cancel();
    const bool isSecond = &m_steps != &m_ownSteps; // which is compared, and no table is made of it
    if (isSecond || !m_state.measurement)
        return takeFit(nullptr);
    m_isFitting = true;
    FitRequest request{m_record, m_state.files, m_state.measurement, m_drive};
    request.record.fit = choicesOfDrive();
    m_fitJob.start([request = std::move(request)](
                       const std::stop_token& stop) { return fitted(request, stop); });
    Q_EMIT fitChanged();
}

void RecordModel::takeFit(std::shared_ptr<const FitOutcome> outcome)
{
    m_isFitting = false;
    auto before = std::exchange(m_state.fit, std::move(outcome));
    Q_EMIT fitChanged(); // who has shown the old one lets go of it
    letGo(std::move(before));
}

void RecordModel::setDrive(const FitDrive& drive)
{
    if (isSameDrive(drive, m_drive))
        return;
    m_drive = drive;
    fit();
}

void RecordModel::readAgain()
{
    if (!m_record.files.empty())
        evaluate();
}

void RecordModel::addFiles(const QStringList& paths)
{
    Record next = m_record;
    QStringList added;
    for (const QString& path : paths) {
        const QString absolute = QFileInfo(path).absoluteFilePath();
        const bool isKnown = std::ranges::any_of(
            next.files, [&](const MeasurementFile& file) { return file.path == absolute; });
        if (isKnown)
            continue;
        next.files.push_back({absolute, {}, {}});
        added += absolute;
    }
    if (added.isEmpty())
        return;
    forgetWhatIsOfTheFiles(next);
    change(std::move(next), StepKind::AddFiles, namesOf(added));
}

void RecordModel::removeFile(std::size_t index)
{
    Record next = m_record;
    const QString path = next.files.at(index).path;
    next.files.erase(next.files.begin() + static_cast<std::ptrdiff_t>(index));
    forgetWhatIsOfTheFiles(next);
    change(std::move(next), StepKind::RemoveFile, namesOf({path}));
}

void RecordModel::setChoices(std::size_t index, const MeasurementChoices& choices)
{
    Record next = m_record;
    MeasurementFile& file = next.files.at(index);
    if (file.choices == choices)
        return;
    file.choices = choices;
    next.exclusions.clear();
    next.statedTable.reset();
    change(std::move(next), StepKind::ReadOtherwise, namesOf({file.path}));
}

void RecordModel::setDirectionsSwapped(bool isSwapped)
{
    if (m_record.swapsDirections == isSwapped)
        return;
    Record next = m_record;
    next.swapsDirections = isSwapped;
    for (Exclusion& exclusion : next.exclusions)
        if (exclusion.direction)
            exclusion.direction =
                *exclusion.direction == Approach::Up ? Approach::Down : Approach::Up;
    if (next.corrections.deadPath)
        swapDirections(*next.corrections.deadPath);
    change(std::move(next), StepKind::SwapDirections);
}

bool RecordModel::isMeasurementShown() const
{
    return m_state.measurement && m_state.record.files == m_record.files
        && m_state.record.swapsDirections == m_record.swapsDirections;
}

/// What is said while the files are being read is not about the measurement before.
const Measurement* RecordModel::shownMeasurement() const
{
    return isMeasurementShown() ? m_state.measurement.get() : nullptr;
}

void RecordModel::exclude(const std::vector<Exclusion>& exclusions)
{
    Record next = m_record;
    std::size_t added = 0;
    for (const Exclusion& exclusion : exclusions) {
        if (std::ranges::find(next.exclusions, exclusion) != next.exclusions.end())
            continue;
        next.exclusions.push_back(exclusion);
        ++added;
    }
    change(std::move(next), StepKind::Exclude, countText(added));
}

bool RecordModel::isLeftOut(const std::vector<Exclusion>& values) const
{
    return std::ranges::any_of(m_record.exclusions, [&](const Exclusion& exclusion) {
        return std::ranges::any_of(
            values, [&](const Exclusion& one) { return overlap(exclusion, one); });
    });
}

void RecordModel::useAgain(const std::vector<Exclusion>& values)
{
    if (!isMeasurementShown())
        return;
    Record next = m_record;
    next.exclusions.clear();
    for (const Exclusion& exclusion : m_record.exclusions) {
        const bool isTouched = std::ranges::any_of(
            values, [&](const Exclusion& one) { return overlap(exclusion, one); });
        if (!isTouched)
            next.exclusions.push_back(exclusion);
        else if (!isOneValue(exclusion))
            addOthers(*m_state.measurement, exclusion, values, next.exclusions);
    }
    change(std::move(next), StepKind::UseAgain, countText(values.size()));
}

void RecordModel::setOutlierRule(OutlierRule rule)
{
    Record next = m_record;
    next.outlierRule = rule;
    change(std::move(next), StepKind::OutlierRule);
}

void RecordModel::setCorrections(const CorrectionsBefore& corrections)
{
    Record next = m_record;
    next.corrections = corrections;
    change(std::move(next), StepKind::Corrections);
}

/// A limit in mm says nothing of an angle: those of the other kind go.
Record RecordModel::withLimitsOfTheMeasurement() const
{
    Record next = m_record;
    const Measurement* const shown = shownMeasurement();
    const bool areAngles = shown ? shown->isAngular : next.areLimitsAngles;
    if (areAngles == next.areLimitsAngles)
        return next;
    next.areLimitsAngles = areAngles;
    next.tolerances.clear();
    next.uncertainty.reset();
    return next;
}

void RecordModel::setTolerance(Iso230Figure figure, std::optional<double> value)
{
    Record next = withLimitsOfTheMeasurement();
    std::erase_if(next.tolerances,
        [figure](const Tolerance& tolerance) { return tolerance.figure == figure; });
    if (value)
        next.tolerances.push_back({figure, *value});
    std::ranges::sort(next.tolerances, {}, &Tolerance::figure);
    change(std::move(next), StepKind::Tolerance, qString(figureName(figure)));
}

void RecordModel::setUncertainty(std::optional<double> value)
{
    Record next = withLimitsOfTheMeasurement();
    next.uncertainty = value;
    change(std::move(next), StepKind::Uncertainty);
}

/// Residuals that were merged onto a table are not left over with the one that came of it.
FitChoices RecordModel::choicesOfDrive() const
{
    FitChoices choices = m_record.fit;
    const bool isOther = choices.onto == FitChoices::Onto::Drive && m_drive.axis
        && choices.ontoTable != m_drive.heldTable();
    if (!isOther)
        return choices;
    choices.ontoTable.reset();
    const MeasuredState none;
    const Measurement* const shown = shownMeasurement();
    const MeasuredState& onFile = shown ? shown->header.compensation : none;
    if (choices.measuredWith == FitChoices::MeasuredWith::On)
        choices.measuredWith = FitChoices::MeasuredWith::NotSaid;
    else if (onFile.kind == MeasuredState::Kind::On && !onFile.tableCrc)
        choices.onto = FitChoices::Onto::Nothing;
    return choices;
}

FitChoices RecordModel::fitChoices() const
{
    FitChoices choices = choicesOfDrive();
    const Measurement* const shown = shownMeasurement();
    if (shown && shown->isAngular != choices.areLengthsAngles) {
        choices.settings = withoutLengths(std::move(choices.settings));
        choices.areLengthsAngles = shown->isAngular;
    }
    return choices;
}

void RecordModel::setFit(const FitChoices& choices, const QString& name)
{
    Record next = m_record;
    next.fit = choices;
    if (choices.onto != FitChoices::Onto::Drive)
        next.fit.ontoTable.reset();
    else if (!choices.ontoTable)
        next.fit.ontoTable = m_drive.heldTable();
    if (const Measurement* const shown = shownMeasurement())
        next.fit.areLengthsAngles = shown->isAngular;
    change(std::move(next), StepKind::Fit, name);
}

void RecordModel::setCalibration(std::shared_ptr<const CalibrationRecord> calibration)
{
    Record next = m_record;
    next.calibration = std::move(calibration);
    change(std::move(next), StepKind::Calibration);
}

void RecordModel::setStatedTable(std::optional<std::uint32_t> crc)
{
    Record next = m_record;
    next.statedTable = crc;
    change(std::move(next), StepKind::StateTable);
}

std::vector<std::shared_ptr<const CalibrationRecord>> RecordModel::calibrations() const
{
    std::vector<std::shared_ptr<const CalibrationRecord>> found;
    const auto add = [&found](const Record& record) {
        if (record.calibration && std::ranges::find(found, record.calibration) == found.end())
            found.push_back(record.calibration);
    };
    add(m_record);
    for (int n = 0; n < m_steps.count(); ++n)
        for (const Record* record : static_cast<const Step*>(m_steps.command(n))->records())
            add(*record);
    return found;
}

void RecordModel::note(const Noting& noted)
{
    for (int n = 0; n < m_steps.count(); ++n)
        static_cast<const Step*>(m_steps.command(n))->note(noted);
    if (!m_record.calibration)
        return;
    auto next = noted(m_record.calibration);
    if (next == m_record.calibration)
        return;
    m_record.calibration = std::move(next);
    Q_EMIT changed();
}

QString RecordModel::textOf(int index) const
{
    const auto* step = static_cast<const Step*>(m_steps.command(index));
    if (!step)
        return {};
    switch (step->kind) {
    case StepKind::AddFiles:
        return tr("Add %1").arg(step->subject);
    case StepKind::FileChanged:
        return tr("%1 changed on disk").arg(step->subject);
    case StepKind::RemoveFile:
        return tr("Remove %1").arg(step->subject);
    case StepKind::ReadOtherwise:
        return tr("How %1 is read").arg(step->subject);
    case StepKind::SwapDirections:
        return tr("Exchange up and down");
    case StepKind::Exclude:
        return tr("Exclude (%1)").arg(step->subject);
    case StepKind::UseAgain:
        return tr("Use again (%1)").arg(step->subject);
    case StepKind::OutlierRule:
        return tr("Rule for outliers");
    case StepKind::Corrections:
        return tr("Corrections");
    case StepKind::Tolerance:
        return tr("Tolerance of %1").arg(step->subject);
    case StepKind::Uncertainty:
        return tr("Uncertainty");
    case StepKind::StateTable:
        return tr("Table active while measured");
    case StepKind::Fit:
        return tr("Fit: %1").arg(step->subject);
    case StepKind::Calibration:
        break;
    }
    return tr("Table in use");
}

QString RecordModel::undoText() const
{
    return textOf(m_steps.index() - 1);
}

QString RecordModel::redoText() const
{
    return textOf(m_steps.index());
}

void RecordModel::undo()
{
    m_steps.undo();
}

void RecordModel::redo()
{
    m_steps.redo();
}

} // namespace axiscomp::ui
