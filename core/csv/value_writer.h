// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace axiscomp::csv {

/// Writes values in as few digits as bring the same float32 back. The reader goes by way of a
/// double, which in rare cases rounds what would be shorter twice. Values of a table have about as
/// many decimals: those of the last one are tried first.
class ValueWriter {
public:
    /// longestText and shortNumberReach characters must be there. Writes a comma behind the text,
    /// and returns what follows it.
    char* write(float value, char* buffer);

private:
    int m_decimals = 9;
};

} // namespace axiscomp::csv
