// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace axiscomp::ui {

/// What is typed into a field is taken before anything else uses it: a key of a button moves the
/// focus to it, as a click does; a key of a menu or of the page, a button that takes no focus, a
/// dropped file and the end of the window let the field take it. Installed on the application as an
/// event filter; acts on what is below one widget and in its dialogs.
class TypedFields : public QObject {
    Q_OBJECT

public:
    explicit TypedFields(QWidget& root);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool isUse(const QObject& watched, const QEvent& event) const;

    QWidget& m_root;
};

} // namespace axiscomp::ui
