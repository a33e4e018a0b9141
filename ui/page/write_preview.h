// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/wizard_controller.h"
#include "ui/data/table_change.h"

#include <QWidget>

#include <memory>
#include <optional>

class QCheckBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QTableWidget;

namespace axiscomp::ui {

class ChangePictures;
class WarningList;

/// The list of what a write will change, shown in the page before it happens: field, on the drive,
/// new; the tables as small pictures; what it costs; what to know about it.
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
    using SharedTable = std::shared_ptr<const CompensationTable>;
    struct Change {
        TableChange tables;
        LoadedTable newTable;
    };

    void build();
    void buildScrolled();
    void fillRows(const WritePlan& plan);
    void fillDeletion(const WritePlan& plan);
    void addRow(const QString& field, const QString& before, const QString& after);
    void askForChange(
        const SharedTable& newTable, const SharedTable& oldTable, TableSources sources);
    void showChange(const Change& change);
    void showAcceptance();
    [[nodiscard]] QString costText(const WritePlan& plan) const;
    [[nodiscard]] QStringList remarks(const WritePlan& plan) const;
    [[nodiscard]] static QStringList warnings(const WritePlan& plan);
    [[nodiscard]] QString sourceText(const DimSource& source) const;
    [[nodiscard]] QString tableText(const std::string& slot, const CompensationTable* table) const;

    WizardController& m_controller;
    QLabel* m_title;
    QScrollArea* m_scroll;
    QLabel* m_introduction;
    WarningList* m_warnings;
    QTableWidget* m_rows;
    ChangePictures* m_pictures;
    QLabel* m_sign;
    QLabel* m_cost;
    QLabel* m_remarks;
    QCheckBox* m_accept;
    QCheckBox* m_skip;
    QPushButton* m_write;
    QPushButton* m_back;
    int m_request = 0; ///< the newest question for the change
    SharedTable m_planned; ///< the table of the plan, as the drive takes it
    SharedTable m_newTable; ///< that m_change is about; null: it is taken away
    SharedTable m_oldTable;
    TableSources m_sources = TableSources::Same; ///< likewise
    std::optional<Change> m_change;
};

} // namespace axiscomp::ui
