#pragma once
/// Distributions of a study file, from text: "lognormal(mean 3.7 MPa, cov 0.30)".

#include "uq/marginals/marginal.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Whether a value is meant as a distribution: a word followed by "(".
[[nodiscard]] bool is_distribution(std::string_view text);

/// A name and its parameters, each a word and a value; those that are quantities with a unit:
///   normal, lognormal, gumbel, gamma, weibull   mean, and cov or sd
///   lognormal                                   or median, sigma_log
///   weibull                                     or shape, scale
///   uniform                                     lower, upper
///   triangular                                  lower, mode, upper
///   beta                                        mean, cov or sd, lower, upper
///   empirical                                   values: empirical(3.1, 3.4, 4.0 MPa)
/// and, after those of any of them, `from` and `to`: cut off outside and scaled up to one.
/// @param unit as parse_quantity
/// @return in SI
/// @throws BadValue
[[nodiscard]] uq::Marginal parse_distribution(std::string_view text, std::string_view unit);

/// The values of empirical(...) in the order in which they stand there, in SI; nothing for
/// another distribution.
/// @throws BadValue
[[nodiscard]] std::vector<double> empirical_values(std::string_view text,
                                                   std::string_view unit);

/// The same distribution in a fixed form: parameters by name, each number as short as it can
/// be, in `unit`. However the numbers of a distribution were written, this text is the same.
/// @param text of a distribution that parse_distribution takes
[[nodiscard]] std::string canonical_distribution(std::string_view text, std::string_view unit);

/// Names and parameters, for help.
[[nodiscard]] std::string distribution_help();

} // namespace app
