// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/sign_sentence.h"

#include "core/table/position_unit.h"
#include "ui/text/value_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <optional>

namespace axiscomp::ui {

namespace {

/// So many decimals that a value shows this many digits of its own.
constexpr int significantDigits = 2;
constexpr int mostDecimals = 9;

int decimalsFor(double value)
{
    if (value == 0.0 || !std::isfinite(value))
        return 0;
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
    return std::clamp(significantDigits - 1 - exponent, 0, mostDecimals);
}

/// The decimals that a position needs to be exact.
int decimalsOf(double value)
{
    double scale = 1.0;
    for (int decimals = 0; decimals < mostDecimals; ++decimals, scale *= 10.0) {
        const double scaled = value * scale;
        if (std::abs(scaled - std::round(scaled)) < 1e-9 * std::max(1.0, std::abs(scaled)))
            return decimals;
    }
    return mostDecimals;
}

QString fixedText(double value, int decimals)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'f', decimals);
}

QString withUnit(const QString& number, const QString& unit)
{
    return unit.isEmpty() ? number : number + u' ' + unit;
}

class Sentence {
    Q_DECLARE_TR_FUNCTIONS(axiscomp::ui::SignSentence)

public:
    Sentence(const CompensationTable& table, std::size_t element, const AxisInfo& axis,
        const SignPlace& place)
        : m_table(table)
        , m_isAtSet(place.lookupAt == LookupAt::Set)
        , m_isComputed(place.isComputed)
        , m_positionUnit(axis.unit)
        , m_unit(unitSymbol(axis.unit))
        , m_value(static_cast<double>(table.values[element]))
        , m_own(place.own)
    {
        for (const GridAxis& gridAxis : table.grid.axes) {
            m_position.push_back(gridAxis.position(element % gridAxis.size));
            element /= gridAxis.size;
        }
    }

    [[nodiscard]] QString text() const
    {
        if (m_value == 0.0)
            return tr("all values are 0: the drive will add nothing");
        const bool isOfTheDrive =
            isOfTheAxis(m_table.unit) && (!m_own || isOfTheAxis(m_table.grid.axes[*m_own].unit));
        if (!isOfTheDrive) // what could be converted has been
            return {};
        return m_own ? withReadings(*m_own) : withDifference();
    }

private:
    /// An axis that is known to have no unit has none of a length or an angle.
    [[nodiscard]] bool isOfTheAxis(const std::string& unit) const
    {
        return unit.empty() || m_positionUnit.empty() || isSameUnit(unit, m_positionUnit);
    }

    [[nodiscard]] QString added() const
    {
        const QString number = fixedText(m_value, decimalsFor(m_value));
        return withUnit(m_value > 0.0 ? u'+' + number : number, m_unit);
    }

    /// The table is over the axis's own position: both readings can be told.
    [[nodiscard]] QString withReadings(std::size_t own) const
    {
        const double encoder = m_position[own];
        const int decimals = std::max(decimalsOf(encoder), decimalsFor(m_value));
        const QString position = withUnit(fixedText(encoder, decimals), positionUnit(own));
        const QString where = m_isAtSet
            ? tr("at the set position %1 the drive will add %2").arg(position, added())
            : m_isComputed
            ? tr("where the encoder reads %1, the drive will add %2").arg(position, added())
            : tr("where the encoder reads %1, the reference reads %2: the drive will add %3")
                  .arg(position, withUnit(fixedText(encoder + m_value, decimals), m_unit), added());
        const QString others = place(own);
        return others.isEmpty() ? where : tr("at %1, %2").arg(others, where);
    }

    [[nodiscard]] QString withDifference() const
    {
        if (m_isComputed)
            return tr("at %1 the drive will add %2").arg(place(std::nullopt), added());
        const QString amount = withUnit(fixedText(std::abs(m_value), decimalsFor(m_value)), m_unit);
        return (m_value > 0.0
                ? tr("at %1 the reference reads %2 more than the encoder: the drive will add %3")
                : tr("at %1 the reference reads %2 less than the encoder: the drive will add %3"))
            .arg(place(std::nullopt), amount, added());
    }

    /// The position, without one of the dimensions: "Y 30 mm, T 20.5"
    [[nodiscard]] QString place(std::optional<std::size_t> except) const
    {
        QStringList parts;
        for (std::size_t n = 0; n < m_position.size(); ++n) {
            if (n == except)
                continue;
            const QString number = fixedText(m_position[n], decimalsOf(m_position[n]));
            parts.append(dimensionName(m_table.grid, n) + u' '
                + withUnit(number, QString::fromStdString(m_table.grid.axes[n].unit)));
        }
        return listText(parts);
    }

    [[nodiscard]] QString positionUnit(std::size_t dimension) const
    {
        const QString unit = QString::fromStdString(m_table.grid.axes[dimension].unit);
        return unit.isEmpty() ? m_unit : unit;
    }

    const CompensationTable& m_table;
    bool m_isAtSet = false; ///< the axis's own position is one after the compensation
    bool m_isComputed = false;
    std::string m_positionUnit; ///< as the drive says it
    QString m_unit; ///< of what the drive adds
    double m_value = 0.0;
    std::optional<std::size_t> m_own; ///< the dimension that is the axis's own position
    std::vector<double> m_position;
};

} // namespace

QString signSentenceFor(const LoadedTable& table, const AxisInfo& axis, const SignPlace& place)
{
    if (!table.table || table.table->values.empty())
        return {};
    SignPlace known = place;
    if (known.own && *known.own >= table.table->grid.axes.size())
        known.own.reset();
    return Sentence(*table.table, table.largestElement, axis, known).text();
}

} // namespace axiscomp::ui
