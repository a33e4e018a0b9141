// SPDX-License-Identifier: GPL-3.0-or-later
// A bad cable. Set AXISCOMP_NOISE_RUNS=200 for more writes.
#include "tests/drivecomm/serial/serial_link_fixture.h"
#include "tests/support/test_registry.h"

namespace tst_serialnoise {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;

namespace {

int runsAskedFor(int usual)
{
    const int runs = qEnvironmentVariableIntValue("AXISCOMP_NOISE_RUNS");
    return runs > 0 ? runs : usual;
}

} // namespace

class SerialNoiseTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void aWriteEndsCorrectOrWithAnErrorAndTheOldTable();
    void readsAreRightOrAnError();
    void theSameRegisterIsNotSetTwice();
};

void SerialNoiseTest::aWriteEndsCorrectOrWithAnErrorAndTheOldTable()
{
    constexpr std::uint32_t oneIn = 2000;
    const int runs = runsAskedFor(8);
    int correct = 0;
    int flips = 0;
    SerialDrive served;
    Bytes before = fullTable(1.0F);
    VERIFY_RESULT(served.drive.upload(small1, before));
    for (int run = 0; run < runs; ++run) {
        const NoisyCable cable(served.server->device(), oneIn, static_cast<std::uint32_t>(run));
        const auto link = serialLinkTo(cable.url());
        const Bytes file = fullTable(0.001F * static_cast<float>(run + 2));
        const std::vector<RegisterWrite> writes{{variable0, static_cast<float>(run)}};
        auto written = link->upload(small1, file, within(60s));
        if (written)
            written = link->writeRegisters(writes, within(60s));
        const bool isCorrect = served.file(small1) == file;
        QVERIFY2(isCorrect || (!written && served.file(small1) == before),
            qPrintable(QStringLiteral("run %1").arg(run)));
        if (!written)
            QVERIFY2(written.error().code == ErrorCode::ConnectionLost
                    || written.error().code == ErrorCode::Timeout,
                describe(written.error()).c_str());
        else
            QCOMPARE(served.drive.readRegisters({variable0})->front().value, writes[0].value);
        const auto readBack = link->download(small1, within(60s));
        if (readBack)
            QVERIFY(*readBack == served.file(small1));
        if (!written)
            qInfo("run %d: %s", run, describe(written.error()).c_str());
        correct += written ? 1 : 0;
        flips += cable.flips();
        before = served.file(small1);
    }
    qInfo("%d of %d writes correct, %d bytes garbled", correct, runs, flips);
    QVERIFY(correct >= runs * 3 / 4);
}

void SerialNoiseTest::readsAreRightOrAnError()
{
    SerialDrive served;
    std::vector<std::string> paths;
    std::vector<RegisterWrite> writes;
    for (int n = 0; n < 16; ++n) {
        paths.push_back("Application/Variables/Floats[" + std::to_string(n) + "]");
        writes.push_back({paths.back(), static_cast<float>(n) * 1.1F});
    }
    VERIFY_RESULT(served.drive.writeRegisters(writes));
    const NoisyCable cable(served.server->device(), 2000, 99);
    const auto link = serialLinkTo(cable.url());
    int right = 0;
    for (int run = 0; run < 40; ++run) {
        const auto readings = link->readRegisters(paths, within(20s));
        if (!readings)
            continue;
        ++right;
        for (std::size_t i = 0; i < paths.size(); ++i)
            QCOMPARE(readings->at(i).value, writes[i].value);
    }
    QVERIFY2(right >= 38, qPrintable(QString::number(right)));
    QVERIFY(cable.flips() > 0);
}

void SerialNoiseTest::theSameRegisterIsNotSetTwice()
{
    // The reply is lost; meanwhile somebody else sets the register. Asked again, the drive answers
    // and does not act.
    SerialDrive served;
    const auto link = serialLinkTo(served.server->url());
    VERIFY_RESULT(link->identify({}));
    served.faults.clear();
    served.faults.add(parseFault("no-reply=1").value());
    served.faults.add(parseFault("stores-wrong=2").value());
    const std::vector<RegisterWrite> writes{{variable0, 1.0F}};
    VERIFY_RESULT(link->writeRegisters(writes, {}));
    QCOMPARE(served.drive.readRegisters({variable0})->front().value, RegisterValue(1.0F));
}

AXISCOMP_TEST(SerialNoiseTest)

} // namespace tst_serialnoise

#include "tst_serialnoise.moc"
