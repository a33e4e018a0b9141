// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/diagnostic.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

namespace tst_diagnosticlist {

using namespace axiscomp;

class TestDiagnosticList : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void whatIsAppendedIsAsIfItHadBeenFoundThere()
    {
        for (const std::size_t maximum : {1, 2, 3, 10}) {
            DiagnosticList due(maximum);
            DiagnosticList first(maximum);
            DiagnosticList second(maximum);
            const auto add = [&](DiagnosticList& part, std::size_t line) {
                for (DiagnosticList* const list : {&due, &part}) {
                    list->error(DiagnosticCode::NotANumber, line, 1, {}, {});
                    list->warning(DiagnosticCode::Assumption, line + 1, 1, {}, {});
                }
            };
            add(first, 7);
            add(first, 3);
            add(second, 5);
            add(second, 1);
            due.countErrors(4);
            second.countErrors(4);
            first.append(std::move(second));
            QVERIFY(first.hasErrors());
            QCOMPARE(first.suppressed(), due.suppressed());
            QVERIFY(first.take() == due.take());
        }
    }

    void anEmptyListAddsNothing()
    {
        DiagnosticList list(3);
        list.append(DiagnosticList(3));
        QVERIFY(!list.hasErrors());
        QCOMPARE(list.suppressed(), std::size_t{0});
        QVERIFY(list.take().empty());
    }
};

AXISCOMP_TEST(TestDiagnosticList)

} // namespace tst_diagnosticlist

#include "tst_diagnosticlist.moc"
