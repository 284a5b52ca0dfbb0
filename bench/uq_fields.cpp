/// Random fields: time to build a basis and to draw many samples, against OpenTURNS where it is
/// installed. OPENBLAS_NUM_THREADS=1 uq_fields OUT.md
#include "bench/uq_fields.hpp"

#include "bench/report.hpp"
#include "uq/fields/field.hpp"
#include "uq/fields/field_marginal.hpp"
#include "uq/fields/karhunen.hpp"
#include "uq/fields/kernel.hpp"

#include <cstdio>
#include <exception>
#include <numeric>

namespace {

constexpr int kRepeats = 25;
constexpr std::size_t kSamples = 1000;

std::vector<uq::Site> sites()
{
    std::vector<uq::Site> s;
    for (int k = 0; k < bench::kFieldRows; ++k)
        for (int i = 0; i < bench::kFieldColumns; ++i)
            s.push_back({i * bench::kFieldDx, k * bench::kFieldDz, 0, k});
    return s;
}

std::string number(double x, const char* format = "%.3f")
{
    char text[40];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

/// One row of the table; `other` < 0: the other library has no such task.
std::vector<std::string> row(const std::string& task, double own, double other, bool compared)
{
    if (!compared || other < 0.0) return {task, number(own), "", ""};
    return {task, number(own), number(other), number(other / own, "%.1f")};
}

struct OwnTimes {
    double matrix, cholesky, karhunen, build_and_one, coordinates, fields, thousand, translated;
};

OwnTimes own_times(const std::vector<uq::Site>& s)
{
    const uq::Kernel kernel{{uq::Exponential{bench::kFieldLength}}};
    const auto p = static_cast<Eigen::Index>(s.size());
    std::vector<std::uint64_t> id(kSamples);
    std::iota(id.begin(), id.end(), 0u);
    Eigen::MatrixXd r, z, g;
    uq::FieldBasis basis;
    const auto time = [](auto run) { return bench::cpu_ms(kRepeats, run); };
    const auto build = [&] { basis = uq::cholesky_basis(uq::correlation_matrix(kernel, s)); };
    OwnTimes t{};
    t.matrix = time([&] { r = uq::correlation_matrix(kernel, s); });
    t.cholesky = time([&] { basis = uq::cholesky_basis(r); });
    t.karhunen = time([&] { basis = uq::karhunen_basis(r); });
    t.build_and_one = time([&] {
        build();
        g = uq::realise(basis, uq::field_coordinates(1, std::span(id).first(1), p));
    });
    t.coordinates = time([&] { z = uq::field_coordinates(1, id, p); });
    t.fields = time([&] { g = uq::realise(basis, z); });
    t.thousand = time([&] {
        build();
        g = uq::realise(basis, uq::field_coordinates(1, id, p));
    });
    const uq::Marginal strength{uq::lognormal_from_moments(3.7, 0.30)};
    t.translated = time([&] { z = uq::translate(g, strength); });
    return t;
}

bench::Report report(const OwnTimes& t, const bench::OtherTimes& o, double difference)
{
    const bool both = !o.name.empty();
    app::Table table{"CPU time of the process, shortest of " + std::to_string(kRepeats) +
                         " runs",
                     {"task", "own [ms]", (both ? o.name : "OpenTURNS") + " [ms]", "ratio"},
                     {}};
    table.rows = {row("correlation matrix", t.matrix, o.matrix, both),
                  row("Cholesky factor", t.cholesky, o.cholesky, both),
                  row("eigenvalues and modes of the matrix", t.karhunen, o.karhunen, both),
                  row("matrix, factor, one field", t.build_and_one, o.build_and_one, both),
                  row("normal coordinates of 1000 fields (here keyed)", t.coordinates,
                      o.coordinates, both),
                  row("1000 fields from given coordinates", t.fields, -1.0, both),
                  row("matrix, factor, coordinates, 1000 fields", t.thousand, o.thousand, both),
                  row("the same less the coordinates", t.thousand - t.coordinates,
                      o.thousand - o.coordinates, both),
                  row("lognormal values of 1000 fields", t.translated, -1.0, both)};
    bench::Report r;
    r.title = "Random fields";
    r.command = "OPENBLAS_NUM_THREADS=1 build/release/bench/uq_fields docs/bench/uq_fields.md";
    r.opening = "15 x 12 sites, as many as the joints of the paper's wall, correlation exp(-d "
                "/ 1 m), one "
                "thread. Both\nmultiply a triangle by standard normal coordinates; here eight "
                "samples side "
                "by side, in plain products and\nsums, so that a sample has the same bits "
                "alone and in any "
                "batch. Coordinates are read off a stream keyed by\nsample through the normal "
                "quantile.";
    if (both)
        r.opening += " Largest difference of the two correlation matrices: " +
                     number(difference, "%.1e") + ".";
    r.sections.push_back({"", "", "", table});
    return r;
}

} // namespace

int main(int argc, char** argv)
try {
    if (argc != 2) {
        std::fputs("usage: uq_fields OUT.md\n", stderr);
        return 2;
    }
    const std::vector<uq::Site> s = sites();
    const OwnTimes own = own_times(s);
    const bench::OtherTimes other = bench::other_times(kRepeats);
    const Eigen::MatrixXd r =
        uq::correlation_matrix({{uq::Exponential{bench::kFieldLength}}}, s);
    const double difference =
        other.name.empty() ? 0.0 : (r - other.correlation).cwiseAbs().maxCoeff();
    const bench::Report result = report(own, other, difference);
    bench::write_report(argv[1], result);
    std::puts(bench::as_markdown(result).c_str());
    return difference < 1e-14 ? 0 : 1;
} catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
}
