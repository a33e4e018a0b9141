// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/metrology/judge/corrections.h"

#include <QDialog>

#include <array>
#include <optional>

class QCheckBox;
class QGroupBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace axiscomp::ui {

class ToneLabel;

/// Corrections of a measurement before it is judged. None is made without being asked for: what a
/// file says is proposed, and a coefficient is never assumed.
class CorrectionsDialog : public QDialog {
    Q_OBJECT

public:
    /// measurement: as it was read.
    CorrectionsDialog(const Measurement& measurement, const CorrectionsBefore& corrections,
        QWidget* parent = nullptr);

    /// The file with the dead path, as axiscomp judge --dead-path takes it. Read on another thread.
    void readDeadPath(const QString& path);

Q_SIGNALS:
    void deadPathRequested(); ///< the user wants to choose its file
    void chosen(const axiscomp::CorrectionsBefore& corrections);

protected:
    void changeEvent(QEvent* event) override; ///< language

private:
    enum Number { Material, Expansion, Reference, ReferenceExpansion, Datum, NumberCount };

    void build();
    [[nodiscard]] QWidget* buildDeadPath();
    void show(const CorrectionsBefore& corrections);
    void retranslate();
    void takeDeadPath(const Result<DeadPathCorrection>& read);
    void showDeadPath();
    void finish();
    /// What is wrong; empty: the corrections are those of the fields.
    [[nodiscard]] QString readInto(CorrectionsBefore& corrections) const;
    void say(const QString& problem);
    /// Nothing: the field is empty. isWrong: becomes true where it holds no number.
    [[nodiscard]] std::optional<double> numberOf(Number number, bool& isWrong) const;

    Measurement m_probe; ///< what the measurement says of itself, without a value
    std::optional<DeadPathCorrection> m_deadPath;
    QGroupBox* m_temperature;
    std::array<QLabel*, NumberCount> m_labels{};
    std::array<QLineEdit*, NumberCount> m_numbers{};
    QPushButton* m_steel;
    QCheckBox* m_isConfirmed;
    QGroupBox* m_deadPathBox;
    QLabel* m_deadPathText;
    QPushButton* m_openDeadPath;
    QPushButton* m_removeDeadPath;
    ToneLabel* m_problem;
    QPushButton* m_accept;
    QPushButton* m_reject;
};

} // namespace axiscomp::ui
