// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/orange_pixels.h"
#include "tests/ui/support/page_stage.h"
#include "tests/ui/support/window_test.h"
#include "ui/fields/field_row.h"
#include "ui/fields/source_combo.h"
#include "ui/style/contrast.h"
#include "ui/style/dirty_style.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QTest>

#include <random>

namespace tst_dirtystyle {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageStage;
using test::Picture;

namespace {

constexpr double leastContrast = 3.0;

enum class Kind { ComboBox, SourceCombo, CheckBox, LineEdit };

QWidget* makeUnnamed(Kind kind)
{
    switch (kind) {
    case Kind::ComboBox: {
        auto* combo = new QComboBox;
        combo->addItems({QStringLiteral("2D"), QStringLiteral("3D")});
        return combo;
    }
    case Kind::SourceCombo: {
        auto* combo = new SourceCombo;
        combo->showValue(QStringLiteral("tam://mc/Drive/Axes[0]/Signals"));
        return combo;
    }
    case Kind::CheckBox:
        return new QCheckBox(QStringLiteral("Make persistent"));
    case Kind::LineEdit:
        break;
    }
    return new QLineEdit(QStringLiteral("file.csv"));
}

QWidget* makeEditor(Kind kind)
{
    QWidget* editor = makeUnnamed(kind);
    editor->setObjectName(QStringLiteral("someField"));
    return editor;
}

/// One field in a window, with something beside it that can have the focus.
struct Fixture {
    explicit Fixture(Kind kind)
        : row(makeEditor(kind), &style, &window)
        , other(new QLineEdit(&window))
    {
        window.setContentsMargins(12, 12, 12, 12);
        auto* grid = new QGridLayout(&window);
        grid->setColumnStretch(1, 1);
        row.addTo(*grid, 0);
        grid->addWidget(other, 2, 1);
        row.setTexts({QStringLiteral("&Field"), QStringLiteral("what it is for"),
            QStringLiteral("A field")});
        window.resize(420, 140);
    }

    [[nodiscard]] QRect place() { return {row.editor().mapTo(&window, QPoint()), editorSize()}; }
    [[nodiscard]] QSize editorSize() { return row.editor().size(); }

    DirtyStyle style;
    QWidget window;
    FieldRow row;
    QLineEdit* other;
};

const QString onDrive = QStringLiteral("1D");

struct NamedField {
    Field field;
    const char* editor;
};
const std::array<NamedField, allFields.size()> fieldEditors{{
    {Field::Dimensionality, "dimensionalityField"},
    {Field::Source1, "source1Field"},
    {Field::Source2, "source2Field"},
    {Field::Source3, "source3Field"},
    {Field::Table, "tableField"},
    {Field::Persistency, "persistencyField"},
}};

} // namespace

class TestDirtyStyle : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWindowWarnings();
        QApplication::setPalette(QPalette());
    }
    void cleanupTestCase() { QApplication::setPalette(QPalette()); }

    void aChangedFieldHasAWholeOrangeFrameAndOnlyThen_data()
    {
        QTest::addColumn<Kind>("kind");
        QTest::addColumn<QString>("state");
        QTest::addColumn<bool>("isDark");
        QTest::addColumn<int>("scale");
        const std::array<std::pair<Kind, const char*>, 4> kinds{
            {{Kind::ComboBox, "combo box"}, {Kind::SourceCombo, "source"},
                {Kind::CheckBox, "check box"}, {Kind::LineEdit, "line edit"}}};
        for (const auto& [kind, name] : kinds) {
            for (const char* state : {"enabled", "disabled", "focused"}) {
                for (const bool isDark : {false, true}) {
                    for (const int scale : {1, 2})
                        QTest::addRow(
                            "%s, %s, %s, %dx", name, state, isDark ? "dark" : "light", scale)
                            << kind << QString::fromLatin1(state) << isDark << scale;
                }
            }
        }
    }

    void aChangedFieldHasAWholeOrangeFrameAndOnlyThen()
    {
        QFETCH(Kind, kind);
        QFETCH(QString, state);
        QFETCH(bool, isDark);
        QFETCH(int, scale);
        if (isDark)
            QApplication::setPalette(test::darkPalette());
        Fixture fixture(kind);
        QVERIFY(test::showActive(fixture.window));
        if (state == QStringLiteral("focused"))
            fixture.row.editor().setFocus();
        else
            fixture.other->setFocus();
        fixture.row.setEnabled(state != QStringLiteral("disabled"));
        QCOMPARE(fixture.row.editor().hasFocus(), state == QStringLiteral("focused"));
        QCOMPARE(Picture(fixture.window, scale).orangePixels(fixture.window.rect()), 0);

        fixture.row.setDirty(true, onDrive);
        const Picture changed(fixture.window, scale);
        const QRect place = fixture.place();
        const double coverage = changed.frameCoverage(place);
        QVERIFY2(coverage > 0.8, qPrintable(QStringLiteral("a side has %1").arg(coverage)));
        for (const auto side :
            {Picture::Side::Top, Picture::Side::Bottom, Picture::Side::Left, Picture::Side::Right})
            verifyContrast(changed.section(place, side));
        // Inside the frame and beside the field nothing is orange but the line that says it.
        constexpr int border = 5;
        QCOMPARE(changed.orangePixels(place.adjusted(border, border, -border, -border)), 0);
        const auto* note = fixture.window.findChild<QLabel*>(QStringLiteral("someFieldNote"));
        const QWidget* line = note->parentWidget();
        const QRegion elsewhere =
            QRegion(fixture.window.rect()) - QRegion(place) - QRegion(line->geometry());
        QCOMPARE(changed.orangePixels(elsewhere), 0);

        fixture.row.setDirty(false, {});
        QCOMPARE(Picture(fixture.window, scale).orangePixels(fixture.window.rect()), 0);
    }

    void theFrameTakesNoPlace()
    {
        for (const Kind kind :
            {Kind::ComboBox, Kind::SourceCombo, Kind::CheckBox, Kind::LineEdit}) {
            Fixture fixture(kind);
            const QSize before = fixture.row.editor().sizeHint();
            fixture.row.setDirty(true, onDrive);
            QCOMPARE(fixture.row.editor().sizeHint(), before);
        }
    }

    void textToolTipAndScreenReaderSayTheSameAsTheFrame()
    {
        Fixture fixture(Kind::ComboBox);
        QVERIFY(test::showActive(fixture.window));
        const auto* note = fixture.window.findChild<QLabel*>(QStringLiteral("someFieldNote"));
        const auto* revert = fixture.window.findChild<QWidget*>(QStringLiteral("someFieldRevert"));
        const auto* editor = &fixture.row.editor();
        QCOMPARE(editor->toolTip(), QStringLiteral("what it is for"));
        QCOMPARE(editor->accessibleDescription(), QStringLiteral("A field"));
        QVERIFY(!revert->isVisible());

        fixture.row.setDirty(true, onDrive);
        QCOMPARE(note->text(), QStringLiteral("changed, on the drive: 1D"));
        QVERIFY(note->isVisible());
        QCOMPARE(editor->toolTip(), QStringLiteral("on the drive: 1D\nwhat it is for"));
        QCOMPARE(
            editor->accessibleDescription(), QStringLiteral("changed, on the drive: 1D. A field"));
        QVERIFY(revert->isVisible());

        // A problem matters more in the line; the rest goes on saying it.
        fixture.row.setProblem(QStringLiteral("There is no such register."));
        QCOMPARE(note->text(), QStringLiteral("There is no such register."));
        QVERIFY(
            editor->accessibleDescription().contains(QStringLiteral("changed, on the drive: 1D")));
        QVERIFY(editor->toolTip().contains(QStringLiteral("on the drive: 1D")));
        fixture.row.setProblem({});

        fixture.row.setDirty(false, {});
        QCOMPARE(editor->toolTip(), QStringLiteral("what it is for"));
        QCOMPARE(editor->accessibleDescription(), QStringLiteral("A field"));
        QVERIFY(!note->text().contains(QStringLiteral("changed")));
        QVERIFY(!revert->isVisible());
    }

    void theTextMarkCanBeReadInBothPalettes()
    {
        for (const bool isDark : {false, true}) {
            const QPalette palette = isDark ? test::darkPalette() : QPalette();
            for (const auto role : {QPalette::Window, QPalette::Base})
                QVERIFY(
                    contrastRatio(textColor(Tone::Changed, palette), palette.color(role)) >= 4.5);
        }
    }

    void thePageIsOrangeWhereTheModelSaysChangedAndNowhereElse_data()
    {
        QTest::addColumn<bool>("isDark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }

    void thePageIsOrangeWhereTheModelSaysChangedAndNowhereElse()
    {
        QFETCH(bool, isDark);
        if (isDark)
            QApplication::setPalette(test::darkPalette());
        PageStage stage;
        WizardOptions options = stage.options();
        options.liveInterval = std::chrono::milliseconds(0); // the drive's state is the test's
        CompensationWizard wizard(options, nullptr);
        WizardController& controller = wizard.controller();
        wizard.resize(1280, 900);
        controller.setEndpoints({PageStage::endpoint()});
        QVERIFY(test::showActive(wizard));
        QTRY_VERIFY(controller.status().has_value());
        controller.setup().setDimensionality(2);
        wizard.openData(stage.superData());
        QTRY_VERIFY(controller.dataFile().data);

        std::mt19937 random(20260); // the same walk every time
        std::array<int, allFields.size()> seenChanged{};
        for (int step = 0; step < 400; ++step) {
            changeSomething(controller, random);
            if (step % 8 == 0)
                QCoreApplication::processEvents();
            compare(wizard, step, seenChanged);
            if (QTest::currentTestFailed())
                return;
        }
        for (const auto& [field, name] : fieldEditors)
            QVERIFY2(seenChanged.at(static_cast<std::size_t>(field)) > 20, name);
    }

private:
    static void verifyContrast(const Picture::Section& section)
    {
        QVERIFY2(section.frame.isValid(), "a side has no frame");
        for (const QColor& neighbour : {section.outside, section.inside}) {
            const double ratio = contrastRatio(section.frame, neighbour);
            QVERIFY2(ratio >= leastContrast,
                qPrintable(QStringLiteral("%1 against %2: %3")
                               .arg(section.frame.name(), neighbour.name())
                               .arg(ratio)));
        }
    }

    static void changeSomething(WizardController& controller, std::mt19937& random)
    {
        SetupModel& setup = controller.setup();
        const auto below = [&](std::size_t end) {
            return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
        };
        const auto& sources = controller.sourceShortlist();
        const auto source = [&] { return below(4) == 0 ? DimSource{} : sources[below(6)]; };
        const auto persistency = [&] {
            return below(2) == 0 ? Persistency::Volatile : Persistency::Persistent;
        };
        switch (below(8)) {
        case 0:
            setup.setDimensionality(1 + static_cast<int>(below(3)));
            return;
        case 1:
        case 2:
        case 3:
            setup.setSource(1 + static_cast<int>(below(3)), source());
            return;
        case 4:
            if (controller.dataFile().data)
                setup.setTable(below(2) == 0 ? TableChoice{} : TableChoice{int(below(2))});
            return;
        case 5:
            setup.setPersistency(persistency());
            return;
        case 6:
            setup.revert(allFields.at(below(allFields.size())));
            return;
        default:
            break;
        }
        if (below(8) == 0) {
            setup.revert();
            return;
        }
        CompensationSetup drive = setup.baseline();
        drive.dimensionality = 1 + static_cast<int>(below(3));
        drive.sources.at(below(3)) = source();
        drive.persistency = persistency();
        setup.setBaseline(drive);
    }

    static void compare(CompensationWizard& wizard, int step, std::array<int, 6>& seenChanged)
    {
        auto* panel = wizard.findChild<QWidget*>(QStringLiteral("setupPanel"));
        const Picture picture(*panel);
        QRegion elsewhere(panel->rect());
        for (const auto& [field, name] : fieldEditors) {
            const auto* editor = panel->findChild<QWidget*>(QLatin1StringView(name));
            if (!editor->isVisibleTo(panel))
                continue;
            const bool isDirty = wizard.controller().setup().isDirty(field);
            const auto* note =
                panel->findChild<QLabel*>(QLatin1StringView(name) + QStringLiteral("Note"));
            const QString where =
                QStringLiteral("step %1, %2").arg(step).arg(QLatin1StringView(name));
            const double coverage = picture.frameCoverage(editor->geometry());
            QVERIFY2(isDirty ? coverage > 0.8 : picture.orangePixels(editor->geometry()) == 0,
                qPrintable(where + QStringLiteral(": frame %1").arg(coverage)));
            const auto saysSo = [&](const QString& text) {
                return text.contains(QStringLiteral("on the drive: ")) == isDirty;
            };
            QVERIFY2(saysSo(note->text()), qPrintable(where + u' ' + note->text()));
            QVERIFY2(saysSo(editor->toolTip()), qPrintable(where + u' ' + editor->toolTip()));
            QVERIFY2(saysSo(editor->accessibleDescription()), qPrintable(where));
            // What the file says against a source is amber, whether it is changed or not.
            const int dimension = static_cast<int>(field) - static_cast<int>(Field::Source1) + 1;
            if (dimension >= 1 && dimension <= 3
                && !wizard.controller().sourceDoubt(dimension).isEmpty())
                elsewhere -= note->parentWidget()->geometry();
            if (!isDirty)
                continue;
            ++seenChanged.at(static_cast<std::size_t>(field));
            elsewhere -= editor->geometry();
            elsewhere -= note->parentWidget()->geometry();
        }
        QVERIFY2(picture.orangePixels(elsewhere) == 0,
            qPrintable(QStringLiteral("step %1: orange beside the fields").arg(step)));
    }
};

AXISCOMP_WINDOW_TEST(TestDirtyStyle)

} // namespace tst_dirtystyle

#include "tst_dirtystyle.moc"
