#include "app/store/wall_datasets.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace app {

namespace {

using hdf5::Dataset;

/// Calls `visit(name, field)` for every dataset of one number per wall; field(row) is that
/// number.
template <class Visit> void each_number(const StoreHead& head, const Visit& visit)
{
    visit(
        "/walls/level", [](auto& row) -> auto& { return row.key.level; });
    visit(
        "/walls/sample", [](auto& row) -> auto& { return row.key.sample; });
    visit(
        "/walls/status", [](auto& row) -> auto& { return row.status; });
    for (std::size_t k = 0; k < head.responses.size(); ++k)
        visit(
            "/responses/" + head.responses[k].name, [k](auto& row) -> auto& {
                return row.responses[k];
            });
    for (std::size_t k = 0; k < head.counts.size(); ++k)
        visit(
            "/counts/" + head.counts[k].name, [k](auto& row) -> auto& {
                return row.counts[k];
            });
    for (std::size_t k = 0; k < head.cost.size(); ++k)
        visit(
            "/cost/" + head.cost[k].name, [k](auto& row) -> auto& { return row.cost[k]; });
}

template <class Field> using NumberOf = std::decay_t<std::invoke_result_t<Field, WallRow&>>;

std::vector<Dataset> make_numbers(const hdf5::File& file, const StoreHead& head,
                                  std::uint64_t walls)
{
    std::vector<Dataset> made;
    each_number(head, [&](const std::string& name, const auto& field) {
        using T = NumberOf<decltype(field)>;
        made.emplace_back(file, name, hdf5::type_of<T>(), std::vector<hsize_t>{walls});
    });
    return made;
}

std::vector<Dataset> open_numbers(const hdf5::File& file, const StoreHead& head)
{
    std::vector<Dataset> opened;
    each_number(head,
                [&](const std::string& name, const auto&) { opened.emplace_back(file, name); });
    return opened;
}

/// At most kMaxReason bytes, cut between two characters of UTF-8; padded to that length.
std::string padded(std::string reason)
{
    std::size_t n = std::min(reason.size(), kMaxReason);
    const auto inside = [&] {
        return (static_cast<unsigned char>(reason[n]) & 0xC0u) == 0x80u;
    };
    while (n > 0 && n < reason.size() && inside()) --n;
    reason.resize(n);
    reason.resize(kMaxReason, '\0');
    return reason;
}

} // namespace

WallDatasets::WallDatasets(const hdf5::File& file, const StoreHead& head, std::uint64_t walls,
                           std::uint64_t points)
    : file_(&file), head_(&head), numbers_(make_numbers(file, head, walls)),
      reason_(file, "/walls/reason", hdf5::text_type(file, kMaxReason).get(), {walls}),
      inputs_(file, "/walls/inputs", H5T_IEEE_F64LE, {walls, head.inputs.size()}),
      offset_(file, "/curves/offset", H5T_STD_U64LE, {walls + 1}),
      displacement_(file, "/curves/displacement",
                    head.single_precision_curves ? H5T_IEEE_F32LE : H5T_IEEE_F64LE, {points}),
      force_(file, "/curves/force",
             head.single_precision_curves ? H5T_IEEE_F32LE : H5T_IEEE_F64LE, {points})
{
    for (const PartGroup& parts : part_groups())
        if (!(head.*parts.stored).places.empty())
            parts_.emplace_back(file, head, parts, walls, points);
    const std::uint64_t begin = 0;
    offset_.write(0, std::span(&begin, 1));
}

WallDatasets::WallDatasets(const hdf5::File& file, const StoreHead& head)
    : file_(&file), head_(&head), numbers_(open_numbers(file, head)),
      reason_(file, "/walls/reason"), inputs_(file, "/walls/inputs", 2),
      offset_(file, "/curves/offset"), displacement_(file, "/curves/displacement"),
      force_(file, "/curves/force")
{
    const std::uint64_t n = reason_.rows();
    for (const Dataset& one : numbers_) one.require_rows(n);
    inputs_.require_rows(n);
    offset_.require_rows(n + 1);
    force_.require_rows(displacement_.rows());
    if (inputs_.width() != head.inputs.size())
        damaged(file.path, "there is not a name for each input");
    for (const PartGroup& parts : part_groups())
        if (!(head.*parts.stored).places.empty()) {
            parts_.emplace_back(file, head, parts);
            parts_.back().require(n, force_.rows());
        }
}

std::vector<StoredWall> WallDatasets::index() const
{
    const std::uint64_t n = reason_.rows();
    if (n > walls_wanted(*head_)) damaged(file_->path, "it has more walls than the study");
    const auto level = numbers_[0].read<std::uint32_t>(0, n);
    const auto sample = numbers_[1].read<std::uint32_t>(0, n);
    const auto status = numbers_[2].read<std::int32_t>(0, n);
    const auto offset = offset_.read<std::uint64_t>(0, n + 1);
    if (offset.front() != 0 || offset.back() != force_.rows() ||
        !std::ranges::is_sorted(offset))
        damaged(file_->path, "curves overlap");
    std::vector<StoredWall> walls;
    walls.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        const WallKey key{level[i], sample[i]};
        if (i > 0 && walls.back().key >= key) damaged(file_->path, "walls are out of order");
        if (key.level >= head_->levels.size() || key.sample >= head_->levels[key.level].samples)
            damaged(file_->path, wall_name(key) + " is outside the study");
        walls.push_back({key, status[i], offset[i + 1] - offset[i]});
        if (walls.back().points > kMostPoints)
            damaged(file_->path, wall_name(key) + ": the curve has more than " +
                                     std::to_string(kMostPoints) + " points");
    }
    return walls;
}

std::uint64_t WallDatasets::write(std::uint64_t first, std::uint64_t point,
                                  std::span<const WallRow> rows)
{
    auto next = numbers_.begin();
    each_number(*head_, [&](const std::string&, const auto& field) {
        std::vector<NumberOf<decltype(field)>> values;
        for (const WallRow& row : rows) values.push_back(field(row));
        (next++)->write(first, std::span(std::as_const(values)));
    });
    std::string reasons;
    std::vector<std::uint64_t> ends;
    std::vector<double> inputs, displacements, forces;
    const auto join = [](std::vector<double>& all, const std::vector<double>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    for (const WallRow& row : rows) {
        reasons += padded(row.reason);
        join(inputs, row.inputs);
        join(displacements, row.curve.displacement);
        join(forces, row.curve.force);
        ends.push_back(point + displacements.size());
    }
    reason_.write(first, rows.size(), hdf5::text_type(*file_, kMaxReason).get(),
                  reasons.data());
    inputs_.write(first, rows.size(), H5T_NATIVE_DOUBLE, inputs.data());
    displacement_.write(point, std::span<const double>(displacements));
    force_.write(point, std::span<const double>(forces));
    offset_.write(first + 1, std::span<const std::uint64_t>(ends));
    for (PierDatasets& parts : parts_) parts.write(first, point, rows);
    return point + displacements.size();
}

void WallDatasets::require_sound(const WallRow& row) const
{
    try {
        check_row(*head_, row);
    } catch (const std::invalid_argument& error) {
        damaged(file_->path, error.what());
    }
}

std::vector<WallRow> WallDatasets::read(std::uint64_t first,
                                        std::span<const StoredWall> walls) const
{
    const WallRow empty{{},
                        kWallOk,
                        {},
                        {},
                        std::vector<double>(head_->responses.size()),
                        std::vector<std::int64_t>(head_->counts.size()),
                        std::vector<double>(head_->cost.size()),
                        {},
                        {},
                        {}};
    std::vector<WallRow> rows(walls.size(), empty);
    auto next = numbers_.begin();
    each_number(*head_, [&](const std::string&, const auto& field) {
        const auto values = (next++)->read<NumberOf<decltype(field)>>(first, rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) field(rows[i]) = values[i];
    });
    std::uint64_t points = 0;
    for (const StoredWall& wall : walls) points += wall.points;
    const std::uint64_t point = offset_.read<std::uint64_t>(first, 1)[0];
    const auto reasons = hdf5::read_texts(*file_, reason_, first, rows.size(), kMaxReason);
    const auto inputs = inputs_.read<double>(first, rows.size());
    const auto displacements = displacement_.read<double>(point, points);
    const auto forces = force_.read<double>(point, points);
    const double *input = inputs.data(), *u = displacements.data(), *f = forces.data();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].reason = reasons[i];
        rows[i].inputs.assign(input, input + inputs_.width());
        rows[i].curve.displacement.assign(u, u + walls[i].points);
        rows[i].curve.force.assign(f, f + walls[i].points);
        input += inputs_.width(), u += walls[i].points, f += walls[i].points;
    }
    for (const PierDatasets& parts : parts_) parts.read(first, point, rows);
    for (const WallRow& row : rows) require_sound(row);
    return rows;
}

} // namespace app
