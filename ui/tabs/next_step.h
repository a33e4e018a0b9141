// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/contrast.h"

#include <QWidget>

class QLabel;

namespace axiscomp::ui {

/// The line under the fields of a tab: the one sentence that matters most now, with its symbol.
class NextStep : public QWidget {
    Q_OBJECT

public:
    explicit NextStep(const QString& name, QWidget* parent = nullptr);

    void say(Tone tone, const QString& sentence);

private:
    QLabel* m_symbol;
    QLabel* m_text;
};

} // namespace axiscomp::ui
