// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_states.h"
#include "tests/ui/support/window_test.h"

#include <QTest>
#include <QToolButton>

namespace tst_proposedsources {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

namespace {

const QString positionX = QStringLiteral("X · PositionController/MasterPosition");
const QString positionY = QStringLiteral("Y · PositionController/MasterPosition");

/// An axis that has no sources yet, and a file open for it.
struct Stage : PageFixture {
    [[nodiscard]] bool openFile(const QByteArray& text, const QString& dimensionality)
    {
        picked = file(QStringLiteral("data.csv"), text);
        return open() && user.choose("dimensionalityField", dimensionality)
            && user.click("openButton")
            && waits([this] { return controller().dataFile().data != nullptr; });
    }
    template <typename Condition> [[nodiscard]] static bool waits(const Condition& condition)
    {
        return test::PageUser::waitFor(condition);
    }
    [[nodiscard]] std::string source(int dimension)
    {
        return controller()
            .setup()
            .edited()
            .sources.at(static_cast<std::size_t>(dimension - 1))
            .path;
    }
    [[nodiscard]] QString current(const char* label)
    {
        const auto& value = user.the<QLabel>(label);
        return value.isVisible() ? value.text() : QString();
    }
};

} // namespace

class TestProposedSources : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void theOwnPositionIsProposedIn1DAndTakenByOneClick()
    {
        Stage stage;
        QVERIFY(stage.open());
        QTRY_VERIFY(
            stage.user.note("source1Field").contains(QStringLiteral("proposed: ") + positionX));
        QVERIFY(!stage.controller().setup().isDirty()); // nothing was chosen for the user
        QVERIFY(stage.user.click("source1FieldTake"));
        QTRY_COMPARE(stage.source(1), test::masterX);
        QVERIFY(!stage.user.sees("source1FieldTake"));
        QVERIFY(!stage.user.note("source1Field").contains(QStringLiteral("proposed")));
    }

    void theColumnsOfTheFileAreMatchedWithAxes()
    {
        Stage stage;
        QVERIFY(stage.openFile("Y [mm],X [mm],E [mm]\n0,0,0\n10,0,0.001\n0,10,0.002\n10,10,0\n",
            QStringLiteral("2D")));
        QTRY_VERIFY(stage.user.note("source1Field").contains(positionY));
        QVERIFY(stage.user.note("source2Field").contains(positionX));
        QVERIFY(stage.user.click("source1FieldTake"));
        QVERIFY(stage.user.click("source2FieldTake"));
        QTRY_COMPARE(stage.source(1), test::masterY);
        QTRY_COMPARE(stage.source(2), test::masterX);
    }

    /// What the user has entered stays, and what the file says against it is beside it.
    void aSourceThatTheFileSpeaksAgainstIsWarnedOfAndStays()
    {
        Stage stage;
        QVERIFY(stage.openFile("X [mm],Y [mm],E [mm]\n0,0,0\n10,0,0.001\n0,10,0.002\n10,10,0\n",
            QStringLiteral("2D")));
        const std::string warmth = "Axes[0]/Signals/General/MotorTemperature";
        QVERIFY(stage.user.enter("source2Field", QString::fromStdString(warmth)));
        QTRY_VERIFY(stage.user.note("source2Field")
                        .contains(QStringLiteral(
                            "Column Y of the file has positions in mm, but its source "
                            "Axes[0]/Signals/General/MotorTemperature is a temperature.")));
        QCOMPARE(stage.source(2), warmth);
        QVERIFY(stage.user.the<QWidget>("source2Field")
                    .accessibleDescription()
                    .contains(QStringLiteral("is a temperature")));
        QVERIFY(stage.user.note("source2Field").contains(positionY)); // what it proposes instead
        QVERIFY(stage.user.enter("source2Field", QString::fromStdString(test::masterY)));
        QTRY_VERIFY(!stage.user.note("source2Field").contains(QStringLiteral("temperature")));
    }

    void theColumnThatIsNamedAsTheAxisIsSelected()
    {
        Stage stage;
        QVERIFY(stage.openFile("Position [mm],Y error [mm],X error [mm]\n0,0,0\n10,0.001,0.002\n",
            QStringLiteral("1D")));
        QTRY_COMPARE(stage.controller().setup().edited().table.fileTable, std::optional<int>(1));
    }

    void theValueOfASourceIsShownBeforeItIsWritten()
    {
        Stage stage;
        QVERIFY(stage.open());
        QVERIFY(stage.current("source1FieldCurrent").isEmpty());
        QVERIFY(stage.user.enter(
            "source1Field", QStringLiteral("Axes[0]/Signals/General/MotorTemperature")));
        QTRY_VERIFY(!stage.current("source1FieldCurrent").isEmpty());
        const QString before = stage.current("source1FieldCurrent");
        QVERIFY2(before.startsWith(QStringLiteral("now ")), qPrintable(before));
        QVERIFY(stage.user.note("source1Field").contains(QStringLiteral("changed, on the drive")));
        // A position moves.
        QVERIFY(stage.user.enter("source1Field", QString::fromStdString(test::masterX)));
        QTRY_VERIFY(stage.current("source1FieldCurrent") != before);
        const QString position = stage.current("source1FieldCurrent");
        QTRY_VERIFY(stage.current("source1FieldCurrent") != position);
    }

    void aValueThatIsNotLiveIsGreyed()
    {
        Stage stage;
        QVERIFY(stage.open());
        QVERIFY(stage.user.enter("source1Field", QString::fromStdString(test::masterX)));
        QTRY_VERIFY(!stage.current("source1FieldCurrent").isEmpty());
        const auto& value = stage.user.the<QLabel>("source1FieldCurrent");
        const QPalette palette = stage.user.the<QWidget>("source1Field").palette();
        const auto color = [&] { return value.palette().color(QPalette::WindowText); };
        QCOMPARE(color(), palette.color(QPalette::WindowText));
        stage.served.stop();
        QTRY_COMPARE_WITH_TIMEOUT(
            color(), palette.color(QPalette::Disabled, QPalette::WindowText), test::patienceMs);
        QCOMPARE(value.toolTip(), QStringLiteral("as last read"));
        QVERIFY(!value.text().isEmpty());
        stage.served.start();
        QTRY_COMPARE_WITH_TIMEOUT(color(), palette.color(QPalette::WindowText), test::patienceMs);
    }

    void aWrongRegisterIsSaidUnderItsFieldUntilTheTextChanges()
    {
        Stage stage;
        QVERIFY(stage.open());
        QVERIFY(stage.user.enter("source1Field", QStringLiteral("Axes[0]/Nonsense")));
        QTRY_VERIFY(stage.user.note("source1Field")
                        .contains(QStringLiteral("no register Axes[0]/Nonsense")));
        QVERIFY(stage.user.message("outcomeMessage").isEmpty());
        test::PageUser::type(QStringLiteral("x"));
        QVERIFY(!stage.user.note("source1Field").contains(QStringLiteral("no register")));
    }
};

AXISCOMP_WINDOW_TEST(TestProposedSources)

} // namespace tst_proposedsources

#include "tst_proposedsources.moc"
