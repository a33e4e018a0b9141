// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/proved_part.h"
#include "core/drive/travel_coverage.h"
#include "ui/drawing/picture_file.h"

#include <QFuture>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>
#include <vector>

class QMouseEvent;

namespace axiscomp::ui {

class TableViewModel;

/// The picture of a compensation table: a curve in 1D, a colour map in 2D (diverging scale,
/// symmetric about zero), slices with a slider in 3D. Zoom by wheel and rectangle, pan by drag, a
/// cross-hair with values, two cursors with their differences, export. Everything by keyboard too.
class TablePlot : public QWidget {
    Q_OBJECT

public:
    /// shown must outlive the plot.
    explicit TablePlot(TableViewModel& shown, QWidget* parent = nullptr);
    ~TablePlot() override;

    /// Puts something that belongs to the picture behind the choice of its values.
    void addTool(QWidget* tool);

    /// Where the axis is now, in the table's positions, and the drive's output there; none hides
    /// it.
    struct Marker {
        std::array<double, 3> positions{};
        double output = 0.0;
    };
    void setMarker(const std::optional<Marker>& marker);
    /// How far the axis travels along each dimension, in the table's positions; none: the drive
    /// does not say. holdsEnds: beyond the table its end values hold.
    void setTravel(const std::array<std::optional<Travel>, 3>& travel, bool holdsEnds);
    /// What has been proved of the table on the drive, which the picture shows only with that
    /// table; null hides it.
    void setProved(const ProvedPart* part);

    /// Where something was measured, over a map or a slice near it: a number for each dimension.
    /// Points that were made up are hatched then.
    void setMeasured(std::vector<std::array<double, 3>> places);
    /// What saved pictures say about where the table is from.
    void setOrigin(const PictureOrigin& origin);
    /// What saved values say besides.
    struct ValuesOrigin {
        bool isOfDrive = true; ///< the selected table, not what another controller makes of it
        std::vector<std::string> selected; ///< notes of the selected table
        std::vector<std::string> onDrive;
    };
    void setValuesOrigin(ValuesOrigin origin);
    /// format by the file's ending: png, svg, pdf, csv (the whole table that is shown, if a drive
    /// can take it: no difference, nothing of another controller). An empty text is
    /// success, otherwise a translated sentence. The file is written on another thread.
    [[nodiscard]] QFuture<QString> exportTo(const QString& path) const;

protected:
    void changeEvent(QEvent* event) override; ///< palette and language
    bool eventFilter(QObject* watched, QEvent* event) override; ///< keys and mouse of the picture

private:
    [[nodiscard]] QFuture<QString> exportValues(const QString& path) const;
    void build();
    void addMapActions();
    void connectTools();
    void retranslate();
    void showTable();
    void showMarker();
    void showProved();
    void showMeasured();
    void showTravel();
    [[nodiscard]] bool holdsEnds() const;
    void showCurrent();
    void currentChanged();
    void showReadout();
    void moveCursor(int stepI, int stepJ);
    void setCursorsShown(bool isShown);
    void handleMouse(const QMouseEvent& mouse);
    [[nodiscard]] bool handleKey(int key, Qt::KeyboardModifiers modifiers);
    void askForExport();
    void showMenu(const QPoint& place);

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::ui
