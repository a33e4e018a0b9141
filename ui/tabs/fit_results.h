// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/fit_outcome.h"

#include <QWidget>

#include <memory>

class QLabel;
class QListWidget;
class QTableWidget;

namespace axiscomp::ui {

class FineScale;

/// What a fit promises: the figures before and foretold, what they rest on, and what is to be known
/// before the table is used, warnings first.
class FitResults : public QWidget {
    Q_OBJECT

public:
    explicit FitResults(QWidget* parent = nullptr);

    /// outcome: with a report; null: nothing is shown. table: which of several.
    void show(std::shared_ptr<const FitOutcome> outcome, std::size_t table);
    /// What is shown is of an earlier fit.
    void setOutdated(bool isOutdated);
    void retranslate();

protected:
    void changeEvent(QEvent* event) override; ///< palette

private:
    struct Row {
        QString name;
        std::optional<double> before;
        std::optional<double> predicted;
        std::optional<double> heldOut;
        bool hasOwnUnits = false; ///< small beside the figures: each value with its unit
    };
    [[nodiscard]] std::vector<Row> rows() const;
    void fill();
    void fillFigures();
    void fillRow(int n, const Row& row, const FineScale& scale);
    void fillRemarks();
    [[nodiscard]] QStringList basis() const;
    void addRemark(const QString& sentence, bool isWarning);

    std::shared_ptr<const FitOutcome> m_outcome;
    std::size_t m_table = 0;
    bool m_isOutdated = false;
    QTableWidget* m_figures;
    QListWidget* m_remarks;
    QLabel* m_sign;
};

/// "largest correction -8.45 µm at X 45.6 mm"
[[nodiscard]] QString largestCorrection(const LoadedTable& table, bool isAngular);

} // namespace axiscomp::ui
