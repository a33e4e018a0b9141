// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <span>
#include <string>

namespace axiscomp::ui {

/// How the values of a table are shown: in a unit that suits the largest of them (micrometres for a
/// table in millimetres), with one number of decimals, as many as they need and never more than
/// five digits of the largest. So the decimals stand below each other, and what float32 adds to a
/// number is not seen.
class ValueScale {
public:
    ValueScale() = default; ///< numbers without a unit, whole
    /// unit: of the values, a symbol as files write it; one that is not known stays. noise:
    /// differences up to this are not shown, in the same unit.
    ValueScale(const std::string& unit, std::span<const float> values, double noise = 0.0);
    /// The same where the largest |value| is known.
    ValueScale(
        const std::string& unit, double largest, std::span<const float> values, double noise);

    /// The same unit, with the decimals that other values need: of a column beside this one.
    [[nodiscard]] ValueScale beside(std::span<const float> values, double noise = 0.0) const;

    [[nodiscard]] const std::string& unit() const { return m_unit; } ///< as shown; may be empty
    [[nodiscard]] double factor() const { return m_factor; } ///< shown value per value
    [[nodiscard]] int decimals() const { return m_decimals; }
    /// "+2.10", "0.00"; value: as the table has it.
    [[nodiscard]] QString text(double value) const;
    /// "+2.10 µm"
    [[nodiscard]] QString textWithUnit(double value) const;
    /// "2.10 µm", for what has no sign.
    [[nodiscard]] QString sizeWithUnit(double value) const;
    /// For other programs: decimal point, every digit that the float32 has, in the unit shown.
    [[nodiscard]] QByteArray plain(float value) const;

private:
    void chooseUnit(double largest);
    void chooseDecimals(double largest, std::span<const float> values, double noise);
    [[nodiscard]] QString digits(double value) const;

    std::string m_unit;
    double m_factor = 1.0;
    int m_decimals = 0;
};

} // namespace axiscomp::ui
