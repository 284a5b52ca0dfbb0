#include "python/src/piers.hpp"

#include "app/study/pushed/pier_reading.hpp"
#include "python/src/arrays.hpp"

#include <string>
#include <utility>

namespace bindings {
namespace {

namespace py = pybind11;

/// A column of numbers of parts: piers, spandrels, places.
template <class Part, class Read>
void add_column(py::dict& columns, const char* name, const std::vector<Part>& parts, Read read)
{
    std::vector<double> numbers;
    for (const Part& p : parts) numbers.push_back(read(p));
    columns[name] = array_of(std::move(numbers));
}

/// Sides of the rectangle that a part fills.
template <class Part, class At>
void add_place(py::dict& columns, const std::vector<Part>& parts, At at)
{
    add_column(columns, "from", parts, [&](const Part& p) { return at(p).x0; });
    add_column(columns, "to", parts, [&](const Part& p) { return at(p).x1; });
    add_column(columns, "bottom", parts, [&](const Part& p) { return at(p).z0; });
    add_column(columns, "top", parts, [&](const Part& p) { return at(p).z1; });
}

} // namespace

py::dict piers_of_wall(const WallOfStudy& w)
{
    using Pier = const app::PierReading&;
    const std::vector<app::PierReading>& piers = w.wall.piers;
    py::dict columns;
    const auto add = [&](const char* name, auto read) {
        add_column(columns, name, piers, read);
    };
    add_place(columns, piers, [](Pier p) { return p.pier.at; });
    add("storey", [](Pier p) { return p.pier.storey; });
    add("normal_before", [](Pier p) { return p.facts.normal_before; });
    add("normal_at_peak", [](Pier p) { return p.facts.normal_at_peak; });
    add("shear_at_peak", [](Pier p) { return p.facts.shear_at_peak; });
    add("largest_shear", [](Pier p) { return p.facts.most_shear; });
    add("drift", [](Pier p) { return p.drift; });
    add("slenderness", [](Pier p) { return p.facts.slenderness; });
    py::list modes;
    for (Pier p : piers) modes.append(std::string(app::mode_text(p)));
    columns["mode"] = modes;
    return columns;
}

py::dict spandrels_of_wall(const WallOfStudy& w)
{
    using Spandrel = const app::SpandrelReading&;
    const std::vector<app::SpandrelReading>& spandrels = w.wall.spandrels;
    py::dict columns;
    add_place(columns, spandrels, [](Spandrel s) { return s.spandrel.at; });
    const auto add = [&](const char* name, auto read) {
        add_column(columns, name, spandrels, read);
    };
    add("normal_at_peak", [](Spandrel s) { return s.facts.normal_at_peak; });
    add("shear_at_peak", [](Spandrel s) { return s.facts.shear_at_peak; });
    add("largest_shear", [](Spandrel s) { return s.facts.most_shear; });
    add("drift", [](Spandrel s) { return s.drift; });
    return columns;
}

void StoredPiers::add(const app::PierRow& row)
{
    const std::size_t n = piers_->places.size();
    for (std::size_t k = 0; k < facts_.size(); ++k)
        facts_[k].insert(facts_[k].end(),
                         row.facts.begin() + static_cast<std::ptrdiff_t>(k * n),
                         row.facts.begin() + static_cast<std::ptrdiff_t>((k + 1) * n));
}

py::dict StoredPiers::taken()
{
    using Place = const app::StorePier&;
    const std::size_t n = piers_->places.size();
    py::dict columns;
    if (n == 0) return columns;
    const auto add = [&](const char* name, auto read) {
        add_column(columns, name, piers_->places, read);
    };
    add("from", [](Place p) { return p.from; });
    add("to", [](Place p) { return p.to; });
    add("bottom", [](Place p) { return p.bottom; });
    add("top", [](Place p) { return p.top; });
    add("storey", [](Place p) { return p.storey; });
    for (std::size_t k = 0; k < facts_.size(); ++k) {
        const std::size_t walls = facts_[k].size() / n;
        columns[py::str(piers_->facts[k].name)] = array_of(std::move(facts_[k]), walls, n);
    }
    return columns;
}

} // namespace bindings
