// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/certificate_button.h"

#include "core/store/trusted_certificates.h"
#include "ui/async/background_job.h"
#include "ui/dialogs/certificate_dialog.h"
#include "ui/style/symbols.h"
#include "ui/text/message_text.h"

namespace axiscomp::ui {

CertificateButton::CertificateButton(std::filesystem::path storeRoot, QWidget* parent)
    : QPushButton(parent)
    , m_storeRoot(std::move(storeRoot))
{
    setObjectName(QStringLiteral("connectionCertificate"));
    setIcon(symbolIcon(Symbol::Information));
    setAutoDefault(false);
    for (const auto& entry : TrustedCertificates(m_storeRoot).all())
        m_trusted += QString::fromStdString(entry.endpoint);
    connect(this, &QPushButton::clicked, this, &CertificateButton::open);
    retranslate();
}

void CertificateButton::choose(const QString& endpoint)
{
    m_endpoint = certificateEndpoint(endpoint);
    retranslate();
}

void CertificateButton::addRejected(const RejectedCertificate& certificate)
{
    m_rejected.insert(certificate.endpoint, certificate);
    retranslate();
}

void CertificateButton::removeRejected(const QString& endpoint)
{
    m_rejected.remove(certificateEndpoint(endpoint));
    retranslate();
}

bool CertificateButton::isToBeForgotten() const
{
    return m_trusted.contains(m_endpoint) && !m_rejected.contains(m_endpoint);
}

void CertificateButton::retranslate()
{
    setEnabled(m_rejected.contains(m_endpoint) || m_trusted.contains(m_endpoint));
    setText(isToBeForgotten() ? tr("Forget Cert&ificate") : tr("Cert&ificate …"));
    setToolTip(isToBeForgotten()
            ? tr("Stop trusting the certificate of the selected drive")
            : tr("Show the certificate of the selected drive and decide whether to trust it"));
}

void CertificateButton::open()
{
    const auto rejected = m_rejected.constFind(m_endpoint);
    if (rejected != m_rejected.cend())
        decide(*rejected);
    else
        forget();
}

void CertificateButton::decide(const RejectedCertificate& certificate)
{
    auto* dialog = new CertificateDialog(certificate, m_storeRoot, window());
    connect(dialog, &CertificateDialog::trusted, this, [this](const QString& endpoint) {
        m_rejected.remove(endpoint);
        m_trusted += endpoint;
        retranslate();
        Q_EMIT trusted();
    });
    dialog->open();
}

void CertificateButton::forget()
{
    const auto done =
        inBackground<Result<void>>([root = m_storeRoot, place = m_endpoint.toStdString()] {
            return TrustedCertificates(root).forget(place);
        });
    whenDone(done, this, [this, endpoint = m_endpoint](const Result<void>& result) {
        if (!result) {
            Q_EMIT failed(errorText(result.error()));
            return;
        }
        m_trusted.removeAll(endpoint);
        retranslate();
        Q_EMIT forgotten(endpoint);
    });
}

} // namespace axiscomp::ui
