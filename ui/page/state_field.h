// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "ui/style/contrast.h"

#include <QDateTime>
#include <QWidget>

#include <optional>

class QLabel;

namespace axiscomp::ui {

class WizardController;

/// What the compensation of the axis does now, in a word that can be read from across the machine,
/// with since when, by which table and what it adds. What is no longer live is greyed and says when
/// it was read.
class StateField : public QWidget {
    Q_OBJECT

public:
    explicit StateField(WizardController& controller, QWidget* parent = nullptr);
    void retranslate();

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void takeAxis();
    void takeLive();
    void display();
    void showFont();
    [[nodiscard]] QString sinceText() const;
    [[nodiscard]] QString tableText() const;
    [[nodiscard]] QString proofText() const;
    [[nodiscard]] QString detailText() const;

    WizardController& m_controller;
    QLabel* m_state;
    QLabel* m_live;
    QLabel* m_detail;
    Tone m_tone = Tone::Information;
    std::optional<CompensationState> m_known; ///< as last seen
    QDateTime m_since;
    bool m_wasSeenToBegin = false; ///< since then, not only at least since then
    QDateTime m_read; ///< when the live values were
};

} // namespace axiscomp::ui
