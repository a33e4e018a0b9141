// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/record.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace axiscomp::ui {

/// How a file is read, where its content leaves that open.
class FileChoices : public QWidget {
    Q_OBJECT

public:
    explicit FileChoices(QWidget* parent = nullptr);

    void show(const MeasurementChoices& choices);
    void retranslate();

Q_SIGNALS:
    void chosen(const axiscomp::ui::MeasurementChoices& choices);

private:
    void build();
    void addRow(QLabel*& label, QWidget* field, const char* name);
    void report();

    MeasurementChoices m_shown; ///< columns are chosen elsewhere
    QFormLayout* m_form;
    QComboBox* m_format;
    QComboBox* m_values;
    QComboBox* m_unit;
    QComboBox* m_valueUnit;
    QSpinBox* m_skippedLines;
    QCheckBox* m_fromOrder;
    QCheckBox* m_invert;
    QLabel* m_formatLabel = nullptr;
    QLabel* m_valuesLabel = nullptr;
    QLabel* m_unitLabel = nullptr;
    QLabel* m_valueUnitLabel = nullptr;
    QLabel* m_skippedLinesLabel = nullptr;
};

} // namespace axiscomp::ui
