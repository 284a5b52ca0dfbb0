#pragma once
/// Random fields over 180 sites: the scene and the tasks that are timed.

#include <Eigen/Core>

#include <ctime>
#include <limits>
#include <string>
#include <vector>

namespace bench {

/// 15 x 12 sites, 0.25 m x 0.20 m apart, as many as the joints of the paper's wall; correlation
/// exp(-d / 1 m).
constexpr int kFieldColumns = 15, kFieldRows = 12;
constexpr double kFieldDx = 0.25, kFieldDz = 0.20, kFieldLength = 1.0; ///< [m]

/// Shortest CPU time of some runs [ms]; of the whole process, so that threads cannot hide work.
template <class F> [[nodiscard]] double cpu_ms(int repeats, F run)
{
    double best = std::numeric_limits<double>::max();
    for (int i = 0; i < repeats; ++i) {
        const std::clock_t start = std::clock();
        run();
        const double ms = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        best = ms < best ? ms : best;
    }
    return best;
}

/// Times of another library for the same tasks [ms].
struct OtherTimes {
    std::string name; ///< empty: not installed
    double matrix, cholesky, build_and_one, coordinates, thousand;
    Eigen::MatrixXd correlation; ///< for comparison
};
[[nodiscard]] OtherTimes other_times(int repeats);

} // namespace bench
