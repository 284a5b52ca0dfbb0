#include "uq/estimates/replicate.hpp"

#include "uq/designs/stream.hpp"

namespace uq {

Estimate combine_replicates(std::span<const double> estimates, double confidence)
{
    return estimate_mean(estimates, confidence);
}

Replicates replicate(std::size_t count, std::uint64_t seed,
                     const std::function<double(std::uint64_t seed)>& one, double confidence)
{
    std::vector<double> each;
    each.reserve(count);
    for (std::size_t r = 0; r < count; ++r) each.push_back(one(replicate_seed(seed, r)));
    return {combine_replicates(each, confidence), std::move(each)};
}

} // namespace uq
