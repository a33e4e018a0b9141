// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/data_file_field.h"

#include "ui/style/symbols.h"

#include <QBoxLayout>
#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>

namespace axiscomp::ui {

namespace {

constexpr int readingSteps = 1000;

} // namespace

DataFileField::DataFileField(QWidget* parent)
    : QWidget(parent)
    , m_stack(new QStackedWidget)
    , m_name(new QLineEdit)
    , m_progress(new QProgressBar)
    , m_open(new QPushButton)
    , m_cancel(new QPushButton)
    , m_more(new QToolButton)
    , m_menu(new QMenu(this))
{
    setObjectName(QStringLiteral("dataField"));
    m_name->setObjectName(QStringLiteral("dataFile"));
    m_name->setReadOnly(true);
    m_progress->setObjectName(QStringLiteral("dataProgress"));
    m_progress->setRange(0, readingSteps);
    m_progress->setMinimumWidth(
        m_progress->fontMetrics().horizontalAdvance(QStringLiteral("100 %")));
    m_open->setObjectName(QStringLiteral("openButton"));
    m_open->setIcon(symbolIcon(Symbol::Open));
    m_open->setAutoDefault(true);
    m_cancel->setObjectName(QStringLiteral("cancelReadingButton"));
    m_cancel->setAutoDefault(true);
    m_cancel->hide();
    m_more->setObjectName(QStringLiteral("recentButton"));
    m_more->setPopupMode(QToolButton::InstantPopup);
    m_more->setArrowType(Qt::DownArrow);
    m_more->setMenu(m_menu);
    m_menu->setObjectName(QStringLiteral("recentMenu"));
    m_menu->setToolTipsVisible(true);
    m_stack->addWidget(m_name);
    m_stack->addWidget(m_progress);
    m_stack->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_stack, 1);
    layout->addWidget(m_open);
    layout->addWidget(m_cancel);
    layout->addWidget(m_more);
    connect(m_open, &QPushButton::clicked, this, &DataFileField::openRequested);
    connect(m_cancel, &QPushButton::clicked, this, &DataFileField::cancelRequested);
    connect(m_menu, &QMenu::aboutToShow, this, &DataFileField::fillMenu);
    retranslate();
}

QWidget& DataFileField::nameField()
{
    return *m_name;
}

void DataFileField::showFile(const QString& path, bool isMade)
{
    m_path = path;
    m_isMade = isMade;
    m_stack->setCurrentWidget(m_name);
    m_name->setText(QFileInfo(path).fileName());
    m_name->setCursorPosition(0);
    m_name->setToolTip(path.isEmpty() ? tr("No file is open") : QDir::toNativeSeparators(path));
    m_open->setVisible(true);
    m_cancel->setVisible(false);
}

void DataFileField::showReading(double fraction)
{
    m_stack->setCurrentWidget(m_progress);
    m_progress->setValue(static_cast<int>(fraction * readingSteps));
    m_open->setVisible(false);
    m_cancel->setVisible(true);
}

void DataFileField::setOpenEnabled(bool isEnabled, const QString& reason)
{
    m_reason = reason;
    m_open->setEnabled(isEnabled);
    m_more->setEnabled(isEnabled);
    m_open->setToolTip(isEnabled || reason.isEmpty()
            ? tr("Open a file of compensation data, or drop it on the window (Ctrl+O)")
            : reason);
}

void DataFileField::setRecentFiles(const QStringList& paths)
{
    m_recent = paths;
}

void DataFileField::retranslate()
{
    m_name->setPlaceholderText(tr("no file"));
    m_name->setToolTip(m_path.isEmpty() ? tr("No file is open") : m_name->toolTip());
    m_name->setAccessibleName(tr("Open file"));
    m_name->setAccessibleDescription(tr("The name of the open file of compensation data"));
    m_progress->setAccessibleName(tr("Reading the file"));
    m_open->setText(tr("&Open…"));
    m_open->setAccessibleDescription(tr("Opens a file of compensation data"));
    m_cancel->setText(tr("St&op")); // where Open was
    m_cancel->setToolTip(tr("Stop reading the file"));
    m_more->setToolTip(tr("Recent files"));
    m_more->setAccessibleName(tr("Recent files"));
    setOpenEnabled(m_open->isEnabled(), m_reason);
}

void DataFileField::fillMenu()
{
    m_menu->clear();
    for (qsizetype i = 0; i < m_recent.size(); ++i) {
        const QString& path = m_recent[i];
        const QString name = QFileInfo(path).fileName();
        QAction* entry = m_menu->addAction(i < 9 ? QStringLiteral("&%1  %2").arg(i + 1).arg(
                                               QString(name).replace(u'&', QStringLiteral("&&")))
                                                 : name);
        entry->setToolTip(QDir::toNativeSeparators(path));
        connect(entry, &QAction::triggered, this, [this, path] { Q_EMIT fileChosen(path); });
    }
    if (m_recent.isEmpty())
        m_menu->addAction(tr("No recent files"))->setEnabled(false);
    m_menu->addSeparator();
    QAction* again = m_menu->addAction(symbolIcon(Symbol::Refresh), tr("&Read Again"));
    QAction* import = m_menu->addAction(symbolIcon(Symbol::Edit), tr("Import &Options…"));
    import->setObjectName(QStringLiteral("importOptionsAction"));
    import->setToolTip(tr("Format, sign and grid of the open file"));
    import->setEnabled(!m_path.isEmpty() && !m_isMade);
    connect(import, &QAction::triggered, this, &DataFileField::importOptionsRequested);
    QAction* close = m_menu->addAction(symbolIcon(Symbol::Close), tr("&Close File"));
    again->setObjectName(QStringLiteral("readAgainAction"));
    close->setObjectName(QStringLiteral("closeFileAction"));
    again->setEnabled(!m_path.isEmpty() && !m_isMade);
    close->setEnabled(!m_path.isEmpty());
    connect(again, &QAction::triggered, this, &DataFileField::readAgainRequested);
    connect(close, &QAction::triggered, this, &DataFileField::closeRequested);
}

} // namespace axiscomp::ui
