/// Random fields: time to build a basis and to draw many samples, against OpenTURNS where it is
/// installed. OPENBLAS_NUM_THREADS=1 uq_fields OUT.md
#include "bench/uq/uq_fields.hpp"

#include "bench/report.hpp"
#include "core/normal.hpp"
#include "uq/designs/stream.hpp"
#include "uq/fields/field.hpp"
#include "uq/fields/kernel.hpp"

#include <cstdio>
#include <exception>

namespace {

constexpr int kRepeats = 25;
constexpr Eigen::Index kSamples = 1000;

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
app::Row row(const std::string& task, double own, double other, bool compared)
{
    if (!compared || other < 0.0) return {task, number(own), "", ""};
    return {task, number(own), number(other), number(other / own, "%.1f")};
}

/// Standard normal coordinates of samples 0 .. n - 1, each read off its own stream.
Eigen::MatrixXd coordinates(Eigen::Index n, Eigen::Index count)
{
    Eigen::MatrixXd z(n, count);
    std::vector<double> row(static_cast<std::size_t>(count));
    for (Eigen::Index i = 0; i < n; ++i) {
        uq::Stream stream(1, static_cast<std::uint64_t>(i), uq::Purpose::field);
        stream.fill_uniform(row);
        z.row(i) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), count);
    }
    core::to_normal_quantiles({z.data(), static_cast<std::size_t>(z.size())});
    return z;
}

struct OwnTimes {
    double matrix, cholesky, build_and_one, coordinates, fields, thousand;
};

OwnTimes own_times(const std::vector<uq::Site>& s)
{
    const uq::Kernel kernel{{uq::Exponential{bench::kFieldLength}}};
    const auto p = static_cast<Eigen::Index>(s.size());
    Eigen::MatrixXd r, z, g;
    uq::FieldBasis basis;
    const auto time = [](auto run) { return bench::cpu_ms(kRepeats, run); };
    const auto build = [&] { basis = uq::cholesky_basis(uq::correlation_matrix(kernel, s)); };
    OwnTimes t{};
    t.matrix = time([&] { r = uq::correlation_matrix(kernel, s); });
    t.cholesky = time([&] { basis = uq::cholesky_basis(r); });
    t.build_and_one = time([&] {
        build();
        g = uq::realise(basis, coordinates(1, p));
    });
    t.coordinates = time([&] { z = coordinates(kSamples, p); });
    t.fields = time([&] { g = uq::realise(basis, z); });
    t.thousand = time([&] {
        build();
        g = uq::realise(basis, coordinates(kSamples, p));
    });
    return t;
}

bench::Report report(const OwnTimes& t, const bench::OtherTimes& o, double difference)
{
    const bool both = !o.name.empty();
    app::Table table;
    table.caption =
        "CPU time of the process, shortest of " + std::to_string(kRepeats) + " runs";
    table.head = {"task", "own [ms]", (both ? o.name : "OpenTURNS") + " [ms]", "ratio"};
    table.rows = {row("correlation matrix", t.matrix, o.matrix, both),
                  row("Cholesky factor", t.cholesky, o.cholesky, both),
                  row("matrix, factor, one field", t.build_and_one, o.build_and_one, both),
                  row("normal coordinates of 1000 fields (here keyed)", t.coordinates,
                      o.coordinates, both),
                  row("1000 fields from given coordinates", t.fields, -1.0, both),
                  row("matrix, factor, coordinates, 1000 fields", t.thousand, o.thousand, both),
                  row("the same less the coordinates", t.thousand - t.coordinates,
                      o.thousand - o.coordinates, both)};
    bench::Report r;
    r.title = "Random fields";
    r.opening = "15 x 12 sites, as many as the joints of the paper's wall, correlation exp(-d "
                "/ 1 m), one "
                "thread. Both\nmultiply a triangle by standard normal coordinates; here eight "
                "samples side "
                "by side, in plain products and\nsums, so that a sample has the same bits "
                "alone and in any "
                "batch. Coordinates are read off a stream keyed by\nsample through the normal "
                "quantile. With OpenTURNS: OPENBLAS_NUM_THREADS=1.";
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
