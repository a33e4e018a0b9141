// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/compensation_setup.h"
#include "ui/text/language.h"

#include <QAbstractTableModel>

#include <array>
#include <optional>
#include <span>

namespace axiscomp::ui {

/// The editable fields of the page (AN140 2.4).
enum class Field { Dimensionality, Source1, Source2, Source3, Table, Persistency };
inline constexpr std::array allFields{Field::Dimensionality, Field::Source1, Field::Source2,
    Field::Source3, Field::Table, Field::Persistency};
/// dimension 1, 2, 3
[[nodiscard]] constexpr Field sourceField(int dimension)
{
    return static_cast<Field>(static_cast<int>(Field::Source1) + dimension - 1);
}

/// Which table the axis shall have: the one on the drive, or one of the open file's.
struct TableChoice {
    std::optional<int> fileTable; ///< index into the file's tables; none: the table on the drive
    friend bool operator==(const TableChoice&, const TableChoice&) = default;
};

/// What the user chooses for one axis.
struct EditedSetup {
    int dimensionality = 1;
    std::array<DimSource, 3> sources;
    TableChoice table;
    Persistency persistency = Persistency::Volatile;
    friend bool operator==(const EditedSetup&, const EditedSetup&) = default;
};

[[nodiscard]] bool sameValue(Field field, const EditedSetup& a, const EditedSetup& b);

/// The paths of the sources that are set, of the chosen dimensions alone.
[[nodiscard]] std::vector<std::string> sourcePaths(const EditedSetup& edited);

/// As a request names it: by its path, by its address when it has none.
[[nodiscard]] std::string requestedSource(const DimSource& source);

/// Two plain values, the baseline (only ever what was read back from the drive) and the edited one.
/// A field is changed when they differ; nothing is stored about it. As a table it has a row per
/// field, in the order of allFields, and one column.
class SetupModel : public QAbstractTableModel {
    Q_OBJECT

public:
    /// The value that is edited is Qt::EditRole: the number of dimensions, a source's path, the
    /// index of a file's table (none: the one on the drive), whether it is persistent.
    enum Role {
        DriveValueRole = Qt::UserRole, ///< the baseline's value, none without a baseline
        DirtyRole, ///< isDirty(Field)
        ProblemRole, ///< problem(), empty when there is none
    };

    explicit SetupModel(QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

    [[nodiscard]] bool hasBaseline() const { return m_baseline.has_value(); }
    [[nodiscard]] const CompensationSetup& baseline() const;
    [[nodiscard]] const EditedSetup& edited() const { return m_edited; }

    /// What the drive now has. Fields that are not changed follow it; changed ones keep the user's
    /// value.
    void setBaseline(const CompensationSetup& setup);
    /// Another axis: the edited value becomes the drive's, but for the table.
    void reset(const CompensationSetup& setup, TableChoice table = {});
    void clear();
    /// The table of the file that the drive has already, the same numbers at the same places: to
    /// choose it changes nothing. None: it has none of those that were compared.
    void setTableOnDrive(std::optional<int> fileTable);
    /// Puts these fields to the values of another setup; not as a change of the user.
    void put(const EditedSetup& values, std::span<const Field> fields);

    // What the user changes
    void setDimensionality(int dimensionality);
    void setSource(int dimension, const DimSource& source); ///< dimension 1, 2, 3
    void setTable(TableChoice table);
    void setPersistency(Persistency persistency);

    /// Sources above the dimensionality do not count as changed, nor does a table that the drive
    /// has already.
    [[nodiscard]] bool isDirty(Field field) const;
    [[nodiscard]] bool isDirty() const;
    void revert(Field field);
    void revert() override;

    /// Why the field did not get the value that was last entered, a translated sentence; it keeps
    /// its old value. Empty: there is nothing wrong.
    [[nodiscard]] QString problem(Field field) const;
    void setProblem(Field field, const Wording& problem);

Q_SIGNALS:
    /// A value of the field, or whether it is changed, is different now.
    void fieldChanged(axiscomp::ui::Field field);
    void changedByUser(); ///< behind all fieldChanged of one change
    void changedOtherwise();

private:
    template <typename Change> void apply(const Change& change);
    template <typename Change> void applyForUser(const Change& change);

    std::optional<CompensationSetup> m_baseline;
    std::optional<int> m_tableOnDrive; ///< of the file
    EditedSetup m_edited;
    std::array<Wording, allFields.size()> m_problems; ///< none: nothing is wrong with it
};

} // namespace axiscomp::ui
