// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/rejected_certificate.h"

#include <QDialog>

#include <filesystem>

class QFormLayout;
class QLabel;
class QPushButton;

namespace axiscomp::ui {

class ToneLabel;

/// Asks whether the certificate of a drive shall be trusted, and remembers a yes for that drive.
/// Whoever only presses Enter or Escape does not trust it.
class CertificateDialog : public QDialog {
    Q_OBJECT

public:
    /// storeRoot: of TrustedCertificates.
    CertificateDialog(RejectedCertificate certificate, std::filesystem::path storeRoot,
        QWidget* parent = nullptr);

Q_SIGNALS:
    /// It is remembered.
    void trusted(const QString& endpoint);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    QLabel* addRow(QFormLayout& form, const char* name, const QString& value);
    void retranslate();
    void trust();

    RejectedCertificate m_certificate;
    std::filesystem::path m_storeRoot;
    QLabel* m_introduction;
    QList<QLabel*> m_names;
    QLabel* m_validity = nullptr;
    ToneLabel* m_note;
    QPushButton* m_refuse;
    QPushButton* m_trust;
};

} // namespace axiscomp::ui
