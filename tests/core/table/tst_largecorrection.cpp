// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/large_correction.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <algorithm>

namespace tst_largecorrection {

using namespace axiscomp;

namespace {

/// Zero but for one value at one point of 5 x 3: X 0 .. 400 mm, Y 0 .. 1 m.
CompensationTable bump(float value, const std::string& unit, std::size_t point = 6)
{
    CompensationTable table;
    table.unit = unit;
    table.grid.axes = {{"X", "mm", 0.0, 100.0, 5}, {"Y", "m", 0.0, 0.5, 3}};
    table.values.assign(15, 0.0F);
    table.values[point] = value;
    return table;
}

QStringList sentencesOf(const CompensationTable& table)
{
    QStringList sentences;
    for (const Text& sentence : largeCorrections(table))
        sentences.append(QString::fromStdString(sentence.english()));
    return sentences;
}

} // namespace

class TestLargeCorrection : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void onePercentOfTheRangeIsTheLimit()
    {
        QCOMPARE(sentencesOf(bump(4.0F, "mm")), QStringList());
        QCOMPARE(sentencesOf(bump(-4.0F, "mm")), QStringList());
        QCOMPARE(sentencesOf(bump(-4.04F, "mm")),
            QStringList(QStringLiteral("The largest correction, 4.04 mm, is 1.01 % of the range of "
                                       "dimension 1, 400 mm.")));
    }

    void unitsAreTakenIntoAccount()
    {
        QCOMPARE(sentencesOf(bump(4000.0F, "um")), QStringList());
        QCOMPARE(sentencesOf(bump(4040.0F, "um")).size(), 1);
        QCOMPARE(sentencesOf(bump(0.00404F, "m")).size(), 1);
        QCOMPARE(sentencesOf(bump(10.0F, "deg")), QStringList());
    }

    void aSlopeOfATenthIsTheLimit_data()
    {
        QTest::addColumn<int>("point");
        QTest::addColumn<QString>("place");
        QTest::newRow("first step") << 0 << "between 0 mm and 100 mm";
        QTest::newRow("middle") << 7 << "between 200 mm and 300 mm";
        QTest::newRow("last step") << 14 << "between 300 mm and 400 mm";
    }
    void aSlopeOfATenthIsTheLimit()
    {
        QFETCH(int, point);
        QFETCH(QString, place);
        const auto index = static_cast<std::size_t>(point);
        for (const QString& sentence : sentencesOf(bump(10.0F, "mm", index)))
            QVERIFY2(!sentence.contains(QLatin1String("slope")), qPrintable(sentence));
        const QStringList sentences = sentencesOf(bump(10.1F, "mm", index));
        QCOMPARE(sentences.filter(QStringLiteral("slope")),
            QStringList(QStringLiteral("The correction has a slope of 0.101 along dimension 1, %1.")
                            .arg(place)));
    }

    void theLargestIsFoundWhereverItStands()
    {
        constexpr std::size_t points = 19; // eight at a time, and three more
        for (std::size_t n = 0; n < points; ++n) {
            for (const float value : {20.0F, -20.0F}) {
                CompensationTable table;
                table.unit = "mm";
                table.grid.axes = {{"X", "mm", 0.0, 100.0, points}};
                table.values.assign(points, 0.0F);
                table.values[n] = value;
                const std::size_t from = std::min(n, points - 2) * 100;
                const QStringList wanted{
                    QStringLiteral("The largest correction, 20 mm, is 1.111 % of the range of "
                                   "dimension 1, 1800 mm."),
                    QStringLiteral("The correction has a slope of 0.2 along dimension 1, between "
                                   "%1 mm and %2 mm.")
                        .arg(from)
                        .arg(from + 100)};
                QCOMPARE(sentencesOf(table), wanted);
            }
        }
    }

    void aStepAlongTheSecondDimensionIsFound()
    {
        CompensationTable table = bump(0.0F, "mm");
        for (std::size_t n = 5; n < 15; ++n)
            table.values[n] = 60.0F;
        const QStringList slopes = sentencesOf(table).filter(QStringLiteral("slope"));
        QCOMPARE(slopes,
            QStringList(QStringLiteral(
                "The correction has a slope of 0.12 along dimension 2, between 0 m and 0.5 m.")));
    }

    void theEndOfOneLineIsNoNeighbourOfTheNext()
    {
        CompensationTable table = bump(0.0F, "mm");
        // Rises gently along X, falls back between the lines.
        for (std::size_t n = 0; n < 15; ++n)
            table.values[n] = 4.0F * static_cast<float>(n % 5);
        QCOMPARE(sentencesOf(table).filter(QStringLiteral("slope")), QStringList());
    }

    void withoutUnitsNumbersAreCompared()
    {
        CompensationTable table = bump(4.04F, "");
        table.grid.axes = {{"", "", 0.0, 100.0, 5}, {"", "", 0.0, 500.0, 3}};
        QCOMPARE(sentencesOf(table),
            QStringList(QStringLiteral(
                "The largest correction, 4.04, is 1.01 % of the range of dimension 1, 400.")));
    }
};

AXISCOMP_TEST(TestLargeCorrection)

} // namespace tst_largecorrection

#include "tst_largecorrection.moc"
