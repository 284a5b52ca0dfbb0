#pragma once
/// The map of a limit state whose inputs are random variables.

#include "uq/designs/normal_copula.hpp"
#include "uq/marginals/marginal.hpp"
#include "uq/reliability/limit_state/limit_state.hpp"

#include <optional>
#include <vector>

namespace uq {

/// Independent standard normal u to the variables: x_i = F_i^-1(Phi((A u)_i)), A A' = rho_z.
/// @param dependence of the variables; without it they are independent
/// @throws std::invalid_argument if the sizes differ
[[nodiscard]] Map to_variables(std::vector<Marginal> variables,
                               const std::optional<NormalCopula>& dependence = {});

} // namespace uq
