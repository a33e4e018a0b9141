// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/configuration_files.h"
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"

#include <QAction>
#include <QCheckBox>
#include <QPushButton>
#include <QTableWidget>

namespace tst_configurationdialogs {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ConfiguredAxis;
using test::ConfiguredStation;
using test::PageFixture;
using Purpose = FileQuestion::Purpose;

namespace {

constexpr int serialOfDrive = 1559;
const std::string compensationOfX = "Axes[0]/Parameters/Compensations/Axis/";

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A window on a drive whose axis X has a table, and configurations of it.
class Stage : public PageFixture {
public:
    /// What the axis X of the drive has.
    [[nodiscard]] ConfiguredAxis axisX() { return test::configuredAxis(served.drive, 0); }
    /// The same in a file: its first station is of another drive.
    [[nodiscard]] QByteArray configurationOfDrive()
    {
        return test::tamConfiguration(
            {{"Other", 7, {{}}}, {"Stage-7", serialOfDrive, {axisX(), {}}}});
    }
    /// As if somebody else had taken the table away.
    [[nodiscard]] bool takeTableAway()
    {
        const auto written = served.drive.writeRegisters({
            {compensationOfX + "Table", std::string("Disabled")},
            {compensationOfX + "Dim1Source", std::uint32_t{0}},
            {compensationOfX + "Dim2Source", std::uint32_t{0}},
        });
        controller().refresh();
        return written.has_value() && test::PageUser::waitFor([this] {
            return controller().status() && controller().status()->setup.slot.empty()
                && controller().action(Action::ImportConfiguration).isEnabled;
        });
    }
    void pick(const QString& name, const QByteArray& content) { picked = file(name, content); }
    /// By the menu; the file dialog answers `picked`.
    [[nodiscard]] bool begin(const char* action, const char* dialog)
    {
        user.the<QAction>(action).trigger();
        return test::PageUser::waitFor([&] { return user.sees(dialog); });
    }
    [[nodiscard]] bool beginImport()
    {
        return begin("importConfigurationAction", "importConfigurationDialog");
    }
    [[nodiscard]] bool beginExport()
    {
        return begin("exportConfigurationAction", "exportConfigurationDialog");
    }
    [[nodiscard]] bool says(const char* label, const QString& part)
    {
        const bool isSaid =
            test::PageUser::waitFor([&] { return user.the<QLabel>(label).text().contains(part); });
        if (!isSaid)
            qInfo("it says: %s", qPrintable(user.the<QLabel>(label).text()));
        return isSaid;
    }
    [[nodiscard]] bool importSays(const char* part)
    {
        return says("multiAxisReason", QString::fromUtf8(part));
    }
    [[nodiscard]] bool exportSays(const char* part)
    {
        return says("exportConfigurationReason", QString::fromUtf8(part));
    }
    QPushButton& writeButton() { return user.the<QPushButton>("writeSeveralButton"); }
    QPushButton& saveButton() { return user.the<QPushButton>("saveConfigurationButton"); }
};

} // namespace

class TestConfigurationDialogs : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void theMenuSaysWhyNot();
    void theParametersOfTheDriveAreWrittenAfterTheirPlan();
    void whatTheDriveHasIsNotWritten();
    void anotherSerialNumberHasToBeConfirmed();
    void theConfirmationIsForOneStationOnly();
    void aDamagedFileNamesTheLine();
    void aDriveThatIsGoneIsPlannedAgainWhenItIsBack();
    void onlyTheRegistersChangeInTheFile();
    void aFileThatHasEverythingIsNotWritten();
    void aFileThatHasChangedMeanwhileIsNotOverwritten();
    void aDriveThatIsGoneIsNotExported();
};

void TestConfigurationDialogs::theMenuSaysWhyNot()
{
    Stage stage;
    QVERIFY(stage.user.isThere());
    stage.controller().setEndpoints({});
    for (const auto& [name, action] :
        {std::pair("importConfigurationAction", Action::ImportConfiguration),
            std::pair("exportConfigurationAction", Action::ExportConfiguration)}) {
        const auto& entry = stage.user.the<QAction>(name);
        QTRY_VERIFY(!entry.isEnabled());
        QCOMPARE(entry.toolTip(), QStringLiteral("No drive is connected: add a connection first."));
        QCOMPARE(entry.toolTip(), stage.controller().action(action).reason);
    }
    QVERIFY(stage.open());
    QTRY_VERIFY(stage.user.the<QAction>("importConfigurationAction").isEnabled());
    QTRY_VERIFY(stage.user.the<QAction>("exportConfigurationAction").isEnabled());
}

void TestConfigurationDialogs::theParametersOfTheDriveAreWrittenAfterTheirPlan()
{
    Stage stage;
    QVERIFY(stage.openWritten());
    const auto wanted = stage.state();
    stage.pick(QStringLiteral("machine.TAMcfg"), stage.configurationOfDrive());
    QVERIFY(stage.takeTableAway());
    const auto without = stage.state();
    QVERIFY(stage.beginImport());
    QCOMPARE(stage.questions.back().purpose, Purpose::OpenConfiguration);
    QTRY_VERIFY(stage.writeButton().isEnabled());
    QCOMPARE(
        stage.user.the<QComboBox>("stationField").currentText(), QStringLiteral("Stage-7 (1559)"));
    QVERIFY(!stage.user.sees("stationWarning"));
    QCOMPARE(stage.user.the<QTableWidget>("multiAxisPlanRows").rowCount(), 1);
    QVERIFY(stage.importSays("Uses no flash operation."));
    QVERIFY(stage.state() == without);
    QVERIFY(stage.user.click("writeSeveralButton"));
    QVERIFY(stage.importSays("Written and verified: X."));
    QVERIFY(stage.state().registers == wanted.registers);
    QCOMPARE(stage.served.text("Axes[0]/Commands/Compensations/Axis/Activation"),
        std::string("Disabled"));
    stage.user.press(Qt::Key_Escape);
    QTRY_VERIFY(!stage.user.find("importConfigurationDialog"));
    QCOMPARE(
        stage.controller().setup().baseline().slot, stage.served.text(compensationOfX + "Table"));
}

void TestConfigurationDialogs::whatTheDriveHasIsNotWritten()
{
    Stage stage;
    QVERIFY(stage.openWritten());
    const auto before = stage.state();
    stage.pick(QStringLiteral("machine.TAMcfg"), stage.configurationOfDrive());
    QVERIFY(stage.beginImport());
    QVERIFY(stage.importSays("The drive already has all of this."));
    QVERIFY(!stage.writeButton().isEnabled());
    stage.user.press(Qt::Key_Escape);
    QTRY_VERIFY(!stage.user.find("importConfigurationDialog"));
    QVERIFY(stage.state() == before);
}

void TestConfigurationDialogs::anotherSerialNumberHasToBeConfirmed()
{
    Stage stage;
    QVERIFY(stage.openWritten());
    const auto before = stage.state();
    stage.pick(QStringLiteral("other.TAMcfg"), test::tamConfiguration({{"Other", 7, {{}, {}}}}));
    QVERIFY(stage.beginImport());
    QVERIFY(stage.importSays("Select the station that is this drive."));
    QCOMPARE(stage.user.the<QComboBox>("stationField").currentIndex(), -1);
    QVERIFY(!stage.writeButton().isEnabled());
    QVERIFY(stage.user.choose("stationField", QStringLiteral("Other (7)")));
    QVERIFY(stage.importSays("Confirm first that the station is meant."));
    QVERIFY(stage.user.sees("stationWarning"));
    QCOMPARE(stage.user.the<QLabel>("stationWarning").text(),
        QStringLiteral("Other has the serial number 7, the drive Stage-7 has 1559."));
    QVERIFY(!stage.writeButton().isEnabled());
    QCOMPARE(stage.user.the<QTableWidget>("multiAxisPlanRows").rowCount(), 0);
    QVERIFY(stage.state() == before);
    QVERIFY(stage.user.click("acceptOtherStation"));
    QTRY_VERIFY(stage.writeButton().isEnabled());
    auto& rows = stage.user.the<QTableWidget>("multiAxisPlanRows");
    QCOMPARE(rows.rowCount(), 1);
    QVERIFY2(rows.item(0, 2)->text().startsWith(QStringLiteral("no table")),
        qPrintable(rows.item(0, 2)->text()));
    QVERIFY(stage.state() == before);
    QVERIFY(stage.user.click("writeSeveralButton"));
    QVERIFY(stage.importSays("Written and verified: X."));
    QCOMPARE(stage.served.text(compensationOfX + "Table"), std::string("Disabled"));
}

void TestConfigurationDialogs::theConfirmationIsForOneStationOnly()
{
    Stage stage;
    QVERIFY(stage.open());
    stage.pick(QStringLiteral("others.TAMcfg"),
        test::tamConfiguration({{"First", 7, {{}}}, {"Second", 8, {{}}}}));
    QVERIFY(stage.beginImport());
    QVERIFY(stage.user.choose("stationField", QStringLiteral("First (7)")));
    QVERIFY(stage.user.click("acceptOtherStation"));
    QVERIFY(stage.importSays("The drive already has all of this."));
    QVERIFY(stage.user.choose("stationField", QStringLiteral("Second (8)")));
    QVERIFY(stage.importSays("Confirm first that the station is meant."));
    QVERIFY(!stage.user.the<QCheckBox>("acceptOtherStation").isChecked());
}

void TestConfigurationDialogs::aDamagedFileNamesTheLine()
{
    Stage stage;
    QVERIFY(stage.open());
    for (const char* const dialog : {"importConfigurationDialog", "exportConfigurationDialog"}) {
        const bool isImport = QByteArray(dialog).startsWith("import");
        stage.pick(QStringLiteral("bad.TAMcfg"), "<TamTopology>\n<TamStation>\n");
        QVERIFY(isImport ? stage.beginImport() : stage.beginExport());
        const char* const sentence = "bad.TAMcfg is wrong in line 3";
        QVERIFY(isImport ? stage.importSays(sentence) : stage.exportSays(sentence));
        QVERIFY(!(isImport ? stage.writeButton() : stage.saveButton()).isEnabled());
        stage.user.press(Qt::Key_Escape);
        QTRY_VERIFY(!stage.user.find(dialog));
    }
}

void TestConfigurationDialogs::aDriveThatIsGoneIsPlannedAgainWhenItIsBack()
{
    Stage stage;
    QVERIFY(stage.openWritten());
    const auto wanted = stage.state();
    stage.pick(QStringLiteral("machine.TAMcfg"), stage.configurationOfDrive());
    QVERIFY(stage.takeTableAway());
    QVERIFY(stage.beginImport());
    QTRY_VERIFY(stage.writeButton().isEnabled());
    stage.served.stop();
    QTRY_VERIFY(!stage.controller().action(Action::ImportConfiguration).isEnabled);
    QVERIFY(stage.user.click("writeSeveralButton"));
    QVERIFY(stage.importSays("The drive is not connected."));
    QVERIFY(!stage.writeButton().isEnabled());
    stage.served.start();
    QVERIFY(stage.user.click("writeSeveralButton"));
    QVERIFY(stage.importSays("Written and verified: X."));
    QVERIFY(stage.state().registers == wanted.registers);
}

void TestConfigurationDialogs::onlyTheRegistersChangeInTheFile()
{
    Stage stage;
    QVERIFY(stage.openWritten());
    const QByteArray before =
        test::tamConfiguration({{"Other", 7, {{}}}, {"Stage-7", serialOfDrive, {{}, {}}}});
    const auto onDrive = stage.state();
    stage.pick(QStringLiteral("machine.TAMcfg"), before);
    QVERIFY(stage.beginExport());
    QVERIFY(stage.exportSays("In the file, only Table and Dim1Source to Dim3Source"));
    auto& rows = stage.user.the<QTableWidget>("parameterRows");
    QCOMPARE(rows.rowCount(), 2);
    QCOMPARE(rows.item(0, 0)->text(), QStringLiteral("X"));
    QCOMPARE(rows.item(0, 1)->text(), QString::fromUtf8(stage.axisX().table));
    QVERIFY2(rows.item(0, 2)->text().contains(QStringLiteral("MasterPosition")),
        qPrintable(rows.item(0, 2)->text()));
    QCOMPARE(rows.item(1, 1)->text(), QStringLiteral("no table"));
    QCOMPARE(contentOf(stage.picked), before);
    QVERIFY(stage.user.click("saveConfigurationButton"));
    QVERIFY(stage.saysOutcome(
        QStringLiteral("Wrote machine.TAMcfg: only compensation registers have changed.")));
    QCOMPARE(stage.questions.back().purpose, Purpose::SaveConfiguration);
    QCOMPARE(stage.questions.back().start, stage.picked);
    QCOMPARE(contentOf(stage.picked), stage.configurationOfDrive());
    QVERIFY(contentOf(stage.picked) != before);
    QVERIFY(stage.state() == onDrive);
}

void TestConfigurationDialogs::aFileThatHasEverythingIsNotWritten()
{
    Stage stage;
    QVERIFY(stage.openWritten());
    stage.pick(QStringLiteral("machine.TAMcfg"), stage.configurationOfDrive());
    QVERIFY(stage.beginExport());
    QVERIFY(stage.exportSays("The configuration has all of this already."));
    QVERIFY(!stage.saveButton().isEnabled());
    const auto questions = stage.questions.size();
    stage.user.press(Qt::Key_Escape);
    QTRY_VERIFY(!stage.user.find("exportConfigurationDialog"));
    QCOMPARE(stage.questions.size(), questions);
}

void TestConfigurationDialogs::aFileThatHasChangedMeanwhileIsNotOverwritten()
{
    Stage stage;
    QVERIFY(stage.openWritten());
    stage.pick(QStringLiteral("machine.TAMcfg"),
        test::tamConfiguration({{"Stage-7", serialOfDrive, {{}, {}}}}));
    QVERIFY(stage.beginExport());
    QTRY_VERIFY(stage.saveButton().isEnabled());
    const QByteArray newer = test::tamConfiguration({{"Renamed", serialOfDrive, {{}, {}}}});
    stage.pick(QStringLiteral("machine.TAMcfg"), newer);
    QVERIFY(stage.user.click("saveConfigurationButton"));
    QVERIFY(stage.saysOutcome(QStringLiteral("it has changed since it was read")));
    QVERIFY(stage.controller().isOutcomeAnError());
    QCOMPARE(contentOf(stage.picked), newer);
}

void TestConfigurationDialogs::aDriveThatIsGoneIsNotExported()
{
    Stage stage;
    QVERIFY(stage.open());
    stage.pick(QStringLiteral("machine.TAMcfg"),
        test::tamConfiguration({{"Stage-7", serialOfDrive, {{}, {}}}}));
    // It goes while the file is being chosen.
    stage.wizard.setFilePicker(
        [&](QWidget&, const FileQuestion&, const std::function<void(const QString&)>& answer) {
            stage.served.stop();
            answer(stage.picked);
        });
    QVERIFY(stage.beginExport());
    QTRY_VERIFY(stage.controller().parameters() && !*stage.controller().parameters());
    QVERIFY(!stage.saveButton().isEnabled());
    QVERIFY(!stage.user.the<QLabel>("exportConfigurationReason").text().isEmpty());
    stage.served.start();
    QVERIFY(stage.exportSays("The configuration has all of this already."));
}

AXISCOMP_WINDOW_TEST(TestConfigurationDialogs)

} // namespace tst_configurationdialogs

#include "tst_configurationdialogs.moc"
