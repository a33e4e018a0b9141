// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/calibration_csv.h"
#include "ui/drawing/picture_file.h"

#include <QWidget>

#include <array>
#include <memory>
#include <optional>

namespace axiscomp::ui {

class TableViewModel;

/// The errors of two axes in one picture: the grid as it really is, its errors drawn larger than
/// they are, over the grid that the encoders read. For files with the errors of two source axes.
class VectorView : public QWidget {
    Q_OBJECT

public:
    using Data = std::shared_ptr<const CalibrationData>;

    /// shown: of 3D tables the same slice is drawn; it must outlive the view.
    explicit VectorView(TableViewModel& shown, QWidget* parent = nullptr);
    ~VectorView() override;

    /// Whether a file has columns for it.
    [[nodiscard]] static bool canShow(const Data& data);
    /// Null: none.
    void setData(const Data& now);
    /// Where the axes are, one position for each dimension of the file, in its units; none hides
    /// them.
    void setMarker(const std::optional<std::array<double, 3>>& positions);
    void setOrigin(const PictureOrigin& origin);
    /// How many times too large errors are drawn.
    [[nodiscard]] double exaggeration() const;
    /// As TablePlot::exportTo, without values.
    [[nodiscard]] QFuture<QString> exportTo(const QString& path) const;
    void retranslate();

protected:
    void changeEvent(QEvent* event) override; ///< palette and language
    bool eventFilter(QObject* watched, QEvent* event) override; ///< keys and mouse of the picture

private:
    void build();
    void connectTools();
    void chooseColumns();
    void showPlane();
    void showWhole();
    void followLayout();
    void showPalette(const QPalette& palette) const;
    void showTexts();
    [[nodiscard]] bool handleKey(int key);
    void showMenu(const QPoint& place);
    void askForExport();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::ui
