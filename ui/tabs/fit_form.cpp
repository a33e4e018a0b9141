// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/fit_form.h"

#include "ui/fields/number_edit.h"
#include "ui/style/plain_label.h"
#include "ui/style/tone_label.h"
#include "ui/text/free_key.h"
#include "ui/text/value_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QListView>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStandardItemModel>

#include <algorithm>
#include <utility>

namespace axiscomp::ui {

namespace {

using MeasuredWith = FitChoices::MeasuredWith;
using Onto = FitChoices::Onto;

/// How the grid is said; the number of an item of its list.
enum class GridKind { Even, Points, Distance, Within };

GridKind gridKindOf(const FitSettings& settings)
{
    if (settings.within)
        return GridKind::Within;
    if (settings.grid.empty())
        return GridKind::Even;
    return settings.grid.front().points != 0 ? GridKind::Points : GridKind::Distance;
}

std::vector<double> listOf(const std::optional<double>& value)
{
    return value ? std::vector{*value} : std::vector<double>{};
}

std::optional<double> firstOf(const NumberEdit& field)
{
    return field.numbers().empty() ? std::nullopt : std::optional(field.numbers().front());
}

int indexOf(const QComboBox& list, int data)
{
    return list.findData(data);
}

std::size_t dimensionsOf(const std::vector<std::string>& axes)
{
    return std::max<std::size_t>(axes.size(), 1);
}

} // namespace

FitForm::FitForm(QWidget* parent) : QWidget(parent), m_form(new QFormLayout(this))
{
    setObjectName(QStringLiteral("fitForm"));
    build();
}

void FitForm::build()
{
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    buildDrive();
    buildCurve();
    buildGrid();
    buildZero();
    buildPoints();
}

void FitForm::buildDrive()
{
    m_driveHeading = addHeading();
    m_lookup = addList("fitLookup", 3);
    const auto addNote = [this](QLabel*& label, const char* name) {
        auto* note = new ToneLabel;
        note->setMuted();
        note->setObjectName(QLatin1StringView(name));
        note->setWordWrap(true);
        label = note;
        m_form->addRow(QString(), note);
    };
    addNote(m_lookupNote, "fitLookupNote");
    m_measuredWith = addList("fitMeasuredWith", 0);
    for (int n = 0; n < 4; ++n)
        m_measuredWith->addItem(QString(), n);
    addNote(m_stateNote, "fitStateNote");
    m_onto = addList("fitOnto", 3);
    addNote(m_ontoNote, "fitOntoNote");
    m_gain = addNumbers("fitGain", 1, 0.0, true);
    // A file is asked for each time that it is chosen, also where it is the choice already.
    for (QComboBox* list : {m_measuredWith, m_onto})
        list->disconnect(this);
    connect(m_measuredWith, &QComboBox::activated, this,
        [this] { reportFile(m_measuredWith, static_cast<int>(MeasuredWith::File), false); });
    connect(m_onto, &QComboBox::activated, this,
        [this] { reportFile(m_onto, static_cast<int>(Onto::File), true); });
}

void FitForm::buildCurve()
{
    m_curveHeading = addHeading();
    m_method = addList("fitMethod", 5);
    m_direction = addList("fitDirection", 3);
    m_smoothness = addNumbers("fitSmoothness", 1, 0.0);
    m_periods = addNumbers("fitPeriods", 20, 0.0, true);
    m_harmonics = new QSpinBox;
    constexpr int mostHarmonics = 100;
    m_harmonics->setRange(1, mostHarmonics);
    m_harmonics->setKeyboardTracking(false);
    addRow(m_harmonics, "fitHarmonics");
    connect(m_harmonics, &QSpinBox::valueChanged, this, [this] { report(m_harmonics); });
    m_turn = addNumbers("fitTurn", 1, 0.0, true);
}

void FitForm::buildGrid()
{
    m_gridHeading = addHeading();
    m_grid = addList("fitGrid", 4);
    // The targets, until the number that a kind of grid needs has been given.
    m_grid->disconnect(this);
    connect(m_grid, &QComboBox::activated, this, [this] {
        m_openGrid = m_grid->currentData().toInt();
        report(m_grid);
        showRows();
        Q_EMIT problemChanged();
    });
    m_points = new NumberEdit({.most = 3, .smallest = 2.0, .areWhole = true});
    addRow(m_points, "fitPoints");
    m_numbers.push_back(m_points);
    m_distance = new NumberEdit({.most = 3, .smallest = 0.0, .isMore = true});
    addRow(m_distance, "fitDistance");
    m_numbers.push_back(m_distance);
    m_within = new NumberEdit({.most = 1, .smallest = 0.0, .isMore = true});
    addRow(m_within, "fitWithin");
    m_numbers.push_back(m_within);
    for (NumberEdit* field : {m_points, m_distance, m_within}) {
        connect(field, &NumberEdit::chosen, this, [this, field] {
            m_openGrid = m_grid->currentData().toInt();
            report(field);
            Q_EMIT problemChanged();
        });
        connect(field, &NumberEdit::problemChanged, this, &FitForm::problemChanged);
    }
    m_hold = new QCheckBox;
    m_hold->setObjectName(QStringLiteral("fitHold"));
    m_form->addRow(QString(), m_hold);
    connect(m_hold, &QCheckBox::clicked, this, [this] { report(m_hold); });
}

void FitForm::buildZero()
{
    m_zeroHeading = addHeading();
    m_zero = addList("fitZero", 6);
    m_zeroPosition = addNumbers("fitZeroPosition", 3, std::nullopt);
    m_home = addNumbers("fitHome", 1, std::nullopt);
    m_slope = addList("fitSlope", 3);
    m_drift = addList("fitDrift", 3);
}

void FitForm::buildPoints()
{
    m_pointsHeading = addHeading();
    m_body = addList("fitBody", 6);
    m_far = addList("fitFar", 3);
    m_robust = new QCheckBox;
    m_robust->setObjectName(QStringLiteral("fitRobust"));
    m_form->addRow(QString(), m_robust);
    connect(m_robust, &QCheckBox::clicked, this, [this] { report(m_robust); });
}

QLabel* FitForm::addHeading()
{
    auto* heading = new PlainLabel;
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    m_form->addRow(heading);
    return heading;
}

void FitForm::addRow(QWidget* field, const char* name)
{
    auto* label = new PlainLabel;
    label->setBuddy(field);
    field->setObjectName(QLatin1StringView(name));
    m_form->addRow(label, field);
}

QComboBox* FitForm::addList(const char* name, int items)
{
    auto* list = new QComboBox;
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    constexpr int fewestLetters = 16;
    list->setMinimumContentsLength(fewestLetters);
    for (int n = 0; n < items; ++n)
        list->addItem(QString(), n);
    addRow(list, name);
    connect(list, &QComboBox::activated, this, [this, list] { report(list); });
    return list;
}

NumberEdit* FitForm::addNumbers(
    const char* name, std::size_t most, std::optional<double> smallest, bool isMore)
{
    auto* field = new NumberEdit({.most = most, .smallest = smallest, .isMore = isMore});
    addRow(field, name);
    connect(field, &NumberEdit::chosen, this, [this, field] { report(field); });
    connect(field, &NumberEdit::problemChanged, this, &FitForm::problemChanged);
    m_numbers.push_back(field);
    return field;
}

QString FitForm::problem() const
{
    for (const NumberEdit* field : m_numbers)
        if (field->isVisibleTo(this) && !field->problem().isEmpty())
            return field->problem();
    for (const NumberEdit* field : {m_points, m_distance, m_within, m_zeroPosition})
        if (field->isVisibleTo(this) && field->numbers().empty())
            return tr("%1: a number is needed. %2")
                .arg(field->accessibleName(), field->accessibleDescription());
    return {};
}

void FitForm::reportFile(QComboBox* list, int file, bool isOnto)
{
    if (list->currentData().toInt() != file)
        return report(list);
    // What is shown stays until a file is there.
    list->setCurrentIndex(indexOf(
        *list, isOnto ? static_cast<int>(m_shown.onto) : static_cast<int>(m_shown.measuredWith)));
    Q_EMIT fileWanted(isOnto);
}

void FitForm::report(QWidget* field)
{
    const FitChoices choices = read();
    if (choices == m_shown)
        return;
    const auto* label = qobject_cast<QLabel*>(m_form->labelForField(field));
    const auto* box = qobject_cast<QCheckBox*>(field);
    const QString name = box ? box->text() : label ? label->text() : QString();
    m_isReporting = true;
    Q_EMIT chosen(choices, withoutKey(name));
    m_isReporting = false;
}

FitChoices FitForm::read() const
{
    FitChoices choices = m_shown;
    FitSettings& settings = choices.settings;
    const auto chosen = [](const QComboBox* list) { return list->currentData().toInt(); };
    settings.lookupAt.reset();
    if (chosen(m_lookup) == 1)
        settings.lookupAt = LookupAt::Encoder;
    else if (chosen(m_lookup) == 2)
        settings.lookupAt = LookupAt::Set;
    choices.measuredWith = static_cast<MeasuredWith>(chosen(m_measuredWith));
    choices.onto = static_cast<Onto>(chosen(m_onto));
    settings.gain = firstOf(*m_gain).value_or(1.0);
    settings.method = static_cast<FitMethod>(chosen(m_method));
    settings.direction = static_cast<FitDirection>(chosen(m_direction));
    settings.smoothness = firstOf(*m_smoothness);
    settings.periods = {m_periods->numbers(), m_harmonics->value()};
    settings.turn = firstOf(*m_turn);
    readGrid(settings);
    settings.holdsEnds = m_hold->isChecked();
    settings.zero = static_cast<FitZero>(chosen(m_zero));
    settings.zeroPosition = m_zeroPosition->numbers();
    settings.home = firstOf(*m_home);
    settings.slope = static_cast<SlopeRemoval>(chosen(m_slope));
    settings.drift.reset();
    if (chosen(m_drift) > 0)
        settings.drift = chosen(m_drift) == 1 ? DriftRemoval::Offset : DriftRemoval::Trend;
    // None, rigid, rigid along one of three axes, scale.
    const int body = chosen(m_body);
    settings.remove = body == 0 ? BodyRemoval::None
        : body == 1             ? BodyRemoval::Rigid
        : body == 5             ? BodyRemoval::Scale
                                : BodyRemoval::RigidAlong;
    settings.removeAlong =
        settings.remove == BodyRemoval::RigidAlong ? static_cast<std::size_t>(body - 2) : 0;
    settings.farPoints = static_cast<FarPoints>(chosen(m_far));
    settings.isRobust = m_robust->isChecked();
    return choices;
}

void FitForm::readGrid(FitSettings& settings) const
{
    settings.grid.clear();
    settings.within.reset();
    switch (static_cast<GridKind>(m_grid->currentData().toInt())) {
    case GridKind::Even:
        return;
    case GridKind::Points:
        for (const double points : m_points->numbers())
            settings.grid.push_back({.points = static_cast<std::size_t>(points)});
        return;
    case GridKind::Distance:
        for (const double distance : m_distance->numbers())
            settings.grid.push_back({.distance = distance});
        return;
    case GridKind::Within:
        settings.within = firstOf(*m_within);
        return;
    }
}

void FitForm::show(const FitChoices& choices, const RecordState& state, const FitDrive& drive)
{
    const bool isOther = m_shown != choices;
    m_shown = choices;
    const Measurement none;
    const Measurement& shown = state.measurement ? *state.measurement : none;
    m_kind = shown.kind;
    m_unit = positionUnit(shown);
    m_axes = shown.points.axes;
    offerMethods();
    offerBodies();
    m_fields = fitFields(shown, choices.settings);
    m_hasRaw = state.measurement && state.hasRaw;
    m_onFile = shown.header.compensation;
    m_isStateAsked = !m_hasRaw && m_onFile.kind == MeasuredState::Kind::NotSaid;
    const FitChoices& said = state.record.fit;
    m_wasSaidOfOther = said.measuredWith != choices.measuredWith;
    m_wasOntoOther = said.onto != choices.onto;
    m_lookupOfDrive = drive.lookupAt();
    m_source = drive.axis ? drive.axis->source : std::string();
    for (NumberEdit* field : {m_points, m_distance, m_zeroPosition})
        field->setMost(dimensionsOf(m_axes));
    showDrive();
    showCurve();
    if (isOther && !m_isReporting)
        m_openGrid.reset();
    if (isOther)
        showGrid();
    showZero();
    showPoints();
    showRows();
}

void FitForm::forgetTyped()
{
    m_openGrid.reset();
    for (NumberEdit* field : m_numbers)
        field->forgetTyped();
    showGrid();
}

void FitForm::showDrive()
{
    m_lookup->setCurrentIndex(!m_shown.settings.lookupAt      ? 0
            : *m_shown.settings.lookupAt == LookupAt::Encoder ? 1
                                                              : 2);
    m_measuredWith->setCurrentIndex(
        indexOf(*m_measuredWith, static_cast<int>(m_shown.measuredWith)));
    m_onto->setCurrentIndex(indexOf(*m_onto, static_cast<int>(m_shown.onto)));
    m_gain->setNumbers({m_shown.settings.gain});
    sayWhereLookedUp();
    sayWhatWasActive();
}

void FitForm::showCurve()
{
    const FitSettings& settings = m_shown.settings;
    const FitMethod method =
        isMethodFor(m_kind, settings.method) ? settings.method : FitMethod::Linear;
    m_method->setCurrentIndex(indexOf(*m_method, static_cast<int>(method)));
    m_direction->setCurrentIndex(indexOf(*m_direction, static_cast<int>(settings.direction)));
    m_smoothness->setNumbers(listOf(settings.smoothness));
    m_periods->setNumbers(settings.periods.periods);
    // A number that is being typed is left to the user.
    if (m_harmonics->value() != settings.periods.harmonics) {
        const QSignalBlocker blocker(m_harmonics);
        m_harmonics->setValue(settings.periods.harmonics);
    }
    m_turn->setNumbers(listOf(settings.turn));
}

void FitForm::showGrid()
{
    const FitSettings& settings = m_shown.settings;
    const int said = static_cast<int>(gridKindOf(settings));
    const bool isSaid = said != static_cast<int>(GridKind::Even);
    m_grid->setCurrentIndex(indexOf(*m_grid, isSaid ? said : m_openGrid.value_or(said)));
    std::vector<double> points;
    std::vector<double> distances;
    for (const AxisRequest& request : settings.grid) {
        if (request.points != 0)
            points.push_back(static_cast<double>(request.points));
        else
            distances.push_back(request.distance);
    }
    m_points->setNumbers(points);
    m_distance->setNumbers(distances);
    m_within->setNumbers(listOf(settings.within));
    m_hold->setChecked(settings.holdsEnds);
}

void FitForm::showZero()
{
    const FitSettings& settings = m_shown.settings;
    m_zero->setCurrentIndex(indexOf(*m_zero, static_cast<int>(settings.zero)));
    m_zeroPosition->setNumbers(settings.zeroPosition);
    m_home->setNumbers(listOf(settings.home));
    m_slope->setCurrentIndex(indexOf(*m_slope, static_cast<int>(settings.slope)));
    m_drift->setCurrentIndex(!settings.drift ? 0 : *settings.drift == DriftRemoval::Offset ? 1 : 2);
}

void FitForm::showPoints()
{
    const FitSettings& settings = m_shown.settings;
    const int body = settings.remove == BodyRemoval::None ? 0
        : settings.remove == BodyRemoval::Rigid           ? 1
        : settings.remove == BodyRemoval::Scale           ? 5
                                                : 2 + static_cast<int>(settings.removeAlong);
    m_body->setCurrentIndex(std::max(0, indexOf(*m_body, body)));
    m_far->setCurrentIndex(indexOf(*m_far, static_cast<int>(settings.farPoints)));
    m_robust->setChecked(settings.isRobust);
}

void FitForm::setRow(QWidget* field, bool isShown)
{
    m_haveRowsChanged = m_haveRowsChanged || m_form->isRowVisible(field) != isShown;
    m_form->setRowVisible(field, isShown);
}

void FitForm::showRows()
{
    const auto grid = static_cast<GridKind>(m_grid->currentData().toInt());
    setRow(m_lookupNote, !m_lookupNote->text().isEmpty());
    setRow(m_measuredWith, m_isStateAsked);
    setRow(m_stateNote, !m_stateNote->text().isEmpty());
    setRow(m_ontoNote, !m_ontoNote->text().isEmpty());
    setRow(m_gain, m_shown.onto != Onto::Nothing);
    setRow(m_curveHeading, m_fields.method || m_fields.smoothness);
    setRow(m_method, m_fields.method);
    setRow(m_direction, m_fields.direction);
    setRow(m_smoothness, m_fields.smoothness);
    setRow(m_periods, m_fields.periods);
    setRow(m_harmonics, m_fields.harmonics);
    setRow(m_turn, m_fields.turn);
    setRow(m_points, grid == GridKind::Points);
    setRow(m_distance, grid == GridKind::Distance);
    setRow(m_within, grid == GridKind::Within);
    setRow(m_hold, m_fields.holdsEnds);
    setRow(m_zeroPosition, m_shown.settings.zero == FitZero::Position);
    setRow(m_home, m_fields.home);
    setRow(m_slope, m_fields.slope);
    setRow(m_drift, m_fields.drift);
    const bool hasScatter = m_fields.body || m_fields.farPoints || m_fields.robust;
    setRow(m_pointsHeading, hasScatter);
    setRow(m_body, m_fields.body);
    setRow(m_far, m_fields.farPoints);
    setRow(m_robust, m_fields.robust);
    if (std::exchange(m_haveRowsChanged, false))
        Q_EMIT rowsChanged();
}

void FitForm::sayWhereLookedUp()
{
    QString note;
    if (m_source.empty())
        note = tr("The current axis has no source.");
    else if (!m_lookupOfDrive)
        note = tr("%1 of the current axis is no known position.").arg(qString(m_source));
    else
        note = *m_lookupOfDrive == LookupAt::Encoder
            ? tr("%1 of the current axis is a position before the compensation.")
                  .arg(qString(m_source))
            : tr("%1 of the current axis is a position after the compensation.")
                  .arg(qString(m_source));
    m_lookupNote->setText(note);
}

void FitForm::sayWhatWasActive()
{
    QString note;
    if (m_hasRaw)
        note = tr("The raw positions are on file: it does not matter what was active.");
    else if (m_onFile.kind == MeasuredState::Kind::Off)
        note = tr("Measured with the compensation off, as the file says.");
    else if (m_onFile.kind == MeasuredState::Kind::On)
        note = m_onFile.tableCrc ? tr("Measured with the table %1 active, as the file says.")
                                       .arg(*m_onFile.tableCrc, 8, 16, QLatin1Char('0'))
                                 : tr("Measured with the compensation on, as the file says.");
    else if (m_shown.measuredWith == MeasuredWith::File)
        note = QFileInfo(m_shown.measuredWithFile).fileName();
    const QString otherTable = tr("The axis has another table since that was said: say it anew.");
    m_stateNote->setText(m_isStateAsked && m_wasSaidOfOther ? otherTable : note);
    m_ontoNote->setText(m_wasOntoOther   ? otherTable
            : m_shown.onto == Onto::File ? QFileInfo(m_shown.ontoFile).fileName()
                                         : QString());
}

void FitForm::nameRow(QWidget* field, const QString& name, const QString& description)
{
    const QString shown = field->isHidden() ? name : withFreeKey(name, *m_keys);
    if (auto* box = qobject_cast<QCheckBox*>(field))
        box->setText(shown);
    else if (auto* label = qobject_cast<QLabel*>(m_form->labelForField(field)))
        label->setText(shown);
    field->setAccessibleName(name);
    field->setToolTip(description);
    field->setAccessibleDescription(description);
}

void FitForm::setItems(QComboBox* list, const QStringList& items)
{
    for (int n = 0; n < list->count(); ++n)
        list->setItemText(n, items.value(list->itemData(n).toInt()));
}

void FitForm::retranslate(QSet<QChar>& used)
{
    m_keys = &used;
    retranslateDrive();
    retranslateCurve();
    retranslateGrid();
    retranslateZero();
    retranslatePoints();
    m_keys = nullptr;
    sayWhereLookedUp();
    sayWhatWasActive();
}

void FitForm::retranslateDrive()
{
    m_driveHeading->setText(tr("Drive"));
    nameRow(m_lookup, tr("Lookup at"),
        tr("Where the drive looks its table up; it decides where the values belong"));
    setItems(m_lookup,
        {tr("as the source of the axis says"), tr("encoder, uncompensated"),
            tr("set position, compensated")});
    nameRow(m_measuredWith, tr("Measured with"),
        tr("What was active while it was measured, since the file does not say it"));
    setItems(m_measuredWith,
        {tr("not said"), tr("compensation off"), tr("the table that is merged onto"),
            tr("the table of a file…")});
    nameRow(m_onto, tr("Merge onto"),
        tr("The table to which residuals are added, that was active while they were measured"));
    setItems(m_onto, {tr("nothing"), tr("the table of the axis"), tr("the table of a file…")});
    nameRow(m_gain, tr("Gain"),
        tr("Factor for the residuals: 1, or below it, such as 0.7, where the machine responds "
           "sluggishly; at most 2"));
}

void FitForm::retranslateCurve()
{
    m_curveHeading->setText(tr("Curve"));
    nameRow(m_method, tr("Method"), tr("The curve through or near the means"));
    setItems(m_method,
        {tr("linear: straight lines"), tr("cubic: without overshoot"), tr("spline: natural cubic"),
            tr("smooth: near the values"), tr("harmonic: of a turn")});
    nameRow(m_direction, tr("Direction"), tr("Which runs the table is made of"));
    setItems(m_direction, {tr("mean of up and down"), tr("up only"), tr("down only")});
    nameRow(m_smoothness, tr("Smoothness"),
        tr("A number from 0 on; by cross-validation when the field is empty"));
    m_smoothness->setPlaceholderText(tr("automatic"));
    nameRow(m_periods, tr("Periods"),
        tr("Known periods above 0, such as the lead of the screw: 10; 2.5"));
    m_periods->setPlaceholderText(tr("none"));
    nameRow(m_harmonics, tr("Harmonics"),
        tr("Of each period, or of the turn; 1 is the fundamental alone"));
    nameRow(m_turn, tr("Turn"),
        tr("Length of a turn of a modulo axis, such as 360: the table ends as it begins"));
    m_turn->setPlaceholderText(tr("no modulo axis"));
}

void FitForm::retranslateGrid()
{
    m_gridHeading->setText(tr("Grid of the table"));
    nameRow(m_grid, tr("Points at"), tr("Positions of the table, always evenly spaced"));
    setItems(m_grid,
        {tr("those measured, where even"), tr("a number of points"), tr("a distance"),
            tr("the fewest points for a deviation")});
    nameRow(m_points, tr("Number"), tr("Whole numbers from 2 on: one for all axes, or 41; 31"));
    nameRow(m_distance, tr("Distance"),
        tr("Above 0, in the unit of the positions: one for all axes, or 10; 5"));
    nameRow(m_within, tr("Deviation"), tr("Above 0, in the unit of the positions"));
    nameRow(m_hold, tr("Hold ends beyond the targets"),
        tr("The grid may go beyond the targets, where the end values are held"));
}

void FitForm::retranslateZero()
{
    m_zeroHeading->setText(tr("Zero, slope and drift"));
    nameRow(
        m_zero, tr("Zero"), tr("Where the table is 0: the zero of the instrument is arbitrary"));
    setItems(m_zero,
        {tr("home, else first target"), tr("at the home position"), tr("at the first target"),
            tr("mean of the values"), tr("at a position"), tr("as measured")});
    nameRow(m_zeroPosition, tr("At"), tr("The position of the zero, one number for each axis"));
    nameRow(m_home, tr("Home"), tr("The home position of the axis"));
    m_home->setPlaceholderText(tr("not known"));
    nameRow(m_slope, tr("Slope"), tr("It is taken out of straightness alone: scale error is real"));
    setItems(m_slope, {tr("kept"), tr("taken out by least squares"), tr("taken out by the ends")});
    nameRow(m_drift, tr("Drift"),
        tr("What is taken out of runs that lie beside each other before the table is made"));
    setItems(m_drift, {tr("kept"), tr("offset of each run taken out"), tr("trend taken out")});
}

void FitForm::offer(QComboBox* list, int item, bool isOffered)
{
    const int index = list->findData(item);
    if (auto* model = qobject_cast<QStandardItemModel*>(list->model()))
        model->item(index)->setEnabled(isOffered);
    if (auto* view = qobject_cast<QListView*>(list->view()))
        view->setRowHidden(index, !isOffered);
}

void FitForm::offerMethods()
{
    for (int method = 0; method < m_method->count(); ++method)
        offer(m_method, method, isMethodFor(m_kind, static_cast<FitMethod>(method)));
}

/// Along which of the axes lines keep no slope.
void FitForm::offerBodies()
{
    constexpr int firstAlong = 2;
    constexpr std::size_t mostAxes = 3;
    QStringList items{tr("nothing"), tr("alignment")};
    for (std::size_t axis = 0; axis < mostAxes; ++axis)
        items += axis < m_axes.size()
            ? tr("alignment, lines along %1 level").arg(qString(m_axes[axis]))
            : QString();
    items += tr("alignment and scale");
    setItems(m_body, items);
    for (std::size_t axis = 0; axis < mostAxes; ++axis)
        offer(m_body, firstAlong + static_cast<int>(axis), axis < m_axes.size());
}

void FitForm::retranslatePoints()
{
    m_pointsHeading->setText(tr("Points"));
    nameRow(m_body, tr("Take out"), tr("How the artefact lay is no error of the machine"));
    offerBodies();
    nameRow(m_far, tr("Far points"), tr("Points of the grid that are far from any measured one"));
    setItems(m_far, {tr("refused"), tr("filled smoothly"), tr("filled with the nearest")});
    nameRow(m_robust, tr("Robust"), tr("Values that do not fit the others count less"));
}

} // namespace axiscomp::ui
