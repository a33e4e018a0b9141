// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/certificate_dialog.h"

#include "core/store/trusted_certificates.h"
#include "ui/async/background_job.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/tone_label.h"
#include "ui/text/message_text.h"

#include <QBoxLayout>
#include <QDate>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

namespace axiscomp::ui {

namespace {

QString dayText(const QString& isoDate)
{
    const QDate day = QDate::fromString(isoDate, Qt::ISODate);
    return day.isValid() ? QLocale().toString(day, QLocale::ShortFormat) : isoDate;
}

/// In two lines, to be compared by eye.
QString inTwoLines(const QString& fingerprint)
{
    const qsizetype half = (fingerprint.size() + 1) / 2;
    return fingerprint.left(half) + u'\n' + fingerprint.mid(half);
}

} // namespace

CertificateDialog::CertificateDialog(
    RejectedCertificate certificate, std::filesystem::path storeRoot, QWidget* parent)
    : QDialog(parent)
    , m_certificate(std::move(certificate))
    , m_storeRoot(std::move(storeRoot))
    , m_introduction(new PlainLabel)
    , m_note(new ToneLabel)
    , m_refuse(new QPushButton)
    , m_trust(new QPushButton)
{
    setObjectName(QStringLiteral("certificateDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(m_refuse, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_trust, &QPushButton::clicked, this, &CertificateDialog::trust);
    retranslate();
    m_refuse->setFocus();
}

QLabel* CertificateDialog::addRow(QFormLayout& form, const char* name, const QString& value)
{
    auto* label = new PlainLabel;
    auto* text = new PlainLabel(value);
    text->setObjectName(QLatin1StringView(name));
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text->setFocusPolicy(Qt::ClickFocus);
    form.addRow(label, text);
    m_names.append(label);
    return text;
}

void CertificateDialog::build()
{
    m_introduction->setObjectName(QStringLiteral("certificateIntroduction"));
    m_introduction->setWordWrap(true);
    m_note->setObjectName(QStringLiteral("certificateNote"));
    m_note->setWordWrap(true);
    m_refuse->setObjectName(QStringLiteral("refuseCertificate"));
    m_refuse->setDefault(true);
    m_trust->setObjectName(QStringLiteral("trustCertificate"));
    m_trust->setAutoDefault(false);
    auto* form = new QFormLayout;
    addRow(*form, "certificateEndpoint", m_certificate.endpoint);
    addRow(*form, "certificateSubject", m_certificate.subject);
    addRow(*form, "certificateIssuer", m_certificate.issuer);
    m_validity = addRow(*form, "certificateValidity", {});
    addRow(*form, "certificateFingerprint", inTwoLines(m_certificate.fingerprint))
        ->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    auto* buttons = new QDialogButtonBox;
    buttons->addButton(m_trust, QDialogButtonBox::ActionRole);
    buttons->addButton(m_refuse, QDialogButtonBox::RejectRole);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addWidget(m_introduction);
    layout->addLayout(form);
    layout->addWidget(m_note);
    layout->addWidget(buttons);
    resize(620, sizeHint().height());
}

void CertificateDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void CertificateDialog::retranslate()
{
    setWindowTitle(tr("Drive Certificate"));
    m_introduction->setText(m_certificate.hasChanged
            ? tr("The certificate of this drive has CHANGED since it was trusted. Either the drive "
                 "has a new one, or another device answers at its address.")
            : tr("No authority known to this computer has signed this certificate, so the identity "
                 "of the drive cannot be confirmed."));
    const QStringList names{
        tr("Address"), tr("Issued to"), tr("Issued by"), tr("Valid"), tr("SHA-256 fingerprint")};
    for (qsizetype i = 0; i < names.size(); ++i)
        m_names.at(i)->setText(names.at(i));
    m_validity->setText(
        tr("from %1 until %2")
            .arg(dayText(m_certificate.validFrom), dayText(m_certificate.validUntil)));
    m_note->setText(
        tr("Trust it only if the drive itself, or its administrator, shows the same fingerprint. "
           "From then on this address is accepted with this certificate only."));
    m_refuse->setText(tr("Do &Not Trust"));
    m_refuse->setToolTip(tr("Stay disconnected (Esc)"));
    m_trust->setText(tr("&Trust This Certificate"));
    m_trust->setToolTip(tr("Accept this certificate for this address from now on"));
}

void CertificateDialog::trust()
{
    m_trust->setEnabled(false);
    const auto saved = inBackground<Result<void>>(
        [root = m_storeRoot, endpoint = m_certificate.endpoint.toStdString(),
            fingerprint = m_certificate.fingerprint.toStdString()] {
            return TrustedCertificates(root).trust(endpoint, fingerprint);
        });
    whenDone(saved, this, [this](const Result<void>& result) {
        if (result) {
            Q_EMIT trusted(m_certificate.endpoint);
            accept();
            return;
        }
        m_note->setTone(Tone::Error);
        m_note->setText(errorText(result.error()));
        m_trust->setEnabled(true);
    });
}

} // namespace axiscomp::ui
