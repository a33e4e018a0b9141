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
    // A name in Chinese or Japanese has no letter of the keyboard.
    for (const QChar key : QStringLiteral("123456789abcdefghijklmnopqrstuvwxyz")) {
        if (used.contains(key))
            continue;
        used.insert(key);
        return name + QStringLiteral(" (&%1)").arg(key.toUpper());
    }
    return name;
}

QString withoutKey(QString text)
{
    return text.remove(u'&');
}

} // namespace axiscomp::ui
