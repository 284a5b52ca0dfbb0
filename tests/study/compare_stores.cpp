/// compare_stores A.h5 B.h5 [first N samples]: 0 if both hold the same walls with the same
/// results, bit for bit; costs aside. With N: the walls of samples 0 .. N - 1 of A are those of
/// B.

#include "app/store/store_reader.hpp"
#include "tests/scenes/same_results.hpp"

#include <cstdlib>
#include <iostream>
#include <optional>

namespace {

int fail(const app::WallKey& key, const char* why)
{
    std::cerr << "level " << key.level << ", sample " << key.sample << ": " << why << '\n';
    return 1;
}

int compare(app::StoreReader& a, app::StoreReader& b, std::uint32_t samples)
{
    std::size_t seen = 0;
    for (std::size_t i = 0; i < a.statuses().size(); ++i) {
        const app::WallKey key = a.statuses()[i].key;
        if (key.sample >= samples) continue;
        const std::optional<app::WallRow> other = b.row(key);
        if (!other) return fail(key, "only in the first");
        if (!scenes::same_results(a.row(i), *other)) return fail(key, "results differ");
        ++seen;
    }
    for (const app::WallStatus& s : b.statuses())
        if (s.key.sample < samples && !a.row(s.key)) return fail(s.key, "only in the second");
    std::cout << seen << " walls, the same bits\n";
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 3) return 2;
    try {
        app::StoreReader a(argv[1]), b(argv[2]);
        const auto samples =
            argc > 3 ? static_cast<std::uint32_t>(std::atoi(argv[3])) : UINT32_MAX;
        return compare(a, b, samples);
    } catch (const std::exception& e) {
        std::cerr << e.what() << '\n';
        return 1;
    }
}
