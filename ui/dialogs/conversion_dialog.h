// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/conversion_form.h"

#include <QDialog>

class QDialogButtonBox;
class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace axiscomp::ui {

class BusyMark;
class ToneLabel;

/// The fields of a conversion, and below them what comes out of it, or why it cannot be done. What
/// is computed is computed in the background; the newest choice wins.
class ConversionDialog : public QDialog {
    Q_OBJECT

public:
    ~ConversionDialog() override;

protected:
    ConversionDialog(ConversionForm::Purpose purpose, QWidget* parent);

    /// The words of the dialog itself.
    struct Words {
        QString title;
        QString introduction;
        QString accept; ///< of the button, with its key
        QString acceptMeaning;
    };
    [[nodiscard]] virtual Words words() const = 0;
    /// Begins to compute with form().choices(); showReport or showReason follows.
    virtual void compute() = 0;

    [[nodiscard]] ConversionForm& form() { return *m_form; }
    /// Of a conversion that can be done. This and showReason() do nothing once the choices have a
    /// problem of their own.
    void showReport(const std::vector<Text>& lines);
    /// Why it cannot be done, a translated sentence.
    void showReason(const QString& reason);
    /// To be called when everything has been built, and for another language.
    void retranslate();
    void startComputing();
    void changeEvent(QEvent* event) override;

private:
    void build();
    void takeChange();
    void showState();

    ConversionForm* m_form;
    QLabel* m_introduction;
    QLabel* m_reportTitle;
    QPlainTextEdit* m_report;
    BusyMark* m_busy;
    ToneLabel* m_reason;
    QDialogButtonBox* m_buttons;
    QPushButton* m_accept;
    QPushButton* m_cancel;
    std::vector<Text> m_lines;
    QString m_reasonText;
    bool m_isComputing = false;
};

} // namespace axiscomp::ui
