// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_softmcbasic {

using namespace axiscomp;

namespace {

const TableFamily& family = softmc_basic::format();

NeutralTable twoSources()
{
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.axes = {test::evenAxis("X", "mm", 100, 10, 2), test::evenAxis("Y", "mm", -1, 0.5, 3)};
    table.columns = {test::waveColumn("X", "mm", 6, 1), test::waveColumn("Y", "mm", 6, 1)};
    table.columns[0].values = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
    table.columns[1].values = {-1, -2, -3, -4, -5, -6};
    return table;
}

bool mentions(const std::string& text, std::string_view part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

class TestSoftmcBasic : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void bothIndicesBeginAtOne()
    {
        NeutralTable table;
        table.axes = {test::evenAxis("1", "mm", 0, 120, 2)};
        table.columns = {test::waveColumn("1", "mm", 2, 1)};
        table.columns[0].values = {0, 0.125};
        const auto written = family.write(std::array{table}, {});
        VERIFY_RESULT(written);
        QCOMPARE(written->bytes,
            std::string("' Compensation table Comp1: 2 points\n"
                        "Comp1.SourceData[1][1] = 0\nComp1.TargetData[1][1] = 0\n"
                        "Comp1.SourceData[1][2] = 120\nComp1.TargetData[1][2] = 0.125\n"));
    }

    void everyPointHasAPositionOfEachSourceTheFirstFastest()
    {
        const auto written = family.write(std::array{twoSources()}, {});
        VERIFY_RESULT(written);
        QVERIFY(mentions(written->bytes,
            "Comp1.SourceData[1][2] = 110\nComp1.SourceData[2][2] = -1\n"
            "Comp1.TargetData[1][2] = 0.2\nComp1.TargetData[2][2] = -2\n"
            "Comp1.SourceData[1][3] = 100\nComp1.SourceData[2][3] = -0.5\n"));
        QVERIFY(mentions(written->bytes, "Comp1.SourceData[2][6] = 0\n"));
        QVERIFY(written->bytes.ends_with("Comp1.TargetData[2][6] = -6\n"));
    }

    void theAssignmentsAreTheRowsOfTheTextTable()
    {
        const auto basic = family.write(std::array{twoSources()}, {});
        const auto text = softmc::format().write(std::array{twoSources()}, {});
        VERIFY_RESULT(basic);
        VERIFY_RESULT(text);
        std::string rows = "2 2 3\n";
        std::size_t numbers = 0;
        for (std::size_t at = basic->bytes.find(" = "); at != std::string::npos;
             at = basic->bytes.find(" = ", at + 1))
            rows += basic->bytes.substr(at + 3, basic->bytes.find('\n', at) - at - 3)
                + (++numbers % 4 == 0 ? '\n' : ' ');
        QCOMPARE(rows, text->bytes);
        QVERIFY(basic->held.front() == twoSources());
    }

    void theNameIsTheSettingAndANameOfMcBasic()
    {
        TableWriteOptions options;
        options.settings = {{"name", "Gantry_1"}};
        const auto written = family.write(std::array{twoSources()}, options);
        VERIFY_RESULT(written);
        QVERIFY(mentions(written->bytes, "\nGantry_1.TargetData[2][6] = -6\n"));
        for (const char* name : {"1st", "_x", "a b", "x.y", "a[1]", "\u00e4"}) {
            options.settings = {{"name", name}};
            VERIFY_ERROR(
                family.write(std::array{twoSources()}, options), ErrorCode::InvalidArgument);
        }
    }

    void valuesAreWrittenInTheUnitsOfTheSettings()
    {
        TableWriteOptions options;
        options.settings = {{"position-unit", "m"}, {"value-unit", "um"}};
        const auto written = family.write(std::array{twoSources()}, options);
        VERIFY_RESULT(written);
        QVERIFY(mentions(written->bytes, "Comp1.SourceData[1][1] = 0.1\n"));
        QVERIFY(mentions(written->bytes, "Comp1.TargetData[1][1] = 100\n"));
    }

    void theRemarksSayThatTheTableMustNotBeInUse()
    {
        const auto written = family.write(std::array{twoSources()}, {});
        VERIFY_RESULT(written);
        const bool isSaid = std::ranges::any_of(written->remarks, [](const std::string& remark) {
            return mentions(remark, "CompActive = 0") && mentions(remark, "2 x 3 points");
        });
        QVERIFY(isSaid);
    }

    void whatTheFactsRefuseIsRefused()
    {
        NeutralTable uneven = twoSources();
        uneven.axes[1].knots[1] = 0.25;
        uneven.axes[1].knots[2] = 3;
        VERIFY_ERROR(checkHolds(family.facts, std::array{uneven}), ErrorCode::FormatCannotHold);
        VERIFY_RESULT(checkHolds(family.facts, std::array{twoSources()}));
    }

    void itIsWrittenOnly()
    {
        QVERIFY(family.read == nullptr && family.recognise == nullptr);
        QCOMPARE(test::applied(family, twoSources(), {99, 0}), 0.0); // before the first value
    }
};

AXISCOMP_TEST(TestSoftmcBasic)

} // namespace tst_softmcbasic

#include "tst_softmcbasic.moc"
