#include "uq/designs/stream.hpp"

#include "core/normal.hpp"

#include <Random123/philox.h>

namespace uq {

namespace {

std::array<std::uint64_t, 4> block(std::array<std::uint64_t, 2> key, std::uint64_t sample,
                                   std::uint64_t number)
{
    const r123::Philox4x64::ctr_type counter = {{number, sample, 0, 0}};
    const r123::Philox4x64::key_type k = {{key[0], key[1]}};
    const auto out = r123::Philox4x64{}(counter, k);
    return {out[0], out[1], out[2], out[3]};
}

/// (k + 1/2) / 2^52 of the upper 52 bits
double unit(std::uint64_t bits) { return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52; }

} // namespace

std::uint64_t bits(std::uint64_t seed, std::uint64_t sample, Purpose purpose, std::uint64_t i)
{
    return block({seed, static_cast<std::uint64_t>(purpose)}, sample, i / 4)[i % 4];
}

Stream::Stream(std::uint64_t seed, std::uint64_t sample, Purpose purpose)
    : key_{seed, static_cast<std::uint64_t>(purpose)}, sample_(sample)
{
}

std::uint64_t Stream::bits()
{
    if (left_ == 0) {
        buffer_ = block(key_, sample_, block_++);
        left_ = 4;
    }
    return buffer_[4 - left_--];
}

double Stream::uniform() { return unit(bits()); }

void Stream::fill_uniform(std::span<double> u)
{
    std::size_t i = 0;
    while (i < u.size() && left_ > 0) u[i++] = uniform();
    for (; i + 4 <= u.size(); i += 4) { // whole blocks: no buffer between them
        const auto four = block(key_, sample_, block_++);
        for (std::size_t k = 0; k < 4; ++k) u[i + k] = unit(four[k]);
    }
    while (i < u.size()) u[i++] = uniform();
}

std::uint64_t Stream::below(std::uint64_t n)
{
    __extension__ using Wide = unsigned __int128;
    Wide product = static_cast<Wide>(bits()) * n;
    if (static_cast<std::uint64_t>(product) < n) { // seldom: spares the remainder
        const std::uint64_t rejected = -n % n; // of the 2^64 values, so that n divides the rest
        while (static_cast<std::uint64_t>(product) < rejected)
            product = static_cast<Wide>(bits()) * n;
    }
    return static_cast<std::uint64_t>(product >> 64);
}

double Stream::normal() { return core::normal_quantile(uniform()); }

std::uint64_t replicate_seed(std::uint64_t seed, std::uint64_t r)
{
    return r == 0 ? seed : uq::bits(seed, r, Purpose::replicate, 0);
}

} // namespace uq
