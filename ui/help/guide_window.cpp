// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/guide_window.h"

#include <QAbstractTextDocumentLayout>
#include <QBoxLayout>
#include <QDesktopServices>
#include <QEvent>
#include <QFile>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>

namespace axiscomp::ui {

namespace {

const QLatin1StringView guideFolder(":/axiscomp/guide/");
constexpr QSize guideSize(720, 640);

/// Pictures as wide as there is room.
class GuideBrowser final : public QTextBrowser {
protected:
    QVariant loadResource(int type, const QUrl& name) override
    {
        if (type != QTextDocument::ImageResource)
            return {};
        const QImage picture(guideFolder + name.path());
        const int room = guideSize.width() - 60;
        return picture.width() > room ? picture.scaledToWidth(room, Qt::SmoothTransformation)
                                      : picture;
    }
};

QString guideText()
{
    QFile file(guideFolder + QStringLiteral("user-guide.md"));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

bool isHeading(const QTextBlock& block)
{
    return block.blockFormat().headingLevel() > 0;
}

/// The heading, or the first cell with that text below it; the beginning when there is neither.
QTextBlock blockOf(const QTextDocument& document, const GuidePlace& place)
{
    QTextBlock heading;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (!heading.isValid()) {
            if (isHeading(block) && block.text() == place.heading)
                heading = block;
            continue;
        }
        if (place.cell.isEmpty() || isHeading(block))
            break;
        if (block.text() == place.cell && QTextCursor(block).currentTable())
            return block;
    }
    return heading.isValid() ? heading : document.begin();
}

} // namespace

GuideWindow::GuideWindow(QWidget* parent) : QDialog(parent), m_text(new GuideBrowser)
{
    setObjectName(QStringLiteral("guideWindow"));
    setModal(false);
    m_text->setObjectName(QStringLiteral("guideText"));
    m_text->setOpenLinks(false);
    m_text->setMarkdown(guideText());
    connect(m_text, &QTextBrowser::anchorClicked, this, &GuideWindow::follow);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_text);
    resize(guideSize);
    retranslate();
}

void GuideWindow::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void GuideWindow::retranslate()
{
    setWindowTitle(tr("User Guide"));
    m_text->setAccessibleName(tr("User guide"));
}

/// The other documents are not part of the program: they are beside the guide where it is
/// installed.
void GuideWindow::follow(const QUrl& link)
{
    if (!link.isRelative())
        QDesktopServices::openUrl(link);
}

void GuideWindow::showPlace(const GuidePlace& place)
{
    show();
    raise();
    activateWindow();
    const QTextBlock block = blockOf(*m_text->document(), place);
    QTextCursor cursor(block);
    m_text->setTextCursor(cursor);
    scrollTo(block);
}

void GuideWindow::scrollTo(const QTextBlock& block)
{
    const auto top = m_text->document()->documentLayout()->blockBoundingRect(block).top();
    m_text->verticalScrollBar()->setValue(block.position() == 0 ? 0 : qRound(top) - 4);
}

QString GuideWindow::textAtTop() const
{
    return m_text->textCursor().block().text();
}

} // namespace axiscomp::ui
