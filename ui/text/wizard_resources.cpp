// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/wizard_resources.h"

/// Q_INIT_RESOURCE declares a function, which must not be in a namespace.
static void initialise()
{
    Q_INIT_RESOURCE(axiscomp_wizard);
}

namespace axiscomp::ui {

void useWizardResources()
{
    initialise();
}

QIcon wizardIcon()
{
    useWizardResources();
    QIcon icon;
    for (const int size : {16, 24, 32, 48, 64, 128, 256})
        icon.addFile(QStringLiteral(":/axiscomp/icons/axis-compensation-wizard-%1.png").arg(size));
    return icon;
}

} // namespace axiscomp::ui
