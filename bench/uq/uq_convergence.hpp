#pragma once
/// Responses of the paper's five random variables whose means are known.

#include <Eigen/Core>

#include <string>
#include <vector>

namespace bench {

/// Inputs of Table 5 for a design on the unit cube: n x 5, columns kn_joint [-], kn_unit [-],
/// ft_unit [MPa], phi_unit [deg], phi_joint [deg] with the distributions of Table 5, not cut.
[[nodiscard]] Eigen::MatrixXd table5(const Eigen::MatrixXd& unit_cube);

struct KnownResponse {
    std::string name;
    Eigen::VectorXd (*evaluate)(const Eigen::MatrixXd& x);
    double mean; ///< exact
};

/// Smooth: products and curved functions of all five. Kinked: the weaker of two mechanisms, one
/// of them growing with a weighted sum of the variables. Indicator: the share of walls for
/// which that sum is below a limit, as a mode of failure is counted.
[[nodiscard]] std::vector<KnownResponse> known_responses();

} // namespace bench
