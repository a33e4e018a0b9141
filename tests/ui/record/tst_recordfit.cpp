// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/fit_record.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/support/compensator_fixture.h"
#include "tests/ui/support/measurement_files.h"
#include "tests/ui/support/settled_record.h"
#include "tests/ui/support/window_test.h"
#include "ui/record/record_model.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace tst_recordfit {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::publicMeasurement;
using test::settled;

namespace {

/// As in chapter 4.2 of the specification: encoder lookup, the zero as measured.
FitChoices asSpecified()
{
    FitChoices choices;
    choices.settings.lookupAt = LookupAt::Encoder;
    choices.settings.zero = FitZero::Keep;
    choices.measuredWith = FitChoices::MeasuredWith::Off;
    return choices;
}

bool isRefused(const RecordModel& model, ErrorCode code, const char* words)
{
    const auto& fit = model.state().fit;
    return fit && fit->refusal && !fit->report && fit->refusal->code == code
        && textOf(*fit->refusal).english().find(words) != std::string::npos;
}

double predicted(const RecordModel& model, Iso230Figure figure)
{
    const auto& fit = model.state().fit;
    return fit && fit->report ? (*fit->report->predicted)[figure].value.value_or(std::nan(""))
                              : std::nan("");
}

bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-6;
}

FitDrive driveWith(const std::string& source)
{
    FitDrive drive;
    drive.profile = &drivecomm::genericProfile();
    AxisInfo axis;
    axis.name = "X";
    axis.unit = "Millimeter";
    drive.axis = AxisOfDrive{axis, 1559, source, {}, {}};
    return drive;
}

const std::string setPosition = "Axes[0]/Signals/PathPlanner/Position";

} // namespace

/// The table that a record comes to, and what it promises. The numbers are those of
/// docs/metrology.md, computed elsewhere.
class TestRecordFit : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    /// Neither where the table is looked up nor what was active is guessed.
    void noTableIsMadeBeforeItIsSaidWhereItIsLookedUp()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("b02_x")});
        QVERIFY(settled(model));
        QVERIFY(isRefused(model, ErrorCode::MeasurementState, "does not say whether"));
        FitChoices choices;
        choices.measuredWith = FitChoices::MeasuredWith::Off;
        model.setFit(choices, {});
        QVERIFY(settled(model));
        QVERIFY(isRefused(model, ErrorCode::InvalidArgument, "decides where its values belong"));
    }

    void theFitPromisesTheKnownFigures()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("b02_x")});
        model.setFit(asSpecified(), QStringLiteral("Zero"));
        QVERIFY(settled(model));
        QVERIFY(isNear(predicted(model, Iso230Figure::B), 0.0334657));
        QVERIFY(isNear(predicted(model, Iso230Figure::R), 0.0549840));
        QVERIFY(isNear(predicted(model, Iso230Figure::A), 0.0551810));
        QVERIFY(isNear(predicted(model, Iso230Figure::M), 0.0));
        const HeldOut& heldOut = *model.state().fit->report->heldOut;
        QVERIFY(isNear(heldOut.rms, 0.0209982) && isNear(heldOut.largest, 0.0410688));
        QVERIFY(isNear(heldOut.range, 0.0750335));
        QCOMPARE(model.undoText(), QStringLiteral("Fit: Zero"));
    }

    void whatIsLeftOutIsNotInTheTable()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("ess_mcu1025")});
        model.setFit(asSpecified(), {});
        model.exclude({{Approach::Down, 1, 1}, {Approach::Down, 2, 1}});
        QVERIFY(settled(model));
        // Of the judgement without these two values.
        const auto& before = *model.state().fit->report->before;
        QVERIFY(isNear(*before[Iso230Figure::A].value, 0.0892653));
    }

    /// Judging a million values again because of a grid would take seconds.
    void aChoiceOfTheFitJudgesNothingAgain()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("b02_x")});
        model.setFit(asSpecified(), {});
        QVERIFY(settled(model));
        const auto measurement = model.state().measurement;
        QSignalSpy states(&model, &RecordModel::stateChanged);
        FitChoices choices = asSpecified();
        choices.settings.grid = {{.points = 17}};
        model.setFit(choices, {});
        QVERIFY(model.isFitting() && !model.isEvaluating());
        QVERIFY(model.state().fit->report); // the old one stays until the new one is there
        QVERIFY(settled(model));
        QCOMPARE(states.size(), 0);
        QCOMPARE(model.state().measurement, measurement);
        QCOMPARE(model.state().fit->tables.front().table->values.size(), std::size_t{17});
        model.undo();
        QVERIFY(settled(model));
        QCOMPARE(model.state().fit->tables.front().table->values.size(), std::size_t{9});
    }

    void ofManyChoicesTheNewestIsFitted()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("b02_x")});
        FitChoices choices = asSpecified();
        for (std::size_t points = 2; points < 60; ++points) {
            choices.settings.grid = {{.points = points}};
            model.setFit(choices, {});
        }
        QVERIFY(settled(model));
        QCOMPARE(model.state().fit->tables.front().table->values.size(), std::size_t{59});
        QVERIFY(model.state().fit->request.record.fit == choices);
    }

    void lengthsOfALinearAxisAreNoneOfARotaryOne()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("b02_x")});
        QVERIFY(settled(model));
        FitChoices choices = asSpecified();
        choices.settings.zero = FitZero::Position;
        choices.settings.zeroPosition = {90.0};
        choices.settings.home = 90.0;
        choices.settings.grid = {{.distance = 45.0}};
        model.setFit(choices, {});
        QTemporaryDir folder;
        const QString angle = folder.filePath(QStringLiteral("angle.csv"));
        QFile file(angle);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("// compensation: off\ntarget [deg],direction,run,deviation [arcsec]\n"
                   "0,+,1,1\n90,+,1,2\n180,+,1,4\n0,-,1,1\n90,-,1,2\n180,-,1,4\n");
        file.close();
        while (!model.record().files.empty())
            model.removeFile(0);
        model.addFiles({angle});
        QVERIFY(settled(model));
        QVERIFY(model.fitChoices().settings.zeroPosition.empty());
        const auto& fit = model.state().fit;
        QVERIFY2(fit->report, fit->refusal ? textOf(*fit->refusal).english().c_str() : "");
        QCOMPARE(fit->tables.front().table->values.size(), std::size_t{3});
        QCOMPARE(fit->tables.front().table->values.front(), 0.0);
        // Those that are said of it are its own.
        choices = model.fitChoices();
        choices.settings.grid = {{.distance = 45.0}};
        model.setFit(choices, {});
        QVERIFY(settled(model));
        QCOMPARE(model.state().fit->tables.front().table->values.size(), std::size_t{5});
    }

    /// "Off" was said of the measurement that was there.
    void whatWasActiveIsAskedOfEveryMeasurementAnew()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("b02_x")});
        model.setFit(asSpecified(), {});
        QVERIFY(settled(model));
        QVERIFY(model.state().fit->report);
        model.removeFile(0);
        model.addFiles({publicMeasurement("b02_y")});
        QVERIFY(settled(model));
        QVERIFY(isRefused(model, ErrorCode::MeasurementState, "does not say whether"));
        QVERIFY(model.record().fit.settings == asSpecified().settings);
        model.undo();
        model.undo();
        QVERIFY(settled(model));
        QVERIFY(model.state().fit->report);
    }

    void withoutFilesThereIsNoTable()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("b02_x")});
        model.setFit(asSpecified(), {});
        QVERIFY(settled(model));
        model.removeFile(0);
        QVERIFY(settled(model));
        QVERIFY(!model.state().fit);
    }

    void theSourceOfTheAxisSaysWhereTheTableIsLookedUp()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("b02_x")});
        FitChoices choices = asSpecified();
        choices.settings.lookupAt.reset();
        model.setFit(choices, {});
        model.setDrive(driveWith(test::masterX));
        QVERIFY(settled(model));
        QVERIFY(model.state().fit->report->lookupAt == LookupAt::Encoder);
        model.setDrive(driveWith(setPosition));
        QVERIFY(settled(model));
        QVERIFY(model.state().fit->report->lookupAt == LookupAt::Set);
        // A register that is no position says nothing, and nothing is guessed.
        model.setDrive(driveWith("Axes[0]/Signals/General/MotorTemperature"));
        QVERIFY(settled(model));
        QVERIFY(isRefused(model, ErrorCode::InvalidArgument, "decides where its values belong"));
        // What is said comes first.
        model.setFit(asSpecified(), {});
        QVERIFY(settled(model));
        QVERIFY(model.state().fit->report->lookupAt == LookupAt::Encoder);
    }

    /// As on the command line: residuals of the axis belong where the axis looks its table up.
    void residualsOfTheAxisAreMergedOnItsOwnSideOnly()
    {
        RecordModel model;
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("after.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("// compensation: on\ntarget [mm],direction,run,deviation [um]\n");
        for (int target = 0; target <= 40; target += 10)
            for (const char* direction : {"+", "-"})
                file.write(QByteArray::number(target) + ',' + direction + ",1,1.5\n");
        file.close();
        model.addFiles({path});
        FitChoices choices = asSpecified();
        model.setFit(choices, {});
        QVERIFY(settled(model));
        QVERIFY(isRefused(model, ErrorCode::MeasurementState, "these are residuals"));

        choices.onto = FitChoices::Onto::Drive;
        model.setFit(choices, {});
        QVERIFY(settled(model));
        QVERIFY(isRefused(model, ErrorCode::InvalidArgument, "there is no axis"));

        FitDrive drive = driveWith(setPosition);
        auto old = std::make_shared<CompensationTable>();
        old->grid.axes = {{"", "", 0.0, 10.0, 5}};
        old->values = {0.001F, 0.001F, 0.001F, 0.001F, 0.001F};
        drive.held = TableIdentity{1, old->grid};
        drive.table = old;
        drive.storeRoot = folder.path().toStdString();
        model.setDrive(drive);
        model.setFit(choices, {});
        QVERIFY(settled(model));
        QVERIFY(isRefused(model, ErrorCode::InvalidArgument, "a position after the compensation"));

        choices.settings.lookupAt.reset();
        choices.settings.gain = 0.5;
        model.setFit(choices, {});
        QVERIFY(settled(model));
        const auto& fit = model.state().fit;
        QVERIFY(fit->report && fit->report->merge);
        QCOMPARE(fit->report->merge->gain, 0.5);
        // 1 um was added, and half of 1.5 um comes to it.
        for (const float value : fit->tables.front().table->values)
            QVERIFY(isNear(static_cast<double>(value), 0.00175));
        QVERIFY(
            fit->report->state.text.english().find("the table of axis 0 (X)") != std::string::npos);
    }

    void residualsOfAnotherDriveAreNotMergedOntoTheTableOfTheAxis()
    {
        QTemporaryDir folder;
        FitDrive drive = driveWith(test::masterX); // 1559
        auto old = std::make_shared<CompensationTable>();
        old->grid.axes = {{"", "", 0.0, 10.0, 5}};
        old->values.assign(5, 0.001F);
        drive.held = TableIdentity{1, old->grid};
        drive.table = old;
        drive.storeRoot = folder.path().toStdString();
        FitChoices choices = asSpecified();
        choices.onto = FitChoices::Onto::Drive;
        for (const char* serial : {"850618", "1559"}) {
            QFile file(folder.filePath(QString::fromLatin1(serial)) + QStringLiteral(".csv"));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("// compensation: on\n// drive: Mill, serial number ");
            file.write(QByteArray(serial) + "\ntarget [mm],direction,run,deviation [um]\n");
            for (int target = 0; target <= 40; target += 10)
                for (const char* direction : {"+", "-"})
                    file.write(QByteArray::number(target) + ',' + direction + ",1,1.5\n");
            file.close();
            RecordModel model;
            model.addFiles({file.fileName()});
            model.setDrive(drive);
            model.setFit(choices, {});
            QVERIFY(settled(model));
            if (serial == std::string_view("1559"))
                QVERIFY(model.state().fit->report && model.state().fit->report->merge);
            else
                QVERIFY(isRefused(model, ErrorCode::OtherDrive, "serial number 850618"));
        }
    }

    /// Its own write would be corrected once more, and so would the table of another axis.
    void residualsAreMergedOntoTheTableAloneOfWhichItWasSaid_data()
    {
        QTest::addColumn<QByteArray>("state");
        QTest::addColumn<QByteArray>("words");
        QTest::newRow("a person says it") << QByteArray() << QByteArray("does not say whether");
        QTest::newRow("the file says it")
            << QByteArray("// compensation: on\n") << QByteArray("these are residuals");
    }
    void residualsAreMergedOntoTheTableAloneOfWhichItWasSaid()
    {
        QFETCH(QByteArray, state);
        QFETCH(QByteArray, words);
        RecordModel model;
        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("after.csv")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(state + "target [mm],direction,run,deviation [um]\n");
        for (int target = 0; target <= 40; target += 10)
            for (const char* direction : {"+", "-"})
                file.write(QByteArray::number(target) + ',' + direction + ",1,0.5\n");
        file.close();
        const auto driveOf = [&](int axis, float value) {
            FitDrive drive = driveWith(test::masterX);
            auto table = std::make_shared<CompensationTable>();
            table->grid.axes = {{"", "", 0.0, 10.0, 5}};
            table->values.assign(5, value);
            drive.axis->axis.index = axis;
            drive.held = TableIdentity{tableCrc(*table), table->grid};
            drive.table = table;
            drive.storeRoot = folder.path().toStdString();
            return drive;
        };
        const auto madeOf = [&] {
            const auto& fit = model.state().fit;
            return fit && fit->report ? static_cast<double>(fit->tables.front().table->values[0])
                                      : std::nan("");
        };
        model.setDrive(driveOf(0, 0.001F));
        model.addFiles({file.fileName()});
        FitChoices choices = asSpecified();
        choices.measuredWith =
            state.isEmpty() ? FitChoices::MeasuredWith::On : FitChoices::MeasuredWith::NotSaid;
        choices.onto = FitChoices::Onto::Drive;
        model.setFit(choices, {});
        QVERIFY(settled(model));
        QVERIFY(isNear(madeOf(), 0.0015));
        for (const auto& [axis, value] : {std::pair(0, 0.0015F), std::pair(1, 0.001F)}) {
            model.setDrive(driveOf(axis, value));
            QVERIFY(settled(model));
            QVERIFY(isRefused(model, ErrorCode::MeasurementState, words.constData()));
            QVERIFY(model.fitChoices().measuredWith == FitChoices::MeasuredWith::NotSaid);
        }
        model.setDrive(driveOf(0, 0.001F)); // as after a restore
        QVERIFY(settled(model));
        QVERIFY(isNear(madeOf(), 0.0015));
        // Said anew of another one, it holds for that.
        model.setDrive(driveOf(0, 0.0015F));
        model.setFit(choices, {});
        QVERIFY(settled(model));
        QVERIFY(isNear(madeOf(), 0.002));
    }

    void theFileOfTheTableThatWasActiveIsRead()
    {
        RecordModel model;
        QTemporaryDir folder;
        const QString table = folder.filePath(QStringLiteral("old.csv"));
        QFile file(table);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("X [mm],dX [um]\n-20,1\n-10,1\n0,1\n10,1\n20,1\n");
        file.close();
        model.addFiles({publicMeasurement("b02_x")});
        FitChoices choices = asSpecified();
        choices.measuredWith = FitChoices::MeasuredWith::On;
        choices.onto = FitChoices::Onto::File;
        choices.ontoFile = table;
        model.setFit(choices, {});
        QVERIFY(settled(model));
        const auto& fit = model.state().fit;
        QVERIFY2(fit->report, fit->refusal ? textOf(*fit->refusal).english().c_str() : "");
        // It does not say which table was active: that is told.
        QVERIFY(fit->report->remarks.front().isWarning);
        QVERIFY(std::ranges::any_of(fit->report->remarks,
            [](const FitRemark& remark) { return remark.name == "StateAssumed"; }));
        choices.ontoFile = folder.filePath(QStringLiteral("none.csv"));
        model.setFit(choices, {});
        QVERIFY(settled(model));
        QVERIFY(
            isRefused(model, ErrorCode::InvalidArgument, "none.csv cannot be used as the table"));
    }

    void aTableWhoseSignNobodyHasPublishedSaysWhereTheSignIsStated()
    {
        RecordModel model;
        QTemporaryDir folder;
        const QString table = folder.filePath(QStringLiteral("old.pmc"));
        QFile file(table);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("#1\nDEFINE COMP 4,#1D,#1,4000\n1\n2\n2\n1\n");
        file.close();
        model.addFiles({publicMeasurement("b02_x")});
        FitChoices choices = asSpecified();
        choices.measuredWith = FitChoices::MeasuredWith::On;
        choices.onto = FitChoices::Onto::File;
        choices.ontoFile = table;
        model.setFit(choices, {});
        QVERIFY(settled(model));
        QVERIFY(isRefused(
            model, ErrorCode::InvalidArgument, "Import it on Write, where you state the sign"));
    }

    /// What was chosen for points is kept, and does not stand in the way of runs.
    void choicesForAnotherKindOfMeasurementAreKept()
    {
        RecordModel model;
        FitChoices choices = asSpecified();
        choices.settings.isRobust = true;
        choices.settings.farPoints = FarPoints::Nearest;
        model.addFiles({publicMeasurement("b02_x")});
        model.setFit(choices, {});
        QVERIFY(settled(model));
        QVERIFY(model.state().fit->report);
        QVERIFY(model.record().fit.settings.isRobust);
    }

    void theRecordHoldsTheFilesAndWhatIsPromised()
    {
        RecordModel model;
        model.addFiles({publicMeasurement("b02_x")});
        model.setFit(asSpecified(), {});
        model.setTolerance(Iso230Figure::A, 0.05);
        model.exclude({{Approach::Up, 1, 1}});
        QVERIFY(settled(model));
        const auto record = calibrationOf(*model.state().fit);
        QCOMPARE(record->before->files.size(), std::size_t{1});
        // Of the wizard, not of the program that shows its page.
        QVERIFY(record->program.starts_with("axiscomp "));
        QVERIFY(std::isdigit(static_cast<unsigned char>(record->program.back())));
        // sha256sum tests/data/metrology/b02_x.csv
        QCOMPARE(record->before->files.front().sha256,
            std::string("c81fa50bf0111e8aec33267f04266e71a798fd79e2c7a8eac44992ac1d3834df"));
        QCOMPARE(record->before->files.front().format, std::string("runs"));
        QCOMPARE(record->before->exclusions.size(), std::size_t{1});
        QCOMPARE(record->tables.front().crc, model.state().fit->crcs.front());
        QCOMPARE(record->fit->settings.tolerances.size(), std::size_t{1});
        // It is a file that can be read again.
        const auto again = recordFromText(recordText(*record), "x.axcal");
        QVERIFY(again.has_value());
        QCOMPARE(recordText(*again), recordText(*record));
    }

    void theWantedTableIsTheFirstOnWrite()
    {
        FitOutcome outcome;
        FitReport report;
        for (const char* name : {"dX", "dY", "dZ"}) {
            FittedTable made;
            made.table.name = name;
            made.table.grid.axes = {{"X", "mm", 0.0, 1.0, 2}};
            made.table.values = {0.0F, 0.1F};
            report.tables.push_back(made);
            outcome.tables.push_back(loaded(std::make_shared<const CompensationTable>(made.table)));
        }
        report.lookupAt = LookupAt::Set;
        outcome.report = report;
        Measurement measured;
        measured.header.drive = "Mill, serial number 1559";
        outcome.request.measurement = std::make_shared<const Measurement>(measured);
        outcome.request.files.resize(1);
        outcome.request.files.front().file.path = QStringLiteral("/data/plane.csv");
        outcome.request.files.front().format = *measurementFormatNamed("points");
        const MadeTables made = madeTables(outcome, 1);
        QCOMPARE(made.name, QStringLiteral("fit of plane.csv"));
        QCOMPARE(made.data->tables[0].name, std::string("dY"));
        QCOMPARE(made.data->tables[1].name, std::string("dX"));
        QCOMPARE(made.tables[2].table->name, std::string("dZ"));
        QVERIFY(made.lookupAt == LookupAt::Set);
        QVERIFY(std::ranges::find(made.data->notes, "drive: Mill, serial number 1559")
            != made.data->notes.end());
    }
};

AXISCOMP_WINDOW_TEST(TestRecordFit)

} // namespace tst_recordfit

#include "tst_recordfit.moc"
