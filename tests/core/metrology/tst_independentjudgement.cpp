// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random measurements, judged once more by a page of Python that shares no code with this program:
// check_judgement.py.
#include "core/metrology/judge/judgement.h"
#include "tests/core/metrology/measurement_reading.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <random>

namespace tst_independentjudgement {

using namespace axiscomp;
using nlohmann::json;

namespace {

/// A measurement as a machine might have been measured: with reversal, drift, gross errors, missing
/// and excluded values, one direction alone now and then, lines in any order.
class RandomFile {
public:
    explicit RandomFile(unsigned seed) : m_random(seed) { }

    [[nodiscard]] std::string next()
    {
        const bool isFine = oneIn(2);
        const int targets = between(2, 9);
        const bool hasDown = !oneIn(8);
        const double drift = oneIn(3) ? 0.002 : 0.0;
        const double holes = oneIn(4) ? 0.15 : 0.0;
        const double gross = oneIn(3) ? 0.05 : 0.0;
        const bool hasExcluded = oneIn(4);
        const int runs[] = {between(1, 6), hasDown ? between(1, 6) : 0};
        std::vector<std::string> lines;
        for (int target = 0; target < targets; ++target) {
            const double mean = 0.01 * normal();
            for (int direction = 0; direction < 2; ++direction)
                for (int run = 1; run <= runs[direction]; ++run) {
                    double value = mean + 0.001 * normal() + direction * 0.003 + drift * run;
                    value += chance(gross) ? 0.5 : 0.0;
                    if (chance(holes))
                        continue;
                    lines.push_back(std::to_string(12.5 * target + 0.25 * (target % 3))
                        + (direction == 0 ? ",+," : ",-,") + std::to_string(run) + ","
                        + std::to_string(isFine ? 1000.0 * value : value)
                        + (hasExcluded && chance(0.1) ? ",0" : ",1"));
                }
        }
        std::shuffle(lines.begin(), lines.end(), m_random);
        std::string text = std::string("target [mm],direction,run,deviation [")
            + (isFine ? "um" : "mm") + "],use\n";
        for (const std::string& line : lines)
            text += line + "\n";
        return text;
    }

private:
    int between(int low, int high) { return std::uniform_int_distribution(low, high)(m_random); }
    bool oneIn(int count) { return between(1, count) == 1; }
    bool chance(double share) { return std::uniform_real_distribution()(m_random) < share; }
    double normal() { return std::normal_distribution()(m_random); }

    std::mt19937 m_random;
};

json numberOrNull(const std::optional<double>& value)
{
    return value ? json(*value) : json(nullptr);
}

json flagged(const Measurement& measurement, const DirectionOutliers& outliers)
{
    json list = json::array();
    for (const Outlier& outlier : outliers.flagged)
        list.push_back({measurement.targets[outlier.target], outlier.run, outlier.score});
    return list;
}

json said(const Measurement& measurement)
{
    const Judgement judgement = judge(measurement, {});
    json axis = json::object();
    for (const Iso230Figure figure : allIso230Figures())
        axis[std::string(figureName(figure))] = numberOrNull(judgement.figures[figure].value);
    const Outliers& outliers = judgement.outliers;
    return {{"axis", std::move(axis)},
        {"firstToLast",
            {{"up", numberOrNull(judgement.driftUp.firstToLast)},
                {"down", numberOrNull(judgement.driftDown.firstToLast)}}},
        {"flagged",
            {{"up", flagged(measurement, outliers.up)},
                {"down", flagged(measurement, outliers.down)}}},
        {"disturbed", {{"up", outliers.up.isDisturbed}, {"down", outliers.down.isDisturbed}}}};
}

} // namespace

class tst_IndependentJudgement : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void anotherProgramJudgesTheSame()
    {
        const QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("measurements")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        RandomFile files(230);
        int written = 0;
        for (int n = 0; n < 400; ++n) {
            const std::string text = files.next();
            const MeasurementReading reading = test::readAs("runs", text);
            if (!reading.measurement) // too much of it is missing
                continue;
            const json line{{"csv", text}, {"said", said(*reading.measurement)}};
            file.write(QByteArray::fromStdString(line.dump() + "\n"));
            ++written;
        }
        file.close();
        QVERIFY(written > 300);
        QProcess python;
        python.start(QStringLiteral("python3"),
            {QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/core/metrology/check_judgement.py"),
                file.fileName()});
        QVERIFY(python.waitForFinished(-1));
        const QByteArray output = python.readAllStandardOutput() + python.readAllStandardError();
        QVERIFY2(python.exitStatus() == QProcess::NormalExit && python.exitCode() == 0,
            output.constData());
        QVERIFY2(output.contains(" 0 differences"), output.constData());
    }
};

AXISCOMP_TEST(tst_IndependentJudgement)

} // namespace tst_independentjudgement

#include "tst_independentjudgement.moc"
