#pragma once
/// A reliability analysis, of a wall or of another program.

#include "dem/block/discretisation.hpp"
#include "uq/reliability/reliability_method.hpp"

#include <string>

namespace app {

using uq::ReliabilityMethod;

/// For the verb reliability: the probability that a response falls to a demand or below.
struct ReliabilityInput {
    ReliabilityMethod method = ReliabilityMethod::monte_carlo;
    int response = 0;         ///< row of kWallNumbers (app/reading/wall_numbers.hpp)
    std::string demand;       ///< "40 kN", "15 mm", or a drift in percent: "1.2"
    double quantile = 0.0;    ///< asked for in place of a demand [-]; 0: none
    int budget = 1000;        ///< evaluations at most, >= 10
    double target_cov = 0.10; ///< stop once the probability is known as well [-]
    dem::Fidelity cheap = dem::Fidelity::rigid; ///< of the cheap model
};

enum class KeepRuns { none, failed, all };

/// For the verb reliability: another program in place of a wall (docs/external_program.md).
struct ProgramInput {
    std::string command;            ///< program and arguments
    std::string responses;          ///< names of what it answers, between commas
    int concurrent = 0;             ///< runs at a time; 0: as many as threads
    double time_limit = 0.0;        ///< of one run [s]; 0: none
    double grace = 2.0;             ///< from SIGTERM to SIGKILL [s]
    int retries = 0;                ///< of a run that failed
    KeepRuns keep = KeepRuns::none; ///< directories of runs
    std::string response;           ///< one of `responses`; empty: the first
    double demand = 0.0;            ///< in the unit of the program
    bool above = false;             ///< the event is to reach the demand, else to fall to it
};

} // namespace app
