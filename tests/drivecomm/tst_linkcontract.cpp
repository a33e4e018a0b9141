// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/drivecomm/link_contract.h"
#include "tests/support/test_registry.h"
#include "tests/support/wire_attachments.h"

namespace tst_linkcontract {

using namespace axiscomp::test;

class TestLinkContract final : public LinkContract {
public:
    TestLinkContract() : LinkContract({inProcess(), web(), serial()}) { }
};

AXISCOMP_TEST(TestLinkContract)

} // namespace tst_linkcontract
