// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/compensation_setup.h"
#include "core/drive/drive_profile.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_driveprofile {

using namespace axiscomp;

class TestDriveProfile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void placeholdersAreReplaced_data()
    {
        QTest::addColumn<std::string>("pattern");
        QTest::addColumn<std::string>("expected");
        const auto row = [](const char* pattern, const char* expected) {
            QTest::newRow(pattern) << std::string(pattern) << std::string(expected);
        };
        row("Axes[{axis}]/Dim{n}Source", "Axes[2]/Dim3Source");
        row("Tables/{slot}/Size[{n}]", "Tables/Small1/Size[3]");
        row("{axis}{axis}", "22");
        row("General/Signals", "General/Signals");
        row("", "");
        row("{other}/{axis}", "{other}/2");
        row("Axes[{axis", "Axes[{axis");
        row("a}{axis}", "a}2");
    }
    void placeholdersAreReplaced()
    {
        QFETCH(std::string, pattern);
        QFETCH(std::string, expected);
        QCOMPARE(expandPath(pattern, {2, "Small1", 3}), expected);
    }

    void aPlaceholderWithoutAnArgumentStays()
    {
        QCOMPARE(expandPath("Axes[{axis}]/Dim{n}Source", {0, {}, {}}), "Axes[0]/Dim{n}Source");
        QCOMPARE(expandPath("Tables/{slot}", {}), "Tables/{slot}");
    }

    void aSourceIsNamedByItsPathOrByItsAddress()
    {
        QCOMPARE(sourceName({0xABCD, "Axes[0]/Signals/Position"}), "Axes[0]/Signals/Position");
        QCOMPARE(sourceName({0xABCD, {}}), "0x0000abcd");
    }

    void theSameSourcesAreThoseOfTheUsedDimensionsInTheirOrder()
    {
        const auto haveSame = [](const CompensationSetup& a, const CompensationSetup& b) {
            return haveSameSources(a, b) && haveSameSources(b, a);
        };
        CompensationSetup one;
        one.dimensionality = 2;
        one.sources = {DimSource{1, "X"}, DimSource{2, "Y"}, DimSource{3, "Z"}};
        CompensationSetup other = one;
        other.sources[2] = {4, "T"}; // is not used
        QVERIFY(haveSame(one, other));
        std::swap(other.sources[0], other.sources[1]);
        QVERIFY(!haveSame(one, other));
        other = one;
        other.dimensionality = 1;
        QVERIFY(!haveSame(one, other));
        other.dimensionality = 3;
        QVERIFY(!haveSame(one, other));
    }

    void theTableAndEverySourceOfAnAxisAreItsRegisters()
    {
        DriveProfile profile;
        profile.registers.table = "Axes[{axis}]/Table";
        profile.registers.source = "Axes[{axis}]/Dim{n}Source";
        const std::vector<std::string> expected{
            "Axes[1]/Table", "Axes[1]/Dim1Source", "Axes[1]/Dim2Source", "Axes[1]/Dim3Source"};
        QVERIFY(axisRegisterPaths(profile, 1) == expected);
    }

    void slotsAreFoundByNameAndByFile()
    {
        DriveProfile profile;
        profile.tableSlots = {{"Small1", "tables/small1.TAMtbl", 100}, {"Large1", "tables/l", 200}};
        QCOMPARE(profile.slotNamed("Large1"), &profile.tableSlots[1]);
        QCOMPARE(profile.slotOfFile("tables/small1.TAMtbl"), &profile.tableSlots[0]);
        QVERIFY(profile.slotNamed("large1") == nullptr);
        QVERIFY(profile.slotNamed("") == nullptr);
        QVERIFY(profile.slotOfFile("Small1") == nullptr);
    }

    void namesArePackedLittleEndian()
    {
        QCOMPARE(packName("Abcde", 2), (std::vector<std::int32_t>{0x64636241, 0x00000065}));
        QCOMPARE(unpackName({0x64636241, 0x00000065}), "Abcde");
        QCOMPARE(packName("", 1), std::vector<std::int32_t>{0});
        QCOMPARE(packName("X", 0), std::vector<std::int32_t>{});
        QCOMPARE(packName("X", -1), std::vector<std::int32_t>{});
    }

    void namesComeBack_data()
    {
        QTest::addColumn<std::string>("name");
        QTest::addColumn<std::string>("expected");
        const auto row = [](const char* title, const std::string& name,
                             const std::string& expected) {
            QTest::newRow(title) << name << expected;
        };
        row("empty", "", "");
        row("shorter", "X1", "X1");
        row("full", "Abcdefgh", "Abcdefgh");
        row("longer is cut", "Abcdefghi", "Abcdefgh");
        row("cut at a character", "Abcdefg\xC3\xA4", "Abcdefg");
        row("umlaut", "Tr\xC3\xA4ger", "Tr\xC3\xA4ger");
    }
    void namesComeBack()
    {
        QFETCH(std::string, name);
        QFETCH(std::string, expected);
        QCOMPARE(unpackName(packName(name, 2)), expected);
    }

    void aNameEndsAtItsFirstZeroByteAndIsAlwaysText()
    {
        QCOMPARE(unpackName({0x00410042, 0x41414141}), "B");
        QCOMPARE(unpackName({}), "");
        QCOMPARE(unpackName({-1}), "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");
        QCOMPARE(unpackName({0x411B0A42}), "B\u240a\u241bA");
    }
};

AXISCOMP_TEST(TestDriveProfile)

} // namespace tst_driveprofile

#include "tst_driveprofile.moc"
