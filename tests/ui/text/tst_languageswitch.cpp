// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/calibration_csv.h"
#include "core/formats/table_format.h"
#include "tests/support/verify.h"
#include "tests/ui/support/configuration_files.h"
#include "tests/ui/support/page_scene.h"
#include "tests/ui/support/pseudo_language.h"
#include "tests/ui/support/visible_texts.h"
#include "tests/ui/support/window_test.h"
#include "ui/text/language.h"

#include "ui/drawing/custom_plot.h"
#include <QActionGroup>
#include <QTest>

#include <algorithm>

namespace tst_languageswitch {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageScene;
using test::VisibleTexts;

namespace {

/// Words that an engineer writes in both languages.
const QSet<QString>& sameInBoth()
{
    static const QSet<QString> words{QStringLiteral("Details"), QStringLiteral("Dim"),
        QStringLiteral("Problem"), QStringLiteral("System"), QStringLiteral("English"),
        QStringLiteral("Deutsch"), QStringLiteral("Index"), QStringLiteral("index"),
        QStringLiteral("min"), QStringLiteral("max"), QStringLiteral("rms"), QStringLiteral("OK"),
        QStringLiteral("Station")};
    return words;
}

/// What a text is made of that is neither in a language nor a number: paths, addresses, names of
/// files, tables, axes and drives, units, names that are the drive's own.
QString withoutData(QString text)
{
    static const QRegularExpression data(QStringLiteral(
        "(https?|tam|serial)://?\\S+|demo:|\\S*[/\\\\]\\S*|0x[0-9a-f]+|\\S+\\.(csv|json|txt|TAMcfg)"
        "|Demo [XY] over X, Y|\\b[0-9A-F]{8}\\b"
        "|\\b(Triamec-616|Demo|Gantry)\\b|\\b(Small|Large)\\d\\b|\\b(first|second|table \\d)\\b"
        "|\\b[XYZT]\\b|\\b[123]D\\b|[µm]?m\\b|°C|<[^>]*>|&\\w+;|\\bDim\\d|[A-Z][a-z]+[A-Z]\\w+"
        "|[A-Z][a-z]+: |X \\[mm\\].*"));
    return text.remove(data).remove(u'&');
}

/// Without the names of controllers, tables and states of a drive, quotations, and Qt's own words.
QString withoutNames(QString text)
{
    static const QRegularExpression name(
        QStringLiteral("\"[^\"]*\"|Table \\d|the disk is full|PMAC|KFLOP, KMotion|RSI "
                       "RapidCode|softMC|Active\\.|^Cancel$"));
    text.remove(name);
    for (const TableFormat* format : tableFormats())
        text.remove(QString::fromStdString(std::string(format->facts.controller)));
    return text;
}

/// The log's details are for experts and for a report to the makers: English in every language.
bool isForExperts(const QString& place)
{
    static const QRegularExpression detail(QStringLiteral("/logLines cell \\d+,2 "));
    return detail.match(place).hasMatch();
}

bool isTheSameInBothLanguages(const QString& text)
{
    static const QRegularExpression word(QStringLiteral("[A-Za-zäöüß]{2,}"));
    for (auto matches = word.globalMatch(withoutData(text)); matches.hasNext();) {
        if (!sameInBoth().contains(matches.next().captured()))
            return false;
    }
    return true;
}

/// Live values come and go between two looks.
bool isLive(const QString& place)
{
    static const QStringList live{QStringLiteral("liveValues"), QStringLiteral("stateDetail"),
        QStringLiteral("readout"), QStringLiteral("sourceNote"), QStringLiteral("logLines"),
        QStringLiteral("busyStep")};
    return std::ranges::any_of(live, [&](const QString& name) { return place.contains(name); });
}

VisibleTexts lasting(VisibleTexts texts)
{
    texts.removeIf([](VisibleTexts::iterator it) { return isLive(it.key()); });
    return texts;
}

QStringList plotTexts(const QWidget& window)
{
    QStringList texts;
    for (auto* plot : window.findChildren<QCustomPlot*>()) {
        for (const auto* axis : {plot->xAxis, plot->yAxis})
            texts += axis->label();
        for (int i = 0; i < plot->graphCount(); ++i)
            texts += plot->graph(i)->name();
        for (int i = 0; i < plot->plottableCount(); ++i) {
            if (const auto* map = qobject_cast<QCPColorMap*>(plot->plottable(i)))
                texts += map->colorScale() ? map->colorScale()->label() : QString();
        }
    }
    return texts;
}

void showConfiguration(PageScene& scene, const char* action)
{
    scene.choose2D();
    scene.write();
    scene.beginConfiguration(scene.stage().file(QStringLiteral("machine.TAMcfg"),
                                 test::tamConfiguration({{"Gantry", 2207, {{}, {}}}})),
        action);
    const auto hasText = [&](const char* label) {
        const auto* reason = scene.page().findChild<QLabel*>(QLatin1StringView(label));
        return reason && !reason->text().contains(QStringLiteral("…"));
    };
    test::wait([&] { return hasText("multiAxisReason") || hasText("exportConfigurationReason"); },
        "the reason");
}

struct State {
    const char* name;
    std::function<void(PageScene&)> reach;
};

void showProblems(PageScene& scene)
{
    scene.choose2D();
    scene.openData(scene.stage().file(QStringLiteral("bad.csv"),
        "X [mm],Y [mm],table 1\n0,0,0.001\n10,0,0.0O2\n20,0,0.001\n0,10,nan\n10,10\n"));
}

void activate(PageScene& scene)
{
    scene.choose2D();
    scene.write();
    scene.click("activateButton");
    test::wait([&] { return scene.controller().proof().has_value(); }, "the proof");
}

void refuseTable(PageScene& scene)
{
    scene.choose2D();
    scene.stage().gate().refuseUploads(
        Error{ErrorCode::TableRefused, {{"reason", Verbatim{"the disk is full"}}}, {}});
    scene.click("writeButton");
    scene.click("confirmWriteButton");
    test::wait([&] { return scene.controller().isOutcomeAnError(); }, "the refusal");
}

void show3D(PageScene& scene)
{
    scene.showDrive();
    scene.controller().setup().setDimensionality(3);
    scene.openData(scene.stage().file(
        QStringLiteral("volume.csv"), QByteArray::fromStdString(exampleCalibrationCsv(3))));
    scene.controller().setup().setTable({0});
}

const std::vector<State>& states()
{
    static const std::vector<State> all{
        {"first start", [](PageScene& scene) { scene.showDrive(true); }},
        {"unwritten", [](PageScene& scene) { scene.choose2D(); }},
        {"preview",
            [](PageScene& scene) {
                scene.choose2D();
                scene.click("writeButton");
                test::wait([&] { return scene.controller().plan().has_value(); }, "the plan");
            }},
        {"active", activate},
        {"refused", refuseTable},
        {"problems", showProblems},
        {"three dimensions", show3D},
        {"log",
            [](PageScene& scene) {
                activate(scene);
                scene.click("logButton");
            }},
        {"import configuration",
            [](PageScene& scene) { showConfiguration(scene, "importConfigurationAction"); }},
        {"export configuration",
            [](PageScene& scene) { showConfiguration(scene, "exportConfigurationAction"); }},
        {"connections",
            [](PageScene& scene) {
                scene.showDrive();
                scene.click("connectionsButton");
            }},
        {"question before leaving",
            [](PageScene& scene) {
                scene.choose2D();
                QVERIFY(!scene.page().mayClose());
            }},
    };
    return all;
}

/// The page, or the dialog that is open on it.
const QWidget& shownWindow(PageScene& scene)
{
    for (const auto* dialog : scene.page().findChildren<QDialog*>()) {
        if (dialog->isVisible())
            return *dialog;
    }
    return scene.page();
}

/// By the menu, as a person does.
void chooseLanguage(PageScene& scene, const QString& language)
{
    auto* menu = scene.page().findChild<QMenu*>(QStringLiteral("languageMenu"));
    QVERIFY(menu);
    for (QAction* action : menu->actions()) {
        if (!action->isSeparator() && action->data().toString() == language) {
            action->trigger();
            QCoreApplication::sendPostedEvents(nullptr, QEvent::LanguageChange);
            return;
        }
    }
    QFAIL(qPrintable(QStringLiteral("the menu does not offer ") + language));
}

QByteArray differences(const VisibleTexts& before, const VisibleTexts& after)
{
    QByteArray found;
    for (const QString& place : QSet<QString>(before.keyBegin(), before.keyEnd())
            + QSet<QString>(after.keyBegin(), after.keyEnd())) {
        if (before.value(place) != after.value(place))
            found += place.toUtf8() + ": \"" + before.value(place).toUtf8() + "\" became \""
                + after.value(place).toUtf8() + "\"\n";
    }
    return found;
}

} // namespace

/// The language is changed while the page is in use, in every state that it can be in.
class TestLanguageSwitch : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void everyTextChangesAndComesBack_data()
    {
        QTest::addColumn<int>("state");
        int number = 0;
        for (const State& state : states())
            QTest::newRow(state.name) << number++;
    }
    void everyTextChangesAndComesBack()
    {
        QFETCH(int, state);
        PageScene scene;
        chooseLanguage(scene, QStringLiteral("en"));
        states()[std::size_t(state)].reach(scene);
        scene.settle();
        const QWidget& window = shownWindow(scene);
        const VisibleTexts english = test::visibleTexts(window);
        QVERIFY(english.size() > 10);

        chooseLanguage(scene, QStringLiteral("de"));
        const VisibleTexts german = test::visibleTexts(window);
        QByteArray unchanged;
        for (auto it = german.cbegin(); it != german.cend(); ++it) {
            if (english.value(it.key()) == it.value() && !isForExperts(it.key())
                && !isTheSameInBothLanguages(it.value()))
                unchanged += it.key().toUtf8() + ": \"" + it.value().toUtf8() + "\"\n";
        }
        QVERIFY2(unchanged.isEmpty(), unchanged.constData());

        chooseLanguage(scene, QStringLiteral("en"));
        const QByteArray different =
            differences(lasting(english), lasting(test::visibleTexts(window)));
        QVERIFY2(different.isEmpty(), different.constData());
    }

    void everyTextIsInTheTranslationFile_data() { everyTextChangesAndComesBack_data(); }
    void everyTextIsInTheTranslationFile()
    {
        QFETCH(int, state);
        PageScene scene;
        chooseLanguage(scene, QStringLiteral("en"));
        const test::PseudoLanguage language;
        QVERIFY(language.isValid());
        states()[std::size_t(state)].reach(scene);
        scene.settle();
        const VisibleTexts texts = test::visibleTexts(shownWindow(scene));
        QByteArray untranslated;
        for (auto it = texts.cbegin(); it != texts.cend(); ++it) {
            if (!isForExperts(it.key())
                && !isTheSameInBothLanguages(withoutNames(test::outsideBrackets(it.value()))))
                untranslated += it.key().toUtf8() + ": \"" + it.value().toUtf8() + "\"\n";
        }
        QVERIFY2(untranslated.isEmpty(), untranslated.constData());
    }

    void thePlotsWordsChange()
    {
        PageScene scene;
        chooseLanguage(scene, QStringLiteral("en"));
        scene.choose2D();
        const QString english = plotTexts(scene.page()).join(u'|');
        QVERIFY2(english.contains(QStringLiteral("compensation")), qPrintable(english));
        chooseLanguage(scene, QStringLiteral("de"));
        const QString german = plotTexts(scene.page()).join(u'|');
        QVERIFY2(german.contains(QStringLiteral("Kompensation")), qPrintable(german));
        chooseLanguage(scene, QStringLiteral("en"));
        QCOMPARE(plotTexts(scene.page()).join(u'|'), english);
    }

    void thePageIsToldOnce()
    {
        class Listener : public QObject {
        public:
            bool eventFilter(QObject*, QEvent* event) override
            {
                changes += event->type() == QEvent::LanguageChange ? 1 : 0;
                return false;
            }
            int changes = 0;
        } listener;
        PageScene scene;
        chooseLanguage(scene, QStringLiteral("en"));
        scene.showDrive();
        scene.page().installEventFilter(&listener);
        chooseLanguage(scene, QStringLiteral("de"));
        QCOMPARE(listener.changes, 1);
        chooseLanguage(scene, QStringLiteral("en"));
        QCOMPARE(listener.changes, 2);
    }

    void qtsOwnButtonsAreGermanToo()
    {
        // From the package qt6-translations-l10n.
        PageScene scene;
        chooseLanguage(scene, QStringLiteral("de"));
        scene.showDrive();
        scene.click("connectionsButton");
        QStringList buttons;
        for (const auto* button : shownWindow(scene).findChildren<QAbstractButton*>())
            buttons += button->text().remove(u'&');
        QVERIFY2(buttons.contains(QStringLiteral("Abbrechen")), qPrintable(buttons.join(u' ')));
    }
};

AXISCOMP_WINDOW_TEST(TestLanguageSwitch)

} // namespace tst_languageswitch

#include "tst_languageswitch.moc"
