// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_run.h"

#include "drivecomm/link_factory.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/support/patience.h"

#include <QFile>
#include <QRegularExpression>

#include <array>
#include <csignal>

namespace axiscomp::test {

namespace {

std::unique_ptr<DriveLink> linkTo(const QString& url)
{
    const auto endpoint = drivecomm::parseEndpoint(url.toStdString());
    return drivecomm::makeLink(endpoint.value(), drivecomm::genericProfile()).value();
}

} // namespace

QJsonObject ProgramRun::json() const
{
    return QJsonDocument::fromJson(out).object();
}

QByteArray ProgramRun::text() const
{
    // Qt Test cuts a message after a thousand characters, and what went wrong was said last.
    return "exit code " + QByteArray::number(code) + "\n--- stderr\n" + err.right(400)
        + "\n--- stdout\n" + out.right(500);
}

Sandbox::Sandbox() : m_environment(QProcessEnvironment::systemEnvironment())
{
    m_environment.insert(QStringLiteral("XDG_STATE_HOME"), path(QStringLiteral("state")));
    m_environment.insert(QStringLiteral("XDG_CONFIG_HOME"), path(QStringLiteral("config")));
    m_environment.remove(QStringLiteral("AXISCOMP_DRIVE"));
}

QString Sandbox::path(const QString& name) const
{
    return m_folder.filePath(name);
}

QString Sandbox::file(const QString& name, const QByteArray& content) const
{
    QFile file(path(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qWarning("cannot write %s", qPrintable(name));
    return file.fileName();
}

QByteArray Sandbox::content(const QString& name) const
{
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void Sandbox::setVariable(const QString& name, const QString& value)
{
    m_environment.insert(name, value);
}

ProgramRun Sandbox::run(const QStringList& arguments, const QByteArray& standardInput) const
{
    return runProgram(axiscompProgram(), arguments, standardInput);
}

ProgramRun Sandbox::runProgram(const QString& program, const QStringList& arguments,
    const QByteArray& standardInput, int patience) const
{
    const std::unique_ptr<QProcess> process = start(program, arguments);
    process->write(standardInput);
    process->closeWriteChannel();
    ProgramRun run;
    if (process->waitForFinished(patience)) {
        const bool isCrash = process->exitStatus() == QProcess::CrashExit;
        run.code = process->exitCode() + (isCrash ? 128 : 0);
    }
    run.out = process->readAllStandardOutput();
    run.err = process->readAllStandardError();
    return run;
}

std::unique_ptr<QProcess> Sandbox::start(const QString& program, const QStringList& arguments) const
{
    auto process = std::make_unique<QProcess>();
    process->setProcessEnvironment(m_environment);
    process->setWorkingDirectory(m_folder.path());
    process->start(program, arguments);
    process->waitForStarted(patienceMs);
    return process;
}

VirtualDriveProcess::VirtualDriveProcess(const Sandbox& sandbox, const QStringList& arguments)
    : m_process(sandbox.start(virtualDriveProgram(), arguments))
{
    static const QRegularExpression ready(
        QStringLiteral(
            "^ready(?: http=(\\S+))?(?: serial=(\\S+))?(?: instrument=\\S+)? drive=(.*)$"),
        QRegularExpression::MultilineOption);
    QByteArray said;
    // The lines of all drives come in one piece.
    while (!said.endsWith('\n') && m_process->waitForReadyRead(patienceMs))
        said += m_process->readAllStandardOutput();
    for (auto matches = ready.globalMatch(QString::fromUtf8(said)); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        m_urls.append(match.captured(1));
        m_devices.append(match.captured(2));
        m_names.append(match.captured(3));
    }
}

VirtualDriveProcess::~VirtualDriveProcess()
{
    m_process->terminate();
    if (!m_process->waitForFinished(patienceMs))
        m_process->kill();
    m_process->waitForFinished(patienceMs);
}

QByteArray VirtualDriveProcess::said()
{
    return m_process->readAllStandardError();
}

RegisterValue VirtualDriveProcess::registerValue(const std::string& path) const
{
    const auto readings = linkTo(url())->readRegisters(std::array{path}, {});
    return readings && readings->size() == 1 ? readings->front().value : RegisterValue{};
}

bool VirtualDriveProcess::writeRegister(const std::string& path, const RegisterValue& value) const
{
    return linkTo(url())->writeRegisters(std::array{RegisterWrite{path, value}}, {}).has_value();
}

QString axiscompProgram()
{
    return QStringLiteral(AXISCOMP_PROGRAM);
}

QString virtualDriveProgram()
{
    return QStringLiteral(AXISCOMP_VIRTUALDRIVE_PROGRAM);
}

QString positionSource(int axis)
{
    return QStringLiteral("Axes[%1]/Signals/PathPlanner/Position").arg(axis);
}

} // namespace axiscomp::test
