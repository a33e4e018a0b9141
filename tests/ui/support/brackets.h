// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QTranslator>

namespace axiscomp::test {

/// A language of its own: what is translated is put in brackets, so that what is not shows.
class Brackets final : public QTranslator {
public:
    Brackets() { QCoreApplication::installTranslator(this); }
    ~Brackets() override { QCoreApplication::removeTranslator(this); }
    [[nodiscard]] QString translate(const char*, const char* text, const char*, int) const override
    {
        return QStringLiteral("<") + QString::fromUtf8(text) + u'>';
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

} // namespace axiscomp::test
