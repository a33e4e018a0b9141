// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/measurement_files.h"
#include "tests/ui/support/settled_record.h"
#include "tests/ui/support/window_test.h"
#include "ui/judging/limit_fields.h"
#include "ui/record/record_model.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace tst_recordmodel {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::publicMeasurement;
using test::settled;

namespace {

double figureOf(const RecordModel& model, Iso230Figure figure)
{
    const auto& judgement = model.state().judgement;
    return judgement ? judgement->figures[figure].value.value_or(std::nan("")) : std::nan("");
}

std::size_t leftOut(const RecordModel& model)
{
    return model.state().measurement ? model.state().measurement->excludedCount() : 9999;
}

const Exclusion firstOutlier{Approach::Down, 1, 1};
const Exclusion secondOutlier{Approach::Down, 2, 1};

} // namespace

/// What a person says of a measurement, and what it comes to. The numbers are those of
/// docs/metrology.md, computed elsewhere.
class TestRecordModel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void aFileIsReadAndJudgedOnAnotherThread()
    {
        RecordModel model;
        QSignalSpy states(&model, &RecordModel::stateChanged);
        model.addFiles({publicMeasurement("ess_mcu1025")});
        QVERIFY(model.isEvaluating());
        QVERIFY(!model.state().measurement); // nothing was read before this returned
        QVERIFY(settled(model));
        QCOMPARE(states.size(), 2);
        QVERIFY(std::abs(figureOf(model, Iso230Figure::A) - 0.2047595) < 1e-6);
        QVERIFY(std::abs(figureOf(model, Iso230Figure::R) - 0.2047595) < 1e-6);
    }

    void figuresLeaveOutWhatIsExcluded()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("ess_mcu1025")});
        model.exclude({firstOutlier, secondOutlier});
        QVERIFY(settled(model));
        QCOMPARE(leftOut(model), std::size_t{2});
        QVERIFY(std::abs(figureOf(model, Iso230Figure::A) - 0.0892653) < 1e-6);
        QVERIFY(std::abs(figureOf(model, Iso230Figure::R) - 0.0582781) < 1e-6);
        QVERIFY(model.state().judgement->ofAllValues);
    }

    void correctionsAreMadeBeforeJudgingAndGoWithTheirFiles()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("bifrost")});
        QVERIFY(settled(model));
        CorrectionsBefore corrections;
        corrections.temperature = TemperatureCorrection{22.5, 11.5e-6};
        corrections.temperature->isConfirmed = true;
        model.setCorrections(corrections);
        QVERIFY(settled(model));
        // 40.8 mm from the first to the last target, 11.5e-6/K, 2.5 K: the last one by -1.173 um.
        const Measurement& measurement = *model.state().measurement;
        const RunValue* last = findValue(measurement, Approach::Up, 4, 1);
        QVERIFY(last && std::abs(last->deviation - (0.00583 - 0.001173)) < 6e-6);
        QVERIFY(std::abs(model.state().largestByTemperature.value_or(0.0) - 0.001173) < 1e-6);
        model.addFiles({publicMeasurement("b02_x")});
        QVERIFY(model.record().corrections == CorrectionsBefore{});
        model.undo();
        QVERIFY(model.record().corrections == corrections);
        model.removeFile(0);
        QVERIFY(model.record().corrections == CorrectionsBefore{});
    }

    void airOfTheDeadPathFollowsTheDirections()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("bifrost")});
        QVERIFY(settled(model));
        CorrectionsBefore corrections;
        corrections.deadPath = DeadPathCorrection{100.0, {}, {}};
        corrections.deadPath->duringRun[{Approach::Up, 2}] = {101.0, 21.0, 40.0};
        model.setCorrections(corrections);
        model.setDirectionsSwapped(true);
        const auto& air = model.record().corrections.deadPath->duringRun;
        QCOMPARE(air.size(), std::size_t{1});
        QVERIFY(air.contains({Approach::Down, 2}));
        QVERIFY(settled(model)); // the air of the other runs is not known
        QVERIFY(model.state().refusal && !model.state().judgement);
        model.undo();
        QVERIFY(model.record().corrections == corrections);
    }

    void everyStepIsUndoneAndDoneAgain()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("ess_mcu1025")});
        QVERIFY(settled(model));
        std::vector<Record> records{model.record()};
        const auto note = [&] { records.push_back(model.record()); };
        model.exclude({firstOutlier});
        note();
        model.setDirectionsSwapped(true);
        note();
        model.setTolerance(Iso230Figure::A, 0.01);
        note();
        model.setUncertainty(0.002);
        note();
        model.setOutlierRule(OutlierRule::Grubbs);
        note();
        CorrectionsBefore corrections;
        corrections.temperature = TemperatureCorrection{22.5, 11.5e-6};
        model.setCorrections(corrections);
        note();
        MeasurementChoices stated;
        stated.unit = "mm";
        model.setChoices(0, stated);
        note();
        model.addFiles({publicMeasurement("b02_x")});
        note();
        model.removeFile(0);
        note();
        QCOMPARE(model.undoText(), QStringLiteral("Remove ess_mcu1025.csv"));
        QVERIFY(model.redoText().isEmpty());
        for (std::size_t n = records.size() - 1; n > 0; --n) {
            QVERIFY(!(records[n] == records[n - 1]));
            model.undo();
            QVERIFY(model.record() == records[n - 1]);
        }
        QCOMPARE(model.redoText(), QStringLiteral("Exclude (1)"));
        for (std::size_t n = 1; n < records.size(); ++n) {
            model.redo();
            QVERIFY(model.record() == records[n]);
        }
    }

    /// It would be in the unit of the one before.
    void nothingIsSaidOfAMeasurementThatIsBeingRead()
    {
        QTemporaryDir folder;
        const QString angle = folder.filePath(QStringLiteral("angle.csv"));
        QFile file(angle);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("target [deg],direction,run,deviation [arcsec]\n"
                   "0,+,1,1\n90,+,1,2\n0,-,1,1\n90,-,1,2\n");
        file.close();
        RecordModel model;
        LimitFields fields(model);
        const auto* accuracy = fields.findChild<QLineEdit*>(QStringLiteral("toleranceA"));
        QVERIFY(accuracy);
        model.addFiles({angle});
        QVERIFY(settled(model));
        QVERIFY(model.state().measurement && model.state().measurement->isAngular);
        QVERIFY(accuracy->isEnabled());
        Record next;
        next.files = {{publicMeasurement("b02_x"), {}}};
        model.open(next);
        QVERIFY(model.state().measurement && !model.isMeasurementShown());
        QVERIFY(!accuracy->isEnabled());
        FitChoices choices = model.fitChoices();
        QVERIFY(!choices.areLengthsAngles);
        choices.settings.zero = FitZero::Position;
        choices.settings.zeroPosition = {90.0};
        model.setFit(choices, {});
        QVERIFY(!model.record().fit.areLengthsAngles);
        model.setTolerance(Iso230Figure::A, 0.01);
        QVERIFY(!model.record().areLimitsAngles);
        QVERIFY(settled(model));
        QVERIFY(accuracy->isEnabled());
        QVERIFY(!accuracy->text().isEmpty());
        QCOMPARE(model.fitChoices().settings.zeroPosition, std::vector<double>{90.0});
    }

    void nothingIsAStepThatChangesNothing()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("b02_x")});
        QVERIFY(settled(model));
        const QString text = model.undoText();
        QSignalSpy changes(&model, &RecordModel::changed);
        model.addFiles({publicMeasurement("b02_x")});
        model.setDirectionsSwapped(false);
        model.setTolerance(Iso230Figure::A, std::nullopt);
        model.setUncertainty(std::nullopt);
        model.setChoices(0, {});
        model.useAgain({firstOutlier});
        model.exclude({});
        QCOMPARE(changes.size(), 0);
        QCOMPARE(model.undoText(), text);
    }

    void twoHundredStepsAreKept()
    {
        RecordModel model;
        for (int n = 1; n <= RecordModel::mostSteps + 10; ++n)
            model.setUncertainty(n * 0.001);
        int steps = 0;
        while (!model.undoText().isEmpty()) {
            model.undo();
            ++steps;
        }
        QCOMPARE(steps, RecordModel::mostSteps);
        QCOMPARE(model.record().uncertainty, std::optional(0.01));
    }

    void ofARunThatWasLeftOutTheOtherValuesStayLeftOut()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("ess_mcu1025")});
        model.exclude({{Approach::Down, std::nullopt, 1}});
        QVERIFY(settled(model));
        QCOMPARE(leftOut(model), std::size_t{5}); // of five targets
        model.useAgain({{Approach::Down, 3, 1}});
        QVERIFY(settled(model));
        QCOMPARE(leftOut(model), std::size_t{4});
        for (const RunValue& value : model.state().measurement->values)
            if (value.direction == Approach::Down && value.run == 1)
                QCOMPARE(value.isUsed, value.target == 2);
    }

    void exchangingDirectionsTakesWhatIsLeftOutAlong()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("ess_mcu1025")});
        model.exclude({firstOutlier, secondOutlier});
        QVERIFY(settled(model));
        const double before = figureOf(model, Iso230Figure::A);
        model.setDirectionsSwapped(true);
        QVERIFY(settled(model));
        QCOMPARE(leftOut(model), std::size_t{2});
        QVERIFY(std::abs(figureOf(model, Iso230Figure::A) - before) < 1e-12);
        QCOMPARE(model.record().exclusions[0].direction, std::optional(Approach::Up));
    }

    void otherFilesUseEverythingAgain()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("ess_mcu1025")});
        model.exclude({firstOutlier});
        QVERIFY(settled(model));
        model.addFiles({publicMeasurement("b02_x")});
        QVERIFY(model.record().exclusions.empty());
        model.undo();
        QCOMPARE(model.record().exclusions.size(), std::size_t{1});
    }

    void theNextMeasurementStartsAnew()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("ess_mcu1025")});
        model.setDirectionsSwapped(true);
        FitChoices fit = model.record().fit;
        fit.onto = FitChoices::Onto::File;
        fit.ontoFile = QStringLiteral("/old.csv");
        model.setFit(fit, QStringLiteral("onto"));
        model.addFiles({publicMeasurement("b02_x")});
        model.removeFile(0);
        QVERIFY(model.record().swapsDirections); // the measurement has a file yet
        QCOMPARE(model.record().fit.ontoFile, QStringLiteral("/old.csv"));
        model.removeFile(0);
        model.addFiles({publicMeasurement("bifrost")});
        QVERIFY(!model.record().swapsDirections);
        QVERIFY(model.record().fit.onto == FitChoices::Onto::Nothing);
        QVERIFY(model.record().fit.ontoFile.isEmpty());
        model.undo();
        model.undo();
        QVERIFY(model.record().swapsDirections);
        QCOMPARE(model.record().fit.ontoFile, QStringLiteral("/old.csv"));
    }

    void aFileThatIsNoMeasurementSaysWhyAndLeavesNothingToJudge()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("bad.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("target [mm],direction,run,deviation [um]\n0,+,1,0.2\n1,sideways,1,0.3\n");
        file.close();
        RecordModel model;
        model.addFiles({publicMeasurement("b02_x"), path});
        QVERIFY(settled(model));
        QVERIFY(!model.state().measurement && !model.state().judgement);
        QCOMPARE(model.state().files.size(), std::size_t{2});
        QVERIFY(!model.state().files[0].refusal);
        QVERIFY(model.state().files[1].refusal);
        QVERIFY(std::ranges::any_of(
            model.state().files[1].reading->diagnostics, [](const Diagnostic& diagnostic) {
                return diagnostic.code == DiagnosticCode::BadDirection && diagnostic.line == 3;
            }));
    }

    void aFileIsReadOnceUntilItChanges()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("runs.csv"));
        QVERIFY(QFile::copy(publicMeasurement("b02_x"), path));
        QVERIFY(QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner));
        RecordModel model;
        model.addFiles({path});
        QVERIFY(settled(model));
        const auto first = model.state().files[0].reading;
        model.setTolerance(Iso230Figure::A, 0.01);
        QVERIFY(settled(model));
        QCOMPARE(model.state().files[0].reading, first);
        QFile file(path);
        QVERIFY(file.open(QIODevice::Append));
        file.write("0,+,99,0.001\n");
        file.close();
        model.readAgain();
        QVERIFY(settled(model));
        QVERIFY(model.state().files[0].reading != first);
    }

    /// A target and a run would name other values, and nobody would see it.
    void whatWasLeftOutIsUsedAgainWhenItsFileHasChanged_data()
    {
        QTest::addColumn<QByteArray>("now");
        QTest::addColumn<bool>("isLost");
        QTest::newRow("another value") << QByteArray("0,+,1,1\n10,+,1,25\n") << true;
        QTest::newRow("a target before it") << QByteArray("-5,+,1,1\n0,+,1,1\n10,+,1,2\n") << true;
        QTest::newRow("at another target") << QByteArray("0,+,1,1\n20,+,1,2\n") << true;
        QTest::newRow("it has grown, as while values are captured")
            << QByteArray("0,+,1,1\n10,+,1,2\n0,-,1,3\n20,+,1,4\n") << false;
    }
    void whatWasLeftOutIsUsedAgainWhenItsFileHasChanged()
    {
        QFETCH(QByteArray, now);
        QFETCH(bool, isLost);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("runs.csv"));
        const auto put = [&path](const QByteArray& lines) {
            QFile file(path);
            return file.open(QIODevice::WriteOnly)
                && file.write("target [mm],direction,run,deviation [um]\n" + lines) > 0;
        };
        QVERIFY(put("0,+,1,1\n10,+,1,2\n"));
        RecordModel model;
        model.addFiles({path});
        model.exclude({{Approach::Up, 2, 1}});
        QVERIFY(settled(model));
        QCOMPARE(model.state().excludedCount, std::size_t{1});
        QSignalSpy told(&model, &RecordModel::filesChanged);
        QVERIFY(put(now));
        model.readAgain();
        QVERIFY(settled(model));
        QCOMPARE(model.record().exclusions.empty(), isLost);
        QCOMPARE(told.size(), isLost ? 1 : 0);
        QCOMPARE(model.state().excludedCount, isLost ? std::size_t{0} : std::size_t{1});
        if (!isLost)
            return;
        QCOMPARE(model.undoText(), QStringLiteral("runs.csv changed on disk"));
        model.undo();
        QCOMPARE(model.record().exclusions.size(), std::size_t{1});
    }

    void whatWasLeftOutDoesNotComeBackToAFileThatHasChangedSince_data()
    {
        QTest::addColumn<bool>("isRemoved");
        QTest::addColumn<QByteArray>("now");
        QTest::addColumn<bool>("isLost");
        const QByteArray another("0,+,1,1\n10,+,1,25\n");
        const QByteArray grown("0,+,1,1\n10,+,1,2\n20,+,1,4\n");
        QTest::newRow("removed, another value") << true << another << true;
        QTest::newRow("removed, grown") << true << grown << false;
        QTest::newRow("undone, another value") << false << another << true;
        QTest::newRow("undone, grown") << false << grown << false;
    }
    void whatWasLeftOutDoesNotComeBackToAFileThatHasChangedSince()
    {
        QFETCH(bool, isRemoved);
        QFETCH(QByteArray, now);
        QFETCH(bool, isLost);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("runs.csv"));
        const auto put = [&path](const QByteArray& lines) {
            QFile file(path);
            return file.open(QIODevice::WriteOnly)
                && file.write("target [mm],direction,run,deviation [um]\n" + lines) > 0;
        };
        QVERIFY(put("0,+,1,1\n10,+,1,2\n"));
        RecordModel model;
        model.addFiles({path});
        QVERIFY(settled(model));
        model.exclude({{Approach::Up, 2, 1}});
        QVERIFY(settled(model));
        QSignalSpy told(&model, &RecordModel::filesChanged);
        if (isRemoved)
            model.removeFile(0);
        else
            model.undo();
        QVERIFY(settled(model));
        QVERIFY(put(now));
        if (!isRemoved)
            model.readAgain();
        QVERIFY(settled(model));
        if (isRemoved)
            model.undo();
        else
            model.redo();
        QVERIFY(settled(model));
        QCOMPARE(model.record().files.size(), std::size_t{1});
        QCOMPARE(model.record().exclusions.empty(), isLost);
        QCOMPARE(model.state().excludedCount, isLost ? std::size_t{0} : std::size_t{1});
        QCOMPARE(told.size(), isRemoved && isLost ? 1 : 0);
        if (isLost && !isRemoved)
            QVERIFY(model.redoText().isEmpty() && model.undoText().isEmpty());
    }
};

AXISCOMP_WINDOW_TEST(TestRecordModel)

} // namespace tst_recordmodel

#include "tst_recordmodel.moc"
