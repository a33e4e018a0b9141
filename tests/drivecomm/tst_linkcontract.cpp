// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/drivecomm/link_contract.h"
#include "tests/support/wire_attachments.h"

#include <QCoreApplication>
#include <QTest>

using namespace axiscomp;

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    test::LinkContract contract({test::inProcess(), test::web(), test::serial()});
    return QTest::qExec(&contract, argc, argv);
}
