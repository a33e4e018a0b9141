// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/wall_time.h"
#include "ui/text/language.h"

#include <QAbstractTableModel>
#include <QString>

#include <vector>

namespace axiscomp::ui {

/// What happened once.
struct LogLine {
    WallTime time;
    enum class Kind { Information, Warning, Error } kind = Kind::Information;
    Wording text;
    QString detail; ///< for experts, in English
};

/// What happened, in order: time, sentence, details. Only the newest lines are kept.
class WizardLog : public QAbstractTableModel {
    Q_OBJECT

public:
    static constexpr std::size_t capacity = 1000;
    enum Column { Time, Text, Detail, ColumnCount };

    void add(LogLine::Kind kind, const Wording& text, const QString& detail = {});
    void add(const Error& error);
    [[nodiscard]] const std::vector<LogLine>& lines() const { return m_lines; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;

    /// The lines as they are kept in a file: UTC time, kind, text, detail.
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString text(const QModelIndexList& rows) const;
    /// Announces the sentences in another language.
    void retranslate();

private:
    std::vector<LogLine> m_lines;
};

} // namespace axiscomp::ui
