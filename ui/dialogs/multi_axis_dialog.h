// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/several_writes_dialog.h"

class QComboBox;

namespace axiscomp::ui {

class ColumnMappingTable;

/// Columns of the open file for several axes of the current drive: what is for which.
class MultiAxisDialog : public SeveralWritesDialog {
    Q_OBJECT

public:
    /// The controller has an open file and an axis.
    explicit MultiAxisDialog(WizardController& controller, QWidget* parent = nullptr);

protected:
    [[nodiscard]] QString obstacle() const override;
    [[nodiscard]] bool ask() override;
    void setChoosable(bool isChoosable) override;
    void retranslateChoices() override;

private:
    void build();
    void fillSources();
    [[nodiscard]] QString sourcesText(SourcesForSeveral sources) const;
    [[nodiscard]] SourcesForSeveral sources() const;
    [[nodiscard]] std::vector<ColumnForAxis> chosen() const;

    ColumnMappingTable* m_columns;
    QLabel* m_sourcesLabel;
    QComboBox* m_sources;
    QLabel* m_persistency;
};

} // namespace axiscomp::ui
