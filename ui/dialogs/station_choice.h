// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/configuration/tam_configuration.h"
#include "ui/session/axis_entry.h"

#include <QWidget>

#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;

namespace axiscomp::ui {

class ToneLabel;

/// Reads a TAM configuration and asks which of its stations is the drive. One with another serial
/// number has to be confirmed.
class StationChoice : public QWidget {
    Q_OBJECT

public:
    enum class Direction { ToDrive, ToFile };

    /// drive: an axis of it.
    StationChoice(
        const QString& path, Direction direction, AxisEntry drive, QWidget* parent = nullptr);

    [[nodiscard]] bool isReading() const { return !m_configuration; }
    [[nodiscard]] bool hasFailed() const { return m_configuration && !*m_configuration; }
    /// Why no station can be used, a translated sentence; empty: configuration() and station() can.
    [[nodiscard]] QString obstacle() const;
    [[nodiscard]] const std::shared_ptr<const TamConfiguration>& configuration() const
    {
        return **m_configuration;
    }
    [[nodiscard]] std::size_t station() const;
    /// Whether another serial number than the drive's has been confirmed.
    [[nodiscard]] bool acceptsOther() const;
    void setChoosable(bool isChoosable);
    void retranslate();

Q_SIGNALS:
    void changed();

private:
    using Loaded = Result<std::shared_ptr<const TamConfiguration>>;

    void build();
    void take(const Loaded& configuration);
    void choose();
    void showState();
    [[nodiscard]] bool isOther() const;
    [[nodiscard]] QString warning() const;

    const Direction m_direction;
    const AxisEntry m_drive;
    std::optional<Loaded> m_configuration;
    bool m_isChoosable = true;
    QLabel* m_label;
    QComboBox* m_stations;
    ToneLabel* m_warning;
    QCheckBox* m_accept;
};

} // namespace axiscomp::ui
