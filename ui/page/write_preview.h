// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/table_math.h"
#include "ui/controller/wizard_controller.h"

#include <QWidget>

#include <memory>
#include <optional>

class QCheckBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace axiscomp::ui {

/// The list of what a write will change, shown in the page before it happens: field, on the drive,
/// new; what it costs; what to know about it.
class WritePreview : public QWidget {
    Q_OBJECT

public:
    explicit WritePreview(WizardController& controller, QWidget* parent = nullptr);

    /// Shows the controller's plan.
    void showPlan();
    void retranslate();
    [[nodiscard]] bool isSkippedForVolatile() const;
    void setSkippedForVolatile(bool isSkipped);
    /// Whether the plan may be carried out: what is unusually large in it has been confirmed.
    [[nodiscard]] bool isAccepted() const;

Q_SIGNALS:
    void confirmed();
    void backRequested();
    void skipForVolatileChanged(bool isSkipped);

private:
    void build();
    void fillRows(const WritePlan& plan);
    void fillDeletion(const WritePlan& plan);
    void addRow(const QString& field, const QString& before, const QString& after);
    [[nodiscard]] std::shared_ptr<const CompensationTable> newTable() const;
    void askForLargestChange();
    void showLargestChange(const LargestChange& change);
    void showAcceptance();
    [[nodiscard]] QString costText(const WritePlan& plan) const;
    [[nodiscard]] QStringList remarks(const WritePlan& plan) const;
    [[nodiscard]] QString sourceText(const DimSource& source) const;
    [[nodiscard]] QString tableText(const std::string& slot, const CompensationTable* table) const;

    WizardController& m_controller;
    QLabel* m_title;
    QLabel* m_introduction;
    QTableWidget* m_rows;
    QLabel* m_cost;
    QLabel* m_remarks;
    QCheckBox* m_accept;
    QCheckBox* m_skip;
    QPushButton* m_write;
    QPushButton* m_back;
    int m_request = 0; ///< the newest question for the largest change
    std::shared_ptr<const CompensationTable> m_restored; ///< of a plan that goes back
    std::shared_ptr<const CompensationTable> m_newTable; ///< that it is about
    std::shared_ptr<const CompensationTable> m_oldTable;
    std::optional<LargestChange> m_change; ///< between these two
};

} // namespace axiscomp::ui
