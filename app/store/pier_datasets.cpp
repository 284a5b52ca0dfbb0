#include "app/store/pier_datasets.hpp"

#include "app/store/hdf5/store_error.hpp"

#include <array>
#include <sstream>
#include <string>
#include <utility>

namespace app {
namespace {

using hdf5::Dataset;
using hdf5::put_attribute;

/// Name and field of each number of a place.
constexpr std::array<std::pair<const char*, double StorePier::*>, 4> kPlace = {
    {{"/from", &StorePier::from},
     {"/to", &StorePier::to},
     {"/bottom", &StorePier::bottom},
     {"/top", &StorePier::top}}};

/// A curve of each part, at the points of the curve of the wall.
struct CurveOfPart {
    const char* name;
    const char* unit;
    const char* meaning;
    std::vector<double> PierRow::*values;
};
constexpr std::array kCurves = {
    CurveOfPart{"/movement", "m",
                "of the upper end of the pier against its lower end, in the direction of the "
                "push",
                &PierRow::movement},
    CurveOfPart{"/shear", "N", "of the pier, in the direction of the push", &PierRow::shear}};

const StorePiers& stored_of(const StoreHead& head, const PartGroup& parts)
{
    return head.*parts.stored;
}

std::string name_of(const PartGroup& parts, const Column& fact)
{
    return parts.group + "/" + fact.name;
}

} // namespace

const std::vector<PartGroup>& part_groups()
{
    static const std::vector<PartGroup> all = {
        {"/piers", "pier", &StoreHead::piers, &WallRow::piers, true},
        {"/spandrels", "spandrel", &StoreHead::spandrels, &WallRow::spandrels, false}};
    return all;
}

PierDatasets::PierDatasets(const hdf5::File& file, const StoreHead& head,
                           const PartGroup& parts, std::uint64_t walls, std::uint64_t points)
    : file_(&file), parts_(&parts), piers_(stored_of(head, parts).places.size())
{
    for (const Column& c : stored_of(head, parts).facts)
        facts_.emplace_back(file, name_of(parts, c), H5T_IEEE_F64LE,
                            std::vector<hsize_t>{walls, piers_});
    if (!parts.curves) return;
    for (const CurveOfPart& c : kCurves)
        curves_.emplace_back(file, parts.group + c.name, H5T_IEEE_F32LE,
                             std::vector<hsize_t>{points, piers_});
}

PierDatasets::PierDatasets(const hdf5::File& file, const StoreHead& head,
                           const PartGroup& parts)
    : file_(&file), parts_(&parts), piers_(stored_of(head, parts).places.size())
{
    for (const Column& c : stored_of(head, parts).facts)
        facts_.emplace_back(file, name_of(parts, c), 2);
    if (!parts.curves) return;
    for (const CurveOfPart& c : kCurves) curves_.emplace_back(file, parts.group + c.name, 2);
}

void PierDatasets::require(std::uint64_t walls, std::uint64_t points) const
{
    const auto check = [&](const Dataset& d, std::uint64_t rows) {
        d.require_rows(rows);
        if (d.width() != piers_)
            damaged(file_->path, d.name() + " has not one column per " + parts_->noun);
    };
    for (const Dataset& fact : facts_) check(fact, walls);
    for (const Dataset& curve : curves_) check(curve, points);
}

void PierDatasets::write(std::uint64_t first, std::uint64_t point,
                         std::span<const WallRow> rows)
{
    for (std::size_t k = 0; k < facts_.size(); ++k) {
        std::vector<double> values;
        for (const WallRow& row : rows)
            for (std::size_t p = 0; p < piers_; ++p)
                values.push_back((row.*parts_->row).facts[k * piers_ + p]);
        facts_[k].write(first, std::span<const double>(values));
    }
    for (std::size_t k = 0; k < curves_.size(); ++k) {
        std::vector<double> all;
        for (const WallRow& row : rows) {
            const std::vector<double>& values = (row.*parts_->row).*kCurves[k].values;
            all.insert(all.end(), values.begin(), values.end());
        }
        curves_[k].write(point, std::span<const double>(all));
    }
}

void PierDatasets::read(std::uint64_t first, std::uint64_t point, std::span<WallRow> rows) const
{
    for (const Dataset& fact : facts_) {
        const auto values = fact.read<double>(first, rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            std::vector<double>& all = (rows[i].*parts_->row).facts;
            all.insert(all.end(), &values[i * piers_], &values[i * piers_] + piers_);
        }
    }
    std::size_t points = 0;
    for (const WallRow& row : rows) points += row.curve.force.size();
    for (std::size_t k = 0; k < curves_.size(); ++k) {
        const auto values = curves_[k].read<double>(point, points);
        const double* next = values.data();
        for (WallRow& row : rows) {
            const std::size_t n = row.curve.force.size() * piers_;
            ((row.*parts_->row).*kCurves[k].values).assign(next, next + n);
            next += n;
        }
    }
}

namespace {

void put_group(const hdf5::File& file, const StorePiers& stored, const PartGroup& parts)
{
    const auto put = [&](const std::string& dataset, const std::string& unit,
                         const std::string& meaning) {
        put_attribute(file, dataset, "unit", unit);
        put_attribute(file, dataset, "units", unit == "-" ? "1" : unit);
        put_attribute(file, dataset, "meaning", meaning);
    };
    for (const auto& [name, field] : kPlace) {
        std::vector<double> values;
        for (const StorePier& p : stored.places) values.push_back(p.*field);
        Dataset(file, parts.group + name, hdf5::type_of<double>(), {values.size()})
            .write(0, std::span<const double>(values));
        put(parts.group + name, "m", "of the " + parts.noun);
    }
    if (parts.curves) {
        const std::string dataset = parts.group + "/storey";
        std::vector<std::uint32_t> storeys;
        for (const StorePier& p : stored.places) storeys.push_back(p.storey);
        Dataset(file, dataset, hdf5::type_of<std::uint32_t>(), {storeys.size()})
            .write(0, std::span<const std::uint32_t>(storeys));
        put(dataset, "-", "of the pier, from 1 at the bottom");
    }
    std::string names;
    for (const Column& c : stored.facts) {
        names += (names.empty() ? "" : " ") + c.name;
        put(name_of(parts, c), c.unit, c.meaning);
    }
    put_attribute(file, parts.group, "columns", names);
    if (parts.curves)
        for (const CurveOfPart& c : kCurves) put(parts.group + c.name, c.unit, c.meaning);
}

StorePiers stored_group(const hdf5::File& file, const PartGroup& parts)
{
    StorePiers stored;
    if (file.checked(H5Lexists(file.id.get(), parts.group.c_str(), H5P_DEFAULT),
                     "find piers in") <= 0)
        return stored;
    for (const auto& [name, field] : kPlace) {
        const Dataset from(file, parts.group + name);
        if (from.rows() == 0 || from.rows() > kMostPiers ||
            (!stored.places.empty() && from.rows() != stored.places.size()))
            damaged(file.path, parts.group + name + " has " + std::to_string(from.rows()) +
                                   " " + parts.noun + "s");
        const auto values = from.read<double>(0, from.rows());
        stored.places.resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) stored.places[i].*field = values[i];
    }
    if (parts.curves) {
        const Dataset storeys(file, parts.group + "/storey");
        storeys.require_rows(stored.places.size());
        const auto storey = storeys.read<std::uint32_t>(0, storeys.rows());
        for (std::size_t i = 0; i < storey.size(); ++i) stored.places[i].storey = storey[i];
    }
    std::istringstream names(hdf5::text_attribute(file, parts.group, "columns"));
    for (std::string name; names >> name;) {
        const std::string dataset = parts.group + "/" + name;
        stored.facts.push_back({name, hdf5::text_attribute(file, dataset, "unit"),
                                hdf5::text_attribute(file, dataset, "meaning")});
    }
    return stored;
}

} // namespace

void put_parts(const hdf5::File& file, const StoreHead& head)
{
    for (const PartGroup& parts : part_groups())
        if (const StorePiers& stored = stored_of(head, parts); !stored.places.empty())
            put_group(file, stored, parts);
}

void read_parts(const hdf5::File& file, StoreHead& head)
{
    for (const PartGroup& parts : part_groups()) head.*parts.stored = stored_group(file, parts);
}

} // namespace app
