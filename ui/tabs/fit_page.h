// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/fit_outcome.h"

#include <QSet>
#include <QWidget>

#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace axiscomp::ui {

class BusyMark;
class FitForm;
class FitPlot;
class FitResults;
class NextStep;
class RecordModel;
class TablePlot;
class TableViewModel;

/// The tab Fit: how a table is made of the measurement, what it is and what it promises.
class FitPage : public QWidget {
    Q_OBJECT

public:
    /// record must outlive the page.
    explicit FitPage(RecordModel& record, QWidget* parent = nullptr);

    void retranslate();
    /// Why no table can be taken over now, a translated sentence; empty: one can.
    void setObstacle(const QString& obstacle);
    /// How things are, for the mark of the tab.
    enum class State { Empty, Ready, Warning };
    [[nodiscard]] State state() const;

Q_SIGNALS:
    /// The table at this index of the outcome is to be used on the tab Write.
    void useRequested(
        const std::shared_ptr<const axiscomp::ui::FitOutcome>& outcome, std::size_t table);
    void saveRequested(
        const std::shared_ptr<const axiscomp::ui::FitOutcome>& outcome, std::size_t table);
    /// The file of a table is wanted. isOnto: to merge onto it; otherwise it was active.
    void fileWanted(bool isOnto);
    void stateChanged();

public:
    /// The answer to fileWanted().
    void takeFile(const QString& path, bool isOnto);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void build();
    [[nodiscard]] QWidget* buildLeft();
    [[nodiscard]] QWidget* buildRight();
    void connectParts();
    void follow();
    void showOutcome();
    void showMap(const std::shared_ptr<const FitOutcome>& outcome);
    void offerColumns();
    void chooseColumn(int index);
    void sayNextStep();
    void offerUse();
    /// The keys of the page around this one.
    [[nodiscard]] QSet<QChar> keysAround() const;
    void nameKeys();
    /// Of the measurement and what is said of it now; null: none, or of an earlier one.
    [[nodiscard]] std::shared_ptr<const FitOutcome> current() const;
    [[nodiscard]] bool isPending() const;
    [[nodiscard]] QString axisDoubt() const;

    RecordModel& m_record;
    FitForm* m_form;
    QLabel* m_columnLabel;
    QComboBox* m_column;
    QPushButton* m_use;
    QPushButton* m_save;
    NextStep* m_nextStep;
    BusyMark* m_busy;
    QLabel* m_title;
    QStackedWidget* m_pictures;
    QWidget* m_nothing; ///< in place of a picture
    FitPlot* m_plot;
    TableViewModel* m_shown = nullptr; ///< of the map, made when it is needed
    TablePlot* m_map = nullptr;
    FitResults* m_results;
    std::shared_ptr<const FitOutcome> m_drawn;
    QString m_obstacle;
    QString m_chosenColumn; ///< by the user
};

} // namespace axiscomp::ui
