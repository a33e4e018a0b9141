// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/setup_history.h"

#include "ui/controller/table_selection.h"

#include <QScopedValueRollback>

#include <algorithm>

namespace axiscomp::ui {

namespace {

/// Each step keeps its file, as far as it is another one.
constexpr int mostSteps = 50;

QString fieldText(Field field)
{
    switch (field) {
    case Field::Dimensionality:
        return SetupHistory::tr("Dimensionality");
    case Field::Table:
        return SetupHistory::tr("Table");
    case Field::Persistency:
        return SetupHistory::tr("Persistency");
    case Field::Source1:
    case Field::Source2:
    case Field::Source3:
        break;
    }
    return SetupHistory::tr("Dim%1 Source")
        .arg(static_cast<int>(field) - static_cast<int>(Field::Source1) + 1);
}

} // namespace

/// What is there when the step is undone is what comes back when it is done again: a file may have
/// been read in the meantime.
class SetupHistory::Step final : public QUndoCommand {
public:
    Step(SetupHistory& history, State before, std::vector<Field> changed, bool isOfFile)
        : fields(std::move(changed))
        , withFile(isOfFile)
        , m_history(history)
        , m_before(std::move(before))
    {
    }

    void undo() override
    {
        m_after = m_history.now();
        m_history.apply(m_before, fields, withFile);
    }
    void redo() override
    {
        if (m_isDone)
            m_history.apply(m_after, fields, withFile);
        m_isDone = true;
    }

    const std::vector<Field> fields;
    const bool withFile;

private:
    SetupHistory& m_history;
    State m_before;
    State m_after;
    bool m_isDone = false; ///< the user has done it before it got here
};

SetupHistory::SetupHistory(SetupModel& setup, TableSelection& tables)
    : m_setup(setup)
    , m_tables(tables)
    , m_last(now())
{
    m_steps.setUndoLimit(mostSteps);
    connect(&setup, &SetupModel::changedByUser, this, &SetupHistory::note);
    connect(&setup, &SetupModel::changedOtherwise, this, &SetupHistory::follow);
    connect(&tables, &TableSelection::fileOpened, this, &SetupHistory::note);
    connect(&tables, &TableSelection::fileReadAgain, this, &SetupHistory::follow);
    connect(&m_steps, &QUndoStack::indexChanged, this, &SetupHistory::changed);
}

/// The stack says that it is emptied: there is nobody left who could ask what that means.
SetupHistory::~SetupHistory()
{
    m_steps.disconnect(this);
}

SetupHistory::State SetupHistory::now() const
{
    return {m_setup.edited(), m_tables.file().opened()};
}

void SetupHistory::note()
{
    if (m_isApplying)
        return;
    State state = now();
    std::vector<Field> changed;
    std::ranges::copy_if(allFields, std::back_inserter(changed),
        [&](Field field) { return !sameValue(field, m_last.edited, state.edited); });
    const bool isOfFile = m_last.file.file.path != state.file.file.path;
    State before = std::exchange(m_last, std::move(state));
    DataFile& file = before.file.file;
    if (isOfFile && file.readingPath == m_last.file.file.path) {
        file.isReading = false; // undone, it is not read again
        file.readingPath.clear();
    }
    if (m_setup.hasBaseline() && (!changed.empty() || isOfFile))
        m_steps.push(new Step(*this, std::move(before), std::move(changed), isOfFile));
}

void SetupHistory::follow()
{
    if (!m_isApplying)
        m_last = now();
}

/// The columns of the file may be in another order since.
EditedSetup SetupHistory::inFileOfNow(const State& state) const
{
    EditedSetup edited = state.edited;
    const auto& then = state.file.file.data;
    const auto& now = m_tables.file().file().data;
    const std::optional<int> chosen = edited.table.fileTable;
    if (chosen && then && now && then != now && *chosen < static_cast<int>(then->tables.size()))
        edited.table.fileTable = sameTableIn(*then, *chosen, *now);
    return edited;
}

/// The file first: what the setup says about its table is of that file.
void SetupHistory::apply(const State& state, const std::vector<Field>& fields, bool withFile)
{
    {
        const QScopedValueRollback applying(m_isApplying, true);
        const bool isOfFile =
            withFile || std::ranges::find(fields, Field::Dimensionality) != fields.end();
        if (isOfFile)
            m_tables.putBack(state.file);
        m_setup.put(isOfFile ? state.edited : inFileOfNow(state), fields);
    }
    m_last = now();
}

QString SetupHistory::textOf(int step) const
{
    if (step < 0 || step >= m_steps.count())
        return {};
    const auto& found = *static_cast<const Step*>(m_steps.command(step));
    if (found.withFile)
        return tr("Compensation data");
    return found.fields.size() == 1 ? fieldText(found.fields.front()) : tr("Several fields");
}

QString SetupHistory::undoText() const
{
    return textOf(m_steps.index() - 1);
}

QString SetupHistory::redoText() const
{
    return textOf(m_steps.index());
}

void SetupHistory::undo()
{
    m_steps.undo();
}

void SetupHistory::redo()
{
    m_steps.redo();
}

void SetupHistory::clear()
{
    m_last = now();
    m_steps.clear();
}

} // namespace axiscomp::ui
