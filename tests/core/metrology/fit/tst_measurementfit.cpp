// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/fit_parts.h"
#include "core/metrology/fit/fitted_points.h"
#include "core/metrology/fit/measurement_fit.h"
#include "core/metrology/judge/corrections.h"
#include "tests/core/metrology/measurement_reading.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tst_measurementfit {

using namespace axiscomp;

namespace {

constexpr double pi = std::numbers::pi;

FoundState measuredOff()
{
    return {};
}

FitSettings keeping(LookupAt lookupAt = LookupAt::Encoder)
{
    FitSettings settings;
    settings.zero = FitZero::Keep;
    settings.lookupAt = lookupAt;
    return settings;
}

/// One run up and one down over even targets; deviation: of a target.
template <typename Deviation>
Measurement runsOver(double from, double distance, std::size_t count, Deviation deviation)
{
    Measurement runs;
    for (std::size_t i = 0; i < count; ++i)
        runs.targets.push_back(from + static_cast<double>(i) * distance);
    for (const Approach direction : {Approach::Up, Approach::Down})
        for (std::size_t i = 0; i < count; ++i)
            runs.values.push_back({i, direction, 1, deviation(runs.targets[i])});
    return runs;
}

bool hasRemark(const FitReport& report, std::string_view name, std::string_view words = {})
{
    return std::ranges::any_of(report.remarks, [&](const FitRemark& remark) {
        return remark.name == name && remark.text.english().find(words) != std::string::npos;
    });
}

/// Fails with a message that names the way out.
bool isRefused(const Result<FitReport>& report, std::string_view words)
{
    if (!report && sentence(report.error()).find(words) != std::string::npos)
        return true;
    qInfo("%s", report ? "a table was made" : sentence(report.error()).c_str());
    return false;
}

/// Of the closed form in the specification of a residual merge.
double waveError(double u)
{
    return 0.5 * std::sin(2.0 * pi * u / 100.0) + 2e-4 * u;
}

/// A screw: slope, bow, and waves of 97 and 10 mm, over the place where the drive looks up.
double screwError(double place)
{
    return 12e-6 * place + 0.003 * std::sin(2.0 * pi * place / 430.0 + 0.7)
        + 0.0012 * std::sin(2.0 * pi * place / 97.0)
        + 0.0008 * std::sin(2.0 * pi * place / 10.0 + 0.3);
}

/// Of a set position S what the drive has to add where u + e(u) = S; both are 0 at 0.
template <typename Error> double addedAt(double position, Error error)
{
    double raw = position;
    for (int i = 0; i < 100; ++i) // a contraction
        raw = position - error(raw);
    return error(raw);
}

double slowWave(double u)
{
    return 0.03 * std::sin(u / 15.0);
}

/// What the table of the screw lacks.
double screwResidual(double place)
{
    return 0.0005 * std::sin(2.0 * pi * place / 500.0);
}

/// Its straight lines are at most 0.01 um off.
KnownTables screwTable()
{
    KnownTables old{Verbatim{"old.csv"}, {{}}, {1}};
    CompensationTable& table = old.tables.front();
    table.target = "X";
    table.grid.axes = {{"X", "mm", 0.0, 0.5, 1001}};
    for (std::uint32_t i = 0; i <= 1000; ++i) {
        const double place = table.grid.axes.front().position(i);
        table.values.push_back(static_cast<float>(screwError(place) - screwResidual(place)));
    }
    return old;
}

/// The largest of error - table - share of the residual that is left, over the whole travel.
double screwLeft(const CompensationTable& table, double leftShare)
{
    const Lookup lookup(table);
    double largest = 0.0;
    for (int i = 0; i <= 5000; ++i) {
        const double place = 0.1 * i;
        largest = std::max(largest,
            std::abs(screwError(place) - lookup.at(place) - leftShare * screwResidual(place)));
    }
    return largest;
}

/// A table of 501 points, up and down by 2 um.
KnownTables toothed()
{
    KnownTables old{Verbatim{"old.csv"}, {{}}, {1}};
    CompensationTable& table = old.tables.front();
    table.grid.axes = {{"X", "mm", 0.0, 1.0, 501}};
    for (int i = 0; i <= 500; ++i)
        table.values.push_back(i % 2 == 0 ? -0.002F : 0.002F);
    return old;
}

/// What X has a table of its own for.
double ownOfX(double target)
{
    return 0.02 * std::sin(2.0 * pi * target / 300.0);
}

double straightness(double target)
{
    return 0.003 * std::sin(2.0 * pi * target / 500.0);
}

/// Out of square, with a wave.
double outOfSquare(double target)
{
    return 0.004 + 3e-4 * target + 0.005 * std::sin(2.0 * pi * target / 80.0);
}

/// Runs along X, whose values are those of Y.
template <typename Deviation> Measurement runsAlongX(Deviation deviation)
{
    Measurement runs = runsOver(0.0, 10.0, 51, deviation);
    runs.header.axis = "X";
    return runs;
}

FoundState offForY()
{
    StateRequest request;
    request.onFile.kind = MeasuredState::Kind::Off;
    request.axis = "Y";
    return findState(request).value_or(FoundState{});
}

/// 5 by 4 points of an artefact that lies turned and shifted.
Measurement shiftedPlane()
{
    Measurement plane;
    plane.kind = MeasurementKind::Points;
    MeasuredPoints& points = plane.points;
    points.axes = {"X", "Y"};
    points.columns = {"dX", "dY"};
    points.positions.resize(2);
    points.values.resize(2);
    for (int x = 0; x <= 4; ++x)
        for (int y = 0; y <= 3; ++y) {
            points.positions[0].push_back(25.0 * x);
            points.positions[1].push_back(20.0 * y);
            points.values[0].push_back(0.01 - 1e-4 * 20.0 * y);
            points.values[1].push_back(-0.02 + 1e-4 * 25.0 * x);
        }
    return plane;
}

} // namespace

class TestMeasurementFit : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// Numbers computed for the specification of this program, not with it.
    void aPublicMeasurementGivesTheKnownTable()
    {
        const auto reading = test::readAs("runs", test::publicMeasurement("bifrost.csv"));
        VERIFY_MEASUREMENT(reading);
        const auto report = fitMeasurement(*reading.measurement, keeping(), measuredOff());
        VERIFY_RESULT(report);
        const FittedTable& made = report->tables.front();
        const double expected[] = {3.226e-3, -1.888e-3, 0.615e-3, -8.452e-3, 6.500e-3};
        QCOMPARE(made.table.values.size(), std::size_t{5});
        for (std::size_t i = 0; i < 5; ++i)
            QVERIFY(std::abs(static_cast<double>(made.table.values[i]) - expected[i]) < 1e-6);
        QVERIFY(std::abs(*(*report->predicted)[Iso230Figure::A].value - 0.0083537) < 1e-6);
        QVERIFY(std::abs(report->heldOut->range - 0.0177945) < 1e-6);
        QVERIFY(std::abs(*(*report->before)[Iso230Figure::A].value - 0.0185713) < 1e-6);
        QVERIFY(hasRemark(*report, "BetweenTargets", "M is 17.79"));
        QVERIFY2(report->sign.english().find("where the encoder reads 45.6 mm the reference said "
                                             "45.591548 mm on average of 10 values; the drive will "
                                             "add -8.452 um")
                != std::string::npos,
            report->sign.english().c_str());
    }

    /// f + r/2 going up and f - r/2 going down, with f of 0.003 mm at the first target.
    void aTableForEachDirectionKeepsTheReversalBetweenThem()
    {
        const auto mean = [](double x) { return 0.003 + 1e-5 * x * (x - 40.0); };
        const auto reversal = [](double x) { return 0.004 + 2e-5 * x; };
        Measurement runs = runsOver(0.0, 10.0, 6, mean);
        for (RunValue& value : runs.values)
            value.deviation += (value.direction == Approach::Up ? 0.5 : -0.5)
                * reversal(runs.targets[value.target]);
        FitSettings settings = keeping();
        settings.zero = FitZero::First;
        settings.direction = FitDirection::Both;
        const auto report = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(report);
        QCOMPARE(report->tables.size(), std::size_t{2});
        const FittedTable& up = report->tables[0];
        const FittedTable& down = report->tables[1];
        QVERIFY(up.direction == Direction::Positive && down.direction == Direction::Negative);
        for (std::size_t i = 0; i < 6; ++i) {
            const double x = 10.0 * static_cast<double>(i);
            const double middle = mean(x) - 0.003;
            QVERIFY(std::abs(static_cast<double>(up.table.values[i]) - middle - 0.5 * reversal(x))
                < 1e-9);
            QVERIFY(std::abs(static_cast<double>(down.table.values[i]) - middle + 0.5 * reversal(x))
                < 1e-9);
        }
        // 0.005 at the last target is what the table of the mean leaves of B.
        for (const Iso230Figure figure : {Iso230Figure::B, Iso230Figure::M, Iso230Figure::E})
            QVERIFY(*(*report->predicted)[figure].value < 1e-8);
        QVERIFY(std::abs(*(*report->before)[Iso230Figure::B].value - 0.005) < 1e-12);
        QVERIFY(hasRemark(*report, "ReversalInTables", "the reversal of up to 5.000 um"));
        QVERIFY(!hasRemark(*report, "MostlyReversal"));
        // Neither is 0 at the first target: they are 2 um above and below.
        QVERIFY(hasRemark(*report, "ZeroMoved", "3.000 um was taken out of all values of both"));
        QCOMPARE(std::ranges::count(report->remarks, "ZeroMoved", &FitRemark::name), 1);
        // A quarter of the second difference of f at each target, and nothing of a straight r
        QVERIFY(std::abs(report->heldOut->rms - 0.001) < 1e-9);
        QVERIFY(report->heldOut->range < 1e-9);
        QVERIFY2(report->sign.english().starts_with("approached upwards: where the encoder reads "),
            report->sign.english().c_str());
    }

    /// Up 0, down -10 um sin(pi x / 100): a table of the runs down takes that out of them, and adds
    /// it to the runs up.
    void aTableOfOneDirectionIsForetoldInBoth()
    {
        Measurement runs = runsOver(0.0, 10.0, 11, [](double) { return 0.0; });
        for (RunValue& value : runs.values)
            if (value.direction == Approach::Down)
                value.deviation = -0.010 * std::sin(pi * runs.targets[value.target] / 100.0);
        FitSettings settings = keeping();
        settings.direction = FitDirection::Negative;
        settings.tolerances = {{Iso230Figure::E, 0.001}, {Iso230Figure::B, 0.001}};
        const auto report = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(report);
        for (const Iso230Figure figure : {Iso230Figure::B, Iso230Figure::E, Iso230Figure::EUp})
            QVERIFY(std::abs(*(*report->predicted)[figure].value - 0.010) < 1e-6);
        QVERIFY(*(*report->predicted)[Iso230Figure::EDown].value < 1e-8);
        QVERIFY(std::abs(*(*report->predicted)[Iso230Figure::M].value - 0.005) < 1e-6);
        for (const Verdict& verdict : report->verdicts)
            QVERIFY(verdict.result == VerdictResult::Failed);
        QVERIFY(hasRemark(*report, "MostlyReversal", "up to 10.000 um remains in the other"));
        QVERIFY(hasRemark(*report, "LittleImprovement"));
    }

    /// A file with the tables of a plane: that of X says nothing of what was measured with Y.
    void residualsAreMergedOntoTheTableThatWasActive()
    {
        KnownTables old = toothed();
        CompensationTable other = old.tables.front();
        for (float& value : other.values)
            value = 0.5F;
        old.tables.insert(old.tables.begin(), other);
        old.crcs = {7, 8};
        const Measurement runs = runsOver(0.0, 1.0, 501, [](double) { return 0.0; });
        const auto report =
            fitMeasurement(runs, keeping(), FoundState{FoundState::Kind::On, &old, {}, {}, 8});
        VERIFY_RESULT(report);
        QVERIFY(report->tables.front().table.values == old.tables[1].values);
    }

    /// Positions and target of the old table, of what was measured along X.
    void whatWasMeasuredOfOneAxisIsNotMergedOntoTheTableOfAnother_data()
    {
        QTest::addColumn<QString>("positions");
        QTest::addColumn<QString>("target");
        QTest::addColumn<QString>("words"); // none: it is merged
        QTest::newRow("its own") << "X"
                                 << "X"
                                 << "";
        QTest::newRow("perhaps its own") << "Position"
                                         << "X2"
                                         << "";
        QTest::newRow("not said whose") << "X position"
                                        << ""
                                        << "";
        QTest::newRow("of Y by name") << "Position"
                                      << "Y"
                                      << "axis X was measured, but old.csv is of axis Y";
        QTest::newRow("of Y by number")
            << "Y"
            << "#1"
            << "old.csv is a table over Y, but what was measured is over X";
        QTest::newRow("over Y, not said whose") << "Y position"
                                                << ""
                                                << "old.csv is a table over Y position";
        QTest::newRow("of X over Y") << "Y"
                                     << "X"
                                     << "old.csv is a table over Y";
        QTest::newRow("of an axis that is no source")
            << "X"
            << "other"
            << "old.csv corrects an axis that is no source";
    }
    void whatWasMeasuredOfOneAxisIsNotMergedOntoTheTableOfAnother()
    {
        QFETCH(QString, positions);
        QFETCH(QString, target);
        QFETCH(QString, words);
        KnownTables old = toothed();
        old.tables.front().grid.axes.front().name = positions.toStdString();
        old.tables.front().target = target.toStdString();
        Measurement runs = runsOver(0.0, 1.0, 501, [](double) { return 0.0; });
        runs.header.axis = "X";
        const auto report =
            fitMeasurement(runs, keeping(), {FoundState::Kind::On, &old, {}, {}, 1});
        if (words.isEmpty())
            VERIFY_RESULT(report);
        else
            QVERIFY(isRefused(report, words.toStdString()));
    }

    /// A straightness has the axis that it corrects stated.
    void whatIsStatedComesBeforeTheAxisThatWasMeasured()
    {
        KnownTables old = toothed();
        old.tables.front().target = "other";
        Measurement runs = runsOver(0.0, 1.0, 501, [](double) { return 0.0; });
        runs.header.axis = "X";
        VERIFY_RESULT(
            fitMeasurement(runs, keeping(), {FoundState::Kind::On, &old, {}, {}, 1, "other"}));
    }

    /// X stands on its targets by its own table, so that its encoder is up to 20 um beside them:
    /// that is no deviation of Y.
    void theEncoderOfTheAxisThatMovesTellsThePlaceOnly()
    {
        Measurement runs = runsAlongX(straightness);
        for (RunValue& value : runs.values)
            value.encoder = runs.targets[value.target] - ownOfX(runs.targets[value.target]);
        QVERIFY(hasRawValues(runs, {}) && hasRawValues(runs, "X"));
        QVERIFY(!hasRawValues(runs, "Y") && !hasRawValues(runs, "other"));
        FitSettings settings = keeping();
        settings.method = FitMethod::Spline;
        for (const LookupAt lookupAt : {LookupAt::Encoder, LookupAt::Set}) {
            settings.lookupAt = lookupAt;
            const auto report = fitMeasurement(runs, settings, offForY());
            VERIFY_RESULT(report);
            const CompensationTable& table = report->tables.front().table;
            QCOMPARE(table.grid.axes.front().size, 51U);
            for (std::uint32_t i = 0; i <= 50; ++i) {
                const double place = table.grid.axes.front().position(i);
                double target = place;
                for (int round = 0; lookupAt == LookupAt::Encoder && round < 100; ++round)
                    target = place + ownOfX(target);
                const double rounding = i == 0 || i == 50 ? 1e-6 : 1e-8; // the ends are held
                QVERIFY(std::abs(static_cast<double>(table.values[i]) - straightness(target))
                    < rounding);
            }
            QVERIFY(*(*report->predicted)[Iso230Figure::M].value < 1e-6);
        }
    }

    void theTableOfAnotherAxisMovesNoPlace_data()
    {
        QTest::addColumn<LookupAt>("lookupAt");
        QTest::addColumn<FitZero>("zero");
        QTest::addColumn<bool>("isOn");
        QTest::addColumn<bool>("isFine");
        for (const LookupAt lookupAt : {LookupAt::Encoder, LookupAt::Set})
            for (const FitZero zero : {FitZero::First, FitZero::Keep})
                for (const bool isOn : {false, true})
                    for (const bool isFine : {false, true})
                        QTest::addRow("%s, zero %s, %s, %s",
                            lookupAt == LookupAt::Encoder ? "encoder" : "set",
                            zero == FitZero::First ? "first" : "kept", isOn ? "on" : "off",
                            isFine ? "spline" : "lines")
                            << lookupAt << zero << isOn << isFine;
    }
    /// What is left is what the table lacks where the axis was sent to, and of both the zero.
    void theTableOfAnotherAxisMovesNoPlace()
    {
        QFETCH(const LookupAt, lookupAt);
        QFETCH(const FitZero, zero);
        QFETCH(const bool, isOn);
        QFETCH(const bool, isFine);
        KnownTables old = toothed();
        old.tables.front().target = "Y";
        const Lookup active(old.tables.front());
        const auto left = [&](double target) {
            return outOfSquare(target) - (isOn ? active.at(target) : 0.0);
        };
        const Measurement runs = runsAlongX(left);
        FitSettings settings = keeping(lookupAt);
        settings.zero = zero;
        if (isFine) {
            settings.method = FitMethod::Spline;
            settings.grid = {{.points = 501}};
        }
        FoundState state = offForY();
        if (isOn) {
            state.kind = FoundState::Kind::On;
            state.active = &old;
        }
        const auto report = fitMeasurement(runs, settings, state);
        VERIFY_RESULT(report);
        const CompensationTable& table = report->tables.front().table;
        const double atZero = zero == FitZero::First ? outOfSquare(0.0) : 0.0;
        const Lookup made(table);
        for (const double target : runs.targets)
            QVERIFY(std::abs(made.at(target) - (outOfSquare(target) - atZero)) < 5e-8);
        QVERIFY(*(*report->predicted)[Iso230Figure::M].value < 5e-8);
    }

    void theTableOfAnotherAxisIsCalledAfterThat()
    {
        const Measurement runs = runsAlongX(outOfSquare);
        const auto report = fitMeasurement(runs, keeping(), offForY());
        VERIFY_RESULT(report);
        const CompensationTable& table = report->tables.front().table;
        QCOMPARE(table.grid.axes.front().name, std::string("X"));
        QCOMPARE(table.name, std::string("dY"));
        QCOMPARE(table.target, std::string("Y"));
        QCOMPARE(report->sign.english(),
            std::string("at X 500 mm the reference was 159.000 um beside the encoder in dY; the "
                        "drive will add 159.000 um"));
        FoundState other;
        other.axis = "other";
        const auto ofAny = fitMeasurement(runs, keeping(), other);
        VERIFY_RESULT(ofAny);
        QCOMPARE(ofAny->tables.front().table.name, std::string("Error"));
        QCOMPARE(ofAny->tables.front().table.target, std::string("other"));
    }

    void whatTheMeasurementDoesNotNameIsCalledAsInTheTableThatWasActive()
    {
        KnownTables old = toothed();
        old.tables.front().target = "Y";
        const Measurement runs = runsOver(0.0, 1.0, 501, [](double) { return 0.0; });
        const auto merged =
            fitMeasurement(runs, keeping(), {FoundState::Kind::On, &old, {}, {}, 1});
        VERIFY_RESULT(merged);
        QCOMPARE(merged->tables.front().table.grid.axes.front().name, std::string("X"));
        QCOMPARE(merged->tables.front().table.target, std::string("Y"));
        const auto alone = fitMeasurement(runs, keeping(), measuredOff());
        VERIFY_RESULT(alone);
        QCOMPARE(alone->tables.front().table.grid.axes.front().name, std::string("Position"));
        QCOMPARE(alone->tables.front().table.target, std::string());
    }

    void whatWasMeasuredOfOneAxisIsNotForetoldWithTheTableOfAnother()
    {
        const KnownTables own = toothed();
        KnownTables other = toothed();
        other.tables.front().grid.axes.front().name = "Position";
        other.tables.front().target = "Y";
        other.tables.front().name = "dY";
        Measurement runs = runsOver(0.0, 50.0, 11, [](double) { return 0.0; });
        runs.header.axis = "X";
        const FoundState withOwn{FoundState::Kind::On, &own, {}, {}};
        const FoundState withOther{FoundState::Kind::On, &other, {}, {}};
        const CompensationTable& table = own.tables.front();
        VERIFY_RESULT(predictMeasurement(runs, table, LookupAt::Encoder, withOwn));
        for (const auto& [refused, name] :
            {std::pair(predictMeasurement(runs, other.tables.front(), LookupAt::Encoder, withOwn),
                 "dY is of axis Y"),
                std::pair(predictMeasurement(runs, table, LookupAt::Encoder, withOther),
                    "old.csv is of axis Y")}) {
            VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
            QVERIFY2(sentence(refused.error()).find(name) != std::string::npos,
                sentence(refused.error()).c_str());
        }
    }

    /// dX = x/10 um and dY = -x/5 um, of which a residual of 0 is merged onto one.
    void ofSeveralTablesThatOfTheAxisIsMergedOnto_data()
    {
        QTest::addColumn<QString>("measured");
        QTest::addColumn<QString>("stated");
        QTest::addColumn<double>("last"); // at 100 mm; NaN: refused
        QTest::newRow("by name") << "Y"
                                 << "" << -0.02;
        QTest::newRow("lower case") << "y"
                                    << "" << -0.02;
        QTest::newRow("with a word") << "Y axis"
                                     << "" << -0.02;
        QTest::newRow("stated") << ""
                                << "Y" << -0.02;
        QTest::newRow("stated otherwise than measured") << "X"
                                                        << "Y" << -0.02;
        QTest::newRow("the first") << "X"
                                   << "" << 0.01;
        QTest::newRow("no name") << ""
                                 << "" << std::nan("");
        QTest::newRow("a number") << "1"
                                  << "" << std::nan("");
        QTest::newRow("another axis") << "Z"
                                      << "" << std::nan("");
    }
    void ofSeveralTablesThatOfTheAxisIsMergedOnto()
    {
        QFETCH(QString, measured);
        QFETCH(QString, stated);
        QFETCH(double, last);
        CompensationTable x;
        x.grid.axes = {{"Position", "mm", 0.0, 100.0, 2}};
        x.target = "X";
        x.values = {0.0F, 0.01F};
        CompensationTable y = x;
        y.target = "Y";
        y.values = {0.0F, -0.02F};
        const KnownTables old{Verbatim{"two.csv"}, {x, y}, {1, 2}};
        Measurement runs = runsOver(0.0, 10.0, 11, [](double) { return 0.0; });
        runs.header.axis = measured.toStdString();
        const FoundState state{FoundState::Kind::On, &old, {}, {}, {}, stated.toStdString()};
        const auto report = fitMeasurement(runs, keeping(), state);
        if (std::isnan(last)) {
            QVERIFY(isRefused(report, "there are: X, Y"));
            QVERIFY(isRefused(report, "--target"));
            return;
        }
        VERIFY_RESULT(report);
        const auto made = static_cast<double>(report->tables.front().table.values.back());
        QVERIFY2(std::abs(made - last) < 1e-8, QByteArray::number(made).constData());
    }

    void tablesOfOneAxisAreToldApartByTheirCrc()
    {
        KnownTables old = toothed();
        old.tables.push_back(old.tables.front());
        old.tables[0].target = old.tables[1].target = "X";
        old.crcs = {0x1c291ca3, 8};
        Measurement runs = runsOver(0.0, 1.0, 501, [](double) { return 0.0; });
        runs.header.axis = "X";
        const FoundState state{FoundState::Kind::On, &old, {}, {}};
        QVERIFY(isRefused(fitMeasurement(runs, keeping(), state), "compensation: crc:1c291ca3"));
        VERIFY_RESULT(
            fitMeasurement(runs, keeping(), FoundState{FoundState::Kind::On, &old, {}, {}, 8}));
    }

    /// As few points as the rougher of the two needs, in both.
    void tablesForBothDirectionsHaveOneGrid()
    {
        Measurement runs = runsOver(0.0, 10.0, 11, [](double x) { return 1e-5 * x; });
        for (RunValue& value : runs.values)
            if (value.direction == Approach::Down)
                value.deviation += 0.003 * std::sin(runs.targets[value.target] / 12.0);
        FitSettings settings = keeping();
        settings.direction = FitDirection::Both;
        settings.method = FitMethod::Spline;
        settings.within = 1e-4;
        const auto report = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(report);
        settings.direction = FitDirection::Negative;
        const auto alone = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(alone);
        QVERIFY(alone->tables.front().table.values.size() > 4);
        for (const FittedTable& made : report->tables)
            QVERIFY(made.table.grid == alone->tables.front().table.grid);
        QVERIFY(report->tables[1].table.values == alone->tables.front().table.values);
    }

    void whatHasOneValueForBothDirectionsRefusesATableForEach()
    {
        const Measurement runs = runsOver(0.0, 1.0, 501, [](double) { return 0.001; });
        FitSettings settings = keeping();
        settings.direction = FitDirection::Both;
        const KnownTables old = toothed();
        QVERIFY(isRefused(
            fitMeasurement(runs, settings, FoundState{FoundState::Kind::On, &old, {}, {}}),
            "old.csv has one value for both directions"));
        settings.isByTemperature = true;
        QVERIFY(isRefused(fitMeasurement(runs, settings, measuredOff()), "(--direction mean)"));
        Measurement track;
        track.kind = MeasurementKind::Track;
        for (int i = 0; i < 100; ++i)
            track.track.push_back({.encoder = 0.1 * i, .reference = 0.1 * i});
        settings.isByTemperature = false;
        settings.grid = {{.points = 3}};
        QVERIFY(isRefused(fitMeasurement(track, settings, measuredOff()), "--direction positive"));
    }

    /// With the table active that the residuals belong to, the knots are the error itself; adding
    /// residuals at the targets would be micrometres off.
    void residualsAreMergedExactly()
    {
        KnownTables old{Verbatim{"old.csv"}, {{}}, {1}};
        CompensationTable& table = old.tables.front();
        table.grid.axes = {{"X", "mm", 0.0, 10.0, 51}};
        for (std::size_t i = 0; i <= 50; ++i)
            table.values.push_back(
                static_cast<float>(0.9 * waveError(10.0 * static_cast<double>(i))));
        const Lookup lookup(table);
        for (const LookupAt lookupAt : {LookupAt::Encoder, LookupAt::Set}) {
            const Measurement runs = runsOver(0.0, 10.0, 51, [&](double target) {
                double raw = target - lookup.at(target);
                for (int i = 0; i < 200 && lookupAt == LookupAt::Encoder; ++i)
                    raw = target - lookup.at(raw); // a contraction by 0.03
                return raw + waveError(raw) - target;
            });
            const FoundState state{FoundState::Kind::On, &old, {}, {}};
            const auto report = fitMeasurement(runs, keeping(lookupAt), state);
            VERIFY_RESULT(report);
            for (const FitKnot& knot : report->tables.front().means) {
                const double raw =
                    lookupAt == LookupAt::Encoder ? knot.position : knot.position - knot.value;
                QVERIFY(std::abs(knot.value - waveError(raw)) < 1e-12);
            }
            QCOMPARE(report->tables.front().table.grid.axes.front().size, 51U); // the old grid
            QVERIFY(report->merge && report->merge->largestChange > 0.04);
            QVERIFY(hasRemark(*report, "Merged", "onto old.csv with gain 1"));
        }
    }

    /// The zero of the instrument is arbitrary: the axis stands without it. Tables computed by
    /// numpy, their first value 0.
    void theZeroOfTheInstrumentMovesNoTableOfRuns_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QList<double>>("expected");
        QTest::newRow("residuals that are merged")
            << static_cast<int>(FoundState::Kind::On)
            << QList<double>{0.0, 0.022170773, 0.02987265, 0.017990627, -0.005730912, -0.025677674,
                   -0.028750979, -0.013016975, 0.011199638, 0.028119224, 0.026643474};
        QTest::newRow("raw readings")
            << static_cast<int>(FoundState::Kind::Irrelevant)
            << QList<double>{0.0, 0.022156107, 0.029839391, 0.01797557, -0.005728453, -0.025650594,
                   -0.028722568, -0.013013384, 0.011197361, 0.02809248, 0.026622873};
    }
    void theZeroOfTheInstrumentMovesNoTableOfRuns()
    {
        QFETCH(const int, kind);
        QFETCH(const QList<double>, expected);
        const auto error = [](double u) { return 0.03 * std::sin(u / 12.0); };
        const bool isMerged = static_cast<FoundState::Kind>(kind) == FoundState::Kind::On;
        KnownTables old{Verbatim{"old.csv"}, {{}}, {1}};
        CompensationTable& table = old.tables.front();
        table.grid.axes = {{"X", "mm", 0.0, 10.0, 11}};
        for (int i = 0; i <= 10; ++i)
            table.values.push_back(static_cast<float>(0.8 * error(10.0 * i)));
        const Lookup lookup(table);
        FitSettings settings = keeping(LookupAt::Set);
        settings.zero = FitZero::First;
        for (const double ofInstrument : {0.0, 0.9, 17.3}) {
            Measurement runs = runsOver(0.0, 10.0, 11, [&](double target) {
                const double raw = isMerged ? target - lookup.at(target) : target;
                return raw + error(raw) - target + ofInstrument;
            });
            if (!isMerged)
                for (RunValue& value : runs.values)
                    value.encoder = runs.targets[value.target];
            const FoundState state{
                static_cast<FoundState::Kind>(kind), isMerged ? &old : nullptr, {}, {}};
            const auto report = fitMeasurement(runs, settings, state);
            VERIFY_RESULT(report);
            const auto& values = report->tables.front().table.values;
            QCOMPARE(values.size(), std::size_t{11});
            for (int i = 0; i < expected.size(); ++i)
                QVERIFY(
                    std::abs(static_cast<double>(values[static_cast<std::size_t>(i)]) - expected[i])
                    < 5e-9);
            QVERIFY(*(*report->predicted)[Iso230Figure::M].value < (isMerged ? 2e-5 : 1e-7));
        }
    }

    /// u is what the encoder read, and u + e + zero what the instrument said, whatever was taken
    /// out of the place of the knot.
    void theSignSentenceNamesTheReferenceAsItWasRead()
    {
        const Measurement runs =
            runsOver(0.0, 10.0, 11, [](double u) { return u == 60.0 ? 0.302 : 0.3; });
        FitSettings settings = keeping(LookupAt::Set);
        settings.zero = FitZero::First;
        const auto report = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(report);
        QVERIFY2(report->sign.english().find(
                     "where the encoder reads 60 mm the reference said 60.302 mm on average of 2 "
                     "values; 300.000 um was taken out for the zero of the table, so the drive "
                     "will add +1.999 um")
                != std::string::npos,
            report->sign.english().c_str());
    }

    /// Whoever adds the numbers up finds the last one.
    void theSignSentenceNamesTheSlopeThatWasTakenOut()
    {
        const Measurement runs = runsOver(
            0.0, 10.0, 11, [](double u) { return 0.0005 + 1e-5 * u + (u == 60.0 ? 0.002 : 0.0); });
        FitSettings settings = keeping();
        settings.slope = SlopeRemoval::LeastSquares;
        const auto signOf = [&] {
            const auto report = fitMeasurement(runs, settings, measuredOff());
            return report ? report->sign.english() : sentence(report.error());
        };
        const std::string kept = signOf();
        QVERIFY2(kept.find(" was taken out for the slope") != std::string::npos, kept.c_str());
        settings.zero = FitZero::First;
        const std::string sign = signOf();
        QVERIFY2(sign.find(" was taken out for the slope and the zero of the table, so the drive "
                           "will add ")
                != std::string::npos,
            sign.c_str());
    }

    /// Up 1 and 1 um, down 4 um: the mean of the three is 2 um, and that of both directions 2.5 um.
    void theSignSentenceSaysOfWhichMeansTheReferenceIs()
    {
        Measurement runs;
        runs.targets = {0.0, 10.0, 20.0};
        for (std::size_t i = 0; i < 3; ++i) {
            runs.values.push_back({i, Approach::Up, 1, i == 1 ? 0.001 : 0.0});
            runs.values.push_back({i, Approach::Up, 2, i == 1 ? 0.001 : 0.0});
            runs.values.push_back({i, Approach::Down, 1, i == 1 ? 0.004 : 0.0});
        }
        sortValues(runs.values);
        const auto report = fitMeasurement(runs, keeping(), measuredOff());
        VERIFY_RESULT(report);
        QVERIFY2(report->sign.english().find(
                     "where the encoder reads 10 mm the reference said 10.0025 mm, the mean of "
                     "both directions with 3 values; the drive will add +2.500 um")
                != std::string::npos,
            report->sign.english().c_str());
    }

    /// Half a um beside each other in both directions: one sample is not what the table has.
    void theSignSentenceOfATrackAddsUp()
    {
        Measurement track;
        track.kind = MeasurementKind::Track;
        for (int i = 0; i <= 100; ++i)
            track.track.push_back(
                {.encoder = 2.0 * i, .reference = 2.0 * i + 1e-5 * i, .direction = Approach::Up});
        for (int i = 100; i >= 0; --i)
            track.track.push_back({.encoder = 2.0 * i,
                .reference = 2.0 * i + 1e-5 * i - 0.0005,
                .direction = Approach::Down});
        FitSettings settings = keeping();
        settings.grid = {{.points = 5}};
        const auto report = fitMeasurement(track, settings, measuredOff());
        VERIFY_RESULT(report);
        QVERIFY2(report->sign.english().find(
                     "was taken out by gain, averaging, smoothing or grid, so the drive will add ")
                != std::string::npos,
            report->sign.english().c_str());
    }

    /// 5 K too warm: 100.001 mm as read are 100.001 / (1 + 57.5e-6) at 20 deg C. The sentence is
    /// compared with the machine, which shows what was read.
    void theSignSentenceNamesTheReferenceBeforeCorrections()
    {
        const Measurement runs = runsOver(0.0, 10.0, 11, [](double) { return 0.001; });
        const CorrectionsBefore warm{
            .temperature = TemperatureCorrection{
                .materialCelsius = 25.0, .expansionPerKelvin = 11.5e-6, .isConfirmed = true}};
        const auto atTwenty = corrected(runs, warm);
        VERIFY_RESULT(atTwenty);
        const auto report = fitMeasurement(atTwenty->measurement, keeping(), measuredOff());
        VERIFY_RESULT(report);
        QVERIFY2(report->sign.english().find(
                     "where the encoder reads 100 mm the reference said 100.001 mm (99.99525 mm "
                     "after corrections) on average of 2 values; the drive will add -4.75")
                != std::string::npos,
            report->sign.english().c_str());
        Measurement beside = runs;
        beside.header.axis = "X";
        const auto besideAtTwenty = corrected(beside, warm);
        VERIFY_RESULT(besideAtTwenty);
        const auto another = fitMeasurement(besideAtTwenty->measurement, keeping(), offForY());
        VERIFY_RESULT(another);
        QVERIFY2(another->sign.english().find("the reference was 1.000 um (-4.750 um after "
                                              "corrections) beside the encoder")
                != std::string::npos,
            another->sign.english().c_str());
    }

    /// The last target has a value of the second run alone, which lies 10 um above the first.
    void theSignSentenceNamesTheReferenceWithItsDrift()
    {
        Measurement runs;
        for (std::size_t i = 0; i <= 10; ++i) {
            runs.targets.push_back(10.0 * static_cast<double>(i));
            runs.values.push_back({i, Approach::Up, 1, 0.0});
            runs.values.back().isUsed = i < 10;
            runs.values.push_back({i, Approach::Up, 2, 0.010});
        }
        FitSettings settings = keeping();
        settings.drift = DriftRemoval::Offset;
        const auto report = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(report);
        const std::string sign = report->sign.english();
        QVERIFY2(sign.find("where the encoder reads 100 mm the reference said 100.01 mm (100.00")
                    != std::string::npos
                && sign.find("mm after corrections), measured once") != std::string::npos,
            sign.c_str());
    }

    /// Every 0.5 mm; the spline through them is met within 0.01 um, straight lines between the
    /// points of a grid of 5 mm within 0.5 um.
    void theZeroOfTheInstrumentMovesNoTableOfATrack_data()
    {
        QTest::addColumn<bool>("isSpline");
        QTest::newRow("on the grid") << false;
        QTest::newRow("by a spline") << true;
    }
    void theZeroOfTheInstrumentMovesNoTableOfATrack()
    {
        QFETCH(const bool, isSpline);
        FitSettings settings = keeping(LookupAt::Set);
        settings.zero = FitZero::First;
        settings.grid = {{.points = isSpline ? std::size_t{201} : std::size_t{41}}};
        if (isSpline)
            settings.method = FitMethod::Smooth;
        else
            settings.smoothness = 1e-9;
        const FoundState state{FoundState::Kind::Irrelevant, nullptr, {}, {}};
        for (const double ofInstrument : {0.0, 0.3, 17.3}) {
            Measurement track;
            track.kind = MeasurementKind::Track;
            track.header.axis = "X";
            for (int i = 0; i <= 400; ++i)
                track.track.push_back(
                    {0.5 * i, 0.5 * i + slowWave(0.5 * i) + ofInstrument, Approach::Up});
            const auto report = fitMeasurement(track, settings, state);
            VERIFY_RESULT(report);
            const CompensationTable& made = report->tables.front().table;
            for (std::uint32_t i = 2; i + 2 < made.grid.axes.front().size; ++i) {
                const double position = made.grid.axes.front().position(i);
                const double left =
                    static_cast<double>(made.values[i]) - addedAt(position, &slowWave);
                QVERIFY2(
                    std::abs(left) < (isSpline ? 1e-5 : 5e-4), qPrintable(QString::number(left)));
            }
            const auto points = fittedPoints(track, settings, *report);
            for (std::size_t i = 10; i + 10 < points.size(); ++i)
                QVERIFY(std::abs(points[i].value - addedAt(points[i].position, &slowWave))
                    < (isSpline ? 1e-5 : 5e-4));
        }
    }

    /// Along X the error of a wave, along Y none: the zero of both instruments moves nothing.
    void theZeroOfTheInstrumentMovesNoTableOfPoints_data()
    {
        QTest::addColumn<double>("gain");
        QTest::newRow("the whole error") << 1.0;
        QTest::newRow("half of the residual") << 0.5;
    }
    void theZeroOfTheInstrumentMovesNoTableOfPoints()
    {
        QFETCH(const double, gain);
        KnownTables old{Verbatim{"old.csv"}, {{}, {}}, {1, 2}};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            CompensationTable& table = old.tables[axis];
            table.target = axis == 0 ? "X" : "Y";
            table.grid.axes = {{"X", "mm", 0.0, 5.0, 41}, {"Y", "mm", 0.0, 20.0, 3}};
            table.values.assign(123, 0.0F);
        }
        FitSettings settings = keeping(LookupAt::Set);
        settings.zero = FitZero::First;
        settings.smoothness = 1e-9;
        settings.gain = gain;
        settings.farPoints = FarPoints::Nearest;
        for (const double ofInstrument : {0.0, 0.9, 17.3}) {
            Measurement plane;
            plane.kind = MeasurementKind::Points;
            plane.points.axes = {"X", "Y"};
            plane.points.columns = {"dX", "dY"};
            plane.points.positions.resize(2);
            plane.points.values.resize(2);
            for (int y = 0; y <= 2; ++y)
                for (int x = 0; x <= 40; ++x) {
                    plane.points.positions[0].push_back(5.0 * x);
                    plane.points.positions[1].push_back(20.0 * y);
                    plane.points.values[0].push_back(slowWave(5.0 * x) + ofInstrument);
                    plane.points.values[1].push_back(-2.0 * ofInstrument);
                }
            const FoundState residuals{FoundState::Kind::On, &old, {}, {}};
            const auto report =
                fitMeasurement(plane, settings, gain == 1.0 ? measuredOff() : residuals);
            VERIFY_RESULT(report);
            QVERIFY(!hasRemark(*report, "PointsOutside"));
            const CompensationTable& made = report->tables.front().table;
            for (std::size_t i = 2; i + 2 < 41; ++i) {
                const double left = static_cast<double>(made.values[41 + i])
                    - gain * addedAt(5.0 * static_cast<double>(i), &slowWave);
                QVERIFY2(std::abs(left) < 5e-4, qPrintable(QString::number(left)));
            }
            for (const float value : report->tables[1].table.values)
                QVERIFY(std::abs(value) < 1e-8F);
        }
    }

    void halfOfTheResidualIsTakenWithHalfTheGain()
    {
        KnownTables old{Verbatim{"old.csv"}, {{}}, {1}};
        old.tables.front().grid.axes = {{"X", "mm", 0.0, 10.0, 11}};
        old.tables.front().values.assign(11, 0.25F);
        const Measurement runs = runsOver(0.0, 10.0, 11, [](double) { return 0.5; });
        FitSettings settings = keeping();
        settings.gain = 0.5;
        settings.holdsEnds = true;
        const FoundState state{FoundState::Kind::On, &old, {}, {}};
        const auto report = fitMeasurement(runs, settings, state);
        VERIFY_RESULT(report);
        for (const float value : report->tables.front().table.values)
            QCOMPARE(value, 0.5F);
        QVERIFY(
            isRefused(fitMeasurement(runs, settings, measuredOff()), "a gain is for residuals"));
    }

    /// new = old + gain x residual, also where nothing was measured: with the same residual
    /// everywhere the whole table is moved by it.
    void aDenserTableKeepsWhatItHasBetweenTheTargets_data()
    {
        QTest::addColumn<bool>("isEncoder");
        QTest::addColumn<double>("gain");
        QTest::newRow("encoder") << true << 1.0;
        QTest::newRow("set") << false << 1.0;
        QTest::newRow("encoder, gain 0.7") << true << 0.7;
    }
    void aDenserTableKeepsWhatItHasBetweenTheTargets()
    {
        QFETCH(const bool, isEncoder);
        QFETCH(const double, gain);
        const KnownTables old = toothed();
        const Measurement runs = runsOver(0.0, 50.0, 11, [](double) { return 0.001; });
        FitSettings settings = keeping(isEncoder ? LookupAt::Encoder : LookupAt::Set);
        settings.gain = gain;
        const auto report = fitMeasurement(runs, settings, {FoundState::Kind::On, &old, {}, {}});
        VERIFY_RESULT(report);
        const auto& values = report->tables.front().table.values;
        const auto& before = old.tables.front().values;
        const double limit = isEncoder ? 1e-8 : 4.1e-6;
        QCOMPARE(values.size(), before.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            QVERIFY(std::abs(static_cast<double>(values[i]) - static_cast<double>(before[i])
                        - 0.001 * gain)
                < limit);
        QVERIFY(std::abs(report->merge->largestChange - 0.001 * gain) < limit);
        QVERIFY(report->heldOut->range < limit);
        QVERIFY(!hasRemark(*report, "OldDetailLost"));
    }

    /// The old table goes from 0 to 360 degrees, the targets from -180: the same residual
    /// everywhere moves all of it, and a target that is left out is foretold exactly.
    void aModuloAxisIsForetoldInWhicheverTurnItWasMeasured()
    {
        KnownTables old{Verbatim{"old.csv"}, {{}}, {1}};
        CompensationTable& table = old.tables.front();
        table.grid.axes = {{"C", "deg", 0.0, 10.0, 37}};
        for (int i = 0; i <= 36; ++i)
            table.values.push_back(
                static_cast<float>(0.003 * std::sin(10.0 * (i % 36) * pi / 180.0)));
        Measurement runs = runsOver(-180.0, 15.0, 24, [](double) { return 0.001; });
        runs.isAngular = true;
        FitSettings settings = keeping();
        settings.turn = 360.0;
        const auto report = fitMeasurement(runs, settings, {FoundState::Kind::On, &old, {}, {}});
        VERIFY_RESULT(report);
        QCOMPARE(report->tables.front().table.grid.axes.front().start, 0.0);
        QVERIFY(*(*report->predicted)[Iso230Figure::M].value < 1e-7); // chords of 15 degrees
        QVERIFY2(
            report->heldOut->range < 1e-8, qPrintable(QString::number(report->heldOut->range)));
    }

    void aTableOfATurnGoesWhereTheAxisCounts_data()
    {
        QTest::addColumn<double>("first");
        QTest::addColumn<double>("start");
        QTest::addColumn<bool>("isDoubtful");
        QTest::newRow("from 0") << 0.0 << 0.0 << false;
        QTest::newRow("from -180") << -180.0 << -180.0 << false;
        QTest::newRow("without 0") << 30.0 << 0.0 << true;
        QTest::newRow("the second turn") << 390.0 << 360.0 << true;
        QTest::newRow("across both ends") << -90.0 << -90.0 << true;
    }
    void aTableOfATurnGoesWhereTheAxisCounts()
    {
        QFETCH(const double, first);
        QFETCH(const double, start);
        QFETCH(const bool, isDoubtful);
        const auto error = [](double degrees) { return 0.01 * std::sin(degrees * pi / 180.0); };
        Measurement runs = runsOver(first, 30.0, 11, error);
        runs.isAngular = true;
        FitSettings settings = keeping();
        settings.turn = 360.0;
        const auto report = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(report);
        const CompensationTable& table = report->tables.front().table;
        const GridAxis& axis = table.grid.axes.front();
        QCOMPARE(axis.start, start);
        QCOMPARE(axis.last(), start + 360.0);
        QCOMPARE(hasRemark(*report, "CountOfTurn"), isDoubtful);
        for (std::size_t i = 0; i < axis.size; ++i) {
            const double fromFirst = std::fmod(axis.position(i) - first + 360.0, 360.0);
            const double due = fromFirst > 300.0 // between the last target and the first
                ? 0.5 * (error(first) + error(first + 300.0))
                : error(first + fromFirst);
            QVERIFY(std::abs(static_cast<double>(table.values[i]) - due) < 1e-8);
        }
    }

    void aMergeOfATurnKeepsTheGridOfTheOldTable()
    {
        KnownTables old{Verbatim{"old.csv"}, {{}}, {1}};
        CompensationTable& table = old.tables.front();
        table.grid.axes = {{"C", "deg", -90.0, 10.0, 37}};
        table.values.assign(37, 0.002F);
        Measurement runs = runsOver(0.0, 15.0, 24, [](double) { return 0.001; });
        runs.isAngular = true;
        FitSettings settings = keeping();
        settings.turn = 360.0;
        settings.method = FitMethod::Smooth;
        for (const bool hasPeriod : {false, true}) {
            if (hasPeriod)
                settings.periods.periods = {120.0};
            const auto report =
                fitMeasurement(runs, settings, {FoundState::Kind::On, &old, {}, {}});
            VERIFY_RESULT(report);
            const GridAxis& axis = report->tables.front().table.grid.axes.front();
            QCOMPARE(axis.start, -90.0);
            QCOMPARE(axis.size, 37U);
        }
    }

    /// At the set position the knots are beside the targets by the deviations, and the grid is not.
    void aHeldGridBeginsAtTheFirstTarget_data()
    {
        QTest::addColumn<double>("distance");
        QTest::addColumn<std::uint32_t>("points");
        QTest::newRow("that divides the range") << 40.0 << 11U;
        QTest::newRow("that does not") << 70.0 << 7U;
        QTest::newRow("longer than the range") << 500.0 << 2U;
    }
    void aHeldGridBeginsAtTheFirstTarget()
    {
        QFETCH(const double, distance);
        QFETCH(const std::uint32_t, points);
        const auto deviation = [](double target) { return 0.005 + 1e-5 * target; };
        const Measurement runs = runsOver(0.0, 10.0, 41, deviation);
        FitSettings settings = keeping(LookupAt::Set);
        settings.grid = {{.distance = distance}};
        settings.holdsEnds = true;
        const auto report = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(report);
        const GridAxis& axis = report->tables.front().table.grid.axes.front();
        QCOMPARE(axis.start, 0.0);
        QCOMPARE(axis.distance, distance);
        QCOMPARE(axis.size, points);
    }

    void aTurnWhoseStepsMissItsTargetsNeedsAGrid()
    {
        Measurement runs = runsOver(15.0, 30.0, 12, [](double) { return 0.001; });
        runs.isAngular = true;
        FitSettings settings = keeping();
        settings.turn = 360.0;
        QVERIFY(isRefused(fitMeasurement(runs, settings, measuredOff()),
            "the axis is taken to count from 0 deg to 360 deg, and steps of 30 deg do not lead"));
        settings.grid = {{.points = 25}};
        const auto report = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(report);
        QCOMPARE(report->tables.front().table.grid.axes.front().start, 0.0);
        settings.grid.clear();
        Measurement odd = runsOver(0.0, 50.0, 7, [](double) { return 0.001; });
        odd.isAngular = true;
        QVERIFY(isRefused(fitMeasurement(odd, settings, measuredOff()), "steps of 50 deg"));
    }

    void targetsBeyondTheTableAreNamed()
    {
        const Measurement runs = runsOver(0.0, 50.0, 7, [](double x) { return 1e-6 * x; });
        FitSettings settings = keeping();
        settings.grid = {{.distance = 70.0}};
        const auto cut = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(cut);
        QVERIFY(hasRemark(
            *cut, "TargetsOutside", "goes from 0 mm to 280 mm, the targets from 0 mm to 300 mm"));
        settings.grid = {{.distance = 60.0}};
        const auto whole = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(whole);
        QVERIFY(!hasRemark(*whole, "TargetsOutside"));
    }

    /// With R = 0 the rounding of numbers alone is above half of it.
    void whatIsForetoldToARoundingIsKnownBetweenTheTargets()
    {
        const auto warns = [](double wave) {
            Measurement runs = runsOver(
                0.0, 0.1, 12, [wave](double x) { return 1e-3 * x + wave * std::sin(40.0 * x); });
            const std::vector<RunValue> first = runs.values;
            for (RunValue value : first) {
                value.run = 2;
                runs.values.push_back(value);
            }
            sortValues(runs.values);
            const auto report = fitMeasurement(runs, keeping(), measuredOff());
            return report ? std::optional(hasRemark(*report, "BetweenTargets")) : std::nullopt;
        };
        QCOMPARE(warns(0.0), std::optional(false));
        QCOMPARE(warns(1e-6), std::optional(false)); // 3.3 nm of 1.1 um
        QCOMPARE(warns(2e-5), std::optional(true));
    }

    /// A peak of 4 um at one target: without it that is all left, and half of it too much beside.
    void runsOfOneDirectionAreForetoldByTheirE()
    {
        Measurement runs =
            runsOver(0.0, 10.0, 11, [](double x) { return x == 50.0 ? 0.004 : 0.0; });
        const auto both = fitMeasurement(runs, keeping(), measuredOff());
        VERIFY_RESULT(both);
        QVERIFY(hasRemark(*both, "BetweenTargets", "M is 6.000 um, before it was 4.000 um"));
        std::erase_if(
            runs.values, [](const RunValue& value) { return value.direction == Approach::Down; });
        const auto up = fitMeasurement(runs, keeping(), measuredOff());
        VERIFY_RESULT(up);
        QVERIFY(hasRemark(*up, "BetweenTargets",
            "E of the direction that was measured is 6.000 um, before it was 4.000 um"));
    }

    /// Straight lines through the means leave nothing at the targets, whatever lies between them:
    /// held out 6 um are left of that peak.
    void aToleranceOfMIsPassedOnlyWhereItIsHeldOutAsWell()
    {
        Measurement runs =
            runsOver(0.0, 10.0, 11, [](double x) { return x == 50.0 ? 0.004 : 0.0; });
        const auto verdictOf = [&runs](const Tolerance& tolerance, std::optional<double> u) {
            FitSettings settings = keeping();
            settings.tolerances = {tolerance};
            settings.uncertainty = u;
            const auto report = fitMeasurement(runs, settings, measuredOff());
            return report ? report->verdicts.front() : Verdict{};
        };
        const Verdict within = verdictOf({Iso230Figure::M, 0.0061}, std::nullopt);
        QCOMPARE(within.result, VerdictResult::Passed);
        QVERIFY(!within.heldOut);
        const Verdict above = verdictOf({Iso230Figure::M, 0.005}, std::nullopt);
        QCOMPARE(above.result, VerdictResult::Undecided);
        QVERIFY(*above.value < 1e-8 && std::abs(*above.heldOut - 0.006) < 1e-8);
        QCOMPARE(verdictOf({Iso230Figure::M, 0.0061}, 0.0002).result, VerdictResult::Undecided);
        QCOMPARE(verdictOf({Iso230Figure::M, 0.0063}, 0.0002).result, VerdictResult::Passed);
        std::erase_if(
            runs.values, [](const RunValue& value) { return value.direction == Approach::Down; });
        const Verdict up = verdictOf({Iso230Figure::EUp, 0.005}, std::nullopt);
        QCOMPARE(up.result, VerdictResult::Undecided);
        QVERIFY(std::abs(*up.heldOut - 0.006) < 1e-8);
    }

    /// What was taken out of the table stays in the machine, and more targets do not change that.
    void aSlopeThatWasTakenOutIsForetoldHeldOutToo()
    {
        const Measurement runs = runsOver(0.0, 10.0, 11, [](double x) { return 1e-6 * x * x; });
        FitSettings settings = keeping();
        settings.slope = SlopeRemoval::Ends;
        const auto report = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(report);
        QVERIFY(std::abs(*(*report->predicted)[Iso230Figure::M].value - 0.010) < 1e-6);
        // 1e-4 x, and at the targets that are left out half of the parabola's second difference
        // less
        QVERIFY(std::abs(report->heldOut->range - 0.010) < 1e-9);
        QVERIFY(std::abs(report->heldOut->residuals.back().value - 0.0089) < 1e-9);
        QVERIFY(!hasRemark(*report, "BetweenTargets"));
    }

    /// Of one direction's table the mean of both is left, as M is defined: at a target that is left
    /// out d / 2 - d cos(pi / 10) of d = -10 um sin(pi x / 100).
    void aTableOfOneDirectionIsForetoldHeldOutOfTheMean()
    {
        Measurement runs = runsOver(0.0, 10.0, 11, [](double) { return 0.0; });
        for (RunValue& value : runs.values)
            if (value.direction == Approach::Down)
                value.deviation = -0.010 * std::sin(pi * runs.targets[value.target] / 100.0);
        FitSettings settings = keeping();
        settings.direction = FitDirection::Negative;
        const auto report = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(report);
        const double share = std::cos(pi / 10.0) - 0.5;
        QVERIFY(std::abs(report->heldOut->largest - 0.010 * share) < 1e-9);
        QVERIFY(std::abs(report->heldOut->range - 0.010 * share) < 1e-9); // nothing at the ends
    }

    /// The old table goes from -50 to 150 mm, with 10 um sin(x / 20); the residual, 1 um and 0.01
    /// um for each mm, was measured from 0 to 100 mm. Beyond it the last residual is added: 1 um
    /// below 0 and 2 um above 100.
    void aTableGoesOnBeyondTheResidualsThatAreMergedOntoIt()
    {
        KnownTables old{Verbatim{"old.csv"}, {{}}, {1}};
        CompensationTable& table = old.tables.front();
        table.grid.axes = {{"X", "mm", -50.0, 10.0, 21}};
        for (int i = 0; i <= 20; ++i)
            table.values.push_back(static_cast<float>(0.01 * std::sin((10.0 * i - 50.0) / 20.0)));
        const Measurement runs =
            runsOver(0.0, 10.0, 11, [](double target) { return 0.001 + 1e-5 * target; });
        const FoundState state{FoundState::Kind::On, &old, {}, {}};
        const auto report = fitMeasurement(runs, keeping(), state);
        VERIFY_RESULT(report);
        const CompensationTable& made = report->tables.front().table;
        QCOMPARE(made.grid.axes.front().size, 21U);
        QCOMPARE(made.grid.axes.front().start, -50.0);
        for (std::size_t i = 0; i <= 20; ++i) {
            const double measured = std::clamp(10.0 * static_cast<double>(i) - 50.0, 0.0, 100.0);
            QVERIFY(std::abs(static_cast<double>(made.values[i])
                        - static_cast<double>(table.values[i]) - 0.001 - 1e-5 * measured)
                < 1e-6);
        }
        QVERIFY(!hasRemark(*report, "OldRangeLost"));
        // By Python: 10 um (sin 7.5 - sin 5) from 100 to 150 mm is the most.
        FitSettings shorter = keeping();
        shorter.grid = {{.points = 11}};
        const auto cut = fitMeasurement(runs, shorter, state);
        VERIFY_RESULT(cut);
        QCOMPARE(cut->tables.front().table.values.size(), std::size_t{11});
        QVERIFY(std::abs(cut->merge->lostRange - 0.018969242514) < 1e-8);
        QVERIFY(hasRemark(*cut, "OldRangeLost", "up to 18.969 um of what that has beyond"));
    }

    /// Every tenth point of the teeth is low, and their tops are 4 um above.
    void whatACoarserGridLosesOfTheOldTableIsSaid()
    {
        const KnownTables old = toothed();
        const Measurement runs = runsOver(0.0, 50.0, 11, [](double) { return 0.001; });
        FitSettings settings = keeping();
        settings.grid = {AxisRequest{.points = 51}};
        const auto report = fitMeasurement(runs, settings, {FoundState::Kind::On, &old, {}, {}});
        VERIFY_RESULT(report);
        QCOMPARE(report->tables.front().table.values.size(), std::size_t{51});
        QVERIFY(hasRemark(*report, "OldDetailLost", "up to 4.000 um of what that has"));
        QVERIFY(std::abs(report->merge->lostDetail - 0.004) < 1e-8);
        QVERIFY(std::abs(report->merge->largestChange - 0.003) < 1e-8);
    }

    /// Points on the edges belong to the edges, though the old table moves half of them out.
    void pointsAreMergedOntoADenserTable()
    {
        KnownTables old{Verbatim{"old.csv"}, {{}}, {1}};
        CompensationTable& table = old.tables.front();
        table.target = "X";
        table.grid.axes = {{"X", "mm", 0.0, 10.0, 11}, {"Y", "mm", 0.0, 10.0, 11}};
        for (int i = 0; i < 121; ++i)
            table.values.push_back(i % 2 == 0 ? -0.002F : 0.002F);
        Measurement plane;
        plane.kind = MeasurementKind::Points;
        MeasuredPoints& points = plane.points;
        points.axes = {"X", "Y"};
        points.columns = {"dX"};
        points.positions.resize(2);
        points.values.resize(1);
        for (const double x : {0.0, 50.0, 100.0})
            for (const double y : {0.0, 50.0, 100.0}) {
                points.positions[0].push_back(x);
                points.positions[1].push_back(y);
                points.values[0].push_back(0.003);
            }
        for (const LookupAt lookupAt : {LookupAt::Encoder, LookupAt::Set}) {
            FitSettings settings = keeping(lookupAt);
            settings.smoothness = 1.0;
            const auto report =
                fitMeasurement(plane, settings, {FoundState::Kind::On, &old, {}, {}});
            VERIFY_RESULT(report);
            QVERIFY(!hasRemark(*report, "PointsOutside"));
            const CompensationTable& made = report->tables.front().table;
            const double limit = lookupAt == LookupAt::Encoder ? 1e-8 : 1.3e-6;
            QCOMPARE(made.values.size(), table.values.size());
            for (std::size_t i = 0; i < made.values.size(); ++i)
                QVERIFY(std::abs(static_cast<double>(made.values[i])
                            - static_cast<double>(table.values[i]) - 0.003)
                    < limit);
        }
    }

    void pointsAreMergedOntoATableOverTheSameAxesInTheSameOrder()
    {
        KnownTables old{Verbatim{"old.csv"}, {{}}, {1}};
        CompensationTable& table = old.tables.front();
        table.target = "X";
        table.grid.axes = {{"Y", "mm", 0.0, 100.0, 2}, {"X", "mm", 0.0, 100.0, 2}};
        table.values = {0.0F, 0.0F, 0.01F, 0.01F};
        Measurement plane;
        plane.kind = MeasurementKind::Points;
        plane.points.axes = {"X", "Y"};
        plane.points.columns = {"dX"};
        plane.points.positions = {{0.0, 100.0, 0.0, 100.0}, {0.0, 0.0, 100.0, 100.0}};
        plane.points.values = {{0.0, 0.0, 0.0, 0.0}};
        FitSettings settings = keeping();
        settings.smoothness = 1.0;
        const auto merged = [&] {
            return fitMeasurement(plane, settings, {FoundState::Kind::On, &old, {}, {}});
        };
        QVERIFY(isRefused(
            merged(), "old.csv is a table over Y, X, but what was measured is over X, Y"));
        std::swap(table.grid.axes[0].name, table.grid.axes[1].name);
        VERIFY_RESULT(merged());
    }

    /// The servo's own error is in the readings, and not in the table.
    void rawReadingsAreReferenceMinusEncoder()
    {
        Measurement runs = runsOver(0.0, 10.0, 11, [](double) { return 0.0; });
        for (RunValue& value : runs.values) {
            const double servo = value.direction == Approach::Up ? 0.03 : 0.01;
            value.encoder = runs.targets[value.target] + servo;
            value.deviation = servo + 1e-3 * *value.encoder;
        }
        QVERIFY(hasRawReadings(runs));
        const FoundState state{FoundState::Kind::Irrelevant, nullptr, {}, {}};
        const auto report = fitMeasurement(runs, keeping(), state);
        VERIFY_RESULT(report);
        const CompensationTable& table = report->tables.front().table;
        QCOMPARE(table.grid.axes.front().size, 11U);
        for (std::size_t i = 1; i < 11; ++i) // the first is held from 0.02 on
            QVERIFY(std::abs(static_cast<double>(table.values[i])
                        - 1e-3 * table.grid.axes.front().position(i))
                < 1e-8);
        runs.values.front().encoder.reset();
        QVERIFY(!hasRawReadings(runs));
    }

    /// Targets 20 mm apart know nothing of the waves of 10 mm, which the old table has.
    void rawReadingsKeepWhatTheOldTableHasBetweenTheTargets_data()
    {
        QTest::addColumn<bool>("isEncoder");
        QTest::addColumn<double>("gain");
        QTest::newRow("encoder") << true << 1.0;
        QTest::newRow("set") << false << 1.0;
        QTest::newRow("encoder, gain 0.7") << true << 0.7;
        QTest::newRow("set, gain 0.7") << false << 0.7;
    }
    void rawReadingsKeepWhatTheOldTableHasBetweenTheTargets()
    {
        QFETCH(const bool, isEncoder);
        QFETCH(const double, gain);
        const KnownTables old = screwTable();
        Measurement runs = runsOver(0.0, 20.0, 26, [](double) { return 0.0; });
        runs.header.axis = "X";
        for (RunValue& value : runs.values) {
            const double target = runs.targets[value.target];
            const double place = target + 0.01;
            value.encoder = isEncoder ? place : place - screwError(place);
            value.deviation = *value.encoder + screwError(place) - target;
        }
        FitSettings settings = keeping(isEncoder ? LookupAt::Encoder : LookupAt::Set);
        settings.gain = gain;
        const FoundState state{FoundState::Kind::Irrelevant, &old, {}, {}};
        const auto report = fitMeasurement(runs, settings, state);
        VERIFY_RESULT(report);
        const CompensationTable& made = report->tables.front().table;
        QVERIFY(made.grid.axes.front().size == 1001U);
        const double left = screwLeft(made, 1.0 - gain);
        QVERIFY2(left < 2e-5, qPrintable(QString::number(left)));
        QVERIFY(std::abs(report->merge->largestChange - gain * 0.0005) < 2e-5);
        if (gain == 1.0)
            QVERIFY2(
                report->heldOut->range < 1e-4, qPrintable(QString::number(report->heldOut->range)));
        QVERIFY(!hasRemark(*report, "OldDetailLost"));
        settings.grid = {AxisRequest{.points = 51}};
        const auto coarse = fitMeasurement(runs, settings, state);
        VERIFY_RESULT(coarse);
        QVERIFY(hasRemark(*coarse, "OldDetailLost"));
    }

    void aTrackKeepsWhatTheOldTableHasBetweenItsSamples_data()
    {
        QTest::addColumn<bool>("isSpline");
        QTest::addColumn<double>("gain");
        QTest::newRow("on the grid") << false << 1.0;
        QTest::newRow("by a spline") << true << 1.0;
        QTest::newRow("on the grid, gain 0.7") << false << 0.7;
        QTest::newRow("by a spline, gain 0.7") << true << 0.7;
    }
    void aTrackKeepsWhatTheOldTableHasBetweenItsSamples()
    {
        QFETCH(const bool, isSpline);
        QFETCH(const double, gain);
        KnownTables old = screwTable();
        Measurement track;
        track.kind = MeasurementKind::Track;
        track.header.axis = "X";
        for (int i = 0; i <= 200; ++i) {
            const double place = 2.5 * i;
            track.track.push_back({place, place + screwError(place), Approach::Up});
        }
        FitSettings settings = keeping();
        settings.gain = gain;
        settings.smoothness = isSpline ? 1e-8 : 1.0;
        if (isSpline)
            settings.method = FitMethod::Smooth;
        const FoundState state{FoundState::Kind::Irrelevant, &old, {}, {}};
        const auto report = fitMeasurement(track, settings, state);
        VERIFY_RESULT(report);
        const CompensationTable& made = report->tables.front().table;
        QVERIFY(made.grid.axes.front().size == 1001U);
        const double left = screwLeft(made, 1.0 - gain);
        QVERIFY2(left < 2e-5, qPrintable(QString::number(left)));
        QVERIFY(std::abs(report->merge->largestChange - gain * 0.0005) < 2e-5);
        old.tables.front().target = "Y";
        QVERIFY(isRefused(fitMeasurement(track, settings, state), "is of axis Y"));
    }

    /// Both directions count the same, though one has three times the samples.
    void aTrackIsFittedOntoItsGrid()
    {
        Measurement track;
        track.kind = MeasurementKind::Track;
        track.header.axis = "X";
        const auto add = [&track](double encoder, Approach direction) {
            const double half = direction == Approach::Up ? 0.002 : -0.002;
            track.track.push_back({encoder, encoder * (1.0 + 1e-4) + half, direction});
        };
        for (int i = 0; i <= 1000; ++i)
            add(0.1 * i, Approach::Up);
        for (int i = 3000; i >= 0; --i)
            add(0.1 * i / 3.0, Approach::Down);
        FitSettings settings = keeping();
        settings.grid = {{.points = 11}};
        const FoundState state{FoundState::Kind::Irrelevant, nullptr, {}, {}};
        const auto report = fitMeasurement(track, settings, state);
        VERIFY_RESULT(report);
        const CompensationTable& table = report->tables.front().table;
        QCOMPARE(table.target, std::string("X"));
        QCOMPARE(table.grid.axes.front().last(), 100.0);
        for (std::size_t i = 0; i < 11; ++i)
            QVERIFY(std::abs(static_cast<double>(table.values[i])
                        - 1e-4 * table.grid.axes.front().position(i))
                < 2e-5);
        QVERIFY(!report->predicted);
        settings.grid.clear();
        QVERIFY(isRefused(fitMeasurement(track, settings, state), "--points or --distance"));
    }

    /// A straight line with a known period is met exactly, by any smoothness; the grid's own fit
    /// with its points 1 mm apart does not see the period.
    void aTrackIsFittedByASmoothingSplineWithItsPeriods()
    {
        const auto error = [](double x) {
            return 3e-5 * x + 0.0008 * std::sin(2.0 * pi * x / 10.0 + 0.3);
        };
        Measurement track;
        track.kind = MeasurementKind::Track;
        track.header.axis = "X";
        for (int i = 0; i <= 4000; ++i)
            track.track.push_back({0.05 * i, 0.05 * i + error(0.05 * i), Approach::Up});
        for (int i = 1000; i >= 0; --i)
            track.track.push_back({0.2 * i, 0.2 * i + error(0.2 * i), Approach::Down});
        FitSettings settings = keeping();
        settings.method = FitMethod::Smooth;
        settings.periods = {{10.0}, 1};
        settings.grid = {{.distance = 0.5}};
        const FoundState state{FoundState::Kind::Irrelevant, nullptr, {}, {}};
        const auto report = fitMeasurement(track, settings, state);
        VERIFY_RESULT(report);
        const FittedTable& made = report->tables.front();
        QCOMPARE(made.table.values.size(), std::size_t{401});
        for (std::size_t i = 0; i < made.table.values.size(); ++i)
            QVERIFY(std::abs(static_cast<double>(made.table.values[i])
                        - error(made.table.grid.axes.front().position(i)))
                < 1e-8);
        QCOMPARE(made.periods.size(), std::size_t{1});
        QVERIFY(std::abs(made.periods.front().amplitude() - 0.0008) < 1e-9);
        // By Python, the largest distance of straight lines from the wave: at 4001 places, and
        // anywhere.
        QVERIFY(std::abs(made.residualLargest - 9.748906e-6) < 1e-9);
        QVERIFY(made.density && std::abs(made.density->largestDistance - 9.749044e-6) < 1e-9);

        // 20 points for each period; by Python, 1257 points are 1.0008e-6 off.
        settings.grid.clear();
        const auto open = fitMeasurement(track, settings, state);
        VERIFY_RESULT(open);
        QCOMPARE(open->tables.front().table.values.size(), std::size_t{401});
        settings.within = 1e-6;
        const auto fewest = fitMeasurement(track, settings, state);
        VERIFY_RESULT(fewest);
        QCOMPARE(fewest->tables.front().table.values.size(), std::size_t{1258});
        QVERIFY(std::abs(fewest->tables.front().density->largestDistance - 9.99214e-7) < 1e-11);
        settings.mostPoints = 1000;
        VERIFY_ERROR(fitMeasurement(track, settings, state), ErrorCode::ResamplingImpossible);
        settings.mostPoints = FitSettings().mostPoints;
        settings.method = FitMethod::Linear;
        settings.periods = {};
        QVERIFY(isRefused(fitMeasurement(track, settings, state), "a track with --method smooth"));
        settings.method = FitMethod::Smooth;
        settings.within.reset();

        settings.grid = {{.distance = 0.5}};
        settings.isRobust = true;
        QVERIFY(isRefused(fitMeasurement(track, settings, state), "leave out --robust"));
        settings.isRobust = false;
        settings.periods = {{0.25}, 1}; // every sample is at one place of it
        settings.grid = {{.points = 11}};
        track.track.resize(4001);
        for (std::size_t i = 0; i < track.track.size(); ++i)
            track.track[i].encoder = 0.25 * static_cast<double>(i);
        const auto unresolved = fitMeasurement(track, settings, state);
        VERIFY_ERROR(unresolved, ErrorCode::PeriodNotResolved);
        settings.periods = {};
        settings.method = FitMethod::Spline;
        QVERIFY(isRefused(fitMeasurement(track, settings, state), "--method smooth"));
    }

    void bothDirectionsOfATrackCountTheSame_data()
    {
        QTest::addColumn<FitMethod>("method");
        QTest::addColumn<bool>("isRobust");
        QTest::addColumn<double>("from"); // what was measured downwards
        QTest::addColumn<double>("to");
        QTest::newRow("spline") << FitMethod::Smooth << false << -5.0 << 205.0;
        QTest::newRow("spline, half of the way back")
            << FitMethod::Smooth << false << 52.5 << 157.5;
        QTest::newRow("grid") << FitMethod::Linear << false << -5.0 << 205.0;
        QTest::newRow("grid, robust") << FitMethod::Linear << true << -5.0 << 205.0;
        QTest::newRow("grid, half of the way back") << FitMethod::Linear << false << 52.5 << 157.5;
    }
    /// The grid itself is up to 0.073 um off the curve, and natural ends a hundredth of one.
    void bothDirectionsOfATrackCountTheSame()
    {
        QFETCH(const FitMethod, method);
        QFETCH(const bool, isRobust);
        QFETCH(const double, from);
        QFETCH(const double, to);
        const auto error = [](double place) {
            return 0.01 * std::sin(2.0 * pi * place / 130.0 + 1.0) + 4e-5 * place;
        };
        Measurement track;
        track.kind = MeasurementKind::Track;
        track.header.axis = "X";
        for (int i = 0; i < 900; ++i) {
            const double place = -5.0 + 210.0 * i / 899.0;
            track.track.push_back({place, place + error(place) + 0.002, Approach::Up});
        }
        for (int i = 0; i < 100; ++i) {
            const double place = to - (to - from) * i / 99.0;
            track.track.push_back({place, place + error(place) - 0.002, Approach::Down});
        }
        FitSettings settings = keeping();
        settings.method = method;
        settings.isRobust = isRobust;
        settings.grid = {{.points = 43}};
        const FoundState state{FoundState::Kind::Irrelevant, nullptr, {}, {}};
        const auto report = fitMeasurement(track, settings, state);
        VERIFY_RESULT(report);
        const FittedTable& made = report->tables.front();
        const GridAxis& axis = made.table.grid.axes.front();
        const double tolerance = method == FitMethod::Smooth ? 2e-5 : 1e-4;
        for (std::uint32_t i = 0; i < axis.size; ++i)
            QVERIFY(std::abs(static_cast<double>(made.table.values[i]) - error(axis.position(i)))
                < tolerance);
        QVERIFY(std::abs(made.residualRms - 0.002) < 1e-4); // half of the reversal
    }

    /// Numbers of samples are those of no file where some were left out.
    void aSampleOfATrackThatDoesNotFitIsNamedByItsPlace()
    {
        Measurement track;
        track.kind = MeasurementKind::Track;
        track.header.axis = "X";
        constexpr double outlier = 37.5;
        for (const Approach direction : {Approach::Up, Approach::Down})
            for (int i = 0; i <= 400; ++i) {
                const double place = 0.25 * (direction == Approach::Up ? i : 400 - i);
                const bool isOff = direction == Approach::Down && place == outlier;
                const double noise = 1e-5 * ((i * 37) % 11 - 5);
                track.track.push_back(
                    {place, place + 1e-5 * place + noise + (isOff ? 0.5 : 0.0), direction});
            }
        FitSettings settings = keeping();
        settings.isRobust = true;
        settings.grid = {{.points = 11}};
        const FoundState state{FoundState::Kind::Irrelevant, nullptr, {}, {}};
        for (const FitDirection direction : {FitDirection::Mean, FitDirection::Negative}) {
            settings.direction = direction;
            const auto report = fitMeasurement(track, settings, state);
            VERIFY_RESULT(report);
            QVERIFY(hasRemark(*report, "DoubtfulPoints", "counts little: at 37.5 mm"));
        }
    }

    void aTrackWhoseDirectionsHaveNothingInCommonHasNoMean()
    {
        Measurement track;
        track.kind = MeasurementKind::Track;
        track.header.axis = "X";
        for (int i = 0; i < 100; ++i) {
            track.track.push_back({0.5 * i, 0.5 * i + 0.002, Approach::Up});
            track.track.push_back({100.0 + 0.5 * i, 100.0 + 0.5 * i - 0.002, Approach::Down});
        }
        FitSettings settings = keeping();
        settings.grid = {{.points = 16}};
        const FoundState state{FoundState::Kind::Irrelevant, nullptr, {}, {}};
        for (const FitMethod method : {FitMethod::Linear, FitMethod::Smooth}) {
            settings.method = method;
            QVERIFY(isRefused(fitMeasurement(track, settings, state), "--direction positive"));
        }
    }

    /// Samples leave a gap: what the spline has there was not measured.
    void aGapOfATrackIsNotBridgedUnasked()
    {
        Measurement track;
        track.kind = MeasurementKind::Track;
        for (int i = 0; i <= 200; ++i)
            if (i < 60 || i > 140)
                track.track.push_back({0.5 * i, 0.5 * i + 1e-5 * i, Approach::Up});
        FitSettings settings = keeping();
        settings.method = FitMethod::Smooth;
        settings.grid = {{.distance = 2.0}};
        const FoundState state{FoundState::Kind::Irrelevant, nullptr, {}, {}};
        VERIFY_ERROR(fitMeasurement(track, settings, state), ErrorCode::NoDataThere);
        settings.farPoints = FarPoints::Smooth;
        const auto report = fitMeasurement(track, settings, state);
        VERIFY_RESULT(report);
        QVERIFY(report->tables.front().filledNodes > 10);
        QVERIFY(hasRemark(*report, "NodesFilled"));
        for (std::size_t i = 0; i <= 50; ++i)
            QVERIFY(std::abs(static_cast<double>(report->tables.front().table.values[i])
                        - 4e-5 * static_cast<double>(i))
                < 1e-8);
    }

    /// 0.005 cos x + 0.002 sin 2x at 24 targets of a turn: the last point is the first again.
    void harmonicsHaveTheGridOfTheTargets()
    {
        const auto error = [](double degrees) {
            const double x = degrees * pi / 180.0;
            return 0.005 * std::cos(x) + 0.002 * std::sin(2.0 * x);
        };
        Measurement runs = runsOver(0.0, 15.0, 24, error);
        runs.isAngular = true;
        FitSettings settings = keeping();
        settings.method = FitMethod::Harmonic;
        settings.periods.harmonics = 2;
        settings.turn = 360.0;
        const auto report = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(report);
        const CompensationTable& table = report->tables.front().table;
        QCOMPARE(table.values.size(), std::size_t{25});
        for (std::size_t i = 0; i < 25; ++i)
            QVERIFY(std::abs(static_cast<double>(table.values[i])
                        - error(table.grid.axes.front().position(i)))
                < 1e-9);
        // Of 0.012 before: with the table the axis stands up to 0.006 deg beside a target, and
        // between points of 15 deg the drive goes straight.
        QVERIFY(*(*report->predicted)[Iso230Figure::M].value < 1e-6);
        QVERIFY(report->heldOut->range < 1e-6);
    }

    void aTurnThatWasNotMeasuredAllRoundSaysSo()
    {
        Measurement half = runsOver(0.0, 15.0, 13, [](double) { return 0.001; });
        half.isAngular = true;
        FitSettings settings = keeping();
        settings.turn = 360.0;
        settings.method = FitMethod::Spline;
        settings.grid = {{.points = 73}};
        const auto guessed = fitMeasurement(half, settings, measuredOff());
        VERIFY_RESULT(guessed);
        QVERIFY(hasRemark(*guessed, "TurnNotMeasured",
            "from 180 deg to 360 deg nothing was measured, 180 deg of a turn of 360 deg"));
        // 0 and 360 are one place; so much as 2.5 times is no gap
        Measurement whole = runsOver(0.0, 15.0, 25, [](double) { return 0.001; });
        whole.isAngular = true;
        const auto known = fitMeasurement(whole, settings, measuredOff());
        VERIFY_RESULT(known);
        QVERIFY(!hasRemark(*known, "TurnNotMeasured"));
        for (RunValue& value : whole.values)
            value.isUsed = value.target != 4;
        const auto without = fitMeasurement(whole, settings, measuredOff());
        VERIFY_RESULT(without);
        QVERIFY(!hasRemark(*without, "TurnNotMeasured"));
    }

    /// The last bit of a float32 is no jump of the axis.
    void endsOfATurnThatRoundingAloneTellsApartAreNoWarning()
    {
        Measurement runs = runsOver(
            0.0, 30.0, 12, [](double c) { return 0.001 + 0.0005 * std::sin(c * pi / 180.0); });
        runs.isAngular = true;
        FitSettings settings = keeping();
        settings.turn = 360.0;
        const FoundState off = measuredOff();
        auto report = fitMeasurement(runs, settings, off);
        VERIFY_RESULT(report);
        const FitInput input{runs, settings, off, LookupAt::Encoder, {}};
        std::vector<float>& values = report->tables.front().table.values;
        for (const auto& [last, isWarning] :
            {std::pair(std::nextafter(values.front(), 1.0F), false),
                std::pair(values.front() + 1e-5F, true)}) {
            values.back() = last;
            report->remarks.clear();
            addStateRemarks(input, {}, {&report->tables.front().table, 1}, *report);
            const auto ends = std::ranges::find(
                report->remarks, std::string_view("EndsOfTurn"), &FitRemark::name);
            QVERIFY(ends != report->remarks.end());
            QCOMPARE(ends->isWarning, isWarning);
        }
    }

    void aTurnIsNotShorterThanWhatWasMeasured()
    {
        Measurement runs = runsOver(0.0, 15.0, 24, [](double) { return 0.001; });
        runs.isAngular = true;
        FitSettings settings = keeping();
        settings.turn = 90.0;
        QVERIFY(isRefused(fitMeasurement(runs, settings, measuredOff()),
            "from 0 deg to 345 deg, which is more than a turn of 90 deg"));
        settings.turn = 345.0; // as when the last target is the first again
        VERIFY_RESULT(fitMeasurement(runs, settings, measuredOff()));
        settings.turn = 330.0;
        QVERIFY(!fitMeasurement(runs, settings, measuredOff()));
        for (RunValue& value : runs.values)
            value.isUsed = value.target != 23;
        VERIFY_RESULT(fitMeasurement(runs, settings, measuredOff()));
    }

    /// The axis Y leans towards X where X deviates by more the further Y has moved.
    void theSquarenessSaysWhetherTheAngleIsAboveOrBelow90Degrees()
    {
        FitSettings settings;
        settings.lookupAt = LookupAt::Encoder;
        settings.remove = BodyRemoval::Rigid;
        settings.smoothness = 0.0;
        for (const double slope : {1e-4, -1e-4}) {
            Measurement plane = shiftedPlane();
            MeasuredPoints& points = plane.points;
            for (std::size_t i = 0; i < points.values[0].size(); ++i)
                points.values[0][i] += slope * points.positions[1][i];
            const auto report = fitMeasurement(plane, settings, measuredOff());
            VERIFY_RESULT(report);
            QVERIFY(hasRemark(*report, "Squareness",
                slope > 0.0 ? "the angle between X and Y is 20.626 arcsec less than 90 degrees"
                            : "the angle between X and Y is 20.626 arcsec more than 90 degrees"));
        }
    }

    /// Of an artefact that lies turned and shifted nothing is left.
    void howAnArtefactLayIsTakenOut()
    {
        const Measurement plane = shiftedPlane();
        FitSettings settings;
        settings.lookupAt = LookupAt::Encoder;
        settings.remove = BodyRemoval::Rigid;
        settings.smoothness = 0.0;
        const auto report = fitMeasurement(plane, settings, measuredOff());
        VERIFY_RESULT(report);
        QCOMPARE(report->tables.size(), std::size_t{2});
        QCOMPARE(report->tables[1].table.target, std::string("Y"));
        QCOMPARE(report->tables[0].table.grid.axes[0].size, 5U);
        for (const FittedTable& made : report->tables)
            for (const float value : made.table.values)
                QVERIFY(std::abs(value) < 1e-9F);
        QVERIFY(std::abs(report->removedBody->rotation[2] - 1e-4) < 1e-12);
        QVERIFY(hasRemark(*report, "Squareness",
            "the angle between X and Y is 0.000 arcsec less than 90 degrees"));
        settings.method = FitMethod::Spline;
        QVERIFY(isRefused(fitMeasurement(plane, settings, measuredOff()), "leave out --method"));
    }

    /// p(x) q(y) with the sum of p 0 is no rigid motion: of 16 um at X 0 mm and Y 60 mm 4 um are
    /// how the artefact lay, and 12 um are in the table.
    void theReferenceIsQuotedAsItWasRead()
    {
        const double p[] = {3.0, -1.0, -1.0, -1.0, 0.0};
        Measurement plane = shiftedPlane();
        for (std::size_t x = 0; x <= 4; ++x)
            for (std::size_t y = 0; y <= 3; ++y)
                plane.points.values[0][4 * x + y] += 0.001 * p[x] * (static_cast<double>(y) + 1.0);
        FitSettings settings;
        settings.lookupAt = LookupAt::Encoder;
        settings.remove = BodyRemoval::Rigid;
        settings.smoothness = 0.0;
        const auto signOf = [&](const FoundState& state) {
            const auto report = fitMeasurement(plane, settings, state);
            return report ? report->sign.english() : sentence(report.error());
        };
        const std::string sign = signOf(measuredOff());
        QVERIFY2(sign.find("at X 0 mm, Y 60 mm the reference was 16.000 um beside the encoder in "
                           "dX; 4.000 um was taken out for how the artefact lay and for the zero "
                           "of the table, so the drive will add 12.000 um")
                != std::string::npos,
            sign.c_str());
        KnownTables old{Verbatim{"old.csv"}, {{}, {}}, {1, 2}};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            CompensationTable& table = old.tables[axis];
            table.target = plane.points.axes[axis];
            table.grid.axes = {{"X", "mm", 0.0, 25.0, 5}, {"Y", "mm", 0.0, 20.0, 4}};
            table.values.assign(20, 0.0F);
        }
        settings.gain = 0.5;
        const std::string half = signOf({FoundState::Kind::On, &old, {}, {}});
        QVERIFY2(half.find("the reference was 16.000 um") != std::string::npos
                && half.find("the drive will add 6.000 um") != std::string::npos,
            half.c_str());
    }

    void theZeroIsAtTheHomePositionWhereItIsKnown()
    {
        const Measurement runs = runsOver(0.0, 10.0, 11, [](double p) { return 0.001 * p + 0.5; });
        FitSettings settings = keeping();
        settings.zero = FitZero::Automatic;
        const auto valueAt = [&](double position) {
            const auto report = fitMeasurement(runs, settings, measuredOff());
            return report ? Lookup(report->tables.front().table).at(position) : NAN;
        };
        QCOMPARE(valueAt(0.0), 0.0); // the first target
        settings.home = 40.0;
        QCOMPARE(valueAt(40.0), 0.0);
        settings.home = 400.0; // not measured
        QCOMPARE(valueAt(0.0), 0.0);
        settings.zero = FitZero::Home;
        QVERIFY(isRefused(
            fitMeasurement(runs, settings, measuredOff()), "400 mm is outside the targets"));
        settings.home.reset();
        QVERIFY(isRefused(fitMeasurement(runs, settings, measuredOff()), "give it (--home)"));
        settings.zero = FitZero::Position;
        settings.zeroPosition = {101.0};
        QVERIFY(isRefused(fitMeasurement(runs, settings, measuredOff()), "outside the targets"));
    }

    /// The last target, and one that is off the even ones, are left out: 0 to 90 mm remain.
    void targetsThatAreLeftOutDoNotCount()
    {
        Measurement runs = runsOver(0.0, 10.0, 11, [](double p) { return 1e-4 * p; });
        runs.targets.insert(runs.targets.begin() + 4, 33.0);
        for (RunValue& value : runs.values)
            value.target += value.target >= 4 ? 1 : 0;
        for (const Approach direction : {Approach::Up, Approach::Down})
            runs.values.push_back({4, direction, 1, 0.5});
        sortValues(runs.values);
        for (RunValue& value : runs.values)
            value.isUsed = value.target != 4 && value.target != 11;
        for (const LookupAt lookupAt : {LookupAt::Encoder, LookupAt::Set}) {
            FitSettings settings = keeping(lookupAt);
            const auto report = fitMeasurement(runs, settings, measuredOff());
            VERIFY_RESULT(report);
            const GridAxis& axis = report->tables.front().table.grid.axes.front();
            QCOMPARE(axis.size, 10U);
            QCOMPARE(axis.start, 0.0);
            QVERIFY(std::abs(axis.last() - 90.0) < 1e-9);
            settings.zero = FitZero::Position;
            settings.zeroPosition = {95.0};
            QVERIFY(isRefused(fitMeasurement(runs, settings, measuredOff()),
                "outside the targets, which go from 0 mm to 90 mm"));
            settings.zero = FitZero::Home;
            settings.home = 95.0;
            QVERIFY(isRefused(
                fitMeasurement(runs, settings, measuredOff()), "95 mm is outside the targets"));
        }
    }

    void whatIsLeftOpenIsAskedFor()
    {
        Measurement runs = runsOver(0.0, 10.0, 11, [](double p) { return 0.001 * p; });
        FitSettings settings = keeping();
        settings.lookupAt.reset();
        QVERIFY(isRefused(fitMeasurement(runs, settings, measuredOff()), "--lookup-at encoder"));
        settings = keeping(LookupAt::Set);
        runs.targets[3] = 33.0;
        QVERIFY(isRefused(fitMeasurement(runs, settings, measuredOff()), "not evenly spaced"));
        settings = keeping();
        QVERIFY(isRefused(fitMeasurement(runs, settings, measuredOff()), "not evenly spaced"));
        settings.remove = BodyRemoval::Rigid;
        QVERIFY(isRefused(fitMeasurement(runs, settings, measuredOff()), "--remove, --robust"));
        settings = keeping();
        settings.smoothness = 1.0;
        QVERIFY(isRefused(fitMeasurement(runs, settings, measuredOff()), "--method smooth"));
    }

    void aPeriodThatTheTargetsCannotTellIsRefused()
    {
        const Measurement runs = runsOver(0.0, 10.0, 21, [](double p) { return 1e-5 * p; });
        FitSettings settings = keeping();
        settings.method = FitMethod::Smooth;
        settings.periods = {{10.0}};
        VERIFY_ERROR(fitMeasurement(runs, settings, measuredOff()), ErrorCode::PeriodNotResolved);
        settings.periods = {{37.0}};
        settings.smoothness = 1.0;
        const auto report = fitMeasurement(runs, settings, measuredOff());
        VERIFY_RESULT(report);
        QVERIFY(hasRemark(*report, "TargetsPerPeriod", "21 targets lie in 5.405 periods of 37 mm"));
    }

    void aTableThatHelpsLittleSaysSo()
    {
        Measurement runs = runsOver(0.0, 10.0, 11, [](double) { return 0.0; });
        for (RunValue& value : runs.values)
            value.deviation = value.direction == Approach::Up ? 0.01 : -0.01;
        const auto report = fitMeasurement(runs, keeping(), measuredOff());
        VERIFY_RESULT(report);
        QVERIFY(hasRemark(*report, "LittleImprovement", "from 20.000 um to 20.000 um"));
        QVERIFY(hasRemark(*report, "MostlyReversal", "up to 10.000 um remains"));
        QVERIFY(report->remarks.front().isWarning);
    }

    void threeTargetsMakeATableThatNothingIsKnownOfBetween()
    {
        const Measurement runs = runsOver(0.0, 10.0, 3, [](double p) { return 0.001 * p; });
        const auto report = fitMeasurement(runs, keeping(), measuredOff());
        VERIFY_RESULT(report);
        QVERIFY(!report->heldOut);
        QVERIFY(hasRemark(*report, "HeldOutUnknown", "3 targets; four are needed"));
    }
};

AXISCOMP_TEST(TestMeasurementFit)

} // namespace tst_measurementfit

#include "tst_measurementfit.moc"
