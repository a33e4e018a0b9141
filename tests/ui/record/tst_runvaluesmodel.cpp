// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/measurement_files.h"
#include "tests/ui/support/settled_record.h"
#include "tests/ui/support/window_test.h"
#include "ui/record/record_model.h"
#include "ui/record/run_values_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace tst_runvaluesmodel {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::publicMeasurement;
using test::settled;
using test::writtenMeasurement;

namespace {

QString text(const RunValuesModel& model, int row, int column)
{
    return model.index(row, column).data().toString();
}

} // namespace

class TestRunValuesModel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void keepsTheRulesOfAModelWhileFilesComeAndGo()
    {
        RecordModel record;
        RunValuesModel model(record);
        const QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(model.rowCount(), 0);
        QCOMPARE(model.columnCount(), 0);
        record.addFiles({publicMeasurement("ess_mcu1025")});
        QVERIFY(settled(record));
        QCOMPARE(model.rowCount(), 5);
        QCOMPARE(model.columnCount(), 11);
        record.addFiles({publicMeasurement("b02_x")});
        QVERIFY(settled(record));
        QCOMPARE(model.columnCount(), 21);
        record.removeFile(0);
        record.removeFile(0);
        QVERIFY(settled(record));
        QCOMPARE(model.rowCount(), 0);
    }

    void aCellStandsForAValueATargetOrARun()
    {
        RecordModel record;
        RunValuesModel model(record);
        record.addFiles({publicMeasurement("ess_mcu1025")});
        QVERIFY(settled(record));
        QVERIFY((model.exclusionOf(model.index(2, 0)) == Exclusion{{}, 3, {}}));
        QVERIFY((model.exclusionOf(model.index(2, 4)) == Exclusion{Approach::Up, 3, 4}));
        QVERIFY((model.exclusionOf(model.index(2, 10)) == Exclusion{Approach::Down, 3, 5}));
        QVERIFY((model.runOf(model.index(2, 10)) == Exclusion{Approach::Down, {}, 5}));
        QVERIFY(!model.runOf(model.index(2, 0)));
        QVERIFY(!model.exclusionOf({}) && !model.runOf({}));
    }

    void whatIsSelectedStaysWhileOnlyTheUseOfValuesChanges()
    {
        RecordModel record;
        RunValuesModel model(record);
        record.addFiles({publicMeasurement("ess_mcu1025")});
        QVERIFY(settled(record));
        QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
        QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
        record.exclude({{Approach::Down, 1, 1}});
        QVERIFY(settled(record));
        QCOMPARE(text(model, 0, 6), QStringLiteral("✕ 93.18"));
        QVERIFY(resets.isEmpty() && !changes.isEmpty());
    }

    void aTargetThatARunDoesNotHaveIsADash()
    {
        QTemporaryDir folder;
        RecordModel record;
        RunValuesModel model(record);
        record.addFiles({writtenMeasurement(folder, "gap.csv",
            "target [mm],direction,run,deviation [um]\n"
            "0,+,1,1\n10,+,1,2\n20,+,1,3\n0,+,2,1\n20,+,2,-0.004\n")});
        QVERIFY(settled(record));
        QCOMPARE(text(model, 1, 2), QStringLiteral("–"));
        QCOMPARE(text(model, 2, 2), QStringLiteral("0.00")); // not -0.00
        QVERIFY(!model.exclusionOf(model.index(1, 2)));
        QCOMPARE(
            model.index(1, 2).data(Qt::AccessibleTextRole).toString(), QStringLiteral("no value"));
    }

    void runsHaveTheNumbersOfTheFile()
    {
        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("through.csv")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("target [mm],direction,run,deviation [um]\n"
                   "0,+,1,1\n10,+,1,2\n10,-,2,3\n0,-,2,4\n0,+,3,5\n10,+,3,6\n");
        file.close();
        RecordModel record;
        RunValuesModel model(record);
        record.addFiles({file.fileName()});
        QVERIFY(settled(record));
        QCOMPARE(model.columnCount(), 4);
        QCOMPARE(model.headerData(2, Qt::Horizontal, Qt::DisplayRole).toString().left(3),
            QStringLiteral("↑ 3"));
        QCOMPARE(text(model, 0, 2), QStringLiteral("5.00"));
        QVERIFY((model.exclusionOf(model.index(1, 3)) == Exclusion{Approach::Down, 2, 2}));
    }

    /// As axiscomp judge shows them.
    void deviationsBelowAHundredNanometresAreInNanometres()
    {
        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("fine.csv")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("target [mm],direction,run,deviation [um]\n0,+,1,0.0012\n10,+,1,-0.08\n");
        file.close();
        RecordModel record;
        RunValuesModel model(record);
        record.addFiles({file.fileName()});
        QVERIFY(settled(record));
        QCOMPARE(text(model, 0, 1), QStringLiteral("1.20"));
        QCOMPARE(text(model, 1, 1), QStringLiteral("-80.00"));
        QCOMPARE(model.headerData(1, Qt::Horizontal, Qt::DisplayRole).toString(),
            QStringLiteral("↑ 1 [nm]"));
    }

    void anglesAreArcSeconds()
    {
        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("table.csv")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("target [deg],direction,run,deviation [deg]\n0,+,1,0.001\n10,+,1,0.002\n");
        file.close();
        RecordModel record;
        RunValuesModel model(record);
        record.addFiles({file.fileName()});
        QVERIFY(settled(record));
        QCOMPARE(text(model, 1, 1), QStringLiteral("7.20")); // 0.002 deg of 3600 arc seconds
        QCOMPARE(model.headerData(1, Qt::Horizontal, Qt::DisplayRole).toString(),
            QStringLiteral("↑ 1 [″]"));
    }
};

AXISCOMP_WINDOW_TEST(TestRunValuesModel)

} // namespace tst_runvaluesmodel

#include "tst_runvaluesmodel.moc"
