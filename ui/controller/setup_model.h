// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/compensation_setup.h"

#include <QObject>

#include <array>
#include <optional>

namespace axiscomp::ui {

/// The editable fields of the page (AN140 2.4).
enum class Field { Dimensionality, Source1, Source2, Source3, Table, Persistency };
inline constexpr std::array allFields{Field::Dimensionality, Field::Source1, Field::Source2,
    Field::Source3, Field::Table, Field::Persistency};

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

/// Two plain values, the baseline (only ever what was read back from the drive) and the edited one.
/// A field is changed when they differ; nothing is stored about it.
class SetupModel : public QObject {
    Q_OBJECT

public:
    explicit SetupModel(QObject* parent = nullptr);

    [[nodiscard]] bool hasBaseline() const;
    [[nodiscard]] const CompensationSetup& baseline() const;
    [[nodiscard]] const EditedSetup& edited() const;

    /// What the drive now has. Fields that are not changed follow it; changed ones keep the user's
    /// value.
    void setBaseline(const CompensationSetup& setup);
    /// Another axis: the edited value becomes the drive's, but for the table.
    void reset(const CompensationSetup& setup, TableChoice table = {});
    void clear();

    void setDimensionality(int dimensionality);
    void setSource(int dimension, const DimSource& source); ///< dimension 1, 2, 3
    void setTable(TableChoice table);
    void setPersistency(Persistency persistency);

    /// Sources above the dimensionality do not count as changed.
    [[nodiscard]] bool isDirty(Field field) const;
    [[nodiscard]] bool isDirty() const;
    void revert(Field field);
    void revert();

Q_SIGNALS:
    /// A value of the field, or whether it is changed, is different now.
    void fieldChanged(axiscomp::ui::Field field);

private:
    template <typename Change> void apply(const Change& change);

    std::optional<CompensationSetup> m_baseline;
    EditedSetup m_edited;
};

} // namespace axiscomp::ui
