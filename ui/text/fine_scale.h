// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace axiscomp::ui {

/// How deviations and figures of a measurement are shown: micrometres for lengths in mm, arc
/// seconds for angles in degrees, with two decimals.
class FineScale {
public:
    explicit FineScale(bool isAngular = false) : m_isAngular(isAngular) { }

    [[nodiscard]] double factor() const { return m_isAngular ? 3600.0 : 1000.0; }
    [[nodiscard]] QString symbol() const; ///< "µm", "″"
    /// "93.20", "-0.31"; "–" for what is not defined.
    [[nodiscard]] QString text(std::optional<double> value) const;
    /// "93.20 µm"
    [[nodiscard]] QString textWithUnit(std::optional<double> value) const;
    /// "+93.20"
    [[nodiscard]] QString signedText(std::optional<double> value) const;

    friend bool operator==(const FineScale&, const FineScale&) = default;

private:
    bool m_isAngular = false;
};

} // namespace axiscomp::ui
