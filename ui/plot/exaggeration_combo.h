// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace axiscomp::ui {

/// How many times too large errors are drawn: the factor that fits, or one of 1, 2 or 5 times a
/// power of ten.
class ExaggerationCombo : public QComboBox {
    Q_OBJECT

public:
    explicit ExaggerationCombo(QWidget* parent = nullptr);

    /// The factor that fits what is drawn; any number, a round one below it is taken.
    void setFitting(double factor);
    [[nodiscard]] double factor() const;
    /// To larger or smaller factors, from the one that is in use.
    void step(int steps);
    void showFitting();
    void retranslate();

Q_SIGNALS:
    void factorChanged();

private:
    double m_fitting = 1.0;
};

/// The largest of 1, 2 and 5 times a power of ten that is not above a number; 1 for what is no
/// positive number.
[[nodiscard]] double roundFactor(double number);
/// "1,000", "0.5"
[[nodiscard]] QString factorText(double factor);

} // namespace axiscomp::ui
