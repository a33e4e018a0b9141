// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fine_quantity.h"
#include "core/metrology/judge/deviation_curves.h"
#include "core/metrology/record/comparison.h"
#include "ui/async/background_job.h"

#include <QObject>

namespace axiscomp::ui {

class RecordModel;

/// What a second measurement says of a table.
struct ComparisonState {
    std::shared_ptr<const Comparison> comparison; ///< null: there is none
    std::optional<Error> refusal; ///< why
    std::optional<std::uint32_t> tableCrc; ///< of the table that is compared
    bool needsStatement = false; ///< the second measurement does not say which table was active
    /// The second one is corrected for temperature or dead path, and the first is not.
    bool isCorrectedOtherwise = false;
    bool isAngular = false;
    bool isKept = false; ///< the second measurement is in the record
    std::string date; ///< of the second measurement, as its file has it
    FineUnit unit; ///< in which figures and deviations are shown
    TwoDatums datums = {}; ///< from which deviations are shown
};

/// Compares the measurement of the table in use with a second one, on another thread, whenever one
/// of them is another one.
class ComparisonModel : public QObject {
    Q_OBJECT

public:
    /// record: with the table in use, the tolerances and, without a table, the first measurement;
    /// after: the second measurement. Both must outlive this.
    ComparisonModel(RecordModel& record, const RecordModel& after, QObject* parent = nullptr);

    [[nodiscard]] const ComparisonState& state() const { return m_state; }
    [[nodiscard]] bool isComparing() const { return m_isComparing; }
    /// There is a comparison of a table in use, which the record does not have yet.
    [[nodiscard]] bool mayKeep() const;
    /// The second measurement, what it says of the prediction, and the verdict go into the record
    /// of the table in use: a step.
    void keep();

Q_SIGNALS:
    void changed(); ///< state(), isComparing(), mayKeep()

private:
    void follow();
    void take(const ComparisonState& state);

    RecordModel& m_record;
    const RecordModel& m_after;
    ComparisonState m_state;
    NewestJob<ComparisonState> m_job;
    bool m_isComparing = false;
    bool m_isKeeping = false;
};

} // namespace axiscomp::ui
