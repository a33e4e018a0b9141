// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bytes.h"
#include "core/configuration/compensation_parameters.h"
#include "core/io/local_file.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <algorithm>
#include <array>

namespace tst_compensationparameters {

using namespace axiscomp;

namespace {

const std::string fileName = "machine.TAMcfg";

std::string fileText(const char* name)
{
    const std::string path = std::string(AXISCOMP_SOURCE_FOLDER "/tests/data/tamcfg/") + name;
    const auto bytes = loadFile(path, maximumConfigurationSize);
    return bytes ? std::string(asText(*bytes)) : std::string();
}

std::string component(const std::string& address, const std::string& type, const std::string& value)
{
    return "<RegisterComponent Address='" + address + "' Type='" + type + "' Value='" + value
        + "'/>\n";
}

const std::string axis0 = "Axes[0]/Parameters/Compensations/Axis/";

std::string document(const std::string& registers, const std::string& station = "Name='S'")
{
    return "<TamTopology>\n<TamStation " + station + ">\n" + registers
        + "</TamStation></TamTopology>\n";
}

CompensationParameters parametersOf(const std::string& text)
{
    const auto stations = readTamStations(text, fileName);
    const auto read = stations
        ? stationParameters(stations->front(), drivecomm::genericProfile(), fileName)
        : fail(stations.error());
    return read ? *read : CompensationParameters{"not read", {}, {}};
}

Result<std::string> with(const std::string& text, const CompensationParameters& parameters)
{
    AXISCOMP_TRY(const auto stations, readTamStations(text, fileName));
    return withParameters(
        text, stations.front(), parameters, drivecomm::genericProfile(), fileName);
}

CompensationParameters oneAxis(
    const std::string& slot, std::array<std::uint32_t, 3> sources, const std::string& unit = {})
{
    return {"", {}, {{0, unit, slot, sources}}};
}

/// How many bytes differ at the beginning and the end of what two texts share.
std::size_t sharedBytes(const std::string& a, const std::string& b)
{
    const auto first = std::ranges::mismatch(a, b).in1 - a.begin();
    const auto last = std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend()).first - a.rbegin();
    return static_cast<std::size_t>(first + last);
}

} // namespace

class TestCompensationParameters : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aStationIsRead()
    {
        const auto stations = readTamStations(fileText("two-drives.TAMcfg"), fileName);
        VERIFY_RESULT(stations);
        QCOMPARE(stations->size(), 2U);
        const auto gantry =
            stationParameters(stations->front(), drivecomm::genericProfile(), fileName);
        VERIFY_RESULT(gantry);
        QCOMPARE(gantry->name, std::string("Gantry"));
        QCOMPARE(gantry->serialNumber.value(), 2207);
        QCOMPARE(gantry->axes.size(), 2U);
        QCOMPARE(gantry->axes[0].slot, std::string("Small4"));
        QCOMPARE(gantry->axes[1].slot, std::string());
        QCOMPARE(gantry->axes[1].unit, std::string("Millimeter"));
        QCOMPARE(stationParameters(stations->back(), drivecomm::genericProfile(), fileName)
                     ->axes[0]
                     .unit,
            std::string("Degree"));
    }

    void onlyTheValuesChange_data()
    {
        QTest::addColumn<bool>("isFromWindows");
        QTest::newRow("lines that end in LF") << false;
        QTest::newRow("lines that end in CR LF") << true;
    }
    void onlyTheValuesChange()
    {
        QFETCH(const bool, isFromWindows);
        QString text = QString::fromStdString(fileText("two-drives.TAMcfg"));
        text.remove(u'\r');
        if (isFromWindows)
            text.replace(u'\n', QStringLiteral("\r\n"));
        const std::string before = text.toStdString();
        QVERIFY(!before.empty());
        const CompensationParameters old = parametersOf(before);
        CompensationParameters wanted = old;
        wanted.axes[0].slot = "Large1";
        wanted.axes[0].sources[0] = 4026531840U;
        const auto after = with(before, wanted);
        VERIFY_RESULT(after);
        QVERIFY(*after != before);
        QVERIFY(parametersOf(*after).axes == wanted.axes);
        const auto back = with(*after, old);
        VERIFY_RESULT(back);
        QVERIFY(*back == before);
        QVERIFY(*with(before, old) == before);
        // One register alone: everything before and after its value is shared.
        wanted = old;
        wanted.axes[0].sources[0] = 7;
        QCOMPARE(sharedBytes(before, *with(before, wanted)), before.size() - 1);
    }

    void aRepeatedRegisterChangesEverywhereAndCommentsNowhere()
    {
        const std::string text = document("<!-- " + component(axis0 + "Table", "T", "Small1")
            + " -->\n" + component(axis0 + "Table", "SourceTable", "Disabled")
            + component("Axes[0].Parameters.Compensations.Axis.Table", "SourceTable", "Small2"));
        QCOMPARE(parametersOf(text).axes[0].slot, std::string("Small2"));
        const auto after = with(text, oneAxis("Small3", {}));
        VERIFY_RESULT(after);
        QCOMPARE(QString::fromStdString(*after).count(QStringLiteral("Small3")), 2);
        QVERIFY(after->find("Small1") != std::string::npos);
        QVERIFY(after->find("Small2") == std::string::npos);
    }

    void whatTheStationCannotHoldIsRefusedWithItsName()
    {
        const std::string text = document(component(axis0 + "Table", "SourceTable", "Disabled")
            + component(axis0 + "Dim1Source", "UInt32", "0"));
        VERIFY_RESULT(with(text, oneAxis("Small1", {5, 0, 0})));
        const auto refused = with(text, oneAxis("Small1", {5, 6, 0}));
        VERIFY_ERROR(refused, ErrorCode::InvalidConfiguration);
        QVERIFY(sentence(refused.error()).find(axis0 + "Dim2Source") != std::string::npos);
    }

    void anAxisWithAnotherUnitIsRefused()
    {
        const std::string text = document(component(axis0 + "Table", "SourceTable", "Disabled")
            + component("Axes[0]/Parameters/PositionController/PositionUnit", "U", "degree"));
        VERIFY_RESULT(with(text, oneAxis("Small1", {}, "Degree")));
        const auto refused = with(text, oneAxis("Small1", {}, "Millimeter"));
        VERIFY_ERROR(refused, ErrorCode::InvalidConfiguration);
        QCOMPARE(refused.error().context.english("line"), std::string("4"));
    }

    void valuesThatAreNoneAreRefusedWithTheirLine()
    {
        for (const std::string& bad : {component(axis0 + "Table", "SourceTable", "Small9"),
                 component(axis0 + "Table", "SourceTable", "Small1")
                     + component(axis0 + "Dim1Source", "UInt32", "-1")}) {
            const auto stations = readTamStations(document(bad), fileName);
            VERIFY_RESULT(stations);
            const auto read =
                stationParameters(stations->front(), drivecomm::genericProfile(), fileName);
            VERIFY_ERROR(read, ErrorCode::InvalidConfiguration);
            const auto line = std::to_string(2 + std::ranges::count(bad, '\n'));
            QCOMPARE(read.error().context.english("line"), line);
        }
    }

    void theStationOfADriveIsFoundOrNamed()
    {
        const auto stations = *readTamStations(fileText("two-drives.TAMcfg"), fileName);
        QCOMPARE(stationFor(stations, fileName, 2208, {}, false).value_or(99), 1U);
        QCOMPARE(stationFor(stations, fileName, {}, "Gantry", false).value_or(99), 0U);
        QCOMPARE(stationFor(stations, fileName, {}, "2208", false).value_or(99), 1U);
        const auto unclear = stationFor(stations, fileName, 1, {}, false);
        VERIFY_ERROR(unclear, ErrorCode::InvalidArgument);
        QVERIFY(sentence(unclear.error()).find("Gantry (2207)") != std::string::npos);
        VERIFY_ERROR(stationFor(stations, fileName, 1, "Gantry", false), ErrorCode::OtherDrive);
        QCOMPARE(stationFor(stations, fileName, 1, "Gantry", true).value_or(99), 0U);

        const auto single =
            *readTamStations(document("", "Name='S' HardwareSerialNumber='5'"), fileName);
        QCOMPARE(stationFor(single, fileName, 5, {}, false).value_or(99), 0U);
        const auto other = stationFor(single, fileName, 6, {}, false);
        VERIFY_ERROR(other, ErrorCode::OtherDrive);
        QCOMPARE(other.error().context.english("expected"), std::string("5"));
        const auto unknown = *readTamStations(document(""), fileName);
        QCOMPARE(stationFor(unknown, fileName, 6, {}, false).value_or(99), 0U);
    }
};

AXISCOMP_TEST(TestCompensationParameters)

} // namespace tst_compensationparameters

#include "tst_compensationparameters.moc"
