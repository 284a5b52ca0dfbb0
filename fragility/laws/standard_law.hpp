#pragma once
/// Standard laws of z = (y - location) / dispersion: log densities, log tails and log
/// probabilities of intervals with two derivatives each, safe far out in the tails. Their
/// densities are log-concave, so all of these are concave.

namespace fragility {

/// A function of z and its derivatives.
struct LogTerm {
    double value, d1, d2;
};

/// ln P(m - h/2 < Z < m + h/2) and its derivatives for the middle m and the width h.
struct LogBetween {
    double value, m, h, mm, mh, hh;
};

/// Normal: the law of ln x of a lognormal x.
struct StandardNormal {
    [[nodiscard]] static LogTerm log_density(double z);
    [[nodiscard]] static LogTerm log_survival(double z);             ///< ln P(Z > z)
    [[nodiscard]] static LogTerm log_cdf(double z);                  ///< ln P(Z < z)
    [[nodiscard]] static LogBetween log_between(double m, double h); ///< h > 0
    [[nodiscard]] static double cdf(double z);
    [[nodiscard]] static double survival(double z);
    [[nodiscard]] static double quantile(double p); ///< p in (0, 1)
};

/// Smallest extreme value, F = 1 - exp(-e^z): the law of ln x of a Weibull x.
struct SmallestExtreme {
    [[nodiscard]] static LogTerm log_density(double z);
    [[nodiscard]] static LogTerm log_survival(double z);
    [[nodiscard]] static LogTerm log_cdf(double z);
    [[nodiscard]] static LogBetween log_between(double m, double h);
    [[nodiscard]] static double cdf(double z);
    [[nodiscard]] static double survival(double z);
    [[nodiscard]] static double quantile(double p);
};

/// Logistic, F = 1 / (1 + e^-z): the other link of binary fits.
struct StandardLogistic {
    [[nodiscard]] static LogTerm log_survival(double z);
    [[nodiscard]] static LogTerm log_cdf(double z);
    [[nodiscard]] static double cdf(double z);
};

} // namespace fragility
