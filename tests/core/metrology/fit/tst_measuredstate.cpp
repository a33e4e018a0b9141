// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/known_tables.h"
#include "core/table/tam_table.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_measuredstate {

using namespace axiscomp;
using Kind = MeasuredState::Kind;

namespace {

KnownTables known(const char* name, std::uint32_t crc)
{
    CompensationTable table;
    table.grid.axes = {{"X", "mm", 0.0, 1.0, 2}};
    table.values = {0.0F, 1.0F};
    return {Verbatim{name}, {table}, {crc}};
}

constexpr std::uint32_t first = 0x1c291ca3;
constexpr std::uint32_t second = 0x00c0ffee;

} // namespace

class TestMeasuredState : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aTableIsRefusedWhereRecordAndRequestDisagree_data()
    {
        QTest::addColumn<int>("onFile");
        QTest::addColumn<quint32>("fileCrc"); // 0: none
        QTest::addColumn<int>("stated"); // -1: nothing
        QTest::addColumn<bool>("isMerged");
        QTest::addColumn<QString>("words");
        const int none = static_cast<int>(Kind::NotSaid);
        const int off = static_cast<int>(Kind::Off);
        const int on = static_cast<int>(Kind::On);
        QTest::newRow("off and merged")
            << off << 0U << -1 << true << "must not be added to old.csv";
        QTest::newRow("on and not merged")
            << on << first << -1 << false << "residuals of the table 1c291ca3";
        QTest::newRow("on, table not said, not merged")
            << on << 0U << -1 << false << "residuals of a table that was active";
        QTest::newRow("unknown table")
            << on << second << -1 << true << "with the table 00c0ffee active, which is not old.csv";
        QTest::newRow("not on record") << none << 0U << -1 << false << "--measured-with off";
        QTest::newRow("stated otherwise")
            << off << 0U << on << true << "the compensation off, not with the compensation on";
        QTest::newRow("stated off and merged") << none << 0U << off << true << "leave out --onto";
    }
    void aTableIsRefusedWhereRecordAndRequestDisagree()
    {
        QFETCH(int, onFile);
        QFETCH(quint32, fileCrc);
        QFETCH(int, stated);
        QFETCH(bool, isMerged);
        QFETCH(QString, words);
        const KnownTables old = known("old.csv", first);
        StateRequest request;
        request.onFile.kind = static_cast<Kind>(onFile);
        if (fileCrc != 0)
            request.onFile.tableCrc = fileCrc;
        if (stated >= 0)
            request.stated = MeasuredState{static_cast<Kind>(stated), {}};
        request.onto = isMerged ? &old : nullptr;
        const auto found = findState(request);
        VERIFY_ERROR(found, ErrorCode::MeasurementState);
        QVERIFY2(QString::fromStdString(sentence(found.error())).contains(words),
            sentence(found.error()).c_str());
    }

    void whatSomeOfTheFilesSayIsNotStatedOtherwise()
    {
        const KnownTables old = known("old.csv", first);
        StateRequest request;
        request.onSomeFiles = {Kind::On, second};
        request.stated = MeasuredState{Kind::Off, {}};
        auto found = findState(request);
        VERIFY_ERROR(found, ErrorCode::MeasurementState);
        QVERIFY2(sentence(found.error()).find("with the table 00c0ffee active, not with")
                != std::string::npos,
            sentence(found.error()).c_str());
        // The others say nothing, so that it has to be stated of them.
        request.stated.reset();
        found = findState(request);
        VERIFY_ERROR(found, ErrorCode::MeasurementState);
        QVERIFY(sentence(found.error()).find("does not say") != std::string::npos);
        // That table is what they are merged onto.
        request.onto = &old;
        request.stated = MeasuredState{Kind::On, {}};
        VERIFY_ERROR(findState(request), ErrorCode::MeasurementState);
        request.onSomeFiles = {Kind::On, first};
        found = findState(request);
        VERIFY_RESULT(found);
        QCOMPARE(found->tableCrc, std::optional(first));
    }

    void theTableThatWasActiveIsFoundAmongAllThatAreKnown()
    {
        const KnownTables now = known("the table of axis 0", first);
        const std::vector<KnownTables> backups{known("a", 7), known("b", second)};
        StateRequest request;
        request.onto = &now;
        request.others = backups;
        request.onFile = {Kind::On, first};
        auto found = findState(request);
        VERIFY_RESULT(found);
        QCOMPARE(found->active, &now);
        QVERIFY(found->assumption.isEmpty());
        request.onFile = {Kind::On, second};
        found = findState(request);
        VERIFY_RESULT(found);
        QCOMPARE(found->active, &backups[1]);
        QCOMPARE(found->kind, FoundState::Kind::On);
    }

    /// The measurement has the CRC alone.
    void theSameValuesOverOtherPositionsLeaveOpenWhichTableWasActive()
    {
        const KnownTables now = known("the table of axis 0", first);
        std::vector<KnownTables> backups{known("a", first)};
        StateRequest request;
        request.onto = &now;
        request.others = backups;
        request.onFile = {Kind::On, first};
        VERIFY_RESULT(findState(request));
        backups[0].tables[0].grid.axes[0].start = 50.0;
        const auto found = findState(request);
        VERIFY_ERROR(found, ErrorCode::MeasurementState);
        QVERIFY2(sentence(found.error()).find("the table of axis 0 and a have the same values")
                != std::string::npos,
            sentence(found.error()).c_str());
        request.others = {};
        VERIFY_RESULT(findState(request));
    }

    void aTableThatWasActiveWithOtherSourcesIsNotTakenForItsPlaces()
    {
        KnownTables onto = known("the table of axis 0", first);
        StateRequest request;
        request.onto = &onto;
        request.onFile = {MeasuredState::Kind::On, onto.crcs.front()};
        VERIFY_RESULT(findState(request));
        onto.hadOtherSources = true;
        const auto refused = findState(request);
        VERIFY_ERROR(refused, ErrorCode::MeasurementState);
        QVERIFY(sentence(refused.error()).find("measure again") != std::string::npos);
        request.onFile.tableCrc.reset();
        VERIFY_ERROR(findState(request), ErrorCode::MeasurementState);
    }

    void aTableThatIsNotNamedIsTakenForGrantedAloud()
    {
        const KnownTables now = known("old.csv", first);
        StateRequest request;
        request.onto = &now;
        request.onFile = {Kind::On, {}};
        const auto found = findState(request);
        VERIFY_RESULT(found);
        QVERIFY2(found->assumption.english().find("1c291ca3") != std::string::npos,
            found->assumption.english().c_str());
    }

    /// 1 um at 100 mm: an axis in m holds 1e-6, one in mm 1e-3, and the file may have um.
    void aTableIsKnownByItsCrcInWhicheverUnitTheAxisIs()
    {
        const TableLayout layout = drivecomm::genericProfile().layout;
        const auto crcOf = [&layout](float value) {
            CompensationTable table;
            table.grid.axes = {{"X", "", 0.0, 100.0, 2}};
            table.values = {0.0F, value};
            return elementCrc(table, layout).value_or(0);
        };
        CompensationTable file;
        file.unit = "um";
        file.grid.axes = {{"X", "m", 0.0, 0.1, 2}};
        file.values = {0.0F, 1.0F};
        KnownTables onto{Verbatim{"m.csv"}, {}, {}};
        VERIFY_RESULT(addTable(onto, file, {}, "mm", layout, nullptr));
        QCOMPARE(onto.tables.front().values.back(), 0.001F);
        QCOMPARE(onto.crcs.front(), crcOf(0.001F));
        StateRequest request;
        request.onto = &onto;
        MeasurementHeader header;
        for (const std::uint32_t crc : {crcOf(1.0F), crcOf(0.001F), crcOf(1e-6F)}) {
            request.onFile = {Kind::On, crc};
            const auto found = findState(request);
            VERIFY_RESULT(found);
            QCOMPARE(found->active, &onto);
            header.compensation = request.onFile;
            QCOMPARE(statedTable(onto, 0, header).tableCrc, std::optional(crc));
        }
        request.onFile = {Kind::On, crcOf(0.1F)};
        VERIFY_ERROR(findState(request), ErrorCode::MeasurementState);
        header.compensation = request.onFile;
        QCOMPARE(statedTable(onto, 0, header).tableCrc, std::optional(crcOf(0.001F)));
    }

    /// The numbers of a table in m are as likely those of another one in mm.
    void aTableWithoutAUnitIsNotKnownByItsCrcAlone()
    {
        const TableLayout layout = drivecomm::genericProfile().layout;
        CompensationTable file;
        file.grid.axes = {{"X", "", 0.0, 0.1, 2}};
        file.values = {0.0F, 1e-6F};
        KnownTables onto{Verbatim{"m.TAMtbl"}, {}, {}};
        VERIFY_RESULT(addTable(onto, file, {}, "mm", layout, nullptr));
        StateRequest request;
        request.onto = &onto;
        request.onFile = {Kind::On, onto.crcs.front()};
        const auto refused = findState(request);
        VERIFY_ERROR(refused, ErrorCode::MeasurementState);
        QVERIFY2(sentence(refused.error()).find("m.TAMtbl does not say the unit of its numbers")
                != std::string::npos,
            sentence(refused.error()).c_str());
        // Without a CRC a person says which table it was, and a remark what is assumed of its unit.
        request.onFile = {Kind::On, {}};
        VERIFY_RESULT(findState(request));
        // A drive's own table is in the unit of the axis.
        KnownTables ofDrive{Verbatim{"the table of axis 0"}, {}, {}};
        VERIFY_RESULT(addTable(ofDrive, file, onto.crcs.front(), "mm", layout, nullptr));
        request.onto = &ofDrive;
        request.onFile = {Kind::On, onto.crcs.front()};
        VERIFY_RESULT(findState(request));
    }

    void theAxisThatIsStatedGoesWithTheState()
    {
        KnownTables onto = known("the table of axis 0", first);
        StateRequest request;
        request.axis = "Y";
        request.onFile.kind = Kind::Off;
        const auto off = findState(request);
        VERIFY_RESULT(off);
        QCOMPARE(off->axis, std::string("Y"));
        request.onFile.kind = Kind::On;
        request.onto = &onto;
        const auto on = findState(request);
        VERIFY_RESULT(on);
        QCOMPARE(on->axis, std::string("Y"));
        request.hasRawReadings = true;
        const auto irrelevant = findState(request);
        VERIFY_RESULT(irrelevant);
        QCOMPARE(irrelevant->axis, std::string("Y"));
    }

    void rawReadingsMakeTheStateIrrelevant()
    {
        StateRequest request;
        request.hasRawReadings = true;
        const auto found = findState(request);
        VERIFY_RESULT(found);
        QCOMPARE(found->kind, FoundState::Kind::Irrelevant);
        QVERIFY(!found->text.isEmpty());
    }

    /// What that table has between the targets would be kept at other places.
    void rawReadingsAreNotMergedOntoATableOfOtherSources()
    {
        KnownTables onto = known("the table of axis 0", first);
        StateRequest request;
        request.hasRawReadings = true;
        request.onto = &onto;
        const auto found = findState(request);
        VERIFY_RESULT(found);
        QCOMPARE(found->active, &onto);
        onto.hadOtherSources = true;
        const auto refused = findState(request);
        VERIFY_ERROR(refused, ErrorCode::MeasurementState);
        QVERIFY2(sentence(refused.error()).find("leave out --onto") != std::string::npos,
            sentence(refused.error()).c_str());
    }
};

AXISCOMP_TEST(TestMeasuredState)

} // namespace tst_measuredstate

#include "tst_measuredstate.moc"
