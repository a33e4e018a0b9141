// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/target_axis.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

namespace tst_targetaxis {

using namespace axiscomp;
using Headers = std::vector<std::string>;

class TestTargetAxis : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aHeaderOfPositionsNamesAnAxisOrNone_data()
    {
        QTest::addColumn<QString>("header");
        QTest::addColumn<QString>("axis");
        for (const auto& [header, axis] :
            std::initializer_list<std::pair<const char*, const char*>>{{"X", "X"}, {"y", "y"},
                {"Z2", "Z2"}, {"X position", "X"}, {"Pos. X", "X"}, {"X-Achse", "X"},
                {"Position_Y", "Y"}, {"3", "3"}, {"C", "C"}, {"Position", ""}, {"Dim 1", ""},
                {"", ""}, {"X Y", ""}, {"Temperature", ""}, {"XYZ", ""}, {"1000", ""}})
            QTest::newRow(header) << QString::fromUtf8(header) << QString::fromUtf8(axis);
    }
    void aHeaderOfPositionsNamesAnAxisOrNone()
    {
        QFETCH(QString, header);
        QTEST(QString::fromStdString(std::string(axisInHeader(header.toStdString()))), "axis");
    }

    void namesOfDifferentLettersAreDifferentAxes_data()
    {
        QTest::addColumn<QString>("one");
        QTest::addColumn<QString>("other");
        QTest::addColumn<bool>("areDifferent");
        QTest::newRow("letters") << "X"
                                 << "Y" << true;
        QTest::newRow("small letters") << "x"
                                       << "Y" << true;
        QTest::newRow("one of two axes") << "X1"
                                         << "Y" << true;
        QTest::newRow("the same") << "X"
                                  << "x" << false;
        QTest::newRow("one of two axes may be meant") << "X"
                                                      << "X2" << false;
        QTest::newRow("blanks") << " X"
                                << "X " << false;
        QTest::newRow("a number") << "1"
                                  << "X" << false;
        QTest::newRow("a word") << "Spindle"
                                << "X" << false;
        QTest::newRow("nothing") << ""
                                 << "X" << false;
        QTest::newRow("a source by its number") << "#2"
                                                << "X" << false;
        QTest::newRow("no source") << "other"
                                   << "X" << false;
    }
    void namesOfDifferentLettersAreDifferentAxes()
    {
        QFETCH(QString, one);
        QFETCH(QString, other);
        QFETCH(bool, areDifferent);
        QCOMPARE(areDifferentAxes(one.toStdString(), other.toStdString()), areDifferent);
        QCOMPARE(areDifferentAxes(other.toStdString(), one.toStdString()), areDifferent);
    }

    void aHeaderOfValuesStatesATargetOrNone_data()
    {
        QTest::addColumn<QString>("header");
        QTest::addColumn<QString>("target");
        // over X position and Y
        for (const auto& [header, target] :
            std::initializer_list<std::pair<const char*, const char*>>{{"Z", "Z"}, {"dZ", "Z"},
                {"\u0394Z", "Z"}, {"Z error", "Z"}, {"Z-Abweichung", "Z"}, {"Error Z", "Z"},
                {"X", "X position"}, {"dX", "X position"}, {"x error", "X position"}, {"Y", "Y"},
                {"Table 1", ""}, {"Error", ""}, {"", ""}, {"1", ""}, {"A", ""}, {"B", ""},
                {"dimension", ""}, {"Zeiss", ""}, {"Z at 20 C", ""}})
            QTest::newRow(header) << QString::fromUtf8(header) << QString::fromUtf8(target);
    }
    void aHeaderOfValuesStatesATargetOrNone()
    {
        QFETCH(QString, header);
        const Headers headers{"X position", "Y"};
        QTEST(QString::fromStdString(targetInHeader(header.toStdString(), headers)), "target");
    }

    void aLetterThatCountsColumnsIsATargetOnlyAsASource()
    {
        QCOMPARE(targetInHeader("C", Headers{"C"}), std::string("C"));
        QCOMPARE(targetInHeader("C", Headers{"X"}), std::string());
        QCOMPARE(targetInHeader("C2", Headers{"X"}), std::string("C2"));
    }

    void aNameIsAnotherAxisOnlyWhereAllSourcesHaveNames()
    {
        const auto source = [](std::size_t n) { return std::optional(TargetAxis{n}); };
        const std::optional other = TargetAxis{};
        QCOMPARE(targetAxis("Y", Headers{"X", "Y"}), source(1));
        QCOMPARE(targetAxis("y", Headers{"X", "Y"}), source(1));
        QCOMPARE(targetAxis("Z", Headers{"X", "Y"}), other);
        QCOMPARE(targetAxis("Z", Headers{"X", ""}), std::optional<TargetAxis>());
        QCOMPARE(targetAxis("#1", Headers{"", ""}), source(0));
        QCOMPARE(targetAxis("#2", Headers{"X", "Y"}), source(1));
        QCOMPARE(targetAxis("#3", Headers{"X", "Y"}), std::optional<TargetAxis>());
        QCOMPARE(targetAxis("other", Headers{"", ""}), other);
        QCOMPARE(targetAxis("", Headers{"X"}), std::optional<TargetAxis>());
    }

    /// "Position" may be the axis that is named or another one.
    void aNameOverHeadersThatAreNoAxesStatesNothing()
    {
        QCOMPARE(targetAmong("X", Headers{"Position"}), std::string());
        QCOMPARE(targetAmong("X", Headers{"X position"}), std::string("X position"));
        QCOMPARE(targetAmong("Z", Headers{"X position", "Y"}), std::string("Z"));
        QCOMPARE(targetAmong("Z", Headers{"X", "Dim 2"}), std::string());
        QCOMPARE(targetAmong("#2", Headers{"X", "Dim 2"}), std::string("#2"));
        QCOMPARE(targetAmong("position", Headers{"Position"}), std::string("Position"));
    }

    void whatIsWrittenMeansTheSameToAReaderOfHeaders_data()
    {
        QTest::addColumn<QString>("statement");
        QTest::addColumn<QString>("sources");
        for (const char* sources : {"X", "X|Y", "|", "Position", "SPINDLE|X1", "X, left|Y", "1|3"})
            for (const char* statement :
                {"X", "Y", "Z", "#1", "#2", "other", "", "3", "X, left", "SPINDLE"})
                QTest::addRow("%s over %s", statement, sources)
                    << QString::fromUtf8(statement) << QString::fromUtf8(sources);
    }
    void whatIsWrittenMeansTheSameToAReaderOfHeaders()
    {
        QFETCH(QString, statement);
        QFETCH(QString, sources);
        Headers headers;
        for (const QString& source : sources.split(u'|'))
            headers.push_back(source.toStdString());
        const auto meant = targetAxis(statement.toStdString(), headers);
        const std::string written = portableTarget(statement.toStdString(), headers);
        const Headers listed = targetList(written + ", other");
        QCOMPARE(listed.size(), std::size_t{2});
        QCOMPARE(targetAxis(targetAmong(listed[0], headers), headers), meant);
    }
};

AXISCOMP_TEST(TestTargetAxis)

} // namespace tst_targetaxis

#include "tst_targetaxis.moc"
