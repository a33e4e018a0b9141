// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/file_kind.h"
#include "tests/support/file_content.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QDir>
#include <QFile>
#include <QMimeDatabase>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

namespace tst_filetypes {

using namespace axiscomp;

namespace {

const QString packaging = QStringLiteral(AXISCOMP_SOURCE_FOLDER "/packaging/");
const QString types = packaging + QStringLiteral("org.axiscomp.wizard.mime.xml");

QSet<QString> matches(const QString& file, const char* pattern)
{
    const QString text = QString::fromStdString(test::contentOf(file.toStdString()));
    QSet<QString> found;
    const QRegularExpression expression(
        QString::fromLatin1(pattern), QRegularExpression::MultilineOption);
    for (auto each = expression.globalMatch(text); each.hasNext();)
        found += each.next().captured(1);
    return found;
}

QSet<QString> ownTypes()
{
    return matches(types, "<mime-type type=\"([^\"]*)\"");
}

} // namespace

/// What a desktop takes a file for, and who opens it.
class TestFileTypes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        const QString folder = m_data.filePath(QStringLiteral("mime/packages"));
        QVERIFY(QDir().mkpath(folder));
        QVERIFY(QFile::copy(types, folder + QStringLiteral("/org.axiscomp.wizard.xml")));
        qputenv("XDG_DATA_HOME", "/nonexistent");
        qputenv("XDG_DATA_DIRS", QFile::encodeName(m_data.path()) + ":/usr/share");
    }
    void init() { test::failOnWarnings(); }

    void aFileIsKnownByItsName_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("type");
        QTest::addColumn<QString>("general");
        const auto row = [](const char* name, const char* type, const char* general) {
            QTest::newRow(name) << QString::fromLatin1(name) << QString::fromLatin1(type)
                                << QString::fromLatin1(general);
        };
        row("job.axcal", "application/vnd.axiscomp.record+json", "application/json");
        row("JOB.AXCAL", "application/vnd.axiscomp.record+json", "application/json");
        row("machine.toml", "application/vnd.axiscomp.machine", "application/toml");
        row("mill.machine.toml", "application/vnd.axiscomp.machine", "application/toml");
        row("Small1.TAMtbl", "application/x-tamtbl", "application/octet-stream");
        row("small1.tamtbl", "application/x-tamtbl", "application/octet-stream");
        row("gantry.TAMcfg", "application/x-tamcfg", "application/xml");
    }
    void aFileIsKnownByItsName()
    {
        QFETCH(const QString, name);
        QFETCH(const QString, type);
        QFETCH(const QString, general);
        const QMimeDatabase database;
        const QMimeType found = database.mimeTypeForFile(name, QMimeDatabase::MatchExtension);
        QCOMPARE(found.name(), type);
        QVERIFY(found.inherits(general));
        QVERIFY(!found.comment().isEmpty());
        QVERIFY(ownTypes().contains(type));
        // And the program does not take it for something unknown.
        QVERIFY(kindOfFile("", name.toStdString()));
    }

    void otherTextFilesStayWhatTheyAre()
    {
        const QMimeDatabase database;
        for (const char* name : {"pyproject.toml", "e.csv", "drives.xml", "backup.json"}) {
            const QString type =
                database.mimeTypeForFile(QLatin1StringView(name), QMimeDatabase::MatchExtension)
                    .name();
            QVERIFY2(!ownTypes().contains(type), qPrintable(type));
        }
    }

    void aTableOfTheGenericLayoutIsKnownByItsContent()
    {
        const QMimeDatabase database;
        const QByteArray table = QByteArray("TAMT\x01\x00\x80\x00", 8) + QByteArray(120, '\0');
        QCOMPARE(database.mimeTypeForData(table).name(), QStringLiteral("application/x-tamtbl"));
    }

    void theProgramIsOfferedForAllOfTheTypes()
    {
        const QString desktop = packaging + QStringLiteral("axis-compensation-wizard.desktop");
        QSet<QString> offered;
        for (const QString& line : matches(desktop, "^MimeType=(.*);$")) {
            const QStringList each = line.split(u';');
            offered += QSet<QString>(each.begin(), each.end());
        }
        QCOMPARE(offered, ownTypes());
        QCOMPARE(matches(packaging + QStringLiteral("org.axiscomp.wizard.metainfo.xml"),
                     "<mediatype>([^<]*)</mediatype>"),
            ownTypes());
        QCOMPARE(matches(desktop, "^Exec=(.*)$"),
            QSet<QString>{QStringLiteral("axis-compensation-wizard %f")});
    }

private:
    QTemporaryDir m_data;
};

AXISCOMP_TEST(TestFileTypes)

} // namespace tst_filetypes

#include "tst_filetypes.moc"
