#include "app/store/pier_datasets.hpp"

#include "app/store/store_error.hpp"

#include <array>
#include <sstream>
#include <string>
#include <utility>

namespace app {
namespace {

using hdf5::Dataset;
using hdf5::put_attribute;

constexpr const char *kGroup = "/piers", *kMovement = "/piers/movement",
                     *kShear = "/piers/shear", *kStorey = "/piers/storey";

/// Dataset and field of each number of a place.
constexpr std::array<std::pair<const char*, double StorePier::*>, 4> kPlace = {
    {{"/piers/from", &StorePier::from},
     {"/piers/to", &StorePier::to},
     {"/piers/bottom", &StorePier::bottom},
     {"/piers/top", &StorePier::top}}};

std::string name_of(const Column& fact) { return std::string(kGroup) + "/" + fact.name; }

std::vector<Dataset> made_facts(const hdf5::File& file, const StorePiers& piers,
                                std::uint64_t walls)
{
    std::vector<Dataset> made;
    for (const Column& c : piers.facts)
        made.emplace_back(file, name_of(c), H5T_IEEE_F64LE,
                          std::vector<hsize_t>{walls, piers.places.size()});
    return made;
}

std::vector<Dataset> opened_facts(const hdf5::File& file, const StorePiers& piers)
{
    std::vector<Dataset> opened;
    for (const Column& c : piers.facts) opened.emplace_back(file, name_of(c), 2);
    return opened;
}

} // namespace

PierDatasets::PierDatasets(const hdf5::File& file, const StoreHead& head, std::uint64_t walls,
                           std::uint64_t points)
    : file_(&file), piers_(head.piers.places.size()),
      facts_(made_facts(file, head.piers, walls)),
      movement_(file, kMovement, H5T_IEEE_F32LE, {points, piers_}),
      shear_(file, kShear, H5T_IEEE_F32LE, {points, piers_})
{
}

PierDatasets::PierDatasets(const hdf5::File& file, const StoreHead& head)
    : file_(&file), piers_(head.piers.places.size()), facts_(opened_facts(file, head.piers)),
      movement_(file, kMovement, 2), shear_(file, kShear, 2)
{
}

void PierDatasets::require(std::uint64_t walls, std::uint64_t points) const
{
    const auto check = [&](const Dataset& d, std::uint64_t rows) {
        d.require_rows(rows);
        if (d.width() != piers_)
            damaged(file_->path, d.name() + " has not one column per pier");
    };
    for (const Dataset& fact : facts_) check(fact, walls);
    check(movement_, points);
    check(shear_, points);
}

void PierDatasets::write(std::uint64_t first, std::uint64_t point,
                         std::span<const WallRow> rows)
{
    for (std::size_t k = 0; k < facts_.size(); ++k) {
        std::vector<double> values;
        for (const WallRow& row : rows)
            for (std::size_t p = 0; p < piers_; ++p)
                values.push_back(row.piers.facts[k * piers_ + p]);
        facts_[k].write(first, std::span<const double>(values));
    }
    std::vector<double> movement, shear;
    for (const WallRow& row : rows) {
        movement.insert(movement.end(), row.piers.movement.begin(), row.piers.movement.end());
        shear.insert(shear.end(), row.piers.shear.begin(), row.piers.shear.end());
    }
    movement_.write(point, std::span<const double>(movement));
    shear_.write(point, std::span<const double>(shear));
}

void PierDatasets::read(std::uint64_t first, std::uint64_t point, std::span<WallRow> rows) const
{
    for (const Dataset& fact : facts_) {
        const auto values = fact.read<double>(first, rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i].piers.facts.insert(rows[i].piers.facts.end(), &values[i * piers_],
                                       &values[i * piers_] + piers_);
    }
    std::size_t points = 0;
    for (const WallRow& row : rows) points += row.curve.force.size();
    const auto movement = movement_.read<double>(point, points),
               shear = shear_.read<double>(point, points);
    const double *m = movement.data(), *v = shear.data();
    for (WallRow& row : rows) {
        const std::size_t n = row.curve.force.size() * piers_;
        row.piers.movement.assign(m, m + n);
        row.piers.shear.assign(v, v + n);
        m += n, v += n;
    }
}

void put_piers(const hdf5::File& file, const StorePiers& piers)
{
    if (piers.places.empty()) return;
    const auto put = [&](const std::string& dataset, const char* unit, const char* meaning) {
        put_attribute(file, dataset, "unit", unit);
        put_attribute(file, dataset, "units", std::string(unit) == "-" ? "1" : unit);
        put_attribute(file, dataset, "meaning", meaning);
    };
    for (const auto& [name, field] : kPlace) {
        std::vector<double> values;
        for (const StorePier& p : piers.places) values.push_back(p.*field);
        Dataset(file, name, hdf5::type_of<double>(), {values.size()})
            .write(0, std::span<const double>(values));
        put(name, "m", "of the pier");
    }
    std::vector<std::uint32_t> storeys;
    for (const StorePier& p : piers.places) storeys.push_back(p.storey);
    Dataset(file, kStorey, hdf5::type_of<std::uint32_t>(), {storeys.size()})
        .write(0, std::span<const std::uint32_t>(storeys));
    put(kStorey, "-", "of the pier, from 1 at the bottom");
    std::string names;
    for (const Column& c : piers.facts) {
        names += (names.empty() ? "" : " ") + c.name;
        put(name_of(c), c.unit.c_str(), c.meaning.c_str());
    }
    put_attribute(file, kGroup, "columns", names);
    put(kMovement, "m",
        "of the upper end of the pier against its lower end, in the direction of the push");
    put(kShear, "N", "of the pier, in the direction of the push");
}

StorePiers stored_piers(const hdf5::File& file)
{
    StorePiers piers;
    if (file.checked(H5Lexists(file.id.get(), kGroup, H5P_DEFAULT), "find piers in") <= 0)
        return piers;
    for (const auto& [name, field] : kPlace) {
        const Dataset from(file, name);
        if (from.rows() == 0 || from.rows() > kMostPiers ||
            (!piers.places.empty() && from.rows() != piers.places.size()))
            damaged(file.path,
                    std::string(name) + " has " + std::to_string(from.rows()) + " piers");
        const auto values = from.read<double>(0, from.rows());
        piers.places.resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) piers.places[i].*field = values[i];
    }
    const Dataset storeys(file, kStorey);
    storeys.require_rows(piers.places.size());
    const auto storey = storeys.read<std::uint32_t>(0, storeys.rows());
    for (std::size_t i = 0; i < storey.size(); ++i) piers.places[i].storey = storey[i];
    std::istringstream names(hdf5::text_attribute(file, kGroup, "columns"));
    for (std::string name; names >> name;) {
        const std::string dataset = std::string(kGroup) + "/" + name;
        piers.facts.push_back({name, hdf5::text_attribute(file, dataset, "unit"),
                               hdf5::text_attribute(file, dataset, "meaning")});
    }
    return piers;
}

} // namespace app
