// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/window_test.h"
#include "ui/style/tone_label.h"

#include <QBoxLayout>
#include <QTest>

namespace tst_tonelabel {

using namespace axiscomp::ui;

namespace {

QPalette paletteOf(const QColor& window, const QColor& text)
{
    QPalette palette;
    palette.setColor(QPalette::Window, window);
    palette.setColor(QPalette::Base, window);
    palette.setColor(QPalette::WindowText, text);
    return palette;
}

QPalette light()
{
    return paletteOf(QColor(245, 245, 245), QColor(20, 20, 20));
}

QPalette dark()
{
    return paletteOf(QColor(30, 30, 30), QColor(230, 230, 230));
}

/// A label in a window, its colour as it is painted.
class Scene {
public:
    Scene() : m_label(new ToneLabel(QStringLiteral("text")))
    {
        m_window.setPalette(light());
        auto* layout = new QVBoxLayout(&m_window);
        layout->addWidget(m_label);
    }
    ToneLabel& label() { return *m_label; }
    void change(const QPalette& palette) { m_window.setPalette(palette); }
    [[nodiscard]] QColor color() const { return m_label->palette().color(QPalette::WindowText); }

private:
    QWidget m_window;
    ToneLabel* m_label;
};

} // namespace

/// Text in a tone can be read on every palette, also when that changes while it is shown.
class TestToneLabel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void toneFollowsThePaletteAround_data()
    {
        QTest::addColumn<Tone>("tone");
        QTest::newRow("error") << Tone::Error;
        QTest::newRow("warning") << Tone::Warning;
        QTest::newRow("success") << Tone::Success;
    }
    void toneFollowsThePaletteAround()
    {
        QFETCH(Tone, tone);
        Scene scene;
        scene.label().setTone(tone);
        QCOMPARE(scene.color(), textColor(tone, light()));
        scene.change(dark());
        QCOMPARE(scene.color(), textColor(tone, dark()));
        scene.change(light());
        QCOMPARE(scene.color(), textColor(tone, light()));
    }

    void mutedTextFollowsIt()
    {
        Scene scene;
        scene.label().setMuted();
        QCOMPARE(scene.color(), mutedTextColor(light()));
        scene.change(dark());
        QCOMPARE(scene.color(), mutedTextColor(dark()));
    }

    void withoutToneItLooksLikeOtherText()
    {
        Scene scene;
        scene.label().setTone(Tone::Error);
        scene.label().setTone(std::nullopt);
        QCOMPARE(scene.color(), light().color(QPalette::WindowText));
        scene.change(dark());
        QCOMPARE(scene.color(), dark().color(QPalette::WindowText));
    }

    void toneThatWasSetBeforeTheLabelWasPlacedFitsThere()
    {
        auto* label = new ToneLabel(QStringLiteral("text"));
        label->setTone(Tone::Warning);
        QWidget window;
        window.setPalette(dark());
        label->setParent(&window);
        QCOMPARE(label->palette().color(QPalette::WindowText), textColor(Tone::Warning, dark()));
    }
};

AXISCOMP_WINDOW_TEST(TestToneLabel)

} // namespace tst_tonelabel

#include "tst_tonelabel.moc"
