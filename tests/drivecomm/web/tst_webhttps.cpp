// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/web_server.h"
#include "tests/drivecomm/web/web_link_fixture.h"
#include "tests/support/test_certificate.h"
#include "tests/support/test_registry.h"

#include <QDateTime>
#include <QFile>
#include <QSslCertificate>
#include <QSslConfiguration>
#include <QTest>

namespace tst_webhttps {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;
using namespace std::chrono_literals;

namespace {

struct SecureDrive {
    explicit SecureDrive(const QString& name) : certificate(name)
    {
        WebServerOptions options;
        options.certificateFile = certificate.certificateFile().toStdString();
        options.privateKeyFile = certificate.keyFile().toStdString();
        server = WebServer::start(drive, genericProfile(), faults, options).value();
    }

    static VirtualDriveOptions options()
    {
        VirtualDriveOptions options;
        options.name = "Secure-1";
        return options;
    }

    TestCertificate certificate;
    FaultPlan faults;
    VirtualDrive drive{genericProfile(), options()};
    std::unique_ptr<WebServer> server;
};

/// A link with what somebody has decided about certificates.
std::unique_ptr<DriveLink> linkWith(const std::string& url, CertificateCheck check)
{
    return makeWebDriveLink(parseEndpoint(url).value(), genericProfile(), std::move(check));
}

/// As an administrator would have installed it.
class Trusted {
public:
    explicit Trusted(const TestCertificate& certificate)
    {
        QSslConfiguration changed = m_before;
        changed.addCaCertificates(certificate.certificateFile());
        QSslConfiguration::setDefaultConfiguration(changed);
    }
    ~Trusted() { QSslConfiguration::setDefaultConfiguration(m_before); }

private:
    QSslConfiguration m_before = QSslConfiguration::defaultConfiguration();
};

} // namespace

class WebHttpsTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void talksToADriveWhoseCertificateIsTrusted();
    void rejectsACertificateThatNobodyVouchesFor();
    void rejectsTheCertificateOfAnotherHost();
    void tellsWhatThereIsToDecide();
    void takesTheCertificateThatWasTrusted_data();
    void takesTheCertificateThatWasTrusted();
    void refusesACertificateThatHasChanged_data();
    void refusesACertificateThatHasChanged();
    void saysThatThereIsNoHttps();
    void doesNotTalkHttpToAnHttpsServer();
    void survivesFaults_data();
    void survivesFaults();
};

void WebHttpsTest::talksToADriveWhoseCertificateIsTrusted()
{
    const SecureDrive secure(QStringLiteral("IP:127.0.0.1"));
    QVERIFY(secure.certificate.isValid());
    const Trusted trusted(secure.certificate);
    QVERIFY(secure.server->url().starts_with("https://127.0.0.1:"));
    const auto link = webLinkTo(secure.server->url());
    const auto identity = link->identify({});
    VERIFY_RESULT(identity);
    QCOMPARE(identity->name, std::string("Secure-1"));
    VERIFY_RESULT(link->writeRegisters(oneWrite, {}));
    const Bytes file(2'000'000);
    VERIFY_ERROR(link->upload("tables/large1.TAMtbl", file, {}), ErrorCode::TableRefused);
    VERIFY_RESULT(link->listFiles({}));
}

void WebHttpsTest::rejectsACertificateThatNobodyVouchesFor()
{
    const SecureDrive secure(QStringLiteral("IP:127.0.0.1"));
    const auto identity = webLinkTo(secure.server->url())->identify({});
    VERIFY_ERROR(identity, ErrorCode::CertificateRejected);
    QCOMPARE(identity.error().context.english("endpoint"), secure.server->url());
    const QString reason = QString::fromStdString(identity.error().context.english("reason"));
    QVERIFY2(reason.contains(QStringLiteral("self-signed")), qPrintable(reason));
}

void WebHttpsTest::rejectsTheCertificateOfAnotherHost()
{
    const SecureDrive secure(QStringLiteral("DNS:other.example"));
    const Trusted trusted(secure.certificate);
    const auto identity = webLinkTo(secure.server->url())->identify({});
    VERIFY_ERROR(identity, ErrorCode::CertificateRejected);
    QVERIFY(identity.error().context.english("reason").find("host name") != std::string::npos);
}

void WebHttpsTest::tellsWhatThereIsToDecide()
{
    const SecureDrive secure(QStringLiteral("IP:127.0.0.1"));
    std::string asked;
    const auto link = linkWith(secure.server->url(),
        [&asked](const std::string& endpoint, const std::string& fingerprint) {
            asked = endpoint + " " + fingerprint;
            return CertificateTrust::Unknown;
        });
    const auto identity = link->identify({});
    VERIFY_ERROR(identity, ErrorCode::CertificateRejected);
    const ErrorContext& context = identity.error().context;
    QCOMPARE(asked, secure.server->url() + " " + context.english("fingerprint"));
    QFile file(secure.certificate.certificateFile());
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray digest = QSslCertificate(&file).digest(QCryptographicHash::Sha256).toHex();
    QCOMPARE(
        sha256Fingerprint(digest.toStdString()), std::optional(context.english("fingerprint")));
    QCOMPARE(context.english("subject"), std::string("axiscomp test"));
    QCOMPARE(context.english("issuer"), std::string("axiscomp test"));
    QCOMPARE(context.english("hasChanged"), std::string("no"));
    const QDate today = QDateTime::currentDateTimeUtc().date();
    const auto dayOf = [&](const char* key) {
        return QDate::fromString(QString::fromStdString(context.english(key)), Qt::ISODate);
    };
    QVERIFY(dayOf("validFrom").isValid() && dayOf("validFrom") <= today);
    QVERIFY(dayOf("validUntil") > today);
    const std::string said = sentence(identity.error());
    QVERIFY2(said.find(context.english("fingerprint")) != std::string::npos, said.c_str());
    QVERIFY2(said.find("--trust-certificate") != std::string::npos, said.c_str());
}

void WebHttpsTest::takesTheCertificateThatWasTrusted_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("its own name") << "IP:127.0.0.1";
    QTest::newRow("the name of another host") << "DNS:other.example";
}

void WebHttpsTest::takesTheCertificateThatWasTrusted()
{
    QFETCH(QString, name);
    const SecureDrive secure(name);
    const auto link = linkWith(secure.server->url(),
        [](const std::string&, const std::string&) { return CertificateTrust::Trusted; });
    VERIFY_RESULT(link->identify({}));
    VERIFY_RESULT(link->writeRegisters(oneWrite, {}));
}

void WebHttpsTest::refusesACertificateThatHasChanged_data()
{
    QTest::addColumn<bool>("isVouchedFor");
    QTest::newRow("nobody vouches for it") << false;
    QTest::newRow("an authority vouches for it") << true;
}

void WebHttpsTest::refusesACertificateThatHasChanged()
{
    QFETCH(bool, isVouchedFor);
    const SecureDrive secure(QStringLiteral("IP:127.0.0.1"));
    std::optional<Trusted> trusted;
    if (isVouchedFor)
        trusted.emplace(secure.certificate);
    const auto link = linkWith(secure.server->url(),
        [](const std::string&, const std::string&) { return CertificateTrust::Changed; });
    const auto written = link->writeRegisters(oneWrite, {});
    VERIFY_ERROR(written, ErrorCode::CertificateRejected);
    QCOMPARE(written.error().context.english("hasChanged"), std::string("yes"));
    QVERIFY(written.error().context.english("reason").find("CHANGED") != std::string::npos);
    QVERIFY(!written.error().context.english("fingerprint").empty());
}

void WebHttpsTest::saysThatThereIsNoHttps()
{
    const RawResponder plain([](RawConnection& c) {
        c.send("HTTP/1.1 400 Bad Request\r\nContent-Length: 0\r\n\r\n");
        c.waitUntilGone();
    });
    const auto identity = webLinkTo("https" + plain.url().substr(4))->identify({});
    VERIFY_ERROR(identity, ErrorCode::NotConnected);
    QVERIFY(identity.error().context.english("reason").find("http://") != std::string::npos);
}

void WebHttpsTest::doesNotTalkHttpToAnHttpsServer()
{
    const SecureDrive secure(QStringLiteral("IP:127.0.0.1"));
    const auto identity = webLinkTo("http" + secure.server->url().substr(5))->identify({});
    QVERIFY(!identity.has_value());
    const ErrorCode code = identity.error().code;
    QVERIFY(code == ErrorCode::Protocol || code == ErrorCode::ConnectionLost);
}

void WebHttpsTest::survivesFaults_data()
{
    QTest::addColumn<QString>("fault");
    for (const char* fault : {"no-reply=1", "reboot-after=1", "drop-after=1", "drop-after=300",
             "drop-after=1500", "drop-after=2500"})
        QTest::newRow(fault) << fault;
}

void WebHttpsTest::survivesFaults()
{
    QFETCH(QString, fault);
    SecureDrive secure(QStringLiteral("IP:127.0.0.1"));
    const Trusted trusted(secure.certificate);
    const auto link = webLinkTo(secure.server->url());
    secure.faults.add(parseFault(fault.toStdString()).value());
    const Bytes file(2000);
    const auto first = link->upload("tables/small1.TAMtbl", file, within(2s));
    QVERIFY(!first.has_value());
    QVERIFY(first.error().code != ErrorCode::TableRefused);
    VERIFY_RESULT(link->identify({}));
}

AXISCOMP_TEST(WebHttpsTest)

} // namespace tst_webhttps

#include "tst_webhttps.moc"
