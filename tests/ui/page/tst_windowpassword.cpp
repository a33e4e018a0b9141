// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/wizard/wizard_window.h"
#include "drivecomm/link_factory.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/web/web_server.h"
#include "tests/support/verify.h"
#include "tests/ui/support/visible_texts.h"
#include "tests/ui/support/window_test.h"
#include "ui/compensation_wizard.h"

#include <QDialog>
#include <QDirIterator>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

namespace tst_windowpassword {

using namespace axiscomp;
using namespace axiscomp::ui;

namespace {

const QString password = QStringLiteral("Xq9-geheim");

bool tellsIt(const QString& text)
{
    return text.contains(password, Qt::CaseInsensitive)
        || text.contains(QString::fromLatin1(("anna:" + password.toUtf8()).toBase64()));
}

/// Where the password can be seen; empty: nowhere.
QString seenIn(const QWidget& window)
{
    const test::VisibleTexts texts = test::visibleTexts(window);
    for (auto text = texts.cbegin(); text != texts.cend(); ++text)
        if (tellsIt(text.value()))
            return text.key();
    for (const auto* line : window.findChildren<QLineEdit*>())
        if (tellsIt(line->text()) || tellsIt(line->displayText()))
            return line->objectName();
    return {};
}

QString storedIn(const QString& folder)
{
    QDirIterator files(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (!file.open(QIODevice::ReadOnly) || tellsIt(QString::fromLatin1(file.readAll())))
            return file.fileName();
    }
    return {};
}

/// The window and a drive that asks for the password.
struct GuardedPage {
    GuardedPage()
    {
        drivecomm::WebServerOptions web;
        web.user = "anna";
        web.password = password.toStdString();
        server =
            drivecomm::WebServer::start(drive, drivecomm::genericProfile(), faults, web).value();
    }
    [[nodiscard]] WizardOptions options() const
    {
        WizardOptions options;
        options.profile = &drivecomm::genericProfile();
        options.storeRoot = folder.path().toStdString() + "/store";
        options.timeout = std::chrono::seconds(10);
        options.reconnectInterval = std::chrono::milliseconds(100);
        options.linkFactory = drivecomm::linkFactory(drivecomm::genericProfile());
        return options;
    }
    [[nodiscard]] QString url(const QString& user) const
    {
        return QStringLiteral("http://%1:%2@127.0.0.1:%3").arg(user, password).arg(server->port());
    }

    static drivecomm::VirtualDriveOptions driveOptions()
    {
        drivecomm::VirtualDriveOptions options;
        options.name = "Guarded-1";
        options.axes = {{.name = "X"}};
        return options;
    }

    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    drivecomm::FaultPlan faults;
    drivecomm::VirtualDrive drive{drivecomm::genericProfile(), driveOptions()};
    std::unique_ptr<drivecomm::WebServer> server;
};

QString logOf(WizardController& controller)
{
    QString all;
    for (const LogLine& line : controller.log())
        all += line.text() + u' ' + line.detail + u'\n';
    return all;
}

} // namespace

class TestWindowPassword final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void itIsUsedAndNeitherShownNorStored_data()
    {
        QTest::addColumn<QString>("user");
        QTest::newRow("right") << QStringLiteral("anna");
        QTest::newRow("wrong") << QStringLiteral("otto");
    }
    void itIsUsedAndNeitherShownNorStored()
    {
        QFETCH(QString, user);
        GuardedPage page;
        {
            app::WizardWindow window(page.options(), page.settings);
            window.show();
            WizardController& controller = window.wizard().controller();
            window.wizard().findChild<QPushButton*>(QStringLiteral("connectionsButton"))->click();
            auto* dialog = window.findChild<QDialog*>(QStringLiteral("connectionsDialog"));
            QVERIFY(dialog);
            auto* address = dialog->findChild<QLineEdit*>(QStringLiteral("connectionAddress"));
            auto* list = dialog->findChild<QTreeWidget*>(QStringLiteral("connections"));
            const int before = list->topLevelItemCount();
            address->setText(page.url(user));
            dialog->findChild<QPushButton*>(QStringLiteral("addConnection"))->click();
            address->clear(); // what is being typed may be seen by who types it
            QCOMPARE(seenIn(*dialog), QString()); // "Asking ..."
            QTRY_COMPARE(list->topLevelItemCount(), before + 1);
            QCOMPARE(seenIn(*dialog), QString());
            dialog->findChild<QPushButton*>(QStringLiteral("editConnection"))->click();
            QCOMPARE(seenIn(*dialog), QString());
            address->clear();
            dialog->findChild<QPushButton*>(QStringLiteral("acceptConnections"))->click();
            const auto expected =
                user == u"anna" ? DriveState::Connection::Connected : DriveState::Connection::Lost;
            QTRY_COMPARE(controller.drives().back().connection, expected);
            QCOMPARE(seenIn(window), QString());
            QVERIFY(!logOf(controller).isEmpty());
            QVERIFY(!tellsIt(logOf(controller)));
            page.server.reset(); // the drive is lost: more to say
            controller.refresh();
            QTRY_COMPARE(controller.drives().back().connection, DriveState::Connection::Lost);
            QCOMPARE(seenIn(window), QString());
            QVERIFY(!tellsIt(logOf(controller)));
            page.settings.sync();
        }
        QVERIFY(!page.settings.value(QStringLiteral("compensationWizard/endpoints"))
                     .toStringList()
                     .isEmpty());
        QCOMPARE(storedIn(page.folder.path()), QString());
    }
};

AXISCOMP_WINDOW_TEST(TestWindowPassword)

} // namespace tst_windowpassword

#include "tst_windowpassword.moc"
