// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_pdf.h"

#include "core/metrology/report/plot_ink.h"

#include <QBuffer>
#include <QFontDatabase>
#include <QFontMetricsF>
#include <QPainter>
#include <QPdfWriter>
#include <QTextLayout>

#include <algorithm>
#include <set>

namespace axiscomp::ui {

namespace {

// Lengths are hundredths of a millimetre, which are the dots of the writer: a font needs whole
// ones.
constexpr int dotsPerInch = 2540;
constexpr double perMillimetre = 100.0;
constexpr double marginMm = 15.0;
constexpr double pageWidth = (210.0 - 2.0 * marginMm) * perMillimetre;
constexpr double pageHeight = (297.0 - 2.0 * marginMm) * perMillimetre;
constexpr double columnGap = 200.0;
constexpr int bodyFont = 270; // 7.65 pt

QFont fontOf(int height, bool isBold = false)
{
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(height);
    font.setBold(isBold);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

QString shown(const Text& text)
{
    return QString::fromStdString(text.english());
}

QColor colour(std::string_view name)
{
    return QColor(QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())));
}

QPolygonF polygon(const std::vector<PlotPoint>& points)
{
    QPolygonF result;
    for (const PlotPoint& point : points)
        result << QPointF(point.x, point.y) * perMillimetre;
    return result;
}

/// A column of blocks, one below the other. Without a painter it is measured only.
class Column {
public:
    Column(QPainter* painter, double width) : m_painter(painter), m_width(width) { }

    [[nodiscard]] double height() const { return m_y; }
    /// A row of a table that would go beyond this height calls nextPage first.
    void breakPagesAt(double height, std::function<void()> nextPage)
    {
        m_lowest = height;
        m_nextPage = std::move(nextPage);
    }

    void title(const Text& text) { m_y += paragraph(text, fontOf(440, true)) + 60.0; }

    void operator()(const ReportHeading& heading)
    {
        const QFont font = fontOf(310, true);
        makeRoom(1200.0);
        m_y += 230.0;
        m_y += paragraph(heading.text, font);
        line(m_y + 10.0, QColor(0x80, 0x80, 0x80), 20.0);
        m_y += 70.0;
    }
    void operator()(const ReportParagraph& text)
    {
        const QFont font = text.isStrong ? fontOf(340, true) : fontOf(bodyFont);
        makeRoom(textHeight(shown(text.text), font, m_width));
        m_y += paragraph(text.text, font) + (text.isStrong ? 120.0 : 30.0);
    }
    void operator()(const ReportFacts& facts);
    void operator()(const ReportTable& table);
    void operator()(const ReportPlots& plots);
    void operator()(const ReportPageBreak& /*nothing*/) { }

private:
    void makeRoom(double height)
    {
        if (!m_nextPage || m_y + height <= m_lowest)
            return;
        m_nextPage();
        m_y = 0.0;
    }

    void line(double y, const QColor& ink, double width)
    {
        if (!m_painter)
            return;
        m_painter->setPen(QPen(ink, width));
        m_painter->drawLine(QLineF(0.0, y, m_width, y));
    }

    /// Draws into a box whose upper left corner is given; returns the height.
    double text(const QPointF& corner, double width, const QString& words, const QFont& font,
        Qt::Alignment alignment = Qt::AlignLeft, const QColor& ink = Qt::black);
    [[nodiscard]] static double textHeight(const QString& words, const QFont& font, double width)
    {
        return Column(nullptr, width).text({}, width, words, font);
    }
    double paragraph(const Text& words, const QFont& font)
    {
        return text({0.0, m_y}, m_width, shown(words), font);
    }

    void row(const std::vector<Text>& cells, const std::vector<double>& widths, bool hasNumbers,
        const QColor& ink);
    [[nodiscard]] std::vector<double> columnWidths(const ReportTable& table) const;
    void plot(const ReportPlot& plot, const QPointF& corner);
    void label(const PlotLabel& label);

    QPainter* m_painter;
    double m_width;
    double m_y = 0.0;
    double m_lowest = 0.0;
    std::function<void()> m_nextPage;
};

double Column::text(const QPointF& corner, double width, const QString& words, const QFont& font,
    Qt::Alignment alignment, const QColor& ink)
{
    QTextLayout layout(words, font);
    QTextOption option(alignment);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    double y = 0.0;
    layout.beginLayout();
    for (QTextLine next = layout.createLine(); next.isValid(); next = layout.createLine()) {
        next.setLineWidth(width);
        next.setPosition({0.0, y});
        y += next.height();
    }
    layout.endLayout();
    if (m_painter) {
        m_painter->setPen(ink);
        layout.draw(m_painter, corner);
    }
    return y;
}

void Column::operator()(const ReportFacts& facts)
{
    const QFont font = fontOf(bodyFont);
    const auto columns = static_cast<std::size_t>(std::max(1, facts.columns));
    const double width =
        (m_width - columnGap * static_cast<double>(columns - 1)) / static_cast<double>(columns);
    std::vector<double> nameWidths(columns, 0.0);
    for (std::size_t i = 0; i < facts.facts.size(); ++i) {
        double& widest = nameWidths[i % columns];
        widest = std::max(
            widest, QFontMetricsF(font).horizontalAdvance(shown(facts.facts[i].name)) + columnGap);
    }
    for (std::size_t first = 0; first < facts.facts.size(); first += columns) {
        double height = 0.0;
        for (std::size_t i = first; i < std::min(first + columns, facts.facts.size()); ++i) {
            const std::size_t column = i % columns;
            const double x = static_cast<double>(column) * (width + columnGap);
            const double nameWidth = nameWidths[column];
            text({x, m_y}, nameWidth, shown(facts.facts[i].name), font, Qt::AlignLeft,
                QColor(0x40, 0x40, 0x40));
            height = std::max(height,
                text({x + nameWidth, m_y}, width - nameWidth, shown(facts.facts[i].value), font));
        }
        m_y += height + 15.0;
    }
}

/// What every column needs, or, where that is more than there is, what the wide ones share.
std::vector<double> Column::columnWidths(const ReportTable& table) const
{
    const QFontMetricsF metrics(fontOf(bodyFont));
    std::vector<double> natural(table.header.size(), 0.0);
    const auto widen = [&](const std::vector<Text>& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i)
            natural[i] =
                std::max(natural[i], metrics.horizontalAdvance(shown(cells[i])) + columnGap);
    };
    widen(table.header);
    for (const std::vector<Text>& cells : table.rows)
        widen(cells);
    if (natural.empty())
        return natural;
    double rest = m_width;
    std::vector<double> widths(natural.size(), 0.0);
    std::vector<std::size_t> order(natural.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::ranges::sort(order, {}, [&](std::size_t i) { return natural[i]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const double share = rest / static_cast<double>(order.size() - i);
        widths[order[i]] = std::min(natural[order[i]], share);
        rest -= widths[order[i]];
    }
    // Columns of values stand evenly, whatever their headings need.
    for (double& width : widths)
        width += rest / static_cast<double>(widths.size());
    return widths;
}

void Column::row(const std::vector<Text>& cells, const std::vector<double>& widths, bool hasNumbers,
    const QColor& ink)
{
    const QFont font = fontOf(bodyFont);
    double height = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i)
        height = std::max(height, textHeight(shown(cells[i]), font, widths[i] - columnGap));
    makeRoom(height);
    double x = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const bool isRight = hasNumbers && i > 0;
        text({isRight ? x + columnGap : x, m_y}, widths[i] - columnGap, shown(cells[i]), font,
            isRight ? Qt::AlignRight : Qt::AlignLeft, ink);
        x += widths[i];
    }
    m_y += height + 8.0;
}

void Column::operator()(const ReportTable& table)
{
    const std::vector<double> widths = columnWidths(table);
    makeRoom(1500.0); // the header stays with its first rows
    row(table.header, widths, table.hasNumbers, QColor(0x40, 0x40, 0x40));
    line(m_y, QColor(0xb0, 0xb0, 0xb0), 12.0);
    m_y += 20.0;
    for (const std::vector<Text>& cells : table.rows)
        row(cells, widths, table.hasNumbers, Qt::black);
    m_y += 20.0;
}

void Column::operator()(const ReportPlots& plots)
{
    double width = 0.0;
    double height = 0.0;
    for (const ReportPlot& plot : plots.plots) {
        width += plot.width * perMillimetre;
        height = std::max(height, plot.height * perMillimetre);
    }
    makeRoom(height);
    const double gap = plots.plots.size() > 1
        ? std::max(0.0, (m_width - width) / static_cast<double>(plots.plots.size() - 1))
        : 0.0;
    double x = 0.0;
    for (const ReportPlot& each : plots.plots) {
        if (m_painter)
            plot(each, {x, m_y});
        x += each.width * perMillimetre + gap;
    }
    m_y += height;
}

void Column::plot(const ReportPlot& plot, const QPointF& corner)
{
    m_painter->save();
    m_painter->translate(corner);
    for (const PlotBand& band : plot.bands) {
        m_painter->setPen(Qt::NoPen);
        m_painter->setBrush(colour(report::bandColour(band.ink)));
        m_painter->drawPolygon(polygon(band.outline));
    }
    m_painter->setBrush(Qt::NoBrush);
    for (const PlotLine& line : plot.lines) {
        QPen pen(colour(report::inkColour(line.ink)), line.width * perMillimetre);
        pen.setCapStyle(Qt::FlatCap);
        QList<qreal> dashes; // in widths of the line
        for (const double length : line.dashes)
            dashes << length / line.width;
        if (!dashes.isEmpty())
            pen.setDashPattern(dashes);
        m_painter->setPen(pen);
        m_painter->drawPolyline(polygon(line.points));
    }
    for (const PlotMarker& marker : plot.markers) {
        const QColor ink = colour(report::inkColour(marker.ink));
        m_painter->setPen(QPen(ink, 20.0));
        m_painter->setBrush(marker.shape == PlotMarkerShape::TriangleUp ? ink : QColor(Qt::white));
        m_painter->drawPolygon(polygon(report::markerOutline(marker)));
    }
    for (const PlotLabel& each : plot.labels)
        label(each);
    m_painter->restore();
}

void Column::label(const PlotLabel& label)
{
    const QFont font = fontOf(qRound(label.size * perMillimetre));
    const QString words = shown(label.text);
    const double width = QFontMetricsF(font).horizontalAdvance(words);
    const double before = label.side == PlotLabel::Side::Left ? 0.0
        : label.side == PlotLabel::Side::Right                ? width
                                                              : width / 2.0;
    m_painter->save();
    m_painter->translate(QPointF(label.place.x, label.place.y) * perMillimetre);
    if (label.isVertical)
        m_painter->rotate(-90.0);
    m_painter->setFont(font);
    m_painter->setPen(Qt::black);
    m_painter->drawText(QPointF(-before, 0.0), words);
    m_painter->restore();
}

using Blocks = std::vector<ReportBlock>;

Blocks::const_iterator firstBreak(const Blocks& blocks)
{
    return std::ranges::find_if(blocks,
        [](const ReportBlock& block) { return std::holds_alternative<ReportPageBreak>(block); });
}

double firstPageHeight(const ReportDocument& document, double width)
{
    Column column(nullptr, width);
    column.title(document.title);
    for (auto block = document.blocks.begin(); block != firstBreak(document.blocks); ++block)
        std::visit(column, *block);
    return column.height();
}

void drawFirstPage(const ReportDocument& document, QPainter& painter)
{
    // A smaller page is also wider before it is made smaller, and its texts take fewer lines.
    double scale = 1.0;
    double height = firstPageHeight(document, pageWidth);
    for (int round = 0; round < 8 && scale * height > pageHeight; ++round) {
        scale = std::min(0.98 * scale, pageHeight / height);
        height = firstPageHeight(document, pageWidth / scale);
    }
    painter.save();
    painter.scale(scale, scale);
    Column column(&painter, pageWidth / scale);
    column.title(document.title);
    for (auto block = document.blocks.begin(); block != firstBreak(document.blocks); ++block)
        std::visit(column, *block);
    painter.restore();
}

/// Characters of a document that no font has, the first of them, each once.
QString missingCharacters(const ReportDocument& document)
{
    constexpr qsizetype most = 20;
    const QFontMetricsF metrics(fontOf(bodyFont)); // of all fonts that stand in for this one
    // The picture of a control character (U+2400 and following) says no more than a box.
    const auto isDrawn = [](char32_t c) {
        const QChar::Category category = QChar::category(c);
        return category != QChar::Other_Control && category != QChar::Other_Format
            && (c < 0x2400 || c > 0x2426);
    };
    QString missing;
    std::set<char32_t> known;
    for (const char32_t c : QString::fromStdString(wordsOf(document)).toStdU32String())
        if (missing.size() < most && isDrawn(c) && known.insert(c).second && !metrics.inFontUcs4(c))
            missing += QString::fromUcs4(&c, 1);
    return missing;
}

/// A page is made for archives, and nothing of it may be lost without a word.
Result<void> checkCharacters(const ReportDocument& document)
{
    const QString missing = missingCharacters(document);
    if (missing.isEmpty())
        return {};
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "no installed font has {characters}, so that empty boxes would stand in the PDF: "
                "install one that has them, such as fonts-noto-cjk for Chinese and Japanese, or "
                "write the report as HTML")
                .with("characters", Verbatim{missing.toStdString()})}});
}

/// Where no font has a character, an empty box stands for it.
Result<void> checkFonts(const std::string& language)
{
    if (QFontDatabase::families().isEmpty())
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "there is no font to draw a PDF with: install one, such as fonts-dejavu-core, "
                    "or write the report as HTML")}});
    const auto system = language == "ja" ? QFontDatabase::Japanese
        : language == "zh"               ? QFontDatabase::SimplifiedChinese
                                         : QFontDatabase::Any;
    if (system == QFontDatabase::Any || !QFontDatabase::families(system).isEmpty())
        return {};
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "there is no font with the characters of this language to draw a PDF with: install "
                "one, such as fonts-noto-cjk, or write the report as HTML")}});
}

} // namespace

Result<Bytes> reportPdf(const ReportDocument& document)
{
    AXISCOMP_CHECK(checkFonts(document.language));
    AXISCOMP_CHECK(checkCharacters(document));
    QByteArray pdf;
    QBuffer buffer(&pdf);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);
    writer.setResolution(dotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(
        QMarginsF(marginMm, marginMm, marginMm, marginMm), QPageLayout::Millimeter);
    writer.setTitle(shown(document.title));
    writer.setCreator(QStringLiteral("Axis Compensation Wizard"));
    QPainter painter(&writer);
    drawFirstPage(document, painter);
    if (const auto lists = firstBreak(document.blocks); lists != document.blocks.end()) {
        writer.newPage();
        Column column(&painter, pageWidth);
        column.breakPagesAt(pageHeight, [&writer] { writer.newPage(); });
        for (auto block = lists; block != document.blocks.end(); ++block)
            std::visit(column, *block);
    }
    painter.end();
    const auto bytes =
        asBytes(std::string_view(pdf.constData(), static_cast<std::size_t>(pdf.size())));
    return Bytes(bytes.begin(), bytes.end());
}

} // namespace axiscomp::ui
