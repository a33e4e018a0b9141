// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/table_plot.h"

#include <QWidget>

#include <array>
#include <optional>

class QLabel;
class QPushButton;
class QStackedWidget;
class QTabWidget;

namespace axiscomp {
struct DriveProfile;
}

namespace axiscomp::ui {

class ControllerCombo;
class FileLinesView;
class ProblemList;
class SliceGallery;
class SurfaceView;
class TableViewModel;
class ToneLabel;
class ValuesView;
class VectorView;
class WizardController;
class WritePreview;

/// The right side of the page: the table as picture, values, surface and, of three dimensions, all
/// of its slices; the errors of two axes as one grid; the problems of the file,
/// and, before a write, the list of what will be written.
class PreviewPanel : public QWidget {
    Q_OBJECT

public:
    /// All references must outlive the panel.
    PreviewPanel(
        WizardController& controller, const DriveProfile& profile, QWidget* parent = nullptr);

    [[nodiscard]] WritePreview& writePreview();
    void showWritePreview(bool isShown);
    [[nodiscard]] bool isWritePreviewShown() const;
    void retranslate();

Q_SIGNALS:
    void saveExampleRequested(int dimensionality);

private:
    void build();
    void addTabShortcuts();
    void connectController();
    void connectProblems();
    void showTables();
    void showApplied();
    void showCompared();
    void showTabs();
    void showTab(QWidget& page, bool isWanted);
    [[nodiscard]] QString titleOf(const QWidget& page) const;
    void showTabTips();
    void showVectors();
    [[nodiscard]] std::optional<std::array<double, 3>> vectorPlace(
        std::array<double, 3> positions) const;
    void showOrigin();
    [[nodiscard]] TablePlot::ValuesOrigin valuesOrigin() const;
    void showFacts();
    void showMarker();
    void showTravel();
    void showProblems();
    void showExample();
    [[nodiscard]] QString sizeText() const;
    [[nodiscard]] QString warningText() const;

    WizardController& m_controller;
    const DriveProfile& m_profile;
    QPushButton* m_example;
    QStackedWidget* m_stack;
    QTabWidget* m_tabs;
    TableViewModel* m_shown;
    TablePlot* m_plot;
    SurfaceView* m_surface;
    SliceGallery* m_slices;
    VectorView* m_vectors;
    ControllerCombo* m_applied;
    QStackedWidget* m_valuesStack; ///< the table's values, or the file's lines
    ValuesView* m_values;
    FileLinesView* m_lines;
    ProblemList* m_problems;
    WritePreview* m_writePreview;
    QWidget* m_notes; ///< about the selected table: the labels below
    QLabel* m_facts;
    QLabel* m_size;
    ToneLabel* m_warnings;
    QLabel* m_sign;
};

} // namespace axiscomp::ui
