// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"

#include <QStandardItemModel>
#include <QTest>

namespace tst_wizardaxes {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

namespace {

drivecomm::VirtualDriveOptions withAxes(std::vector<drivecomm::VirtualAxis> axes)
{
    auto options = PageFixture::twoAxes();
    options.axes = std::move(axes);
    return options;
}

QStringList entriesOf(const QComboBox& box)
{
    QStringList entries;
    for (int i = 0; i < box.count(); ++i)
        entries += box.itemText(i);
    return entries;
}

} // namespace

/// Drives and axes that are not as one expects them.
class TestWizardAxes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void sixtyFourAxesCanBeChosenFrom()
    {
        std::vector<drivecomm::VirtualAxis> many;
        for (int i = 0; i < 64; ++i)
            many.push_back({.name = "A" + std::to_string(i)});
        PageFixture bench(withAxes(many));
        QVERIFY(bench.open());
        auto& axes = bench.user.the<QComboBox>("axisField");
        QTRY_COMPARE(axes.count(), 64);
        QVERIFY(bench.user.choose("axisField", QStringLiteral("A63 · ")));
        QTRY_VERIFY(bench.controller().status() && bench.controller().status()->axis.index == 63);
        QCOMPARE(axes.currentText(), QStringLiteral("A63 · Stage-7"));
        QVERIFY(bench.window.windowTitle().contains(QStringLiteral("A63")));
        QVERIFY(bench.user.enter(
            "source1Field", QStringLiteral("Axes[63]/Signals/PositionController/MasterPosition")));
        QTRY_VERIFY(bench.controller().setup().edited().sources[0].isSet());
    }

    void axesOfTheSameNameAreToldApart()
    {
        PageFixture bench(withAxes({{.name = "X"}, {.name = "X"}}));
        QVERIFY(bench.open());
        const QStringList entries = entriesOf(bench.user.the<QComboBox>("axisField"));
        QCOMPARE(entries,
            (QStringList{QStringLiteral("X [0] · Stage-7"), QStringLiteral("X [1] · Stage-7")}));
        QVERIFY(bench.user.choose("axisField", QStringLiteral("X [1]")));
        QTRY_VERIFY(bench.controller().status() && bench.controller().status()->axis.index == 1);
    }

    void anAxisWithoutANameHasItsNumber()
    {
        PageFixture bench(withAxes({{.name = ""}, {.name = "Y"}}));
        QVERIFY(bench.open());
        QCOMPARE(entriesOf(bench.user.the<QComboBox>("axisField")).front(),
            QStringLiteral("Axis 0 · Stage-7"));
        QVERIFY(bench.window.windowTitle().contains(QStringLiteral("Axis 0")));
        QVERIFY(bench.user.choose("source1Field", QStringLiteral("Axes[0]")));
        QTRY_VERIFY(bench.controller().setup().edited().sources[0].isSet());
    }

    void aDriveWithoutCompensationRegistersSaysSo()
    {
        DriveProfile profile = drivecomm::genericProfile();
        profile.registers.state = "Axes[{axis}]/Signals/Compensations/Axis/NoSuchState";
        profile.registers.table = "Axes[{axis}]/Parameters/Compensations/Axis/NoSuchTable";
        PageFixture bench(PageFixture::twoAxes(), QStringLiteral("en"), profile);
        bench.controller().setEndpoints({bench.served.url()});
        QVERIFY(bench.user.isThere());
        auto& axes = bench.user.the<QComboBox>("axisField");
        QTRY_COMPARE(axes.count(), 2);
        QCOMPARE(axes.itemText(0), QStringLiteral("X · Stage-7 (no compensation)"));
        const auto* items = qobject_cast<const QStandardItemModel*>(axes.model());
        QVERIFY(!items->item(0)->isEnabled());
        QCOMPARE(
            items->item(0)->toolTip(), QStringLiteral("This axis has no compensation registers."));
        QCOMPARE(axes.currentIndex(), -1);
        QVERIFY(!bench.user.hint().isEmpty());
        for (const char* name : {"writeButton", "activateButton", "deactivateButton",
                 "dimensionalityField", "tableField", "persistencyField"})
            QVERIFY2(!bench.user.the(name).isEnabled(), name);
        QCOMPARE(bench.user.the<QLabel>("driveState").text(), QStringLiteral("connected"));
    }

    void twoDrivesAreInOneListAndOneMayBeAway()
    {
        PageFixture bench;
        test::ServedDrive other([] {
            auto options = PageFixture::twoAxes();
            options.name = "Gantry";
            options.serialNumber = 42;
            return options;
        }());
        bench.controller().setEndpoints({bench.served.url(), other.url()});
        QVERIFY(bench.user.isThere());
        auto& axes = bench.user.the<QComboBox>("axisField");
        QTRY_COMPARE(axes.count(), 4);
        QTRY_VERIFY(bench.controller().status().has_value());
        QVERIFY(bench.user.choose("driveField", QStringLiteral("Gantry")));
        QTRY_VERIFY(
            bench.controller().status() && bench.controller().status()->drive.serialNumber == 42);
        QCOMPARE(axes.currentText(), QStringLiteral("X · Gantry"));
        // The one that is not shown goes away: the page says nothing against the one that is.
        bench.served.stop();
        QVERIFY(bench.user.click("refreshButton"));
        QTRY_VERIFY(bench.controller().drives()[0].connection == DriveState::Connection::Lost);
        QVERIFY(bench.user.message("connectionMessage").isEmpty());
        QCOMPARE(axes.count(), 4);
        QVERIFY(!bench.controller().axes()[0].isUsable);
        QVERIFY(bench.controller().axes()[2].isUsable);
    }
};

AXISCOMP_WINDOW_TEST(TestWizardAxes)

} // namespace tst_wizardaxes

#include "tst_wizardaxes.moc"
