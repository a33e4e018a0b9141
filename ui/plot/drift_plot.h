// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fine_quantity.h"
#include "core/metrology/judge/judgement.h"

#include <QPalette>
#include <QWidget>

#include <memory>
#include <optional>

class QCPGraph;
class QCustomPlot;
class QLabel;

namespace axiscomp::ui {

/// How far the runs of each direction lie beside each other: their offsets, run by run. Runs are
/// selected by mouse and arrow keys.
class DriftPlot : public QWidget {
    Q_OBJECT

public:
    explicit DriftPlot(QWidget* parent = nullptr);

    /// Null: nothing.
    void setJudgement(std::shared_ptr<const Judgement> judgement, bool isAngular);
    /// A run; does not report it. Others and none: nothing is selected.
    void select(const std::optional<Exclusion>& run);
    void retranslate();

Q_SIGNALS:
    /// By mouse or key.
    void selectionChanged(const std::optional<axiscomp::Exclusion>& run);

protected:
    void changeEvent(QEvent* event) override; ///< palette
    bool eventFilter(QObject* watched, QEvent* event) override; ///< keys and mouse of the picture

private:
    void build();
    void colour();
    void choose(const std::optional<Exclusion>& run);
    [[nodiscard]] bool handleKey(int key);
    [[nodiscard]] std::optional<Exclusion> runAt(const QPointF& pixel) const;
    [[nodiscard]] const DirectionDrift& driftOf(Approach direction) const;
    /// Of a run, in mm or deg; nothing: there is no such run.
    [[nodiscard]] std::optional<double> offsetOf(const Exclusion& run) const;
    void showSelected();

    std::shared_ptr<const Judgement> m_judgement;
    bool m_isAngular = false;
    FineUnit m_unit;
    std::optional<Exclusion> m_selected;
    QCustomPlot* m_plot;
    QCPGraph* m_up;
    QCPGraph* m_down;
    QCPGraph* m_mark;
    QLabel* m_readout;
};

} // namespace axiscomp::ui
