// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/formats/measurement_format.h"
#include "core/metrology/judge/corrections.h"
#include "core/metrology/judge/outliers.h"
#include "core/metrology/judge/uncertainty.h"
#include "core/metrology/record/calibration_record.h"
#include "core/table/table_identity.h"

#include <QString>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace axiscomp::ui {

/// How the file of a measurement is read, as far as the user has said it.
struct MeasurementChoices {
    std::string format; ///< its name; empty: by the content
    std::vector<ColumnMapping> columns; ///< empty: the header names them
    std::size_t skippedLines = 0;
    std::string unit; ///< of targets; empty: as the file says
    std::string valueUnit; ///< likewise
    MeasurementReadOptions::Values values = MeasurementReadOptions::Values::AsFileSays;
    bool takesDirectionFromOrder = false;
    bool invertsReference = false;

    friend bool operator==(const MeasurementChoices&, const MeasurementChoices&) = default;
};

struct MeasurementFile {
    QString path; ///< absolute; of a file that a record holds, its name there
    MeasurementChoices choices;
    /// As a record holds it: nothing is read, and the choices have no meaning. null: it is read.
    std::shared_ptr<const RecordedFile> recorded = {};

    friend bool operator==(const MeasurementFile&, const MeasurementFile&) = default;
};

/// The table that an axis has.
struct HeldTable {
    std::int32_t serialNumber = 0; ///< of the drive
    int axis = 0; ///< its number, from 0
    TableIdentity table = {};

    friend bool operator==(const HeldTable& a, const HeldTable& b)
    {
        return a.serialNumber == b.serialNumber && a.axis == b.axis
            && isSameTable(a.table, b.table);
    }
};

/// What a person says of the table that is made of a measurement.
struct FitChoices {
    /// Without what is said elsewhere: tolerances, uncertainty, rule for outliers, most points.
    /// lookupAt none: as the source of the current axis says it.
    FitSettings settings;
    bool areLengthsAngles = false; ///< lengths of the settings are in deg, else in mm
    /// What was active while it was measured, where the file does not say it.
    enum class MeasuredWith { NotSaid, Off, On, File } measuredWith = MeasuredWith::NotSaid;
    QString measuredWithFile; ///< the table that was active, with File; absolute
    /// What residuals are merged onto.
    enum class Onto { Nothing, Drive, File } onto = Onto::Nothing;
    /// With Drive: the table that the axis had when it was said. What was measured with it was not
    /// measured with another one.
    std::optional<HeldTable> ontoTable;
    QString ontoFile; ///< with File; absolute

    friend bool operator==(const FitChoices&, const FitChoices&) = default;
};

/// Everything that a person says of a measurement, as one value: what is undone and done again.
struct Record {
    std::vector<MeasurementFile> files; ///< joined in this order
    bool swapsDirections = false;
    /// Of the joined measurement, as it is shown: after the directions were exchanged.
    std::vector<Exclusion> exclusions;
    CorrectionsBefore corrections; ///< before judging
    /// Of a second measurement, where its files do not say it: the checksum of the table that was
    /// active, as a person says. It holds for that table alone.
    std::optional<std::uint32_t> statedTable;
    OutlierRule outlierRule = OutlierRule::PooledMad;
    bool areLimitsAngles = false; ///< tolerances and uncertainty are in deg, else in mm
    std::vector<Tolerance> tolerances; ///< in mm or deg
    std::optional<double> uncertainty; ///< U with k = 2, in mm or deg
    FitChoices fit;
    /// What was promised of the table that is used, and what came of it: as it was made then, even
    /// when the measurement is judged or fitted otherwise since. null: no table is used.
    std::shared_ptr<const CalibrationRecord> calibration;

    friend bool operator==(const Record&, const Record&) = default;
};

} // namespace axiscomp::ui
