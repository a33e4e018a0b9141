// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

class QVBoxLayout;

namespace axiscomp::ui {

/// Warnings one below the other in an amber frame, each with its symbol; hidden without any.
class WarningList : public QWidget {
    Q_OBJECT

public:
    explicit WarningList(QWidget* parent = nullptr);

    void setWarnings(const QStringList& warnings);
    [[nodiscard]] const QStringList& warnings() const { return m_warnings; }

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void addWarning(const QString& warning);
    void colour();

    QStringList m_warnings;
    QVBoxLayout* m_layout;
};

} // namespace axiscomp::ui
