// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/window_test.h"
#include "ui/dialogs/file_picker.h"

#include <QFile>
#include <QFileDialog>
#include <QTemporaryDir>
#include <QTest>

namespace tst_filepicker {

using axiscomp::ui::FileQuestion;
using axiscomp::ui::systemFilePicker;
using Purpose = FileQuestion::Purpose;

namespace {

/// A file that is there.
QString fileIn(const QTemporaryDir& folder)
{
    QFile file(folder.filePath(QStringLiteral("there.csv")));
    if (!file.open(QIODevice::WriteOnly))
        qFatal("cannot write %s", qPrintable(file.fileName()));
    return file.fileName();
}

} // namespace

/// The system's dialog, where the page asks nothing itself.
class TestFilePicker : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { axiscomp::test::failOnWindowWarnings(); }

    void onlyAFileThatWouldBeReplacedIsAskedAbout_data()
    {
        QTest::addColumn<Purpose>("purpose");
        QTest::addColumn<bool>("isAsked");
        QTest::newRow("table") << Purpose::SaveTable << true;
        QTest::newRow("program") << Purpose::SaveProgram << true;
        QTest::newRow("values go on where they end") << Purpose::SaveValues << false;
        QTest::newRow("of a record the page asks") << Purpose::SaveRecord << false;
    }
    void onlyAFileThatWouldBeReplacedIsAskedAbout()
    {
        QFETCH(Purpose, purpose);
        QFETCH(bool, isAsked);
        const QTemporaryDir folder;
        const QString there = fileIn(folder);
        QWidget page;
        QString answer;
        systemFilePicker()(page,
            {purpose, QStringLiteral("Save"), QStringLiteral("(*.csv)"), there},
            [&](const QString& path) { answer = path; });
        auto* dialog = page.findChild<QFileDialog*>(QStringLiteral("fileDialog"));
        QVERIFY(dialog);
        QCOMPARE(dialog->testOption(QFileDialog::DontConfirmOverwrite), !isAsked);
        if (isAsked)
            return;
        static_cast<QDialog*>(dialog)->accept();
        QCOMPARE(answer, there);
    }
};

AXISCOMP_WINDOW_TEST(TestFilePicker)

} // namespace tst_filepicker

#include "tst_filepicker.moc"
