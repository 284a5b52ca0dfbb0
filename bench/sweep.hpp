#pragma once
/// Many pushes of the paper's wall, read the same way, as ensembles.

#include "dem/block/discretisation.hpp"
#include "dem/solver/ensemble.hpp"
#include "scenes/paper_wall.hpp"

#include <vector>

namespace bench {

struct Case {
    scenes::Scene scene;
    dem::Discretisation discretisation;
    dem::SolverOptions solver;
    double record_every = 5e-5; ///< [m]
    int sample = -1;            ///< of Table 5; -1: the mean values
    bool spatial = false;       ///< one draw per joint
};

struct Answer {
    double peak = 0.0;     ///< [N]
    double at_peak = 0.0;  ///< [m]
    double ultimate = 0.0; ///< 80 % of the peak, first crossing [m]
    bool censored = false; ///< no such drop: ultimate is the last displacement
    double at_30mm = 0.0;  ///< force at the end [N]
    double residual = 0.0; ///< largest energy residual [-]
    int cracked_units = 0;
    bool mixed = false;
    bool failed = false;
    long long steps = 0;
    double seconds = 0.0; ///< of one core, solver alone
};

/// Answers in the order of the cases; cases that differ in materials and stress alone share a
/// model and run side by side. Prints a line of progress to stderr.
[[nodiscard]] std::vector<Answer> run_all(const std::vector<Case>& cases,
                                          const dem::Workers& workers = {});

[[nodiscard]] dem::WallMaterials case_materials(const Case& c, const dem::Model& model);

struct Moments {
    double mean = 0.0;
    double cov = 0.0;
    int n = 0;
};
[[nodiscard]] Moments moments(const std::vector<double>& values);

} // namespace bench
