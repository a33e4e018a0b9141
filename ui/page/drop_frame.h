// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace axiscomp::ui {

/// Lies over the page while a file is dragged over it, and says that it may be dropped.
class DropFrame : public QWidget {
    Q_OBJECT

public:
    /// Covers its parent while it is shown.
    explicit DropFrame(QWidget* parent);

    void showFor(const QString& fileName);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_fileName;
};

} // namespace axiscomp::ui
