// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/table_choice.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <vector>

namespace tst_tablechoice {

using namespace axiscomp;

namespace {

/// By their targets, as the tables of a file without names are called.
const std::vector<TableName> byTarget{{"X", "Y to X"}, {"Y", "Y to Y"}, {"1", "Y to 1"}};

} // namespace

class TestTableChoice : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aTableIsChosenAsTheListNamesIt_data()
    {
        QTest::addColumn<std::string>("asked");
        QTest::addColumn<int>("index");
        const auto row = [](const char* asked, int index) {
            QTest::newRow(asked) << std::string(asked) << index;
        };
        row("Y", 1);
        row("2", 1);
        row("#1", 0);
        row("Y to X", 0);
        row("name:Y to 1", 2);
        row("name:1", 2);
    }
    void aTableIsChosenAsTheListNamesIt()
    {
        QFETCH(const std::string, asked);
        QFETCH(const int, index);
        const auto chosen = chooseTable(byTarget, asked);
        VERIFY_RESULT(chosen);
        QCOMPARE(*chosen, static_cast<std::size_t>(index));
    }

    void aNumberThatIsAnotherTablesNameIsRefused()
    {
        VERIFY_ERROR(chooseTable(byTarget, "1"), ErrorCode::TableAmbiguous);
    }

    void aNameThatNoTableHasIsRefused()
    {
        for (const char* asked : {"Z", "4", "#0", "name:2", "Z to Y"})
            VERIFY_ERROR(chooseTable(byTarget, asked), ErrorCode::TableNotFound);
    }

    void aNameOfSeveralTablesIsRefused()
    {
        const std::vector<TableName> alike{{"Y", "X to Y"}, {"Y", "Z to Y"}, {"X", "X to X"}};
        const auto refused = chooseTable(alike, "Y");
        VERIFY_ERROR(refused, ErrorCode::TableAmbiguous);
        const std::string said = sentence(refused.error());
        QVERIFY2(said.find("several tables are called Y") != std::string::npos
                && said.find("2 (Z to Y)") != std::string::npos,
            said.c_str());
        QCOMPARE(chooseTable(alike, "Z to Y").value(), std::size_t{1});
        QCOMPARE(chooseTable(alike, "#2").value(), std::size_t{1});
    }
};

AXISCOMP_TEST(TestTableChoice)

} // namespace tst_tablechoice

#include "tst_tablechoice.moc"
