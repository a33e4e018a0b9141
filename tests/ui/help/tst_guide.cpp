// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/help/guide_window.h"

#include <QPointer>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>

namespace tst_guide {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

/// The user guide in the window.
class TestGuide : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void theHelpKeyOpensTheGuideAtTheFieldWithTheFocus_data()
    {
        QTest::addColumn<QByteArray>("widget");
        QTest::addColumn<QString>("place");
        QTest::newRow("axis") << QByteArray("axisField") << QStringLiteral("Axis");
        QTest::newRow("dimensionality")
            << QByteArray("dimensionalityField") << QStringLiteral("Dimensionality");
        QTest::newRow("source") << QByteArray("source1Field") << QStringLiteral("Dim1..3 Source");
        QTest::newRow("open") << QByteArray("openButton") << QStringLiteral("Compensation data");
        QTest::newRow("table") << QByteArray("tableField") << QStringLiteral("Table");
        QTest::newRow("persistency")
            << QByteArray("persistencyField") << QStringLiteral("Persistency");
        QTest::newRow("drive") << QByteArray("driveField")
                               << QStringLiteral("2. Connect the drive");
        QTest::newRow("write") << QByteArray("writeButton") << QStringLiteral("4. Write");
        QTest::newRow("activate") << QByteArray("activateButton")
                                  << QStringLiteral("5. Activate, and see the proof");
    }
    void theHelpKeyOpensTheGuideAtTheFieldWithTheFocus()
    {
        QFETCH(QByteArray, widget);
        QFETCH(QString, place);
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.openWritten());
        QVERIFY(user.click("persistencyField")); // so that there is something to write
        if (widget == "activateButton")
            QVERIFY(user.click("revertAllButton"));
        QTRY_VERIFY(user.the(widget.constData()).isEnabled());
        user.the(widget.constData()).setFocus();
        test::PageUser::press(Qt::Key_F1);
        QTRY_VERIFY(user.sees("guideWindow"));
        auto& guide = user.the<GuideWindow>("guideWindow");
        QCOMPARE(guide.textAtTop(), place);
        // It is to be seen, as far up as the guide is long enough.
        auto& text = user.the<QTextBrowser>("guideText");
        QVERIFY(text.viewport()->rect().contains(text.cursorRect().center()));
    }

    void theHelpKeyOpensTheGuideOverADialogAtItsPlace()
    {
        PageFixture bench;
        auto& user = bench.user;
        QVERIFY(bench.open());
        QVERIFY(user.click("connectionsButton"));
        QTRY_VERIFY(user.sees("connectionsDialog"));
        QVERIFY(user.click("connectionAddress"));
        test::PageUser::press(Qt::Key_F1);
        QTRY_VERIFY(user.sees("guideWindow"));
        auto& guide = user.the<GuideWindow>("guideWindow");
        QCOMPARE(guide.textAtTop(), QStringLiteral("2. Connect the drive"));
        // It can be used although the dialog is open, and goes with it.
        QVERIFY(QApplication::activeModalWidget() == guide.parentWidget());
        QCOMPARE(guide.parentWidget(), &user.the("connectionsDialog"));
        const QPointer<GuideWindow> watched(&guide);
        guide.close();
        QVERIFY(user.click("rejectConnections"));
        QTRY_VERIFY(!watched);
    }

    void everyDialogHasItsPlaceInTheGuide_data()
    {
        QTest::addColumn<QString>("heading");
        const auto row = [](const char* dialog, const char* heading) {
            QTest::newRow(dialog) << QString::fromLatin1(heading);
        };
        row("connectionsDialog", "2. Connect the drive");
        row("findDrivesDialog", "2. Connect the drive");
        row("certificateDialog", "2. Connect the drive");
        row("importDialog", "Files of other controllers, and uneven measurements");
        row("exportDialog", "Files of other controllers, and uneven measurements");
        row("multiAxisDialog", "Several axes from one file");
        row("importConfigurationDialog", "Parameters of a TAM configuration");
        row("exportConfigurationDialog", "Parameters of a TAM configuration");
        row("correctionsDialog", "What a measurement says of the axis");
        row("backupDialog", "Backups");
        row("restoreDriveDialog", "Backups");
    }
    void everyDialogHasItsPlaceInTheGuide()
    {
        QFETCH(QString, heading);
        QWidget dialog;
        dialog.setObjectName(QString::fromLatin1(QTest::currentDataTag()));
        const QWidget field(&dialog);
        GuideWindow guide;
        guide.showPlace(guidePlaceOf(&field));
        QCOMPARE(guide.textAtTop(), heading);
    }

    void everyPictureOfTheGuideIsInTheProgram()
    {
        GuideWindow guide;
        guide.show();
        const auto* text = guide.findChild<QTextBrowser*>(QStringLiteral("guideText"));
        int pictures = 0;
        for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next())
            for (auto part = block.begin(); !part.atEnd(); ++part) {
                const QTextImageFormat image = part.fragment().charFormat().toImageFormat();
                if (!image.isValid())
                    continue;
                ++pictures;
                const QString file = QStringLiteral(":/axiscomp/guide/") + image.name();
                QVERIFY2(QFile::exists(file), qPrintable(file));
            }
        QVERIFY(pictures >= 6);
        QVERIFY(text->document()->size().width() <= guide.width());
    }
};

AXISCOMP_WINDOW_TEST(TestGuide)

} // namespace tst_guide

#include "tst_guide.moc"
