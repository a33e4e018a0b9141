// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/report_module.h"
#include "ui/report/report_pdf.h"

#include <QGuiApplication>

extern "C" Q_DECL_EXPORT void axiscompReportPdf(
    const axiscomp::ReportDocument& document, axiscomp::Result<axiscomp::Bytes>& pdf)
{
    // What Qt misses of a desktop's folders is nothing to a person who wants a file.
    const QtMessageHandler handler =
        qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
    // Fonts come with an application; nothing is shown, and no display is asked for.
    int count = 3;
    char name[] = "axiscomp";
    char option[] = "-platform";
    char platform[] = "offscreen";
    char* arguments[] = {name, option, platform, nullptr};
    const QGuiApplication application(count, arguments);
    pdf = axiscomp::ui::reportPdf(document);
    qInstallMessageHandler(handler);
}
