// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/number_text.h"
#include "core/metrology/fine_quantity.h"

namespace axiscomp::app {

/// Deviations and figures that are read together, in the unit that suits the largest of them.
class FineText {
public:
    /// shown: all of them, in mm or deg
    FineText(std::span<const std::optional<double>> shown, bool isAngular)
        : m_unit(fineUnit(shown, isAngular))
    {
    }

    /// "-": not defined
    [[nodiscard]] std::string operator()(const std::optional<double>& value) const
    {
        return value ? m_unit.digits(*value) : "-";
    }
    [[nodiscard]] std::string unit() const { return m_unit.name; }

private:
    FineUnit m_unit;
};

/// One that stands alone, with its unit.
[[nodiscard]] inline std::string fineText(double value, bool isAngular)
{
    const Quantity quantity = fineQuantity(value, isAngular);
    return withUnit(quantity.digits, quantity.unit);
}

} // namespace axiscomp::app
