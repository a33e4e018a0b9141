// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "tests/support/test_certificate.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QCoreApplication>
#include <QTest>
#include <QUrl>

namespace tst_certificateoption {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;
using test::VirtualDriveProcess;

namespace {

/// A drive with a certificate that vouches for itself.
struct SecureDrive {
    explicit SecureDrive(const QString& address = "127.0.0.1:0")
        : drive(box,
            {"--http", address, "--certificate", certificate.certificateFile(), "--key",
                certificate.keyFile()})
    {
    }
    Sandbox box;
    test::TestCertificate certificate{"IP:127.0.0.1"};
    VirtualDriveProcess drive;
};

/// A loopback address on which no other test listens, so that a port that was given up is free
/// when a second drive takes it over.
QString addressOfItsOwn()
{
    const qint64 process = QCoreApplication::applicationPid();
    return QStringLiteral("127.77.%1.%2:0").arg(process / 250 % 250).arg(process % 250 + 1);
}

QString fingerprintIn(const ProgramRun& run)
{
    return run.json()
        .value("error")
        .toObject()
        .value("context")
        .toObject()
        .value("fingerprint")
        .toString();
}

} // namespace

class tst_CertificateOption : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theErrorNamesTheFingerprintAndTheWayOut()
    {
        const SecureDrive secure;
        const Sandbox box;
        const ProgramRun run = box.run({"axes", "--drive", secure.drive.url(), "--json"});
        VERIFY_CODE(run, 5);
        const QString fingerprint = fingerprintIn(run);
        QCOMPARE(fingerprint.size(), 95);
        QVERIFY2(run.err.startsWith("error: CertificateRejected: "), run.err.constData());
        QVERIFY(run.err.contains(fingerprint.toUtf8()));
        QVERIFY(run.err.contains("--trust-certificate"));
    }

    void whatIsTrustedOnceIsTrustedLater()
    {
        const SecureDrive secure;
        const Sandbox box;
        const QString fingerprint =
            fingerprintIn(box.run({"axes", "--drive", secure.drive.url(), "--json"}));
        const ProgramRun given = box.run({"status", "--axis", "0", "--drive", secure.drive.url(),
            "--trust-certificate", fingerprint});
        VERIFY_CODE(given, 0);
        VERIFY_CODE(box.run({"axes", "--drive", secure.drive.url()}), 0);
        const Sandbox somebodyElse;
        VERIFY_CODE(somebodyElse.run({"axes", "--drive", secure.drive.url()}), 5);
    }

    void anotherFingerprintTrustsNothing()
    {
        const SecureDrive secure;
        const Sandbox box;
        VERIFY_CODE(box.run({"axes", "--drive", secure.drive.url(), "--trust-certificate",
                        QString(64, 'a')}),
            5);
        VERIFY_CODE(box.run({"axes", "--drive", secure.drive.url()}), 5);
    }

    void aChangedCertificateIsRefusedUntilItIsTrusted()
    {
        const Sandbox box;
        QString address;
        {
            const SecureDrive first(addressOfItsOwn());
            address = QUrl(first.drive.url()).authority();
            const QString fingerprint =
                fingerprintIn(box.run({"axes", "--drive", first.drive.url(), "--json"}));
            VERIFY_CODE(
                box.run({"axes", "--drive", first.drive.url(), "--trust-certificate", fingerprint}),
                0);
        }
        const SecureDrive second(address);
        const ProgramRun refused = box.run({"axes", "--drive", second.drive.url(), "--json"});
        VERIFY_CODE(refused, 5);
        QVERIFY2(refused.err.contains("CHANGED"), refused.err.constData());
        VERIFY_CODE(box.run({"axes", "--drive", second.drive.url(), "--trust-certificate",
                        fingerprintIn(refused)}),
            0);
        VERIFY_CODE(box.run({"axes", "--drive", second.drive.url()}), 0);
    }

    void whatIsNoFingerprintIsWrongUsage()
    {
        const Sandbox box;
        const ProgramRun run =
            box.run({"axes", "--drive", "demo:", "--trust-certificate", "AA:BB"});
        VERIFY_CODE(run, 2);
        QVERIFY2(run.err.contains("64 hexadecimal digits"), run.err.constData());
    }
};

AXISCOMP_TEST(tst_CertificateOption)

} // namespace tst_certificateoption

#include "tst_certificateoption.moc"
