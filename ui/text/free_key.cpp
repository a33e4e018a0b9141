// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/free_key.h"

namespace axiscomp::ui {

QString withFreeKey(QString name, QSet<QChar>& used)
{
    for (qsizetype i = 0; i < name.size(); ++i) {
        const QChar letter = name[i].toLower();
        if (!letter.isLetterOrNumber() || letter.unicode() > 127 || used.contains(letter))
            continue;
        used.insert(letter);
        return name.insert(i, u'&');
    }
    for (QChar digit = u'1'; digit <= u'9'; digit = QChar(digit.unicode() + 1)) {
        if (used.contains(digit))
            continue;
        used.insert(digit);
        return name + QStringLiteral(" (&%1)").arg(digit);
    }
    return name;
}

QString withoutKey(QString text)
{
    return text.remove(u'&');
}

} // namespace axiscomp::ui
