// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/rejected_certificate.h"

#include <QHash>
#include <QPushButton>
#include <QStringList>

#include <filesystem>

namespace axiscomp::ui {

/// Decides about the certificate of the chosen connection, or takes a decision back.
class CertificateButton : public QPushButton {
    Q_OBJECT

public:
    /// storeRoot: of TrustedCertificates.
    explicit CertificateButton(std::filesystem::path storeRoot, QWidget* parent = nullptr);

    /// The chosen connection; empty: none.
    void choose(const QString& endpoint);
    void addRejected(const RejectedCertificate& certificate);
    void removeRejected(const QString& endpoint);
    void retranslate();

Q_SIGNALS:
    /// The person trusts the certificate of the chosen connection.
    void trusted();
    void forgotten(const QString& endpoint);
    void failed(const QString& sentence);

private:
    [[nodiscard]] bool isToBeForgotten() const;
    void open();
    void decide(const RejectedCertificate& certificate);
    void forget();

    std::filesystem::path m_storeRoot;
    QHash<QString, RejectedCertificate> m_rejected; ///< by certificateEndpoint()
    QStringList m_trusted; ///< the same
    QString m_endpoint; ///< the same, of the chosen connection
};

} // namespace axiscomp::ui
