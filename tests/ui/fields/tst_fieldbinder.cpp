// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/window_test.h"
#include "ui/fields/field_binder.h"
#include "ui/fields/field_row.h"
#include "ui/fields/source_combo.h"
#include "ui/style/dirty_style.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include <random>

namespace tst_fieldbinder {

using namespace axiscomp;
using namespace axiscomp::ui;

namespace {

const DimSource x{0x1000, "Axes[0]/MasterPosition"};
const DimSource y{0x2000, "Axes[1]/MasterPosition"};

CompensationSetup onDrive()
{
    CompensationSetup setup;
    setup.dimensionality = 2;
    setup.sources = {x, y, DimSource{}};
    setup.slot = "Small1";
    return setup;
}

QString nameOf(const DimSource& source)
{
    return source.isSet() ? QString::fromStdString(source.path) : QStringLiteral("not set");
}

QString uriOf(const DimSource& source)
{
    return source.isSet() ? QStringLiteral("tam://mc/D/") + nameOf(source) : QString();
}

/// A model, an editor of each kind, and what ties them.
struct Fixture {
    Fixture()
        : dimensionality(named(new QComboBox, "dimensionality"))
        , source(named(new SourceCombo, "source"))
        , persistency(named(new QCheckBox(QStringLiteral("persistent")), "persistency"))
        , dimensionalityRow(new FieldRow(dimensionality, &style, &window))
        , sourceRow(new FieldRow(source, &style, &window))
        , persistencyRow(new FieldRow(persistency, &style, &window))
    {
        for (int n = 1; n <= 3; ++n)
            dimensionality->addItem(QStringLiteral("%1D").arg(n), n);
        model.reset(onDrive());
        binder.bind(
            Field::Dimensionality, *dimensionalityRow, *dimensionality,
            [](const EditedSetup& edited) { return QVariant(edited.dimensionality); },
            [this](SetupModel& target, const QVariant& value) {
                ++writes;
                target.setDimensionality(value.toInt());
            },
            [](const CompensationSetup& drive) {
                return QStringLiteral("%1D").arg(drive.dimensionality);
            });
        binder.bind(*sourceRow, *source, 1, uriOf, nameOf);
        binder.bind(
            Field::Persistency, *persistencyRow, *persistency,
            [](const EditedSetup& edited) { return edited.persistency == Persistency::Persistent; },
            [this](SetupModel& target, bool isPersistent) {
                ++writes;
                target.setPersistency(
                    isPersistent ? Persistency::Persistent : Persistency::Volatile);
            },
            [](const CompensationSetup& drive) {
                return drive.persistency == Persistency::Persistent ? QStringLiteral("persistent")
                                                                    : QStringLiteral("volatile");
            });
        QObject::connect(&model, &SetupModel::fieldChanged, &window, [this] { ++changes; });
        auto* grid = new QGridLayout(&window);
        int row = 0;
        for (FieldRow* field : {dimensionalityRow, sourceRow, persistencyRow}) {
            field->addTo(*grid, row);
            row += 2;
        }
        window.resize(500, 260);
    }

    template <typename T> static T* named(T* editor, const char* name)
    {
        editor->setObjectName(QLatin1StringView(name));
        return editor;
    }
    [[nodiscard]] bool shown() { return test::showActive(window); }
    static QToolButton& revertOf(FieldRow& row)
    {
        return *row.editor().parentWidget()->findChild<QToolButton*>(
            row.editor().objectName() + QStringLiteral("Revert"));
    }
    /// The fields show what the model has, and which of it is changed.
    void verify()
    {
        const EditedSetup& edited = model.edited();
        QCOMPARE(dimensionality->currentData().toInt(), edited.dimensionality);
        QCOMPARE(persistency->isChecked(), edited.persistency == Persistency::Persistent);
        if (!source->isTyping())
            QCOMPARE(source->currentText(), uriOf(edited.sources[0]));
        QCOMPARE(source->value(), uriOf(edited.sources[0]));
        QCOMPARE(dimensionalityRow->isDirty(), model.isDirty(Field::Dimensionality));
        QCOMPARE(sourceRow->isDirty(), model.isDirty(Field::Source1));
        QCOMPARE(persistencyRow->isDirty(), model.isDirty(Field::Persistency));
    }

    DirtyStyle style;
    QWidget window;
    SetupModel model;
    FieldBinder binder{model};
    QComboBox* dimensionality;
    SourceCombo* source;
    QCheckBox* persistency;
    FieldRow* dimensionalityRow;
    FieldRow* sourceRow;
    FieldRow* persistencyRow;
    int writes = 0; ///< from the editors into the model
    int changes = 0; ///< reported by the model
};

} // namespace

class TestFieldBinder : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void theFieldsShowTheModelFromTheBeginning()
    {
        Fixture bench;
        bench.verify();
        QCOMPARE(bench.source->currentText(), QStringLiteral("tam://mc/D/Axes[0]/MasterPosition"));
        QCOMPARE(bench.changes, 0);
        QCOMPARE(bench.writes, 0);
    }

    void theModelReachesTheFieldsAndNothingComesBack()
    {
        Fixture bench;
        bench.model.setDimensionality(3);
        bench.model.setPersistency(Persistency::Persistent);
        bench.model.setSource(1, {});
        QCOMPARE(bench.writes, 0);
        bench.verify();
        CompensationSetup elsewhere = onDrive();
        elsewhere.dimensionality = 1;
        elsewhere.persistency = Persistency::Persistent;
        bench.model.setBaseline(elsewhere);
        bench.verify();
        bench.model.reset(elsewhere);
        bench.verify();
        QCOMPARE(bench.writes, 0);
    }

    void whatTheUserDoesReachesTheModelOnce()
    {
        Fixture bench;
        QVERIFY(bench.shown());
        bench.dimensionality->setFocus();
        QTest::keyClick(bench.dimensionality, Qt::Key_Down);
        QCOMPARE(bench.model.edited().dimensionality, 3);
        QCOMPARE(bench.writes, 1);
        bench.changes = 0;
        QTest::mouseClick(
            bench.persistency, Qt::LeftButton, {}, QPoint(14, bench.persistency->height() / 2));
        QCOMPARE(bench.model.edited().persistency, Persistency::Persistent);
        QCOMPARE(bench.writes, 2);
        QCOMPARE(bench.changes, 1);
        QTest::keyClick(bench.persistency, Qt::Key_Space);
        QCOMPARE(bench.model.edited().persistency, Persistency::Volatile);
        QCOMPARE(bench.changes, 2);
        bench.verify();
    }

    void choosingTheSameAgainIsNoChange()
    {
        Fixture bench;
        QVERIFY(bench.shown());
        bench.dimensionality->setFocus();
        QTest::keyClick(bench.dimensionality, Qt::Key_Down);
        QTest::keyClick(bench.dimensionality, Qt::Key_Up);
        bench.verify();
        QVERIFY(!bench.model.isDirty());
        bench.changes = 0;
        bench.model.setDimensionality(2);
        QCOMPARE(bench.changes, 0);
    }

    void aTypedSourceIsHandedOnOnceAndTheModelWaits()
    {
        Fixture bench;
        QVERIFY(bench.shown());
        QSignalSpy entered(&bench.binder, &FieldBinder::sourceEntered);
        bench.source->setFocus();
        bench.source->lineEdit()->selectAll();
        QTest::keyClicks(bench.source, QStringLiteral("0x2000"));
        QCOMPARE(entered.count(), 0);
        QTest::keyClick(bench.source, Qt::Key_Return);
        QTest::keyClick(bench.source, Qt::Key_Return);
        bench.persistency->setFocus();
        QCOMPARE(entered.count(), 1);
        QCOMPARE(entered[0][0].toInt(), 1);
        QCOMPARE(entered[0][1].toString(), QStringLiteral("0x2000"));
        QCOMPARE(bench.model.edited().sources[0].address, x.address);
        QVERIFY(!bench.sourceRow->isDirty());
        bench.model.setSource(1, y);
        QCOMPARE(bench.source->currentText(), uriOf(y));
        QVERIFY(bench.sourceRow->isDirty());
        QCOMPARE(entered.count(), 1);
    }

    void leavingTheFieldHandsOnWhatWasTyped()
    {
        Fixture bench;
        QVERIFY(bench.shown());
        QSignalSpy entered(&bench.binder, &FieldBinder::sourceEntered);
        bench.source->setFocus();
        bench.source->lineEdit()->selectAll();
        QTest::keyClicks(bench.source, QStringLiteral("0x3000"));
        QTest::keyClick(bench.source, Qt::Key_Tab);
        QCOMPARE(entered.count(), 1);
        QVERIFY(!bench.source->hasFocus());
    }

    void whatIsBeingTypedIsTheUsers()
    {
        Fixture bench;
        QVERIFY(bench.shown());
        bench.source->setFocus();
        bench.source->lineEdit()->selectAll();
        QTest::keyClicks(bench.source, QStringLiteral("Axes[1]"));
        bench.model.setSource(1, y);
        bench.binder.refresh();
        QCOMPARE(bench.source->currentText(), QStringLiteral("Axes[1]"));
        QTest::keyClick(bench.source, Qt::Key_Escape);
        QCOMPARE(bench.source->currentText(), uriOf(y));
        bench.verify();
    }

    void aRefusedSourceStaysForCorrectionUntilTheFieldIsLeft()
    {
        Fixture bench;
        QVERIFY(bench.shown());
        bench.source->setFocus();
        bench.source->lineEdit()->selectAll();
        QTest::keyClicks(bench.source, QStringLiteral("0x99"));
        QTest::keyClick(bench.source, Qt::Key_Return);
        bench.source->refuse();
        QCOMPARE(bench.source->currentText(), QStringLiteral("0x99"));
        QTest::keyClick(bench.source, Qt::Key_Escape);
        QCOMPARE(bench.source->currentText(), uriOf(x));
    }

    void aRefusedSourceIsGoneWhenTheFieldHasBeenLeft()
    {
        Fixture bench;
        QVERIFY(bench.shown());
        QSignalSpy entered(&bench.binder, &FieldBinder::sourceEntered);
        bench.source->setFocus();
        bench.source->lineEdit()->selectAll();
        QTest::keyClicks(bench.source, QStringLiteral("0x99"));
        bench.persistency->setFocus();
        QCOMPARE(entered.count(), 1);
        bench.source->refuse();
        QCOMPARE(bench.source->currentText(), uriOf(x));
        bench.verify();
    }

    /// The problem of the field is said again whenever the drive is read.
    void aRefusalThatIsSaidAgainLeavesTheSourceAlone()
    {
        Fixture bench;
        QVERIFY(bench.shown());
        bench.source->setFocus();
        bench.source->lineEdit()->selectAll();
        QTest::keyClicks(bench.source, QStringLiteral("0x99"));
        bench.persistency->setFocus();
        bench.source->refuse();
        bench.source->setFocus();
        QSignalSpy entered(&bench.binder, &FieldBinder::sourceEntered);
        bench.source->refuse();
        QCOMPARE(bench.source->currentText(), uriOf(x));
        bench.persistency->setFocus();
        QCOMPARE(entered.count(), 0);
        bench.verify();
    }

    void aTextThatIsGivenUpTakesItsProblemWithIt()
    {
        Fixture bench;
        QVERIFY(bench.shown());
        bench.source->setFocus();
        bench.source->lineEdit()->selectAll();
        QTest::keyClicks(bench.source, QStringLiteral("0x99"));
        QTest::keyClick(bench.source, Qt::Key_Return);
        bench.source->refuse();
        QSignalSpy edited(&bench.binder, &FieldBinder::sourceEdited);
        QTest::keyClick(bench.source, Qt::Key_Escape);
        QCOMPARE(edited.count(), 1);
    }

    void eachRowRevertsItsOwnField()
    {
        Fixture bench;
        QVERIFY(bench.shown());
        const std::array<std::pair<FieldRow*, Field>, 3> rows{
            {{bench.dimensionalityRow, Field::Dimensionality}, {bench.sourceRow, Field::Source1},
                {bench.persistencyRow, Field::Persistency}}};
        for (const auto& [row, field] : rows) {
            bench.model.setDimensionality(3);
            bench.model.setSource(1, {0x9000, "other"});
            bench.model.setPersistency(Persistency::Persistent);
            QToolButton& revert = Fixture::revertOf(*row);
            QVERIFY(revert.isVisible());
            QTest::mouseClick(&revert, Qt::LeftButton);
            QVERIFY(!revert.isVisible());
            for (const auto& [other, otherField] : rows)
                QCOMPARE(bench.model.isDirty(otherField), otherField != field);
            bench.verify();
        }
    }

    void theContextMenuRevertsToo()
    {
        Fixture bench;
        QVERIFY(bench.shown());
        bench.model.setDimensionality(3);
        QContextMenuEvent event(QContextMenuEvent::Keyboard, QPoint(5, 5),
            bench.dimensionality->mapToGlobal(QPoint(5, 5)));
        QApplication::sendEvent(bench.dimensionality, &event);
        auto* menu = bench.dimensionality->findChild<QMenu*>(QStringLiteral("dimensionalityMenu"));
        QVERIFY(menu);
        QTRY_VERIFY(menu->isVisible());
        QTest::keyClick(menu, Qt::Key_R);
        QTRY_COMPARE(bench.model.edited().dimensionality, 2);
    }

    void aWheelOverThePageChangesNothing()
    {
        Fixture bench;
        QVERIFY(bench.shown());
        for (QWidget* editor : std::initializer_list<QWidget*>{
                 bench.dimensionality, bench.source, bench.source->lineEdit(), bench.persistency}) {
            const QPointF place(5, 5);
            QWheelEvent wheel(place, editor->mapToGlobal(place), {0, -120}, {0, -120}, Qt::NoButton,
                Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(editor, &wheel);
        }
        QVERIFY(!bench.model.isDirty());
        QCOMPARE(bench.writes, 0);
    }

    void fieldsAndModelStayTheSameOverManySteps()
    {
        Fixture bench;
        QVERIFY(bench.shown());
        std::mt19937 random(7);
        const auto below = [&](int end) {
            return std::uniform_int_distribution<int>(0, end - 1)(random);
        };
        for (int step = 0; step < 1'000; ++step) {
            switch (below(6)) {
            case 0:
                QTest::keyClick(bench.dimensionality, below(2) == 0 ? Qt::Key_Up : Qt::Key_Down);
                break;
            case 1:
                QTest::keyClick(bench.persistency, Qt::Key_Space);
                break;
            case 2:
                bench.model.setDimensionality(1 + below(3));
                break;
            case 3:
                bench.model.setSource(1, below(2) == 0 ? x : y);
                break;
            case 4: {
                CompensationSetup drive = onDrive();
                drive.dimensionality = 1 + below(3);
                drive.sources[0] = below(2) == 0 ? x : y;
                bench.model.setBaseline(drive);
                break;
            }
            default:
                bench.model.revert(allFields.at(std::size_t(below(6))));
                break;
            }
            bench.verify();
            QVERIFY2(!QTest::currentTestFailed(), qPrintable(QStringLiteral("step %1").arg(step)));
        }
    }
};

AXISCOMP_WINDOW_TEST(TestFieldBinder)

} // namespace tst_fieldbinder

#include "tst_fieldbinder.moc"
