// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/patience.h"
#include "tests/support/verify.h"
#include "tests/ui/support/record_files.h"
#include "tests/ui/support/settled_record.h"
#include "tests/ui/support/window_test.h"
#include "ui/record/comparison_model.h"
#include "ui/record/record_file.h"
#include "ui/record/record_model.h"
#include "ui/record/record_recovery.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace tst_recordfile {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::publicMeasurement;

namespace {

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString& path, const QByteArray& content)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("cannot write %s", qPrintable(path));
}

/// A record in the window, without the window.
struct Bench {
    explicit Bench(const QString& store = {})
        : after(RecordModel::HistoryOf{record})
        , file(record, after)
        , recovery(file, (store.isEmpty() ? path(QStringLiteral("store")) : store).toStdString())
    {
        QObject::connect(&file, &RecordFile::obstructed, &file,
            [this](const QString&, RecordFile::Obstacle found) { obstacle = found; });
        for (const auto failure : {&RecordFile::openFailed, &RecordFile::saveFailed})
            QObject::connect(&file, failure, &file,
                [this](const Error& error) { problem = QString::fromStdString(sentence(error)); });
    }

    [[nodiscard]] QString path(const QString& name) const { return folder.filePath(name); }
    [[nodiscard]] QString saved(const QString& name, const CalibrationRecord& content) const
    {
        put(path(name), QByteArray::fromStdString(recordText(content)));
        return path(name);
    }
    [[nodiscard]] bool settled()
    {
        return QTest::qWaitFor(
            [this] { return !file.isBusy() && !record.isEvaluating() && !after.isEvaluating(); },
            test::patienceMs);
    }
    [[nodiscard]] bool open(const QString& name)
    {
        file.open(name);
        return settled() && problem.isEmpty();
    }
    [[nodiscard]] bool save(const QString& name, bool overwrites = false)
    {
        QSignalSpy isSaved(&file, &RecordFile::saved);
        obstacle.reset();
        file.save(name, overwrites);
        return QTest::qWaitFor([&] { return !isSaved.isEmpty() || obstacle || !problem.isEmpty(); },
                   test::patienceMs)
            && !isSaved.isEmpty();
    }

    QTemporaryDir folder;
    RecordModel record;
    RecordModel after;
    RecordFile file;
    RecordRecovery recovery;
    std::optional<RecordFile::Obstacle> obstacle;
    QString problem;
};

/// Written, proved, measured twice, judged, and worked on since.
CalibrationRecord withEverything()
{
    CalibrationRecord record = test::recordOfFit();
    record.before->corrections.temperature =
        TemperatureCorrection{20.9, 11.5e-6, 20.1, 1e-7, 5.0, true};
    record.drive = RecordedDrive{"Triamec-616", 1559, "generic", 1, "X", {}};
    record.write = RecordedWrite{*record.time, "Small1", true, record.tables.front().crc,
        RecordedWrite::Proof{true, 100, 1e-9, 2e-9, 0.75}};
    RecordedAfter after{*record.before, record.prediction->predicted, true};
    record.after = {after, after};
    record.verdict =
        RecordedVerdict{{{{Iso230Figure::A, 0.01}, 0.0032, 0.0021, VerdictResult::Passed}}};
    record.judging = RecordedJudging{OutlierRule::Grubbs, {{Iso230Figure::R, 0.1}}, 0.5};
    record.draft = RecordedDraft{*record.before, *record.before, true};
    record.draft->before->exclusions = {{Approach::Down, 1, 1}};
    record.draft->after->swapsDirections = true;
    record.draft->others = {{"/mood", "1"}};
    return record;
}

CalibrationRecord loaded(const QString& path)
{
    auto record = loadRecord(path.toStdString());
    if (!record)
        qFatal("%s", sentence(record.error()).c_str());
    return *std::move(record);
}

/// A measurement of an axis that turns, in place of the one there is.
void measureAnAngleInstead(Bench& bench)
{
    const QString angle = bench.path(QStringLiteral("angle.csv"));
    put(angle,
        "target [deg],direction,run,deviation [arcsec]\n0,+,1,1\n90,+,1,2\n0,-,1,2\n90,-,1,2\n");
    bench.record.removeFile(0);
    bench.record.addFiles({angle});
}

/// Until the comparison is that of the records as they are.
bool compared(Bench& bench, const ComparisonModel& comparison)
{
    return bench.settled()
        && QTest::qWaitFor([&] { return !comparison.isComparing(); }, test::patienceMs);
}

/// Of files that were kept; locks are not counted.
QStringList keptIn(const QString& folder)
{
    return QDir(folder).entryList({QStringLiteral("*.axcal")}, QDir::Files);
}

} // namespace

/// The file of a record: what is in it, and what never happens to it.
class TestRecordFile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    /// Otherwise the next save would write the new record over the file of the old one.
    void aSaveThatEndsAfterAnotherRecordWasBegunIsNotTheFileOfThat()
    {
        Bench bench;
        const QString old = bench.saved(QStringLiteral("old.axcal"), withEverything());
        QVERIFY(bench.open(old));
        const QString copy = bench.path(QStringLiteral("copy.axcal"));
        bench.file.save(copy);
        QVERIFY(bench.file.isBusy());
        bench.file.begin();
        QVERIFY(bench.settled());
        QVERIFY(QFile::exists(copy));
        QVERIFY(bench.file.path().isEmpty());
        QVERIFY(!bench.file.isModified());
    }

    void aRecordThatIsReadAfterAnotherWasBegunIsNotOpened()
    {
        Bench bench;
        const QString late = bench.saved(QStringLiteral("late.axcal"), withEverything());
        bench.file.open(late);
        bench.file.begin();
        QVERIFY(bench.settled());
        QVERIFY(bench.file.path().isEmpty());
        QVERIFY(bench.file.isEmpty());
    }

    void aRecordOfTheCommandLineIsShown()
    {
        Bench bench;
        CalibrationRecord record = test::recordOfFit();
        record.before->exclusions = {{Approach::Down, 1, 1}};
        record.before->swapsDirections = true;
        record.fit->settings.tolerances = {{Iso230Figure::A, 0.01}};
        record.fit->settings.uncertainty = 0.002;
        QVERIFY(bench.open(bench.saved(QStringLiteral("x.axcal"), record)));
        QCOMPARE(bench.file.name(), QStringLiteral("x.axcal"));
        QVERIFY(!bench.file.isModified());
        const Record& shown = bench.record.record();
        QCOMPARE(shown.files.size(), std::size_t{1});
        QCOMPARE(shown.files.front().path, QStringLiteral("b02_x.csv"));
        QVERIFY(shown.exclusions == record.before->exclusions && shown.swapsDirections);
        QVERIFY(shown.tolerances == record.fit->settings.tolerances);
        QCOMPARE(shown.uncertainty, std::optional(0.002));
        QVERIFY(shown.calibration);
        QCOMPARE(shown.calibration->tables.front().crc, record.tables.front().crc);
        // The values are those of the record: the file that it was read from is not there.
        QVERIFY(bench.record.state().measurement);
        QCOMPARE(bench.record.state().excludedCount, std::size_t{1});
        QVERIFY(bench.record.undoText().isEmpty());
    }

    void theTableOfARecordIsMadeAgainAsItWas()
    {
        Bench bench;
        CalibrationRecord record = test::recordOfFit();
        record.fit->settings.mostPoints = 1000;
        record.fit->settings.tolerances = {{Iso230Figure::A, 0.01}};
        QVERIFY(bench.open(bench.saved(QStringLiteral("x.axcal"), record)));
        FitChoices choices = bench.record.record().fit;
        QVERIFY(choices.settings.zero == FitZero::Keep);
        // What other parts of the page say is not said twice, and what is asked for is asked again.
        QVERIFY(choices.settings.tolerances.empty());
        QCOMPARE(choices.settings.mostPoints, FitSettings{}.mostPoints);
        QVERIFY(choices.measuredWith == FitChoices::MeasuredWith::NotSaid);
        QVERIFY(!choices.settings.lookupAt);
        choices.settings.lookupAt = LookupAt::Encoder;
        choices.measuredWith = FitChoices::MeasuredWith::Off;
        bench.record.setFit(choices, {});
        QVERIFY(test::settled(bench.record));
        const auto& fit = bench.record.state().fit;
        QVERIFY(fit && fit->report);
        QCOMPARE(fit->crcs.front(), record.tables.front().crc);
    }

    void whatIsOpenedAndSavedIsTheSameByteForByte_data()
    {
        QTest::addColumn<bool>("hasEverything");
        QTest::newRow("begun by fit") << false;
        QTest::newRow("with every member that there is") << true;
    }
    void whatIsOpenedAndSavedIsTheSameByteForByte()
    {
        QFETCH(bool, hasEverything);
        Bench bench;
        CalibrationRecord record = hasEverything ? withEverything() : test::recordOfFit();
        record.others = {{"/later", "{\"kept\":[1,2]}"}};
        const QString path = bench.saved(QStringLiteral("x.axcal"), record);
        const QByteArray content = contentOf(path);
        QVERIFY(bench.open(path));
        QVERIFY(bench.save(path));
        QCOMPARE(contentOf(path), content);
        const QString other = bench.path(QStringLiteral("y.axcal"));
        QVERIFY(bench.save(other));
        QCOMPARE(contentOf(other), content);
        // Done and undone is not done.
        bench.record.setTolerance(Iso230Figure::E, 0.5);
        QVERIFY(bench.file.isModified());
        bench.record.undo();
        QVERIFY(!bench.file.isModified());
        QVERIFY(bench.save(bench.path(QStringLiteral("z.axcal"))));
        QCOMPARE(contentOf(bench.path(QStringLiteral("z.axcal"))), content);
    }

    void aMeasurementWithoutATableIsSavedAndReadBack()
    {
        Bench bench;
        bench.record.addFiles({publicMeasurement("ess_mcu1025")});
        bench.record.exclude({{Approach::Down, 1, 1}, {Approach::Down, 2, 1}});
        bench.record.setTolerance(Iso230Figure::A, 0.1);
        bench.record.setUncertainty(0.001);
        bench.record.setOutlierRule(OutlierRule::Grubbs);
        QVERIFY(bench.file.isModified());
        const QString path = bench.path(QStringLiteral("new.axcal"));
        QVERIFY(bench.save(path)); // it waits until the file is read
        QVERIFY(!bench.file.isModified());
        const CalibrationRecord saved = loaded(path);
        QVERIFY(saved.before && saved.tables.empty() && !saved.fit && !saved.draft);
        const RecordedFile& file = saved.before->files.front();
        QCOMPARE(file.file, std::string("ess_mcu1025.csv"));
        QCOMPARE(file.format, std::string("runs"));
        // sha256sum tests/data/metrology/ess_mcu1025.csv
        const QByteArray digest = QCryptographicHash::hash(
            contentOf(publicMeasurement("ess_mcu1025")), QCryptographicHash::Sha256);
        QCOMPARE(QByteArray::fromStdString(file.sha256), digest.toHex());
        QCOMPARE(saved.before->exclusions.size(), std::size_t{2});
        const auto used = usedMeasurement(*saved.before);
        VERIFY_RESULT(used);
        QVERIFY(std::abs(*iso230Figures(*used)[Iso230Figure::A].value - 0.0892653) < 1e-6);
        Bench again;
        QVERIFY(again.open(path));
        QCOMPARE(again.record.record().exclusions.size(), std::size_t{2});
        QVERIFY(again.record.record().tolerances == bench.record.record().tolerances);
        QCOMPARE(again.record.record().uncertainty, std::optional(0.001));
        QCOMPARE(again.record.record().outlierRule, OutlierRule::Grubbs);
        QVERIFY(!again.record.record().calibration);
    }

    void aMeasurementThatWasReadAgainIsNotTheOneThatWasSaved()
    {
        Bench bench;
        const QString runs = bench.path(QStringLiteral("runs.csv"));
        put(runs, "target [mm],direction,run,deviation [um]\n0,+,1,1\n10,+,1,2\n");
        bench.record.addFiles({runs});
        const QString path = bench.path(QStringLiteral("x.axcal"));
        QVERIFY(bench.save(path));
        QVERIFY(!bench.file.isModified());
        put(runs, "target [mm],direction,run,deviation [um]\n0,+,1,1\n10,+,1,25\n");
        QSignalSpy changed(&bench.file, &RecordFile::changed);
        bench.record.readAgain();
        QVERIFY(bench.settled());
        QVERIFY(bench.file.isModified() && !changed.isEmpty());
        QVERIFY(bench.save(path));
        QVERIFY(!bench.file.isModified());
        const auto used = usedMeasurement(*loaded(path).before);
        VERIFY_RESULT(used);
        QCOMPARE(used->values.back().deviation, 0.025);
        // A file that is gone is no other measurement.
        QVERIFY(QFile::remove(runs));
        bench.record.readAgain();
        QVERIFY(bench.settled());
        QVERIFY(!bench.file.isModified());
    }

    void whatTheTableWasMadeOfStaysWhenTheMeasurementIsChosenOtherwise()
    {
        Bench bench;
        const QString path = bench.saved(QStringLiteral("x.axcal"), test::recordOfFit());
        QVERIFY(bench.open(path));
        bench.record.exclude({{Approach::Up, 3, 2}});
        QVERIFY(bench.save(path));
        const CalibrationRecord saved = loaded(path);
        QVERIFY(saved.before->exclusions.empty());
        QVERIFY(saved.draft && saved.draft->before);
        QCOMPARE(saved.draft->before->exclusions.size(), std::size_t{1});
        Bench again;
        QVERIFY(again.open(path));
        QVERIFY(again.record.record() == bench.record.record()
            || again.record.record().exclusions == bench.record.record().exclusions);
        QCOMPARE(again.record.state().excludedCount, std::size_t{1});
        again.record.useAgain({{Approach::Up, 3, 2}});
        QVERIFY(again.save(path));
        QVERIFY(!loaded(path).draft);
    }

    void aSecondMeasurementThatIsNotKeptIsThereAgain()
    {
        Bench bench;
        const QString path = bench.saved(QStringLiteral("x.axcal"), test::recordOfFit());
        QVERIFY(bench.open(path));
        const QString after = bench.path(QStringLiteral("after.csv"));
        put(after, test::goodAfterMeasurement({}));
        bench.after.addFiles({after});
        const std::uint32_t crc = bench.record.record().calibration->tables.front().crc;
        bench.after.setStatedTable(crc);
        QVERIFY(bench.file.isModified());
        QVERIFY(bench.save(path));
        QVERIFY(loaded(path).after.empty());
        Bench again;
        QVERIFY(again.open(path));
        QCOMPARE(again.after.record().files.size(), std::size_t{1});
        QCOMPARE(again.after.record().statedTable, std::optional(crc));
        QCOMPARE(again.after.state().upRunNumbers.size(), std::size_t{2});
        // Of another file it is to be said anew.
        again.after.addFiles({publicMeasurement("b02_x")});
        QVERIFY(!again.after.record().statedTable);
    }

    /// Otherwise a table that was never written would be within the tolerances.
    void whatIsSaidOfATableIsNotSaidOfAnother()
    {
        Bench bench;
        const CalibrationRecord record = test::recordOfFit();
        QVERIFY(bench.open(bench.saved(QStringLiteral("x.axcal"), record)));
        const QString after = bench.path(QStringLiteral("after.csv"));
        put(after, test::goodAfterMeasurement({}));
        ComparisonModel comparison(bench.record, bench.after);
        bench.after.addFiles({after});
        bench.after.setStatedTable(record.tables.front().crc);
        QVERIFY(compared(bench, comparison));
        QVERIFY(comparison.state().comparison);
        const auto other = std::make_shared<const CalibrationRecord>(test::recordOfFit("b02_y"));
        QVERIFY(other->tables.front().crc != record.tables.front().crc);
        bench.record.setCalibration(other);
        QVERIFY(compared(bench, comparison));
        QVERIFY(!comparison.state().comparison && comparison.state().needsStatement);
        QVERIFY(comparison.state().refusal);
        QCOMPARE(comparison.state().refusal->code, ErrorCode::MeasurementState);
        const QString path = bench.path(QStringLiteral("y.axcal"));
        QVERIFY(bench.save(path));
        QVERIFY(loaded(path).draft && loaded(path).draft->after);
        QVERIFY(!loaded(path).draft->isTableStated);
        // It was said of the first one, and holds for that.
        bench.record.undo();
        QVERIFY(compared(bench, comparison));
        QVERIFY(comparison.state().comparison);
    }

    void membersOfLaterVersionsAreKept()
    {
        Bench bench;
        CalibrationRecord record = test::recordOfFit();
        record.others = {{"/later", "7"}};
        record.before->others = {{"/operatorMood", "\"good\""}};
        record.before->files.front().others = {{"/camera", "true"}};
        record.before->corrections.drift = DriftRemoval::Offset;
        const QString path = bench.saved(QStringLiteral("x.axcal"), record);
        QVERIFY(bench.open(path));
        bench.record.setTolerance(Iso230Figure::A, 0.2);
        QVERIFY(bench.save(path));
        const CalibrationRecord saved = loaded(path);
        QVERIFY(saved.others == record.others);
        QVERIFY(saved.before->others == record.before->others);
        QVERIFY(saved.before->corrections == record.before->corrections && !saved.draft);
        QVERIFY(saved.before->files.front().others == record.before->files.front().others);
        QVERIFY(saved.judging && saved.judging->tolerances.size() == 1);
    }

    void limitsOfALengthDoNotComeBackAsThoseOfAnAngle_data()
    {
        QTest::addColumn<bool>("hasTable");
        QTest::newRow("of a measurement") << false;
        QTest::newRow("of a table, which keeps them") << true;
    }
    void limitsOfALengthDoNotComeBackAsThoseOfAnAngle()
    {
        QFETCH(bool, hasTable);
        Bench bench;
        const QString path = bench.path(QStringLiteral("x.axcal"));
        if (hasTable)
            QVERIFY(bench.open(bench.saved(QStringLiteral("x.axcal"), test::recordOfFit())));
        else
            bench.record.addFiles({publicMeasurement("b02_x")});
        QVERIFY(bench.settled());
        bench.record.setTolerance(Iso230Figure::A, 0.01);
        bench.record.setUncertainty(0.001);
        measureAnAngleInstead(bench);
        QVERIFY(bench.save(path));
        const RecordedJudging judging = judgingOf(loaded(path));
        QCOMPARE(judging.tolerances.size(), hasTable ? std::size_t{1} : std::size_t{0});
        QCOMPARE(judging.uncertainty.has_value(), hasTable);
        Bench again;
        QVERIFY(again.open(path));
        const RecordState& state = again.record.state();
        QVERIFY(state.measurement && state.measurement->isAngular && state.judgement);
        QVERIFY(state.judgement->verdicts.empty());
    }

    void aLimitOfAnAngleIsNoVerdictOfATableOfALength()
    {
        Bench bench;
        CalibrationRecord record = test::recordOfFit();
        record.verdict =
            RecordedVerdict{{{{Iso230Figure::A, 0.01}, 0.0032, 0.0021, VerdictResult::Passed}}};
        const QString path = bench.saved(QStringLiteral("x.axcal"), record);
        QVERIFY(bench.open(path));
        measureAnAngleInstead(bench);
        QVERIFY(bench.settled());
        bench.record.setTolerance(Iso230Figure::A, 0.003);
        QVERIFY(bench.save(path));
        const CalibrationRecord saved = loaded(path);
        QVERIFY(!saved.before->files.front().measurement.isAngular);
        QVERIFY(saved.verdict && saved.verdict->figures.empty());
        QVERIFY(judgingOf(saved).tolerances.empty());
    }

    void whatSomebodyElseHasPutThereIsNotWrittenOver()
    {
        Bench bench;
        const QString path = bench.saved(QStringLiteral("x.axcal"), test::recordOfFit());
        QVERIFY(bench.open(path));
        bench.record.setTolerance(Iso230Figure::A, 0.2);
        const QByteArray others = contentOf(path) + "\n";
        put(path, others);
        QVERIFY(!bench.save(path));
        QCOMPARE(bench.obstacle, std::optional(RecordFile::Obstacle::Changed));
        QCOMPARE(contentOf(path), others);
        QVERIFY(bench.file.isModified());
        QVERIFY(bench.save(path, true));
        QVERIFY(loaded(path).judging);
        const QString stranger = bench.path(QStringLiteral("photo.axcal"));
        put(stranger, "not a record");
        QVERIFY(!bench.save(stranger));
        QCOMPARE(bench.obstacle, std::optional(RecordFile::Obstacle::Exists));
        QCOMPARE(contentOf(stranger), QByteArray("not a record"));
        QCOMPARE(bench.file.path(), path);
    }

    /// "Saved" is said of what is in the file.
    void aRecordThatWasNotChangedIsNotSavedWhereSomebodyElseHasPutSomething()
    {
        Bench bench;
        const QString path = bench.saved(QStringLiteral("x.axcal"), test::recordOfFit());
        QVERIFY(bench.open(path));
        const QByteArray mine = contentOf(path);
        QVERIFY(bench.save(path));
        QCOMPARE(contentOf(path), mine);
        put(path, "of another program");
        QVERIFY(!bench.save(path));
        QCOMPARE(bench.obstacle, std::optional(RecordFile::Obstacle::Changed));
        QCOMPARE(contentOf(path), QByteArray("of another program"));
        QVERIFY(bench.save(path, true));
        QCOMPARE(contentOf(path), mine);
    }

    void theHistoryOfAnotherTableIsNotLostWithoutAsking()
    {
        Bench bench;
        CalibrationRecord record = test::recordOfFit();
        record.write = RecordedWrite{*record.time, "Small1", true, record.tables.front().crc};
        const QString path = bench.saved(QStringLiteral("x.axcal"), record);
        QVERIFY(bench.open(path));
        bench.record.setCalibration(
            std::make_shared<const CalibrationRecord>(test::recordOfFit("b02_y")));
        QVERIFY(!bench.save(path));
        QCOMPARE(bench.obstacle, std::optional(RecordFile::Obstacle::OtherTable));
        QCOMPARE(loaded(path).tables.front().crc, record.tables.front().crc);
    }

    void theHistoryOfTheTableItselfIsNotLostWithoutAsking()
    {
        Bench bench;
        CalibrationRecord record = test::recordOfFit();
        record.write = RecordedWrite{*record.time, "Small1", true, record.tables.front().crc};
        const QString path = bench.saved(QStringLiteral("x.axcal"), record);
        QVERIFY(bench.open(path));
        bench.record.setCalibration(std::make_shared<const CalibrationRecord>(test::recordOfFit()));
        QVERIFY(!bench.save(path));
        QCOMPARE(bench.obstacle, std::optional(RecordFile::Obstacle::OtherTable));
        QVERIFY(loaded(path).write.has_value());
    }

    /// The same values, which have the same CRC-32.
    void theTableIsAnotherOneOverOtherPositionsOrInAnotherUnit()
    {
        for (const bool isMoved : {true, false}) {
            Bench bench;
            CalibrationRecord record = test::recordOfFit();
            record.write = RecordedWrite{*record.time, "Small1", true, record.tables.front().crc};
            const QString path = bench.saved(QStringLiteral("x.axcal"), record);
            QVERIFY(bench.open(path));
            CalibrationRecord other = test::recordOfFit();
            CompensationTable& table = other.tables.front().table;
            if (isMoved)
                table.grid.axes.front().start += 5.0;
            else
                table.unit = "um";
            bench.record.setCalibration(std::make_shared<const CalibrationRecord>(other));
            QVERIFY(!bench.save(path));
            QCOMPARE(bench.obstacle, std::optional(RecordFile::Obstacle::OtherTable));
        }
    }

    void whatCannotBeReadLeavesTheRecordAsItIs_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("words");
        QTest::newRow("newer") << QByteArray("{\"format\":\"axiscomp-record\",\"version\":2}")
                               << QStringLiteral("version 2");
        QTest::newRow("damaged") << QByteArray("{\"format\":\"axiscomp-record\",\"vers")
                                 << QStringLiteral("bad.axcal");
        QTest::newRow("another file")
            << QByteArray("target,direction\n") << QStringLiteral("bad.axcal");
    }
    void whatCannotBeReadLeavesTheRecordAsItIs()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, words);
        Bench bench;
        bench.record.addFiles({publicMeasurement("b02_x")});
        const Record before = bench.record.record();
        put(bench.path(QStringLiteral("bad.axcal")), content);
        QVERIFY(!bench.open(bench.path(QStringLiteral("bad.axcal"))));
        QVERIFY2(bench.problem.contains(words), qPrintable(bench.problem));
        QVERIFY(bench.record.record() == before && bench.file.path().isEmpty());
        QCOMPARE(contentOf(bench.path(QStringLiteral("bad.axcal"))), content);
    }

    void aFileThatCannotBeUsedIsNotSavedInSilence()
    {
        Bench bench;
        bench.record.addFiles({publicMeasurement("b02_x")});
        put(bench.path(QStringLiteral("no.csv")), "no,measurement\n1,2\n");
        bench.record.addFiles({bench.path(QStringLiteral("no.csv"))});
        QVERIFY(!bench.save(bench.path(QStringLiteral("x.axcal"))));
        QVERIFY2(bench.problem.contains(QStringLiteral("no.csv")), qPrintable(bench.problem));
        QVERIFY(!QFile::exists(bench.path(QStringLiteral("x.axcal"))));
        QVERIFY(bench.file.isModified());
    }

    void aTableThatWasWrittenStaysSoWhenStepsAreUndone()
    {
        Bench bench;
        QVERIFY(bench.open(bench.saved(QStringLiteral("x.axcal"), test::recordOfFit())));
        bench.record.setTolerance(Iso230Figure::A, 0.01);
        bench.record.note([](const std::shared_ptr<const CalibrationRecord>& known) {
            auto noted = std::make_shared<CalibrationRecord>(*known);
            noted->write = RecordedWrite{*known->time, "Small1", true, known->tables.front().crc};
            return std::shared_ptr<const CalibrationRecord>(noted);
        });
        QVERIFY(bench.record.record().calibration->write);
        bench.record.undo();
        QVERIFY(bench.record.record().calibration->write);
        QVERIFY(bench.file.isModified());
    }

    void oneStackOfStepsHasBothMeasurements()
    {
        Bench bench;
        bench.record.addFiles({publicMeasurement("b02_x")});
        bench.after.addFiles({publicMeasurement("b02_y")});
        QCOMPARE(bench.record.undoText(), QStringLiteral("Add b02_y.csv"));
        bench.record.undo();
        QVERIFY(bench.after.record().files.empty());
        bench.after.undo();
        QVERIFY(bench.record.record().files.empty());
        bench.record.redo();
        bench.record.redo();
        QCOMPARE(bench.after.record().files.size(), std::size_t{1});
    }

    void unsavedChangesAreThereAfterACrash()
    {
        const QTemporaryDir folder;
        const QString kept = folder.filePath(QStringLiteral("kept"));
        const QString left = folder.filePath(QStringLiteral("left"));
        {
            Bench crashed(kept);
            const QString path = folder.filePath(QStringLiteral("x.axcal"));
            put(path, QByteArray::fromStdString(recordText(test::recordOfFit())));
            QVERIFY(crashed.open(path));
            crashed.record.setTolerance(Iso230Figure::A, 0.123);
            crashed.recovery.setInterval(std::chrono::milliseconds(10));
            QTRY_COMPARE(keptIn(kept).size(), 1);
            // What a program leaves that is killed: the file, without anybody who holds its lock.
            QVERIFY(QDir().mkpath(left));
            QVERIFY(QFile::copy(
                kept + u'/' + keptIn(kept).front(), left + QStringLiteral("/0c1f.axcal")));
            // One that runs keeps its own.
            Bench second(kept);
            QSignalSpy found(&second.recovery, &RecordRecovery::found);
            QSignalSpy looked(&second.recovery, &RecordRecovery::looked);
            second.recovery.look();
            QTRY_COMPARE(looked.size(), 1);
            QVERIFY(found.isEmpty());
            QVERIFY(crashed.save(path));
            QTRY_VERIFY(keptIn(kept).isEmpty());
        }
        Bench next(left);
        QSignalSpy found(&next.recovery, &RecordRecovery::found);
        next.recovery.look();
        QTRY_COMPARE(found.size(), 1);
        // Two windows do not take the same.
        Bench other(left);
        QSignalSpy looked(&other.recovery, &RecordRecovery::looked);
        other.recovery.look();
        QTRY_COMPARE(looked.size(), 1);
        QVERIFY(!other.recovery.waiting());
        next.recovery.take();
        QVERIFY(next.settled());
        QCOMPARE(next.file.name(), QStringLiteral("x.axcal"));
        QVERIFY(next.file.isModified());
        QCOMPARE(next.record.record().tolerances.front().value, 0.123);
        // It stays kept until it is saved, by whatever ends the program.
        QTRY_COMPARE(keptIn(left).size(), 1);
        QVERIFY(next.save(next.path(QStringLiteral("mine.axcal"))));
        QVERIFY(loaded(next.path(QStringLiteral("mine.axcal"))).others.empty());
        QTRY_VERIFY(keptIn(left).isEmpty());
    }

    void whatWasKeptStaysAtTheEndUnlessItIsNotWanted()
    {
        const QTemporaryDir folder;
        const QString kept = folder.filePath(QStringLiteral("kept"));
        for (const bool isWanted : {true, false}) {
            {
                Bench bench(kept);
                bench.record.addFiles({publicMeasurement("b02_x")});
                bench.recovery.keep();
                QTRY_COMPARE(keptIn(kept).size(), 1);
                if (!isWanted)
                    bench.recovery.end();
            }
            QCOMPARE(keptIn(kept).size(), isWanted ? 1 : 0);
            if (isWanted) {
                Bench next(kept);
                next.recovery.look();
                QTRY_VERIFY(next.recovery.waiting());
                next.recovery.discard();
                QTRY_VERIFY(keptIn(kept).isEmpty());
            }
        }
        {
            Bench clean(kept);
            clean.recovery.keep();
        }
        QVERIFY(keptIn(kept).isEmpty());
    }
};

AXISCOMP_WINDOW_TEST(TestRecordFile)

} // namespace tst_recordfile

#include "tst_recordfile.moc"
