// SPDX-License-Identifier: GPL-3.0-or-later
// Renders every state of the page into PNG files, for a person to look at: in each language, in one
// whose texts are a third longer, light and dark, on three sizes of screen.
//
//   axiscomp-wizard-pictures FOLDER [STATE...]   the screens that have the scale of QT_SCALE_FACTOR
//   axiscomp-wizard-pictures --sheet FOLDER      FOLDER/index.html, with all pictures of the folder
#include "tests/ui/support/long_texts.h"
#include "tests/ui/support/scene_states.h"
#include "tests/ui/support/window_test.h"
#include "ui/text/language.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QStyleFactory>
#include <QTextStream>

#include <algorithm>
#include <string_view>

using namespace axiscomp;
using namespace axiscomp::ui;
using axiscomp::test::PageScene;
using axiscomp::test::SceneState;
using axiscomp::test::ScreenSize;

namespace {

const QLatin1StringView longTexts("long");
const QLatin1StringView usage("usage: axiscomp-wizard-pictures [--sheet] FOLDER [STATE...]");

/// While it is there the program speaks a language; longTexts is English that is longer.
class Spoken {
public:
    explicit Spoken(const QString& language)
        : m_language(language == longTexts ? QStringLiteral("en") : language)
    {
        if (language == longTexts)
            QApplication::installTranslator(&m_long);
        settle();
    }
    ~Spoken()
    {
        QApplication::removeTranslator(&m_long);
        settle();
    }
    Spoken(const Spoken&) = delete;
    Spoken& operator=(const Spoken&) = delete;

private:
    static void settle() { QCoreApplication::sendPostedEvents(nullptr, QEvent::LanguageChange); }

    Language m_language;
    test::LongTexts m_long;
};

void save(QWidget& window, const QString& file)
{
    if (!window.grab().save(file))
        qFatal("cannot write %s", qPrintable(file));
    QTextStream(stdout) << file << Qt::endl;
}

/// file: its name without what is said of the screen.
void render(const SceneState& state, const QString& file, int scale)
{
    PageScene scene(state.isHomed);
    state.make(scene);
    scene.page().setFocus();
    QWidget& shown = test::shownWindow(scene);
    const QSize own = shown.size();
    for (const ScreenSize& screen : test::screenSizes) {
        if (screen.scale != scale)
            continue;
        shown.resize(own);
        test::fitTo(shown, screen.size, &shown == &scene.page());
        // Pictures of tables are drawn anew once they have been asked for.
        QTest::qWait(100);
        static_cast<void>(shown.grab());
        QTest::qWait(50);
        save(shown,
            QStringLiteral("%1-%2x%3.png")
                .arg(file)
                .arg(screen.size.width())
                .arg(screen.size.height()));
    }
    scene.stage().gate().releaseUploads();
}

/// A row for each state, with a link from each picture to itself.
void writeSheet(const QDir& folder)
{
    QFile file(folder.filePath(QStringLiteral("index.html")));
    if (!file.open(QIODevice::WriteOnly))
        qFatal("cannot write %s", qPrintable(file.fileName()));
    QTextStream html(&file);
    html
        << "<!DOCTYPE html>\n<meta charset=\"utf-8\">\n<title>Every state of the page</title>\n"
           "<style>body { font-family: sans-serif } figure { display: inline-block; margin: 4px }"
           " img { width: 400px; border: 1px solid gray } figcaption { font-size: 12px }</style>\n";
    for (const SceneState& state : test::sceneStates()) {
        const QString name = QLatin1StringView(state.name);
        html << "<h2>" << name << "</h2>\n";
        const QStringList pictures = folder.entryList(
            {name + QStringLiteral("-light-*.png"), name + QStringLiteral("-dark-*.png")});
        for (const QString& picture : pictures)
            html << "<figure><a href=\"" << picture << "\"><img loading=\"lazy\" src=\"" << picture
                 << "\"></a><figcaption>" << picture.mid(name.size() + 1).chopped(4)
                 << "</figcaption></figure>\n";
    }
    QTextStream(stdout) << file.fileName() << Qt::endl;
}

} // namespace

int main(int argc, char** argv)
{
    const auto isHelp = [](std::string_view text) { return text == "--help" || text == "-h"; };
    if (std::any_of(argv + 1, argv + argc, isHelp)) { // without a screen, too
        QTextStream(stdout) << usage << Qt::endl;
        return 0;
    }
    QApplication application(argc, argv);
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QStringList arguments = QApplication::arguments().mid(1);
    const bool isSheet = arguments.removeAll(QStringLiteral("--sheet")) > 0;
    if (arguments.isEmpty() || arguments.front().startsWith(u'-')) { // a folder may be ./-x
        QTextStream(stderr) << usage << Qt::endl;
        return 2;
    }
    const QDir folder(arguments.front());
    if (!folder.mkpath(QStringLiteral(".")))
        qFatal("cannot make %s", qPrintable(folder.path()));
    if (isSheet) {
        writeSheet(folder);
        return 0;
    }
    const QStringList wanted = arguments.mid(1);
    const QPalette light = QApplication::palette();
    for (const QString& language : Language::available() + QStringList(longTexts)) {
        const Spoken spoken(language);
        for (const bool isDark : {false, true}) {
            QApplication::setPalette(isDark ? test::darkPalette() : light);
            for (const SceneState& state : test::sceneStates()) {
                const QString name = QLatin1StringView(state.name);
                if (!wanted.isEmpty() && !wanted.contains(name))
                    continue;
                const QString palette = isDark ? QStringLiteral("dark") : QStringLiteral("light");
                render(state,
                    folder.filePath(QStringLiteral("%1-%2-%3").arg(name, palette, language)),
                    qRound(application.devicePixelRatio()));
            }
        }
    }
    return 0;
}
