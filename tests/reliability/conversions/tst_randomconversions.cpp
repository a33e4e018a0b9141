// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random tables from one format to another, checked by a page of Python that shares no code with
// this program: check_conversions.py. AXISCOMP_CONVERSIONS says how many; AXISCOMP_CONVERSION_SEED
// makes others.
#include "core/conversion/conversion.h"
#include "core/formats/formats.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <nlohmann/json.hpp>

#include <array>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace tst_randomconversions {

using namespace axiscomp;
using nlohmann::json;

namespace {

/// What one conversion is about, before there are any numbers.
struct Case {
    const TableFormat* from = nullptr;
    const TableFormat* to = nullptr;
    std::size_t dimensions = 1;
    std::optional<std::size_t> own; ///< the source that is corrected; none: another axis
    bool isRotary = false; ///< over a full turn
    bool hasDirections = false;
    std::optional<DirectionChoice> choice;
};

class Cases {
public:
    explicit Cases(unsigned seed) : m_random(seed) { }

    /// Nothing: these formats have no such table in common.
    [[nodiscard]] std::optional<Case> next();
    [[nodiscard]] NeutralTable table(const Case& chosen);
    /// With which a format is written, and with which it is read.
    struct Settings {
        FormatSettings writing;
        FormatSettings reading;
    };
    [[nodiscard]] Settings settings(const Case& chosen, const TableFormat& format);

private:
    template <typename List> auto& oneOf(List& list)
    {
        return list[std::uniform_int_distribution<std::size_t>(0, std::size(list) - 1)(m_random)];
    }
    [[nodiscard]] bool maybe(double share) { return std::bernoulli_distribution(share)(m_random); }
    [[nodiscard]] SourceAxis axis(const Case& chosen, double distance);

    std::mt19937 m_random;
};

bool isPmac(const TableFormat& format)
{
    return format.facts.name.starts_with("pmac");
}

/// Its corrections are 0 at the reference position, which is 0 here.
bool isFanuc(const TableFormat& format)
{
    return &format == &fanuc::format();
}

/// Its axes are X, Y and Z, whatever a table calls them.
bool isKmotionGeo(const TableFormat& format)
{
    return &format == &kmotion_geo::format();
}

bool isOwnOnly(const TableFormat& format)
{
    for (const std::string_view name : {"acs-1d", "aerotech-1d", "siemens-eec", "isg-ssfk", "icube",
             "fanuc", "kmotion-linear", "linuxcnc", "twincat-nc", "weihong"})
        if (format.facts.name == name)
            return true;
    return false;
}

std::optional<Case> Cases::next()
{
    static const std::array<const TableFormat*, 23> formats{&calibration_csv::format(),
        &acs_1d::format(), &acs_2d::format(), &aerotech_1d::format(), &aerotech_2d::format(),
        &siemens_eec::format(), &siemens_cec::format(), &isg_ssfk::format(),
        &isg_crosscomp::format(), &isg_crosscomp2::format(), &softmc::format(), &icube::format(),
        &linuxcnc::format(), &rapidcode::format(), &pmac_1d::format(), &weihong::format(),
        &heidenhain_com::format(), &heidenhain_com_530::format(), &kmotion_geo::format(),
        &kmotion_linear::format(), &power_pmac::format(), &twincat_nc::format(), &fanuc::format()};
    Case chosen;
    chosen.from = oneOf(formats);
    chosen.to = oneOf(formats);
    const FormatFacts& a = chosen.from->facts;
    const FormatFacts& b = chosen.to->facts;
    const int fewest = std::max(a.fewestDimensions, b.fewestDimensions);
    const int most = std::min(a.mostDimensions, b.mostDimensions);
    if (chosen.from == chosen.to || fewest > most)
        return std::nullopt;
    chosen.dimensions =
        static_cast<std::size_t>(std::uniform_int_distribution(fewest, most)(m_random));
    const bool mustOwn = isOwnOnly(*chosen.from) || isOwnOnly(*chosen.to);
    if (mustOwn || maybe(0.7))
        chosen.own = std::uniform_int_distribution<std::size_t>(0, chosen.dimensions - 1)(m_random);
    chosen.isRotary = chosen.dimensions == 1 && chosen.own && a.holdsWrap && maybe(0.4);
    chosen.hasDirections = a.holdsDirections && maybe(0.5);
    constexpr std::array choices{
        DirectionChoice::Positive, DirectionChoice::Negative, DirectionChoice::Mean};
    if (chosen.hasDirections && !b.holdsDirections)
        chosen.choice = oneOf(choices);
    return chosen;
}

SourceAxis Cases::axis(const Case& chosen, double distance)
{
    SourceAxis axis;
    axis.unit = chosen.isRotary ? "deg" : "mm";
    const bool isPmacCase = isPmac(*chosen.from) || isPmac(*chosen.to);
    const auto count = std::uniform_int_distribution<int>(3, 9)(m_random);
    double start = 0.5 * std::uniform_int_distribution<int>(-80, 80)(m_random);
    const bool isFanucCase = isFanuc(*chosen.from) || isFanuc(*chosen.to);
    if (isPmacCase)
        start = 0.0;
    else if (isFanucCase)
        start = -distance * std::uniform_int_distribution<int>(0, count - 1)(m_random);
    if (chosen.isRotary) {
        constexpr std::array cells{4, 5, 6, 8, 9};
        const int turn = oneOf(cells);
        axis.wrap = 360.0;
        for (int i = 0; i <= turn; ++i)
            axis.knots.push_back((isPmacCase || isFanucCase ? 0.0 : -180.0) + i * (360.0 / turn));
        return axis;
    }
    const bool isUneven = chosen.from->facts.knots == KnotRule::Any
        && chosen.to->facts.knots == KnotRule::Any && maybe(0.5);
    for (int i = 0; i < count; ++i) {
        axis.knots.push_back(start);
        start +=
            isUneven ? distance * std::uniform_int_distribution<int>(1, 4)(m_random) : distance;
    }
    return axis;
}

NeutralTable Cases::table(const Case& chosen)
{
    NeutralTable table;
    table.sign = chosen.from->facts.sign;
    constexpr std::array distances{0.25, 0.5, 1.0, 2.5, 10.0};
    const double distance = oneOf(distances);
    for (std::size_t n = 0; n < chosen.dimensions; ++n) {
        table.axes.push_back(axis(chosen, distance));
        table.axes[n].name = std::to_string(n + 1);
    }
    const std::string unit = table.axes[0].unit;
    constexpr std::array<const char*, 4> lengths{"mm", "um", "nm", "inch"};
    constexpr std::array<const char*, 3> angles{"deg", "mdeg", "arcsec"};
    const std::string valueUnit = chosen.isRotary ? oneOf(angles) : oneOf(lengths);
    const double factor = unitFactor(unit, valueUnit).value_or(1.0);
    const double largest = maybe(0.2) ? 0.2 * distance : 0.003;
    std::uniform_real_distribution value(-largest, largest);
    for (const Direction direction : {Direction::Positive, Direction::Negative}) {
        CompensationColumn& column = table.columns.emplace_back();
        const char* const other = isKmotionGeo(*chosen.from) ? "other" : "9";
        column.target = chosen.own ? table.axes[*chosen.own].name : other;
        column.unit = valueUnit;
        column.direction = chosen.hasDirections ? direction : Direction::Both;
        for (std::size_t i = 0; i < table.pointCount(); ++i)
            column.values.push_back(factor * std::round(value(m_random) * 1e7) / 1e7);
        if (isPmac(*chosen.from) || isPmac(*chosen.to))
            column.values.front() = 0.0;
        for (std::size_t i = 0; i < table.pointCount(); ++i)
            if ((isFanuc(*chosen.from) || isFanuc(*chosen.to)) && table.axes[0].knots[i] == 0.0)
                column.values[i] = 0.0;
        if (table.axes[0].wrap)
            column.values.back() = column.values.front();
        if (!chosen.hasDirections)
            break;
    }
    return table;
}

Cases::Settings Cases::settings(const Case& chosen, const TableFormat& format)
{
    const std::string_view name = format.facts.name;
    constexpr std::array<const char*, 4> lengths{"mm", "um", "m", "inch"};
    const std::string target = chosen.own ? std::to_string(*chosen.own + 1) : "9";
    const std::string position = chosen.isRotary ? "deg" : oneOf(lengths);
    const std::string value = chosen.isRotary ? "arcsec" : oneOf(lengths);
    const std::string kind = chosen.isRotary ? "rotary" : "linear";
    if (name == "acs-1d")
        return {{{"axis", "0"}, {"position-unit", position},
                    {"form", maybe(0.5) ? "errormap" : "connect"},
                    {"declare", maybe(0.5) ? "yes" : "no"}},
            {{"position-unit", position}}};
    if (name == "weihong")
        return {{{"axis", "X"}}, {}};
    if (name.starts_with("heidenhain")) {
        FormatSettings writing{{"axis", chosen.isRotary ? "C" : "X"}, {"target-axis", "Z"}};
        if (name == "heidenhain-com-530")
            writing["any-distance"] = "yes";
        return {writing, {}};
    }
    // An axis has one unit, for its positions and for what is added to them.
    const FormatSettings units{
        {"position-unit", position}, {"value-unit", chosen.own ? position : value}};
    if (name == "acs-2d") {
        FormatSettings writing = units;
        writing.insert({{"source-axis-1", "1"}, {"source-axis-2", "2"}, {"target-axis", target}});
        return {writing, units};
    }
    if (name == "aerotech-1d")
        return {{{"axis", "1"}},
            chosen.isRotary ? FormatSettings{{"rotary-axes", "1"}} : FormatSettings{}};
    if (name == "aerotech-2d")
        return {{{"column-axis", "1"}, {"row-axis", "2"}, {"output-axis-1", target}}, {}};
    if (name == "siemens-eec")
        return {{{"axis", "X1"}}, {}};
    if (name == "siemens-cec")
        return {{{"input-axis", "X1"}, {"output-axis", chosen.own ? "X1" : "Z1"}}, {}};
    if (name == "isg-ssfk")
        return {{{"axis", "1"}}, {{"axis-kind", kind}}};
    if (name == "isg-crosscomp")
        return {{{"axis", target}, {"master-axis", "1"}},
            {{"axis-kind", kind}, {"master-kind", kind},
                {"modulo", chosen.isRotary ? "yes" : "no"}}};
    if (name == "isg-crosscomp2")
        return {{{"axis", target}, {"master1-axis", "1"}, {"master2-axis", "2"}},
            {{"axis-kind", kind}, {"master1-kind", kind}, {"master2-kind", kind}}};
    if (name == "softmc")
        return {units, units};
    if (name == "kmotion-geo") {
        const FormatSettings both{{"unit", maybe(0.5) ? "inch" : "mm"}};
        return {both, both};
    }
    if (name == "icube" || name == "linuxcnc" || name == "kmotion-linear" || name == "twincat-nc") {
        FormatSettings both{{"position-unit", position}};
        if (name == "linuxcnc")
            both["type"] = maybe(0.5) ? "1" : "0";
        else if (chosen.isRotary && name == "icube")
            both["wrap-range"] = "360";
        return {both, both};
    }
    if (isFanuc(format)) {
        const FormatSettings both{{"reference-number", "100"}, {"detection-unit", "0.0001"},
            {"magnification", maybe(0.5) ? "1" : "3"}, {"reference-position", "0"},
            {"position-unit", chosen.isRotary ? "deg" : "mm"}};
        FormatSettings writing = both;
        writing["largest-step"] = "1000000";
        return {writing, both};
    }
    if (name == "rapidcode")
        return {{{"counts-per-unit", maybe(0.5) ? "20000" : "-4096"}, {"position-unit", position},
                    {"value-unit", position}},
            {}};
    if (isPmac(format) || &format == &power_pmac::format()) {
        const std::string unit = chosen.isRotary ? "deg" : "mm";
        const FormatSettings both{
            {"counts-per-unit", "10000"}, {"position-unit", unit}, {"value-unit", unit}};
        FormatSettings writing = both;
        writing.insert({{"source-motor", "1"}, {"target-motor", target}});
        return {writing, both};
    }
    return {};
}

/// What parameters of the control say beside a file of Fanuc.
void addInterval(const TableFormat& format, const NeutralTable& held, FormatSettings& reading)
{
    if (!isFanuc(format))
        return;
    const SourceAxis& axis = held.axes.front();
    const auto cells = static_cast<double>(axis.knots.size() - 1);
    reading["interval"] = toText((axis.knots.back() - axis.knots.front()) / cells);
    if (axis.wrap)
        reading["wrap-range"] = toText(*axis.wrap);
}

/// Reads the table of the source's bytes, converts it, and says for the checker what both files
/// are; nothing: one of the formats cannot hold it, which is an error and not silently wrong.
std::optional<json> converted(Cases& cases, const Case& chosen, bool keepsSign)
{
    auto from = cases.settings(chosen, *chosen.from);
    const auto to = cases.settings(chosen, *chosen.to);
    TableWriteOptions writing;
    writing.settings = from.writing;
    const std::vector original{cases.table(chosen)};
    const auto source = chosen.from->write(original, writing);
    if (!source)
        return std::nullopt;
    addInterval(*chosen.from, source->held.front(), from.reading);
    TableReadOptions reading;
    reading.dimensions = static_cast<int>(chosen.dimensions);
    reading.settings = from.reading;
    const auto read = chosen.from->read(source->bytes, reading);
    if (!read || read->hasErrors() || read->tables.empty())
        return json{{"refused", "what was written cannot be read"}};

    ConversionRequest request;
    request.from = chosen.from;
    request.to = chosen.to;
    request.targets = {chosen.own ? sourceTarget(*chosen.own) : std::string(otherAxis)};
    request.direction = chosen.choice;
    request.dropsWrap = read->tables.front().axes[0].wrap && !chosen.to->facts.holdsWrap;
    request.writing.settings = to.writing;
    if (chosen.from->facts.needsSign())
        request.sourceSign = chosen.from->facts.sign;
    if (chosen.to->facts.needsSign())
        request.targetSign = chosen.to->facts.sign;
    if (keepsSign)
        request.targetSign = chosen.from->facts.sign;
    const std::size_t column = isKmotionGeo(*chosen.from) ? chosen.own.value_or(2) : 0;
    const NeutralTable first = separateColumns(read->tables)[column];
    const auto result = convertTables(std::span(&first, 1), request);
    if (!result)
        return std::nullopt;
    const auto side = [&](const TableFormat& format, const std::string& text,
                          const FormatSettings& settings) {
        return json{{"format", format.facts.name}, {"text", text}, {"settings", settings},
            {"sign", signName(format.facts.sign)}};
    };
    // What these files do not say of an axis that rolls over.
    FormatSettings readingTo = to.reading;
    if (result->written.held.front().axes[0].wrap) {
        readingTo["modulo"] = "yes";
        readingTo["wrap-range"] = "its span";
    }
    addInterval(*chosen.to, result->written.held.front(), readingTo);
    json line{{"from", side(*chosen.from, source->bytes, from.reading)},
        {"to", side(*chosen.to, result->written.bytes, readingTo)},
        {"dimensions", chosen.dimensions}, {"rotary", chosen.isRotary},
        {"dropsWrap", request.dropsWrap}};
    if (chosen.own)
        line["own"] = *chosen.own;
    if (chosen.choice)
        line["direction"] = Text(choiceText(*chosen.choice)).english();
    return line;
}

struct Bulk {
    QTemporaryDir folder;
    std::size_t count = 0;
    std::size_t refused = 0;

    [[nodiscard]] QString file() const { return folder.filePath(QStringLiteral("pairs.jsonl")); }
    void make(unsigned seed, std::size_t wanted, bool keepsSign)
    {
        QFile out(file());
        QVERIFY(out.open(QIODevice::WriteOnly));
        Cases cases(seed);
        while (count < wanted) {
            const auto chosen = cases.next();
            if (!chosen)
                continue;
            const auto line = converted(cases, *chosen, keepsSign);
            refused += line ? 0 : 1;
            QVERIFY2(refused < 1000 + wanted, "nearly everything is refused");
            if (!line)
                continue;
            const std::string text = line->dump() + '\n';
            out.write(text.data(), static_cast<qint64>(text.size()));
            ++count;
        }
    }
};

struct Verdict {
    int status = -1;
    QByteArray said;
};

Verdict check(const QString& file)
{
    QProcess checker;
    checker.setProcessChannelMode(QProcess::MergedChannels);
    checker.start(QStringLiteral("python3"),
        {QStringLiteral(
             AXISCOMP_SOURCE_FOLDER "/tests/reliability/conversions/check_conversions.py"),
            file});
    if (!checker.waitForFinished(-1) || checker.exitStatus() != QProcess::NormalExit)
        return {};
    return {checker.exitCode(), checker.readAll()};
}

} // namespace

class TestRandomConversions : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyConversionIsWhatAnotherProgramMakesOfIt()
    {
        constexpr int usually = 400;
        bool isGiven = false;
        const int given = qEnvironmentVariableIntValue("AXISCOMP_CONVERSIONS", &isGiven);
        const int seed = qEnvironmentVariableIntValue("AXISCOMP_CONVERSION_SEED");
        Bulk bulk;
        bulk.make(static_cast<unsigned>(seed) + 1,
            static_cast<std::size_t>(isGiven ? given : usually), false);
        const Verdict verdict = check(bulk.file());
        QVERIFY2(verdict.status == 0, verdict.said);
        QVERIFY(verdict.said.startsWith(QByteArray::number(static_cast<int>(bulk.count))));
    }

    void theCheckerNoticesASignThatWasNotConverted()
    {
        Bulk bulk;
        bulk.make(1, 60, true);
        const Verdict verdict = check(bulk.file());
        QCOMPARE(verdict.status, 1);
        QVERIFY2(verdict.said.count(" is silently wrong") > 10, verdict.said);
    }
};

AXISCOMP_TEST(TestRandomConversions)

} // namespace tst_randomconversions

#include "tst_randomconversions.moc"
