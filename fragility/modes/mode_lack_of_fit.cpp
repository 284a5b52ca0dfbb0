#include "fragility/modes/mode_lack_of_fit.hpp"

#include "fragility/laws/chi_squared.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fragility {

LackOfFit lack_of_fit(const ModeModel& model, const ModeData& data)
{
    if (model.coefficients.rows() + 1 != data.counts.cols())
        throw std::invalid_argument("lack of fit: the model has other modes than the data");
    LackOfFit f;
    for (Eigen::Index i = 0; i < data.counts.rows(); ++i) {
        const double walls = data.counts.row(i).sum();
        if (!(walls > 0.0)) continue;
        f.degrees += data.counts.cols() - 1;
        const Eigen::VectorXd p = mode_probabilities(model, data.covariates.row(i).transpose());
        for (Eigen::Index k = 0; k < p.size(); ++k) {
            const double n = data.counts(i, k);
            if (n > 0.0) f.deviance += 2.0 * n * std::log(n / (walls * p[k]));
        }
    }
    f.deviance = std::max(0.0, f.deviance);
    f.degrees = std::max<Eigen::Index>(0, f.degrees - model.coefficients.size());
    if (f.degrees > 0)
        f.p_value = chi_squared_survival(f.deviance, static_cast<double>(f.degrees));
    return f;
}

} // namespace fragility
