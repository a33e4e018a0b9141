// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/table_import.h"
#include "core/table/table_layout.h"
#include "ui/async/background_job.h"
#include "ui/dialogs/conversion_dialog.h"

namespace axiscomp::ui {

/// How a file of compensation data is to be understood. Nothing changes until it is accepted.
class ImportDialog : public ConversionDialog {
    Q_OBJECT

public:
    struct Options {
        QString path;
        int dimensions = 1; ///< of a calibration file
        ImportChoices choices; ///< to begin with
        TableLayout layout;
    };
    explicit ImportDialog(Options options, QWidget* parent = nullptr);

Q_SIGNALS:
    void chosen(const QString& path, const axiscomp::ImportChoices& choices);

protected:
    [[nodiscard]] Words words() const override;
    void compute() override;

private:
    void take(const TableImport& import);
    void showFormat(const TableImport& import);

    Options m_options;
    NewestJob<TableImport> m_job;
    bool m_isFormatShown = false;
};

} // namespace axiscomp::ui
