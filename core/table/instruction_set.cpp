// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/instruction_set.h"

namespace axiscomp {

bool isSupported(InstructionSet instructions)
{
#ifdef AXISCOMP_HAS_WIDE_VECTORS
    switch (instructions) {
    case InstructionSet::Baseline:
        return true;
    case InstructionSet::Avx2:
        return __builtin_cpu_supports("avx2") != 0;
    case InstructionSet::Avx512:
        return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0
            && __builtin_cpu_supports("avx512vl") != 0;
    }
    return false;
#else
    return instructions == InstructionSet::Baseline;
#endif
}

InstructionSet bestInstructionSet()
{
    static const InstructionSet best = isSupported(InstructionSet::Avx512) ? InstructionSet::Avx512
        : isSupported(InstructionSet::Avx2)                                ? InstructionSet::Avx2
                                            : InstructionSet::Baseline;
    return best;
}

} // namespace axiscomp
