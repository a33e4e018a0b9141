// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/file_lines_view.h"

#include "ui/async/background_job.h"
#include "ui/style/plain_label.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QToolButton>

#include <array>

namespace axiscomp::ui {

namespace {

/// Enough to see what goes on, little enough to be laid out at once.
constexpr std::size_t neighbours = 200;

QToolButton* button(const char* name)
{
    auto* made = new QToolButton;
    made->setObjectName(QLatin1StringView(name));
    made->setToolButtonStyle(Qt::ToolButtonTextOnly);
    made->setAutoRaise(true);
    made->setFocusPolicy(Qt::StrongFocus);
    return made;
}

} // namespace

FileLinesView::FileLinesView(QWidget* parent)
    : QWidget(parent)
    , m_model(new FileLinesModel(this))
    , m_title(new PlainLabel)
    , m_previous(button("previousProblem"))
    , m_next(button("nextProblem"))
    , m_close(button("closeFileLines"))
    , m_table(new QTableView)
    , m_range(new PlainLabel)
    , m_earlier(button("earlierLines"))
    , m_later(button("laterLines"))
{
    setObjectName(QStringLiteral("fileLinesView"));
    build();
    connect(m_previous, &QToolButton::clicked, this, [this] { Q_EMIT stepRequested(-1); });
    connect(m_next, &QToolButton::clicked, this, [this] { Q_EMIT stepRequested(1); });
    connect(m_close, &QToolButton::clicked, this, &FileLinesView::closeRequested);
    connect(m_earlier, &QToolButton::clicked, this, [this] { read(m_firstLine); });
    connect(m_later, &QToolButton::clicked, this,
        [this] { read(m_firstLine + static_cast<std::size_t>(m_model->rowCount()) - 1); });
    retranslate();
}

FileLinesView::~FileLinesView()
{
    m_stop.request_stop();
}

void FileLinesView::build()
{
    m_title->setObjectName(QStringLiteral("fileLinesTitle"));
    m_title->setWordWrap(true);
    m_title->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_table->setObjectName(QStringLiteral("fileLines"));
    m_table->setModel(m_model);
    m_table->setWordWrap(false);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 6);
    m_table->verticalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_range->setObjectName(QStringLiteral("fileLinesRange"));
    auto* tools = new QHBoxLayout;
    for (QToolButton* tool : {m_previous, m_next})
        tools->addWidget(tool);
    tools->addStretch(1);
    tools->addWidget(m_close);
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(m_range, 1);
    bottom->addWidget(m_earlier);
    bottom->addWidget(m_later);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addLayout(tools);
    layout->addWidget(m_title);
    layout->addWidget(m_table, 1);
    layout->addLayout(bottom);
}

void FileLinesView::showProblem(const QString& path, const ProblemPlace& place)
{
    m_path = path;
    m_place = place;
    showTitle();
    read(place.line);
}

void FileLinesView::read(std::size_t line)
{
    m_stop.request_stop();
    m_stop = {};
    m_isReading = true;
    showRange();
    const auto excerpt =
        inBackground<FileExcerpt>([path = m_path, line, stop = m_stop.get_token()] {
            return excerptOf(path, line, neighbours, stop);
        });
    whenDone(excerpt, this, [this, line, request = ++m_request](const FileExcerpt& found) {
        if (request == m_request)
            showExcerpt(found, line);
    });
}

void FileLinesView::showExcerpt(const FileExcerpt& excerpt, std::size_t line)
{
    m_isReading = false;
    m_firstLine = excerpt.firstLine;
    m_hasMore = excerpt.hasMore;
    m_model->setExcerpt(excerpt, m_place);
    for (int column = 0; column < m_model->columnCount(); ++column) {
        constexpr int widest = 320;
        m_table->setColumnWidth(column,
            std::min(widest,
                std::max(m_table->horizontalHeader()->sectionSizeHint(column) + 24,
                    m_table->horizontalHeader()->defaultSectionSize())));
    }
    QModelIndex place = m_model->placeIndex();
    if (line != m_place.line && line >= m_firstLine)
        place = m_model->index(static_cast<int>(line - m_firstLine), 0);
    if (place.isValid()) {
        m_table->setCurrentIndex(place);
        m_table->clearSelection();
        m_table->scrollTo(place, QAbstractItemView::PositionAtCenter);
    }
    showRange();
}

void FileLinesView::showTitle()
{
    const QString name = QFileInfo(m_path).fileName();
    QString place = m_place.line == 0 ? name
        : m_place.column == 0         ? tr("%1, line %2").arg(name, countText(m_place.line))
                                      : tr("%1, line %2, column %3")
                                    .arg(name, countText(m_place.line), countText(m_place.column));
    m_title->setText(place + QStringLiteral(": ") + m_place.sentence);
    m_table->setAccessibleDescription(m_title->text());
}

void FileLinesView::showRange()
{
    const auto count = static_cast<std::size_t>(m_model->rowCount());
    m_earlier->setVisible(!m_isReading && count > 0 && m_firstLine > 1);
    m_later->setVisible(!m_isReading && count > 0 && m_hasMore);
    if (m_isReading)
        m_range->setText(tr("Reading the file…"));
    else if (count == 0)
        m_range->setText(tr("These lines can no longer be read from the file."));
    else
        m_range->setText(
            tr("Lines %1 to %2").arg(countText(m_firstLine), countText(m_firstLine + count - 1)));
}

void FileLinesView::retranslate()
{
    const std::array<std::tuple<QToolButton*, QString, QString>, 5> tools{{
        {m_previous, tr("Previous problem"), tr("Show the lines at the previous problem")},
        {m_next, tr("Next problem"), tr("Show the lines at the next problem")},
        {m_close, tr("Table's values"), tr("Show the values of the selected table again")},
        {m_earlier, tr("Earlier lines"), tr("Show the lines before these")},
        {m_later, tr("Later lines"), tr("Show the lines after these")},
    }};
    for (const auto& [tool, text, tip] : tools) {
        tool->setText(text);
        tool->setToolTip(tip);
        tool->setAccessibleDescription(tip);
    }
    m_table->setAccessibleName(tr("The file's lines at the chosen problem"));
    showTitle();
    showRange();
}

} // namespace axiscomp::ui
