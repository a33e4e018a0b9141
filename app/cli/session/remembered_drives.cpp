// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/session/remembered_drives.h"

#include <QSettings>

namespace axiscomp::app {

namespace {

constexpr std::size_t mostEndpoints = 64;
constexpr qsizetype longestEndpoint = 4096;

} // namespace

std::vector<std::string> rememberedDrives()
{
    // As the window writes them (tests/app compares).
    const QSettings settings(
        QStringLiteral("axiscomp"), QStringLiteral("axis-compensation-wizard"));
    std::vector<std::string> endpoints;
    for (const QString& endpoint :
        settings.value(QStringLiteral("compensationWizard/endpoints")).toStringList())
        if (endpoint.size() <= longestEndpoint && endpoints.size() < mostEndpoints)
            endpoints.push_back(endpoint.toStdString());
    return endpoints;
}

} // namespace axiscomp::app
