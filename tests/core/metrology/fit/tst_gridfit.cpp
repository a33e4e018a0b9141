// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/grid_fit.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace tst_gridfit {

using namespace axiscomp;
using Numbers = std::vector<double>;
using Place = std::array<double, 3>;
using Formula = std::function<double(const Place&)>;

namespace {

constexpr double pi = std::numbers::pi;
const QString referenceFolder = QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/data/metrology/");

Numbers numbers(const QJsonValue& value)
{
    Numbers all;
    for (const QJsonValue& number : value.toArray())
        all.push_back(number.toDouble());
    return all;
}

Grid gridOf(const Numbers& starts, const Numbers& distances, const std::vector<int>& sizes)
{
    Grid grid;
    const std::vector<std::string> names{"X", "Y", "Z"};
    for (std::size_t i = 0; i < sizes.size(); ++i)
        grid.axes.push_back(
            {names[i], "mm", starts[i], distances[i], static_cast<std::uint32_t>(sizes[i])});
    return grid;
}

Grid square(int size)
{
    return gridOf({0.0, 0.0}, {1.0, 1.0}, {size, size});
}

struct Points {
    std::array<Numbers, 3> coordinates;
    Numbers values;

    [[nodiscard]] ScatteredValues scattered() const
    {
        return {{coordinates[0], coordinates[1], coordinates[2]}, values};
    }
    void add(const Place& place, double value)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            coordinates[axis].push_back(place[axis]);
        values.push_back(value);
    }
};

/// Anywhere in a grid, with normal noise.
Points scatter(
    const Grid& grid, int count, const Formula& truth, double noise = 0.0, unsigned seed = 1)
{
    std::mt19937 random(seed); // NOLINT: the same points every time
    std::normal_distribution<double> error(0.0, 1.0);
    Points points;
    for (int i = 0; i < count; ++i) {
        Place place{};
        for (std::size_t axis = 0; axis < grid.axes.size(); ++axis)
            place[axis] = std::uniform_real_distribution<double>(
                grid.axes[axis].start, grid.axes[axis].last())(random);
        points.add(place, truth(place) + noise * error(random));
    }
    return points;
}

Place nodePlace(const Grid& grid, std::size_t node)
{
    Place place{};
    for (std::size_t axis = 0; axis < grid.axes.size(); ++axis) {
        place[axis] = grid.axes[axis].position(node % grid.axes[axis].size);
        node /= grid.axes[axis].size;
    }
    return place;
}

double rmsTo(const Grid& grid, const Numbers& nodes, const Formula& truth)
{
    double sum = 0.0;
    for (std::size_t node = 0; node < nodes.size(); ++node)
        sum += std::pow(nodes[node] - truth(nodePlace(grid, node)), 2);
    return std::sqrt(sum / static_cast<double>(nodes.size()));
}

double largestDifference(const Numbers& a, const Numbers& b)
{
    double largest = a.size() == b.size() ? 0.0 : INFINITY;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

double wave(const Place& p)
{
    return 5.0 * std::sin(0.4 * p[0]) + 3.0 * std::cos(0.3 * p[1] + 0.2 * p[0]) + 0.1 * p[2];
}

#define VERIFY_BELOW(difference, limit)                                                            \
    QVERIFY2((difference) <= (limit), qPrintable(QString::number(difference)))

} // namespace

class TestGridFit : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theStoredReferencesAreWhatDenseMatricesMake()
    {
        QProcess python;
        python.start(QStringLiteral("/usr/bin/python3"),
            {referenceFolder + QStringLiteral("grid_reference.py"), QStringLiteral("check"),
                referenceFolder + QStringLiteral("grid_reference.json")});
        QVERIFY(python.waitForFinished(120000));
        if (python.exitCode() == 77)
            QSKIP("python3-numpy is not installed");
        QVERIFY2(python.exitCode() == 0, python.readAllStandardError().constData());
    }

    void nodesAreThoseOfDenseMatrices_data()
    {
        QFile file(referenceFolder + QStringLiteral("grid_reference.json"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject all = QJsonDocument::fromJson(file.readAll()).object();
        const QJsonArray inputs = all[QLatin1String("inputs")].toArray();
        const QJsonArray nodes = all[QLatin1String("nodes")].toArray();
        QTest::addColumn<QJsonObject>("input");
        QTest::addColumn<QJsonArray>("nodes");
        for (int i = 0; i < inputs.size(); ++i)
            QTest::addRow("%s", qPrintable(inputs[i].toObject()[QLatin1String("name")].toString()))
                << inputs[i].toObject() << nodes[i].toArray();
    }
    void nodesAreThoseOfDenseMatrices()
    {
        QFETCH(QJsonObject, input);
        QFETCH(QJsonArray, nodes);
        const auto given = [&](const char* name) { return numbers(input[QLatin1String(name)]); };
        std::vector<int> sizes;
        for (const double size : given("sizes"))
            sizes.push_back(static_cast<int>(size));
        Points points;
        const QJsonArray coordinates = input[QLatin1String("coordinates")].toArray();
        for (int axis = 0; axis < coordinates.size(); ++axis)
            points.coordinates[static_cast<std::size_t>(axis)] = numbers(coordinates[axis]);
        points.values = given("values");
        const Numbers weights = given("weights");
        ScatteredValues values = points.scattered();
        values.weights = weights;
        const auto fit = fitGrid(values,
            {.grid = gridOf(given("starts"), given("distances"), sizes),
                .smoothness = input[QLatin1String("smoothness")].toDouble(),
                .farPoints = FarPoints::Smooth});
        VERIFY_RESULT(fit);
        VERIFY_BELOW(largestDifference(fit->values, numbers(nodes)), 1e-6);
    }

    void pointsOnTheNodesGiveExactlyTheirMeans()
    {
        const Grid grid = gridOf({-3.0, 0.1}, {0.1, 0.7}, {11, 6});
        Points points;
        for (std::size_t node = 0; node < grid.pointCount(); ++node) {
            points.add(nodePlace(grid, node), static_cast<double>(node) + 0.5);
            points.add(nodePlace(grid, node), static_cast<double>(node) - 0.25);
        }
        const auto fit = fitGrid(points.scattered(), {.grid = grid, .smoothness = 0.0});
        VERIFY_RESULT(fit);
        for (std::size_t node = 0; node < grid.pointCount(); ++node)
            QCOMPARE(fit->values[node], static_cast<double>(node) + 0.125);
        QVERIFY(fit->filled.empty());
        // two values 0.75 apart: sigma 0.75 / sqrt(2)
        QVERIFY(std::abs(*fit->repeatability - 0.75 / std::sqrt(2.0)) < 1e-12);
        points.coordinates[0].resize(2 * grid.pointCount() - 2);
        points.coordinates[1].resize(2 * grid.pointCount() - 2);
        points.values.resize(2 * grid.pointCount() - 2);
        VERIFY_ERROR(fitGrid(points.scattered(), {.grid = grid, .smoothness = 0.0}),
            ErrorCode::InvalidArgument); // the last node has none
    }

    void theOrderOfThePointsDoesNotMatter()
    {
        const Grid grid = square(12);
        const Points points = scatter(grid, 400, wave, 0.3);
        Points mixed;
        for (std::size_t i = 0; i < points.values.size(); ++i) {
            const std::size_t from = i * 143 % points.values.size();
            mixed.add({points.coordinates[0][from], points.coordinates[1][from], 0.0},
                points.values[from]);
        }
        const auto fit = fitGrid(points.scattered(), {.grid = grid, .isRobust = true});
        const auto again = fitGrid(mixed.scattered(), {.grid = grid, .isRobust = true});
        VERIFY_RESULT(fit);
        VERIFY_RESULT(again);
        QVERIFY(fit->values == again->values);
    }

    void planesAndFactorsPassThrough()
    {
        const Grid grid = gridOf({-4.0, 2.0}, {1.0, 0.5}, {10, 14});
        const Points points = scatter(grid, 300, wave, 0.3);
        const auto fit = fitGrid(points.scattered(), {.grid = grid});
        VERIFY_RESULT(fit);
        Points tilted = points;
        Points larger = points;
        Points stretched = points;
        for (std::size_t i = 0; i < points.values.size(); ++i) {
            tilted.values[i] +=
                100.0 - 7.0 * points.coordinates[0][i] + 3.0 * points.coordinates[1][i];
            larger.values[i] *= -1000.0;
            stretched.coordinates[0][i] *= 64.0;
            stretched.coordinates[1][i] *= 64.0;
        }
        const auto sum = fitGrid(tilted.scattered(), {.grid = grid});
        VERIFY_RESULT(sum);
        const auto product = fitGrid(larger.scattered(), {.grid = grid});
        VERIFY_RESULT(product);
        const auto same = fitGrid(
            stretched.scattered(), {.grid = gridOf({-256.0, 128.0}, {64.0, 32.0}, {10, 14})});
        VERIFY_RESULT(same);
        for (std::size_t node = 0; node < fit->values.size(); ++node) {
            const Place place = nodePlace(grid, node);
            const double plane = 100.0 - 7.0 * place[0] + 3.0 * place[1];
            VERIFY_BELOW(std::abs(sum->values[node] - fit->values[node] - plane), 1e-8);
            VERIFY_BELOW(std::abs(product->values[node] + 1000.0 * fit->values[node]), 1e-5);
            VERIFY_BELOW(std::abs(same->values[node] - fit->values[node]), 1e-9);
        }
    }

    /// The best of all smoothnesses is found by comparison with the truth, which the search does
    /// not know.
    void theAutomaticSmoothnessIsNearTheBest_data()
    {
        QTest::addColumn<int>("dimensions");
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 4; ++seed)
            for (const int dimensions : {2, 3})
                QTest::addRow("%dD, %u", dimensions, seed) << dimensions << seed;
    }
    void theAutomaticSmoothnessIsNearTheBest()
    {
        QFETCH(int, dimensions);
        QFETCH(unsigned, seed);
        const Grid grid =
            dimensions == 2 ? square(16) : gridOf({0, 0, 0}, {2.0, 2.0, 2.0}, {8, 8, 8});
        std::mt19937 random(seed); // NOLINT: the same field every time
        std::uniform_real_distribution<double> phase(0.0, 2.0 * pi);
        const std::array phases{phase(random), phase(random), phase(random)};
        const Formula truth = [&phases](const Place& p) {
            return 4.0 * std::sin(2.0 * pi * p[0] / 14.0 + phases[0])
                * std::cos(2.0 * pi * p[1] / 20.0 + phases[1])
                + 2.0 * std::sin(2.0 * pi * (p[2] + p[0]) / 18.0 + phases[2]);
        };
        const Points points = scatter(grid, dimensions == 2 ? 700 : 1500, truth, 0.5, seed);
        const auto rmsOf = [&](const GridFit& fit) { return rmsTo(grid, fit.values, truth); };
        double best = INFINITY;
        for (double decade = -2.0; decade <= 3.0; decade += 0.5) {
            const auto fit = fitGrid(points.scattered(),
                {.grid = grid,
                    .smoothness = std::pow(10.0, decade),
                    .farPoints = FarPoints::Smooth});
            VERIFY_RESULT(fit);
            best = std::min(best, rmsOf(*fit));
        }
        const auto chosen =
            fitGrid(points.scattered(), {.grid = grid, .farPoints = FarPoints::Smooth});
        VERIFY_RESULT(chosen);
        QVERIFY2(rmsOf(*chosen) <= 1.2 * best,
            qPrintable(QStringLiteral("%1 best %2").arg(rmsOf(*chosen)).arg(best)));
        // left-out points have the noise, too
        QVERIFY(std::abs(*chosen->crossValidation - 0.5) < 0.15);
        QVERIFY(!chosen->explainsLittle());
        QVERIFY(chosen->explained > 0.9);
    }

    void noiseAloneExplainsLittle()
    {
        const Grid grid = square(8);
        const auto fit = fitGrid(scatter(
                                     grid, 300, [](const Place&) { return 0.0; }, 1.0)
                                     .scattered(),
            {.grid = grid});
        VERIFY_RESULT(fit);
        QVERIFY(fit->explainsLittle());
    }

    void aRobustFitFindsTheGrossErrors()
    {
        const Grid grid = square(12);
        Points points = scatter(grid, 500, wave, 0.1);
        const Points clean = points;
        for (const std::size_t bad : {7U, 77U, 300U})
            points.values[bad] += 30.0;
        const auto plain = fitGrid(clean.scattered(), {.grid = grid, .smoothness = 0.05});
        const auto harmed = fitGrid(points.scattered(), {.grid = grid, .smoothness = 0.05});
        const auto robust =
            fitGrid(points.scattered(), {.grid = grid, .smoothness = 0.05, .isRobust = true});
        VERIFY_RESULT(plain);
        VERIFY_RESULT(harmed);
        VERIFY_RESULT(robust);
        QVERIFY(largestDifference(harmed->values, plain->values) > 1.0);
        VERIFY_BELOW(largestDifference(robust->values, plain->values), 0.3);
        for (const std::size_t bad : {7U, 77U, 300U}) {
            const auto found = std::ranges::find(robust->doubtful, bad, &DoubtfulPoint::index);
            QVERIFY(found != robust->doubtful.end());
            QVERIFY(found->weight < 0.02 && std::abs(found->residual - 30.0) < 1.0);
        }
        QVERIFY(robust->doubtful.size() < 8);
    }

    void aRegionWithoutPointsIsRefusedOrFilled()
    {
        const Grid grid = square(16);
        Points points = scatter(gridOf({0.0, 0.0}, {1.0, 1.0}, {9, 16}), 600, wave);
        const auto refused = fitGrid(points.scattered(), {.grid = grid, .smoothness = 0.1});
        VERIFY_ERROR(refused, ErrorCode::NoDataThere);
        const std::string said = sentence(refused.error());
        // the last points lie just below X = 8: X = 11 and more are 3 or more away
        QVERIFY2(said.find("80 points of the grid, at X 11 mm to 15 mm, Y 0 mm to 15 mm")
                != std::string::npos,
            said.c_str());
        points.add({13.0, 7.5, 0.0}, -50.0); // reaches from 10 to 16 and from 4.5 to 10.5
        const auto nearest = fitGrid(
            points.scattered(), {.grid = grid, .smoothness = 0.1, .farPoints = FarPoints::Nearest});
        VERIFY_RESULT(nearest);
        const auto smooth = fitGrid(
            points.scattered(), {.grid = grid, .smoothness = 0.1, .farPoints = FarPoints::Smooth});
        VERIFY_RESULT(smooth);
        QCOMPARE(
            nearest->values[15], nearest->values[10]); // Y = 0: X = 10 is the last that is near
        QVERIFY(smooth->values[15] != smooth->values[10]);
        QCOMPARE(nearest->values[7 * 16 + 13], smooth->values[7 * 16 + 13]);
        // nodes in which no point has a share: X 9 to 15 but for (13, 7) and (13, 8)
        QCOMPARE(nearest->filled.size(), std::size_t{7 * 16 - 2});
        QVERIFY(std::ranges::is_sorted(nearest->filled));
    }

    void pointsOutsideTheGridAreCountedAndLeftOut()
    {
        const Grid grid = square(6);
        Points points = scatter(grid, 200, wave);
        const auto fit = fitGrid(points.scattered(), {.grid = grid, .smoothness = 0.1});
        points.add({5.01, 2.0, 0.0}, 1e6);
        points.add({2.0, -0.01, 0.0}, 1e6);
        const auto again = fitGrid(points.scattered(), {.grid = grid, .smoothness = 0.1});
        VERIFY_RESULT(fit);
        VERIFY_RESULT(again);
        QCOMPARE(again->outside, std::size_t{2});
        QVERIFY(again->values == fit->values);
        Points others;
        others.add({-1.0, -1.0, 0.0}, 1.0);
        VERIFY_ERROR(fitGrid(others.scattered(), {.grid = grid, .smoothness = 0.1}),
            ErrorCode::InvalidArgument);
    }

    void itStopsWhenAsked()
    {
        std::stop_source source;
        source.request_stop();
        const Grid grid = square(30);
        VERIFY_ERROR(fitGrid(scatter(grid, 2000, wave, 0.1).scattered(),
                         {.grid = grid, .stop = source.get_token()}),
            ErrorCode::Cancelled);
    }

    void whatMakesNoSenseIsRefused()
    {
        const Points points = scatter(square(5), 50, wave);
        const auto refuses = [](const Points& given, const GridFitRequest& request) {
            const auto fit = fitGrid(given.scattered(), request);
            return !fit && fit.error().code == ErrorCode::InvalidArgument;
        };
        QVERIFY(refuses(points, {.grid = {}, .smoothness = 1.0}));
        QVERIFY(refuses(points, {.grid = square(1), .smoothness = 1.0}));
        QVERIFY(refuses(points, {.grid = square(100'000), .smoothness = 1.0}));
        QVERIFY(refuses(points, {.grid = square(5), .smoothness = -1.0}));
        QVERIFY(refuses(points, {.grid = square(5), .smoothness = NAN}));
        QVERIFY(refuses({}, {.grid = square(5), .smoothness = 1.0}));
        Points bad = points;
        bad.values[3] = NAN;
        QVERIFY(refuses(bad, {.grid = square(5), .smoothness = 1.0}));
        bad = points;
        bad.coordinates[1].pop_back();
        QVERIFY(refuses(bad, {.grid = square(5), .smoothness = 1.0}));
        QVERIFY(refuses(scatter(square(5), 9, wave), {.grid = square(5)})); // too few to choose
    }
};

AXISCOMP_TEST(TestGridFit)

} // namespace tst_gridfit

#include "tst_gridfit.moc"
