// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/setup_model.h"

#include "core/drive/axis_target.h"

#include <algorithm>

namespace axiscomp::ui {

namespace {

EditedSetup asEdited(const CompensationSetup& setup)
{
    return {setup.dimensionality, setup.sources, {}, setup.persistency};
}

bool isSource(Field field)
{
    return field == Field::Source1 || field == Field::Source2 || field == Field::Source3;
}

std::size_t sourceIndex(Field field)
{
    return static_cast<std::size_t>(field) - static_cast<std::size_t>(Field::Source1);
}

/// Calls use with the function that gives the field's member of a setup.
template <typename Use> auto withMember(Field field, const Use& use)
{
    switch (field) {
    case Field::Dimensionality:
        return use([](auto& setup) -> auto& { return setup.dimensionality; });
    case Field::Table:
        return use([](auto& setup) -> auto& { return setup.table; });
    case Field::Persistency:
        return use([](auto& setup) -> auto& { return setup.persistency; });
    case Field::Source1:
    case Field::Source2:
    case Field::Source3:
        break;
    }
    return use([n = sourceIndex(field)](auto& setup) -> auto& { return setup.sources[n]; });
}

void copyValue(Field field, const EditedSetup& from, EditedSetup& to)
{
    withMember(field, [&](auto member) { member(to) = member(from); });
}

QVariant asVariant(int dimensionality)
{
    return dimensionality;
}

QVariant asVariant(const DimSource& source)
{
    return source.isSet() ? QString::fromStdString(requestedSource(source)) : QString();
}

QVariant asVariant(const TableChoice& table)
{
    return table.fileTable ? QVariant(*table.fileTable) : QVariant();
}

QVariant asVariant(Persistency persistency)
{
    return persistency == Persistency::Persistent;
}

QVariant valueOf(Field field, const EditedSetup& setup)
{
    return withMember(field, [&](auto member) { return asVariant(member(setup)); });
}

} // namespace

bool sameValue(Field field, const EditedSetup& a, const EditedSetup& b)
{
    return withMember(field, [&](auto member) { return member(a) == member(b); });
}

std::vector<std::string> sourcePaths(const EditedSetup& edited)
{
    CompensationSetup chosen;
    std::copy_n(edited.sources.begin(), edited.dimensionality, chosen.sources.begin());
    return axiscomp::sourcePaths(chosen);
}

std::string requestedSource(const DimSource& source)
{
    return source.path.empty()
        ? QStringLiteral("0x%1").arg(source.address, 8, 16, QChar(u'0')).toStdString()
        : source.path;
}

SetupModel::SetupModel(QObject* parent) : QAbstractTableModel(parent) { }

int SetupModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(allFields.size());
}

int SetupModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : 1;
}

QVariant SetupModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Field field = allFields.at(static_cast<std::size_t>(index.row()));
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return valueOf(field, m_edited);
    case DriveValueRole:
        return m_baseline ? valueOf(field, asEdited(*m_baseline)) : QVariant();
    case DirtyRole:
        return isDirty(field);
    case ProblemRole:
        return problem(field);
    default:
        return {};
    }
}

const CompensationSetup& SetupModel::baseline() const
{
    static const CompensationSetup none;
    return m_baseline ? *m_baseline : none;
}

/// Changes the values and announces every field that looks different afterwards.
template <typename Change> void SetupModel::apply(const Change& change)
{
    const EditedSetup before = m_edited;
    std::array<bool, allFields.size()> wasDirty{};
    for (std::size_t i = 0; i < allFields.size(); ++i)
        wasDirty[i] = isDirty(allFields[i]);
    const std::optional<CompensationSetup> baselineBefore = m_baseline;
    change();
    for (std::size_t i = 0; i < allFields.size(); ++i) {
        const Field field = allFields[i];
        if (sameValue(field, before, m_edited) && wasDirty[i] == isDirty(field)
            && baselineBefore == m_baseline)
            continue;
        const QModelIndex row = index(static_cast<int>(i), 0);
        Q_EMIT dataChanged(row, row, {Qt::DisplayRole, Qt::EditRole, DriveValueRole, DirtyRole});
        Q_EMIT fieldChanged(field);
    }
}

template <typename Change> void SetupModel::applyForUser(const Change& change)
{
    apply(change);
    Q_EMIT changedByUser();
}

void SetupModel::setBaseline(const CompensationSetup& setup)
{
    apply([&] {
        EditedSetup followed = asEdited(setup);
        for (const Field field : allFields) {
            if (m_baseline && isDirty(field))
                copyValue(field, m_edited, followed);
        }
        m_baseline = setup;
        m_edited = followed;
    });
    Q_EMIT changedOtherwise();
}

void SetupModel::reset(const CompensationSetup& setup, TableChoice table)
{
    apply([&] {
        m_baseline = setup;
        m_edited = asEdited(setup);
        m_edited.table = table;
    });
    Q_EMIT changedOtherwise();
}

void SetupModel::clear()
{
    apply([&] {
        m_baseline.reset();
        m_edited = {};
    });
    Q_EMIT changedOtherwise();
}

void SetupModel::setTableOnDrive(std::optional<int> fileTable)
{
    if (fileTable != m_tableOnDrive)
        apply([&] { m_tableOnDrive = fileTable; });
}

void SetupModel::put(const EditedSetup& values, std::span<const Field> fields)
{
    apply([&] {
        for (const Field field : fields)
            copyValue(field, values, m_edited);
    });
    Q_EMIT changedOtherwise();
}

void SetupModel::setDimensionality(int dimensionality)
{
    applyForUser([&] { m_edited.dimensionality = dimensionality; });
}

void SetupModel::setSource(int dimension, const DimSource& source)
{
    applyForUser([&] { m_edited.sources.at(static_cast<std::size_t>(dimension - 1)) = source; });
}

void SetupModel::setTable(TableChoice table)
{
    applyForUser([&] { m_edited.table = table; });
}

void SetupModel::setPersistency(Persistency persistency)
{
    applyForUser([&] { m_edited.persistency = persistency; });
}

bool SetupModel::isDirty(Field field) const
{
    if (!m_baseline)
        return false;
    if (isSource(field) && static_cast<int>(sourceIndex(field)) >= m_edited.dimensionality)
        return false;
    if (field == Field::Table && m_edited.table.fileTable
        && m_edited.table.fileTable == m_tableOnDrive)
        return false;
    return !sameValue(field, m_edited, asEdited(*m_baseline));
}

bool SetupModel::isDirty() const
{
    for (const Field field : allFields) {
        if (isDirty(field))
            return true;
    }
    return false;
}

void SetupModel::revert(Field field)
{
    if (m_baseline)
        applyForUser([&] { copyValue(field, asEdited(*m_baseline), m_edited); });
}

void SetupModel::revert()
{
    if (m_baseline)
        applyForUser([&] { m_edited = asEdited(*m_baseline); });
}

QString SetupModel::problem(Field field) const
{
    const Wording& problem = m_problems[static_cast<std::size_t>(field)];
    return problem ? problem() : QString();
}

void SetupModel::setProblem(Field field, const Wording& problem)
{
    m_problems[static_cast<std::size_t>(field)] = problem;
    const QModelIndex row = index(static_cast<int>(field), 0);
    Q_EMIT dataChanged(row, row, {ProblemRole});
}

} // namespace axiscomp::ui
