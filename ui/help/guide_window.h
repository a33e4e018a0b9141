// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/help/guide_places.h"

#include <QDialog>

class QTextBlock;
class QTextBrowser;

namespace axiscomp::ui {

/// The user guide beside the page. It is part of the program: no network, no file is needed.
class GuideWindow : public QDialog {
    Q_OBJECT

public:
    explicit GuideWindow(QWidget* parent = nullptr);

    void showPlace(const GuidePlace& place);
    /// The text of the block at the upper edge.
    [[nodiscard]] QString textAtTop() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void follow(const QUrl& link);
    void scrollTo(const QTextBlock& block);

    QTextBrowser* m_text;
};

} // namespace axiscomp::ui
