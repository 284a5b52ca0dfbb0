#include "tests/app/store/store_scene.hpp"
#include "tests/scenes/same_results.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace scenes {

namespace {

std::uint64_t mixed(std::uint64_t x) // splitmix64, Steele, Lea and Flood 2014
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// In (-1, 1), and now and then something special.
double number(std::uint64_t key)
{
    const std::uint64_t bits = mixed(key);
    switch (bits % 101) {
    case 0:
        return std::numeric_limits<double>::quiet_NaN();
    case 1:
        return -0.0;
    case 2:
        return std::numeric_limits<double>::infinity();
    case 3:
        return std::numeric_limits<double>::denorm_min();
    default:
        return static_cast<double>(static_cast<std::int64_t>(bits)) / 9.3e18;
    }
}

std::vector<double> numbers(std::uint64_t key, std::size_t n)
{
    std::vector<double> values(n);
    for (std::size_t i = 0; i < n; ++i) values[i] = number(key * 1000003 + i);
    return values;
}

/// None is NaN or infinite.
std::vector<double> finite_numbers(std::uint64_t key, std::size_t n)
{
    std::vector<double> values = numbers(key, n);
    for (double& v : values) v = std::isfinite(v) ? v : 1e29;
    return values;
}

} // namespace

app::StoreHead store_head(std::uint32_t samples)
{
    app::StoreHead head;
    head.configuration = "[wall]\nlength = 1.0 m\n# \xc3\xa9t\xc3\xa9\n";
    head.identity = "length = 1\nfriction = normal(0.6, 0.2)\n";
    head.levels = {{0.15e6, samples}, {0.5e6, samples}, {1.25e6, samples}};
    head.design_sizes = {samples};
    head.seed = 18446744073709551615u;
    for (const char* name : {"kn", "ft", "phi[1]", "phi[2]"})
        head.inputs.push_back({name, "-", "an input"});
    head.responses = {{"peak_force", "N", "largest force"},
                      {"ultimate_displacement", "m", "at 80 % of it"},
                      {"energy_residual", "-", ""}};
    head.counts = {{"steps", "-", "of the solver"}, {"cracked_units", "-", ""}};
    head.cost = {{"seconds", "s", "CPU time"}};
    head.sessions = {
        {"0.1.0", "a machine", "g++ 12, release", "2 threads", "2026-01-01T00:00", "2"}};
    return head;
}

app::WallRow store_row(app::WallKey key, std::size_t points)
{
    const std::uint64_t id = key.level * 1000000007ull + key.sample;
    app::WallRow row;
    row.key = key;
    const bool failed = id % 7 == 3;
    row.status = failed ? 5 : app::kWallOk;
    if (failed) row.reason = "no equilibrium at " + std::to_string(id % 1000) + " \xc2\xb5m";
    row.inputs = finite_numbers(id, 4);
    row.responses = numbers(id + 1, 3);
    row.counts = {static_cast<std::int64_t>(mixed(id)), -1};
    row.cost = numbers(id + 2, 1);
    const std::size_t n = failed ? 0 : points + id % 3;
    row.curve = {finite_numbers(id + 3, n), finite_numbers(id + 4, n)};
    return row;
}

std::vector<app::WallRow> store_rows(std::uint32_t first, std::uint32_t last,
                                     std::size_t points)
{
    std::vector<app::WallRow> rows;
    for (std::uint32_t sample = last; sample > first; --sample)
        for (std::uint32_t level : {1u, 0u, 2u})
            rows.push_back(store_row({level, sample - 1}, points));
    return rows;
}

std::size_t check_rows(const std::filesystem::path& file, std::size_t points)
{
    app::StoreReader reader(file);
    std::size_t n = 0, wrong = 0;
    reader.for_each_row([&](const app::WallRow& row) {
        const app::WallRow wanted = store_row(row.key, points);
        const bool same_cost =
            std::memcmp(row.cost.data(), wanted.cost.data(), sizeof(double)) == 0;
        if (!scenes::same_results(row, wanted) || !same_cost) ++wrong;
        if (row.key != reader.statuses()[n].key || row.status != reader.statuses()[n].status)
            ++wrong;
        ++n;
    });
    CHECK(wrong == 0);
    CHECK(n == reader.statuses().size());
    CHECK(std::ranges::is_sorted(reader.statuses(), {}, &app::WallStatus::key));
    return n;
}

} // namespace scenes
