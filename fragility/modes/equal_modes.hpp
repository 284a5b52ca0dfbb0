#pragma once
/// The value of one covariate at which two failure modes are equally likely.

#include "core/interval.hpp"
#include "fragility/modes/mode_model.hpp"

namespace fragility {

struct EqualModes {
    bool found = false;
    std::string reason;     ///< why not
    double at = 0.0;        ///< [unit of the covariate]
    double std_error = 0.0; ///< delta method
    core::Interval delta{}; ///< at +- z std_error
    core::Interval
        fieller{}; ///< all values at which the difference is not significant; both ends
                   ///< infinite where the slope itself is not significant
    core::Interval
        profile{}; ///< likelihood ratio; an end further than 40 standard errors away is
                   ///< infinite. Of a penalised model: [-infinity, infinity]
};

/// @param covariates  the others at which it is asked for; the entry of `which` is not read
/// @param data        that of the model
/// @throws std::invalid_argument if there is no model, for modes or covariates that it does not
/// have, equal modes, a confidence not in (0, 1)
[[nodiscard]] EqualModes equal_modes(const ModeModel& model, const ModeData& data, int mode_a,
                                     int mode_b, int which, const Eigen::VectorXd& covariates,
                                     double confidence = 0.95);

} // namespace fragility
