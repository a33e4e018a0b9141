// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/contrast.h"

#include <QWidget>

#include <array>
#include <utility>

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace axiscomp::ui {

class CapturedPlot;
class CaptureFeed;
class NextStep;
class PlanStepsModel;
class ToneLabel;
struct CaptureView;

/// A capture as it goes: where axis and instrument are, in digits that are read from across the
/// machine, which step is due, what the axis does, and what was taken.
class CapturePanel : public QWidget {
    Q_OBJECT

public:
    /// feed must outlive the panel.
    explicit CapturePanel(CaptureFeed& feed, QWidget* parent = nullptr);

    void retranslate();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    enum Digits { Encoder, Reference, Difference, DigitsCount };

    void build();
    [[nodiscard]] QWidget* buildDigits();
    [[nodiscard]] QHBoxLayout* buildTyped();
    [[nodiscard]] QHBoxLayout* buildButtons();
    void follow();
    void showDigits();
    void showSteps();
    void revealDue();
    void showButtons();
    void showNotes();
    void followQuestion();
    [[nodiscard]] std::pair<Tone, QString> state() const;
    [[nodiscard]] std::pair<Tone, QString> runningState() const;
    [[nodiscard]] std::pair<Tone, QString> endState() const;
    [[nodiscard]] QString dueText() const;
    [[nodiscard]] QString obstacle() const;
    [[nodiscard]] bool canTake() const;
    void take();
    void pauseOrResume();

    CaptureFeed& m_feed;
    PlanStepsModel* m_model;
    QLabel* m_title;
    std::array<QLabel*, DigitsCount> m_names{};
    std::array<QLabel*, DigitsCount> m_digits{};
    NextStep* m_state;
    ToneLabel* m_notes;
    QWidget* m_typedRow;
    QLabel* m_typedLabel;
    QLineEdit* m_typed;
    QPushButton* m_take;
    QPushButton* m_undo;
    QPushButton* m_pause;
    QPushButton* m_stop;
    QTableView* m_steps;
    CapturedPlot* m_plot;
    std::size_t m_shownValues = 0;
    bool m_wasAsked = false;
    bool m_wasDoubted = false;
};

} // namespace axiscomp::ui
