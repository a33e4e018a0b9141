// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace axiscomp::ui {

/// The key of a button moves the focus to it, as a click does: what is typed into a field is taken
/// before the button uses it. Installed on the application as an event filter; acts on the buttons
/// below one widget and in its dialogs.
class ButtonKeys : public QObject {
    Q_OBJECT

public:
    explicit ButtonKeys(QWidget& root);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget& m_root;
};

} // namespace axiscomp::ui
