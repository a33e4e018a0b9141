// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grid.h"

#include <QWidget>

#include <array>
#include <memory>
#include <optional>

namespace axiscomp::ui {

/// Which values the plot shows.
enum class PlotContent {
    Selected, ///< the selected table, the drive's as a muted second curve (1D)
    Drive, ///< the table now on the drive
    Difference, ///< selected - drive, on the selected table's points
};

/// The picture of a compensation table: a curve in 1D, a colour map in 2D (diverging scale,
/// symmetric about zero), slices with a slider in 3D. Zoom by wheel and rubber band, pan by drag,
/// two cursors with their differences, export. Everything by keyboard too.
class TablePlot : public QWidget {
    Q_OBJECT

public:
    explicit TablePlot(QWidget* parent = nullptr);
    ~TablePlot() override;

    /// Null: none. The tables are kept as long as they are shown.
    void setTables(std::shared_ptr<const CompensationTable> selected,
        std::shared_ptr<const CompensationTable> onDrive);
    void setContent(PlotContent content);
    [[nodiscard]] PlotContent content() const;
    [[nodiscard]] bool canShow(PlotContent content) const;

    /// Where the axis is now, in the table's positions, and the drive's output there; none hides
    /// it.
    struct Marker {
        std::array<double, 3> positions{};
        double output = 0.0;
    };
    void setMarker(const std::optional<Marker>& marker);

    /// 3D: which dimension is cut (1, 2, 3) and at which index.
    void setSlice(int dimension, int index);
    [[nodiscard]] int sliceDimension() const;
    [[nodiscard]] int sliceIndex() const;

    /// format by the file's ending: png, pdf, csv (the values shown). An empty text is success,
    /// otherwise a translated sentence.
    [[nodiscard]] QString exportTo(const QString& path) const;

    /// "5 x 4 points, X 0 .. 40 step 10, ...; min, max, rms": for the text beside the plot and for
    /// screen readers.
    [[nodiscard]] QString description() const;

protected:
    void changeEvent(QEvent* event) override; ///< palette and language
    bool eventFilter(QObject* watched, QEvent* event) override; ///< keys and mouse of the picture

private:
    void build();
    void connectTools();
    void retranslate();
    void showTables();
    void showSlice();
    void showMarker();
    void showReadout();
    void moveCursor(int stepI, int stepJ);
    void placeCursor(const QPointF& pixel);
    void setCursorsShown(bool isShown);
    void toggleCursor();
    [[nodiscard]] bool handleKey(int key, Qt::KeyboardModifiers modifiers);
    [[nodiscard]] QString pointText(
        const CompensationTable& table, std::size_t i, std::size_t j) const;
    void askForExport();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::ui
