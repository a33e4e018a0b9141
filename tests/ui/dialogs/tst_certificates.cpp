// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/trusted_certificates.h"
#include "drivecomm/link_factory.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/web/web_server.h"
#include "tests/support/compensator_fixture.h"
#include "tests/support/test_certificate.h"
#include "tests/support/verify.h"
#include "tests/ui/support/page_user.h"
#include "tests/ui/support/window_test.h"
#include "ui/compensation_wizard.h"
#include "ui/page/message_stack.h"
#include "ui/session/rejected_certificate.h"

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTreeWidget>

namespace tst_certificates {

using namespace axiscomp;
using namespace axiscomp::ui;

namespace {

/// The wizard on a drive whose certificate vouches for itself.
struct SecurePage {
    SecurePage() { serve(first); }

    void serve(const test::TestCertificate& certificate)
    {
        server.reset();
        drivecomm::WebServerOptions options;
        options.port = port;
        options.certificateFile = certificate.certificateFile().toStdString();
        options.privateKeyFile = certificate.keyFile().toStdString();
        server = drivecomm::WebServer::start(drive, drivecomm::genericProfile(), faults, options)
                     .value();
        port = server->port();
    }
    void show()
    {
        WizardOptions options;
        options.profile = &drivecomm::genericProfile();
        options.storeRoot = root;
        options.timeout = std::chrono::seconds(10);
        options.reconnectInterval = std::chrono::milliseconds(100);
        options.linkFactory = drivecomm::linkFactory(drivecomm::genericProfile(),
            [certificates = std::make_shared<TrustedCertificates>(root)](
                const std::string& endpoint, const std::string& fingerprint) {
                return certificates->check(endpoint, fingerprint);
            });
        wizard = std::make_unique<CompensationWizard>(options, &settings);
        wizard->controller().setEndpoints({url()});
        wizard->show();
    }
    [[nodiscard]] QString url() const { return QString::fromStdString(server->url()); }
    [[nodiscard]] bool isConnected() const
    {
        return wizard->controller().drives().front().connection
            == DriveState::Connection::Connected;
    }
    template <typename T> [[nodiscard]] T* find(const char* name) const
    {
        T* found = nullptr;
        (void)QTest::qWaitFor(
            [&] {
                found = wizard->findChild<T*>(QLatin1StringView(name));
                return found && found->isVisible();
            },
            test::patienceMs);
        return found;
    }
    [[nodiscard]] QDialog* openCertificate() const
    {
        auto* look = find<QPushButton>("lookAtCertificateButton");
        if (!look)
            return nullptr;
        look->click();
        return find<QDialog>("certificateDialog");
    }
    [[nodiscard]] bool isClosed(const char* dialog) const
    {
        return QTest::qWaitFor(
            [&] { return !wizard->findChild<QDialog*>(QLatin1StringView(dialog)); },
            test::patienceMs);
    }
    [[nodiscard]] QString text(const char* label) const
    {
        const auto* found = wizard->findChild<QLabel*>(QLatin1StringView(label));
        return found ? found->text() : QString();
    }

    static drivecomm::VirtualDriveOptions driveOptions()
    {
        drivecomm::VirtualDriveOptions options;
        options.name = "Secure-1";
        options.axes = {{.name = "X"}};
        return options;
    }

    test::TestCertificate first{QStringLiteral("IP:127.0.0.1")};
    test::TestCertificate second{QStringLiteral("IP:127.0.0.1")};
    QTemporaryDir folder;
    std::filesystem::path root = folder.path().toStdString() + "/store";
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    drivecomm::FaultPlan faults;
    drivecomm::VirtualDrive drive{drivecomm::genericProfile(), driveOptions()};
    std::uint16_t port = 0;
    std::unique_ptr<drivecomm::WebServer> server;
    std::unique_ptr<CompensationWizard> wizard;
};

} // namespace

class TestCertificates final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void whoPressesEnterDoesNotTrust_data()
    {
        QTest::addColumn<int>("key");
        QTest::newRow("Enter") << int(Qt::Key_Return);
        QTest::newRow("Escape") << int(Qt::Key_Escape);
    }
    void whoPressesEnterDoesNotTrust()
    {
        QFETCH(int, key);
        SecurePage page;
        page.show();
        QDialog* dialog = page.openCertificate();
        QVERIFY(dialog);
        QTest::keyClick(dialog, static_cast<Qt::Key>(key));
        QVERIFY(page.isClosed("certificateDialog"));
        QVERIFY(!page.isConnected());
        QVERIFY(TrustedCertificates(page.root).all().empty());
        QVERIFY(page.find<QPushButton>("lookAtCertificateButton")); // it can be looked at again
    }

    void theDialogShowsWhatThereIsToDecide()
    {
        SecurePage page;
        page.show();
        QVERIFY(page.openCertificate());
        QCOMPARE(page.text("certificateEndpoint"), page.url());
        QCOMPARE(page.text("certificateSubject"), QStringLiteral("axiscomp test"));
        QCOMPARE(page.text("certificateIssuer"), QStringLiteral("axiscomp test"));
        QVERIFY(!page.text("certificateValidity").isEmpty());
        QString fingerprint = page.text("certificateFingerprint");
        fingerprint.remove(u'\n');
        QVERIFY(sha256Fingerprint(fingerprint.toStdString()).has_value());
        QVERIFY(!page.text("certificateIntroduction").contains(QStringLiteral("CHANGED")));
    }

    void whatIsTrustedConnectsAndAnotherOneIsRefused()
    {
        SecurePage page;
        page.show();
        QVERIFY(page.openCertificate());
        QString shown = page.text("certificateFingerprint");
        page.find<QPushButton>("trustCertificate")->click();
        QVERIFY(page.isClosed("certificateDialog"));
        QTRY_VERIFY(page.isConnected());
        QCOMPARE(TrustedCertificates(page.root).fingerprintOf(page.url().toStdString()),
            std::optional(shown.remove(u'\n').toStdString()));

        page.serve(page.second);
        page.wizard->controller().refresh();
        QDialog* dialog = page.openCertificate();
        QVERIFY(dialog);
        QVERIFY(!page.isConnected());
        QVERIFY(page.text("certificateIntroduction").contains(QStringLiteral("CHANGED")));
        QVERIFY(
            page.wizard->controller().drives().front().problem.contains(QStringLiteral("CHANGED")));
    }

    void connectionsForgetACertificate()
    {
        SecurePage page;
        page.show();
        auto* open = page.find<QPushButton>("connectionsButton");
        QTRY_VERIFY(page.wizard->controller().drives().front().certificate.has_value());
        open->click();
        auto* connections = page.find<QDialog>("connectionsDialog");
        QVERIFY(connections);
        auto* button = page.find<QPushButton>("connectionCertificate");
        QTRY_VERIFY(button->isEnabled());
        button->click();
        page.find<QPushButton>("trustCertificate")->click();
        QVERIFY(page.isClosed("certificateDialog"));
        QTRY_VERIFY(page.isConnected());
        QTRY_COMPARE(button->text(), QStringLiteral("Forget Cert&ificate"));
        button->click();
        QTRY_VERIFY(TrustedCertificates(page.root).all().empty());
        QTRY_VERIFY(!button->isEnabled());
    }

    void endpointsAreComparedAsTheLinkSaysThem_data()
    {
        QTest::addColumn<QString>("given");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* given, const char* expected) {
            QTest::newRow(given) << QString::fromLatin1(given) << QString::fromLatin1(expected);
        };
        row("https://host", "https://host");
        row(" https://host/ ", "https://host");
        row("https://HOST:443", "https://host");
        row("https://me:secret@host:8443", "https://host:8443");
        row("https://[::1]:8443", "https://[::1]:8443");
        row("http://host", "");
        row("serial:/dev/ttyUSB0", "");
    }
    void endpointsAreComparedAsTheLinkSaysThem()
    {
        QFETCH(QString, given);
        QFETCH(QString, expected);
        QCOMPARE(certificateEndpoint(given), expected);
        if (expected.isEmpty())
            return;
        const auto endpoint = drivecomm::parseEndpoint(given.toStdString());
        VERIFY_RESULT(endpoint);
        QCOMPARE(QString::fromStdString(drivecomm::displayText(*endpoint)), expected);
    }
};

AXISCOMP_WINDOW_TEST(TestCertificates)

} // namespace tst_certificates

#include "tst_certificates.moc"
