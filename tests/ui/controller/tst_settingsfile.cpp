// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/kill_points.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "ui/controller/wizard_settings.h"

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>

namespace tst_settingsfile {

using namespace axiscomp;
using ui::WizardSettings;

namespace {

const QStringList before{QStringLiteral("http://192.168.1.20"), QStringLiteral("demo:")};
const QStringList after{QStringLiteral("http://192.168.1.21")};

bool save(const QString& file, const QStringList& endpoints)
{
    QSettings settings(file, QSettings::IniFormat);
    WizardSettings(&settings).setEndpoints(endpoints);
    settings.sync();
    return settings.status() == QSettings::NoError;
}

QStringList load(const QString& file)
{
    QSettings settings(file, QSettings::IniFormat);
    return WizardSettings(&settings).endpoints();
}

} // namespace

class TestSettingsFile final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void killedAnywhereTheOldOrTheNewIsThere()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.conf"));
        QVERIFY(save(file, before));
        bool sawOld = false;
        bool sawNew = false;
        const int moments = test::killEverywhere([&] { ::_exit(save(file, after) ? 0 : 1); },
            [&] {
                // Qt waits 30 s for a lock file that was made and not yet written to.
                QFile::remove(file + QStringLiteral(".lock"));
                const QStringList there = load(file);
                QVERIFY2(there == before || there == after, qPrintable(there.join(u' ')));
                sawOld = sawOld || there == before;
                sawNew = sawNew || there == after;
                QVERIFY(save(file, before));
            });
        QVERIFY2(moments > 20, std::to_string(moments).c_str());
        qInfo("killed at %d moments", moments);
        QVERIFY(sawOld && sawNew);
    }

    void onAFullDiskTheOldIsThere()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.conf"));
        QVERIFY(save(file, before));
        // Qt keeps what it could not save for the next try, so the file itself is looked at.
        const auto content = [&] {
            QFile opened(file);
            return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
        };
        const QByteArray old = content();
        QVERIFY(!old.isEmpty());
        {
            const test::FileSizeLimit full(20);
            QVERIFY(!save(file, after));
        }
        QCOMPARE(content(), old);
    }

    void listsAreLimited()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.conf"));
        QSettings settings(file, QSettings::IniFormat);
        QStringList many;
        for (int i = 0; i < 10'000; ++i)
            many += QStringLiteral("http://host%1").arg(i);
        many.prepend(QString(1'000'000, u'x'));
        settings.setValue(QStringLiteral("compensationWizard/endpoints"), many);
        settings.setValue(QStringLiteral("compensationWizard/recentFiles"), many);
        const WizardSettings wizard(&settings);
        QCOMPARE(wizard.endpoints().size(), 64);
        QCOMPARE(wizard.endpoints().front(), QStringLiteral("http://host0"));
        QCOMPARE(wizard.recentFiles().size(), 8);
    }
};

AXISCOMP_TEST(TestSettingsFile)

} // namespace tst_settingsfile

#include "tst_settingsfile.moc"
