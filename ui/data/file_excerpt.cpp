// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/data/file_excerpt.h"

#include "core/csv/fields.h"

#include <QByteArray>
#include <QFile>

#include <algorithm>
#include <string_view>

namespace axiscomp::ui {

namespace {

constexpr qint64 blockSize = 1 << 20;
/// How far lines are looked for behind the one that is asked for.
constexpr qint64 reach = 8 * blockSize;
constexpr qsizetype longestLine = 1 << 16;
constexpr std::size_t mostFields = 256;
constexpr qsizetype longestField = 200;

std::string_view viewOf(const QByteArray& bytes)
{
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

QStringList fieldsOf(std::string_view line, char separator)
{
    QStringList fields;
    for (const std::string& field : csvFields(line, separator, mostFields)) {
        const QString text = QString::fromStdString(field);
        fields += text.size() > longestField ? text.left(longestField) + u'…' : text;
    }
    return fields;
}

/// The first line of the text that is neither a comment nor blank, as the parser finds it.
std::string_view headerLine(std::string_view text)
{
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = text.substr(0, end);
        if (!isCsvComment(line))
            return line;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return {};
}

/// Takes the lines of a file one after the other, block by block.
class LineCollector {
public:
    LineCollector(std::size_t first, std::size_t last) : m_first(first), m_last(last) { }

    [[nodiscard]] bool isComplete() const { return m_line > m_last; }
    [[nodiscard]] bool hasReached(std::size_t line) const { return m_line >= line; }

    /// How many bytes of the block were needed.
    qsizetype take(const QByteArray& block)
    {
        if (skip(block))
            return block.size();
        for (qsizetype i = 0; i < block.size(); ++i) {
            const char character = block[i];
            if (character == '\n' && m_wasReturn) {
                m_wasReturn = false;
                continue;
            }
            if (isComplete())
                return i;
            m_wasReturn = character == '\r';
            if (character == '\n' || m_wasReturn)
                endLine();
            else if (m_line >= m_first && m_text.size() < longestLine)
                m_text += character;
        }
        return block.size();
    }
    void end()
    {
        if (!m_text.isEmpty())
            endLine();
    }
    [[nodiscard]] const std::vector<QByteArray>& lines() const { return m_lines; }

private:
    /// Passes over a block before the first line by counting its line ends alone.
    bool skip(const QByteArray& block)
    {
        std::size_t ends = 0;
        bool wasReturn = m_wasReturn;
        for (const char character : block) {
            const bool isReturn = character == '\r';
            ends += static_cast<std::size_t>(isReturn || (character == '\n' && !wasReturn));
            wasReturn = isReturn;
        }
        if (m_line + ends >= m_first)
            return false;
        m_line += ends;
        m_wasReturn = wasReturn;
        return true;
    }
    void endLine()
    {
        if (m_line >= m_first && !isComplete())
            m_lines.push_back(m_text);
        m_text.clear();
        ++m_line;
    }

    std::size_t m_first;
    std::size_t m_last;
    std::size_t m_line = 1;
    bool m_wasReturn = false;
    QByteArray m_text;
    std::vector<QByteArray> m_lines;
};

} // namespace

FileExcerpt excerptOf(
    const QString& path, std::size_t line, std::size_t around, const std::stop_token& stop)
{
    line = std::max<std::size_t>(line, 1);
    FileExcerpt excerpt;
    excerpt.firstLine = line > around ? line - around : 1;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return excerpt;
    LineCollector collector(excerpt.firstLine, line + around);
    char separator = ',';
    qint64 left = reach;
    while (!file.atEnd() && !collector.isComplete() && left > 0 && !stop.stop_requested()) {
        const bool isFirst = file.pos() == 0;
        const QByteArray block = file.read(blockSize);
        if (block.isEmpty())
            break;
        if (isFirst) {
            const std::string_view header = headerLine(viewOf(block).substr(0, longestLine));
            separator = csvSeparator(header);
            excerpt.header = header.empty() ? QStringList() : fieldsOf(header, separator);
        }
        excerpt.hasMore = collector.take(block) < block.size();
        if (collector.hasReached(line))
            left -= block.size();
    }
    excerpt.hasMore = excerpt.hasMore || !file.atEnd();
    collector.end();
    for (const QByteArray& bytes : collector.lines())
        excerpt.lines.push_back(fieldsOf(viewOf(bytes), separator));
    return excerpt;
}

} // namespace axiscomp::ui
