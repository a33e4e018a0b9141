// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "ui/outcome/multi_axis_outcome.h"
#include "ui/text/language.h"

#include <QTest>

#include <span>
#include <vector>

namespace tst_multiaxisoutcome {

using namespace axiscomp;
using namespace axiscomp::ui;

namespace {

std::vector<AxisEntry> axesXYZ()
{
    std::vector<AxisEntry> axes;
    for (const char* name : {"X", "Y", "Z"}) {
        const int index = static_cast<int>(axes.size());
        axes.emplace_back();
        axes.back().axis.index = index;
        axes.back().axis.name = name;
    }
    return axes;
}

/// What has become of X, Y and Z in this order: P is written and persistent, V written and
/// volatile, N written to have no table, and "-" had everything already.
QString outcomeOf(const QByteArray& axes)
{
    const Language language(QStringLiteral("en"));
    MultiAxisReport report;
    for (const char what : axes) {
        WriteReport written;
        CompensationSetup& now = written.now.setup;
        if (what != 'N')
            now.slot = "Small1";
        now.persistency = what == 'P' ? Persistency::Persistent : Persistency::Volatile;
        if (what == '-')
            report.writes.emplace_back(fail(ErrorCode::NothingToWrite));
        else
            report.writes.emplace_back(written);
    }
    const std::vector<AxisEntry> all = axesXYZ();
    const Outcome outcome =
        multiAxisOutcome(std::span(all).first(static_cast<std::size_t>(axes.size())), report);
    return outcome.isError ? QStringLiteral("error: ") + outcome.text : outcome.text;
}

} // namespace

class TestMultiAxisOutcome : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void onlyWhatWasWrittenIsSaidToBe_data()
    {
        QTest::addColumn<QString>("said");
        QTest::newRow("PP") << "Written and verified: X, Y. This is stored in flash.";
        QTest::newRow("-V") << "Written and verified: Y. This is volatile: a reboot of the drive "
                               "restores the stored state.";
        QTest::newRow("P-V") << "Written and verified: X, Z. Stored in flash: X. Volatile: Z; a "
                                "reboot of the drive restores the stored state.";
        QTest::newRow("PN") << "Written and verified: X, Y. Stored in flash: X.";
        QTest::newRow("NV") << "Written and verified: X, Y. Volatile: Y; a reboot of the drive "
                               "restores the stored state.";
        QTest::newRow("N-") << "Written and verified: X.";
        QTest::newRow("--") << "The axes already had all of this.";
    }
    void onlyWhatWasWrittenIsSaidToBe()
    {
        QFETCH(const QString, said);
        QCOMPARE(outcomeOf(QTest::currentDataTag()), said);
    }

    void anAxisThatHadEverythingHoldsTheNewStateWhereALaterOneFails()
    {
        const Language language(QStringLiteral("en"));
        MultiAxisReport report;
        report.writes.emplace_back(fail(ErrorCode::NothingToWrite));
        report.writes.emplace_back(fail(ErrorCode::Cancelled));
        const Outcome outcome = multiAxisOutcome(axesXYZ(), report);
        QVERIFY(outcome.isError);
        QCOMPARE(outcome.text,
            QStringLiteral("The writes were stopped at Y. New state: X. Old state, complete: Y, "
                           "Z."));
    }
};

AXISCOMP_TEST(TestMultiAxisOutcome)

} // namespace tst_multiaxisoutcome

#include "tst_multiaxisoutcome.moc"
