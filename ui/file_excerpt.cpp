// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/file_excerpt.h"

#include <QByteArray>
#include <QFile>
#include <QStringDecoder>

namespace axiscomp::ui {

namespace {

constexpr qint64 blockSize = 1 << 20;
constexpr qsizetype longestLine = 400;

QString textOf(const QByteArray& bytes)
{
    QStringDecoder utf8(QStringDecoder::Utf8);
    QString text = utf8.decode(bytes);
    return utf8.hasError() ? QString::fromLatin1(bytes) : text;
}

/// Takes the lines of a file one after the other, block by block.
class LineCollector {
public:
    LineCollector(std::size_t first, std::size_t last) : m_first(first), m_last(last) { }

    [[nodiscard]] bool isComplete() const { return m_line > m_last; }

    void take(const QByteArray& block)
    {
        for (const char character : block) {
            if (character == '\n' && m_wasReturn) {
                m_wasReturn = false;
                continue;
            }
            m_wasReturn = character == '\r';
            if (character == '\n' || m_wasReturn)
                endLine();
            else if (m_line >= m_first && m_text.size() < longestLine)
                m_text += character;
            if (isComplete())
                return;
        }
    }
    void endLine()
    {
        if (m_line >= m_first && !isComplete())
            m_lines += textOf(m_text);
        m_text.clear();
        ++m_line;
    }
    [[nodiscard]] bool hasUnendedLine() const { return !m_text.isEmpty(); }
    [[nodiscard]] const QStringList& lines() const { return m_lines; }

private:
    std::size_t m_first;
    std::size_t m_last;
    std::size_t m_line = 1;
    bool m_wasReturn = false;
    QByteArray m_text;
    QStringList m_lines;
};

} // namespace

FileExcerpt excerptOf(const QString& path, std::size_t line, std::size_t around)
{
    FileExcerpt excerpt;
    excerpt.firstLine = line > around ? line - around : 1;
    QFile file(path);
    if (line == 0 || !file.open(QIODevice::ReadOnly))
        return excerpt;
    LineCollector collector(excerpt.firstLine, line + around);
    while (!file.atEnd() && !collector.isComplete()) {
        const QByteArray block = file.read(blockSize);
        if (block.isEmpty())
            break;
        collector.take(block);
    }
    if (collector.hasUnendedLine())
        collector.endLine();
    excerpt.lines = collector.lines();
    return excerpt;
}

} // namespace axiscomp::ui
