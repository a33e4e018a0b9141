// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"

#include <QObject>
#include <QSet>

class QFormLayout;
class QLabel;
class QWidget;

namespace axiscomp::ui {

/// Rows of a form for the settings of a format, made from what its facts say about them.
class SettingFields : public QObject {
    Q_OBJECT

public:
    /// The rows begin at firstRow. form must outlive this.
    SettingFields(QFormLayout& form, int firstRow, bool isWriting, QObject* parent);

    /// What was given for a setting of the same key stays until the user changes or clears it.
    /// Null: none.
    void setFormat(const TableFormat* format);
    void setValues(const FormatSettings& values);
    /// Those that were given.
    [[nodiscard]] FormatSettings values() const;
    /// Why one of them is none, a translated sentence; empty: they are.
    [[nodiscard]] QString problem() const;
    [[nodiscard]] QList<QWidget*> fields() const;
    /// usedKeys: letters that lead elsewhere already.
    void retranslate(QSet<QChar> usedKeys);

Q_SIGNALS:
    void changed();

private:
    struct Row {
        FormatSetting setting;
        QLabel* label = nullptr; ///< null for a check box
        QWidget* field = nullptr;
        std::string shown; ///< what the field gave before the user changed it
    };
    void addRow(const FormatSetting& setting);
    [[nodiscard]] QWidget* makeField(const FormatSetting& setting);
    [[nodiscard]] std::string valueOf(const Row& row) const;
    void show(const Row& row, const std::string& value);

    QFormLayout& m_form;
    int m_firstRow;
    bool m_isWriting;
    std::vector<Row> m_rows;
    FormatSettings m_given; ///< of all formats so far
};

/// The letter behind the & of a text; null without one.
[[nodiscard]] QChar keyOf(const QString& text);

} // namespace axiscomp::ui
