// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/moments.h"
#include "tests/ui/support/long_texts.h"
#include "tests/ui/support/scene_states.h"
#include "tests/ui/support/text_fit.h"
#include "tests/ui/support/window_test.h"
#include "ui/text/language.h"

#include <QHBoxLayout>
#include <QPushButton>

namespace tst_textsfit {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::fitProblems;
using test::PageScene;
using test::SceneState;

namespace {

void laidOut()
{
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LanguageChange);
    QTest::qWait(1);
}

/// What is still wrong when the layouts, which ask each other, have come to an end.
QStringList lastingProblems(const QWidget& window)
{
    constexpr int untilLaidOut = 500;
    laidOut();
    QStringList problems;
    static_cast<void>(QTest::qWaitFor(
        [&] {
            problems = fitProblems(window);
            return problems.isEmpty();
        },
        untilLaidOut));
    return problems;
}

/// Of the tabs: the highest one makes the window.
QString leastHeights(const QWidget& window)
{
    QStringList heights;
    for (const char* name : {"measurePage", "judgePage", "fitPage", "columns", "provePage"})
        if (const auto* page = window.findChild<QWidget*>(QLatin1StringView(name)))
            heights += QLatin1StringView(name)
                + QStringLiteral(" %1").arg(page->minimumSizeHint().height());
    return heights.join(QStringLiteral(", "));
}

/// The languages that a state is looked at in, on every screen or on the smallest alone, which is
/// the one that a language is too long for. German is on every screen; the others take turns on the
/// smallest, and with AXISCOMP_EVERY_MOMENT all are on every screen.
enum class Looks { Everywhere, Smallest, Nowhere };
Looks looksAt(const QString& language, int state)
{
    if (test::takesEveryMoment() || language == QStringLiteral("de"))
        return Looks::Everywhere;
    const auto place = static_cast<int>(Language::available().indexOf(language));
    return test::hasTurn(place + state, 2) ? Looks::Smallest : Looks::Nowhere;
}

} // namespace

/// On every size of screen and in every language no text is cut and nothing is off the screen; nor
/// in one whose texts are a third longer, where the screen is not the smallest. looksAt() says
/// which are looked at.
class TestTextsFit : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void whatDoesNotFitIsNoticed()
    {
        QWidget window;
        auto* layout = new QHBoxLayout(&window);
        auto* button = new QPushButton(QStringLiteral("A button with many words"));
        auto* label = new QLabel(QStringLiteral("A label with many words"));
        layout->addWidget(button);
        layout->addWidget(label);
        window.show();
        QVERIFY(fitProblems(window).isEmpty());
        button->setFixedWidth(40);
        laidOut();
        QCOMPARE(fitProblems(window).size(), 1);
        label->setFixedWidth(30);
        laidOut();
        QCOMPARE(fitProblems(window).size(), 2);
        auto* outside = new QLabel(QStringLiteral("Word"), &window);
        outside->setGeometry(window.width() - 10, 0, 80, 20);
        outside->show();
        QCOMPARE(fitProblems(window).size(), 3);
    }

    void everythingFits_data()
    {
        QTest::addColumn<int>("state");
        int number = 0;
        for (const SceneState& state : test::sceneStates())
            QTest::newRow(state.name) << number++;
    }
    void everythingFits()
    {
        QFETCH(int, state);
        const SceneState& wanted = test::sceneStates()[static_cast<std::size_t>(state)];
        PageScene scene(wanted.isHomed);
        wanted.make(scene);
        QWidget& window = test::shownWindow(scene);
        const bool isPage = &window == &scene.page();
        const QSize own = window.size();
        QStringList problems;
        const auto check = [&](const QString& language, Looks looks, bool isLong) {
            for (const auto& screen : test::screenSizes) {
                if (isLong && screen.scale > 1)
                    continue; // the page becomes as wide as its texts
                if (screen.scale == 1 && looks != Looks::Everywhere)
                    continue;
                window.resize(own);
                test::fitTo(window, screen.size, isPage);
                const QStringList lasting = lastingProblems(window);
                const QString place = QStringLiteral("%1 %2x%3: ")
                                          .arg(language)
                                          .arg(screen.size.width())
                                          .arg(screen.size.height());
                if (window.width() > screen.size.width() || window.height() > screen.size.height())
                    problems += place
                        + QStringLiteral("the window is larger: %1x%2; least heights: %3")
                              .arg(window.width())
                              .arg(window.height())
                              .arg(leastHeights(window));
                for (const QString& problem : lasting)
                    problems += place + problem;
            }
        };
        for (const QString& language : Language::available()) {
            const Looks looks = looksAt(language, state);
            if (looks == Looks::Nowhere)
                continue;
            const Language spoken(language);
            check(language, looks, false);
        }
        const Language english(QStringLiteral("en"));
        test::LongTexts longTexts;
        QCoreApplication::installTranslator(&longTexts);
        check(QStringLiteral("long"), Looks::Everywhere, true);
        QCoreApplication::removeTranslator(&longTexts);
        scene.stage().gate().releaseUploads();
        QVERIFY2(problems.isEmpty(), qPrintable(u'\n' + problems.join(u'\n')));
    }
};

AXISCOMP_WINDOW_TEST(TestTextsFit)

} // namespace tst_textsfit

#include "tst_textsfit.moc"
