// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace axiscomp::ui {

/// What is typed into a field is taken before a key uses it: the key of a button moves the focus to
/// it, as a click does; that of a menu or of the page lets the field take it. Installed on the
/// application as an event filter; acts on what is below one widget and in its dialogs.
class ShortcutKeys : public QObject {
    Q_OBJECT

public:
    explicit ShortcutKeys(QWidget& root);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget& m_root;
};

} // namespace axiscomp::ui
