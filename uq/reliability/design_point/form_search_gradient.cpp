#include "uq/reliability/design_point/form_search_gradient.hpp"

namespace uq {

std::optional<LinearLimit> linearise(const LimitState& s, const Eigen::VectorXd& u, double step,
                                     Ledger& ledger)
{
    const Eigen::Index d = u.size();
    Eigen::MatrixXd points = u.transpose().replicate(2 * d + 1, 1);
    for (Eigen::Index i = 0; i < d; ++i) {
        points(1 + i, i) += step;
        points(1 + d + i, i) -= step;
    }
    const Eigen::VectorXd g = limit_values(s, points, ledger);
    if (g.hasNaN()) return std::nullopt;
    return LinearLimit{u, g(0), (g.segment(1, d) - g.tail(d)) / (2.0 * step)};
}

double distance_to_plane(const LinearLimit& l) { return l.g / l.gradient.norm(); }

Eigen::VectorXd direction(const LinearLimit& l) { return -l.gradient / l.gradient.norm(); }

double off_axis(const LinearLimit& l)
{
    const Eigen::VectorXd alpha = direction(l);
    return (l.u - alpha.dot(l.u) * alpha).norm();
}

} // namespace uq
