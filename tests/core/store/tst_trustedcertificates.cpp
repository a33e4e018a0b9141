// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/trusted_certificates.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <fstream>

namespace tst_trustedcertificates {

using namespace axiscomp;
namespace fs = std::filesystem;

namespace {

std::string fingerprint(char digit)
{
    return sha256Fingerprint(std::string(64, digit)).value_or("");
}

const std::string drive = "https://192.168.1.20";
const std::string otherPort = "https://192.168.1.20:8443";

} // namespace

class TestTrustedCertificates final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWarnings();
        m_folder = std::make_unique<QTemporaryDir>();
        m_root = m_folder->path().toStdString() + "/state";
    }

    void fingerprintsAreReadInAnyForm()
    {
        const std::string plain =
            "0123456789abcdef0123456789ABCDEF0123456789abcdef0123456789abcdef";
        const auto read = sha256Fingerprint(plain);
        QVERIFY(read.has_value());
        QVERIFY(read->starts_with("01:23:45:67:89:AB:CD:EF:01"));
        QCOMPARE(read->size(), std::size_t{95});
        QCOMPARE(sha256Fingerprint(*read), read);
        QCOMPARE(sha256Fingerprint(" " + plain), read);
        QVERIFY(!sha256Fingerprint(plain.substr(1)));
        QVERIFY(!sha256Fingerprint(plain + "0"));
        QVERIFY(!sha256Fingerprint("g" + plain.substr(1)));
        QVERIFY(!sha256Fingerprint(""));
    }

    void oneCertificateIsTrustedForOneEndpoint()
    {
        TrustedCertificates certificates(m_root);
        QVERIFY(certificates.all().empty());
        QVERIFY(!fs::exists(m_root)); // reading makes nothing
        QCOMPARE(certificates.check(drive, fingerprint('a')), CertificateTrust::Unknown);
        VERIFY_RESULT(certificates.trust(drive, std::string(64, 'a')));
        QCOMPARE(certificates.check(drive, fingerprint('a')), CertificateTrust::Trusted);
        QCOMPARE(certificates.check(drive, fingerprint('b')), CertificateTrust::Changed);
        QCOMPARE(certificates.check(otherPort, fingerprint('a')), CertificateTrust::Unknown);
        const TrustedCertificates anotherProgram(m_root);
        QCOMPARE(anotherProgram.fingerprintOf(drive), std::optional(fingerprint('a')));
    }

    void aNewOneTakesThePlaceOfTheOld()
    {
        TrustedCertificates certificates(m_root);
        VERIFY_RESULT(certificates.trust(drive, fingerprint('a')));
        VERIFY_RESULT(certificates.trust(otherPort, fingerprint('c')));
        VERIFY_RESULT(certificates.trust(drive, fingerprint('b')));
        QCOMPARE(certificates.all(),
            (std::vector<TrustedCertificates::Entry>{
                {drive, fingerprint('b')}, {otherPort, fingerprint('c')}}));
    }

    void whatIsForgottenIsUnknown()
    {
        TrustedCertificates certificates(m_root);
        VERIFY_RESULT(certificates.forget(drive));
        VERIFY_RESULT(certificates.trust(drive, fingerprint('a')));
        VERIFY_RESULT(certificates.forget(drive));
        QCOMPARE(certificates.check(drive, fingerprint('b')), CertificateTrust::Unknown);
    }

    void noFingerprintIsNotKept()
    {
        TrustedCertificates certificates(m_root);
        VERIFY_ERROR(certificates.trust(drive, "abc"), ErrorCode::InvalidArgument);
        QVERIFY(!fs::exists(m_root));
    }

    void aBrokenFileTrustsNobody_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("no JSON") << QByteArray("{");
        const auto json = [](QByteArray text) { return text.replace('\'', '"'); };
        QTest::newRow("another format") << json("{'format': 'x', 'version': 1}");
        QTest::newRow("a short fingerprint")
            << json("{'format': 'axiscomp-certificates', 'version': 1, 'certificates': "
                    "[{'endpoint': 'https://192.168.1.20', 'sha256': 'AA'}]}");
        QTest::newRow("deep") << QByteArray(1000, '[');
        QTest::newRow("too large") << QByteArray(1024 * 1024 + 1, ' ');
    }
    void aBrokenFileTrustsNobody()
    {
        QFETCH(QByteArray, text);
        fs::create_directories(m_root);
        const fs::path file = m_root / "certificates.json";
        std::ofstream(file, std::ios::binary) << text.toStdString();
        TrustedCertificates certificates(m_root); // as older versions left it
        QCOMPARE(certificates.check(drive, fingerprint('a')), CertificateTrust::Unknown);
        VERIFY_RESULT(certificates.trust(drive, fingerprint('a')));
        QCOMPARE(certificates.check(drive, fingerprint('a')), CertificateTrust::Trusted);
        QVERIFY(fs::exists(file.string() + ".broken"));
    }

private:
    fs::path m_root;
    std::unique_ptr<QTemporaryDir> m_folder;
};

AXISCOMP_TEST(TestTrustedCertificates)

} // namespace tst_trustedcertificates

#include "tst_trustedcertificates.moc"
