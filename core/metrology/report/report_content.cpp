// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/report/report_content.h"

#include "core/metrology/fine_quantity.h"
#include "core/metrology/fit/measurement_fit.h"
#include "core/metrology/joined_files.h"
#include "core/metrology/report/deviation_plot.h"
#include "core/metrology/report/report_text.h"
#include "core/metrology/run_selection.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace axiscomp {

namespace {

using namespace report;

constexpr double pageWidth = 180.0; // mm, A4 without its margins
constexpr std::size_t mostNotes = 3; // on the first page, as the rest of a list
constexpr std::size_t mostInputs = 4;
constexpr std::size_t mostExclusions = 6;
constexpr std::size_t mostTables = 4;
constexpr std::size_t mostStatements = 4; // of joined files, and of those with the same

/// A measurement as the page needs it.
struct Judged {
    const ReportMeasurement* reported = nullptr; ///< null: not on record
    Iso230Figures figures;
    std::optional<Iso230Figures> ofAllValues; ///< only where values are left out
    DeviationCurves curves;

    [[nodiscard]] const Iso230Figures& ofAll() const
    {
        return ofAllValues ? *ofAllValues : figures;
    }
};

Judged judged(const ReportContent& content, const std::optional<ReportMeasurement>& reported)
{
    Judged result;
    if (!reported)
        return result;
    result.reported = &*reported;
    if (reported->measurement.hasTargets()) {
        result.figures = figuresBy(content, reported->measurement);
        result.ofAllValues = figuresOfAllValues(content, reported->measurement);
    }
    return result;
}

class ReportWriter {
public:
    ReportWriter(const ReportContent& content, const ReportOptions& options)
        : m_content(content)
        , m_options(options)
        , m_before(judged(content, content.before))
        , m_after(judged(content, content.after))
    {
        placeCurves();
    }

    ReportDocument written()
    {
        m_document.title = title();
        addOutcome();
        addMachine();
        addMeasurements();
        addPlots();
        addFigures();
        addVerdicts();
        addTable();
        addNotes();
        addInputs(m_options.wantsLists ? 0 : mostInputs);
        if (m_options.wantsLists)
            addLists();
        return std::move(m_document);
    }

private:
    /// The zero of an instrument is arbitrary, and may be another one in each measurement.
    void placeCurves()
    {
        const auto side = [](const Judged& one) {
            return DatumSide{one.figures, one.reported ? one.reported->datum : std::nullopt};
        };
        const TwoDatums datums = deviationDatums(side(m_before), side(m_after));
        for (const auto& [one, datum] :
            {std::pair(&m_before, &datums.before), std::pair(&m_after, &datums.after)})
            if (hasPlot(*one))
                one->curves = deviationCurves(one->reported->measurement, one->figures, *datum);
    }

    [[nodiscard]] Text title() const
    {
        if (m_content.corrected.empty())
            return AXISCOMP_TEXT("Report", "Compensation of axis {axis}, machine {machine}")
                .with("axis", statedText(m_content.axis))
                .with("machine", statedText(m_content.machine));
        return AXISCOMP_TEXT(
            "Report", "Compensation of axis {target} over axis {axis}, machine {machine}")
            .with("target", Verbatim{m_content.corrected})
            .with("axis", statedText(m_content.axis))
            .with("machine", statedText(m_content.machine));
    }

    void heading(const TextPattern& text) { m_document.blocks.emplace_back(ReportHeading{text}); }
    void paragraph(Text text, bool isStrong = false)
    {
        m_document.blocks.emplace_back(ReportParagraph{std::move(text), isStrong});
    }

    [[nodiscard]] Text fine(const std::optional<double>& value) const
    {
        return value ? fineText(*value, m_content.isAngular)
                     : Text(AXISCOMP_TEXT("Report", "not defined"));
    }
    /// In a table whose heading says the unit.
    [[nodiscard]] static Text cell(const FineUnit& unit, const std::optional<double>& value)
    {
        return value ? quantityText(unit.digits(*value, figureDecimals), "")
                     : Text(AXISCOMP_TEXT("Report", "not defined"));
    }
    [[nodiscard]] static std::optional<double> valueOf(const Judged& one, Iso230Figure figure)
    {
        return one.reported ? one.figures[figure].value : std::nullopt;
    }
    /// A, or where all runs are of one direction that of it.
    [[nodiscard]] static Iso230Figure accuracyFigure(
        const Iso230Figures& before, const Iso230Figures& after)
    {
        for (const Iso230Figure figure : {Iso230Figure::A, Iso230Figure::AUp, Iso230Figure::ADown})
            if (before[figure].value || after[figure].value)
                return figure;
        return Iso230Figure::A;
    }

    /// The sentence that is read first.
    void addOutcome()
    {
        const Iso230Figure figure = accuracyFigure(m_before.figures, m_after.figures);
        const Text symbol = Verbatim{std::string(figureSymbol(figure))};
        const auto before = valueOf(m_before, figure);
        const auto after = valueOf(m_after, figure);
        if (m_after.reported && (before || after))
            paragraph(AXISCOMP_TEXT("Report", "Accuracy {figure}: {before} before, {after} after.")
                          .with("figure", symbol)
                          .with("before", fine(before))
                          .with("after", fine(after)),
                true);
        else if (m_after.reported)
            paragraph(
                AXISCOMP_TEXT("Report", "The accuracy A is not defined, before or after."), true);
        else if (before)
            paragraph(AXISCOMP_TEXT("Report",
                          "Accuracy {figure}: {before} before. There is no measurement afterwards "
                          "on record.")
                          .with("figure", symbol)
                          .with("before", fine(before)),
                true);
        else
            paragraph(AXISCOMP_TEXT("Report", "The accuracy A before is not defined."), true);
        if (m_after.reported && !(before && after))
            addDefinedOutcome();
        addOutcomeOfAllValues();
        for (const JudgeWarning& warning : m_content.warnings)
            paragraph(
                AXISCOMP_TEXT("Report", "Warning: {warning}.").with("warning", warning.text), true);
    }

    /// With one run alone A is not defined, and what is systematic still is; of runs in both
    /// directions beside those of one the figures of that are.
    void addDefinedOutcome()
    {
        for (const Iso230Figure figure : {Iso230Figure::E, Iso230Figure::M, Iso230Figure::AUp,
                 Iso230Figure::ADown, Iso230Figure::EUp, Iso230Figure::EDown}) {
            const auto before = valueOf(m_before, figure);
            const auto after = valueOf(m_after, figure);
            if (!before || !after)
                continue;
            paragraph(AXISCOMP_TEXT("Report", "{figure}: {before} before, {after} after.")
                          .with("figure", Verbatim{std::string(figureSymbol(figure))})
                          .with("before", fine(before))
                          .with("after", fine(after)),
                true);
            return;
        }
    }

    /// Who reads that sentence alone has to know that values were chosen.
    void addOutcomeOfAllValues()
    {
        const Iso230Figure figure = accuracyFigure(m_before.ofAll(), m_after.ofAll());
        const auto& before = m_before.ofAll()[figure].value;
        const auto& after = m_after.ofAll()[figure].value;
        if (!hasExcluded() || !(before || after))
            return;
        const Text symbol = Verbatim{std::string(figureSymbol(figure))};
        if (m_after.reported)
            paragraph(AXISCOMP_TEXT("Report",
                          "Accuracy {figure} of all values, with those that are left out: {before} "
                          "before, {after} after.")
                          .with("figure", symbol)
                          .with("before", fine(before))
                          .with("after", fine(after)),
                true);
        else
            paragraph(AXISCOMP_TEXT("Report",
                          "Accuracy {figure} of all values, with those that are left out: {before} "
                          "before.")
                          .with("figure", symbol)
                          .with("before", fine(before)),
                true);
    }

    [[nodiscard]] bool hasExcluded() const { return m_before.ofAllValues || m_after.ofAllValues; }

    void addMachine()
    {
        m_document.blocks.emplace_back(ReportFacts{
            {{AXISCOMP_TEXT("Report", "Machine"), statedText(m_content.machine)},
                {AXISCOMP_TEXT("Report", "Axis"), statedText(m_content.axis)},
                {AXISCOMP_TEXT("Report", "Serial number"), statedText(m_content.serial)},
                {AXISCOMP_TEXT("Report", "Drive"), statedText(m_content.drive)},
                {AXISCOMP_TEXT("Report", "Serial number of the drive"),
                    statedText(m_content.driveSerial)},
                {AXISCOMP_TEXT("Report", "Firmware profile"),
                    statedText(m_content.firmwareProfile)}},
            2});
    }

    /// A column for each measurement; absent ones say so in every row.
    void addMeasurements()
    {
        heading(AXISCOMP_TEXT("Report", "Measurements"));
        ReportTable table;
        table.header = {
            Text(), AXISCOMP_TEXT("Report", "before"), AXISCOMP_TEXT("Report", "after")};
        const auto row = [&](const TextPattern& name, auto text) {
            std::vector<Text> cells{name};
            for (const Judged* one : {&m_before, &m_after})
                cells.push_back(one->reported ? text(*one->reported) : notStated());
            table.rows.push_back(std::move(cells));
        };
        using Header = MeasurementHeader;
        row(AXISCOMP_TEXT("Report", "Date"),
            [&](const ReportMeasurement& one) { return saidText(one, &Header::date); });
        row(AXISCOMP_TEXT("Report", "Operator"),
            [&](const ReportMeasurement& one) { return saidText(one, &Header::operatorName); });
        row(AXISCOMP_TEXT("Report", "Instrument"),
            [&](const ReportMeasurement& one) { return saidText(one, &Header::instrument); });
        row(AXISCOMP_TEXT("Report", "Feed, dwell"), [&](const ReportMeasurement& one) {
            return listText({saidText(one, &Header::feed), saidText(one, &Header::dwell)});
        });
        row(AXISCOMP_TEXT("Report", "Environment"),
            [&](const ReportMeasurement& one) { return environmentText(one); });
        row(AXISCOMP_TEXT("Report", "Compensation"),
            [&](const ReportMeasurement& one) { return stateText(one); });
        row(AXISCOMP_TEXT("Report", "Corrections"),
            [&](const ReportMeasurement& one) { return correctionsText(one); });
        row(AXISCOMP_TEXT("Report", "Targets and runs"),
            [&](const ReportMeasurement& one) { return extentText(one.measurement); });
        row(AXISCOMP_TEXT("Report", "Left out"),
            [&](const ReportMeasurement& one) { return exclusionsText(one.measurement); });
        m_document.blocks.emplace_back(std::move(table));
    }

    /// Of a list that may be long.
    template <typename Item>
    [[nodiscard]] static Text shortListText(const std::vector<Item>& items, auto textOf)
    {
        std::vector<Text> list;
        for (std::size_t i = 0; i < std::min(items.size(), mostStatements); ++i)
            list.push_back(textOf(items[i]));
        if (items.size() > mostStatements)
            list.push_back(AXISCOMP_COUNTED(
                "Report", "and {count} more in the record", "and 1 more in the record")
                               .with("count", items.size() - mostStatements));
        return listText(std::move(list));
    }

    /// "M1 (a.csv), M2 (b.csv)": nobody is to take the statement of one file for that of all.
    template <typename Statement>
    [[nodiscard]] static Text byFilesText(
        const ReportMeasurement& one, const std::vector<SaidByFiles<Statement>>& said, auto textOf)
    {
        return shortListText(said, [&](const SaidByFiles<Statement>& each) -> Text {
            return AXISCOMP_TEXT("Report", "{said} ({files})")
                .with("said", textOf(each.said))
                .with("files", shortListText(each.files, [&](std::size_t file) {
                    return statedText(file < one.files.size() ? one.files[file] : std::string());
                }));
        });
    }

    [[nodiscard]] static Text saidText(
        const ReportMeasurement& one, std::string MeasurementHeader::*text)
    {
        const auto said = saidByFiles(one.measurement, text);
        return areDifferent(said) ? byFilesText(one, said, statedText)
                                  : statedText(one.measurement.header.*text);
    }
    /// factor: from what a header has to the unit that is shown.
    [[nodiscard]] static Text saidText(const ReportMeasurement& one,
        std::optional<double> MeasurementHeader::*number, double factor, const char* unit)
    {
        const auto textOf = [&](const std::optional<double>& value) {
            return value ? quantityText(roundedText(*value * factor), unit) : notStated();
        };
        const auto said = saidByFiles(one.measurement, number);
        return areDifferent(said) ? byFilesText(one, said, textOf)
                                  : textOf(one.measurement.header.*number);
    }

    [[nodiscard]] static Text environmentText(const ReportMeasurement& one)
    {
        using Header = MeasurementHeader;
        const auto values = temperaturesOfValues(one.measurement);
        Text text = values ? AXISCOMP_TEXT("Report",
                        "air {air}, material {material}, values measured at {values}, expansion "
                        "{expansion}")
                                 .with("values", rangeText(*values))
                           : Text(AXISCOMP_TEXT(
                               "Report", "air {air}, material {material}, expansion {expansion}"));
        return std::move(text)
            .with("air", saidText(one, &Header::airTemperature, 1.0, "°C"))
            .with("material", saidText(one, &Header::materialTemperature, 1.0, "°C"))
            .with("expansion", saidText(one, &Header::expansion, 1e6, "µm/(m·K)"));
    }

    [[nodiscard]] static Text rangeText(const TemperatureRange& range)
    {
        // A degree Fahrenheit or a kelvin is seldom one of whole tenths.
        const auto digits = [](double celsius) {
            return roundedText(std::round(celsius * 100.0) / 100.0);
        };
        if (digits(range.lowest) == digits(range.highest))
            return quantityText(digits(range.lowest), "°C");
        return AXISCOMP_TEXT("Report", "{from} to {to}")
            .with("from", quantityText(digits(range.lowest), ""))
            .with("to", quantityText(digits(range.highest), "°C"));
    }

    /// By the file, which a person may have completed.
    [[nodiscard]] static Text stateText(const ReportMeasurement& one)
    {
        const MeasuredState& state = one.measurement.header.compensation;
        if (state.kind == MeasuredState::Kind::Off)
            return AXISCOMP_TEXT("Report", "off");
        if (state.tableCrc)
            return AXISCOMP_TEXT("Report", "on, table {crc}").with("crc", crcText(*state.tableCrc));
        if (one.statedTable)
            return AXISCOMP_TEXT("Report", "on, table {crc}, as stated with the measurement")
                .with("crc", crcText(*one.statedTable));
        if (state.kind == MeasuredState::Kind::On)
            return AXISCOMP_TEXT("Report", "on, which table is not stated");
        return notStated();
    }

    [[nodiscard]] static Text correctionsText(const ReportMeasurement& one)
    {
        if (!one.corrections.empty())
            return listText(one.corrections);
        switch (one.measurement.header.corrected) {
        case MeasurementHeader::Corrected::To20Celsius:
            return AXISCOMP_TEXT("Report", "to 20 °C by the instrument");
        case MeasurementHeader::Corrected::None:
            return AXISCOMP_TEXT("Report", "none");
        case MeasurementHeader::Corrected::NotSaid:
            break;
        }
        return one.areCorrectionsKnown
            ? Text(AXISCOMP_TEXT("Report", "none here, by the instrument not stated"))
            : notStated();
    }

    [[nodiscard]] Text extentText(const Measurement& measurement) const
    {
        if (!measurement.hasTargets() || measurement.targets.empty())
            return AXISCOMP_TEXT("Report", "no targets: {kind}")
                .with("kind", measurementKindText(measurement.kind));
        return listText(
            {AXISCOMP_COUNTED(
                 "Report", "{count} targets from {from} to {to}", "1 target from {from} to {to}")
                    .with("count", measurement.targets.size())
                    .with("from", quantityText(roundedText(measurement.targets.front()), ""))
                    .with("to",
                        quantityText(roundedText(measurement.targets.back()),
                            positionSymbol(m_content.isAngular))),
                passesText(measurement, Approach::Up), passesText(measurement, Approach::Down)});
    }

    /// Of how many runs a mean is, no file says.
    [[nodiscard]] static Text passesText(const Measurement& measurement, Approach direction)
    {
        const int count = measurement.runCount(direction);
        const char* const arrow = direction == Approach::Up ? "↑" : "↓";
        if (measurement.kind != MeasurementKind::Averages)
            return AXISCOMP_COUNTED("Report", "{count} runs {direction}", "1 run {direction}")
                .with("count", count)
                .with("direction", Verbatim{arrow});
        return (count > 0 ? AXISCOMP_TEXT("Report", "means {direction}")
                          : AXISCOMP_TEXT("Report", "no means {direction}"))
            .with("direction", Verbatim{arrow});
    }

    [[nodiscard]] static std::vector<Text> exclusions(const Measurement& measurement)
    {
        std::vector<Text> list;
        for (const RunValue& value : measurement.values)
            if (!value.isUsed)
                list.push_back(
                    AXISCOMP_TEXT("Report", "{direction} target {target} run {run}")
                        .with("direction", Verbatim{value.direction == Approach::Up ? "↑" : "↓"})
                        .with("target", value.target + 1)
                        .with("run", value.run));
        return list;
    }

    [[nodiscard]] static Text exclusionsText(const Measurement& measurement)
    {
        std::vector<Text> list = exclusions(measurement);
        const std::size_t count = list.size();
        if (count == 0)
            return AXISCOMP_TEXT("Report", "nothing");
        if (count > mostExclusions)
            return AXISCOMP_TEXT("Report", "{count} values: not an evaluation by ISO 230-2")
                .with("count", count);
        return AXISCOMP_TEXT("Report", "{values}: not an evaluation by ISO 230-2")
            .with("values", std::move(list));
    }

    [[nodiscard]] static bool hasPlot(const Judged& one)
    {
        return one.reported && !one.figures.targets.empty();
    }

    void addPlots()
    {
        const bool hasBoth = hasPlot(m_before) && hasPlot(m_after);
        if (!hasPlot(m_before) && !hasPlot(m_after))
            return;
        std::optional<PlotRange> range;
        for (const Judged* one : {&m_before, &m_after}) {
            if (!hasPlot(*one))
                continue;
            const PlotRange own = plotRange(one->reported->measurement, one->curves);
            range = range ? united(*range, own) : own;
        }
        if (hasBoth)
            heading(
                AXISCOMP_TEXT("Report", "Deviation over position: before, after, to one scale"));
        else if (hasPlot(m_before))
            heading(AXISCOMP_TEXT("Report", "Deviation over position, before"));
        else
            heading(AXISCOMP_TEXT("Report", "Deviation over position, after"));
        constexpr double gap = 2.0;
        const PlotSize size{hasBoth ? (pageWidth - gap) / 2.0 : pageWidth, 62.0};
        ReportPlots plots;
        for (const Judged* one : {&m_before, &m_after})
            if (hasPlot(*one))
                plots.plots.push_back(
                    deviationPlot(one->reported->measurement, one->curves, *range, size));
        m_document.blocks.emplace_back(std::move(plots));
        const bool haveRuns =
            std::ranges::any_of(std::array{&m_before, &m_after}, [](const Judged* one) {
                return hasPlot(*one) && hasPlottedRuns(one->reported->measurement);
            });
        m_document.blocks.emplace_back(ReportPlots{{deviationLegend(pageWidth, haveRuns)}});
    }

    void addFigures()
    {
        const FineUnit unit = unitOfFigures();
        m_document.blocks.emplace_back(
            ReportHeading{AXISCOMP_TEXT("Report", "Figures of ISO 230-2:2014 in {unit}")
                              .with("unit", Verbatim{unit.symbol})});
        ReportTable table;
        table.hasNumbers = true;
        table.header = {Text(), AXISCOMP_TEXT("Report", "before"),
            AXISCOMP_TEXT("Report", "predicted"), AXISCOMP_TEXT("Report", "held out"),
            AXISCOMP_TEXT("Report", "after")};
        if (hasExcluded())
            table.header.insert(table.header.end(),
                {AXISCOMP_TEXT("Report", "before, all values"),
                    AXISCOMP_TEXT("Report", "after, all values")});
        for (const Iso230Figure figure : shownIso230Figures()) {
            const auto measured = [&](const Judged& one, const Iso230Figures& figures) {
                return one.reported ? cell(unit, figures[figure].value) : notStated();
            };
            auto& row = table.rows.emplace_back(std::vector<Text>{figureText(figure),
                measured(m_before, m_before.figures), predictedCell(unit, figure),
                heldOutCell(unit, figure), measured(m_after, m_after.figures)});
            if (hasExcluded())
                for (const Judged* one : {&m_before, &m_after})
                    row.push_back(measured(*one, one->ofAll()));
        }
        m_document.blocks.emplace_back(std::move(table));
        if (m_content.isByTemperature)
            paragraph(AXISCOMP_TEXT("Report",
                "Each figure is the largest of a thermal state and of all runs together."));
        if (const auto& prediction = m_content.prediction; prediction && prediction->heldOutM)
            paragraph(AXISCOMP_TEXT("Report",
                "Held out: what is left at targets that the table was made without: {figure} "
                "{range}, rms {rms}, largest {largest}. Of the two predictions this is the one to "
                "believe.")
                          .with("figure", Verbatim{std::string(figureSymbol(heldOutFigure()))})
                          .with("range", fine(prediction->heldOutM))
                          .with("rms", fine(prediction->heldOutRms))
                          .with("largest", fine(prediction->heldOutLargest)));
    }

    /// Of all figures, which are read side by side.
    [[nodiscard]] FineUnit unitOfFigures() const
    {
        std::vector<std::optional<double>> shown;
        for (const Iso230Figure figure : allIso230Figures()) {
            for (const Judged* one : {&m_before, &m_after})
                if (one->reported)
                    shown.insert(
                        shown.end(), {one->figures[figure].value, one->ofAll()[figure].value});
            if (const auto& prediction = m_content.prediction)
                shown.push_back(prediction->figures[static_cast<std::size_t>(figure)]);
        }
        if (const auto& prediction = m_content.prediction)
            shown.push_back(prediction->heldOutM);
        return fineUnit(shown, m_content.isAngular);
    }

    [[nodiscard]] Text predictedCell(const FineUnit& unit, Iso230Figure figure) const
    {
        const auto& prediction = m_content.prediction;
        return prediction ? cell(unit, prediction->figures[static_cast<std::size_t>(figure)])
                          : notStated();
    }
    [[nodiscard]] Iso230Figure heldOutFigure() const
    {
        return figureStandingFor(Iso230Figure::M, m_before.figures);
    }
    [[nodiscard]] Text heldOutCell(const FineUnit& unit, Iso230Figure figure) const
    {
        const auto& prediction = m_content.prediction;
        if (figure != heldOutFigure())
            return Verbatim{"–"}; // there is but one figure held out
        return prediction ? cell(unit, prediction->heldOutM) : notStated();
    }

    void addVerdicts()
    {
        const bool isAfter = m_after.reported != nullptr;
        heading(isAfter ? AXISCOMP_TEXT("Report", "Verdict on the measurement after")
                        : AXISCOMP_TEXT("Report", "Verdict on the measurement before"));
        if (m_content.tolerances.empty()) {
            m_document.blocks.emplace_back(ReportFacts{
                {{AXISCOMP_TEXT("Report", "Tolerances"), notStated()},
                    {AXISCOMP_TEXT("Report", "Uncertainty U, k = 2"),
                        m_content.uncertainty ? fine(m_content.uncertainty) : notStated()}},
                2});
            return;
        }
        ReportTable table;
        table.hasNumbers = true;
        table.header = {Text(), AXISCOMP_TEXT("Report", "value"),
            AXISCOMP_TEXT("Report", "tolerance"), AXISCOMP_TEXT("Report", "uncertainty U, k = 2"),
            AXISCOMP_TEXT("Report", "verdict")};
        const Iso230Figures& figures = isAfter ? m_after.figures : m_before.figures;
        for (const Verdict& verdict :
            verdicts(figures, m_content.tolerances, m_content.uncertainty)) {
            const auto shown = verdictDigits(verdict, m_content.isAngular, figureDecimals);
            const auto text = [&shown](const FineUnit& unit, double value) {
                return quantityText(unit.digits(value, shown.decimals), unit.symbol);
            };
            table.rows.push_back({figureText(verdict.tolerance.figure), verdictValue(verdict),
                text(shown.limit, verdict.tolerance.value),
                verdict.uncertainty ? text(shown.uncertainty, *verdict.uncertainty) : notStated(),
                verdictText(verdict.result)});
        }
        addVerdictsOfAllValues(table, isAfter ? m_after : m_before);
        m_document.blocks.emplace_back(std::move(table));
    }

    [[nodiscard]] Text verdictValue(const Verdict& verdict) const
    {
        if (!verdict.value)
            return fine(verdict.value);
        const auto shown = verdictDigits(verdict, m_content.isAngular, figureDecimals);
        return quantityText(shown.value.digits(*verdict.value, shown.decimals), shown.value.symbol);
    }

    /// Beside those of the values in use.
    void addVerdictsOfAllValues(ReportTable& table, const Judged& judged) const
    {
        if (!judged.ofAllValues)
            return;
        table.header.insert(table.header.end(),
            {AXISCOMP_TEXT("Report", "all values"),
                AXISCOMP_TEXT("Report", "verdict, all values")});
        const auto ofAll =
            verdicts(*judged.ofAllValues, m_content.tolerances, m_content.uncertainty);
        for (std::size_t n = 0; n < ofAll.size(); ++n)
            table.rows[n].insert(
                table.rows[n].end(), {verdictValue(ofAll[n]), verdictText(ofAll[n].result)});
    }

    void addTable()
    {
        const ReportedTable& table = m_content.table;
        heading(AXISCOMP_TEXT("Report", "Table"));
        m_document.blocks.emplace_back(
            ReportFacts{{{AXISCOMP_TEXT("Report", "Grid"), gridText()},
                            {AXISCOMP_TEXT("Report", "Method"),
                                table.method.isEmpty() ? notStated() : table.method},
                            {AXISCOMP_TEXT("Report", "CRC-32"), tableCrcText()},
                            {AXISCOMP_TEXT("Report", "Slot"), statedText(table.slot)},
                            {AXISCOMP_TEXT("Report", "Persistency"), persistencyText()},
                            {AXISCOMP_TEXT("Report", "End-to-end proof"),
                                table.proof.isEmpty() ? notStated() : table.proof}},
                2});
        if (!table.columns.empty())
            m_document.blocks.emplace_back(
                ReportFacts{{{AXISCOMP_TEXT("Report", "Tables"), columnsText()}}});
        m_document.blocks.emplace_back(ReportFacts{{{AXISCOMP_TEXT("Report", "Sign"),
            m_content.sign.isEmpty() ? notStated() : m_content.sign}}});
    }

    [[nodiscard]] Text tableCrcText() const
    {
        if (m_content.table.crc)
            return crcText(*m_content.table.crc);
        return m_content.table.columns.empty()
            ? notStated()
            : Text(AXISCOMP_TEXT("Report", "that of each table, below"));
    }

    /// Each goes to an axis of its own.
    [[nodiscard]] Text columnsText() const
    {
        std::vector<Text> list;
        const auto& columns = m_content.table.columns;
        for (std::size_t i = 0; i < std::min(columns.size(), mostTables); ++i)
            list.push_back(AXISCOMP_TEXT("Report", "{name} for axis {axis}, CRC-32 {crc}")
                               .with("name", statedText(columns[i].name))
                               .with("axis", statedText(columns[i].target))
                               .with("crc", crcText(columns[i].crc)));
        if (columns.size() > mostTables)
            list.push_back(AXISCOMP_COUNTED(
                "Report", "and {count} more in the record", "and 1 more in the record")
                               .with("count", columns.size() - mostTables));
        return listText(std::move(list));
    }

    [[nodiscard]] Text gridText() const
    {
        std::vector<Text> axes;
        for (const GridAxis& axis : m_content.table.grid.axes)
            axes.push_back(AXISCOMP_TEXT("Report", "{count} points from {from} to {to}")
                               .with("count", axis.size)
                               .with("from", quantityText(roundedText(axis.start), ""))
                               .with("to",
                                   quantityText(roundedText(axis.last()),
                                       axis.unit.empty() || axis.unit == "deg"
                                           ? positionSymbol(m_content.isAngular)
                                           : axis.unit.c_str())));
        return axes.empty() ? notStated() : listText(std::move(axes));
    }

    [[nodiscard]] Text persistencyText() const
    {
        const auto& isPersistent = m_content.table.isPersistent;
        if (!isPersistent)
            return notStated();
        return *isPersistent ? AXISCOMP_TEXT("Report", "persistent")
                             : AXISCOMP_TEXT("Report", "volatile");
    }

    [[nodiscard]] static Text crcText(std::uint32_t crc)
    {
        std::string digits(8, '0');
        std::array<char, 8> buffer{};
        const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), crc, 16);
        const auto length = static_cast<std::size_t>(end.ptr - buffer.data());
        std::copy(buffer.data(), end.ptr, digits.begin() + static_cast<std::int64_t>(8 - length));
        return Verbatim{digits};
    }

    void addNotes()
    {
        heading(AXISCOMP_TEXT("Report", "Notes"));
        const auto& notes = m_content.notes;
        if (notes.empty())
            paragraph(AXISCOMP_TEXT("Report", "none on record"));
        const std::size_t count =
            m_options.wantsLists ? notes.size() : std::min(notes.size(), mostNotes);
        for (std::size_t i = 0; i < count; ++i)
            paragraph(notes[i]);
        if (count < notes.size())
            paragraph(AXISCOMP_COUNTED(
                "Report", "and {count} more in the record", "and 1 more in the record")
                          .with("count", notes.size() - count));
    }

    /// most: 0 for all of them.
    void addInputs(std::size_t most)
    {
        heading(AXISCOMP_TEXT("Report", "Input files"));
        const auto& inputs = m_content.inputs;
        const std::size_t count = most == 0 ? inputs.size() : std::min(inputs.size(), most);
        if (inputs.empty())
            paragraph(notStated());
        ReportTable table;
        table.header = {AXISCOMP_TEXT("Report", "file"), AXISCOMP_TEXT("Report", "format"),
            Verbatim{"SHA-256"}};
        for (std::size_t i = 0; i < count; ++i)
            table.rows.push_back({statedText(inputs[i].file), statedText(inputs[i].format),
                statedText(inputs[i].sha256)});
        if (!inputs.empty())
            m_document.blocks.emplace_back(std::move(table));
        if (count < inputs.size())
            paragraph(AXISCOMP_COUNTED(
                "Report", "and {count} more in the record", "and 1 more in the record")
                          .with("count", inputs.size() - count));
        paragraph(AXISCOMP_TEXT("Report",
            "Made by Axis Compensation Wizard {version}. Figures that the values do not define are "
            "not defined; what is not on record is not stated.")
                      .with("version", statedText(m_content.programVersion)));
    }

    void addLists()
    {
        m_document.blocks.emplace_back(ReportPageBreak{});
        if (hasPlot(m_before))
            addTargets(AXISCOMP_TEXT("Report", "Targets before, in {unit}"),
                AXISCOMP_TEXT("Report", "Targets before, all values, in {unit}"), m_before);
        if (hasPlot(m_after))
            addTargets(AXISCOMP_TEXT("Report", "Targets after, in {unit}"),
                AXISCOMP_TEXT("Report", "Targets after, all values, in {unit}"), m_after);
    }

    void addTargets(const TextPattern& name, const TextPattern& nameOfAll, const Judged& one)
    {
        addTargets(name, one.figures, one.curves.datum);
        if (auto list = exclusions(one.reported->measurement); !list.empty())
            paragraph(
                AXISCOMP_TEXT("Report", "Left out: {values}").with("values", std::move(list)));
        if (one.ofAllValues)
            addTargets(nameOfAll, *one.ofAllValues, one.curves.datum);
    }

    void addTargets(const TextPattern& name, const Iso230Figures& measured,
        const std::optional<PlacedDeviation>& datum)
    {
        const Iso230Figures figures = fromDatum(measured, datum);
        const FineUnit unit = fineUnit(valuesOfTargets(figures), m_content.isAngular);
        m_document.blocks.emplace_back(
            ReportHeading{name.with("unit", deviationUnitText(unit, datum, m_content.isAngular))});
        ReportTable table;
        table.hasNumbers = true;
        table.header = {AXISCOMP_TEXT("Report", "target in {unit}")
                            .with("unit", Verbatim{positionSymbol(m_content.isAngular)}),
            AXISCOMP_TEXT("Report", "values ↑"), AXISCOMP_TEXT("Report", "mean ↑"),
            AXISCOMP_TEXT("Report", "s ↑"), AXISCOMP_TEXT("Report", "values ↓"),
            AXISCOMP_TEXT("Report", "mean ↓"), AXISCOMP_TEXT("Report", "s ↓"), Verbatim{"B"},
            Verbatim{"R"}};
        for (const TargetFigures& target : figures.targets)
            table.rows.push_back({quantityText(roundedText(target.position), ""),
                numberText(static_cast<double>(target.up.n), 0), cell(unit, target.up.mean),
                cell(unit, target.up.s), numberText(static_cast<double>(target.down.n), 0),
                cell(unit, target.down.mean), cell(unit, target.down.s),
                cell(unit, target.reversal), cell(unit, target.repeatability)});
        m_document.blocks.emplace_back(std::move(table));
    }

    const ReportContent& m_content;
    const ReportOptions& m_options;
    Judged m_before;
    Judged m_after;
    ReportDocument m_document;
};

} // namespace

Iso230Figures figuresBy(const ReportContent& content, const Measurement& measurement)
{
    return figuresOfFit(measurement, content.isByTemperature);
}

std::optional<Iso230Figures> figuresOfAllValues(
    const ReportContent& content, const Measurement& measurement)
{
    if (measurement.excludedCount() == 0)
        return std::nullopt;
    return figuresBy(content, withAllValues(measurement));
}

ReportDocument reportDocument(const ReportContent& content, const ReportOptions& options)
{
    return ReportWriter(content, options).written();
}

} // namespace axiscomp
