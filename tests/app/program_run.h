// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/register_value.h"
#include "tests/support/patience.h"

#include <QByteArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

#include <memory>
#include <string>

namespace axiscomp::test {

/// How a program ended and what it said.
struct ProgramRun {
    int code = -1; ///< 128 + signal when it was killed
    QByteArray out;
    QByteArray err;

    /// The one JSON document on standard output; empty when there is none.
    [[nodiscard]] QJsonObject json() const;
    /// For failure messages.
    [[nodiscard]] QByteArray text() const;
};

/// A folder of its own for files and for what the programs remember, and a clean environment.
class Sandbox {
public:
    Sandbox();

    [[nodiscard]] QString path(const QString& name = {}) const;
    /// Writes a file and gives its path.
    QString file(const QString& name, const QByteArray& content) const;
    [[nodiscard]] QByteArray content(const QString& name) const;
    void setVariable(const QString& name, const QString& value);

    /// Runs axiscomp to its end.
    [[nodiscard]] ProgramRun run(
        const QStringList& arguments, const QByteArray& standardInput = {}) const;
    /// Runs any program to its end.
    [[nodiscard]] ProgramRun runProgram(const QString& program, const QStringList& arguments,
        const QByteArray& standardInput = {}, int patience = patienceMs) const;
    /// Starts a program and leaves it running.
    [[nodiscard]] std::unique_ptr<QProcess> start(
        const QString& program, const QStringList& arguments) const;

private:
    QTemporaryDir m_folder;
    QProcessEnvironment m_environment;
};

/// axiscomp-virtualdrive, running until this is destroyed.
class VirtualDriveProcess {
public:
    explicit VirtualDriveProcess(const Sandbox& sandbox, const QStringList& arguments = {});
    ~VirtualDriveProcess();

    /// Whether it said "ready", which it does within the deadline or never.
    [[nodiscard]] bool isReady() const { return !m_names.isEmpty(); }
    [[nodiscard]] QString url(int drive = 0) const { return m_urls.value(drive); }
    [[nodiscard]] QStringList urls() const { return m_urls; }
    /// "/dev/pts/7", empty where a drive has no serial link
    [[nodiscard]] QStringList devices() const { return m_devices; }
    [[nodiscard]] QStringList names() const { return m_names; }
    [[nodiscard]] QProcess& process() { return *m_process; }
    [[nodiscard]] QByteArray said();
    /// What a register of the first drive says, and writing it, as another program would.
    [[nodiscard]] axiscomp::RegisterValue registerValue(const std::string& path) const;
    [[nodiscard]] bool writeRegister(
        const std::string& path, const axiscomp::RegisterValue& value) const;

private:
    std::unique_ptr<QProcess> m_process;
    QStringList m_urls; ///< empty where a drive has no web server
    QStringList m_devices;
    QStringList m_names;
};

[[nodiscard]] QString axiscompProgram();
[[nodiscard]] QString virtualDriveProgram();

/// Register paths of the generic profile that tests use as sources.
[[nodiscard]] QString positionSource(int axis);

} // namespace axiscomp::test

/// Fails with everything the program said unless it ended with this code.
#define VERIFY_CODE(run, expected)                                                                 \
    do {                                                                                           \
        const auto& verifiedRun = (run);                                                           \
        QVERIFY2(verifiedRun.code == (expected), verifiedRun.text().constData());                  \
    } while (false)
