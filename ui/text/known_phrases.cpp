// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <vector>

namespace axiscomp::ui {

std::span<const char* const> knownPhrases()
{
    static const std::vector<const char*> all = [] {
        std::vector<const char*> phrases;
        for (const auto part : {errorPhrases(), planPhrases(), filePhrases(), calibrationPhrases(),
                 linkPhrases(), formatPhrases(), conversionPhrases(), tablePhrases(), gridPhrases(),
                 motionPhrases(), machinePhrases()})
            phrases.insert(phrases.end(), part.begin(), part.end());
        return phrases;
    }();
    return all;
}

} // namespace axiscomp::ui
