// SPDX-License-Identifier: GPL-3.0-or-later
// A program of its own, with nothing but a window from which files can be dragged: drag-source X Y
// FILE... The window is 120 x 80 at X, Y. Says "ready" when it is there, and after a drag what has
// become of it.
#include <QApplication>
#include <QDrag>
#include <QMimeData>
#include <QMouseEvent>
#include <QTextStream>
#include <QUrl>
#include <QWidget>

#include <utility>

namespace {

void say(const char* text)
{
    QTextStream(stdout) << text << Qt::endl;
}

class Source final : public QWidget {
public:
    explicit Source(const QStringList& files)
    {
        for (const QString& file : files)
            m_urls += QUrl::fromLocalFile(file);
    }

protected:
    void mousePressEvent(QMouseEvent* event) override { m_pressed = event->position(); }
    void mouseMoveEvent(QMouseEvent* event) override
    {
        const QPointF way = event->position() - m_pressed;
        if (!event->buttons().testFlag(Qt::LeftButton)
            || way.manhattanLength() < QApplication::startDragDistance())
            return;
        auto* mimeData = new QMimeData;
        mimeData->setUrls(m_urls);
        auto* drag = new QDrag(this);
        drag->setMimeData(mimeData);
        say(drag->exec(Qt::CopyAction) == Qt::CopyAction ? "copied" : "not taken");
    }
    void paintEvent(QPaintEvent*) override
    {
        if (!std::exchange(m_isPainted, true))
            QMetaObject::invokeMethod(
                this, [] { say("ready"); }, Qt::QueuedConnection);
    }

private:
    QList<QUrl> m_urls;
    QPointF m_pressed;
    bool m_isPainted = false;
};

} // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments().mid(1);
    if (arguments.size() < 3)
        qFatal("usage: drag-source X Y FILE...");
    Source source(arguments.mid(2));
    source.setWindowFlag(Qt::FramelessWindowHint);
    source.setGeometry(arguments[0].toInt(), arguments[1].toInt(), 120, 80);
    source.show();
    return QApplication::exec();
}
