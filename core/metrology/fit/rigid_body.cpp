// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/rigid_body.h"

#include "core/metrology/fit/fit_errors.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

namespace axiscomp {

namespace {

using BodyIndex = Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

bool isCompleteField(const VectorDeviations& vectors)
{
    const auto isFinite = [](double number) { return std::isfinite(number); };
    const std::size_t count = vectors.positions[0].size();
    for (std::size_t axis = 0; axis < vectors.dimensions; ++axis) {
        const auto& positions = vectors.positions[axis];
        const auto& deviations = vectors.deviations[axis];
        if (positions.size() != count || deviations.size() != count
            || !std::ranges::all_of(positions, isFinite)
            || !std::ranges::all_of(deviations, isFinite))
            return false;
    }
    return true;
}

/// Columns of positions or deviations about their means; 0 for a dimension that is not there.
struct Centred {
    MatrixXd numbers;
    Vector3d mean = Vector3d::Zero();

    Centred(const std::array<std::span<const double>, 3>& columns, std::size_t dimensions)
        : numbers(MatrixXd::Zero(static_cast<BodyIndex>(columns[0].size()), 3))
    {
        for (std::size_t axis = 0; axis < dimensions; ++axis) {
            const auto column = static_cast<BodyIndex>(axis);
            for (std::size_t i = 0; i < columns[axis].size(); ++i)
                numbers(static_cast<BodyIndex>(i), column) = columns[axis][i];
            mean[column] = numbers.col(column).mean();
            numbers.col(column).array() -= mean[column];
        }
    }
};

/// The field of a unit rotation about each axis, and of a unit scale.
Vector3d unitField(BodyIndex parameter, const Vector3d& position)
{
    if (parameter == 3)
        return position;
    return Vector3d::Unit(parameter).cross(position);
}

/// Least squares of the free parameters (rotations 0 to 2, scale 3) to what the fixed ones leave.
void fitParameters(const MatrixXd& positions, const MatrixXd& deviations,
    const std::vector<BodyIndex>& parameters, Eigen::Vector4d& found)
{
    if (parameters.empty())
        return;
    const auto count = static_cast<BodyIndex>(parameters.size());
    MatrixXd normal = MatrixXd::Zero(count, count);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    for (BodyIndex point = 0; point < positions.rows(); ++point) {
        const Vector3d position = positions.row(point).transpose();
        Vector3d rest = deviations.row(point).transpose();
        for (BodyIndex parameter = 0; parameter < 4; ++parameter)
            rest -= found[parameter] * unitField(parameter, position);
        for (BodyIndex i = 0; i < count; ++i) {
            const Vector3d field = unitField(parameters[static_cast<std::size_t>(i)], position);
            right[i] += field.dot(rest);
            for (BodyIndex k = 0; k < count; ++k)
                normal(i, k) +=
                    field.dot(unitField(parameters[static_cast<std::size_t>(k)], position));
        }
    }
    const Eigen::VectorXd solution = normal.ldlt().solve(right);
    for (BodyIndex i = 0; i < count; ++i)
        found[parameters[static_cast<std::size_t>(i)]] += solution[i];
}

} // namespace

std::array<double, 3> RigidBody::at(const std::array<double, 3>& position) const
{
    const Vector3d p(position[0], position[1], position[2]);
    const Vector3d w(rotation[0], rotation[1], rotation[2]);
    const Vector3d d =
        Vector3d(translation[0], translation[1], translation[2]) + w.cross(p) + scale * p;
    return {d[0], d[1], d[2]};
}

Result<RigidBody> fitRigidBody(const VectorDeviations& vectors, const RigidBodyRequest& request)
{
    const bool isSpace = vectors.dimensions == 3;
    if ((!isSpace && vectors.dimensions != 2) || !isCompleteField(vectors)
        || request.alongAxis.value_or(0) >= vectors.dimensions)
        return badFit(AXISCOMP_TEXT("Error",
            "each point needs a finite position and deviation in two or three dimensions"));
    const Centred positions(vectors.positions, vectors.dimensions);
    const Centred deviations(vectors.deviations, vectors.dimensions);
    const auto size = static_cast<BodyIndex>(vectors.dimensions);
    const Eigen::ColPivHouseholderQR<MatrixXd> solver(positions.numbers.leftCols(size));
    if (positions.numbers.rows() <= size || solver.rank() < size)
        return badFit(AXISCOMP_TEXT("Error",
            "the points lie on a line, or on a plane in space, and cannot tell how the artefact "
            "lay; measure points beside it"));
    // slopes(b, a): of the deviation of axis a over the position of axis b
    Matrix3d slopes = Matrix3d::Zero();
    slopes.topLeftCorner(size, size) = solver.solve(deviations.numbers.leftCols(size));

    Eigen::Vector4d found = Eigen::Vector4d::Zero();
    std::vector<BodyIndex> free{2};
    if (isSpace)
        free = {0, 1, 2};
    if (request.alongAxis) {
        const auto a = static_cast<BodyIndex>(*request.alongAxis);
        for (BodyIndex b = 0; b < size; ++b) {
            if (b == a)
                continue;
            // the rotation about the third axis that moves b along a
            const BodyIndex about = 3 - a - b;
            const double sign = Vector3d::Unit(about).cross(Vector3d::Unit(a))[b];
            found[about] = sign * slopes(a, b);
            std::erase(free, about);
        }
    }
    if (request.fitsScale)
        free.push_back(3);
    fitParameters(positions.numbers, deviations.numbers, free, found);

    RigidBody body;
    body.rotation = {found[0], found[1], found[2]};
    body.scale = found[3];
    const auto atMean = body.at({positions.mean[0], positions.mean[1], positions.mean[2]});
    for (std::size_t axis = 0; axis < 3; ++axis)
        body.translation[axis] = deviations.mean[static_cast<BodyIndex>(axis)] - atMean[axis];
    body.squareness = {
        slopes(1, 0) + slopes(0, 1), slopes(2, 0) + slopes(0, 2), slopes(2, 1) + slopes(1, 2)};
    return body;
}

} // namespace axiscomp
