#pragma once
/// Which limit states are read off curves: `limit_states` and `user_states` of a study file.

#include "app/input/study.hpp"
#include "fragility/limit_states.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace app {

/// A limit state of the user; its cap is a drift, a displacement once the wall is known.
struct UserState {
    fragility::UserLimitState state; ///< without cap
    double most_drift = 0.0;         ///< [-]; 0: no cap
};

struct WantedStates {
    std::vector<fragility::LimitStateSet> sets; ///< in the order asked for, each once
    std::vector<UserState> user;                ///< of the set user
    fragility::LimitStateOptions options;
};

/// "slight: 0.7 yield; heavy: 0.5 yield + 0.5 ultimate; crack: rise 0.33; half: drop 0.5; near: ultimate
/// or 1.0 %; far: 2 %". A drift after `or` is a cap: whichever comes first.
/// @throws BadValue naming the state and what is allowed
[[nodiscard]] std::vector<UserState> parse_user_states(std::string_view text);

/// @throws ConfigError at the key to change
[[nodiscard]] WantedStates wanted_states(const Study& study);

/// A limit state to read, before any wall.
struct StateName {
    std::string set;  ///< "paper", "ntc", "ec8", "user"
    std::string name; ///< "SLV"
    std::string rule; ///< how it is read: "3/4 of SLC"
};
[[nodiscard]] std::vector<StateName> state_names(const WantedStates& wanted);

/// In the order of state_names. Nothing is defined on a push that turns back.
/// @param height of the load line [m], of drifts
/// @return displacements [m]; reasons live as long as the program
[[nodiscard]] std::vector<fragility::LimitDisplacement>
read_states(const fragility::Curve& curve, const WantedStates& wanted, double height);

} // namespace app
