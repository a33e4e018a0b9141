// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"

#include <QCoreApplication>

#include <functional>
#include <memory>
#include <string_view>

namespace axiscomp::test {

using MakeApplication = std::function<std::unique_ptr<QCoreApplication>(int& argc, char** argv)>;
using MakeTest = std::function<std::unique_ptr<QObject>()>;

/// The tests of one folder are one program, which runs the test that its first argument names: the
/// name of the file without folder and ending. To be called before main.
bool addTest(std::string_view file, MakeApplication makeApplication, MakeTest makeTest);

template <class Application>
std::unique_ptr<QCoreApplication> makeApplication(int& argc, char** argv)
{
    return std::make_unique<Application>(argc, argv);
}

} // namespace axiscomp::test

#define AXISCOMP_TEST_WITH(Application, Class)                                                     \
    [[maybe_unused]] const bool isTestAdded = axiscomp::test::addTest(__FILE__,                    \
        axiscomp::test::makeApplication<Application>, [] { return std::make_unique<Class>(); });

/// A class of test functions that needs no window.
#define AXISCOMP_TEST(Class) AXISCOMP_TEST_WITH(QCoreApplication, Class)
