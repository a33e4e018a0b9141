// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/values_copy.h"

#include "ui/data/values_model.h"
#include "ui/text/value_text.h"

#include <algorithm>

namespace axiscomp::ui {

namespace {

class Copier {
public:
    Copier(const CompensationTable& drawn, const std::vector<CellRange>& ranges)
        : m_table(drawn)
        , m_ranges(ranges)
        , m_isMap(drawn.grid.dimensions() == 2)
    {
        for (const CellRange& range : ranges) {
            m_lastRow = std::max(m_lastRow, range.bottom);
            if (m_columns.size() <= static_cast<std::size_t>(range.right))
                m_columns.resize(static_cast<std::size_t>(range.right) + 1);
            std::fill(m_columns.begin() + range.left, m_columns.begin() + range.right + 1, true);
        }
    }

    QByteArray text(const CopyHeaders* headers)
    {
        m_hasHeaders = headers != nullptr;
        // Positions stand on the left anyway then.
        if (m_hasHeaders && !m_isMap && !m_columns.empty())
            m_columns[ValuesModel::Position] = false;
        if (headers)
            addHeaders(*headers);
        for (int row = 0; row <= m_lastRow; ++row)
            addRow(row);
        return m_text;
    }

private:
    void addHeaders(const CopyHeaders& headers)
    {
        m_text += (m_isMap ? headers.second + QStringLiteral(" \\ ") + headers.first
                           : headers.first + u'\t' + headers.second)
                      .toUtf8();
        for (std::size_t column = 0; m_isMap && column < m_columns.size(); ++column) {
            if (m_columns[column])
                m_text += '\t' + plainPosition(m_table.grid.axes[0], column);
        }
        m_text += '\n';
    }

    void addRow(int row)
    {
        m_inRow.clear();
        std::ranges::copy_if(m_ranges, std::back_inserter(m_inRow),
            [row](const CellRange& range) { return range.top <= row && row <= range.bottom; });
        if (m_inRow.empty())
            return;
        bool isFirst = !m_hasHeaders;
        if (m_hasHeaders)
            m_text += plainPosition(m_table.grid.axes[m_isMap ? 1 : 0], std::size_t(row));
        for (std::size_t column = 0; column < m_columns.size(); ++column) {
            if (!m_columns[column])
                continue;
            if (!isFirst)
                m_text += '\t';
            isFirst = false;
            const int at = static_cast<int>(column);
            if (std::ranges::any_of(m_inRow,
                    [at](const CellRange& range) { return range.left <= at && at <= range.right; }))
                m_text += cell(static_cast<std::size_t>(row), column);
        }
        m_text += '\n';
    }

    [[nodiscard]] QByteArray cell(std::size_t row, std::size_t column) const
    {
        if (m_isMap)
            return plainValue(m_table.values[row * m_table.grid.axes[0].size + column]);
        return column == ValuesModel::Position ? plainPosition(m_table.grid.axes[0], row)
                                               : plainValue(m_table.values[row]);
    }

    const CompensationTable& m_table;
    const std::vector<CellRange>& m_ranges;
    bool m_isMap;
    bool m_hasHeaders = false;
    int m_lastRow = -1;
    std::vector<bool> m_columns; ///< those of which a cell is chosen
    std::vector<CellRange> m_inRow;
    QByteArray m_text;
};

} // namespace

QString copiedText(const CompensationTable& drawn, const std::vector<CellRange>& ranges,
    const CopyHeaders* headers)
{
    return QString::fromUtf8(Copier(drawn, ranges).text(headers));
}

} // namespace axiscomp::ui
