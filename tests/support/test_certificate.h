// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"

#include <QDir>
#include <QProcess>
#include <QString>
#include <QTemporaryDir>

namespace axiscomp::test {

/// A certificate for name that vouches for itself, with its key, as PEM files of a few days.
class TestCertificate {
public:
    /// name as in subjectAltName: "IP:127.0.0.1", "DNS:other.example"
    explicit TestCertificate(const QString& name)
    {
        QProcess openssl;
        openssl.start(QStringLiteral("openssl"),
            {QStringLiteral("req"), QStringLiteral("-x509"), QStringLiteral("-newkey"),
                QStringLiteral("ec"), QStringLiteral("-pkeyopt"),
                QStringLiteral("ec_paramgen_curve:prime256v1"), QStringLiteral("-nodes"),
                QStringLiteral("-days"), QStringLiteral("3"), QStringLiteral("-subj"),
                QStringLiteral("/CN=axiscomp test"), QStringLiteral("-addext"),
                QStringLiteral("subjectAltName=") + name, QStringLiteral("-keyout"), keyFile(),
                QStringLiteral("-out"), certificateFile()});
        m_isValid = openssl.waitForFinished(patienceMs) && openssl.exitCode() == 0;
    }

    [[nodiscard]] bool isValid() const { return m_isValid; }
    [[nodiscard]] QString certificateFile() const
    {
        return m_folder.filePath(QStringLiteral("certificate.pem"));
    }
    [[nodiscard]] QString keyFile() const { return m_folder.filePath(QStringLiteral("key.pem")); }

private:
    QTemporaryDir m_folder;
    bool m_isValid = false;
};

} // namespace axiscomp::test
