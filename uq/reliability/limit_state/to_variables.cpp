#include "uq/reliability/limit_state/to_variables.hpp"

#include <cstddef>
#include <stdexcept>
#include <utility>

namespace uq {

Map to_variables(std::vector<Marginal> variables, const std::optional<NormalCopula>& dependence)
{
    const auto d = static_cast<Eigen::Index>(variables.size());
    const Eigen::MatrixXd factor =
        dependence ? dependence->factor : Eigen::MatrixXd(Eigen::MatrixXd::Identity(d, d));
    if (factor.rows() != d)
        throw std::invalid_argument("to_variables: the dependence is of " +
                                    std::to_string(factor.rows()) +
                                    " variables, but there are " + std::to_string(d));
    return [factor, variables = std::move(variables)](const Eigen::MatrixXd& u) {
        Eigen::MatrixXd x = u * factor.transpose();
        for (std::size_t j = 0; j < variables.size(); ++j)
            for (double& value : x.col(static_cast<Eigen::Index>(j)))
                value = from_normal(variables[j], value);
        return x;
    };
}

} // namespace uq
