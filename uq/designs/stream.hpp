#pragma once
/// Random numbers keyed by (seed, sample, purpose): sample 17 is the same alone, in a batch, in
/// a shard, or when 50 samples grow to 500.
///
/// Philox 4x64-10 (Salmon, Moraes, Dror, Shaw 2011, Random123): a counter is enciphered, so any
/// draw of any stream is reached at once and no two streams overlap.

#include <array>
#include <cstdint>
#include <span>

namespace uq {

/// Purpose of random numbers. Each has a stream of its own, so that adding draws for one
/// purpose moves no other. Values are part of stored results: never renumber.
enum class Purpose : std::uint64_t {
    monte_carlo = 1,      ///< coordinates of independent samples
    strata = 2,           ///< order of the strata of a Latin hypercube; sample = variable
    place_in_stratum = 3, ///< where in its stratum a sample lies
    scramble = 4,         ///< scrambling of a low-discrepancy sequence
    annealing = 5,        ///< optimisation of a design
    extension = 6,        ///< strata given to new rows of a grown design
    dependence = 7,       ///< scores that bring rank correlation
    field = 8,            ///< coordinates of a random field
    bootstrap = 9,        ///< resampling of results
    markov_chain = 10,    ///< subset simulation
    importance = 11,      ///< importance sampling
    search = 12,          ///< starting points of optimisers
    replicate = 13,       ///< seeds of replicated designs
    prediction = 14       ///< errors of further tests
};

/// 64 random bits: draw `i` of a stream.
[[nodiscard]] std::uint64_t bits(std::uint64_t seed, std::uint64_t sample, Purpose purpose,
                                 std::uint64_t i);

/// One stream, read in order.
class Stream {
  public:
    Stream(std::uint64_t seed, std::uint64_t sample, Purpose purpose);
    /// 64 random bits; draw i is bits(seed, sample, purpose, i).
    std::uint64_t bits();
    /// In (0, 1), never 0 or 1: (k + 1/2) / 2^52, k = 0 .. 2^52 - 1, so that 1 - u is exact
    /// too.
    double uniform();
    /// In 0 .. n - 1, without bias (Lemire 2019); n >= 1.
    std::uint64_t below(std::uint64_t n);
    /// Fills each entry with uniform(): the same bits, faster.
    void fill_uniform(std::span<double> u);
    /// Standard normal, quantile of uniform().
    double normal();

  private:
    std::array<std::uint64_t, 2> key_;
    std::uint64_t sample_;
    std::uint64_t block_ = 0;
    std::array<std::uint64_t, 4> buffer_{};
    unsigned left_ = 0;
};

/// Seed of the r-th replicate of a study; 0 is the study itself.
[[nodiscard]] std::uint64_t replicate_seed(std::uint64_t seed, std::uint64_t r);

} // namespace uq
