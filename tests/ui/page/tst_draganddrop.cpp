// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_stage.h"
#include "tests/ui/support/window_test.h"

#include <QProcess>
#include <QTest>

namespace tst_draganddrop {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageStage;

namespace {

constexpr QRect sourcePlace(1090, 100, 120, 80);
constexpr QRect wizardPlace(10, 10, 1060, 760);

/// Moves the real pointer, through the display server.
bool pointer(const QStringList& command)
{
    QProcess xdotool;
    xdotool.start(QStringLiteral("xdotool"), command);
    // The window must go on answering meanwhile.
    return QTest::qWaitFor(
               [&] { return xdotool.state() == QProcess::NotRunning; }, test::patienceMs)
        && xdotool.exitCode() == 0;
}

bool movePointer(const QPoint& place)
{
    return pointer(
        {QStringLiteral("mousemove"), QString::number(place.x()), QString::number(place.y())});
}

/// The other program.
class Source {
public:
    explicit Source(const QStringList& files)
    {
        const QStringList place{QString::number(sourcePlace.x()), QString::number(sourcePlace.y())};
        m_process.start(QStringLiteral(AXISCOMP_DRAG_SOURCE), place + files);
    }
    ~Source()
    {
        m_process.kill();
        m_process.waitForFinished();
    }
    [[nodiscard]] bool says(const QByteArray& word)
    {
        return QTest::qWaitFor(
            [&] {
                m_said += m_process.readAllStandardOutput();
                return m_said.contains(word + '\n');
            },
            test::patienceMs);
    }

private:
    QProcess m_process;
    QByteArray m_said;
};

/// The page on the screen with its drive read.
struct Scene {
    Scene() : wizard(stage.options(), nullptr)
    {
        wizard.setWindowFlag(Qt::FramelessWindowHint);
        wizard.setGeometry(wizardPlace);
        wizard.controller().setEndpoints({PageStage::endpoint()});
    }
    [[nodiscard]] bool isThere()
    {
        wizard.show();
        return QTest::qWaitForWindowExposed(&wizard)
            && QTest::qWaitFor(
                [this] { return wizard.controller().status().has_value(); }, test::patienceMs);
    }
    [[nodiscard]] bool showsDropFrame() const
    {
        const auto* frame = wizard.findChild<QWidget*>(QStringLiteral("dropFrame"));
        return frame->isVisible();
    }

    PageStage stage;
    CompensationWizard wizard;
};

/// Presses in the other program and moves over the page, in steps as a hand does.
bool dragOverPage()
{
    const QPoint start = sourcePlace.center();
    const QPoint end = wizardPlace.center();
    if (!movePointer(start) || !pointer({QStringLiteral("mousedown"), QStringLiteral("1")}))
        return false;
    constexpr int steps = 12;
    for (int step = 1; step <= steps; ++step) {
        if (!movePointer(start + (end - start) * step / steps))
            return false;
    }
    return true;
}

bool letGo()
{
    return pointer({QStringLiteral("mouseup"), QStringLiteral("1")});
}

} // namespace

/// Real drags from another program, on a display server.
class TestDragAndDrop : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        if (QGuiApplication::platformName() != QStringLiteral("xcb"))
            QSKIP("needs a display server: ctest runs it under xvfb-run");
    }
    void init() { test::failOnWindowWarnings(); }
    void cleanup() { QVERIFY(letGo()); }

    void aFileOfAnotherProgramIsDroppedAndOpened()
    {
        Scene scene;
        QVERIFY(scene.isThere());
        scene.wizard.controller().setup().setDimensionality(2);
        const QString file = scene.stage.superData();
        Source source({file});
        QVERIFY(source.says("ready"));
        QVERIFY(dragOverPage());
        QTRY_VERIFY(scene.showsDropFrame());
        QVERIFY(letGo());
        QVERIFY(source.says("copied"));
        QTRY_VERIFY(scene.wizard.controller().dataFile().data);
        QCOMPARE(scene.wizard.controller().dataFile().path, file);
        QCOMPARE(scene.wizard.controller().setup().edited().table.fileTable, std::optional(0));
        QVERIFY(!scene.showsDropFrame());
    }

    void twoFilesAreNotTaken()
    {
        Scene scene;
        QVERIFY(scene.isThere());
        const QString file = scene.stage.superData();
        Source source({file, scene.stage.file(QStringLiteral("b.csv"), "X,t\n0,1\n1,2\n")});
        QVERIFY(source.says("ready"));
        QVERIFY(dragOverPage());
        QVERIFY(letGo());
        QVERIFY(source.says("not taken"));
        QVERIFY(!scene.showsDropFrame());
        QVERIFY(scene.wizard.controller().dataFile().path.isEmpty());
    }

    void aDragThatLeavesThePageIsForgotten()
    {
        Scene scene;
        QVERIFY(scene.isThere());
        Source source({scene.stage.superData()});
        QVERIFY(source.says("ready"));
        QVERIFY(dragOverPage());
        QTRY_VERIFY(scene.showsDropFrame());
        QVERIFY(movePointer(sourcePlace.center()));
        QTRY_VERIFY(!scene.showsDropFrame());
        QVERIFY(letGo());
        QVERIFY(source.says("not taken"));
        QVERIFY(scene.wizard.controller().dataFile().path.isEmpty());
    }
};

AXISCOMP_WINDOW_TEST(TestDragAndDrop)

} // namespace tst_draganddrop

#include "tst_draganddrop.moc"
