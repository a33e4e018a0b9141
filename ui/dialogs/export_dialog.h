// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/table_export.h"
#include "ui/async/background_job.h"
#include "ui/dialogs/conversion_dialog.h"

#include <memory>

namespace axiscomp::ui {

/// As which file of another controller a table is to be written. Writes nothing itself.
class ExportDialog : public ConversionDialog {
    Q_OBJECT

public:
    struct Options {
        std::shared_ptr<const CompensationTable> table;
        QString tableName;
        TableLayout layout;
        AxisPlace place; ///< see ImportChoices
        bool isFitted = false; ///< it was made of a measurement: more likely for the drive
        TableFacts facts;
    };
    explicit ExportDialog(Options options, QWidget* parent = nullptr);

Q_SIGNALS:
    void chosen(const std::shared_ptr<const axiscomp::CompensationTable>& table,
        const axiscomp::ImportChoices& choices);

protected:
    [[nodiscard]] Words words() const override;
    void compute() override;

private:
    [[nodiscard]] ImportChoices choices();

    Options m_options;
    NewestJob<Result<TableExport>> m_job;
};

} // namespace axiscomp::ui
