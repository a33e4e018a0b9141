// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"

#include <QFileInfo>
#include <QTest>

#include <cstdio>
#include <map>
#include <string>

namespace axiscomp::test {

namespace {

struct RegisteredTest {
    MakeApplication makeApplication;
    MakeTest makeTest;
};

/// Inside a function: tests are added before the objects of this file are made.
std::map<std::string, RegisteredTest, std::less<>>& registeredTests()
{
    static std::map<std::string, RegisteredTest, std::less<>> tests;
    return tests;
}

/// Temporary folders are in memory where there is such a place: thousands of writes that reach a
/// disk take minutes. Nothing here depends on a disk: what is killed is programs, not the system.
void keepTemporaryFilesInMemory()
{
    const auto memory = QByteArrayLiteral("/dev/shm");
    if (!qEnvironmentVariableIsSet("TMPDIR") && QFileInfo(QString::fromLatin1(memory)).isWritable())
        qputenv("TMPDIR", memory);
}

int run(int argc, char** argv)
{
    const auto found = argc < 2 ? registeredTests().end() : registeredTests().find(argv[1]);
    if (found == registeredTests().end()) {
        std::fprintf(stderr, "%s NAME [FUNCTION[:ROW] ...] runs one of these tests:\n", argv[0]);
        for (const auto& [name, test] : registeredTests())
            std::fprintf(stderr, "    %s\n", name.c_str());
        return 2;
    }
    // The name becomes the program's, so that Qt Test sees its own arguments only.
    argv[1] = argv[0];
    ++argv;
    --argc;
    // ctest limits how long a test may take; Qt Test would end each function after five minutes.
    if (!qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT"))
        qputenv("QTEST_FUNCTION_TIMEOUT", "36000000");
    keepTemporaryFilesInMemory();
    const auto application = found->second.makeApplication(argc, argv);
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi, true);
    return QTest::qExec(found->second.makeTest().get(), argc, argv);
}

} // namespace

bool addTest(std::string_view file, MakeApplication makeApplication, MakeTest makeTest)
{
    file.remove_prefix(file.rfind('/') + 1);
    const auto name = std::string(file.substr(0, file.rfind('.')));
    return registeredTests()
        .try_emplace(name, RegisteredTest{std::move(makeApplication), std::move(makeTest)})
        .second;
}

} // namespace axiscomp::test

int main(int argc, char** argv)
{
    return axiscomp::test::run(argc, argv);
}
