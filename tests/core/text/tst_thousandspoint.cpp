// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/thousands_point.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_thousandspoint {

using namespace axiscomp;

class TestThousandsPoint : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aPointThatMayStandBetweenThousandsIsFound_data()
    {
        QTest::addColumn<QByteArray>("lines");
        QTest::addColumn<QByteArray>("found"); // "line:column number whole"
        const auto row = [](const char* name, const char* lines, const char* found) {
            QTest::newRow(name) << QByteArray(lines) << QByteArray(found);
        };
        row("beside hundreds", "750;1\n1.000;2\n", "8:1 1.000 750");
        row("before a 0", "0;1\n750;1\n1.000;2\n0;1\n", "9:1 1.000 750");
        row("in the second column", "1;-250\n2;-1.250\n", "8:2 1.250 250");
        row("with quotes, blanks and CRLF", "\"0\" ; 1\r\n \"+12.500\";2\r\n", "8:1 12.500 0");
        row("of comments nothing counts", "// 0.5\n0;1\n1.000;2\n", "9:1 1.000 0");
        row("nor behind blanks", " // 0.5\n0;1\n1.000;2\n", "9:1 1.000 0");
        row("a date says nothing", "0;1.05.2024\n1.000;2.05.2024\n", "8:1 1.000 0");
        row("other digits behind a point somewhere", "0;0.25\n1.000;1\n", "");
        row("a point behind 0", "0;0.250\n1.000;1\n", "");
        row("four digits before the point", "0;1\n1000.500;2\n", "");
        row("an exponent", "0;1\n1.000;2.000e3\n", "");
        row("thousands without a point", "0;1\n1.000;2\n2000;3\n", "");
        row("no number without a point", "1.000;1\n2.000;2\n", "");
        row("numbers without points in another column", "1.000;100\n2.000;200\n", "");
        row("nothing", "", "");
    }
    void aPointThatMayStandBetweenThousandsIsFound()
    {
        QFETCH(const QByteArray, lines);
        QFETCH(const QByteArray, found);
        const auto doubt =
            thousandsDoubt({lines.data(), static_cast<std::size_t>(lines.size())}, 7, ';');
        const std::string said = doubt
            ? std::to_string(doubt->line) + ':' + std::to_string(doubt->column) + ' '
                + std::string(doubt->number) + ' ' + std::string(doubt->whole)
            : std::string();
        QCOMPARE(QByteArray::fromStdString(said), found);
    }
};

AXISCOMP_TEST(TestThousandsPoint)

} // namespace tst_thousandspoint

#include "tst_thousandspoint.moc"
