// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fit/grid_points.h"

#include <memory>
#include <stop_token>
#include <vector>

namespace axiscomp {

/// The normal equations of grid_fit: sum over points of w_k B_k^T B_k, and L D^T D. Each node has
/// coefficients for itself and for half of the neighbours that share a cell with it, the other half
/// being the same by symmetry; second neighbours have one constant for each axis.
class GridSystem {
public:
    explicit GridSystem(const Grid& grid);
    ~GridSystem();
    GridSystem(const GridSystem&) = delete;
    GridSystem& operator=(const GridSystem&) = delete;

    /// Takes these points in place of those before. weights: one for each point, beside its own;
    /// empty: 1. A weight of 0 leaves a point out.
    void setPoints(const std::vector<GridPoint>& points, std::span<const double> weights = {});
    /// The sum of the weights.
    [[nodiscard]] double weight() const { return m_weight; }

    /// The nodes for a smoothness S, L = S weight / nodes; begins with `nodes` and leaves the
    /// solution there. tolerance: of the residual of the equations, relative. Errors: NotConverged,
    /// Cancelled.
    [[nodiscard]] Result<void> solve(
        double smoothness, double tolerance, std::stop_token stop, std::vector<double>& nodes);

private:
    class Preconditioner;
    struct Neighbour {
        std::array<int, 3> step{};
        std::ptrdiff_t offset = 0;
    };
    using Numbers = std::vector<double>;

    void setPenalty(double penalty);
    [[nodiscard]] double penaltyBetween(
        const std::array<std::size_t, 3>& place, const std::array<int, 3>& step) const;
    void multiply(const Numbers& x, Numbers& y) const;
    void multiplyNeighbours(std::size_t j, std::size_t k, const Numbers& x, Numbers& y) const;
    void multiplySecondNeighbours(std::size_t j, std::size_t k, const Numbers& x, Numbers& y) const;
    [[nodiscard]] bool isDiagonal() const;
    [[nodiscard]] Result<void> solveDirectly(Numbers& nodes) const;
    [[nodiscard]] Result<bool> iterate(
        double tolerance, std::stop_token stop, int mostSteps, Numbers& nodes) const;

    GridShape m_shape;
    std::array<double, 3> m_along{}; ///< (h / h_a)^4
    std::array<std::array<double, 3>, 3> m_across{}; ///< 2 (h^2 / (h_a h_b))^2
    std::vector<Neighbour> m_neighbours; ///< the first is the node itself
    std::array<std::array<std::size_t, 8>, 8> m_neighbourOfCorners{};
    std::vector<Numbers> m_data; ///< for each neighbour, by nodes
    std::vector<Numbers> m_matrix; ///< the same with the penalty
    Numbers m_right;
    double m_weight = 0.0;
    double m_penalty = 0.0;
    std::unique_ptr<Preconditioner> m_preconditioner;
};

} // namespace axiscomp
