// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "ui/controller/setup_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include <random>
#include <set>

namespace tst_setupmodel {

using namespace axiscomp;
using namespace axiscomp::ui;

namespace {

const DimSource x{0x1000, "Axes[0]/Signals/PositionController/MasterPosition"};
const DimSource y{0x2000, "Axes[1]/Signals/PositionController/MasterPosition"};
const DimSource temperature{0x3000, "Axes[0]/Signals/General/MotorTemperature"};

CompensationSetup twoDimensions()
{
    CompensationSetup setup;
    setup.dimensionality = 2;
    setup.sources = {x, y, DimSource{}};
    setup.slot = "Small1";
    setup.tableCrc = 0xc0ffee;
    setup.persistency = Persistency::Persistent;
    return setup;
}

/// The rule itself, spelled out once more.
bool differs(Field field, const EditedSetup& edited, const CompensationSetup& baseline)
{
    const auto source = [&](std::size_t n) {
        return static_cast<int>(n) < edited.dimensionality
            && edited.sources[n].address != baseline.sources[n].address;
    };
    switch (field) {
    case Field::Dimensionality:
        return edited.dimensionality != baseline.dimensionality;
    case Field::Source1:
        return source(0);
    case Field::Source2:
        return source(1);
    case Field::Source3:
        return source(2);
    case Field::Table:
        return edited.table.fileTable.has_value();
    case Field::Persistency:
        return edited.persistency != baseline.persistency;
    }
    return false;
}

} // namespace

class TestSetupModel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aSourceCountsOnlyWithItsDimensionAndIsNotLostWithIt()
    {
        using Paths = std::vector<std::string>;
        SetupModel model;
        model.reset(twoDimensions());
        QCOMPARE(sourcePaths(model.edited()), (Paths{x.path, y.path}));
        model.setDimensionality(1);
        QCOMPARE(sourcePaths(model.edited()), Paths{x.path});
        model.setDimensionality(2);
        QCOMPARE(sourcePaths(model.edited()), (Paths{x.path, y.path}));
    }

    void withoutABaselineNothingIsChanged()
    {
        SetupModel model;
        model.setDimensionality(3);
        model.setTable({0});
        QVERIFY(!model.hasBaseline());
        QVERIFY(!model.isDirty());
        model.revert();
        QCOMPARE(model.edited().dimensionality, 3);
    }

    void aFieldIsChangedExactlyWhileItDiffers()
    {
        SetupModel model;
        model.reset(twoDimensions());
        QVERIFY(!model.isDirty());
        model.setSource(2, temperature);
        QVERIFY(model.isDirty(Field::Source2));
        QVERIFY(!model.isDirty(Field::Source1));
        model.setSource(2, {y.address, "another spelling of the same register"});
        QVERIFY(!model.isDirty());
    }

    void aTableOfTheFileIsAlwaysAChange()
    {
        SetupModel model;
        model.reset(twoDimensions());
        model.setTable({0});
        QVERIFY(model.isDirty(Field::Table));
        model.setTable({});
        QVERIFY(!model.isDirty());
    }

    void sourcesAboveTheDimensionalityDoNotCount()
    {
        SetupModel model;
        model.reset(twoDimensions());
        model.setSource(3, temperature);
        QVERIFY(!model.isDirty());
        model.setDimensionality(3);
        QVERIFY(model.isDirty(Field::Source3));
        model.setDimensionality(1);
        QVERIFY(!model.isDirty(Field::Source2));
        QVERIFY(model.isDirty(Field::Dimensionality));
    }

    void aNewBaselineIsFollowedExceptWhereTheUserHasChangedSomething()
    {
        SetupModel model;
        model.reset(twoDimensions());
        model.setPersistency(Persistency::Volatile);
        CompensationSetup elsewhere = twoDimensions();
        elsewhere.sources[1] = temperature;
        elsewhere.tableCrc = 1;
        model.setBaseline(elsewhere);
        QCOMPARE(model.edited().sources[1].address, temperature.address);
        QVERIFY(!model.isDirty(Field::Source2));
        QCOMPARE(model.edited().persistency, Persistency::Volatile);
        QVERIFY(model.isDirty(Field::Persistency));
        elsewhere.persistency = Persistency::Volatile;
        model.setBaseline(elsewhere);
        QVERIFY(!model.isDirty());
    }

    void anotherAxisDropsTheChanges()
    {
        SetupModel model;
        model.reset(twoDimensions());
        model.setDimensionality(3);
        model.reset(CompensationSetup{});
        QVERIFY(!model.isDirty());
        QCOMPARE(model.edited().dimensionality, 1);
        model.clear();
        QVERIFY(!model.hasBaseline());
    }

    void revertPutsTheDrivesValuesBackOneOrAll()
    {
        SetupModel model;
        model.reset(twoDimensions());
        model.setDimensionality(3);
        model.setTable({1});
        model.revert(Field::Table);
        QVERIFY(!model.isDirty(Field::Table));
        QVERIFY(model.isDirty(Field::Dimensionality));
        model.revert();
        QVERIFY(!model.isDirty());
        QCOMPARE(model.edited().dimensionality, 2);
    }

    void fieldChangedIsSentForEveryFieldThatLooksDifferentAndNoOther()
    {
        SetupModel model;
        model.reset(twoDimensions());
        std::set<Field> sent;
        connect(&model, &SetupModel::fieldChanged, this, [&](Field field) { sent.insert(field); });
        model.setSource(1, temperature);
        QCOMPARE(sent, (std::set<Field>{Field::Source1}));
        sent.clear();
        model.setSource(1, temperature);
        QVERIFY(sent.empty());
        // Dim2 Source is changed no more when there is no second dimension.
        model.setSource(2, temperature);
        sent.clear();
        model.setDimensionality(1);
        QCOMPARE(sent, (std::set<Field>{Field::Dimensionality, Field::Source2}));
    }

    void asATableItHasARowPerField()
    {
        SetupModel model;
        const auto value = [&](Field field, int role) {
            return model.data(model.index(static_cast<int>(field), 0), role);
        };
        QCOMPARE(model.rowCount(), static_cast<int>(allFields.size()));
        QVERIFY(!value(Field::Dimensionality, SetupModel::DriveValueRole).isValid());
        model.reset(twoDimensions());
        model.setSource(2, {0xbeef, {}});
        model.setTable({1});
        QCOMPARE(value(Field::Dimensionality, Qt::EditRole), QVariant(2));
        QCOMPARE(value(Field::Source1, Qt::EditRole), QVariant(QString::fromStdString(x.path)));
        QCOMPARE(value(Field::Source2, Qt::EditRole), QVariant(QStringLiteral("0x0000beef")));
        QCOMPARE(value(Field::Source2, SetupModel::DriveValueRole),
            QVariant(QString::fromStdString(y.path)));
        QCOMPARE(value(Field::Source2, SetupModel::DirtyRole), QVariant(true));
        QCOMPARE(value(Field::Source3, Qt::EditRole), QVariant(QString()));
        QCOMPARE(value(Field::Table, Qt::EditRole), QVariant(1));
        QVERIFY(!value(Field::Table, SetupModel::DriveValueRole).isValid());
        QCOMPARE(value(Field::Persistency, Qt::EditRole), QVariant(true));
        QCOMPARE(value(Field::Persistency, SetupModel::DirtyRole), QVariant(false));
        QVERIFY(!model.data({}, Qt::EditRole).isValid());
    }

    void aProblemIsAnnouncedButIsNoChange()
    {
        SetupModel model;
        model.reset(twoDimensions());
        const QSignalSpy changed(&model, &SetupModel::fieldChanged);
        const QSignalSpy data(&model, &SetupModel::dataChanged);
        model.setProblem(Field::Source2, [] { return QStringLiteral("No such register."); });
        QCOMPARE(model.problem(Field::Source2), QStringLiteral("No such register."));
        QCOMPARE(model.data(model.index(2, 0), SetupModel::ProblemRole).toString(),
            QStringLiteral("No such register."));
        QVERIFY(model.problem(Field::Source1).isEmpty());
        QVERIFY(!model.isDirty());
        QCOMPARE(data.count(), 1);
        QCOMPARE(changed.count(), 0);
        model.setProblem(Field::Source2, nullptr);
        QVERIFY(model.problem(Field::Source2).isEmpty());
    }

    void theChangedFieldsAreThoseThatDifferWhateverIsDone()
    {
        std::mt19937 random(20261121);
        const auto below = [&](int n) {
            return static_cast<int>(random() % static_cast<unsigned>(n));
        };
        const std::array sources{x, y, temperature, DimSource{}};
        SetupModel model;
        const QAbstractItemModelTester tester(&model);
        const QSignalSpy dataChanged(&model, &SetupModel::dataChanged);
        model.reset(twoDimensions());
        for (int step = 0; step < 10'000; ++step) {
            const EditedSetup before = model.edited();
            std::array<bool, allFields.size()> wasDirty{};
            for (std::size_t i = 0; i < allFields.size(); ++i)
                wasDirty[i] = model.isDirty(allFields[i]);
            std::set<Field> sent;
            const qsizetype rowsBefore = dataChanged.count();
            const auto connection = connect(
                &model, &SetupModel::fieldChanged, this, [&](Field field) { sent.insert(field); });
            randomChange(model, below, sources);
            disconnect(connection);
            bool isAnyDirty = false;
            for (std::size_t i = 0; i < allFields.size(); ++i) {
                const Field field = allFields[i];
                const bool isDirty = differs(field, model.edited(), model.baseline());
                QCOMPARE(model.isDirty(field), isDirty);
                QVERIFY(isDirty == wasDirty[i] || sent.contains(field));
                isAnyDirty |= isDirty;
            }
            QCOMPARE(model.isDirty(), isAnyDirty);
            QVERIFY(!sent.empty() || before == model.edited());
            QCOMPARE(dataChanged.count() - rowsBefore, static_cast<qsizetype>(sent.size()));
        }
    }

private:
    template <typename Below, typename Sources>
    static void randomChange(SetupModel& model, const Below& below, const Sources& sources)
    {
        const auto source = [&] { return sources[static_cast<std::size_t>(below(4))]; };
        const auto persistency = [&] {
            return below(2) ? Persistency::Persistent : Persistency::Volatile;
        };
        switch (below(8)) {
        case 0:
            return model.setDimensionality(1 + below(3));
        case 1:
            return model.setSource(1 + below(3), source());
        case 2:
            return model.setTable(below(2) ? TableChoice{below(3)} : TableChoice{});
        case 3:
            return model.setPersistency(persistency());
        case 4:
            return model.revert(allFields[static_cast<std::size_t>(below(6))]);
        case 5:
            return below(10) ? void() : model.revert();
        default:
            break;
        }
        CompensationSetup drive = model.baseline();
        drive.dimensionality = 1 + below(3);
        drive.sources[static_cast<std::size_t>(below(3))] = source();
        drive.persistency = persistency();
        drive.tableCrc = static_cast<std::uint32_t>(below(3));
        model.setBaseline(drive);
    }
};

AXISCOMP_TEST(TestSetupModel)

} // namespace tst_setupmodel

#include "tst_setupmodel.moc"
