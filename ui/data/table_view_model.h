// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"
#include "core/table/table_math.h"
#include "ui/text/value_scale.h"

#include <QObject>

#include <array>
#include <memory>
#include <optional>

namespace axiscomp::ui {

/// Which values are shown.
enum class TableContent {
    Selected, ///< the selected table
    Drive, ///< the table now on the drive
    Difference, ///< selected - drive, on the selected table's points
};

/// A place in the drawn table, as grid indices from 0 (one or two dimensions).
struct GridPoint {
    std::size_t i = 0;
    std::size_t j = 0;
    friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// Up to this, values of the difference of two tables are not different: what float32 rounds.
[[nodiscard]] double differenceNoise(const CompensationTable& one, const CompensationTable& other);

/// What picture and values show together: which table, which slice of it, and the point that is
/// looked at.
class TableViewModel : public QObject {
    Q_OBJECT

public:
    using Table = std::shared_ptr<const CompensationTable>;

    explicit TableViewModel(QObject* parent = nullptr);
    ~TableViewModel() override;

    /// Null: none. The tables are kept as long as they are shown. sources: of the selected table
    /// beside those of the drive's; with other ones there is no place at which the two differ.
    void setTables(Table selected, Table onDrive, TableSources sources = TableSources::Same);
    /// The difference is computed on a thread of its own; changed() follows when it is there.
    void setContent(TableContent content);
    [[nodiscard]] TableContent content() const;
    [[nodiscard]] bool canShow(TableContent content) const;

    /// All dimensions; null without a table.
    [[nodiscard]] const Table& table() const;
    /// What is drawn: the table, or the slice of it that is chosen (3D).
    [[nodiscard]] const Table& drawn() const;
    /// Whether table() is the one on the drive.
    [[nodiscard]] bool showsDriveTable() const;
    /// Whether a slice is the border of, or within, the cell around a place.
    [[nodiscard]] bool isAtSlice(const std::array<double, 3>& place) const;
    /// 1D: the drive's table beside another one over the same source; otherwise null.
    [[nodiscard]] Table second() const;
    /// The largest |value| of table(): half of a scale that is symmetric about zero.
    [[nodiscard]] double scale() const;
    /// How the values of table() are shown.
    [[nodiscard]] const ValueScale& valueScale() const;
    /// What is drawn, for a caption: "X error, difference [µm], Z 20 mm".
    [[nodiscard]] QString title() const;
    /// "5 x 4 points, X 0 .. 40, Y 0 .. 30, step 10 / 10; min, max, rms"
    [[nodiscard]] QString description() const;

    /// 3D: which dimension is cut (1, 2, 3) and at which index, held at the ends.
    void setSlice(int dimension, int index);
    [[nodiscard]] bool isCut() const;
    [[nodiscard]] int sliceDimension() const;
    [[nodiscard]] int sliceIndex() const;
    /// The table's dimension, from 0, behind the drawn axis 0 or 1.
    [[nodiscard]] std::size_t dimensionOf(std::size_t drawnAxis) const;
    [[nodiscard]] QString nameOf(std::size_t drawnAxis) const;

    /// The value at a point of drawn(), as the table has it.
    [[nodiscard]] float valueAt(const GridPoint& point) const;
    /// "X 10 mm, Y 20 mm, +2.1 µm"
    [[nodiscard]] QString pointText(const GridPoint& point) const;
    /// Outside the drawn table, or nothing: none.
    void setCurrent(const std::optional<GridPoint>& point);
    [[nodiscard]] const std::optional<GridPoint>& current() const;

Q_SIGNALS:
    void changed(); ///< drawn(), content(), slice, or what canShow() says
    void currentChanged();

private:
    [[nodiscard]] bool isComparable() const;
    void update();
    void computeDifference();
    void show(Table table);
    void cut();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::ui
