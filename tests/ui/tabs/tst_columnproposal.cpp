// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/page/page_tabs.h"

#include <QSettings>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

namespace tst_columnproposal {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

namespace {

constexpr const char* ownHeader = "Pos [mm],Way,Lap,Delta [um]\n";
constexpr const char* ownValues = "0,+,1,1\n10,+,1,2\n0,-,1,3\n10,-,1,4\n";
const QStringList ownColumns{QStringLiteral("Pos [mm]"), QStringLiteral("Way"),
    QStringLiteral("Lap"), QStringLiteral("Delta [um]")};
const QStringList ownRoles{QStringLiteral("target"), QStringLiteral("direction"),
    QStringLiteral("run"), QStringLiteral("deviation")};
constexpr const char* ownProposal =
    "Proposed, as you chose it for the last file with these columns: target in column 1, direction "
    "in column 2, run in column 3, deviation in column 4.";

QString cell(PageFixture& bench, int row, int column)
{
    const auto& files = bench.user.the<QTableView>("measurementFiles");
    return files.model()->index(row, column).data().toString();
}

[[nodiscard]] bool showMeasure(PageFixture& bench)
{
    if (!bench.user.isThere())
        return false;
    bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Measure);
    return bench.user.sees("measurePage");
}

/// Its columns are seen.
[[nodiscard]] bool add(
    PageFixture& bench, const char* name, const char* header = ownHeader, int row = 0)
{
    bench.picked = bench.file(QLatin1StringView(name), QByteArray(header) + ownValues);
    if (!bench.user.click("addMeasurement"))
        return false;
    bench.user.the<QTabWidget>("measureTabs").setCurrentIndex(1);
    return test::PageUser::waitFor([&] {
        return cell(bench, row, 1) == QStringLiteral("cannot be used");
    }) && test::PageUser::waitFor([&] { return bench.user.sees("roleOfColumn4"); });
}

[[nodiscard]] bool chooseRoles(PageFixture& bench, const QStringList& roles)
{
    for (qsizetype n = 0; n < roles.size(); ++n) {
        const QByteArray list = "roleOfColumn" + QByteArray::number(n + 1);
        if (!bench.user.choose(list, roles[n]))
            return false;
    }
    return true;
}

/// Empty: none is shown.
QString proposal(PageFixture& bench)
{
    return bench.user.sees("columnProposal") ? bench.user.the<QLabel>("columnProposalText").text()
                                             : QString();
}

QStringList known(PageFixture& bench, const QStringList& header = ownColumns)
{
    return WizardSettings(&bench.settings).columnRoles(header);
}

} // namespace

/// What the columns of a file were said to be is proposed for the next one of the same columns, and
/// never taken unasked.
class TestColumnProposal : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void whatWasChosenIsProposedForTheNextFile()
    {
        PageFixture bench;
        QVERIFY(showMeasure(bench) && add(bench, "first.csv"));
        QVERIFY(proposal(bench).isEmpty());
        QVERIFY(chooseRoles(bench, ownRoles));
        QTRY_COMPARE(cell(bench, 0, 2), QStringLiteral("1 up, 1 down"));
        QVERIFY(proposal(bench).isEmpty());
        QCOMPARE(known(bench), ownRoles);
        QVERIFY(add(bench, "second.csv", ownHeader, 1));
        QTRY_COMPARE(proposal(bench), QLatin1StringView(ownProposal));
        QVERIFY(bench.user.click("takeColumnsButton"));
        QTRY_COMPARE(cell(bench, 1, 2), QStringLiteral("1 up, 1 down"));
        QVERIFY(proposal(bench).isEmpty());
        for (int n = 0; n < 4; ++n) {
            const QByteArray list = "roleOfColumn" + QByteArray::number(n + 1);
            QCOMPARE(bench.user.the<QComboBox>(list).currentText(), ownRoles[n]);
        }
        // It was one step.
        bench.user.press(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(cell(bench, 1, 1), QStringLiteral("cannot be used"));
        QTRY_COMPARE(proposal(bench), QLatin1StringView(ownProposal));
    }

    void columnsOfOtherNamesAreNotProposed()
    {
        PageFixture bench;
        WizardSettings(&bench.settings).setColumnRoles(ownColumns, ownRoles);
        QVERIFY(showMeasure(bench));
        QVERIFY(add(bench, "other.csv", "Pos [mm],Way,Lap,Error [um]\n"));
        QCOMPARE(bench.user.the<QTableWidget>("columnPreview").horizontalHeaderItem(3)->text(),
            QStringLiteral("Error [um]"));
        QVERIFY(proposal(bench).isEmpty());
    }

    void whatIsTakenBackIsForgotten()
    {
        PageFixture bench;
        WizardSettings(&bench.settings).setColumnRoles(ownColumns, ownRoles);
        QVERIFY(showMeasure(bench) && add(bench, "own.csv"));
        QTRY_COMPARE(proposal(bench), QLatin1StringView(ownProposal));
        QVERIFY(bench.user.choose("roleOfColumn1", ownRoles[0]));
        QTRY_COMPARE(
            known(bench), (QStringList{QStringLiteral("target"), QString(), QString(), QString()}));
        QVERIFY(proposal(bench).isEmpty());
        QVERIFY(bench.user.choose("roleOfColumn1", QStringLiteral("by its name")));
        QTRY_VERIFY(known(bench).isEmpty());
        QVERIFY(proposal(bench).isEmpty());
    }

    /// Anybody may have edited the file of the settings.
    void whatTheSettingsCannotSayIsNotProposed()
    {
        PageFixture bench;
        WizardSettings(&bench.settings)
            .setColumnRoles(ownColumns,
                {QStringLiteral("target"), QStringLiteral("<b>sideways</b>"), QString(),
                    QString()});
        QVERIFY(showMeasure(bench) && add(bench, "own.csv"));
        QTRY_COMPARE(proposal(bench),
            QStringLiteral("Proposed, as you chose it for the last file with these columns: target "
                           "in column 1."));
        for (const char* edited : {"nonsense", "{}", R"({"header":["A","B"],"roles":["target"]})",
                 R"({"header":["A","B"],"roles":"target"})"}) {
            bench.settings.setValue(QStringLiteral("compensationWizard/columnRoles"),
                QStringList{QLatin1StringView(edited)});
            QVERIFY2(known(bench, {QStringLiteral("A"), QStringLiteral("B")}).isEmpty(), edited);
        }
    }

    void theLastHeadersAreKnownAndNoMore()
    {
        const QTemporaryDir folder;
        QSettings file(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
        WizardSettings settings(&file);
        const auto header = [](int n) { return QStringList{QStringLiteral("column %1").arg(n)}; };
        const QStringList roles{QStringLiteral("target")};
        constexpr int most = 32;
        for (int n = 0; n <= most; ++n)
            settings.setColumnRoles(header(n), roles);
        QVERIFY(settings.columnRoles(header(0)).isEmpty());
        for (int n = 1; n <= most; ++n)
            QCOMPARE(settings.columnRoles(header(n)), roles);
        // One that is chosen again is the last one, once.
        settings.setColumnRoles(header(1), roles);
        settings.setColumnRoles(header(0), roles);
        QCOMPARE(settings.columnRoles(header(1)), roles);
        QVERIFY(settings.columnRoles(header(2)).isEmpty());
    }
};

AXISCOMP_WINDOW_TEST(TestColumnProposal)

} // namespace tst_columnproposal

#include "tst_columnproposal.moc"
