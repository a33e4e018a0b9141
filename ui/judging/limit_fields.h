// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/metrology/judge/iso230.h"

#include <QWidget>

#include <optional>
#include <vector>

class QGridLayout;
class QLabel;
class QLineEdit;

namespace axiscomp::ui {

class RecordModel;
class ToneLabel;

/// What is allowed of the figures of ISO 230-2, and how well they are known.
class LimitFields : public QWidget {
    Q_OBJECT

public:
    /// record must outlive the fields.
    explicit LimitFields(RecordModel& record, QWidget* parent = nullptr);

    void retranslate();

private:
    struct Field {
        std::optional<Iso230Figure> figure; ///< nothing: the uncertainty
        QLabel* label;
        QLineEdit* edit;
        std::optional<Error> problem; ///< why its text was not taken
    };
    void follow();
    void forgetTyped();
    void take(Field& field);
    void showProblems();
    [[nodiscard]] bool isAngular() const;
    [[nodiscard]] std::optional<double> valueOf(const Field& field) const;
    void describe(const Field& field);

    RecordModel& m_record;
    std::vector<Field> m_fields;
    ToneLabel* m_problem;
};

} // namespace axiscomp::ui
