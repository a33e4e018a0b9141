// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/wall_time.h"
#include "ui/text/language.h"

#include <QObject>
#include <QString>

#include <vector>

namespace axiscomp::ui {

/// What happened once.
struct LogLine {
    int number = 0; ///< of all lines that there have been, from 1
    WallTime time;
    enum class Kind { Information, Warning, Error } kind = Kind::Information;
    Wording text;
    QString detail; ///< for experts, in English
};

/// What happened, in order; only the newest lines are kept.
class WizardLog : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t capacity = 1000;

    void add(LogLine::Kind kind, const Wording& text, const QString& detail = {});
    void add(const Error& error);
    [[nodiscard]] const std::vector<LogLine>& lines() const { return m_lines; }

Q_SIGNALS:
    void added();

private:
    std::vector<LogLine> m_lines;
    int m_count = 0;
};

} // namespace axiscomp::ui
