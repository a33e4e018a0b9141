// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/rigid_body.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <vector>

namespace tst_rigidbody {

using namespace axiscomp;
using Place = std::array<double, 3>;
using Field = std::function<Place(const Place&)>;

namespace {

struct Points {
    std::size_t dimensions = 2;
    std::array<std::vector<double>, 3> positions;
    std::array<std::vector<double>, 3> deviations;

    /// A grid of 5 x 4, or 5 x 4 x 3, away from the origin.
    Points(std::size_t count, const Field& field) : dimensions(count)
    {
        for (int i = 0; i < 5; ++i)
            for (int j = 0; j < 4; ++j)
                for (int k = 0; k < (count == 3 ? 3 : 1); ++k)
                    add({100.0 + 20.0 * i, -30.0 + 25.0 * j, count == 3 ? 10.0 * k : 0.0}, field);
    }
    void add(const Place& place, const Field& field)
    {
        const Place deviation = field(place);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            positions[axis].push_back(place[axis]);
            deviations[axis].push_back(deviation[axis]);
        }
    }
    [[nodiscard]] VectorDeviations vectors() const
    {
        return {dimensions, {positions[0], positions[1], positions[2]},
            {deviations[0], deviations[1], deviations[2]}};
    }
};

bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-12;
}

} // namespace

class TestRigidBody : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aShiftedAndTurnedPlateIsFound()
    {
        const Points points(2, [](const Place& p) {
            return Place{0.3 - 2e-4 * p[1], -0.1 + 2e-4 * p[0], 0.0};
        });
        const auto body = fitRigidBody(points.vectors());
        VERIFY_RESULT(body);
        QVERIFY(isNear(body->translation[0], 0.3) && isNear(body->translation[1], -0.1));
        QVERIFY(isNear(body->rotation[2], 2e-4));
        QVERIFY(isNear(body->squareness[0], 0.0));
        const Place there = body->at({7.0, -5.0, 0.0});
        QVERIFY(isNear(there[0], 0.301) && isNear(there[1], -0.0986));
    }

    void aBodyInSpaceIsFound()
    {
        const Place w{1e-4, -2e-4, 3e-4};
        const Points points(3, [&w](const Place& p) {
            return Place{0.1 + w[1] * p[2] - w[2] * p[1], 0.2 + w[2] * p[0] - w[0] * p[2],
                0.3 + w[0] * p[1] - w[1] * p[0]};
        });
        for (const RigidBodyRequest& request :
            {RigidBodyRequest{}, RigidBodyRequest{.alongAxis = 0}, RigidBodyRequest{.alongAxis = 1},
                RigidBodyRequest{.alongAxis = 2, .fitsScale = true}}) {
            const auto body = fitRigidBody(points.vectors(), request);
            VERIFY_RESULT(body);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                QVERIFY(isNear(body->rotation[axis], w[axis]));
                QVERIFY(isNear(body->translation[axis], 0.1 * static_cast<double>(axis + 1)));
                QVERIFY(isNear(body->squareness[axis], 0.0));
            }
            QVERIFY(isNear(body->scale, 0.0));
        }
    }

    /// Y leans by 40 urad: dx = 40e-6 y, and the plate lies turned by 100 urad.
    void alongXSquarenessStaysInTheTableOfX()
    {
        const Points points(2, [](const Place& p) {
            return Place{4e-5 * p[1] - 1e-4 * p[1], 1e-4 * p[0], 0.0};
        });
        const auto alongX = fitRigidBody(points.vectors(), {.alongAxis = 0});
        VERIFY_RESULT(alongX);
        QVERIFY(isNear(alongX->rotation[2], 1e-4));
        const auto alongY = fitRigidBody(points.vectors(), {.alongAxis = 1});
        VERIFY_RESULT(alongY);
        QVERIFY(isNear(alongY->rotation[2], 6e-5));
        const auto shared = fitRigidBody(points.vectors());
        VERIFY_RESULT(shared);
        QVERIFY(shared->rotation[2] > 6e-5 && shared->rotation[2] < 1e-4);
        for (const auto& body : {alongX, alongY, shared})
            QVERIFY(isNear(body->squareness[0], 4e-5)); // whatever the rotation
    }

    void theScaleIsTakenOutOnlyWhenAsked()
    {
        const Points points(2, [](const Place& p) { return Place{1e-5 * p[0], 1e-5 * p[1], 0.0}; });
        const auto without = fitRigidBody(points.vectors());
        const auto with = fitRigidBody(points.vectors(), {.fitsScale = true});
        VERIFY_RESULT(without);
        VERIFY_RESULT(with);
        QCOMPARE(without->scale, 0.0);
        QVERIFY(isNear(with->scale, 1e-5));
        QVERIFY(isNear(with->translation[0], 0.0) && isNear(with->translation[1], 0.0));
    }

    void pointsThatCannotTellAreRefused()
    {
        const Field none = [](const Place&) { return Place{}; };
        Points line(2, none);
        for (std::size_t i = 0; i < line.positions[0].size(); ++i)
            line.positions[1][i] = 2.0 * line.positions[0][i];
        VERIFY_ERROR(fitRigidBody(line.vectors()), ErrorCode::InvalidArgument);
        Points plane(3, none);
        plane.positions[2].assign(plane.positions[2].size(), 5.0);
        VERIFY_ERROR(fitRigidBody(plane.vectors()), ErrorCode::InvalidArgument);
        Points bad(2, none);
        bad.deviations[1][3] = NAN;
        VERIFY_ERROR(fitRigidBody(bad.vectors()), ErrorCode::InvalidArgument);
        VERIFY_ERROR(
            fitRigidBody(Points(2, none).vectors(), {.alongAxis = 2}), ErrorCode::InvalidArgument);
    }
};

AXISCOMP_TEST(TestRigidBody)

} // namespace tst_rigidbody

#include "tst_rigidbody.moc"
