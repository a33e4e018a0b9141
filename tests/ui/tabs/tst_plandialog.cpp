// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/local_file.h"
#include "core/metrology/gcode.h"
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/page/page_tabs.h"

#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QTest>

namespace tst_plandialog {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

namespace {

[[nodiscard]] bool openDialog(PageFixture& bench)
{
    bench.user.the<PageTabs>("pageTabs").setCurrentIndex(PageTabs::Measure);
    return bench.user.click("newProgram") && bench.user.sees("planDialog");
}

void set(PageFixture& bench, const char* field, double value)
{
    bench.user.the<QDoubleSpinBox>(field).setValue(value);
}

[[nodiscard]] QString reason(PageFixture& bench)
{
    return bench.user.the<QLabel>("planReason").text();
}

[[nodiscard]] bool isPlanned(PageFixture& bench)
{
    return QTest::qWaitFor(
        [&] { return bench.user.the("savePlanButton").isEnabled(); }, test::patienceMs);
}

std::string contentOf(const QString& file)
{
    const auto bytes = loadFile(file.toStdString(), 1'000'000);
    return bytes ? std::string(asText(*bytes)) : std::string();
}

} // namespace

/// The dialog that plans a measurement.
class TestPlanDialog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void theTravelOfTheAxisIsProposedWithRoomForTheOverrun()
    {
        drivecomm::VirtualDriveOptions options = PageFixture::twoAxes();
        options.axes.front().saysTravel = true; // 0 to 40 mm
        PageFixture bench(std::move(options));
        QVERIFY(bench.open() && openDialog(bench));
        QCOMPARE(bench.user.the<QLineEdit>("planAxisField").text(), QStringLiteral("X"));
        QCOMPARE(bench.user.the<QDoubleSpinBox>("fromField").value(), 0.4);
        QCOMPARE(bench.user.the<QDoubleSpinBox>("toField").value(), 39.6);
        QVERIFY(isPlanned(bench));
        const auto& preview = bench.user.the<QTableView>("planPreview");
        QCOMPARE(preview.model()->rowCount(), 21);
        QCOMPARE(preview.model()->index(0, 1).data().toString(), QStringLiteral("0.400"));
        QCOMPARE(preview.model()->index(20, 1).data().toString(), QStringLiteral("39.600"));
        QVERIFY(reason(bench).contains(QStringLiteral("never moves an axis")));
        set(bench, "toField", 45.0);
        QVERIFY(isPlanned(bench));
        QTRY_VERIFY2(reason(bench).contains(QStringLiteral("its travel is 0.000 mm to 40.000 mm")),
            qPrintable(reason(bench)));
    }

    void everyMistakeIsSaidInTheWordsOfItsField_data()
    {
        QTest::addColumn<QByteArray>("field");
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("said");
        QTest::newRow("last") << QByteArray("toField") << -5.0
                              << QStringLiteral("Last target: The last target");
        QTest::newRow("overrun is by the range when it is 0")
            << QByteArray("overrunField") << 0.0 << QString();
        QTest::newRow("feed") << QByteArray("feedField") << 0.0 << QStringLiteral("Feed: The feed");
        QTest::newRow("dwell") << QByteArray("dwellField") << 0.0
                               << QStringLiteral("Dwell: The dwell must be above 0 s");
    }
    void everyMistakeIsSaidInTheWordsOfItsField()
    {
        QFETCH(const QByteArray, field);
        QFETCH(const double, value);
        QFETCH(const QString, said);
        PageFixture bench;
        QVERIFY(bench.open() && openDialog(bench) && isPlanned(bench));
        set(bench, field, value);
        if (said.isEmpty()) {
            QVERIFY(isPlanned(bench));
            return;
        }
        QVERIFY2(reason(bench).startsWith(said), qPrintable(reason(bench)));
        QVERIFY(!bench.user.the("savePlanButton").isEnabled());
        QVERIFY(!bench.user.the("saveProgramButton").isEnabled());
        QCOMPARE(bench.user.the<QTableView>("planPreview").model()->rowCount(), 0);
    }

    void countsAreSaidByTheirFields()
    {
        PageFixture bench;
        QVERIFY(bench.open() && openDialog(bench) && isPlanned(bench));
        bench.user.the<QSpinBox>("countField").setValue(1);
        QVERIFY2(reason(bench).startsWith(QStringLiteral("Targets: A plan has 2 to")),
            qPrintable(reason(bench)));
        bench.user.the<QSpinBox>("countField").setValue(3);
        bench.user.the<QSpinBox>("cyclesField").setValue(0);
        QVERIFY2(reason(bench).startsWith(QStringLiteral("Cycles: At least one cycle")),
            qPrintable(reason(bench)));
        bench.user.the<QSpinBox>("cyclesField").setValue(2);
        bench.user.the<QLineEdit>("planAxisField").setText(QString());
        QVERIFY2(reason(bench).startsWith(QStringLiteral("Axis: Name the axis")),
            qPrintable(reason(bench)));
    }

    void aNumberThatCanBeReadInTwoWaysIsSaidAndNotPlanned()
    {
        PageFixture bench(PageFixture::twoAxes(), QStringLiteral("de"));
        QVERIFY(bench.open() && openDialog(bench) && isPlanned(bench));
        const auto& last = bench.user.the<QDoubleSpinBox>("toField");
        const double before = last.value();
        const auto type = [&](const char* text) {
            const bool isThere = bench.user.click("toField");
            bench.user.press(Qt::Key_A, Qt::ControlModifier);
            bench.user.type(QLatin1StringView(text));
            bench.user.press(Qt::Key_Tab);
            return isThere;
        };
        QVERIFY(type("45.678"));
        QCOMPARE(last.value(), before);
        QTRY_VERIFY2(reason(bench).contains(QStringLiteral("45.678")), qPrintable(reason(bench)));
        QVERIFY(!bench.user.the("savePlanButton").isEnabled());
        QVERIFY(!bench.user.the("saveProgramButton").isEnabled());
        QVERIFY(type("45,678"));
        QCOMPARE(last.value(), 45.678);
        QVERIFY(isPlanned(bench));
        QVERIFY(!reason(bench).contains(QStringLiteral("45.678")));
    }

    void planAndProgramAreThoseOfTheCommandLine()
    {
        PageFixture bench;
        QVERIFY(bench.open() && openDialog(bench));
        set(bench, "fromField", 1.0);
        set(bench, "toField", 31.0);
        bench.user.the<QSpinBox>("countField").setValue(4);
        bench.user.the<QSpinBox>("cyclesField").setValue(2);
        bench.user.the<QSpinBox>("seedField").setValue(7);
        set(bench, "overrunField", 0.5);
        set(bench, "periodField", 5.0);
        set(bench, "feedField", 600.0);
        set(bench, "dwellField", 2.5);
        MeasuringPlanRequest request;
        request.from = 1.0;
        request.to = 31.0;
        request.count = 4;
        request.cycles = 2;
        request.seed = 7;
        request.overrun = 0.5;
        request.period = 5.0;
        request.feedPerMinute = 600.0;
        request.dwellSeconds = 2.5;
        const MeasuringPlan plan = makeMeasuringPlan(request).value();
        QVERIFY(isPlanned(bench));
        bench.picked = bench.path(QStringLiteral("plan.csv"));
        QVERIFY(bench.user.click("savePlanButton"));
        QTRY_COMPARE(reason(bench), QStringLiteral("Saved as plan.csv."));
        QCOMPARE(contentOf(bench.picked), measuringPlanCsv(plan));
        QVERIFY(bench.user.choose("dialectField", QStringLiteral("Siemens")));
        bench.picked = bench.path(QStringLiteral("plan.mpf"));
        QVERIFY(bench.user.click("saveProgramButton"));
        QTRY_COMPARE(reason(bench), QStringLiteral("Saved as plan.mpf."));
        QVERIFY(bench.questions.back().start.endsWith(QStringLiteral("plan-X.mpf")));
        QCOMPARE(contentOf(bench.picked), gcodeProgram(plan, GcodeDialect::Siemens).value());
        // A plan in a file that a control takes for a program
        QVERIFY(bench.user.click("savePlanButton"));
        QTRY_VERIFY2(reason(bench).contains(QStringLiteral("mislead the control")),
            qPrintable(reason(bench)));
        QCOMPARE(contentOf(bench.picked), gcodeProgram(plan, GcodeDialect::Siemens).value());
    }
};

AXISCOMP_WINDOW_TEST(TestPlanDialog)

} // namespace tst_plandialog

#include "tst_plandialog.moc"
