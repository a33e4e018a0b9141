// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fine_quantity.h"
#include "core/metrology/report/report_content.h"
#include "core/metrology/report/report_html.h"
#include "tests/core/metrology/measurement_reading.h"
#include "tests/support/test_registry.h"

#include <QRegularExpression>

#include <cmath>

namespace tst_report {

using namespace axiscomp;

namespace {

QStringList lines(std::initializer_list<const char*> texts)
{
    QStringList list;
    for (const char* text : texts)
        list += QString::fromUtf8(text);
    return list;
}

Measurement publicRuns(const std::string& name)
{
    return test::readAs("runs", test::publicMeasurement(name)).measurement.value_or(Measurement{});
}

Text words(const char* text)
{
    return Verbatim{text};
}

ReportMeasurement measured(double scale)
{
    ReportMeasurement result;
    result.measurement = publicRuns("bifrost.csv");
    for (RunValue& value : result.measurement.values)
        value.deviation *= scale;
    MeasurementHeader& header = result.measurement.header;
    header.date = scale == 1.0 ? "2026-11-20" : "2026-11-21";
    header.operatorName = "A. Meter";
    header.instrument = "XL-80 12345";
    header.feed = "1000 mm/min";
    header.dwell = "3 s";
    header.airTemperature = 20.4;
    header.materialTemperature = 20.9;
    header.expansion = 11.5e-6;
    header.compensation.kind = scale == 1.0 ? MeasuredState::Kind::Off : MeasuredState::Kind::On;
    if (scale != 1.0)
        header.compensation.tableCrc = 0x0c291ca3;
    result.corrections = {words("dead path of 120 mm")};
    return result;
}

ReportContent wholeContent()
{
    ReportContent content;
    content.machine = "Mill 7";
    content.axis = "X";
    content.serial = "M-4711";
    content.drive = "Triamec-616";
    content.driveSerial = "9087";
    content.firmwareProfile = "generic";
    content.before = measured(1.0);
    content.before->measurement.values[3].isUsed = false;
    content.after = measured(0.1);
    content.prediction.emplace();
    content.prediction->figures[static_cast<std::size_t>(Iso230Figure::A)] = 0.0083537;
    content.prediction->heldOutM = 0.0177945;
    content.prediction->heldOutRms = 0.004321;
    content.prediction->heldOutLargest = 0.0098765;
    content.table.grid.axes = {{"X", "mm", 15.0, 10.2, 5}};
    content.table.method = words("smooth");
    content.table.crc = 0x0c291ca3;
    content.table.slot = "small3";
    content.table.isPersistent = true;
    content.table.proof = words("passed over 83 % of the table");
    content.sign = words("the drive will add +0.0021 mm");
    content.tolerances = {{Iso230Figure::A, 0.005}, {Iso230Figure::R, 0.0001}};
    content.uncertainty = 0.0011;
    content.notes = {words("after a change of the belt")};
    content.inputs = {
        {"before.csv", "runs", std::string(64, 'a')}, {"after.csv", "runs", std::string(64, 'b')}};
    content.programVersion = "9.8.7";
    return content;
}

QString htmlOf(const ReportContent& content, const ReportOptions& options = {})
{
    return QString::fromStdString(reportHtml(reportDocument(content, options)));
}

/// Text between tags, in order.
QStringList textsOf(const QString& html)
{
    static const QRegularExpression tag(QStringLiteral("<[^>]*>"));
    QString body = html.mid(html.indexOf(QStringLiteral("<body>")));
    QStringList texts;
    for (const QString& piece : body.split(tag))
        if (!piece.trimmed().isEmpty())
            texts += piece.trimmed();
    return texts;
}

QStringList rowOf(const QString& html, const QString& name)
{
    const qsizetype begin = html.indexOf(QStringLiteral("scope=\"row\">") + name + u'<');
    if (begin < 0)
        return {};
    return textsOf(QStringLiteral("<body>")
        + html.mid(begin - 4, html.indexOf(QStringLiteral("</tr>"), begin) - begin + 4));
}

struct Svg {
    QStringList lines; ///< the tags of its polylines
    QList<QPair<double, double>> ticks; ///< y in mm, and the number that stands there
    /// Deviation at a height, from the numbers at the axis alone.
    [[nodiscard]] double deviation(double y) const
    {
        const auto& a = ticks.first();
        const auto& b = ticks.last();
        return a.second + (y - a.first) / (b.first - a.first) * (b.second - a.second);
    }
};

Svg svgOf(const QString& html, int number)
{
    Svg svg;
    const QString text = html.section(QStringLiteral("<svg"), number + 1, number + 1)
                             .section(QStringLiteral("</svg>"), 0, 0);
    static const QRegularExpression line(QStringLiteral("<polyline[^>]*>"));
    for (auto match = line.globalMatch(text); match.hasNext();)
        svg.lines += match.next().captured();
    static const QRegularExpression label(
        QStringLiteral("<text x=\"[^\"]*\" y=\"([^\"]*)\" font-size=\"([^\"]*)\" "
                       "text-anchor=\"end\">([^<]*)</text>"));
    for (auto match = label.globalMatch(text); match.hasNext();) {
        const auto found = match.next();
        // The number stands around its tick: a little more than a third of its height below it.
        svg.ticks.append({found.captured(1).toDouble() - 0.35 * found.captured(2).toDouble(),
            found.captured(3).toDouble()});
    }
    return svg;
}

QList<double> heightsOf(const QString& line)
{
    QList<double> heights;
    const QString points = line.section(u'"', 1, 1);
    for (const QString& point : points.split(u' '))
        heights += point.section(u',', 1).toDouble();
    return heights;
}

} // namespace

class tst_Report : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everythingOnRecordIsOnThePage()
    {
        const QString text = textsOf(htmlOf(wholeContent())).join(u'\n');
        for (const char* fact : {"Mill 7", "M-4711", "Triamec-616", "9087", "generic", "2026-11-20",
                 "2026-11-21", "A. Meter", "XL-80 12345", "1000 mm/min, 3 s",
                 "air 20.4 °C, material 20.9 °C, expansion 11.5 µm/(m·K)", "off",
                 "on, table 0c291ca3", "dead path of 120 mm",
                 "5 targets from 15 to 55.8 mm, 5 runs ↑, 5 runs ↓",
                 "↑ target 1 run 4: not an evaluation by ISO 230-2", "nothing", "8.35", "17.79 µm",
                 "4.32 µm", "9.88 µm", "5 points from 15 to 55.8 mm", "smooth", "small3",
                 "persistent", "passed over 83 % of the table", "the drive will add +0.0021 mm",
                 "5.00 µm", "1.10 µm", "after a change of the belt", "before.csv", "after.csv"})
            QVERIFY2(text.contains(QString::fromUtf8(fact)), fact);
        QVERIFY(text.contains(QString(64, u'a')));
        QVERIFY(text.contains(QString(64, u'b')));
        QVERIFY(text.contains(QStringLiteral("9.8.7")));
    }

    void figuresAreThoseOfThePublicMeasurement()
    {
        ReportContent content = wholeContent();
        content.before->measurement.values[3].isUsed = true;
        const QString html = htmlOf(content);
        // metrology.md of the specification of ISO 230-2's figures, chapter of public measurements
        QCOMPARE(rowOf(html, QStringLiteral("accuracy A")),
            lines({"accuracy A", "18.57", "8.35", "–", "1.86"}));
        QCOMPARE(rowOf(html, QStringLiteral("repeatability R")),
            lines({"repeatability R", "8.35", "not defined", "–", "0.84"}));
        QCOMPARE(rowOf(html, QStringLiteral("range of the mean deviation M")),
            (lines({"range of the mean deviation M", "14.95", "not defined", "17.79", "1.50"})));
    }

    /// 3 inch are 76.19999999999999 mm in doubles.
    void targetsAreSaidWithoutTheRoundingOfDoubles()
    {
        ReportContent content = wholeContent();
        content.before->measurement.targets.back() = 3.0 * 25.4;
        const QString page = htmlOf(content, {.wantsLists = true});
        QVERIFY(page.contains(QStringLiteral("5 targets from 15 to 76.2 mm")));
        QVERIFY(!page.contains(QStringLiteral("76.19")));
    }

    void theTitleNamesTheAxisThatIsCorrected()
    {
        ReportContent content = wholeContent();
        content.axis = "X";
        content.corrected = "Y";
        QVERIFY(htmlOf(content).contains(
            QStringLiteral("Compensation of axis Y over axis X, machine ")));
    }

    void aMeanIsNoRun()
    {
        ReportContent content = wholeContent();
        content.after.reset();
        Measurement& means = content.before->measurement;
        std::erase_if(means.values, [](const RunValue& value) { return value.run > 1; });
        for (RunValue& value : means.values)
            value.isUsed = true;
        QString page = htmlOf(content);
        QCOMPARE(rowOf(page, QStringLiteral("Targets and runs")).at(1),
            QStringLiteral("5 targets from 15 to 55.8 mm, 1 run ↑, 1 run ↓"));
        QVERIFY(page.contains(QStringLiteral("single run")));
        means.kind = MeasurementKind::Averages;
        page = htmlOf(content);
        QCOMPARE(rowOf(page, QStringLiteral("Targets and runs")).at(1),
            QStringLiteral("5 targets from 15 to 55.8 mm, means ↑, means ↓"));
        QVERIFY(!page.contains(QStringLiteral("single run")));
        std::erase_if(
            means.values, [](const RunValue& value) { return value.direction == Approach::Down; });
        QCOMPARE(rowOf(htmlOf(content), QStringLiteral("Targets and runs")).at(1),
            QStringLiteral("5 targets from 15 to 55.8 mm, means ↑, no means ↓"));
    }

    void aWarningStandsBesideTheOutcome()
    {
        ReportContent content = wholeContent();
        content.warnings = {{"LesserRange", words("measured over less of the axis")}};
        const QStringList texts = textsOf(htmlOf(content));
        const auto warning =
            texts.indexOf(QStringLiteral("Warning: measured over less of the axis."));
        QVERIFY(warning > 0 && warning < texts.indexOf(QStringLiteral("Measurements")));
    }

    /// A value that fails the tolerance, and is left out.
    void figuresAndVerdictOfAllValuesStandBesideTheOthers()
    {
        ReportContent content = wholeContent();
        content.before->measurement.values[3].isUsed = true;
        QVERIFY(!htmlOf(content, {true}).contains(QStringLiteral("all values")));
        Measurement& after = content.after->measurement;
        after.values[7].deviation = 0.05;
        const Iso230Figures all = iso230Figures(after);
        after.values[7].isUsed = false;
        const auto shown = [](const Iso230Figures& figures) {
            return QString::number(1e3 * figures[Iso230Figure::A].value.value_or(0.0), 'f', 2);
        };
        const QString others = shown(iso230Figures(after));
        const QString html = htmlOf(content);
        QVERIFY(html.contains(QStringLiteral("Accuracy A of all values, with those that are left "
                                             "out: 18.57 µm before, %1 µm after.")
                                  .arg(shown(all))));
        QVERIFY(html.contains(QStringLiteral("<th scope=\"col\">before, all values</th>"
                                             "<th scope=\"col\">after, all values</th>")));
        QCOMPARE(rowOf(html, QStringLiteral("accuracy A")),
            (QStringList{QStringLiteral("accuracy A"), QStringLiteral("18.57"),
                QStringLiteral("8.35"), QStringLiteral("–"), others, QStringLiteral("18.57"),
                shown(all)}));
        const QString text = textsOf(html).join(u'|');
        QVERIFY2(
            text.contains(QStringLiteral("accuracy A|%1 µm|5.00 µm|1.10 µm|passed|%2 µm|failed")
                              .arg(others, shown(all))),
            qPrintable(text));
        QVERIFY(!html.contains(QStringLiteral("Targets after, all values")));
        QVERIFY(
            htmlOf(content, {true}).contains(QStringLiteral("Targets after, all values, in µm")));
    }

    /// To one scale: from 15 to 111.6 mm, of which the first one measured 15 to 55.8.
    void bothPlotsHaveTheSamePositions()
    {
        ReportContent content = wholeContent();
        for (double& target : content.after->measurement.targets)
            target *= 2.0;
        QCOMPARE(textsOf(htmlOf(content)).count(QStringLiteral("100")), qsizetype{2});
    }

    void temperaturesOfTheValuesAreToldByTheirRange()
    {
        ReportContent content = wholeContent();
        double celsius = 18.0;
        for (RunValue& value : content.before->measurement.values)
            value.temperature = celsius += 0.1;
        content.before->measurement.values.front().temperature = (64.5 - 32.0) / 1.8;
        for (RunValue& value : content.after->measurement.values)
            value.temperature = 21.5;
        content.after->measurement.header = {};
        QCOMPARE(rowOf(htmlOf(content), QStringLiteral("Environment")),
            (QStringList{QStringLiteral("Environment"),
                QStringLiteral("air 20.4 °C, material 20.9 °C, values measured at 18.06 to 23 °C, "
                               "expansion 11.5 µm/(m·K)"),
                QStringLiteral("air not stated, material not stated, values measured at 21.5 °C, "
                               "expansion not stated")}));
    }

    void aVerdictIsThatOfTheLastMeasurement()
    {
        const QString text = textsOf(htmlOf(wholeContent())).join(u'|');
        QVERIFY2(text.contains(QStringLiteral("accuracy A|1.86 µm|5.00 µm|1.10 µm|passed")),
            qPrintable(text));
        QVERIFY(text.contains(QStringLiteral("repeatability R|0.84 µm|0.10 µm|1.10 µm|undecided")));
    }

    void whatIsNotOnRecordIsNotStated()
    {
        const QString html = htmlOf({});
        for (const char* name :
            {"Machine", "Axis", "Serial number", "Drive", "Serial number of the drive",
                "Firmware profile", "Grid", "Method", "CRC-32", "Slot", "Persistency",
                "End-to-end proof", "Sign", "Tolerances", "Uncertainty U, k = 2"})
            QVERIFY2(html.contains(QStringLiteral("<dt>%1</dt><dd>not stated</dd>")
                                       .arg(QString::fromLatin1(name))),
                name);
        for (const char* name : {"Date", "Operator", "Instrument", "Feed, dwell", "Environment",
                 "Compensation", "Corrections", "Targets and runs", "Left out"})
            QCOMPARE(
                rowOf(html, QString::fromLatin1(name)), lines({name, "not stated", "not stated"}));
        QVERIFY(!html.contains(QStringLiteral("<dd></dd>")));
        QCOMPARE(rowOf(html, QStringLiteral("accuracy A")),
            lines({"accuracy A", "not stated", "not stated", "–", "not stated"}));
        const QString body = html.mid(html.indexOf(QStringLiteral("<tbody>")));
        QVERIFY(!body.contains(QStringLiteral("<td>0")));
    }

    void aFigureThatIsNotDefinedIsNeverZero()
    {
        ReportContent content = wholeContent();
        std::erase_if(content.before->measurement.values,
            [](const RunValue& value) { return value.direction == Approach::Down; });
        QCOMPARE(rowOf(htmlOf(content), QStringLiteral("accuracy A")).at(1),
            QStringLiteral("not defined"));
    }

    void aMeasurementAfterWithoutAccuracyIsOnRecordAllTheSame()
    {
        ReportContent content = wholeContent();
        std::erase_if(
            content.after->measurement.values, [](const RunValue& value) { return value.run > 1; });
        QString text = textsOf(htmlOf(content)).join(u'|');
        QVERIFY2(!text.contains(QStringLiteral("no measurement afterwards")), qPrintable(text));
        QVERIFY2(
            text.contains(QStringLiteral("µm before, not defined after.|E: ")), qPrintable(text));
        content.before = content.after;
        text = textsOf(htmlOf(content)).join(u'|');
        QVERIFY2(text.contains(QStringLiteral("The accuracy A is not defined, before or after.")),
            qPrintable(text));
        content = wholeContent();
        content.after.reset();
        QVERIFY(htmlOf(content).contains(QStringLiteral("There is no measurement afterwards")));
    }

    /// A up, and E up beside what was held out.
    void runsOfOneDirectionHaveItsFigures()
    {
        ReportContent content = wholeContent();
        content.before->measurement.values[3].isUsed = true;
        const auto takeUp = [](ReportMeasurement& reported) {
            std::erase_if(reported.measurement.values,
                [](const RunValue& value) { return value.direction == Approach::Down; });
        };
        takeUp(*content.after);
        QString html = htmlOf(content);
        QVERIFY(textsOf(html).join(u'|').contains(
            QStringLiteral("Accuracy A: 18.57 µm before, not defined after.|A↑: 18.07 µm before, "
                           "1.81 µm after.")));
        takeUp(*content.before);
        html = htmlOf(content);
        const QString text = textsOf(html).join(u'|');
        QVERIFY2(text.contains(QStringLiteral("Accuracy A↑: 18.07 µm before, 1.81 µm after.")),
            qPrintable(text));
        QVERIFY(!text.contains(QStringLiteral("The accuracy A is not defined")));
        QCOMPARE(rowOf(html, QStringLiteral("systematic deviation E, up")).at(3),
            QStringLiteral("17.79"));
        QCOMPARE(rowOf(html, QStringLiteral("range of the mean deviation M")).at(3),
            QStringLiteral("–"));
        QVERIFY(text.contains(QStringLiteral("was made without: E↑ 17.79 µm, rms")));
    }

    void allValuesOfOneDirectionHaveItsAccuracy()
    {
        ReportContent content = wholeContent();
        for (auto* reported : {&content.before, &content.after})
            std::erase_if((*reported)->measurement.values,
                [](const RunValue& value) { return value.direction == Approach::Down; });
        QString text = textsOf(htmlOf(content)).join(u'|');
        QVERIFY2(text.contains(QStringLiteral("Accuracy A↑ of all values, with those that are left "
                                              "out: 18.07 µm before, 1.81 µm after.")),
            qPrintable(text));
        content.after.reset();
        text = textsOf(htmlOf(content)).join(u'|');
        QVERIFY2(text.contains(QStringLiteral("Accuracy A↑ of all values, with those that are left "
                                              "out: 18.07 µm before.")),
            qPrintable(text));
    }

    void aVerdictThatIsMissedByLittleReadsSo()
    {
        ReportContent content = wholeContent();
        const auto figures = iso230Figures(content.after->measurement);
        const double accuracy = figures[Iso230Figure::A].value.value_or(0.0);
        content.tolerances = {{Iso230Figure::A, accuracy - 1e-7}};
        content.uncertainty.reset();
        const QString text = textsOf(htmlOf(content)).join(u'|');
        const auto shown = comparedDigits(accuracy, accuracy - 1e-7, false, 2);
        QVERIFY2(text.contains(
                     QStringLiteral("accuracy A|%1 µm|%2 µm|not stated|failed")
                         .arg(QString::fromStdString(shown.value.digits(accuracy, shown.decimals)),
                             QString::fromStdString(
                                 shown.limit.digits(accuracy - 1e-7, shown.decimals)))),
            qPrintable(text));
        QVERIFY(shown.decimals > 2);
    }

    /// 0.1 nm above it, with U.
    void aVerdictOfAllValuesThatUDecidesReadsSo()
    {
        ReportContent content = wholeContent();
        Measurement& after = content.after->measurement;
        after.values[7].deviation = 0.05;
        const double all = iso230Figures(after)[Iso230Figure::A].value.value_or(0.0);
        after.values[7].isUsed = false;
        const Verdict verdict{{Iso230Figure::A, all + 0.0011 - 1e-7}, all, 0.0011};
        content.tolerances = {verdict.tolerance};
        const auto shown = verdictDigits(verdict, false, 2);
        QVERIFY(shown.decimals > 2);
        const QString text = textsOf(htmlOf(content)).join(u'|');
        QVERIFY2(text.contains(
                     QStringLiteral("|%1 µm|undecided")
                         .arg(QString::fromStdString(shown.value.digits(all, shown.decimals)))),
            qPrintable(text));
    }

    void curvesShowTheMeans()
    {
        ReportContent content = wholeContent();
        content.before->measurement.values[3].isUsed = true;
        content.after.reset();
        const Svg svg = svgOf(htmlOf(content), 0);
        QVERIFY(svg.ticks.size() >= 3);
        const QList<double> means{2.25, 0.394, 2.084, -9.02, 6.032}; // of the five runs up, in um
        const double datum = 3.226; // the mean of both directions at the first target
        bool hasThem = false;
        for (const QString& line : svg.lines) {
            const QList<double> heights = heightsOf(line);
            bool isSame = heights.size() == means.size();
            for (qsizetype i = 0; isSame && i < means.size(); ++i)
                isSame = std::abs(svg.deviation(heights[i]) - (means[i] - datum)) < 0.02;
            hasThem = hasThem || isSame;
        }
        QVERIFY(hasThem);
    }

    void accuracyIsMarkedFromItsLowestToItsHighestPlace()
    {
        ReportContent content = wholeContent();
        content.before->measurement.values[3].isUsed = true;
        content.after.reset();
        const Svg svg = svgOf(htmlOf(content), 0);
        QList<double> spans;
        for (const QString& line : svg.lines) {
            const QList<double> heights = heightsOf(line);
            if (heights.size() == 2)
                spans += std::abs(svg.deviation(heights[1]) - svg.deviation(heights[0]));
        }
        for (const double figure : {18.5713, 15.988, 14.952, 4.564}) // A, E, M, B
            QVERIFY2(std::ranges::any_of(
                         spans, [&](double span) { return std::abs(span - figure) < 0.03; }),
                QByteArray::number(figure).constData());
    }

    void beforeAndAfterHaveOneScale()
    {
        const QString html = htmlOf(wholeContent());
        const Svg before = svgOf(html, 0);
        QVERIFY(before.ticks.size() >= 3);
        QCOMPARE(svgOf(html, 1).ticks, before.ticks);
    }

    /// A compensation that has done nothing looked like one that took 12.5 mm away.
    void theZeroOfTheInstrumentIsNotDrawn()
    {
        ReportContent content = wholeContent();
        const auto plots = [&content] {
            const QString html = htmlOf(content);
            return QStringList() << svgOf(html, 0).lines << svgOf(html, 1).lines;
        };
        const QStringList without = plots();
        QVERIFY(without.size() > 20);
        for (RunValue& value : content.after->measurement.values)
            value.deviation += 12.5;
        QCOMPARE(plots(), without);
        QCOMPARE(htmlOf(content).count(QStringLiteral("Deviation in µm, 0 = mean at 15 mm")), 2);
        content.before->datum = 45.6;
        const QString html = htmlOf(content, {true});
        QCOMPARE(html.count(QStringLiteral("Deviation in µm, 0 = mean at 45.6 mm")), 2);
        QVERIFY(html.contains(QStringLiteral("Targets after, in µm, 0 = mean at 45.6 mm")));
        QVERIFY(!html.contains(QStringLiteral("12500.")));
    }

    void allOfACurveIsWithinItsFrame()
    {
        const QString html = htmlOf(wholeContent());
        for (const int number : {0, 1}) {
            const Svg svg = svgOf(html, number);
            const auto frame = std::ranges::find_if(svg.lines, [](const QString& line) {
                const QList<double> heights = heightsOf(line);
                return heights.size() == 5 && heights.first() == heights.last();
            });
            QVERIFY(frame != svg.lines.end());
            const QList<double> limits = heightsOf(*frame);
            const auto [top, bottom] = std::ranges::minmax(limits);
            for (const QString& line : svg.lines) {
                const QList<double> heights = heightsOf(line);
                const bool isTick = heights.size() == 2 && heights.last() > bottom;
                QVERIFY2(isTick
                        || std::ranges::all_of(
                            heights, [&](double y) { return y >= top && y <= bottom; }),
                    qPrintable(line));
            }
        }
    }

    void nothingComesFromElsewhere()
    {
        const QString html = htmlOf(wholeContent(), {true});
        for (const char* reference : {"http", "src=", "href", "<script", "url(", "@import", "<link",
                 "<iframe", "javascript"})
            QVERIFY2(
                !html.contains(QString::fromLatin1(reference), Qt::CaseInsensitive), reference);
    }

    void markupInTextsIsText()
    {
        ReportContent content = wholeContent();
        content.machine = "<script>alert(\"1\")</script> & 'Co'";
        content.notes = {words("</p><b>bold")};
        const QString html = htmlOf(content);
        QVERIFY(!html.contains(QStringLiteral("<script>")));
        QVERIFY(!html.contains(QStringLiteral("<b>")));
        QVERIFY(html.contains(QStringLiteral(
            "&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt; &amp; &apos;Co&apos;")));
    }

    void anglesAreInArcSeconds()
    {
        ReportContent content = wholeContent();
        content.isAngular = true;
        for (auto* one : {&*content.before, &*content.after})
            one->measurement.isAngular = true;
        content.before->measurement.values[3].isUsed = true;
        const QString html = htmlOf(content);
        // 0.0185713 deg, the accuracy of the public measurement, were it one of angles
        QCOMPARE(rowOf(html, QStringLiteral("accuracy A")).at(1), QStringLiteral("66.86"));
        QVERIFY(html.contains(QStringLiteral("Figures of ISO 230-2:2014 in ″")));
        QVERIFY(html.contains(QStringLiteral("5 targets from 15 to 55.8 °")));
        QVERIFY(!html.contains(QStringLiteral(" mm, 5 runs")));
    }

    void longListsStayOffTheFirstPage()
    {
        ReportContent content = wholeContent();
        content.notes.assign(40, words("one of many"));
        content.inputs.assign(30, {"file.csv", "runs", std::string(64, 'c')});
        const QString html = htmlOf(content);
        QCOMPARE(html.count(QStringLiteral("one of many")), 3);
        QVERIFY(html.contains(QStringLiteral("and 37 more in the record")));
        QCOMPARE(html.count(QString(64, u'c')), 4);
        QVERIFY(html.contains(QStringLiteral("and 26 more in the record")));
        QVERIFY(!html.contains(QStringLiteral("class=\"page\"")));
        const QString whole = htmlOf(content, {true});
        QVERIFY(whole.contains(QStringLiteral("class=\"page\"")));
        QCOMPARE(whole.count(QStringLiteral("one of many")), 40);
    }

    void everyTextOfADocumentChangesWithItsLanguage()
    {
        Wording wording;
        wording.decimalSign = ',';
        wording.words = [](const TextPattern& pattern, std::optional<std::int64_t>) {
            const std::string text = pattern.words;
            return std::string(pattern.context) == "Report"
                    || std::string(pattern.context) == "Measurement"
                ? "~" + text
                : text;
        };
        const QString html = QString::fromStdString(
            reportHtml(worded(reportDocument(wholeContent(), {true}), wording, "de")));
        QVERIFY(html.contains(QStringLiteral("<html lang=\"de\">")));
        static const QRegularExpression english(
            QStringLiteral("[>\"](Machine|before|Sign|accuracy A|Position in mm|mean ↑)[<\"]"));
        QVERIFY2(!html.contains(english), qPrintable(english.match(html).captured()));
        static const QRegularExpression point(QStringLiteral("<td>-?[0-9]+\\.[0-9]"));
        QVERIFY2(!html.contains(point), qPrintable(point.match(html).captured()));
    }
};

AXISCOMP_TEST(tst_Report)

} // namespace tst_report

#include "tst_report.moc"
