// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/measurement_files.h"
#include "tests/ui/support/settled_record.h"
#include "tests/ui/support/window_test.h"
#include "ui/record/drift_models.h"
#include "ui/record/figures_models.h"
#include "ui/record/outliers_model.h"
#include "ui/record/record_model.h"
#include "ui/record/remark_models.h"

#include <QAbstractItemModelTester>
#include <QTemporaryDir>
#include <QTest>

namespace tst_judgementmodels {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::publicMeasurement;
using test::settled;
using test::writtenMeasurement;

namespace {

QString text(const QAbstractItemModel& model, int row, int column)
{
    return model.index(row, column).data().toString();
}

QString spoken(const QAbstractItemModel& model, int row)
{
    return model.index(row, 0).data(Qt::AccessibleTextRole).toString();
}

QString heading(const QAbstractItemModel& model, int column)
{
    return model.headerData(column, Qt::Horizontal).toString();
}

/// The row that begins with a text; -1: there is none.
int rowOf(const QAbstractItemModel& model, const QString& first)
{
    for (int row = 0; row < model.rowCount(); ++row)
        if (text(model, row, 0) == first)
            return row;
    return -1;
}

const Exclusion firstOutlier{Approach::Down, 1, 1};
const Exclusion secondOutlier{Approach::Down, 2, 1};

} // namespace

/// The tables of a judgement, against numbers that were computed elsewhere.
class TestJudgementModels : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void theyKeepTheRulesOfAModelWhileFilesComeAndGo()
    {
        RecordModel record;
        FiguresModel figures(record);
        TargetFiguresModel targets(record);
        RunDriftModel runs(record);
        DriftModel drift(record);
        ConditionsModel conditions(record);
        JudgeWarningsModel warnings(record);
        OutliersModel outliers(record);
        const std::array<QAbstractItemModel*, 7> all{
            &figures, &targets, &runs, &drift, &conditions, &warnings, &outliers};
        std::vector<std::unique_ptr<QAbstractItemModelTester>> testers;
        for (QAbstractItemModel* model : all)
            testers.push_back(std::make_unique<QAbstractItemModelTester>(
                model, QAbstractItemModelTester::FailureReportingMode::QtTest));
        record.addFiles({publicMeasurement("ess_mcu1025")});
        QVERIFY(settled(record));
        QCOMPARE(targets.rowCount(), 5);
        QCOMPARE(runs.rowCount(), 10);
        record.exclude({firstOutlier, secondOutlier});
        QVERIFY(settled(record));
        targets.setShowsAll(true);
        record.removeFile(0);
        QVERIFY(settled(record));
        for (const QAbstractItemModel* model : all)
            QCOMPARE(model->rowCount(), 0);
    }

    void figuresStandWithToleranceAndVerdictInARow()
    {
        RecordModel record;
        FiguresModel model(record);
        record.addFiles({publicMeasurement("bifrost")});
        QVERIFY(settled(record));
        QCOMPARE(heading(model, 2), QStringLiteral("Value [µm]"));
        QCOMPARE(text(model, rowOf(model, QStringLiteral("A")), 2), QStringLiteral("18.57"));
        QCOMPARE(text(model, rowOf(model, QStringLiteral("E")), 2), QStringLiteral("15.99"));
        QCOMPARE(text(model, rowOf(model, QStringLiteral("R")), 2), QStringLiteral("8.35"));
        QCOMPARE(text(model, rowOf(model, QStringLiteral("B")), 2), QStringLiteral("4.56"));
        QCOMPARE(text(model, rowOf(model, QStringLiteral("M")), 2), QStringLiteral("14.95"));
        QCOMPARE(text(model, rowOf(model, QStringLiteral("R↑")), 2), QStringLiteral("7.50"));
        record.setTolerance(Iso230Figure::A, 0.010);
        record.setTolerance(Iso230Figure::M, 0.016);
        record.setTolerance(Iso230Figure::R, 0.020);
        QVERIFY(settled(record));
        QCOMPARE(spoken(model, rowOf(model, QStringLiteral("A"))),
            QStringLiteral("Figure: A, Meaning: accuracy A, Value [µm]: 18.57, Tolerance [µm]: "
                           "10.00, Verdict: failed, uncertainty not stated, At target [mm]: 55.8 "
                           "and 45.6"));
        record.setUncertainty(0.002);
        QVERIFY(settled(record));
        QCOMPARE(
            text(model, rowOf(model, QStringLiteral("A")), 4), QStringLiteral("failed, U 2.00 µm"));
        QCOMPARE(text(model, rowOf(model, QStringLiteral("M")), 4),
            QStringLiteral("undecided, U 2.00 µm"));
        QCOMPARE(
            text(model, rowOf(model, QStringLiteral("R")), 4), QStringLiteral("passed, U 2.00 µm"));
        QCOMPARE(text(model, rowOf(model, QStringLiteral("E")), 4), QStringLiteral("–"));
    }

    void withExclusionsBothVersionsStandBesideEachOther()
    {
        RecordModel record;
        FiguresModel model(record);
        record.addFiles({publicMeasurement("ess_mcu1025")});
        record.setTolerance(Iso230Figure::R, 0.1);
        QVERIFY(settled(record));
        QCOMPARE(model.columnCount(), 6);
        const int row = rowOf(model, QStringLiteral("R"));
        QCOMPARE(text(model, row, 2), QStringLiteral("204.76"));
        QVERIFY(text(model, row, 4).startsWith(QStringLiteral("failed")));
        record.exclude({firstOutlier, secondOutlier});
        QVERIFY(settled(record));
        QCOMPARE(model.columnCount(), 7);
        QCOMPARE(heading(model, 2), QStringLiteral("Without excluded [µm]"));
        QCOMPARE(text(model, row, 2), QStringLiteral("58.28"));
        QVERIFY(text(model, row, 4).startsWith(QStringLiteral("passed")));
        QCOMPARE(heading(model, 5), QStringLiteral("All values [µm]"));
        QCOMPARE(text(model, row, 5), QStringLiteral("204.76"));
    }

    void aFigureReadsAsItWasDecided()
    {
        QTemporaryDir folder;
        RecordModel record;
        FiguresModel model(record);
        record.addFiles({writtenMeasurement(folder, "near.csv",
            "target [mm],direction,run,deviation [um]\n0,+,1,0\n10,+,1,10.0004\n0,-,1,0\n"
            "10,-,1,0\n")});
        QVERIFY(settled(record));
        record.setTolerance(Iso230Figure::E, 0.01);
        QVERIFY(settled(record));
        const int row = rowOf(model, QStringLiteral("E"));
        QCOMPARE(text(model, row, 2), QStringLiteral("10.0004"));
        QCOMPARE(text(model, row, 3), QStringLiteral("10.0000"));
        QVERIFY(text(model, row, 4).startsWith(QStringLiteral("failed")));
        QCOMPARE(text(model, rowOf(model, QStringLiteral("E↑")), 2), QStringLiteral("10.00"));
    }

    void aFigureThatIsNotDefinedSaysSo()
    {
        QTemporaryDir folder;
        RecordModel record;
        FiguresModel model(record);
        record.addFiles({writtenMeasurement(folder, "up.csv",
            "target [mm],direction,run,deviation [um]\n0,+,1,1\n10,+,1,2\n0,+,2,2\n"
            "10,+,2,2\n")});
        QVERIFY(settled(record));
        record.setTolerance(Iso230Figure::A, 1.0);
        QVERIFY(settled(record));
        const int row = rowOf(model, QStringLiteral("A"));
        QCOMPARE(text(model, row, 2), QStringLiteral("not defined"));
        QVERIFY(text(model, row, 4).startsWith(QStringLiteral("not defined")));
        QCOMPARE(text(model, rowOf(model, QStringLiteral("E↑")), 2), QStringLiteral("0.50"));
    }

    void smallFiguresAreShownInNanometresAndAnglesInArcSeconds()
    {
        QTemporaryDir folder;
        const QByteArray rows = "0,+,1,10\n10,+,1,20\n0,+,2,12\n10,+,2,22\n0,-,1,5\n10,-,1,15\n"
                                "0,-,2,5\n10,-,2,15\n";
        RecordModel record;
        FiguresModel model(record);
        record.addFiles({writtenMeasurement(
            folder, "nm.csv", "target [mm],direction,run,deviation [nm]\n" + rows)});
        QVERIFY(settled(record));
        QCOMPARE(heading(model, 2), QStringLiteral("Value [nm]"));
        QCOMPARE(text(model, rowOf(model, QStringLiteral("M")), 2), QStringLiteral("10.00"));
        record.removeFile(0);
        record.addFiles({writtenMeasurement(
            folder, "angle.csv", "target [deg],direction,run,deviation [arcsec]\n" + rows)});
        QVERIFY(settled(record));
        QCOMPARE(heading(model, 2), QStringLiteral("Value [″]"));
        QCOMPARE(text(model, rowOf(model, QStringLiteral("M")), 2), QStringLiteral("10.00"));
    }

    void targetsShowTheValuesInUseOrAll()
    {
        RecordModel record;
        TargetFiguresModel model(record);
        record.addFiles({publicMeasurement("ess_mcu1025")});
        record.exclude({firstOutlier});
        QVERIFY(settled(record));
        QCOMPARE(text(model, 0, 5), QStringLiteral("4"));
        model.setShowsAll(true);
        QCOMPARE(text(model, 0, 5), QStringLiteral("5"));
        QVERIFY(model.valuesOf(1) == (Exclusion{{}, 2, {}}));
        QCOMPARE(model.rowOf(firstOutlier), 0);
        QCOMPARE(model.rowOf({Approach::Up, {}, 3}), -1);
    }

    void targetsOfAPublicMeasurement()
    {
        RecordModel record;
        TargetFiguresModel model(record);
        record.addFiles({publicMeasurement("bifrost")});
        QVERIFY(settled(record));
        QCOMPARE(text(model, 3, 1), QStringLiteral("45.6"));
        // -9.02, -7.88 and -8.45 as they were read.
        QCOMPARE(text(model, 3, 3), QStringLiteral("-12.25"));
        QCOMPARE(text(model, 3, 6), QStringLiteral("-11.11"));
        QCOMPARE(text(model, 3, 8), QStringLiteral("-11.68"));
        QCOMPARE(text(model, 0, 8), QStringLiteral("0.00"));
        QCOMPARE(text(model, 3, 9), QStringLiteral("-1.14"));
        QCOMPARE(model.headerData(3, Qt::Horizontal, Qt::ToolTipRole).toString(),
            QStringLiteral("0 = mean at 15 mm"));
    }

    void driftIsSaidInNumbersAndWords()
    {
        RecordModel record;
        DriftModel drift(record);
        RunDriftModel runs(record);
        record.addFiles({publicMeasurement("b02_y")});
        QVERIFY(settled(record));
        QCOMPARE(text(drift, 0, 1), QStringLiteral("-12.25 µm"));
        QCOMPARE(text(drift, 0, 2), QStringLiteral("-13.20 µm"));
        QCOMPARE(text(drift, 5, 1), QStringLiteral("suspected"));
        QCOMPARE(drift.rowCount(), 8);
        QCOMPARE(text(drift, 6, 3), QStringLiteral("113.99 µm"));
        QCOMPARE(text(drift, 7, 3), QStringLiteral("33.08 µm"));
        QCOMPARE(text(drift, 6, 1), QStringLiteral("100.68 µm"));
        QCOMPARE(text(drift, 6, 2), QStringLiteral("95.60 µm"));
        QCOMPARE(text(drift, 7, 1), QStringLiteral("12.94 µm"));
        QCOMPARE(text(drift, 7, 2), QStringLiteral("20.45 µm"));
        QCOMPARE(runs.rowCount(), 10);
        QCOMPARE(heading(runs, 3), QStringLiteral("Slope [µm/m]"));
        QVERIFY(runs.valuesOf(6) == (Exclusion{Approach::Down, {}, 2}));
        QCOMPARE(runs.rowOf({Approach::Down, {}, 2}), 6);
        record.removeFile(0);
        record.addFiles({publicMeasurement("bifrost")});
        QVERIFY(settled(record));
        QCOMPARE(text(drift, 5, 1), QStringLiteral("not suspected"));
        QCOMPARE(drift.rowCount(), 6);
    }

    void conditionsAreMetOrNotOrNotKnown()
    {
        RecordModel record;
        ConditionsModel model(record);
        record.addFiles({publicMeasurement("bifrost")});
        QVERIFY(settled(record));
        QVERIFY(text(model, 0, 0).startsWith(QStringLiteral("at least 5 targets")));
        QCOMPARE(text(model, 0, 1), QStringLiteral("met"));
        QCOMPARE(text(model, 3, 1), QStringLiteral("not known"));
    }

    void proposalsAndWhatIsExcludedStandInOneList()
    {
        RecordModel record;
        OutliersModel model(record);
        record.addFiles({publicMeasurement("ess_mcu1025")});
        QVERIFY(settled(record));
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(text(model, 0, 0), QStringLiteral("↓ down"));
        QCOMPARE(text(model, 0, 2), QStringLiteral("1"));
        QCOMPARE(text(model, 0, 3), QStringLiteral("19.95"));
        QCOMPARE(text(model, 1, 3), QStringLiteral("17.50"));
        QCOMPARE(text(model, 0, 4), QStringLiteral("proposed"));
        QVERIFY(model.valuesOf(0) == firstOutlier);
        record.exclude({firstOutlier, {Approach::Up, {}, 2}});
        QVERIFY(settled(record));
        QCOMPARE(text(model, model.rowOf(firstOutlier), 4), QStringLiteral("excluded"));
        const int run = model.rowOf({Approach::Up, {}, 2});
        QCOMPARE(text(model, run, 1), QStringLiteral("all"));
        QCOMPARE(text(model, run, 2), QStringLiteral("2"));
        record.setOutlierRule(OutlierRule::None);
        QVERIFY(settled(record));
        QCOMPARE(model.rowCount(), 2);
    }

    void aLimitOfALengthIsNoneOfAnAngle()
    {
        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("angle.csv")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("target [deg],direction,run,deviation [arcsec]\n0,+,1,1\n90,+,1,2\n0,-,1,2\n"
                   "90,-,1,2\n");
        file.close();
        RecordModel record;
        record.addFiles({publicMeasurement("bifrost")});
        QVERIFY(settled(record));
        record.setTolerance(Iso230Figure::M, 0.02);
        record.setUncertainty(0.001);
        QVERIFY(settled(record));
        QCOMPARE(record.state().judgement->verdicts.size(), std::size_t{1});
        record.removeFile(0);
        record.addFiles({file.fileName()});
        QVERIFY(settled(record));
        QVERIFY(record.state().judgement && record.state().judgement->verdicts.empty());
        // The first limit of an angle is not judged with an uncertainty of a length.
        record.setTolerance(Iso230Figure::M, 0.001);
        QVERIFY(settled(record));
        QCOMPARE(record.state().judgement->verdicts.size(), std::size_t{1});
        QVERIFY(!record.state().judgement->verdicts.front().uncertainty);
    }
};

AXISCOMP_WINDOW_TEST(TestJudgementModels)

} // namespace tst_judgementmodels

#include "tst_judgementmodels.moc"
