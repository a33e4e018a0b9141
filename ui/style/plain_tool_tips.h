// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace axiscomp::ui {

/// Shows tool tips that look like markup letter by letter: they may be what a drive or a file says.
/// Installed on the application as an event filter; acts on the widgets below one.
class PlainToolTips : public QObject {
    Q_OBJECT

public:
    explicit PlainToolTips(QWidget& root);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget& m_root;
};

} // namespace axiscomp::ui
